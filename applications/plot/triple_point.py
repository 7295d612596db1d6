#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws the path of the triple point: triple_point.py OUTPUT_FOLDER HEIGHT

Reads the pressure planes of an axisymmetric run (Pictures/Planes = all) with
a charge HEIGHT [m] above ground, y = 0. The blast in free air is a sphere
around the charge, whose radius is seen above it. Where the front along the
ground is ahead of that sphere there is a Mach stem; its upper end is the
triple point. Writes OUTPUT_FOLDER/pictures/triple_point.png and prints the
path and the ground range at which the stem begins, where a parabola through
the path meets the ground.
"""

import os
import sys

import matplotlib.pyplot as plt
import numpy as np

import look
import planes

DISTURBED = 1.1  # times the pressure at rest
AHEAD = 1.5      # samples that a stem is ahead of the sphere at least


def front(pressure, positions, threshold):
    """The outermost place where the pressure falls through the threshold, or
    None if the pressure is nowhere above it or still is at the end."""
    above = np.nonzero(pressure > threshold)[0]
    if len(above) == 0 or above[-1] + 1 == len(pressure):
        return None
    i = above[-1]
    part = (pressure[i] - threshold) / (pressure[i] - pressure[i + 1])
    return positions[i] + part * (positions[i + 1] - positions[i])


def sphere(plane, height, threshold):
    """Radius of the free-air blast, from rays slightly upwards, or None if
    it has left the plane or not left the charge."""
    heights = np.linspace(plane.lower[1], plane.upper[1],
                          plane.values.shape[0])
    ranges = plane.positions()
    step = ranges[1] - ranges[0]
    radii = []
    for angle in np.radians(np.arange(5., 26., 2.)):
        along = np.arange(0., plane.upper[0] / np.cos(angle), 0.5 * step)
        x, y = along * np.cos(angle), height + along * np.sin(angle)
        inside = (x < ranges[-1]) & (y < heights[-1]) & (x > ranges[0])
        column = (x[inside] - ranges[0]) / step
        row = (y[inside] - heights[0]) / step
        values = bilinear(plane.values, row, column)
        radius = front(values, along[inside], threshold)
        if radius is not None:
            radii.append(radius)
    return np.median(radii) if len(radii) > 5 else None


def bilinear(values, row, column):
    i = np.minimum(row.astype(int), values.shape[0] - 2)
    j = np.minimum(column.astype(int), values.shape[1] - 2)
    s, t = row - i, column - j
    return ((1. - s) * ((1. - t) * values[i, j] + t * values[i, j + 1])
            + s * ((1. - t) * values[i + 1, j] + t * values[i + 1, j + 1]))


def triple_point(plane, height, background):
    """Range and height of the triple point [m], or None without a stem."""
    threshold = DISTURBED * background
    radius = sphere(plane, height, threshold)
    if radius is None or radius <= height:
        return None
    ranges = plane.positions()
    step = ranges[1] - ranges[0]
    stem = []  # height, lead, range
    for row, y in enumerate(np.linspace(plane.lower[1], plane.upper[1],
                                        plane.values.shape[0])):
        if y >= height:
            break
        place = front(plane.values[row], ranges, threshold)
        if place is None:
            return None
        lead = place - np.sqrt(max(radius**2 - (height - y)**2, 0.))
        if lead < AHEAD * step:
            break
        stem.append((y, lead, place))
    if len(stem) < 3:
        return None
    # The lead goes to zero at the triple point.
    y, lead, place = np.array(stem[-max(3, len(stem) // 2):]).T
    slope, top = np.polyfit(lead, y, 1)
    return (place[-1], top if slope < 0. else y[-1])


def main(arguments):
    if len(arguments) != 2:
        print("usage: triple_point.py OUTPUT_FOLDER HEIGHT", file=sys.stderr)
        return 1
    folder, height = arguments[0], float(arguments[1])
    cuts = planes.open_planes(folder).get("plane_pressure", [])
    if not cuts:
        print(f"triple_point.py: {folder} has no pressure planes; set "
              "Pictures/Planes = all", file=sys.stderr)
        return 1
    background = float(np.median(cuts[0].values))
    path = [(cut.time, *point) for cut in cuts
            for point in [triple_point(cut, height, background)] if point]
    if len(path) < 4:
        print("triple_point.py: no Mach stem found", file=sys.stderr)
        return 1
    time, ground, top = np.array(path).T
    for row in path:
        print("time %.6g s  range %.4f m  height %.4f m" % row)
    # The beginning of the path, where it is nearly a parabola.
    early = top < 0.25 * height
    if np.count_nonzero(early) < 4:
        early[:] = True
    curve = np.polyfit(top[early], ground[early], 2)
    print(f"Mach stem from a ground range of {curve[-1]:.4f} m on")

    look.set_up()
    figure, axis = plt.subplots(figsize=(6., 3.6))
    axis.plot(ground, top, "o", markersize=3, label="triple point")
    heights = np.linspace(0., top[early].max(), 50)
    axis.plot(np.polyval(curve, heights), heights, color=look.GREY,
              label=f"parabola, from {curve[-1]:.3f} m on")
    axis.set_xlabel(look.label("ground range", "m"))
    axis.set_ylabel(look.label("height", "m"))
    axis.set_title(f"path of the triple point, charge at {height:g} m")
    axis.set_ylim(bottom=0.)
    axis.legend()
    pictures = os.path.join(folder, "pictures")
    os.makedirs(pictures, exist_ok=True)
    look.save(figure, os.path.join(pictures, "triple_point.png"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
