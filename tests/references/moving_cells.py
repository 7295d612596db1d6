#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Two one-dimensional problems, in cells that move with the gas.

    moving_cells.py woodward_colella|shu_osher CELLS [FILE.csv]

A reference for the tests of shocks and density waves that shares nothing with
the program but the Euler equations: van Leer's second-order sequel to Godunov's
method in Lagrangian coordinates (J. Comput. Phys. 32 (1979) 101-136), with his
limiter, a predictor of half a step and the exact Riemann problem (as two shocks)
at edges. No mass crosses an edge, so that contacts and waves of density stay as
sharp as they began.

Writes the densities, velocities and pressures of those cells from which straight
lines reproduce the others to 3e-5 of each quantity's range.
"""

import sys

import numpy as np

HEATS = 1.4
TITLE = """\
# The profile at t = {2}, by another method than the program's, in cells that move
# with the gas: tests/references/moving_cells.py {0} {1} FILE
"""
LAGGING = 0.45  # part of the longest stable step


def limited(values, walls):
    """Van Leer's limited differences across each cell."""
    first, last = (values[:1], values[-1:]) if walls else (
        2. * values[:1] - values[1:2], 2. * values[-1:] - values[-2:-1])
    steps = np.diff(np.concatenate([first, values, last]))
    low, high = steps[:-1], steps[1:]
    product = low * high
    return np.where(product > 0., 2. * product / np.where(
        product > 0., low + high, 1.), 0.)


def meeting(density, speed, pressure):
    """Speed and pressure where pairs of gases meet, by Newton's method for the
    curves of shocks (of rarefactions the curves agree to third order)."""
    (density_l, density_r), (speed_l, speed_r), (pressure_l, pressure_r) = (
        density, speed, pressure)
    wave_l = np.sqrt(HEATS * pressure_l * density_l)
    wave_r = np.sqrt(HEATS * pressure_r * density_r)
    found = np.maximum(
        (wave_r * pressure_l + wave_l * pressure_r + wave_l * wave_r
         * (speed_l - speed_r)) / (wave_l + wave_r), 1e-10)
    for _ in range(4):
        at_l, slope_l = behind(found, pressure_l, density_l)
        at_r, slope_r = behind(found, pressure_r, density_r)
        found = np.maximum(found - (at_l + at_r + speed_r - speed_l)
                           / (slope_l + slope_r), 1e-10)
    at_l, _ = behind(found, pressure_l, density_l)
    at_r, _ = behind(found, pressure_r, density_r)
    return 0.5 * (speed_l - at_l + speed_r + at_r), found


def behind(pressure, pressure_0, density_0):
    """Change of speed over a shock to this pressure, and its derivative."""
    mass = np.sqrt(0.5 * density_0 * ((HEATS + 1.) * pressure
                                      + (HEATS - 1.) * pressure_0))
    change = (pressure - pressure_0) / mass
    return change, 1. / mass - 0.25 * change * density_0 * (HEATS + 1.) / mass**2


class Gas:
    """Masses of the cells, their edges, velocities and total energies."""

    def __init__(self, edges, density, speed, pressure, walls):
        self.edges = edges
        self.mass = density * np.diff(edges)
        self.speed = speed
        self.energy = pressure / density / (HEATS - 1.) + 0.5 * speed**2
        self.walls = walls

    def fields(self):
        density = self.mass / np.diff(self.edges)
        return density, self.speed, (HEATS - 1.) * density * (
            self.energy - 0.5 * self.speed**2)

    def advance(self, longest):
        density, speed, pressure = self.fields()
        impedance = np.sqrt(HEATS * pressure * density)
        step = min(longest, LAGGING * np.min(self.mass / impedance))
        slope = [limited(field, self.walls)
                 for field in (1. / density, speed, pressure)]
        part = 0.5 * step / self.mass
        middle = (1. / density + part * slope[1], speed - part * slope[2],
                  pressure - part * impedance**2 * slope[1])
        left, right = ([field[1:] - 0.5 * rise[1:] if side else
                        field[:-1] + 0.5 * rise[:-1]
                        for field, rise in zip(middle, slope)]
                       for side in (0, 1))
        for states in (left, right):
            states[0] = 1. / states[0]
        at_edges, pressures = meeting(*zip(left, right))
        if self.walls:
            first, last = 0., 0.
            pressure_first = wall_pressure(middle, slope, 0)
            pressure_last = wall_pressure(middle, slope, -1)
        else:
            first, last = speed[0], speed[-1]
            pressure_first, pressure_last = pressure[0], pressure[-1]
        at_edges = np.concatenate([[first], at_edges, [last]])
        pressures = np.concatenate([[pressure_first], pressures,
                                    [pressure_last]])
        self.edges = self.edges + step * at_edges
        self.speed = self.speed - step / self.mass * np.diff(pressures)
        self.energy = self.energy - step / self.mass * np.diff(
            pressures * at_edges)
        return step


