# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Numerical errors of a scene, from its run with larger cells and elements."""

import math
import statistics

import numpy as np

from plot.analysis import signals
from plot.report import page

# Assumed order of convergence: pressures at fronts converge slower than to
# first order. See parameter_files/scene/error_estimate.md for how often the
# estimate covers the difference to finer cells.
ORDER = 0.7


# Measures of gauge_measures.csv that have an estimated error.
GAUGE_MEASURES = ("peak", "impulse", "positive phase")
# Smallest relative error of a measure: two runs can agree by chance.
LEAST = 0.02
SAME_CELLS = 0.9  # of this run's, in the coarser one
WHOLE_SKIN = 0.95  # of this run's, in the gas of the coarser one


def of_gauges(fine, coarse, ratio, other_phases=(), other_waves=None):
    """Relative errors by gauge and measure, from the measures of both runs (as
    Scene.gauge_measures()) and the ratio of their cells. Two runs can agree at
    a place by chance: no error is smaller than LEAST, or than the median of its
    measure over all gauges. Measures that are missing or not positive have
    none, nor have impulse and phase where a run cuts them off or one alone has
    more waves in the phase, as at the gauges @p other_phases. By gauge,
    @p other_waves has the peaks of each wave in both runs."""
    times = 1. / (ratio ** ORDER - 1.)
    errors = {gauge: {} for gauge in fine}
    for name in GAUGE_MEASURES:
        for gauge, measures in fine.items():
            value, is_cut, other, is_other_cut = (
                one.get(key, math.nan) for one in (measures, coarse.get(gauge, {}))
                for key in (name, "cut off"))
            if name != "peak" and (gauge in other_phases
                                   or is_cut + is_other_cut >= 1.):
                continue
            if value > 0. and math.isfinite(other):
                errors[gauge][name] = times * abs(other / value - 1.)
            if name == "peak" and gauge in (other_waves or {}):
                errors[gauge][name] = max(
                    (one + times * abs(same - one)) / value - 1.
                    for one, same in other_waves[gauge])
        known = [one[name] for one in errors.values() if name in one]
        for one in errors.values():
            if name in one:
                one[name] = max(one[name], LEAST, statistics.median(known))
    return errors


def of_scene_gauges(scene, other_phases=()):
    """of_gauges() of a scene and its coarser run; {} without one."""
    ratio = (scene.facts.get("coarser_run") or {}).get("cell_ratio", 2.)
    return {} if scene.coarser is None else of_gauges(
        scene.gauge_measures(), scene.coarser.gauge_measures(), ratio,
        other_phases, _other_waves(scene))


def _other_waves(scene):
    """Peaks of both waves in both runs [Pa], by the gauges where these differ in
    which wave is larger; 0 for a wave that the coarser run lacks."""
    found = {}
    fine, coarse = (run.blast.table("load_gauges.csv")
                    for run in (scene, scene.coarser))
    for name in scene.gauge_measures():
        if None in (fine, coarse) or name not in fine or name not in coarse:
            continue
        tops = signals.find_peaks(fine["time"], fine[name])
        if None in tops:
            continue
        times, peaks = (fine[key][list(tops)] for key in ("time", name))
        away = np.abs(np.subtract.outer(times, coarse["time"]))
        if np.argmax(peaks) != np.argmin(away[:, np.argmax(coarse[name])]):
            over = coarse[name]
            is_top = (over >= np.roll(over, 1)) & (over >= np.roll(over, -1))
            found[name] = [
                (peak, np.max(over, where=near & is_top, initial=0.))
                for peak, near in zip(peaks, away <= 0.5 * np.ptp(times))]
    return found


def factor(scene, name):
    """Error over the difference between both runs: 1 / (r^p - 1) with ratio r
    of the sizes and order p, and the sizes that differ."""
    ratios = scene.facts.get("coarser_run") or {}
    ratio, causes = ratios.get("cell_ratio", 2.), "cells"
    if not name.startswith(("ear_", "chest_", "lung_")):
        ratio = min(ratio, ratios.get("element_ratio") or ratio)
        causes = "cells and elements"
    return 1. / (ratio ** ORDER - 1.), causes


def of(scene, name, value, coarser):
    """Relative error of a measure, at least LEAST, and its causes; of a value of
    zero infinite, or none where the coarser run has zero, too."""
    times, causes = factor(scene, name)
    if not value:
        return math.inf if coarser else 0., causes
    return max(LEAST, times * abs(coarser / value - 1.)), causes


def of_area(scene, area, difference, most):
    """Lower and upper limit of an area, from its difference in the coarser run;
    no area is larger than @p most."""
    error = max(LEAST * area, factor(scene, "ear_")[0] * abs(difference))
    return max(area - error, 0.), min(area + error, most)


