#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""How far a Mach stem is from smooth: stem.py OUTPUT_FOLDER

Prints the largest distance in x [m] between the foremost shock in the last
pressure plane of a run, where the pressure passes ten times that ahead, and
the parabola through it, for 0 < y < 0.18: the stem of a double Mach
reflection. A kink or a foot that runs ahead cannot be fitted.
"""

import os
import sys

import numpy

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..",
                             "..", "..", "applications"))
from plot.readers import planes  # noqa: E402


def front(row, x, level):
    """Place of the last sample above the level, interpolated."""
    last = numpy.where(row > level)[0][-1]
    part = (row[last] - level) / (row[last] - row[last + 1])
    return x[last] + part * (x[1] - x[0])


def main(folder):
    plane = planes.open_planes(folder)["plane_pressure"][-1]
    pressure = plane.values
    x, y = (numpy.linspace(plane.lower[axis], plane.upper[axis],
                           pressure.shape[1 - axis]) for axis in range(2))
    level = 10. * pressure[0, -1]
    rows = y < 0.18
    places = numpy.array([front(row, x, level) for row in pressure[rows]])
    parabola = numpy.polyval(numpy.polyfit(y[rows], places, 2), y[rows])
    print(numpy.abs(places - parabola).max())


if __name__ == "__main__":
    main(sys.argv[1])
