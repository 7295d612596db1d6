# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Least positive phases before second waves, worked out again from the files
of a scene and its coarser run."""

import math
import os

from case import read_columns, read_json
from summaries import values_of

RUNS = ("blast", "coarser_blast")
SMALLEST = 0.02  # of the peak


def first_dip(times, values, arrival, phase, peak):
    """Time after the arrival and overpressure where a history first turns up
    again within its positive phase, by SMALLEST at least; None without."""
    inside = [(time, value) for time, value in zip(times, values)
              if arrival <= time <= arrival + phase]
    top, low = -math.inf, (0., math.inf)
    for time, value in inside:
        if top - low[1] > SMALLEST * peak and value - low[1] > SMALLEST * peak:
            return low[0] - arrival, low[1]
        if value > top:
            top, low = value, (time, value)
        elif value < low[1]:
            low = time, value
    return None


def last_wave(times, values, arrival, phase, peak):
    """Time from the arrival to the last top within the positive phase that
    follows a fall and a rise by SMALLEST at least, 0 without."""
    last, top, low, has_dip = 0., (-math.inf, 0.), None, False
    for time, value in zip(times, values):
        if not arrival <= time <= arrival + phase:
            continue
        if low is None:
            if value > top[0]:
                top = value, time
            elif top[0] - value > SMALLEST * peak:
                last = top[1] - arrival if has_dip else 0.
                low = value
        elif value < low:
            low = value
        elif value - low > SMALLEST * peak:
            top, low, has_dip = (value, time), None, True
    return last


def least_phase(waves):
    """Least phase by the arguments of first_dip() in both runs, None for a run
    without; None where the phase stands."""
    fine, coarse = waves
    dips = [wave and first_dip(*wave) for wave in waves]
    if dips[0]:
        time, value = dips[0]
        error = SMALLEST * fine[4]
        if dips[1] and abs(dips[1][0] / time - 1.) <= 0.2:
            error = max(error, abs(dips[1][1] - value) / (2. ** 0.7 - 1.))
        elif coarse:
            error = math.inf
        if value > error:
            return None
    least = min((dip[0] for dip in dips if dip), default=math.inf)
    return least if least < fine[3] else None


def of_skin(output, places, coarser_places):
    """The least phase by gauge, of those that have one."""
    least = {name: least_phase(waves) for name, waves in _waves(
        output, places, coarser_places)}
    return {name: phase for name, phase in least.items() if phase is not None}


def of_fewer_waves(output, places, coarser_places):
    """Gauges whose phase ends before the last wave that the coarser run has in
    it."""
    return {name for name, (fine, coarse) in _waves(
        output, places, coarser_places)
            if coarse and last_wave(*coarse) > fine[3]}


def _waves(output, places, coarser_places):
    """Arguments of first_dip() in both runs, by gauge."""
    histories = [read_columns(output, run, "load_gauges.csv")
                 if os.path.exists(os.path.join(output, run, "load_gauges.csv"))
                 else {} for run in RUNS]
    for name, known in places.items():
        if not known["peak"] > 0. or name not in histories[0]:
            continue
        waves = [(of_run["time"], of_run[name], measures[name]["arrival"],
                  measures[name]["positive phase"], measures[name]["peak"])
                 if name in of_run and measures.get(name, {}).get("peak", 0.) > 0.
                 else None for of_run, measures in zip(
                     histories, (places, coarser_places))]
        yield name, waves


def at_probe(output):
    """Positive phase and least phase at the first probe, or None."""
    waves = []
    for run in RUNS:
        paths = [os.path.join(output, run, name)
                 for name in ("summary.json", "probes.csv")]
        known = values_of(read_json(paths[0]), "results") \
            if all(map(os.path.exists, paths)) else {}
        measures = [known.get("probe_1_" + name) for name in (
            "arrival", "duration", "peak_overpressure")]
        if None in measures:
            waves.append(None)
            continue
        columns = read_columns(paths[1])
        pressure = columns["probe_1_pressure"]
        waves.append((columns["time"], [value - pressure[0]
                                        for value in pressure], *measures))
    least = waves[0] and least_phase(waves)
    return None if least is None else (waves[0][3], least)


def part_of_load(phase, least, mass):
    """Part of Bowen's load at sea level that a shorter phase leaves."""
    lethal = [1. + 6.76 * (1e3 * time * (70. / mass) ** (1. / 3.)) ** -1.064
              for time in (phase, least)]
    return lethal[0] / lethal[1]
