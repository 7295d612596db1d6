# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""How well a history agrees with a reference: the rating of ISO/TS 18571:2014,
with its constants. The standard itself could not be seen; formula and constants
are those on which public implementations agree."""

import collections

import numpy as np

INNER, OUTER = 0.05, 0.5  # half-widths of the corridors, of the largest value
LARGEST_SHIFT = 0.2  # of the interval
WARPING = 0.1  # of the interval
LARGEST_MAGNITUDE, LARGEST_SLOPE = 0.5, 2.  # relative errors that score nothing
MEANS = 9  # points
WEIGHTS = (0.4, 0.2, 0.2, 0.2)
GRADES = ((0.94, "excellent"), (0.8, "good"), (0.58, "fair"), (-1., "poor"))

Rating = collections.namedtuple("Rating",
                                "corridor phase magnitude slope total")


def corridor(reference, values):
    """1 within the inner corridor around the reference, 0 beyond the outer one,
    the square of a straight line between: the mean over time."""
    apart = np.abs(values - reference) / np.abs(reference).max()
    return float(np.mean(np.clip((OUTER - apart) / (OUTER - INNER), 0.,
                                 1.)**2))


def overlap(reference, values, shift):
    """Both, where the values are later by so many points."""
    if shift >= 0:
        return reference[:len(reference) - shift], values[shift:]
    return reference[-shift:], values[:shift]


def correlation(one, other):
    one, other = one - one.mean(), other - other.mean()
    size = np.linalg.norm(one) * np.linalg.norm(other)
    return float(one @ other / size) if size > 0. else 0.


def best_shift(reference, values):
    """Points by which the values are late, for the largest correlation; the
    smallest such shift."""
    most = int(LARGEST_SHIFT * len(reference))
    shifts = sorted(range(-most, most + 1), key=abs)
    found = np.array([correlation(*overlap(reference, values, shift))
                      for shift in shifts])
    # Equal but for round-off.
    return shifts[np.argmax(found > found.max() - 1e-12)]


def warped(one, other, width):
    """Pairs of numbers of points, at most @p width apart, that dynamic time
    warping joins: the least sum of squared differences from both beginnings to
    both ends."""
    n = len(one)
    cost = np.full((n + 1, n + 1), np.inf)
    cost[0, 0] = 0.
    for i in range(n):
        for j in range(max(0, i - width), min(n, i + width + 1)):
            cost[i + 1, j + 1] = (one[i] - other[j])**2 + min(
                cost[i, j], cost[i, j + 1], cost[i + 1, j])
    i = j = n
    pairs = []
    while i > 0 and j > 0:
        pairs.append((i - 1, j - 1))
        i, j = min(((i - 1, j - 1), (i - 1, j), (i, j - 1)),
                   key=lambda place: cost[place])
    return np.array(pairs[::-1])


def magnitude(reference, values):
    """From the error that is left after time warping."""
    width = max(1, int(np.ceil(WARPING * len(reference))) - 1)
    first, second = warped(reference, values, width).T
    error = np.abs(values[second] - reference[first]).sum() \
        / np.abs(reference[first]).sum()
    return float(max(0., 1. - error / LARGEST_MAGNITUDE))


def slopes(values):
    """Differences and means over MEANS points, fewer at the ends."""
    raw = np.gradient(values)
    half = MEANS // 2
    return np.array([
        raw[i - reach:i + reach + 1].mean() for i, reach in (
            (i, min(half, i, len(raw) - 1 - i)) for i in range(len(raw)))])


def slope(reference, values):
    expected = slopes(reference)
    error = np.abs(slopes(values) - expected).sum() / np.abs(expected).sum()
    return float(max(0., 1. - error / LARGEST_SLOPE))


def rate(reference, values):
    """Rating of values against a reference, at the same equal steps of time.
    Raises ValueError for a reference that does not change."""
    if np.ptp(reference) <= 0.:
        raise ValueError("the reference does not change over time")
    shift = best_shift(reference, values)
    moved = overlap(reference, values, shift)
    scores = (corridor(reference, values),
              1. - abs(shift) / (LARGEST_SHIFT * len(reference)),
              magnitude(*moved), slope(*moved))
    return Rating(*scores, float(np.dot(WEIGHTS, scores)))


def grade(total):
    return next(word for least, word in GRADES if total > least)
