# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""What could change the verdict of a scene: a sentence each."""

import re

import numpy as np

from plot.analysis import person, signals, tissue_places
from plot.readers import files
from plot.report import (comparison, error_estimate, injury_table,
                         load_impulses, page, reflections, unfinished, verdict)
from plot.report.energy_audit import EnergyAudit
from plot.report.injury_thresholds import (SEA_LEVEL, median_lethal_load,
                                           of_run)

LARGE_LOAD_DIFFERENCE = 0.02  # of impulses on skin and elements
LARGE_PUSH_DIFFERENCE = 0.1  # of small differences of large impulses
# Words for items of the audit, for readers who do not know the plan.
WORDS = {"reflection": "arrival of a wave reflected by an open side of the "
         "domain"}
PRODUCTS = 0.1  # mass fraction from which they are told
SIMPLE = 0.75  # least part of the impulse in the first wave of a simple one
AHEAD = 0.85  # of the arrival by the tables
LARGE_BIAS = 0.1  # of the model, which may decide a verdict


def of(scene, judged):
    """How sure the answer is, a sentence each."""
    parts = unfinished.reservations(scene)
    if injury_table.lungs_by(scene) == "skin":
        why = injury_table.why_by_the_skin(scene)
        parts.append(f"{why[:1].upper()}{why[1:]}: death by lung injury follows "
                     "from the reflected load on the skin.")
    parts += _walls(scene, judged) + _grazed_sides(scene)
    parts += _products(scene) + _runs_ahead(scene) + _in_a_gap(scene)
    parts += _not_simple(scene, judged) + _long_load(scene, judged)
    parts += _askew(scene, judged) + _along_the_body(scene, judged)
    parts += _late_tension(scene, judged)
    parts += _tables(scene, judged) + _verdicts(scene, judged)
    parts += injury_table.cut_off(judged, "Scene/End time",
                                  scene.fact("end_time"))
    parts += tissue_places.holes(scene)
    parts += _afterburn(scene) + _model_bias(scene)
    parts += _loads(scene) + EnergyAudit(scene).reservations() + _limits(scene)
    parts += error_estimate.same_cells(scene) + _ground(scene)
    parts += _unused_thresholds(scene, judged)
    if any(entry.name == "injury_strain_95" for entry in judged):
        parts.append(
            "No limit of brain pressure or strain is agreed on for blast: the "
            "published limits were found for impacts, and survived blasts "
            "exceed the pressure limits.")
    failed = [stage.get("name") for stage in scene.list_of("stages")
              if stage.get("status") == "failed"
              and not str(stage.get("name")).startswith("coarser_")]
    if failed:
        parts.append("The scene is not complete: " + page.joined(
            str(name) for name in failed) + " failed.")
    return parts


def _products(scene):
    """That explosive products come to the probe beside the body."""
    probes = scene.blast.table("probes.csv")
    name = "probe_1_products"
    if not injury_table.has_probe_at_body(scene) or not probes \
            or name not in probes or probes[name].max() < PRODUCTS:
        return []
    return ["Explosive products come to the probe beside the body (up to "
            f"{page.percent(probes[name].max(), 2)} of the mass): what is told of "
            "people in the open there is of a wave that chest and head need not "
            "meet."]


def _runs_ahead(scene):
    """The jet along the ground of a charge on it, where it reaches the body."""
    known = scene.loads()
    expected = (scene.facts.get("tables") or {}).get("answer") or {}
    if known is None or not reflections.is_surface_burst(scene) \
            or not known.arrived().any() or "arrival" not in expected:
        return []
    times = np.where(known.arrived(), known.measure("arrival"), np.inf)
    first = int(times.argmin())
    return [] if times[first] > AHEAD * expected["arrival"] else [
        "Along the ground the wave of a charge on it runs ahead: it reaches the "
        f"skin first after {page.milliseconds(float(times[first]))}, "
        f"{page.height(known.centroids[first])} above the ground, where the tables "
        f"have {page.milliseconds(expected['arrival'])} for the nearest skin; "
        + ("all loads on a person who lies there, those of trunk and head too, "
           "are of this jet." if (scene.facts.get("person") or {}).get("posture")
           == "lying" else "loads on feet and legs are of this jet.")]


