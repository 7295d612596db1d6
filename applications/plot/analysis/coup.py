# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pressures before and behind in a head beside what experiments in shock tubes
saw."""

import numpy as np

CAVITATION = -100e3  # Pa
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
    """What the experiments saw, what these pressures [Pa] have, and whether it
    agrees: rows of two texts and a truth value."""
    begins = [time[first_time(time, p, 0.05)] for p in (coup, contrecoup)]
    first = contrecoup[first_time(time, contrecoup, 0.25)]
    grid, smooth = mean_over(time, contrecoup, SMOOTHED)
    turns = turning_points(smooth)
    peaks = [smooth[i] for i, rising in turns
             if rising and smooth[i] > PROMINENT]
    dips = [smooth[i] for i, rising in turns if not rising]
    # A dip lies between prominent maxima.
    parts = np.split(grid, [i for i, rising in turns if rising])
    n_below = sum(np.interp(part, time, contrecoup).min() < CAVITATION
                  for part in parts if len(part))

    def listed(values):
        return ", ".join(f"{1e-3 * value:.0f}" for value in values)

    delay = 1e3 * (begins[1] - begins[0])
    return [
        ("contrecoup later by some 0.1 ms", f"{delay:.3f} ms",
         0.05 < delay < 0.2),
        ("contrecoup begins negative", f"{1e-3 * first:.0f} kPa at first",
         first < 0.),
        ("higher positive peak at the contrecoup",
         f"{1e-3 * contrecoup.max():.0f} kPa, coup "
         f"{1e-3 * coup.max():.0f} kPa", contrecoup.max() > coup.max()),
        ("three positive peaks that fade there", listed(peaks[:3]) + " kPa",
         len(peaks) >= 3 and peaks[0] > peaks[1] > peaks[2]),
        ("three dips below -100 kPa there",
         f"{n_below}; lowest {1e-3 * contrecoup.min():.0f} kPa; means over "
         f"0.1 ms " + listed(dips[:3]), n_below >= 3)]
