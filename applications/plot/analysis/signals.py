# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Facts from histories: arrivals, phases, peaks."""

import numpy as np

ARRIVED = 0.05  # of the largest absolute value
LIKE_LARGEST = 0.4  # of a rise: what is less may be an oscillation behind a front
NEAR = 0.01  # of the run, between the sample of a peak and the peak itself
FIRST_WAVES = 2.5e-3  # s from the onset in tissue, without echoes of echoes
ROUND_OFF = 1e-6  # of single precision, as a part of the largest absolute value


def extremes(values):
    """Least and largest value, 0 where the round-off of the larger one is
    more."""
    bounds = float(np.min(values)), float(np.max(values))
    scale = max(map(abs, bounds))
    return tuple(0. if abs(bound) < ROUND_OFF * scale else bound
                 for bound in bounds)


def onset(time, values, part=ARRIVED):
    """When a history first reaches a part of its largest absolute value; None
    for one that is zero throughout."""
    size = np.abs(values)
    if not size.max() > 0.:
        return None
    return float(time[np.argmax(size >= part * size.max())])


def goes_on(values):
    """Whether the least and the largest value are the last ones, so that they
    are those of the end of the run alone."""
    return tuple(bool(bound and values[0] != bound == values[-1])
                 for bound in extremes(values))


def arrival(time, values, part=ARRIVED):
    """When a history arrives: the middle of its first rise beyond a part of its
    largest absolute value, as the blast defines arrivals on the skin; None for
    one that is zero throughout. The rise ends where a tenth of it is lost, and
    its middle is the mean time weighted with what the value grows by."""
    rise = _first_rise(time, values, part)
    return None if rise is None else float(rise[1] @ rise[0] / rise[1].sum())


def arrival_span(time, values):
    """From a tenth to nine tenths of the rise whose middle is the arrival [s]; 0
    for a history that is zero throughout."""
    rise = _first_rise(time, values, ARRIVED)
    if rise is None:
        return 0.
    part = np.cumsum(rise[1]) / rise[1].sum()
    low, high = (rise[0][int(np.argmax(part >= limit))] for limit in (0.1, 0.9))
    return float(high - low)


def _first_rise(time, values, part):
    """Times and growths of the first rise, see arrival(); None without."""
    size = np.abs(values)
    if not size.max() > 0.:
        return None
    begin = int(np.argmax(size >= part * size.max()))
    highest = np.maximum.accumulate(size[begin:])
    lost = np.flatnonzero(size[begin:] < 0.9 * highest)
    highest = highest[:lost[0]] if lost.size else highest
    growth = np.diff(highest, prepend=0.)
    return np.asarray(time)[begin:begin + len(growth)], growth


def rise_time(time, values):
    """From a tenth to nine tenths of the first of find_peaks() [s]; NaN without
    one."""
    first, _ = find_peaks(time, values)
    if first is None:
        return np.nan
    low, high = (time[np.argmax(values[:first + 1] >= part * values[first])]
                 for part in (0.1, 0.9))
    return float(high - low)


def extrema(time, values, smallest):
    """Turning points that stand out by @p smallest, as (time, value) in two
    lists: tops and dips."""
    tops, dips = [], []
    high = low = 0
    rising = None
    for i in range(1, len(values)):
        high = i if values[i] > values[high] else high
        low = i if values[i] < values[low] else low
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
    """Equal steps of time, and running means over @p span [s] there; the history
    itself where it is too short for that."""
    if len(time) < 5:
        return time, values
    even = np.linspace(time[0], time[-1], 2 * len(time))
    count = max(1, int(round(span / float(np.median(np.diff(even))))))
    padded = np.pad(np.interp(even, time, values),
                    (count // 2, count - 1 - count // 2), mode="edge")
    return even, np.convolve(padded, np.ones(count) / count, mode="valid")


def low_pass(time, values, bandwidth):
    """The history at equal steps of time, and below @p bandwidth [Hz], where
    half of the power is left: a Butterworth filter of second order, forwards
    and backwards, which shifts no phase. Before and after the history its first
    and last value are assumed."""
    grid = np.linspace(time[0], time[-1], 2 * len(time))
    even = np.interp(grid, time, values)
    step = grid[1] - grid[0]
    width = int(2. / (bandwidth * step)) + 1
    # The end returns to the beginning, as the transform is periodic.
    whole = np.concatenate([
        np.full(width, even[0]), even, np.full(width, even[-1]),
        np.linspace(even[-1], even[0], 2 * width)])
    ratio = np.fft.rfftfreq(len(whole), step) / bandwidth
    gain = 1. / (1. + (np.sqrt(2.) - 1.) * ratio**4)
    return grid, np.fft.irfft(gain * np.fft.rfft(whole),
                              len(whole))[width:width + len(even)]


def find_peaks(time, over):
    """Indices of the first peak and of the second one: the top of the first
    rise after it that is above the ambient pressure, of a tenth of the peak and
    LIKE_LARGEST of the largest later rise at least, and not the end, where the
    pressure may rise on."""
    if np.max(over) <= 0.:
        return None, None
    # The first peak ends where a fifth of it is lost again.
    first = 0
    for i in range(1, len(over)):
        if over[i] > over[first]:
            first = i
        elif over[i] < 0.8 * over[first] and over[first] > 0.3 * np.max(over):
            break
    later = over[first:] - np.minimum.accumulate(over[first:])
    least = max(0.1 * over[first], LIKE_LARGEST * np.max(later))
    top = first
    while True:
        rise = over[top:] - np.minimum.accumulate(over[top:])
        if not np.max(rise) >= least:
            return first, None
        rise[:int(np.argmax(rise >= least))] = 0.
        lost = np.flatnonzero(rise < 0.8 * np.maximum.accumulate(rise))
        top += int(np.argmax(rise[:lost[0]] if lost.size else rise))
        if top == len(over) - 1:
            return first, None
        if over[top] > 0.:
            return first, top


def peaks_of_steps(time, over, measures):
    """(time, value) of both find_peaks() at a gauge, or None. The largest is that
    of its @p measures: samples are means over steps and lack some of the
    peak."""
    peaks = []
    for index in find_peaks(time, over):
        peak = None if index is None else (float(time[index]), float(over[index]))
        if peak and "peak" in measures and peak[1] == np.max(over) and \
                abs(measures["peak time"] - peak[0]) < NEAR * time[-1]:
            peak = measures["peak time"], measures["peak"]
        peaks.append(peak)
    return peaks