def _in_a_gap(scene):
    """That lungs are judged by gas in a gap thinner than a cell."""
    side, cell = injury_table.loaded_side(scene), scene.fact("cell_size_at_body")
    place = scene.loads() and scene.loads().places().get(side)
    return [] if place is None or not cell or injury_table.lungs_by(scene) != \
        "skin" or scene.fact("height") is None or place[2] >= cell else [
            f"Lungs are judged by the load at the {side}, in a gap of "
            f"{page.quantity(float(place[2]), 'm')} above the ground, thinner than "
            f"a cell: finer cells may change it much ({_entry_of_cells(scene)})."]


def _not_simple(scene, judged):
    """That lungs are judged by a wave for which their measure is not made."""
    fraction = scene.air_injury().get(("first_phase_fraction", comparison.PROBE))
    return [] if fraction is None or fraction.value > SIMPLE or injury_table.find(
        judged, "lung_exposure_air") is None else [
            "The wave beside the body is not simple: its first wave has "
            f"{page.percent(fraction.value)} of the impulse. The load on the lung "
            "is made for simple waves, and taken of both waves together."]


def _long_load(scene, judged):
    """That lungs are judged by a longer load than the first positive phase."""
    load = injury_table.find(judged, "lung_exposure_air")
    longer = scene.air_injury().get(("lung_load_duration", comparison.PROBE))
    first = scene.blast.found("results", "probe_1_duration")
    mass = scene.blast.parameter("Loads/Body mass")
    if None in (load, longer, first, mass):
        return []
    lethal = [median_lethal_load(phase, mass[0], SEA_LEVEL)
              for phase in (longer.value, first)]
    return ["The load on the lung is judged over "
            f"{page.milliseconds(longer.value)}, to the end of a later phase "
            "among explosive products; over the first phase of "
            f"{page.milliseconds(first)} it is "
            f"{page.number(load.value * lethal[0] / lethal[1])} instead of "
            f"{load.shown()}."]


def _askew(scene, judged):
    """That none of the gauges around the trunk faces the charge."""
    off = injury_table.off_the_gauges(scene)
    return [] if not off \
        or injury_table.find(judged, "chest_wall_mean") is None else [
            f"The charge is {page.number(off, 2)}° off the nearest of the axes of "
            "chest, back and sides: none of the gauges by which lungs are judged "
            "faces it, and the skin between them may be loaded more."]


def _along_the_body(scene, judged):
    """That free-field loads on lungs are of somebody who stands in the wave."""
    side = person.side_to_charge(scene)
    where = "trunk" if (scene.facts.get("tables") or {}).get("trunk") else "answer"
    load, death = (scene.table_answer(name, where, ("along_body",))[0]
                   for name in comparison.LUNGS)
    return [] if side not in ("head", "feet") or None in (load, death) or not any(
        entry.name in comparison.LUNGS for entry in judged) else [
            f"The charge is at the {side}: the tables' load on the lung is of a person "
            "who stands, side-on plus dynamic pressure; along the body the side-on "
            f"pressure alone loads it (Bowen et al. 1968): {page.number(load)} of "
            f"what kills half, death by lung injury {page.chance(death)}."]


def _late_tension(scene, judged):
    """That the brain is judged by a swing after the first waves in it."""
    entry = injury_table.find(judged, "injury_intracranial_pressure_lowest")
    history = scene.biomechanics.table("history.csv")
    if entry is None or not entry.exceeded() or not history \
            or "brain_pressure_5" not in history:
        return []
    time, pressure = history["time"], history["brain_pressure_5"]
    begin = tissue_places.brain_arrival(scene)
    lowest = float(time[pressure.argmin()])
    return [] if begin is None or lowest < begin + signals.FIRST_WAVES else [
        f"The brain's pressure is lowest {page.milliseconds(lowest)} after the "
        f"ignition, {page.milliseconds(lowest - begin, 2)} after the wave has "
        "reached the brain: it swings"
        + (", and may fall further after the end of the run."
           if lowest > 0.8 * time[-1] else ".")]


