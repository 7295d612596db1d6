#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A sphere of TNT in free air, in shells that move with the gas.

    lagrangian_blast.py WIDTH END AFTERBURN OUTER [at-once] [RADIUS]... [FILE.csv]

A reference for the tests of charges that shares nothing with the program but the
Euler equations, the constants of TNT and Miller's law: the staggered scheme of
J. von Neumann and R. D. Richtmyer (J. Appl. Phys. 21 (1950) 232-237), with a
viscosity of linear and quadratic terms. No mass crosses the shells, so that
products and air never mix. The detonation is a programmed burn after M. L.
Wilkins (UCRL-7322, 1963).

Charge: radius 0.05 m, lit in its centre; WIDTH is that of the shells in the air at
the beginning [m], END [s], AFTERBURN the energy of Miller's law [J/kg], OUTER where
the shells end, which is beyond what the blast reaches [m]; at-once: all of the
charge is burned at the start, without a detonation. Prints peak overpressure, impulse of the positive phase and arrival at each RADIUS [m],
how far energy drifted, and what the peak becomes when the shock meets a wall
head-on; writes what the shells hold at END.

Results (the longest took a minute): without afterburn at 0.25 m 9.97 and 10.07 MPa
(WIDTH 0.001, 0.0005), 0.05296 and 0.05304 ms. With 3.5e6 at 1 m 878, 900 and 899 kPa
(0.004, 0.002, 0.001), 0.528, 0.533 and 0.536 ms; at 1.2 m 559, 577 and 578 kPa. From
the speed of the front (arrivals within 0.06 m, to which a parabola is fitted) Rankine
and Hugoniot's relations have 905 kPa at 1 m and 579 kPa at 1.2 m, at a wall 2717.
"""

import sys

import numpy as np

from moving_cells import thinned

RADIUS = 0.05
# Products: Tan, Saunders and Bagchi (COUPLED PROBLEMS 2017), table 2.
DENSITY, A, B, R1, R2, OMEGA = 1630., 373.8e9, 3.747e9, 4.15, 0.90, 0.35
ENERGY, DETONATION_SPEED = 6.0e9 / DENSITY, 6930.
AIR_DENSITY, AIR_PRESSURE, HEATS = 1.225, 101325., 1.4
BURN_WIDTH = 3.  # shells
QUADRATIC, LINEAR = 1.5, 0.25  # of the viscosity
COURANT = 0.3


class Blast:
    """Edges and their velocities, masses (per steradian) and energies."""

    def __init__(self, width, outer):
        # Shells get thinner towards the surface, as products expand the most
        # there, and all masses change smoothly.
        layers = max(20, int(round(RADIUS / width * 1.5)))
        part = np.linspace(0., 1., layers + 1)
        inner = RADIUS * (1. - (1. - part)**1.8)
        beyond = np.arange(1, int((outer - RADIUS) / width) + 1) * width + RADIUS
        self.edges = np.concatenate([inner, beyond])
        self.speed = np.zeros(self.edges.size)
        self.charge = layers
        volume = np.diff(self.edges**3) / 3.
        self.density = np.where(np.arange(volume.size) < layers, DENSITY,
                                AIR_DENSITY)
        self.mass = volume * self.density
        self.energy = np.where(np.arange(volume.size) < layers, ENERGY,
                               AIR_PRESSURE / (HEATS - 1.) / AIR_DENSITY)
        self.at_nodes = np.concatenate(
            [[1.], 0.5 * (self.mass[1:] + self.mass[:-1]), [1.]])
        self.begin = 0.5 * (inner[1:] + inner[:-1]) / DETONATION_SPEED
        self.duration = BURN_WIDTH * np.diff(inner) / DETONATION_SPEED
        self.begin -= 0.5 * self.duration
        self.burned = np.zeros(layers)
        self.time, self.released, self.fraction = 0., 0., 0.
        self.active = layers + 10  # shells that may move
        self.pressure = np.full(volume.size, AIR_PRESSURE)
        self.viscosity = np.zeros(volume.size)
        self.step = 1e-10
        self.begun = self.total()

    def total(self):
        kinetic = 0.5 * self.at_nodes[1:-1] * self.speed[1:-1]**2
        return float(np.sum(self.mass * self.energy) + np.sum(kinetic))

    def curve(self, density, layers):
        """Pressure at zero energy and by how much energy raises it."""
        volume = DENSITY / density[:layers]
        first, second = A * np.exp(-R1 * volume), B * np.exp(-R2 * volume)
        base = np.zeros(density.size)
        slope = (HEATS - 1.) * density
        part = self.burned
        base[:layers] = part * (first * (1. - OMEGA / (R1 * volume))
                                + second * (1. - OMEGA / (R2 * volume))
                                ) + (1. - part) * AIR_PRESSURE
        slope[:layers] = part * OMEGA * density[:layers]
        return base, slope

    def sound(self, density, pressure, layers):
        square = HEATS * pressure / density
        volume = DENSITY / density[:layers]
        first, second = A * np.exp(-R1 * volume), B * np.exp(-R2 * volume)
        square[:layers] = volume / DENSITY * (
            volume * (R1 * first + R2 * second) + (1. + OMEGA)
            * np.maximum(pressure[:layers] - first - second, 0.))
        return np.sqrt(np.maximum(square, 1e4))

    def advance(self, longest, afterburn):
        step = min(self.step, longest)
        n, layers = self.active, self.charge
        total = self.pressure[:n] + self.viscosity[:n]
        edges, speed = self.edges[:n + 1], self.speed[:n + 1]
        speed[1:-1] -= step * edges[1:-1]**2 * np.diff(total) / \
            self.at_nodes[1:n]
        edges += step * speed
        cubes = edges**3
        density = 3. * self.mass[:n] / np.diff(cubes)
        self.time += step
        if self.burned.min() < 1.:
            compressed = 1. - DENSITY / density[:layers]
            self.burned = np.maximum(self.burned, np.clip(np.maximum(
                (self.time - self.begin) / self.duration,
                np.where(compressed > 0.1, compressed / 0.27, 0.)), 0., 1.))
        change = 1. / density - 1. / self.density[:n]
        closing = np.maximum(-np.diff(speed), 0.)
        sound = self.sound(density, self.pressure[:n], layers)
        viscosity = density * closing * (QUADRATIC * closing + LINEAR * sound)
        base, slope = self.curve(density, layers)
        middle = 0.5 * (viscosity + self.viscosity[:n])
        self.energy[:n] = (self.energy[:n] - change * (
            0.5 * (self.pressure[:n] + base) + middle)) / (
                1. + 0.5 * change * slope)
        if afterburn and self.burned.min() == 1.:
            self.burn_on(step, afterburn)
        self.pressure[:n] = base + slope * self.energy[:n]
        self.density[:n] = density
        self.viscosity[:n] = viscosity
        fastest = np.max((sound + 4. * QUADRATIC * closing) / np.diff(edges))
        if self.burned.min() < 1.:
            fastest = max(fastest, DETONATION_SPEED / np.min(
                np.diff(edges[:layers + 1])))
        self.step = min(1.05 * step if step == self.step else self.step,
                        COURANT / fastest)
        if abs(self.pressure[n - 5] / AIR_PRESSURE - 1.) > 1e-9:
            self.active = min(n + 20, self.mass.size)

    def burn_on(self, step, afterburn):
        """Miller's law with the mean pressure of the products."""
        masses = self.mass[:self.charge]
        pressure = np.sum(masses * self.pressure[:self.charge]) / masses.sum()
        left = max(np.sqrt(1. - self.fraction) - 0.5 * step * 6500. * (
            max(pressure, 0.) / 1e11)**(1. / 6.), 0.)**2
        share = afterburn * (1. - left - self.fraction)
        self.fraction = 1. - left
        self.energy[:self.charge] += share
        self.released += share * masses.sum()


