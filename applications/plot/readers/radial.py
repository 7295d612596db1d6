# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Blasts that depend on the distance from the origin alone, whoever computed
them: one-dimensional runs of blast, cones and balls of head_impact, and tables
of radius, density, velocity and pressure."""

import os
import xml.etree.ElementTree as xml

import numpy as np

from plot.readers import profiles, tables, vtk_file
from plot.readers.files import BrokenInput, reading

FOOT, TOP = 0.1, 0.9  # of the shock's overpressure, between which is its width
# Fields between two of which the shock advances by more than this part of the
# radius cannot tell a peak there.
COARSEST = 0.02


class RadialProfile:
    """Radius [m], density [kg/m^3], velocity [m/s], pressure [Pa], outwards.
    Runs have as many samples as cells."""

    def __init__(self, radius, density, velocity, pressure):
        order = np.argsort(radius, kind="stable")
        self.radius, self.density, self.velocity, self.pressure = (
            values[order] for values in (radius, density, velocity, pressure))

    def shock(self):
        """Peak overpressure [Pa], its radius [m], and the width from 10 to 90 %
        of it in m and in samples; None where the outermost gas is disturbed."""
        over = self.pressure - self.pressure[-1]
        peak = int(np.argmax(over))
        places = []
        for level in (TOP * over[peak], FOOT * over[peak]):
            above = np.nonzero(over[peak:] > level)[0]
            if above.size == 0 or above[-1] + peak + 1 == over.size:
                return None
            inside = peak + above[-1]
            part = (over[inside] - level) / (over[inside] - over[inside + 1])
            places.append((self.radius[inside] + part * (
                self.radius[inside + 1] - self.radius[inside]), inside + part))
        (top, first), (foot, last) = places
        return over[peak], self.radius[peak], foot - top, last - first


def _in_cells(x, fields):
    """Values in the middle of as many cells of each leaf as its samples, from
    one end of it to the other, are; leaves meet in two samples of one place."""
    ends = np.nonzero(np.diff(x) <= 1e-9 * np.max(np.abs(x)))[0] + 1
    found = []
    for leaf in np.split(np.arange(x.size), ends):
        first, last = x[leaf[0]], x[leaf[-1]]
        middle = first + (np.arange(leaf.size) + 0.5) / leaf.size * (
            last - first)
        found.append([middle, *(np.interp(middle, x[leaf], field[leaf])
                                for field in fields)])
    return RadialProfile(*np.concatenate(found, axis=1))


def _read(path):
    """The profile of a VTU file of a one-dimensional run, or of hexahedra, of
    which it takes the centres."""
    try:
        line = profiles.Profile(path, 0.)
        if line.is_line:
            return _in_cells(line.x, [line.values[name] for name in (
                "density", "velocity", "pressure")])
        cells = vtk_file.read_cells(path)
        corners, velocity = cells["points"], cells["velocity"]
        distance = np.linalg.norm(corners, axis=2)
        away = np.sum(velocity * corners, axis=2) / np.maximum(distance, 1e-300)
        return RadialProfile(distance.mean(axis=1), cells["density"][:, 0, 0],
                             away.mean(axis=1), cells["pressure"][:, 0, 0])
    except (ValueError, KeyError, AttributeError, IndexError,
            xml.ParseError) as problem:
        raise BrokenInput(f"{path}: no fields of a one-dimensional run, or of "
                          "hexahedra, or cut off") from problem


def _read_table(path):
    """That of position, density, velocity and pressure."""
    with reading(path), open(path, encoding="utf-8") as file:
        names, *lines = [line for line in file if not line.startswith("#")]
        names = [name.strip() for name in names.split(",")]
        values = dict(zip(names, np.loadtxt(lines, delimiter=",", ndmin=2).T))
        columns = ("position", "density", "velocity", "pressure")
        if not values.keys() >= set(columns):
            raise BrokenInput(f"{path}: no table of position, density, "
                              "velocity and pressure")
        return RadialProfile(*(values[name] for name in columns))


class RadialRun:
    """A folder of results, or a table, which has one time and no history."""

    def __init__(self, label, path):
        self.label, self.path = label, path
        self.history, self.entries = None, []
        if os.path.isdir(path):
            self.history = tables.open_table(path, "history.csv")
            collection = os.path.join(path, "fields.pvd")
            if self.history is None or not os.path.exists(collection):
                raise BrokenInput(f"{path} has no history.csv or no fields.pvd")
            self.entries = [
                (float(entry.get("timestep")),
                 os.path.join(path, entry.get("file")))
                for entry in xml.parse(collection).iter("DataSet")
                if not entry.get("file").endswith((".vti", ".vtp"))]
            if len(self.entries) < 2:
                raise BrokenInput(f"{path}: no fields but those at the start")
            self.last = _read(self.entries[-1][1])
        else:
            self.last = _read_table(path)

    def energy(self):
        """Internal and kinetic, less the work that was done on it [J]."""
        table = self.history
        return table["energy"] if "energy" in table else (
            table["internal_energy"] + table["kinetic_energy"]
            - table["external_work"])

    def at(self, radius):
        """Peak overpressure [Pa] and its impulse [Pa s] there until the end,
        from the fields over time; None where these are too few."""
        if len(self.entries) < 1. / COARSEST:
            return None
        over = []
        for _, file in self.entries:
            now = _read(file)
            over.append(np.interp(radius, now.radius, now.pressure)
                        - now.pressure[-1])
        over = np.maximum(over, 0.)
        return np.max(over), np.trapz(over, [time for time, _ in self.entries])