def _walls(scene, judged):
    """Effect of walls on verdicts by curves of a wave in the open."""
    walls = reflections.walls(scene)
    if not walls or not any(entry.name.startswith(("lung_", "chest_wall_"))
                            for entry in judged):
        return []
    return [f"The blast comes back from the {' and from the '.join(walls)}: "
            "verdicts on life and lungs are for a single wave and a person far "
            "from walls; several waves may injure more."]


def _grazed_sides(scene):
    """Open sides that disturb the wave from its arrival on, as the runs warn."""
    begin = "grazed side: "
    told = [text[len(begin):] for text in scene.warnings()
            if text.startswith(begin)]
    return [f"{text[:1].upper()}{text[1:]}." for text in told]


def _tables(scene, judged):
    """Where the run and the tables differ by more than their errors: one item,
    which says each difference once."""
    disagrees = verdict.disagrees(scene, judged)
    told = _other_chances(scene, disagrees) + (
        [] if disagrees else _other_load(scene, judged)) + _other_ear(judged)
    parts = ([_other_death(scene, judged)] if disagrees else []) \
        + _other_loads(scene)
    if told:
        parts.append("By the tables, " + "; ".join(told) + ".")
    return [" ".join(parts)] if parts else []


def _other_death(scene, judged):
    """That the tables have another verdict on death by lung injury."""
    death = injury_table.find(judged, "lung_lethality")
    low, high = injury_table.lungs_of_tables(scene, death.name)
    is_biased = any(abs(bias) >= LARGE_BIAS
                    for bias in _known_biases(scene).values())
    return ("The tables have another verdict on the lungs: death with a "
            f"probability of {page.chance(low)} in the open"
            + (f" and {page.chance(high)} before a wall" if high > low else "")
            + f"{injury_table.at_trunk(scene)}, where this run has {death.shown()}"
            + (" by the load on the skin, whose phase ends earlier than that in "
               "the open" if injury_table.lungs_by(scene) == "skin" else "") + ". "
            "Trust neither" + (
                ": finer cells leave the model's difference from the tables "
                "(below) as it is." if is_biased else
                f" before a run with finer cells ({_entry_of_cells(scene)})."))


def _differing_rows(scene):
    """Rows that differ from the tables, with both values and the words for their
    quantity."""
    for row in comparison.rows_of(scene):
        here, known = (files.as_number(row.get(key))
                       for key in ("run", "tables"))
        if row.get("differs") and here is not None and known:
            yield row, here, known, comparison.COMPARED.get(
                row.get("name"), str(row.get("name")))


def _other_loads(scene):
    """Loads that differ from the tables, a sentence or two."""
    rows = [one for one in _differing_rows(scene)
            if one[0].get("name") not in comparison.CHANCES]
    if not rows:
        return []
    biases, differing, biased, unsure = _known_biases(scene), [], [], []
    for row, here, known, words in rows:
        change = here / known - 1.
        least = "at least " if change > 0. \
            and reflections.is_cut_off(scene, row) else ""
        differing.append(f"the {words} is {least}{page.percent(abs(change))} "
                         + ("below" if change < 0. else "above"))
        bias = biases.get(str(row.get("name")).removesuffix("_overpressure"), 0.)
        if bias * change > 0. and abs(bias) >= 0.5 * abs(change):
            biased.append(words)
        if files.as_number(row.get("run_error")) is None:
            unsure.append(f"the {words}")
    # No verdict depends on when the wave comes.
    n_carried = sum(row.get("name") != "arrival" for row, *_ in rows)
    gauge = comparison.gauge(scene)
    is_published = (scene.facts.get("tables") or {}).get("is_published", True)
    return [
        (f"At the {gauge}, " if gauge else "Beside the body, ")
        + page.joined(differing) + " the tables of Kingery and Bulmash, by more "
        "than "
        + ("the errors of both" if not unsure else
           "the error of the tables, while that of the run is unknown"
           if len(unsure) == len(differing) else
           "is known of both errors (that of the run is unknown of "
           + page.joined(unsure) + ")")
        + ("" if len(biased) == len(differing) or is_published else
           " (the TNT equivalence is a ratio of energies, not measured)")
        + ("." if n_carried == 0 else "; loads and verdicts carry "
           + ("these differences." if n_carried > 1 else "this difference."))
        + (f" Most of the difference in {page.joined(biased)} is the known bias "
           "of the model." if biased else "")
        + (" What open sides of the domain send back may be the cause."
           if reflections.open_sides_disturb(scene) else "")]