def met_by_wall(peak):
    """Overpressure of a shock in air that meets a wall head-on."""
    return peak * 2. * (7. * AIR_PRESSURE + 4. * peak) / (
        7. * AIR_PRESSURE + peak)


def main(width, end, afterburn, outer, *others):
    places = [float(word) for word in others
              if word != "at-once" and not word.endswith(".csv")]
    width, end, afterburn = float(width), float(end), float(afterburn)
    blast = Blast(width, float(outer))
    if "at-once" in others:
        blast.burned[:] = 1.
    peaks, arrivals, impulses = ([0.] * len(places) for _ in range(3))
    ended = [False] * len(places)
    steps = 0
    while blast.time < end * (1. - 1e-12):
        blast.advance(end - blast.time, afterburn)
        steps += 1
        for index, place in enumerate(places):
            if place > blast.edges[blast.active] or ended[index]:
                continue
            cell = np.searchsorted(blast.edges[:blast.active], place)
            near = slice(max(cell - 3, 0), cell + 3)
            x = 0.5 * (blast.edges[1:] + blast.edges[:-1])[near]
            over = float(np.interp(place, x, blast.pressure[near]
                                   )) - AIR_PRESSURE
            if over > 0.05 * AIR_PRESSURE and not arrivals[index]:
                arrivals[index] = blast.time
            peaks[index] = max(peaks[index], over)
            impulses[index] += max(over, 0.) * blast.step
            ended[index] = peaks[index] > 0.05 * AIR_PRESSURE and over < 0.
    print(f"{blast.mass.size} shells, {steps} steps, energy off by "
          f"{(blast.total() - blast.released) / blast.begun - 1.:.1e}")
    for place, peak, impulse, arrival in zip(places, peaks, impulses, arrivals):
        print(f"{place} m: {peak / 1e3:.2f} kPa, {impulse:.2f} Pa s, "
              f"{arrival * 1e3:.5f} ms; at a wall {met_by_wall(peak) / 1e3:.1f}"
              " kPa")
    if others and others[-1].endswith(".csv"):
        burn = " at-once" if "at-once" in others else ""
        write(blast, others[-1],
              f"{width:g} {end:g} {afterburn:g} {outer}{burn}")


def write(blast, file, arguments):
    n = blast.active
    rows = np.stack([
        0.5 * (blast.edges[1:n + 1] + blast.edges[:n]), blast.density[:n],
        0.5 * (blast.speed[1:n + 1] + blast.speed[:n]), blast.pressure[:n],
        np.arange(n) < blast.charge], axis=1)
    np.savetxt(file, thinned(rows, 2e-4), fmt="%.6g", delimiter=",", comments="",
               header="# By another method than the program's, in shells that "
               "move with the gas:\n#   tests/references/lagrangian_blast.py "
               f"{arguments} FILE\nposition,density,velocity,pressure,products")


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
