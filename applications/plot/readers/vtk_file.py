# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Reads the VTK XML files that solvers write."""

import base64
import re
import xml.etree.ElementTree as xml
import zlib

import numpy as np

_TYPES = {"Float64": np.float64, "Float32": np.float32, "UInt32": np.uint32,
          "Int64": np.int64, "UInt8": np.uint8}


def _decompress(content, begin):
    """The bytes of one array: header of block sizes, then blocks."""
    n_blocks = int(np.frombuffer(content, np.uint64, 1, begin)[0])
    sizes = np.frombuffer(content, np.uint64, n_blocks, begin + 24)
    place = begin + 24 + 8 * n_blocks
    parts = []
    for size in sizes:
        parts.append(zlib.decompress(content[place:place + int(size)]))
        place += int(size)
    return b"".join(parts)


def read(path):
    """All arrays by name; those with several components have a row for each
    tuple. A ValueError names a file that is no such one."""
    with open(path, "rb") as file:
        content = file.read()
    try:
        return _arrays(content)
    except (ValueError, IndexError, KeyError, zlib.error) as problem:
        raise ValueError(f"{path}: no VTK file of compressed arrays, or cut "
                         "off") from problem


def _arrays(content):
    mark = b'<AppendedData encoding="raw">\n_'
    end = content.index(mark)
    begin = end + len(mark)
    arrays = {}
    for match in re.finditer(
            r'<DataArray type="(\w+)" Name="([^"]*)" NumberOfComponents="(\d+)"'
            r' format="appended" offset="(\d+)"/>',
            content[:end].decode("ascii")):
        kind, name, components, offset = match.groups()
        values = np.frombuffer(_decompress(content, begin + int(offset)),
                               _TYPES[kind])
        if int(components) > 1:
            values = values.reshape(-1, int(components))
        arrays[name] = values
    return arrays


def decode(element):
    """The numbers of an array that deal.II wrote into its element: a header of
    four-byte counts (blocks, sizes), then the blocks, each half coded by
    itself."""
    text = element.text.strip()
    blocks = np.frombuffer(base64.b64decode(text[:8])[:4], np.uint32)[0]
    header = 4 * -(-4 * (3 + int(blocks)) // 3)
    sizes = np.frombuffer(base64.b64decode(text[:header]), np.uint32)
    data = base64.b64decode(text[header:])
    content, begin = b"", 0
    for size in sizes[3:3 + blocks]:
        content += zlib.decompress(data[begin:begin + size])
        begin += size
    numbers = np.frombuffer(content, _TYPES[element.get("type")])
    return numbers.reshape(-1, int(element.get("NumberOfComponents", 1)))


def _deal_arrays(path):
    """"points" and fields by name of a file by deal.II, a row for each
    point."""
    piece = xml.parse(path).find("UnstructuredGrid/Piece")
    found = {"points": decode(piece.find("Points/DataArray"))}
    for array in piece.findall("PointData/DataArray"):
        found[array.get("Name")] = decode(array)
    return found


# What broken files make of these.
_BROKEN = (ValueError, IndexError, KeyError, AttributeError, TypeError,
           xml.ParseError, zlib.error)


def read_points(path):
    """Of a file by deal.II: "points" and fields by name, as points x
    components. A ValueError names a file that is no such one."""
    try:
        return _deal_arrays(path)
    except _BROKEN as problem:
        raise ValueError(f"{path}: no file of points, or cut off") from problem


def read_cells(path):
    """Of a file by deal.II whose cells have eight points each, which follow
    each other: "points" and fields by name, as cells x 8 x components. A
    ValueError names a file that is no such one."""
    try:
        return {name: values.reshape(-1, 8, values.shape[1])
                for name, values in _deal_arrays(path).items()}
    except _BROKEN as problem:
        raise ValueError(f"{path}: no file of cells with eight points, or cut "
                         "off") from problem