def _other_chances(scene, is_death_told):
    """Probabilities that differ from those of the tables."""
    return [f"the {words} is {page.chance(known)}, where this run has "
            f"{page.chance(here)}"
            for row, here, known, words in _differing_rows(scene)
            if row.get("name") in comparison.CHANCES
            and page.chance(here) != page.chance(known)
            and not (is_death_told and row.get("name") == "lung_lethality")]


def _other_load(scene, judged):
    """That a load on the lung by the tables is beyond another threshold."""
    other = verdict.other_lungs(scene, judged)
    if other is None:
        return []
    load, known, place = other
    limit, meaning = load.thresholds[0]
    beside = reflections.beside_tables(scene)
    sides = ("above", "below") if load.exceeded(known) else ("below", "above")
    return [f"the load on the lung{injury_table.at_trunk(scene)} is "
            f"{page.number(known)}{place}, {sides[0]} the {meaning} of "
            f"{load.shown_limit(limit)}, where this run has {load.shown()}, "
            f"{sides[1]} it" + (f"; the tables are{beside}" if beside else "")]


def _other_ear(judged):
    """That the tables have another verdict on an eardrum."""
    ear = verdict.other_ears(judged)
    if ear is None:
        return []
    low, high = map(ear.shown, ear.tables)
    return [f"the {ear.short_title()} is {low} in the open"
            + (f" and {high} before a wall" if high != low else "")
            + (ear.tables_place and f" {ear.tables_place}")
            + f", where this run has {ear.shown()}"]


def _entry_of_cells(scene):
    """The entry that makes cells finer."""
    return next((row["entry"] for row in scene.list_of("plan")
                 if row.get("item") == "resolution" and row.get("entry")),
                "Scene/Accuracy")


def _verdicts(scene, judged):
    """Which verdicts the numerical error could change."""
    having = [entry for entry in judged if entry.has_verdict]
    known = [entry for entry in having if entry.is_certain() is not None]
    unknown = [entry for entry in having if entry.is_certain() is None]
    why = error_estimate.why_unknown(scene, unknown)
    if not known:
        return ["The numerical error of these verdicts is unknown: " + why
                + "."] if judged else []
    open_ones = [entry for entry in known if not entry.is_certain()]
    return ["Numerical error could change "
            + (page.count_in_words(len(open_ones)) if open_ones else "none")
            + f" of {page.counted(len(having), 'verdict')}"
            + (": " + page.joined(entry.short_title() for entry in open_ones)
               if open_ones else "")
            + ("; it is unknown of "
               + page.joined(entry.short_title() for entry in unknown)
               + f": {why}" if unknown else "") + "."]


def _unused_thresholds(scene, judged):
    """Thresholds of the user for what the table of injuries does not have, as
    of a side that is turned away from the charge."""
    used = {"ear_rupture" if entry.name.startswith("ear_rupture_")
            else entry.name for entry in judged}
    unused = [name for name, known in of_run(scene).items()
              if known.is_own and name not in used]
    return ["Thresholds of the user's own judge nothing, since the table of "
            f"injuries lacks {page.joined(unused)}."] if unused else []


