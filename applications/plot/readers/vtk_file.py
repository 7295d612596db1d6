# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Reads the VTK XML files that solvers write."""

import base64
import xml.etree.ElementTree as xml
import zlib

import numpy as np

_WORDS = {"UInt32": np.uint32, "UInt64": np.uint64}
# Exceptions raised for damaged files.
_BROKEN = (ValueError, IndexError, KeyError, AttributeError, TypeError,
           OverflowError, xml.ParseError, zlib.error)


def _inflate(content, word):
    """The bytes of an array: its header of counts (blocks, sizes), each a
    @p word, then its blocks."""
    n_blocks = int(np.frombuffer(content, word, 1)[0])
    header = np.frombuffer(content, word, 3 + n_blocks)
    ends = header.nbytes + np.cumsum(header[3:], dtype=int)
    return b"".join(zlib.decompress(content[end - int(size):end])
                    for size, end in zip(header[3:], ends))


def _decode(text, word):
    """The bytes of header and blocks, which are coded each by itself."""
    size = np.dtype(word).itemsize
    n_blocks = int(np.frombuffer(base64.b64decode(text[:12]), word, 1)[0])
    length = 4 * -(-size * (3 + n_blocks) // 3)
    return base64.b64decode(text[:length]) + base64.b64decode(text[length:])


def _numbers_of(element, content, word):
    """The numbers of an array, with a row for each tuple."""
    return np.frombuffer(
        _inflate(content, word), element.get("type").lower()).reshape(
            -1, int(element.get("NumberOfComponents", 1)))


def read(path):
    """All compressed arrays by name, "points" without one; those with several
    components have a row for each tuple. A ValueError names a file that is no
    such one."""
    return {name: values for name, (values, _) in _open(path)[1].items()}


class Image:
    """Fields on a regular grid of points in a plane: time [s]; its place along
    the third axis [m]; of both axes their names, first and last points [m] and
    numbers of points; and by name values [second axis, first axis] with units.
    A ValueError names a file that is no such one."""

    def __init__(self, path):
        root, arrays = _open(path)
        try:
            grid = root.find("ImageData")
            extent, origin, spacing = (_numbers(grid.get(name)) for name in (
                "WholeExtent", "Origin", "Spacing"))
            self.time = _numbers(
                root.find(".//DataArray[@Name='TimeValue']").text)[0]
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
        except _BROKEN as problem:
            raise ValueError(f"{path}: no picture in a plane") from problem


def _numbers(text):
    """Numbers of an attribute or element; a ValueError if not finite."""
    values = [float(word) for word in text.split()]
    if not np.isfinite(values).all():
        raise ValueError(f"{text} is not finite")
    return values


def _open(path):
    """The root of the file, and the arrays by name with their units."""
    with open(path, "rb") as file:
        content = file.read()
    try:
        return _arrays(content)
    except _BROKEN as problem:
        raise ValueError(f"{path}: no VTK file of compressed arrays, or cut "
                         "off") from problem


def _arrays(content):
    # Bytes may also be appended as they are, which is no XML.
    head, mark, data = content.partition(b'<AppendedData encoding="raw">\n_')
    root = xml.fromstring(head + b"</VTKFile>" if mark else content)
    word = _WORDS[root.get("header_type", "UInt32")]
    arrays = {}
    for element in root.iter("DataArray"):
        if element.get("format") == "ascii":
            continue
        packed = memoryview(data)[int(element.get("offset")):] if mark \
            else _decode(element.text.strip(), word)
        values = _numbers_of(element, packed, word)
        arrays[element.get("Name", "points")] = (
            values if values.shape[1] > 1 else values[:, 0],
            element.findtext("InformationKey", ""))
    return root, arrays


def units_and_points(path):
    """Arrays of a file by deal.II: "points" and fields by name, as points x
    components, behind their units. A ValueError names a file that is no such
    one."""
    try:
        piece = xml.parse(path).find("UnstructuredGrid/Piece")
        arrays = {"points": piece.find("Points/DataArray")} | {
            array.get("Name"): array
            for array in piece.findall("PointData/DataArray")}
        return {name: (array.get("units", "-"), _numbers_of(
            array, _decode(array.text.strip(), np.uint32), np.uint32))
                for name, array in arrays.items()}
    except _BROKEN as problem:
        raise ValueError(f"{path}: no file of points, or cut off") from problem


def read_points(path):
    """The same without units."""
    return {name: values for name, (_, values) in units_and_points(path).items()}


def read_cells(path):
    """Arrays of a file by deal.II whose cells have eight points each, which
    follow each other: "points" and fields by name, as cells x 8 x components.
    A ValueError names a file that is no such one."""
    try:
        return {name: values.reshape(-1, 8, values.shape[1])
                for name, values in read_points(path).items()}
    except ValueError as problem:
        raise ValueError(f"{path}: no file of cells with eight points, or cut "
                         "off") from problem
