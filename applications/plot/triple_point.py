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

Stems shorter than a captured front is wide cannot be seen. If the run has
probes on the ground, the range where reflection ceases to be regular is found
from them as well: where the gas behind the reflected wave, seen from the point
of reflection, no longer is supersonic, so that what happens above the ground
can reach that point. Two-shock theory has its limit a tenth of a degree on.
"""

import os
import re
import sys

import matplotlib.pyplot as plt
import numpy as np

import look
import planes
import tables
import usage

EXPONENT = 1.4   # of air
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


def ground_probes(folder):
    """Numbers and ranges of the probes on the ground, off the axis."""
    with open(os.path.join(folder, "parameters.prm"),
              encoding="utf-8") as file:
        text = file.read()
    entry = re.search(r"^subsection Probes$.*?^  set Points *=(.*?)$", text,
                      re.MULTILINE | re.DOTALL)
    points = entry[1].split(";") if entry and entry[1].strip() else []
    places = [[float(word) for word in point.split(",")] for point in points]
    return [(number, x) for number, (x, y) in enumerate(places, 1)
            if y == 0. and x > 0.]


def mach_numbers(folder, height):
    """Ground ranges [m], and Mach numbers of the gas at peak pressure
    relative to the point of reflection, which moves along the ground."""
    table = tables.open_table(folder, "probes.csv")
    probes = ground_probes(folder) if table else []
    ranges, arrivals, states = [], [], []
    for number, x in probes:
        pressure = table[f"probe_{number}_pressure"]
        above = np.nonzero(pressure > DISTURBED * pressure[0])[0]
        peak = np.argmax(pressure)
        if len(above) == 0 or peak + 1 == len(pressure):
            continue
        ranges.append(x)
        arrivals.append(table["time"][above[0]])
        states.append((table[f"probe_{number}_velocity_x"][peak],
                       np.sqrt(EXPONENT * pressure[peak]
                               / table[f"probe_{number}_density"][peak])))
    if len(ranges) < 6:
        return None
    ranges, states = np.array(ranges), np.array(states)
    # Smoother in the distance from the charge, which the front is a sphere
    # around, than in the range.
    distance = np.hypot(ranges, height)
    slowness = np.polyval(np.polyder(np.polyfit(distance, arrivals, 4)),
                          distance)
    speed = distance / (ranges * slowness)
    return ranges, (speed - states[:, 0]) / states[:, 1]


def sonic_range(ranges, mach):
    """Where the Mach number falls through one [m], or None."""
    for i in range(len(ranges) - 1):
        if mach[i] >= 1. > mach[i + 1]:
            part = (mach[i] - 1.) / (mach[i] - mach[i + 1])
            return ranges[i] + part * (ranges[i + 1] - ranges[i])
    return None


def draw_mach(axis, ranges, mach, transition):
    axis.plot(ranges, mach, "o-", markersize=3)
    axis.axhline(1., color=look.GREY)
    if transition:
        axis.axvline(transition, color=look.GREY, linestyle="--")
        axis.set_title(f"regular up to {transition:.3f} m")
    axis.set_xlabel(look.label("ground range", "m"))
    axis.set_ylabel("Mach number behind the reflection")


def draw_path(axis, ground, top, early, curve, height):
    axis.plot(ground, top, "o", markersize=3, label="triple point")
    heights = np.linspace(0., top[early].max(), 50)
    axis.plot(np.polyval(curve, heights), heights, color=look.GREY,
              label=f"parabola, from {curve[-1]:.3f} m on")
    axis.set_xlabel(look.label("ground range", "m"))
    axis.set_ylabel(look.label("height", "m"))
    axis.set_title(f"path of the triple point, charge at {height:g} m")
    axis.set_ylim(bottom=0.)
    axis.legend()


def follow_path(folder, height):
    """Ground ranges and heights of the triple point [m], which of them are
    early, and a parabola through those, or None without a stem."""
    cuts = planes.open_planes(folder).get("plane_pressure", [])
    if not cuts:
        return None
    background = float(np.median(cuts[0].values))
    path = [(cut.time, *point) for cut in cuts
            for point in [triple_point(cut, height, background)] if point]
    if len(path) < 4:
        return None
    for row in path:
        print("time %.6g s  range %.4f m  height %.4f m" % row)
    _, ground, top = np.array(path).T
    # The beginning of the path, where it is nearly a parabola.
    early = top < 0.25 * height
    if np.count_nonzero(early) < 4:
        early[:] = True
    return ground, top, early, np.polyfit(top[early], ground[early], 2)


def main(arguments):
    if len(arguments) != 2:
        print("usage: triple_point.py OUTPUT_FOLDER HEIGHT", file=sys.stderr)
        return 1
    folder, height = arguments[0], float(arguments[1])
    panels = []
    path = follow_path(folder, height)
    if path:
        print(f"Mach stem from a ground range of {path[-1][-1]:.4f} m on")
        panels.append(lambda axis: draw_path(axis, *path, height))
    reflection = mach_numbers(folder, height)
    if reflection:
        limit = sonic_range(*reflection)
        if limit:
            print(f"Regular reflection up to a ground range of {limit:.4f} m")
        panels.append(lambda axis: draw_mach(axis, *reflection, limit))
    if not panels:
        print(f"triple_point.py: {folder} has neither a Mach stem in its "
              "pressure planes (Pictures/Planes = all) nor six probes on the "
              "ground", file=sys.stderr)
        return 1

    look.set_up()
    figure, axes = plt.subplots(1, len(panels), squeeze=False,
                                figsize=(5.5 * len(panels), 3.6))
    for axis, draw in zip(axes[0], panels):
        draw(axis)
    pictures = os.path.join(folder, "pictures")
    os.makedirs(pictures, exist_ok=True)
    look.save(figure, os.path.join(pictures, "triple_point.png"))
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
