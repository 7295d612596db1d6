#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Angles of shocks at a wedge: wedge.py OUTPUT_FOLDER ANGLE

A plane shock runs along x over a wedge that rises from the origin at ANGLE
degrees. Prints, from the last pressure plane of the run and in degrees, the
angle from the wall to the reflected shock next to the wall ("reflected", of
regular reflection) and to the way of the triple point ("triple_point", where
a Mach stem that is straight and normal to the wall meets the incident shock).
"""

import json
import os
import sys

import numpy

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..",
                             "..", "..", "applications"))
from plot.readers import planes  # noqa: E402


class Plane:
    def __init__(self, folder):
        plane = planes.open_planes(folder)["plane_pressure"][-1]
        self.pressure = plane.values
        self.x, self.y = (
            numpy.linspace(plane.lower[axis], plane.upper[axis],
                           self.pressure.shape[1 - axis])
            for axis in range(2))

    def along_wall(self, angle, height):
        """Ways along the wall, at this distance from it, and pressures."""
        way = numpy.linspace(0., 2. * self.x[-1], 6000)
        x = way * numpy.cos(angle) - height * numpy.sin(angle)
        y = way * numpy.sin(angle) + height * numpy.cos(angle)
        inside = (x > self.x[0]) & (x < self.x[-1]) & (y < self.y[-1])
        way, x, y = way[inside], x[inside], y[inside]
        p = self.pressure
        i = numpy.searchsorted(self.x, x) - 1
        j = numpy.searchsorted(self.y, y) - 1
        a = (x - self.x[i]) / (self.x[1] - self.x[0])
        b = (y - self.y[j]) / (self.y[1] - self.y[0])
        return way, ((p[j, i] * (1 - a) + p[j, i + 1] * a) * (1 - b) +
                     (p[j + 1, i] * (1 - a) + p[j + 1, i + 1] * a) * b)


def foremost(way, values, level):
    return way[numpy.where(values > level)[0][-1]]


def main(folder, degrees):
    plane = Plane(folder)
    angle = numpy.radians(degrees)
    top = plane.pressure[-1]
    behind, ahead = top[0], numpy.nanmin(top)
    shock = foremost(plane.x, top, 0.5 * (behind + ahead))
    foot = shock / numpy.cos(angle)
    # Levels half way up the incident shock and the one that is reflected.
    near = numpy.linspace(0.03, 0.1, 30) * foot
    stem = numpy.mean([foremost(*plane.along_wall(angle, height),
                                0.5 * (behind + ahead)) for height in near])
    height = (stem * numpy.cos(angle) - shock) / numpy.sin(angle)
    highest = max(numpy.nanmax(plane.along_wall(angle, distance)[1])
                  for distance in near)
    reflected = [foremost(*plane.along_wall(angle, height),
                          0.5 * (behind + highest)) for height in near]
    slope = numpy.polyfit(reflected, near, 1)[0]
    print(json.dumps({
        "reflected": numpy.degrees(numpy.arctan(-slope)),
        "triple_point": numpy.degrees(numpy.arctan2(height, stem))}))


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]))
