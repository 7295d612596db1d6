# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Profiles of one-dimensional runs, from their VTU files."""

import os
import xml.etree.ElementTree as xml

import numpy as np

from plot.readers import vtk_file

QUANTITIES = ("density", "velocity", "pressure", "products")
MOST_TIMES = 6


class Profile:
    """Quantities at the points of a VTU file, in the order of x."""

    def __init__(self, path, time):
        piece = xml.parse(path).find("UnstructuredGrid/Piece")
        points = vtk_file.decode(piece.find("Points/DataArray"))
        self.is_line = not np.any(points[:, 1:])
        order = np.argsort(points[:, 0], kind="stable")
        self.time = time
        self.x = points[order, 0]
        self.values, self.units = {}, {}
        for array in piece.findall("PointData/DataArray"):
            name = array.get("Name")
            if name in QUANTITIES:
                self.values[name] = vtk_file.decode(array)[order, 0]
                self.units[name] = array.get("units", "-")


def open_profiles(folder):
    """Profiles of a one-dimensional run, evenly spread; else none."""
    collection = os.path.join(folder, "fields.pvd")
    if not os.path.exists(collection):
        return []
    entries = [(float(entry.get("timestep")), entry.get("file"))
               for entry in xml.parse(collection).iter("DataSet")
               if entry.get("file").endswith(".vtu")]
    if not entries:
        return []
    picks = np.unique(np.linspace(0, len(entries) - 1, MOST_TIMES).round())
    profiles = []
    for pick in picks.astype(int):
        time, file = entries[pick]
        profile = Profile(os.path.join(folder, file), time)
        if not profile.is_line:
            return []
        profiles.append(profile)
    return profiles