def wall_pressure(middle, slope, cell):
    """Pressure on a wall beside the first or the last cell."""
    sign = -0.5 if cell == 0 else 0.5
    volume, speed, pressure = (field[cell] + sign * rise[cell]
                               for field, rise in zip(middle, slope))
    density = 1. / volume
    towards = speed if cell else -speed
    if towards < 0.:
        return pressure * (1. + 0.5 * (HEATS - 1.) * towards / np.sqrt(
            HEATS * pressure / density))**(2. * HEATS / (HEATS - 1.))
    return pressure + 0.25 * (HEATS + 1.) * density * towards**2 + np.sqrt(
        HEATS * pressure * density * towards**2
        + (0.25 * (HEATS + 1.) * density * towards**2)**2)


def woodward_colella(cells):
    edges = np.linspace(0., 1., cells + 1)
    x = 0.5 * (edges[1:] + edges[:-1])
    pressure = np.where(x < 0.1, 1000., np.where(x > 0.9, 100., 0.01))
    return Gas(edges, np.ones(cells), np.zeros(cells), pressure, True), 0.038


def shu_osher(cells):
    """The gas that will be between -5 and 5, and some on either side; cells
    have about equal masses."""
    begin, jump, end = -5. - 1.05 * 1.8 * 2.629369, -4., 5.2
    width = 10. / cells
    waves = np.arange(jump, end, width)
    edges = np.concatenate([np.arange(jump, begin, -width / 3.857143)[:0:-1],
                            waves])
    low, high = edges[:-1], edges[1:]
    density = np.where(
        low < jump - 1e-9, 3.857143,
        1. - 0.04 * (np.cos(5. * high) - np.cos(5. * low)) / (high - low))
    return Gas(edges, density, np.where(low < jump - 1e-9, 2.629369, 0.),
               np.where(low < jump - 1e-9, 10.33333, 1.), False), 1.8


def thinned(rows, part=3e-5):
    """The rows between which straight lines hold the others."""
    ranges = part * (rows.max(axis=0) - rows.min(axis=0))[1:]
    kept, begin = [0], 0
    while begin < len(rows) - 1:
        reach, stride = begin + 1, 1
        while True:
            tried = min(begin + 2 * stride, len(rows) - 1)
            if tried <= reach or not straight(rows, begin, tried, ranges):
                break
            reach, stride = tried, 2 * stride
        while stride >= 1:
            tried = min(reach + stride, len(rows) - 1)
            if tried > reach and straight(rows, begin, tried, ranges):
                reach = tried
            else:
                stride //= 2
        kept.append(reach)
        begin = reach
    return rows[kept]


def straight(rows, begin, end, ranges):
    inner = rows[begin:end + 1]
    part = (inner[:, :1] - inner[0, 0]) / (inner[-1, 0] - inner[0, 0])
    lines = inner[0, 1:] + part * (inner[-1, 1:] - inner[0, 1:])
    return np.all(np.abs(inner[:, 1:] - lines) <= ranges)


def main(problem, cells, file=None):
    gas, end = {"woodward_colella": woodward_colella,
                "shu_osher": shu_osher}[problem](int(cells))
    time, steps = 0., 0
    while time < end * (1. - 1e-12):
        time += gas.advance(end - time)
        steps += 1
    x = 0.5 * (gas.edges[1:] + gas.edges[:-1])
    rows = np.stack([x, *gas.fields()], axis=1)
    if problem == "shu_osher":
        rows = rows[(x > -5.05) & (x < 5.05)]
    print(f"{problem}: {len(x)} cells, {steps} steps, densities from "
          f"{rows[:, 1].min():.5g} to {rows[:, 1].max():.5g}")
    if file:
        np.savetxt(file, thinned(rows), fmt="%.7g", delimiter=",", comments="",
                   header=TITLE.format(problem, cells, end)
                   + "position [m],density [kg/m^3],velocity [m/s],pressure [Pa]")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
