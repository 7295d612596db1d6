# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""What histories say: arrivals, phases, peaks, and what a chest makes of
them."""

import numpy as np

ARRIVED = 0.05  # of the largest absolute value

# Axelsson and Yelverton, J. Trauma 40 (1996) S31-S37: a chest wall of a man
# of 70 kg.
WALL_AREA, WALL_MASS = 0.082, 2.03  # m^2, kg
WALL_DAMPING, WALL_SPRING = 696., 989.  # kg/s, N/m
LUNG_VOLUME, LUNG_EXPONENT = 1.82e-3, 1.2  # m^3, -


def arrival(time, values, part=ARRIVED):
    """When a history first reaches a part of its largest absolute value; None
    for one that is zero throughout."""
    size = np.abs(values)
    if not size.max() > 0.:
        return None
    return float(time[np.argmax(size >= part * size.max())])


def positive_phase(time, values):
    """When the first positive phase begins and ends, and its impulse: until
    the overpressure is first back at zero."""
    begin = arrival(time, np.maximum(values, 0.))
    if begin is None:
        return None
    first = int(np.searchsorted(time, begin))
    after = np.flatnonzero(values[first:] <= 0.)
    last = first + int(after[0]) if after.size else len(time) - 1
    start = max(first - 1, 0)
    while start > 0 and values[start] > 0.:
        start -= 1
    part = slice(start, last + 1)
    impulse = float(np.trapz(np.maximum(values[part], 0.), time[part]))
    return begin, float(time[last]), impulse


def rise_time(time, values):
    """From a tenth to nine tenths of the first peak that has half of the
    largest value at least [s]."""
    top = values.max()
    first = int(np.argmax(values >= 0.5 * top))
    while first + 1 < len(values) and values[first + 1] > values[first]:
        first += 1
    before = values[:first + 1]
    low = int(np.argmax(before >= 0.1 * values[first]))
    high = int(np.argmax(before >= 0.9 * values[first]))
    return float(time[high] - time[low])


def extrema(time, values, smallest):
    """Turning points that stand out by @p smallest, as (time, value) in two
    lists: tops and dips."""
    tops, dips = [], []
    high = low = 0
    rising = None
    for i in range(1, len(values)):
        if values[i] > values[high]:
            high = i
        if values[i] < values[low]:
            low = i
        if rising is not False and values[high] - values[i] > smallest:
            if rising:
                tops.append((float(time[high]), float(values[high])))
            rising, low = False, i
        elif rising is not True and values[i] - values[low] > smallest:
            if rising is False:
                dips.append((float(time[low]), float(values[low])))
            rising, high = True, i
    return tops, dips


def smooth(time, values, span):
    """Running mean over @p span [s]."""
    step = float(np.median(np.diff(time)))
    count = max(1, int(round(span / step)))
    kernel = np.ones(count) / count
    padded = np.pad(values, (count // 2, count - 1 - count // 2), mode="edge")
    return np.convolve(padded, kernel, mode="valid")


def chest_wall_velocity(time, overpressure, ambient=101325.):
    """Largest inward velocity [m/s] of the chest wall under an overpressure
    [Pa], by the classical Runge-Kutta scheme."""
    def rate(load, x, v):
        left = max(LUNG_VOLUME - WALL_AREA * x, 1e-3 * LUNG_VOLUME)
        lung = ambient * (LUNG_VOLUME / left) ** LUNG_EXPONENT
        return (WALL_AREA * (load + ambient - lung) - WALL_DAMPING * v
                - WALL_SPRING * x) / WALL_MASS

    step = 1e-5
    moments = np.arange(time[0], time[-1], 0.5 * step)
    loads = np.interp(moments, time, overpressure)
    x = v = largest = 0.
    for i in range(0, len(moments) - 2, 2):
        first, middle, last = loads[i:i + 3]
        a1 = rate(first, x, v)
        v2 = v + 0.5 * step * a1
        a2 = rate(middle, x + 0.5 * step * v, v2)
        v3 = v + 0.5 * step * a2
        a3 = rate(middle, x + 0.5 * step * v2, v3)
        v4 = v + step * a3
        a4 = rate(last, x + step * v3, v4)
        x += step / 6. * (v + 2. * v2 + 2. * v3 + v4)
        v += step / 6. * (a1 + 2. * a2 + 2. * a3 + a4)
        largest = max(largest, v)
    return float(largest)


def severity_index(velocity):
    """Adjusted severity of injury index of a chest wall velocity [-]."""
    return (0.124 + 0.117 * velocity) ** 2.63


def half_lethal(duration, mass):
    """Overpressure on the chest that half survive [Pa] (Bowen et al. 1968)."""
    scaled = 1e3 * duration * (70. / mass) ** (1. / 3.)
    return 61.5 * 6894.757 * (1. + 6.76 * scaled ** -1.064)


def eardrum_rupture(peak):
    """Part of the eardrums that rupture at a peak overpressure [Pa]."""
    from math import erfc, log, sqrt
    if not peak > 0.:
        return 0.
    return 0.5 * erfc((5. - (-12.6 + 1.524 * log(peak))) / sqrt(2.))
