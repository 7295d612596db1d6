# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Rates how well pressures at the probes of a run of biomechanics agree with
those of another one, as one with smaller elements:
plot.py agreement OUTPUT_FOLDER REFERENCE_FOLDER [KILOHERTZ]

Prints for each probe the rating of ISO/TS 18571: corridor, phase, magnitude,
slope, and their weighted mean, 1 for equal histories; above 0.94 it is called
excellent, above 0.8 good, above 0.58 fair, else poor. Both are compared below
KILOHERTZ, 20 by default, over the time that both have.
"""

import numpy as np

from plot.analysis import coup, rating
from plot.readers import files, tables

POINTS = 500


def pressures_of(folder, hertz):
    """Time and pressures of all probes, by number."""
    table = tables.open_table(folder, "probes.csv")
    count = 0
    while table is not None and f"probe_{count + 1}_pressure" in table:
        count += 1
    if not count:
        raise files.BrokenInput(f"{folder} has no pressures in probes.csv")
    return coup.filtered(*tables.probe_pressures(
        folder, range(1, count + 1)), hertz)


def main(output_folder, reference_folder,
         kilohertz: float = 1e-3 * coup.BANDWIDTH):
    if not kilohertz > 0.:
        raise files.BrokenInput("KILOHERTZ must be above 0")
    (time, found), (other, expected) = (
        pressures_of(folder, 1e3 * kilohertz)
        for folder in (output_folder, reference_folder))
    grid = np.linspace(max(time[0], other[0]), min(time[-1], other[-1]),
                       POINTS)
    if grid[-1] <= grid[0]:
        raise files.BrokenInput(f"{output_folder} and {reference_folder} have "
                                "no time in common")
    print(f"{'probe':>5} {'corridor':>9} {'phase':>6} {'magnitude':>10} "
          f"{'slope':>6} {'rating':>7}")
    for number in sorted(set(found) & set(expected)):
        with files.reading(f"{reference_folder}, probe {number}"):
            scores = rating.rate(np.interp(grid, other, expected[number]),
                                 np.interp(grid, time, found[number]))
        print(f"{number:5} {scores.corridor:9.3f} {scores.phase:6.3f} "
              f"{scores.magnitude:10.3f} {scores.slope:6.3f} "
              f"{scores.total:7.3f}  {rating.grade(scores.total)}")
