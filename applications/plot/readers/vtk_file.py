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
_ARRAY = re.compile(
    r'<DataArray type="(\w+)" Name="([^"]*)" NumberOfComponents="(\d+)"'
    r' format="appended" offset="(\d+)"'
    r'(?:/>|><InformationKey name="UNITS_LABEL" location="vtkDataArray">'
    r'([^<]*)<)')


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
    return {name: values for name, (values, _) in _open(path)[1].items()}


class Image:
    """Fields on a regular grid of points in a plane: time [s]; its place along
    the third axis [m]; of both axes their names, first and last points [m] and
    numbers of points; and by name values [second axis, first axis] with units.
    A ValueError names a file that is no such one."""

    def __init__(self, path):
        head, arrays = _open(path)
        try:
            extent = _numbers(head, r'WholeExtent="([^"]*)"')
            origin = _numbers(head, r'Origin="([^"]*)"')
            spacing = _numbers(head, r'Spacing="([^"]*)"')
            self.time = _numbers(head, r'Name="TimeValue"[^>]*>([^<]*)<')[0]
            axes = [axis for axis in range(3) if extent[2 * axis + 1] > 0]
            self.axes = ["xyz"[axis] for axis in axes]
            self.counts = [int(extent[2 * axis + 1]) + 1 for axis in axes]
            self.lower = [origin[axis] for axis in axes]
            self.upper = [origin[axis] + spacing[axis] * extent[2 * axis + 1]
                          for axis in axes]
            if len(axes) != 2:
                raise ValueError("not of two dimensions")
            self.place = origin[3 - sum(axes)]
            self.fields = {
                name: (values.reshape(self.counts[::-1]), unit)
                for name, (values, unit) in arrays.items()}
        except (ValueError, IndexError) as problem:
            raise ValueError(f"{path}: no picture in a plane") from problem


def _numbers(head, pattern):
    """Of an attribute or element; a ValueError if missing or not finite."""
    found = re.search(pattern, head)
    values = [float(word) for word in found[1].split()] if found else []
    if not values or not np.isfinite(values).all():
        raise ValueError(f"{pattern} is missing")
    return values


def _open(path):
    """What describes the arrays, and these by name with their units."""
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
    head = content[:end].decode("ascii")
    arrays = {}
    for match in _ARRAY.finditer(head):
        kind, name, components, offset, unit = match.groups()
        values = np.frombuffer(_decompress(content, begin + int(offset)),
                               _TYPES[kind])
        if int(components) > 1:
            values = values.reshape(-1, int(components))
        arrays[name] = values, unit or ""
    return head, arrays


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
