#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Judges pressures before and behind in a head: plot_coup.py OUTPUT_FOLDER

Takes a run of biomechanics whose first and third probe are at the coup and the
contrecoup. Prints what Tan, Saunders and Bagchi (2017) saw in experiments in
shock tubes and whether the run has it: the contrecoup is later by 0.1 ms,
begins negative, has the higher peak, peaks that fade, and three dips below
-100 kPa. Writes pictures/coup.png.
"""

import os
import sys

import numpy as np

import look
from plot_pressures import draw, pressures_of
import usage

CAVITATION = -100e3
SMOOTHED = 1e-4  # s, for what counts as a peak
PROMINENT = 20e3  # Pa


def first_time(time, values, part):
    """When the values first have that part of their largest one."""
    return np.argmax(np.abs(values) > part * np.abs(values).max())


def mean_over(time, values, span):
    """Running means."""
    grid = np.linspace(time[0], time[-1], 4 * len(time))
    width = max(1, int(span / (grid[1] - grid[0])))
    even = np.interp(grid, time, values)
    return grid, np.convolve(np.pad(even, width // 2, mode="edge"),
                             np.ones(width) / width, mode="same")[
                                 width // 2:width // 2 + len(grid)]


def turning_points(values):
    """Numbers of maxima and minima, in turn, that differ by PROMINENT."""
    found, best, rising = [], 0, True
    for i, value in enumerate(values):
        ahead = value - values[best] if rising else values[best] - value
        if ahead >= 0.:
            best = i
        elif ahead < -PROMINENT:
            found.append((best, rising))
            best, rising = i, not rising
    return found


def judge(time, coup, contrecoup):
    begins = [time[first_time(time, p, 0.05)] for p in (coup, contrecoup)]
    first = contrecoup[first_time(time, contrecoup, 0.25)]
    grid, smooth = mean_over(time, contrecoup, SMOOTHED)
    turns = turning_points(smooth)
    peaks = [smooth[i] for i, rising in turns
             if rising and smooth[i] > PROMINENT]
    dips = [(grid[i], smooth[i]) for i, rising in turns if not rising]
    # A dip lies between prominent maxima.
    parts = np.split(grid, [i for i, rising in turns if rising])
    n_below = sum(np.interp(part, time, contrecoup).min() < CAVITATION
                  for part in parts if len(part))

    def listed(values):
        return ", ".join(f"{1e-3 * value:.0f}" for value in values)

    def say(fact, found, holds):
        print(f"{fact:46} {found:58} {'yes' if holds else 'no'}")

    delay = 1e3 * (begins[1] - begins[0])
    say("contrecoup later by some 0.1 ms", f"{delay:.3f} ms",
        0.05 < delay < 0.2)
    say("contrecoup begins negative", f"{1e-3 * first:.0f} kPa at first",
        first < 0.)
    say("higher positive peak at the contrecoup",
        f"{1e-3 * contrecoup.max():.0f} kPa, coup {1e-3 * coup.max():.0f} kPa",
        contrecoup.max() > coup.max())
    say("three positive peaks that fade there", listed(peaks[:3]) + " kPa",
        len(peaks) >= 3 and peaks[0] > peaks[1] > peaks[2])
    say("three dips below -100 kPa there",
        f"{n_below}; lowest {1e-3 * contrecoup.min():.0f} kPa; means over "
        f"0.1 ms " + listed([value for _, value in dips[:3]]), n_below >= 3)


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 1
    folder = arguments[0]
    time, pressures = pressures_of(folder, ["coup", "middle", "contrecoup"])
    if time is None:
        return 1
    look.set_up()
    judge(time, pressures["coup"], pressures["contrecoup"])
    pictures = os.path.join(folder, "pictures")
    os.makedirs(pictures, exist_ok=True)
    draw(folder, time, pressures, {"contrecoup": 1e-3 * CAVITATION},
         os.path.join(pictures, "coup.png"))
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