def of_result(scene, name):
    """Relative error of a result of the blast, None if unknown."""
    values = [run and run.blast.found("results", name)
              for run in (scene.coarser, scene)]
    return of(scene, "lung_", *values[::-1])[0] if all(values) else None


def of_skin(scene, name):
    """Largest value of a measure of the loads over the skin, in the coarser run
    and in this one, and its relative error, at least that of all gauges, as two
    places can agree by chance; None for what is unknown."""
    values = [None if known is None or not len(known.areas) else
              known.largest(name) for known in (
                  scene.coarser and scene.coarser.loads(), scene.loads())]
    gauges = [one[name] for one in of_scene_gauges(scene).values() if name in one]
    return (*values, max(of(scene, "lung_", *values[::-1])[0], min(
        gauges, default=0.)) if all(values) else None)


def same_cells(scene):
    """A sentence in a list where the coarser run is coarser near the body alone."""
    counts = [run and run.blast.summary.get("cells")
              for run in (scene.coarser, scene)]
    return [] if None in counts or counts[0] < SAME_CELLS * counts[1] else [
        "The wave's way to the body has the same cells in the coarser run, so that "
        "estimated errors leave out what it loses there (entry Scene/Cell size)."]


def why_unknown(scene, entries):
    """Why the errors of measures are unknown, a clause."""
    is_alone = scene.coarser is None or not scene.coarser.blast.exists
    if scene.has_own_mesh() and (is_alone or all(
            entry.name.startswith("injury_") for entry in entries)):
        return "your own hexahedra have no coarser mesh"
    if is_alone:
        return "the scene has no coarser run"
    return "the coarser run has no complete value of " + (
        "it" if len(entries) == 1 else "them")


def _rows_of_skin(scene):
    """Rows of section() for scenes that end with the loads."""
    for name, unit, title in (
            ("peak", "Pa", "largest overpressure on the skin"),
            ("impulse", "Pa s", "largest impulse on the skin")):
        coarser, value, found = of_skin(scene, name)
        if found is not None:
            yield (title, *(page.limit(page.quantity(size, unit),
                                       name == "impulse"
                                       and run.loads().is_cut_off(name))
                            for size, run in (
                                (coarser, scene.coarser), (value, scene))),
                   page.error(found))


def section(scene, judged):
    """The measures of both runs; None without a coarser run."""
    if scene.coarser is None:
        return page.paragraph(
            "The numerical error of this scene is unknown: it has no finished "
            "coarser run (Scene/Error estimate).")
    rows = list(_rows_of_skin(scene)) if scene.asks_for_loads() or all(
        entry.error is None for entry in judged) else []
    rows += [(entry.title, entry.shown_coarser(), entry.shown(),
              entry.shown_error() or "unknown") for entry in judged
             if (entry.error, entry.coarser) != (None, None)]
    coarser = "The coarser run has cells of twice the size" + (
        ", and no body: your own hexahedra have no coarser mesh, and errors of "
        "what happens in the body are unknown" if scene.has_own_mesh() else
        "" if scene.asks_for_loads() else " and elements of 5/3 of the size")
    skins = [run.blast.found("checks", "loads_skin_projections")
             for run in (scene.coarser, scene)]
    if all(skins) and skins[0] < WHOLE_SKIN * skins[1]:
        coarser += (f". Its gas has {page.percent(skins[0] / skins[1])} of the "
                    "skin that this run has, and errors contain the effect of "
                    "what is missing")
    if not rows:
        return page.paragraph(coarser + ". This scene has no measure of injury "
                              "whose error it could tell.")
    return page.table(
        ("measure", "coarser run", "this run", "estimated error"), rows,
        page.tag(
            "span", coarser
            + ". The estimated error is the difference of both runs over r",
            page.tag("sup", ORDER), " − 1 with the ratio r of the sizes, and "
            "at least 2 %. Errors of peak, impulse and positive phase on the "
            "skin are each at least the median over all places, since both runs "
            "may agree at one place by chance. For chest wall and lungs the "
            "error is at least that of the peak on the chest, or on the back "
            "where that is shown, and beside the body that of the largest peak "
            "there; probabilities have the bounds that follow from the error of "
            "the pressure or load by their curve; the least load is that of the "
            "least positive phase, where finer cells may end it before a second "
            "wave; what happens in the body has at least the difference of the "
            "impulse on the elements from the recorded one; maximum and minimum "
            "brain pressure both take the larger of their errors, and so do "
            "fraction and mean time of the brain at low pressure where both runs "
            "have them whole."),
        numbers=(1, 2, 3))
