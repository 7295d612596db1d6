# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Writes images of labels as NIfTI files."""

import struct


def write_labels(path, labels, width, first=0.):
    """An array [x, y, z] of small numbers, in cubic voxels of a width [mm]; the
    centre of the first is at this coordinate [mm] in each direction."""
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *labels.shape, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 2, 8)
    struct.pack_into("<8f", header, 76, 1, *3 * [width], 0, 0, 0, 0)
    struct.pack_into("<f", header, 108, len(header))
    header[123] = 2  # millimetres
    struct.pack_into("<2h", header, 252, 0, 1)
    for row in range(3):
        affine = [0., 0., 0., first]
        affine[row] = width
        struct.pack_into("<4f", header, 280 + 16 * row, *affine)
    header[344:348] = b"n+1\0"
    with open(path, "wb") as file:
        file.write(header + labels.astype("u1").tobytes(order="F"))
