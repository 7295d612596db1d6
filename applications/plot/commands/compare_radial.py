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
from plot.figures import profiles

ROWS = 6  # of the table over time


def show(rows):
    """A table in Markdown, its first row the head."""
    for number, row in enumerate(rows):
        print("| " + " | ".join(row) + " |")
        if number == 0:
            print("|" + "---|" * len(row))
    print()


def tell_conservation(runs):
    show([["run", "mass, kg", "largest change of it", "energy, J",
           "largest change of it"]]
         + [[run.label, *(text for values in (run.history["mass"], run.energy())
                          for text in (
            f"{values[0]:.6g}",
            f"{np.max(np.abs(values / values[0] - 1.)):.1e}"))] for run in runs])


def tell_history(runs):
    """Mass and energy over those at the start, less one, and the share of the
    energy that is kinetic, at some times."""
    end = min(run.history["time"][-1] for run in runs)
    times = np.linspace(0., end, ROWS)
    rows = [["time, s"], *([f"{time:.3g}"] for time in times)]
    for run in runs:
        rows[0] += [f"{run.label}: change of mass", "of energy",
                    "kinetic share, %"]
        mass, energy = run.history["mass"], run.energy()
        for row, time in zip(rows[1:], times):
            i = np.argmin(np.abs(run.history["time"] - time))
            row += [f"{mass[i] / mass[0] - 1.:+.1e}",
                    f"{energy[i] / energy[0] - 1.:+.1e}",
                    f"{100. * run.history['kinetic_energy'][i] / energy[i]:.2f}"]
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
    profiles.draw_radial(runs, picture)
