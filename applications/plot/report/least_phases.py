# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Second waves within the positive phase at places on the skin and at the
probe next to the body: finer cells may let the pressure fall to zero before
them, which ends the phase there."""

import math
from typing import NamedTuple

import numpy as np

from plot.analysis import signals
from plot.report import error_estimate, injury_thresholds

PROBE = "probe 1"  # next to the body
# Part of the peak by which a dip between two waves stands out, and by which two
# runs can agree on it by chance.
SMALLEST_DIP = 0.02
ALIKE = 0.2  # relative difference of the times of one dip in both runs
AT_ONCE = 0.1  # relative difference of times of one wave at two places


class Wave(NamedTuple):
    """History of the overpressure [Pa] at a place, its arrival and positive
    phase [s], its peak, and the ambient pressure by which its load on lungs is
    judged."""
    time: np.ndarray
    over: np.ndarray
    arrival: float
    phase: float
    peak: float
    ambient: float = injury_thresholds.SEA_LEVEL

    def turns(self):
        """Tops and dips within the positive phase."""
        inside = (self.time >= self.arrival) \
            & (self.time <= self.arrival + self.phase)
        return signals.extrema(self.time[inside], self.over[inside],
                               SMALLEST_DIP * self.peak) \
            if inside.any() else ([], [])

    def dips(self):
        """Those within the positive phase: time after the arrival and
        overpressure."""
        return [(time - self.arrival, over) for time, over in self.turns()[1]]

    def last_wave(self):
        """Time from the arrival to the top of the last wave within the positive
        phase that follows a dip, 0 without [s]."""
        tops, dips = self.turns()
        return max((time - self.arrival for time, _ in tops
                    if dips and time > dips[0][0]), default=0.)

    def second_peak(self):
        """Its time [s], or None."""
        second = signals.find_peaks(self.time, self.over)[1]
        return None if second is None else float(self.time[second])


def of_skin(scene):
    """Times from the arrival to the end that finer cells may give the positive
    phase [s], by the place on the skin where they may."""
    coarser = _at_gauges(scene.coarser)
    return {name: least for name, wave in _at_gauges(scene).items() if (
        least := _least(scene, wave, coarser.get(name))) is not None}


def of_fewer_waves(scene):
    """Places on the skin whose positive phase ends before the last wave that is
    within that of the coarser run."""
    coarser = {name: wave.last_wave() for name, wave in
               _at_gauges(scene.coarser).items()}
    return {name for name, wave in _at_gauges(scene).items()
            if coarser.get(name, 0.) > wave.phase}


def at_probe(scene):
    """The same at the probe next to the body [s], or None."""
    wave = _at_probe(scene)
    return wave and _least(scene, wave, _at_probe(scene.coarser))


def part_of_load(scene, place):
    """Part of the load on lungs at a place that is left if its positive phase
    ends as early as finer cells may let it; 1 elsewhere."""
    wave, least = (_at_probe(scene), at_probe(scene)) if place == PROBE else (
        _at_gauges(scene).get(place), of_skin(scene).get(place))
    mass = scene.blast.parameter("Loads/Body mass")
    if least is None or mass is None:
        return 1.
    lethal = [injury_thresholds.median_lethal_load(phase, mass[0], wave.ambient)
              for phase in (wave.phase, least)]
    return lethal[0] / lethal[1]


def place_of_same_wave(scene):
    """The place on the skin to which first and second wave come when they come to
    the probe, as two waves of one charge do; None without."""
    probe = _at_probe(scene)
    second = probe and probe.second_peak()
    if not second:
        return None
    found = {}
    for name, wave in _at_gauges(scene).items():
        other = wave.second_peak()
        apart = abs(wave.arrival / probe.arrival - 1.)
        if other and max(apart, abs(other / second - 1.)) < AT_ONCE:
            found[name] = apart
    return min(found, key=found.get, default=None)


def _least(scene, wave, coarser):
    """The earliest dip of a Wave and of that of the coarser run [s] where finer
    cells may let it fall to zero, as its overpressure is within its error; None
    without."""
    here, there = wave.dips(), coarser.dips() if coarser else []
    ends = [dip for dip in here if not _stays(scene, wave, dip, coarser, min(
        there, key=lambda one, dip=dip: abs(one[0] - dip[0]), default=None))]
    if here[:1] == ends[:1]:
        ends += there[:1]
    least = min((dip[0] for dip in ends), default=math.inf)
    return least if least < wave.phase else None


def _stays(scene, wave, here, coarser, there):
    """Whether finer cells leave a dip above zero: by the coarser run, if that has
    the same dip; of a dip that it lacks nothing is known."""
    least = SMALLEST_DIP * wave.peak
    if coarser is None:
        return here[1] > least
    if there is None or abs(there[0] / here[0] - 1.) > ALIKE:
        return False
    times, _ = error_estimate.factor(scene, "lung_")
    return here[1] > max(times * abs(there[1] - here[1]), least)


def _at_gauges(run):
    """A Wave by the place on the skin."""
    gauges = run and run.blast.table("load_gauges.csv")
    if gauges is None:
        return {}
    return {name: Wave(gauges["time"], gauges[name], measures["arrival"],
                       measures["positive phase"], measures["peak"])
            for name, measures in run.gauge_measures().items()
            if name in gauges and measures["peak"] > 0.}


def _at_probe(run):
    """The Wave at the probe next to the body, or None."""
    measures = [run.blast.found("results", "probe_1_" + name) for name in (
        "arrival", "duration", "peak_overpressure")] if run else [None]
    probes = None if None in measures else run.blast.table("probes.csv")
    if probes is None or "probe_1_pressure" not in probes:
        return None
    pressure = probes["probe_1_pressure"]
    return Wave(probes["time"], pressure - pressure[0], *measures, pressure[0])
