# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Plane cuts through fields, NAME.vti."""

import glob
import os
import re

import numpy as np

from plot.readers import vtk_file


class Plane:
    """One quantity on a regular grid: values[second axis, first axis]."""

    def __init__(self, image, quantity):
        self.quantity = quantity
        self.values, self.unit = image.fields[quantity]
        self.time, self.place = image.time, image.place
        self.axes, self.lower, self.upper = image.axes, image.lower, image.upper
        self.copies = 1  # with the mirror images at planes of symmetry
        self.mirrored = set()  # sides at these: axis, 0 lower or 1 upper
        if self.values.dtype.kind != "f":
            raise ValueError("no grid of numbers")
        if np.isinf(self.values).any():
            raise ValueError(f"{quantity} is infinite")

    def extent(self):
        """Left, right, bottom, top for imshow, whose pixels are centred on
        the points of the grid."""
        extent = []
        for low, high, points in zip(self.lower, self.upper,
                                     self.values.shape[::-1]):
            half = 0.5 * (high - low) / max(points - 1, 1)
            extent += [low - half, high + half]
        return extent

    def mirror(self, symmetry_planes):
        """Counts the mirror images of a plane that ends at planes of symmetry,
        axis and place of each."""
        for axis, place in symmetry_planes:
            if "xyz"[axis] in self.axes:
                own = self.axes.index("xyz"[axis])
                near = 1e-6 * (self.upper[own] - self.lower[own])
                for side, end in enumerate((self.lower[own], self.upper[own])):
                    if abs(end - place) < near:
                        self.copies *= 2
                        self.mirrored.add((own, side))

    def positions(self, axis=0):
        """Coordinates along the first or the second axis [m]."""
        return np.linspace(self.lower[axis], self.upper[axis],
                           self.values.shape[1 - axis])


def open_planes(folder):
    """All planes of a run, by the names of their files and quantities, such as
    "plane_y_0_pressure", without the number of the output, each list by time.
    Planes without a number, which sum up a whole run, stand alone; those of
    which no value is known are left out."""
    found = {}
    for path in glob.glob(os.path.join(folder, "**", "*plane_*.vti"),
                          recursive=True):
        stem = re.sub(r"_(\d{4,}|maps)$", "", os.path.basename(path)[:-4])
        image = vtk_file.Image(path)
        try:
            for quantity in image.fields:
                plane = Plane(image, quantity)
                if np.isfinite(plane.values).any():
                    found.setdefault(f"{stem}_{quantity}", []).append(plane)
        except ValueError as problem:
            raise ValueError(f"{path}: {problem}") from problem
    for planes in found.values():
        planes.sort(key=lambda plane: plane.time)
    return found
