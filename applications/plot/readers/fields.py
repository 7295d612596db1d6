# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Fields of biomechanics over time, and what planes cut of their elements."""

import os
import re

import numpy as np

from plot.readers import vtk_file

# Corners at the beginning and the end of the four edges along each axis.
EDGES = [((0, 3, 7, 4), (1, 2, 6, 5)), ((0, 1, 5, 4), (3, 2, 6, 7)),
         ((0, 1, 2, 3), (4, 5, 6, 7))]


def list_fields(folder):
    """Times and the files of each output, without planes and skin of a
    blast."""
    with open(os.path.join(folder, "fields.pvd"), encoding="utf-8") as file:
        found = re.findall(r'timestep="([^"]*)"[^>]*file="([^"]*)"',
                           file.read())
    result = []
    for time, name in found:
        if name.endswith((".vti", ".vtp")):
            continue
        path = os.path.join(folder, name)
        pieces = [path]
        if path.endswith(".pvtu"):
            with open(path, encoding="utf-8") as file:
                pieces = [os.path.join(os.path.dirname(path), piece)
                          for piece in re.findall(r'Source="([^"]*)"',
                                                  file.read())]
        result.append((float(time), pieces))
    return result


def cut(mesh, place):
    """Polygons (x, z) of the cells that y = place cuts, and their numbers."""
    connectivity = mesh["connectivity"].reshape(-1, 8)
    ends = mesh["points"][:, 1][connectivity]
    found = np.flatnonzero((ends.min(axis=1) <= place)
                           & (ends.max(axis=1) > place))
    corners = mesh["points"][connectivity[found]]
    begin, _ = (corners[:, list(side)] for side in EDGES[1])
    return begin[:, :, [0, 2]], found


def cut_fields(fields, place):
    """Of each output the time, and of the cells that y = place cuts polygons
    and pressures, averaged ones if there are."""
    panels = []
    for time, pieces in fields:
        polygons, values = [], []
        for piece in pieces:
            mesh = vtk_file.read(piece)
            shape, found = cut(mesh, place)
            polygons.append(shape)
            # Averages know nothing of what alternates from element to element.
            name = "averaged_pressure" if "averaged_pressure" in mesh \
                else "pressure"
            values.append(mesh[name][found])
        panels.append((time, np.concatenate(polygons), np.concatenate(values)))
    return panels


def cut_values(pieces, place, name):
    """Of one output polygons and a quantity of the cells that y = place cuts;
    None for a quantity that it does not have."""
    polygons, values = [], []
    for piece in pieces:
        mesh = vtk_file.read(piece)
        if name not in mesh:
            return None
        shape, found = cut(mesh, place)
        polygons.append(shape)
        values.append(mesh[name][found])
    return np.concatenate(polygons), np.concatenate(values)
