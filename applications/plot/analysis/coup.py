# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pressures before and behind in a head, next to those that experiments in
shock tubes saw."""

import numpy as np

from plot.analysis import signals

BANDWIDTH = 20e3  # Hz; no source gives that of the experiment's gauges
CAVITATION = -100e3  # Pa
ONSET = 5e3  # Pa
PROMINENT = 20e3  # Pa, for a pressure that has a sign
PEAK = 0.25  # of the highest peak, for what counts as one
REACHED = 0.95  # of the least pressure of a cavitating fluid


def required_dip(least_pressure):
    """Pressure [Pa] that a dip must fall below. A fluid that cavitates falls no
    further than its least pressure, None if there is none: if that is above the
    cavitation limit, a dip has to reach it."""
    if least_pressure is None or least_pressure < CAVITATION:
        return CAVITATION
    return REACHED * least_pressure


def swings(values):
    """Numbers of the highest and lowest values, in turn: a swing begins where
    the pressure first has its sign by PROMINENT, and ends where the next
    begins."""
    found, sign = [], 0
    for i in np.flatnonzero(np.abs(values) > PROMINENT):
        if np.sign(values[i]) != sign:
            sign = np.sign(values[i])
            found.append(i)
        elif sign * values[i] > sign * values[found[-1]]:
            found[-1] = i
    return found


def peaks_and_dips(values):
    """Peaks of PEAK of the highest one at least, and the lowest values before,
    between and after them, as far as they are negative by PROMINENT."""
    highest = max(PEAK * values.max(), PROMINENT)
    tops = [i for i in swings(values) if values[i] >= highest]
    lows = [part.min() for part in np.split(values, tops) if len(part)]
    return values[tops], np.array([low for low in lows if low < -PROMINENT])


def listed(values):
    return ", ".join(f"{1e-3 * value:.0f}" for value in values) or "none"


def judge(coup, contrecoup, step, dip=CAVITATION):
    """Findings of the experiments, those of these pressures [Pa] at equal
    @p step [s], and whether they agree: rows of two texts and a truth value.
    @p dip is required_dip()."""
    beyond = [np.abs(pressure) > ONSET for pressure in (coup, contrecoup)]
    first, second = map(np.argmax, beyond)
    delay = 1e3 * step * (second - first) if all(map(np.any, beyond)) else None
    first = [contrecoup[i] for i in swings(contrecoup)[:1]]
    peaks, dips = peaks_and_dips(contrecoup)
    n_below = int(np.sum(dips < dip))
    limit = "" if dip == CAVITATION else f" {1e-3 * dip:.0f} kPa (cut-off)"
    return [
        ("contrecoup later by some 0.1 ms",
         "no onset" if delay is None else f"{delay:.3f} ms",
         delay is not None and 0.05 < delay < 0.2),
        ("contrecoup begins negative", f"first swing {listed(first)} kPa",
         bool(first) and first[0] < 0.),
        ("higher positive peak at the contrecoup",
         f"{1e-3 * contrecoup.max():.0f} kPa, coup "
         f"{1e-3 * coup.max():.0f} kPa", contrecoup.max() > coup.max()),
        ("three positive peaks that fade there", listed(peaks) + " kPa",
         len(peaks) >= 3 and peaks[0] > peaks[1] > peaks[2]),
        ("three dips below -100 kPa there",
         f"{n_below}{' below' + limit if limit else ''}; dips "
         f"{listed(dips)} kPa", n_below >= 3)]


def filtered(time, pressures, bandwidth=BANDWIDTH):
    """Time at equal steps, and pressures by name below @p bandwidth [Hz]."""
    grid, result = time, {}
    for name, values in pressures.items():
        grid, result[name] = signals.low_pass(time, values, bandwidth)
    return grid, result
