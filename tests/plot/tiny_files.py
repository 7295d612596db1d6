# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""VTK files like those of the applications."""

import base64
import os
import zlib

import numpy as np

KINDS = {"float64": "Float64", "float32": "Float32", "uint32": "UInt32",
         "uint8": "UInt8"}


def elements(arrays):
    """Text of (name, values, components, unit)."""
    text = ""
    for name, values, components, unit in arrays:
        block = zlib.compress(values.tobytes())
        header = np.array([1, values.nbytes, 0, len(block)], np.uint64)
        coded = "".join(base64.b64encode(part).decode()
                        for part in (header.tobytes(), block))
        key = ('<InformationKey name="UNITS_LABEL" location="vtkDataArray">'
               f"{unit}</InformationKey>" if unit else "")
        text += (f'<DataArray type="{KINDS[str(values.dtype)]}" Name="{name}"'
                 f' NumberOfComponents="{components}" format="binary">'
                 f"{coded}{key}</DataArray>\n")
    return text


def write(path, text, kind="UnstructuredGrid"):
    """A file of the text of a grid."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<VTKFile type="{kind}" version="1.0" '
                   'byte_order="LittleEndian" header_type="UInt64" '
                   'compressor="vtkZLibDataCompressor">\n'
                   f"{text}</VTKFile>\n")


def write_plane(path, fields, lower, upper, time=0., axes="xz", place=0.):
    """Fields {name: (values, unit)} with values [second axis, first axis]
    between two corners, at a place along the third axis [m]."""
    counts = next(iter(fields.values()))[0].shape[::-1]
    extent, origin, spacing = [], [], []
    for axis in "xyz":
        if axis in axes:
            at = axes.index(axis)
            extent += [0, counts[at] - 1]
            origin.append(lower[at])
            spacing.append((upper[at] - lower[at]) / (counts[at] - 1))
        else:
            extent += [0, 0]
            origin.append(place)
            spacing.append(1.)
    arrays = elements(
        (name, np.ascontiguousarray(values, float), 1, unit)
        for name, (values, unit) in fields.items())
    words = [" ".join(map(repr, map(float, numbers)))
             for numbers in (origin, spacing)]
    whole = " ".join(map(str, extent))
    write(path, f'<ImageData WholeExtent="{whole}" '
          f'Origin="{words[0]}" Spacing="{words[1]}">\n<FieldData>\n'
          '<DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" '
          f'format="ascii">{float(time)!r}</DataArray>\n</FieldData>\n'
          f'<Piece Extent="{whole}">\n<PointData>\n{arrays}</PointData>\n'
          "</Piece>\n</ImageData>\n", "ImageData")
