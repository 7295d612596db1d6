# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Plane cuts through fields, NAME.npy with NAME.json."""

import glob
import os
import re

import numpy as np

from plot.readers import json_shape


class Plane:
    """One quantity on a regular grid: values[second axis, first axis]."""

    def __init__(self, description, path):
        json_shape.check(description, json_shape.PLANE)
        for name in json_shape.PLANE:
            if description.get(name) is None:
                raise ValueError(f'"{name}" is missing')
        self.quantity = description["quantity"]
        self.unit = description["unit"]
        self.time = description["time"]
        self.axes = description["axes"]
        self.lower = description["lower"]
        self.upper = description["upper"]
        self.values = np.load(path)
        if self.values.ndim != 2 or self.values.dtype.kind != "f" \
                or not np.isfinite(self.values).any():
            raise ValueError("no grid of numbers")

    def extent(self):
        """Left, right, bottom, top for imshow, whose pixels are centred on
        the points of the grid."""
        extent = []
        for axis in range(2):
            points = self.values.shape[1 - axis]
            half = 0.5 * (self.upper[axis] - self.lower[axis]) / max(
                points - 1, 1)
            extent += [self.lower[axis] - half, self.upper[axis] + half]
        return extent

    def positions(self):
        """Coordinates along the first axis [m]."""
        return np.linspace(self.lower[0], self.upper[0],
                           self.values.shape[1])


def open_planes(folder):
    """All planes of a run, by the names of their files without the number
    of the output at the end, each list by time. Planes without a number,
    which sum up a whole run, stand alone."""
    found = {}
    for path in glob.glob(os.path.join(folder, "**", "*.json"),
                          recursive=True):
        array = path[:-len(".json")] + ".npy"
        if not os.path.exists(array):
            continue
        try:
            with open(path, encoding="utf-8") as file:
                plane = Plane(json_shape.parse(file.read()), array)
        except (ValueError, EOFError) as problem:
            raise ValueError(f"{array} with .json: {problem}") from problem
        stem = re.sub(r"_\d{4,}$", "", os.path.basename(array)[:-4])
        found.setdefault(stem, []).append(plane)
    for planes in found.values():
        planes.sort(key=lambda plane: plane.time)
    return found
