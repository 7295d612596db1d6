# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The path of the triple point above the ground, and where regular reflection
ends."""

import os

import numpy as np

from plot.readers import files, planes, tables

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
    ranges, heights = plane.positions(), plane.positions(1)
    step = ranges[1] - ranges[0]
    radii = []
    for angle in np.radians(np.arange(5., 26., 2.)):
        along = np.arange(0., plane.upper[0] / np.cos(angle), 0.5 * step)
        x, y = along * np.cos(angle), height + along * np.sin(angle)
        inside = (x < ranges[-1]) & (y < heights[-1]) & (x > ranges[0])
        values = bilinear(plane.values, (y[inside] - heights[0]) / step,
                          (x[inside] - ranges[0]) / step)
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
    for y, values in zip(plane.positions(1), plane.values):
        if y >= height:
            break
        place = front(values, ranges, threshold)
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
    entry = files.read_parameters(os.path.join(folder, "parameters.prm")
                                  ).get("Probes/Points", "")
    points = [[float(word) for word in point.split(",")]
              for point in entry.split(";") if point.strip()]
    return [(number, x) for number, (x, y) in enumerate(points, 1)
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


class Path:
    """Path of the triple point: times [s], ground ranges and heights [m],
    which of them are early, and the coefficients of a parabola through the
    early ones, the range over the height."""

    def __init__(self, points, height):
        self.times, self.ranges, self.heights = np.array(points).T
        # The beginning of the path, where it is nearly a parabola.
        self.early = self.heights < 0.25 * height
        if np.count_nonzero(self.early) < 4:
            self.early[:] = True
        self.parabola = np.polyfit(self.heights[self.early],
                                   self.ranges[self.early], 2)


def follow_path(folder, height):
    """The Path, or None without a stem."""
    cuts = planes.open_planes(folder).get("plane_pressure", [])
    if not cuts:
        return None
    background = float(np.median(cuts[0].values))
    points = [(cut.time, *point) for cut in cuts
              for point in [triple_point(cut, height, background)] if point]
    return Path(points, height) if len(points) >= 4 else None
