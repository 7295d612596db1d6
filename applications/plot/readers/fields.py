# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Fields of biomechanics over time, and what planes cut of their elements."""

import os
import re

import numpy as np

from plot.readers import cuts, vtk_file

# Corners at the beginning and the end of the four edges along each axis.
EDGES = [((0, 3, 7, 4), (1, 2, 6, 5)), ((0, 1, 5, 4), (3, 2, 6, 7)),
         ((0, 1, 2, 3), (4, 5, 6, 7))]
PARALLEL = 1e-3  # by which such edges may be aside, over their length
# The corners numbered as binary digits of z, y, x.
BY_DIGITS = [0, 1, 3, 2, 4, 5, 7, 6]


def list_fields(folder):
    """Times and the files of each output, without planes and skin of a
    blast."""
    result = []
    for time, name in _found_in(os.path.join(folder, "fields.pvd"),
                                r'timestep="([^"]*)"[^>]*file="([^"]*)"'):
        if name.endswith((".vti", ".vtp")):
            continue
        path = os.path.join(folder, name)
        result.append((float(time), [path] if not path.endswith(".pvtu") else [
            os.path.join(os.path.dirname(path), piece)
            for piece in _found_in(path, r'Source="([^"]*)"')]))
    return result


def _found_in(path, pattern):
    with open(path, encoding="utf-8") as file:
        return re.findall(pattern, file.read())


def cut(mesh, place, normal=1):
    """Polygons, of the other two axes, in which the plane at a place normal to an
    axis cuts cells, and the numbers of these. Cells whose edges are along that
    axis have one each, others several."""
    connectivity = mesh["connectivity"].reshape(-1, 8)
    ends = mesh["points"][:, normal][connectivity]
    found = np.flatnonzero((ends.min(axis=1) <= place)
                           & (ends.max(axis=1) > place))
    others = [axis for axis in range(3) if axis != normal]
    corners = mesh["points"][connectivity[found]]
    begin, end = (corners[:, list(side)] for side in EDGES[normal])
    size = np.ptp(ends[found], axis=1)
    aside = np.abs(end - begin)[:, :, others].max(axis=(1, 2))
    is_tilted = (aside > PARALLEL * size) | (
        np.ptp(begin[:, :, normal], axis=1) > PARALLEL * size)
    shape, owners = cuts.cut_hexahedra(corners[is_tilted][:, BY_DIGITS],
                                       normal, place, others)
    return (np.concatenate([begin[~is_tilted][:, :, others], shape]),
            np.concatenate([found[~is_tilted], found[is_tilted][owners]]))


def cut_fields(fields, place, axes=np.eye(3)):
    """Time of each output, and, of the cells that the plane at a place along
    the second axis cuts, polygons, of the two others, and pressures, averaged
    ones if there are."""
    panels = []
    for time, pieces in fields:
        # Averages know nothing of what alternates from element to element.
        found = cut_values(pieces, place, "averaged_pressure", axes) \
            or cut_values(pieces, place, "pressure", axes)
        if found is None:
            raise KeyError("pressure")
        panels.append((time, *found))
    return panels


def cut_values(pieces, place, name, axes=np.eye(3)):
    """Polygons and a quantity of the cells of one output that this plane cuts;
    None for a quantity that it does not have."""
    polygons, values = [], []
    for piece in pieces:
        mesh = vtk_file.read(piece)
        if name not in mesh:
            return None
        if not np.array_equal(axes, np.eye(3)):
            mesh["points"] = mesh["points"] @ np.transpose(axes)
        shape, found = cut(mesh, place)
        polygons.append(shape)
        values.append(mesh[name][found])
    return np.concatenate(polygons), np.concatenate(values)
