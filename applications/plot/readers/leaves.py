# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Leaves of blast in 2-D with the values of their subcells, from the fields."""

import numpy as np

from plot.readers import fields, files, vtk_file
from plot.readers.stage import Stage


def subcell_values(n):
    """Matrix from the values that fields have along an edge of a leaf, n at
    equal distances from end to end, to the means of its n subcells, between
    whose centres they are interpolated."""
    places = np.clip(np.linspace(0., n, n) - 0.5, 0., n - 1.)
    first = np.minimum(places.astype(int), n - 2)
    matrix = np.zeros((n, n))
    matrix[np.arange(n), first] = 1. - (places - first)
    matrix[np.arange(n), first + 1] = places - first
    return np.linalg.inv(matrix)


class Leaves:
    """The leaves of one output: lower corners and edge lengths [m], levels, and
    the means of subcells as arrays [leaf, y, x]: density [kg/m^3], momentum_x
    [kg/(m^2 s)], pressure [Pa], and the open fraction next to a body."""

    def __init__(self, time, path, n, gamma):
        self.time, self.n = time, n
        found = vtk_file.read_points(path)
        corners = found["points"][:, :2].reshape(-1, n * n, 2)
        self.corners = corners[:, 0].astype(float)
        self.edges = (corners[:, -1] - corners[:, 0]).astype(float)
        self.levels = found["level"].reshape(-1, n * n)[:, 0].astype(int)
        density = found["density"][:, 0]
        momentum = density[:, None] * found["velocity"][:, :2]
        energy = (found["pressure"][:, 0] / (gamma - 1.)
                  + 0.5 * (momentum**2).sum(axis=1) / density)
        inverse = subcell_values(n)

        def means(values):
            return np.einsum("ai,bj,lij->lab", inverse, inverse,
                             values.reshape(-1, n, n).astype(float))

        self.density = means(density)
        self.momentum_x, momentum_y = map(means, momentum.T)
        self.pressure = (gamma - 1.) * (means(energy) - 0.5 * (
            self.momentum_x**2 + momentum_y**2) / self.density)
        self.open = np.ones_like(self.density)
        if "open_fraction" in found:
            self.open = means(found["open_fraction"][:, 0])
            self.open[self.open < 1e-6] = 0.

    def centres(self):
        """Centres of subcells, as [leaf, y, x, direction] [m]."""
        place = (np.arange(self.n) + 0.5) / self.n
        x, y = np.meshgrid(place, place)
        return (self.corners[:, None, None]
                + self.edges[:, None, None] * np.stack([x, y], axis=-1))

    def keys(self):
        """Keys that tell leaves apart, in the order of leaves."""
        return [(int(level), *np.round(corner / edge).astype(int))
                for level, corner, edge in zip(self.levels, self.corners,
                                               self.edges)]


class LeafRun(Stage):
    """A run of finite volumes in a plane, with an ideal gas."""

    def __init__(self, folder):
        super().__init__(folder)
        if self.parameters.get("Domain/Dimension") != "2" \
                or self.parameters.get("Method/Scheme") != "finite volume":
            raise files.BrokenInput(f"{folder}: not the output folder of blast "
                                    "in 2-D with finite volumes")
        self.n = int(self.parameters["Method/Subcells"])
        self.gamma = float(self.parameters["Material/Gamma"])
        with files.reading(self.path("fields.pvd")):
            self.outputs = fields.list_fields(folder)

    def states(self):
        """Leaves of all outputs."""
        result = []
        for time, pieces in self.outputs:
            with files.reading(pieces[0]):
                result.append(Leaves(time, pieces[0], self.n, self.gamma))
        return result
