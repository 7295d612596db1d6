# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Profiles of one-dimensional runs, from their VTU files."""

import os

import numpy as np

from plot.readers import fields, vtk_file

QUANTITIES = ("density", "velocity", "pressure", "products")
MOST_TIMES = 6


class Profile:
    """Quantities at the points of a VTU file, in the order of x."""

    def __init__(self, path, time):
        found = vtk_file.units_and_points(path)
        _, points = found["points"]
        self.is_line = not np.any(points[:, 1:])
        order = np.argsort(points[:, 0], kind="stable")
        self.time = time
        self.x = points[order, 0]
        self.values = {name: found[name][1][order, 0] for name in QUANTITIES
                       if name in found}
        self.units = {name: found[name][0] for name in self.values}


def open_profiles(folder):
    """Profiles of a one-dimensional run, evenly spread; else none."""
    if not os.path.exists(os.path.join(folder, "fields.pvd")):
        return []
    entries = [(time, pieces[0]) for time, pieces in fields.list_fields(folder)
               if len(pieces) == 1]
    picks = np.unique(np.linspace(0, len(entries) - 1, MOST_TIMES).round())
    profiles = []
    for pick in picks.astype(int) if entries else ():
        profiles.append(Profile(entries[pick][1], entries[pick][0]))
        if not profiles[-1].is_line:
            return []
    return profiles