def _afterburn(scene):
    """The energy of afterburn that is assumed, and its largest effects."""
    rows = {row.get("item"): row for row in
            scene.list_of("plan") + scene.list_of("audit")}
    if "afterburn" not in rows:
        return []
    known = [_fraction(rows.get(f"afterburn_{name}"))
             for name in ("peak", "impulse")]
    if known == [0., 0.]:
        return ["The run has no afterburn: the explosive's own oxygen burns "
                "it."]
    decision = rows["afterburn"].get("decision") or ""
    if decision.startswith("left out by the values of "):
        return [f"Afterburn is {decision}."]
    energy = re.match(r"[\d.e+-]+(?= of at most ([\d.e+-]+) MJ/kg"
                      r"( by [^,]+)?)", decision)
    effects = page.joined(
        f"the incident {word} by at most {page.percent(rise)}"
        for rise, word in zip(known, ("peak", "impulse")) if rise is not None)
    text = "The run leaves out afterburn" if energy is None else (
        f"The run assumes {energy[0]} MJ/kg of afterburn "
        f"(at most {energy[1]} MJ/kg is possible{energy[2] or ''})")
    if effects:
        text += f", which {'would raise' if energy is None else 'raises'} " \
            + effects
    return [text + "."]


def _model_bias(scene):
    """Contribution of the model itself to the differences from the tables."""
    parts = [f"{'an' if name == 'impulse' else 'a'} {name} "
             f"{page.given(round(abs(100. * bias)), '%')} "
             f"{'below' if bias < 0. else 'above'}"
             for name, bias in _known_biases(scene).items()]
    if parts:
        return [f"In fine cells the model gives this explosive "
                f"{page.joined(parts)} the tables in free air at this "
                "distance."]
    return [f"How far the model differs from the tables in fine cells is "
            f"unknown: {row['decision']}." for row in scene.list_of("plan")
            if row.get("item") == "model_bias_peak"]


def _known_biases(scene):
    """Relative differences of the model from the tables, by quantity."""
    rows = {row.get("item"): row for row in scene.list_of("plan")}
    biases = {name: _fraction(rows.get(f"model_bias_{name}"))
              for name in ("peak", "impulse", "duration")}
    return {name: bias for name, bias in biases.items() if bias is not None}


def _fraction(row):
    """The estimate of a row of the plan, or None."""
    try:
        return float(row.get("estimate"))
    except (AttributeError, TypeError, ValueError):
        return None


def _loads(scene):
    """A large difference of the impulse on the elements to the recorded one, and
    of what pushes from opposite sides leave of it."""
    found, left = load_impulses.along(scene), load_impulses.pushes_left(scene)
    if found is None:
        return []
    recorded, mapped = found
    lines = []
    if abs(mapped / recorded - 1.) > LARGE_LOAD_DIFFERENCE:
        lines.append(
            f"The elements get {page.percent(mapped / recorded, 4)} of the "
            "impulse that was recorded on the skin"
            + ("." if left is None else ", all facets taken as magnitudes."))
    if left is not None \
            and load_impulses.difference_of_motion(scene) > LARGE_PUSH_DIFFERENCE:
        lines.append(
            "Pushes from opposite sides cancel: when what is left of those on "
            f"the skin is largest, {page.quantity(left[0], 'N s')}, its elements "
            f"received {page.quantity(left[1], 'N s')}.")
    return lines


def _ground(scene):
    """The ground that biomechanics leaves out below a body on it."""
    return ["Biomechanics leaves out the ground that the body is on: the body "
            "may move into it (Biomechanics/Ground/Active)."] if any(
                row.get("item") == "ground_of_body"
                for row in scene.list_of("plan")) else []


def _words(row):
    """An item of the audit for readers who do not know the plan, with the place
    where it was found."""
    words, place = WORDS.get(row.get("item")), row["quantity"].partition(
        " open side at ")[2]
    return (words + (f" at {place}" if place else "")) if words else \
        row["quantity"]


def _limits(scene):
    """Items of the audit beyond their limits."""
    def known(row):
        if row.get("found") != "unknown":
            return row.get("found")
        return f"estimated at {row.get('estimate')}" + (
            "" if "not measured" in row["quantity"] else ", not measured")

    failed = [f"{_words(row)} ({known(row)}; limit: {row.get('limit')})"
              for row in scene.list_of("audit")
              if row.get("holds") is False and row.get("limit")
              and not reflections.is_elsewhere(scene, row)]
    return ["Beyond " + ("their limits" if len(failed) > 1 else "its limit")
            + ": " + "; ".join(failed) + "."] if failed else []
