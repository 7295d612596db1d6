# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""VTK files like those of the applications."""

import os
import zlib

import numpy as np

KINDS = {"float64": "Float64", "float32": "Float32", "uint32": "UInt32",
         "uint8": "UInt8"}


def appended(arrays):
    """What describes (name, values, components, unit), and their bytes."""
    head, data = "", b""
    for name, values, components, unit in arrays:
        key = ('<InformationKey name="UNITS_LABEL" location="vtkDataArray">'
               f"{unit}</InformationKey></DataArray>\n")
        head += (f'<DataArray type="{KINDS[str(values.dtype)]}" Name="{name}"'
                 f' NumberOfComponents="{components}" format="appended" '
                 f'offset="{len(data)}"' + (f">{key}" if unit else "/>\n"))
        block = zlib.compress(values.tobytes())
        data += np.array([1, values.nbytes, 0, len(block)],
                         np.uint64).tobytes() + block
    return head, data


def write(path, head, data):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(head.encode() + b'<AppendedData encoding="raw">\n_' + data)


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
    head, data = appended(
        (name, np.ascontiguousarray(values, float), 1, unit)
        for name, (values, unit) in fields.items())
    words = [" ".join(map(repr, map(float, numbers)))
             for numbers in (origin, spacing)]
    whole = " ".join(map(str, extent))
    write(path, f'<VTKFile type="ImageData">\n<ImageData WholeExtent="{whole}" '
          f'Origin="{words[0]}" Spacing="{words[1]}">\n<FieldData>\n'
          '<DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" '
          f'format="ascii">{float(time)!r}</DataArray>\n</FieldData>\n'
          f'<Piece Extent="{whole}">\n<PointData>\n{head}</PointData>\n'
          "</Piece>\n</ImageData>\n", data)
