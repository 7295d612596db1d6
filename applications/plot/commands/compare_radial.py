# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws blasts around the origin beside one another:

    plot.py compare_radial PICTURE.png RADIUS [LABEL=]RESULT...

A RESULT is the output folder of a run that depends on the distance from the
origin alone (one-dimensional ones of blast; cones and balls of head_impact), or
a table of position, density, velocity and pressure (CSV). PICTURE.png gets
density, velocity and pressure at the end of each, and pressures around its
shock with as many marks as there are cells. Prints tables of mass and energy
over time, and of the shock: its peak overpressure, its width from 10 to 90 % of
that in mm and in cells, and the peak and impulse at RADIUS [m] where a run has
kept fifty fields or more (Output/Fields interval).
"""

import os

import numpy as np

from plot.readers import radial
from plot.figures import radial_profiles

ROWS = 6  # of the table over time


def show(rows):
    """A table in Markdown, its first row the head."""
    for number, row in enumerate(rows):
        print("| " + " | ".join(row) + " |")
        if number == 0:
            print("|" + "---|" * len(row))
    print()


def change(values):
    """Largest relative change since the start."""
    return float(np.max(np.abs(values / values[0] - 1.)))


def tell_conservation(runs):
    show([["run", "mass, kg", "largest change of it", "energy, J",
           "largest change of it"]]
         + [[run.label, f"{run.mass()[0]:.6g}", f"{change(run.mass()):.1e}",
             f"{run.energy()[0]:.6g}", f"{change(run.energy()):.1e}"]
            for run in runs])


def tell_history(runs):
    """Mass and energy over those at the start, less one, and the share of the
    energy that is kinetic, at some times."""
    end = min(run.history["time"][-1] for run in runs)
    head = ["time, s"]
    for run in runs:
        head += [f"{run.label}: change of mass", "of energy",
                 "kinetic share, %"]
    rows = [head]
    for time in np.linspace(0., end, ROWS):
        row = [f"{time:.3g}"]
        for run in runs:
            i = int(np.argmin(np.abs(run.history["time"] - time)))
            mass, energy = run.mass(), run.energy()
            kinetic = run.history["kinetic_energy"]
            row += [f"{mass[i] / mass[0] - 1.:+.1e}",
                    f"{energy[i] / energy[0] - 1.:+.1e}",
                    f"{100. * kinetic[i] / energy[i]:.2f}"]
        rows.append(row)
    show(rows)


def tell_shocks(runs, radius):
    rows = [["run", "peak overpressure at the end, MPa", "at, m",
             "width of the shock, mm", "cells",
             f"peak overpressure at {radius:g} m, MPa", "impulse there, Pa s"]]
    for run in runs:
        shock = run.last.shock()
        row = [run.label] + (["-"] * 4 if shock is None else [
            f"{shock[0] / 1e6:.3f}", f"{shock[1]:.4f}",
            f"{shock[2] * 1e3:.2f}",
            f"{shock[3]:.2f}" if run.history else "-"])
        there = run.at(radius)
        rows.append(row + (["-"] * 2 if there is None else [
            f"{there[0] / 1e6:.3f}", f"{there[1]:.2f}"]))
    show(rows)


def main(picture, radius: float, result, *more_results):
    runs = []
    for argument in (result, *more_results):
        label, sign, path = argument.rpartition("=")
        runs.append(radial.RadialRun(
            label if sign else os.path.basename(path.rstrip("/")), path))
    with_history = [run for run in runs if run.history]
    if with_history:
        tell_conservation(with_history)
        tell_history(with_history)
    tell_shocks(runs, radius)
    radial_profiles.draw(runs, picture)
