# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Beginning of a report: the verdict, the answer of the tables next to it,
what could change it, and the warnings of the runs."""

import math
import re

import numpy as np

from plot.analysis import person, tissue_places
from plot.readers import files
from plot.readers.scene import COARSER
from plot.report import (error_estimate, injury_table, least_phases,
                         load_impulses, page, reflections, unfinished, verdict)
from plot.report.energy_audit import EnergyAudit
from plot.report.injury_thresholds import (KNOWN, SEA_LEVEL,
                                           median_lethal_load, of_run,
                                           probability)

LARGE_LOAD_DIFFERENCE = 0.02  # of impulses on skin and elements
LARGE_PUSH_DIFFERENCE = 0.1  # of small differences of large impulses
# Words for items of the audit, for readers who do not know the plan.
WORDS = {"reflection": "arrival of a wave reflected by an open side of the "
         "domain"}
# Quantities of the comparison with the tables.
COMPARED = {"peak_overpressure": "peak overpressure",
            "impulse": "impulse", "duration": "duration",
            "arrival": "arrival",
            "reflected_overpressure": "reflected peak overpressure",
            "reflected_impulse": "reflected impulse", "lung_exposure": KNOWN["lung_exposure_air"][0],
            "lung_lethality": KNOWN["lung_lethality"][0],
            "eardrum_rupture": "rupture probability of an eardrum in the open"}
TITLES_IN_FILE = {
    f"{key}{suffix}": f"{before}{title}"
    for key, title in (("run", "this run"), ("tables", "tables"))
    for suffix, before in (("", ""), ("_error", "relative error of "),
                           ("_least", "least of "), ("_largest", "largest of "))
} | {"before_a_wall": "tables before a wall"}
PROBE = least_phases.PROBE  # where the run is compared with the tables
EAR = "nearer ear"
LUNGS = ("lung_exposure", "lung_lethality")
PRODUCTS = 0.1  # mass fraction from which they are told
# Loads by which probabilities follow.
LOADS = {"lung_lethality": "lung_exposure", "eardrum_rupture": "peak_overpressure"}
CHANCES = tuple(LOADS)
BOUNDS = "for probabilities the bounds that follow from those of their load"
SIMPLE = 0.75  # least part of the impulse in the first wave of a simple one
AHEAD = 0.85  # of the arrival by the tables
LARGE_BIAS = 0.1  # of the model, which may decide a verdict
LEVEL = 0.1  # m, difference in height that the wave does not notice
MOST_LINES = 3  # of what could change the verdict, in the text version


class Lead:
    """All that a report begins with."""

    def __init__(self, scene, judged):
        self.verdicts = verdict.verdicts(scene, judged)
        self.sentence = _loads_alone(scene) if not self.verdicts and \
            scene.asks_for_loads() else verdict.sentence(scene, self.verdicts)
        self.opening = _opening(scene)
        self.reservations = _certainty(scene, judged)
        self.warnings = scene.warnings()
        self.rows = _completed_rows(scene, judged)
        self.compared, self.gauge = _compared(scene, judged), _gauge(scene)
        self.has_probe = bool(scene.list_of("table_comparison")) \
            and not self.gauge
        self.charge = f"a bare charge {reflections.place_of_burst(scene)}" \
            + _equivalence(scene)
        mass = files.as_number((scene.facts.get("tables") or {}).get(
            "body_mass"))
        self.lungs = "" if mass is None or not any(
            row.get("name") in LUNGS for row in self.rows) else (
                f"; lungs of a person of {page.given(float(f'{mass:.3g}'), 'kg')}"
                + (_at_trunk(scene) and f",{_at_trunk(scene)}"))
        self.explaining = reflections.explaining(scene)
        self.trunk = "; loads of skin, as at the trunk, are not compared with " \
            "those of air" if any(row.get("place") == "trunk"
                                  for row in self.rows) else ""
        self.reflections = reflections.note(scene) \
            + reflections.note_on_people(scene)
        self.heights = _heights(scene)
        probe = scene.facts.get("probe_beside_body")
        self.distance = _distance(scene)
        self.where = self.distance + (
            f", {_height(probe)} above the ground" if probe else "")
        left_out = ([] if reflections.is_surface_burst(scene) else ["ground"]) \
            + ["body"] + (["walls"] if reflections.walls(scene) else [])
        self.left_out = ("" if len(left_out) > 1 else "the ") \
            + page.joined(left_out)
        self.file = _comparison_file(self.rows)

    def lines(self):
        """The text version, a few lines."""
        more = len(self.reservations) - MOST_LINES
        return [self.sentence, *self.reservations[:MOST_LINES]] + (
            [f"The report has {page.counted(more, 'more reservation')}."]
            if more > 0 else []) + (
            [f"Warnings of the runs: {len(self.warnings)}, listed in the "
             "report."] if self.warnings else [])

    def answer(self):
        """The box with the verdict."""
        return page.tag("div", page.tag("p", self.sentence, kind="verdict"),
                        page.paragraph(self.opening), kind="answer")

    def tables(self):
        """This run next to the tables of Kingery and Bulmash."""
        if not self.compared:
            return page.missing("an answer of the tables of Kingery and "
                                "Bulmash, which do not cover this charge and "
                                "distance")
        caption = ("Tables: Kingery and Bulmash for "
                   f"{self.charge}, without {self.left_out}{self.lungs}. ")
        if not self.has_probe:
            return page.table(
                (f"in the open, as far as the nearest skin{self.distance}",
                 *(("this run",) if self.gauge else ()), "tables"),
                self.compared,
                caption + "No probe beside the body has the wave of this run "
                "at that distance" + (
                    f"; at the {self.gauge} its load on the skin stands beside "
                    "that on an endless wall, whose impulse is larger. ±: errors "
                    "of the numerics, where they are known, and of the tables, "
                    f"{BOUNDS}; what differs by more is marked." if self.gauge else "."),
                numbers=(1, 2) if self.gauge else (1,), data=self.file)
        return page.table(
            (f"beside the body{self.where}, in the open", "this run", "tables"),
            self.compared, caption + "±: errors of the numerics, where they are "
            f"known, and of the tables, {BOUNDS}; what differs by more is "
            "marked, unless "
            f"{self.explaining} may explain it"
            f"{self.trunk}. {self.reflections}{self.heights}",
            numbers=(1, 2), data=self.file)

    def doubts(self):
        """Reservations that could change the verdict, and the warnings."""
        parts = []
        if self.reservations:
            parts += [page.tag("h3", "What could change the verdict"),
                      page.bullets(self.reservations)]
        told = {is_coarser: [
            f"{text} ({page.joined(stages)})" for text, stages
            in self.warnings.items()
            if stages[0].startswith(COARSER) == is_coarser]
            for is_coarser in (False, True)}
        if told[False]:
            parts += [page.tag("h3", "Warnings of the runs"),
                      page.bullets(told[False])]
        if told[True]:
            parts.append(page.folded_table(
                "Warnings of the coarser run alone, which estimates the error",
                page.bullets(told[True])))
        return page.tag("div", *parts, kind="doubts") if parts else ""


def _distance(scene):
    """How far from the charge the tables are asked, unless that is said."""
    distance = scene.fact("distance")
    return "" if distance is None else \
        f", {page.quantity(distance, 'm')} from the charge"


def _height(place):
    return page.given(round(place[2], 2), "m")


def _heights(scene):
    """Heights of the probe next to the body and of the parts that its wave is
    compared with, as a sentence; "" where they are level."""
    probe, known = scene.facts.get("probe_beside_body"), scene.loads()
    if not probe or known is None:
        return ""
    places, charge = known.places(), scene.charge_place()
    ears = sorted((name for name in places if name.endswith(" ear")),
                  key=lambda name: charge is not None
                  and math.dist(places[name], charge))
    others = [f"the {name} {_height(places[name])}"
              for name in ("chest", *ears[:1]) if name in places
              and abs(places[name][2] - probe[2]) > LEVEL]
    return (f" The probe is {_height(probe)} above the ground, "
            f"{page.joined(others)}.") if others else ""


def _opening(scene):
    mass, place = scene.charge_mass(), scene.charge_place()
    body = f"{person.place_of_charge(scene)} {person.words(scene)}"
    charge = "The charge" if mass is None else (
        f"{page.given(mass, 'kg')} of {scene.explosive_name()}")
    distance, height = scene.fact("distance"), scene.fact("height")
    where = body if distance is None else \
        f"{page.given(distance, 'm')} {body}"
    azimuth = person.azimuth_of_charge(scene)
    where += f", {azimuth}" if azimuth else ""
    if height is None and place is not None:
        height = float(place[2])
    if height is not None:
        charge += f", {page.given(height, 'm')} above the ground,"
    walls = reflections.walls(scene)
    return f"{charge} detonates {where}." + (
        f" The domain has a {' and a '.join(walls)}." if walls else "")


def _equivalence(scene):
    """Equivalence of the charge to TNT, in words."""
    known = scene.facts.get("tables") or {}
    pressure, impulse = (files.as_number(known.get(f"equivalence_of_{name}"))
                         for name in ("pressure", "impulse"))
    if None in (pressure, impulse) or pressure == impulse == 1.:
        return ""
    return (f" (as {page.number(pressure)} times the mass of TNT"
            + ("" if pressure == impulse else
               f" for pressures, {page.number(impulse)} for impulses") + ": "
            + (known.get("source") or "unknown source")
            + ("" if known.get("is_published") else ", not measured") + ")")


def _completed_rows(scene, judged):
    """Rows with the tables before a wall and with bounds of probabilities."""
    rows = []
    for row in _rows(scene):
        name = str(row.get("name"))
        if name in (*CHANCES, *LUNGS):
            row = {"before_a_wall": scene.table_answer(name)[1], **row}
        if name == "lung_exposure":
            load = injury_table.find(judged, injury_table.SKIN_NAMES[
                name, injury_table.loaded_side(scene)] if row.get("place") ==
                                     "trunk" else "lung_exposure_air")
            row.setdefault("run_error", load and load.error)
            if load and load.least_part != 1.:
                row["run_least"], row["run_largest"] = load.sure_bounds()
        if name in CHANCES and row.get("place") != EAR:
            for key, ends in _bounds_of_chances(scene, judged, name).items():
                row[f"{key}_least"], row[f"{key}_largest"] = ends
        rows.append(row)
    return rows


def _compared(scene, judged=()):
    """Rows of this run next to the tables; of the tables alone where this run
    has no probe as far from the charge as the body, nor a gauge there."""
    rows, compared = [], scene.list_of("table_comparison")
    least = least_phases.at_probe(scene)
    for row in _completed_rows(scene, judged):
        name, unit = str(row.get("name")), row.get("unit") or "-"
        is_chance = name in CHANCES
        columns = ("run", "tables") if compared else ("tables",)
        cells = [_with_error(row.get(key), unit, is_chance,
                             row.get(f"{key}_error")) for key in columns]
        if compared and reflections.is_cut_off(scene, row):
            cells[0] = "≥ " + cells[0]
        if compared and least is not None and name == "duration":
            cells[0] += f", least {page.milliseconds(least)}"
        if compared and name == "lung_exposure" and row.get("run_least"):
            cells[0] += ", least " + page.number(row["run_least"])
        notes = {key: [page.interval(row[f"{key}_least"],
                                     row[f"{key}_largest"])]
                 for key in columns if is_chance and f"{key}_least" in row}
        wall = row.get("before_a_wall")
        if wall is not None:
            told = page.chance if is_chance else page.number
            notes.setdefault("tables", []).append(f"{told(wall)} before a wall")
        for k, (key, cell) in enumerate(zip(columns, cells)):
            others = [text for text in notes.get(key, []) if text != cell]
            cells[k] += f" ({'; '.join(others)})" if others else ""
        if row.get("differs"):
            cells[-1] = page.tag("span", cells[-1], kind="mid")
        rows.append((_title(row), *cells))
    return rows


def _bounds_of_chances(scene, judged, name):
    """Least and largest value of a probability by the errors of its load, of the
    "run" and the "tables"; of what is known."""
    death, peak = injury_table.find(judged, name), "probe_1_peak_overpressure"
    bounds = {"run": (death and death.bounds()) if name in LUNGS else _ends(
        name, scene.blast.found("results", peak),
        error_estimate.of_result(scene, peak))}
    for row in _rows(scene):
        if row.get("name") == LOADS[name]:
            bounds["tables"] = _ends(name, *(files.as_number(
                row.get(key)) for key in ("tables", "tables_error")))
    return {key: found for key, found in bounds.items() if found}


def _ends(curve, load, error):
    """Probabilities by both ends of a load; None if its error is unknown."""
    return None if None in (load, error) else tuple(
        probability(curve, load * (1. + sign * error)) for sign in (-1., 1.))


def _title(row):
    """Quantity of a row, and its place unless that is the one of the table."""
    name, place = str(row.get("name")), row.get("place") or PROBE
    if name == "lung_exposure" and place != PROBE:
        return f"load over the 50\u00a0% lethality load at the {place}"
    if place == EAR:
        return "rupture probability of an eardrum at the nearer ear (this run: " \
            "by the load on its skin)"
    return COMPARED.get(name, name.replace("_", " ")) \
        + ("" if place == PROBE else f" at the {place}")


def _comparison_file(rows):
    """The same with all digits."""
    return (("quantity", "unit", *TITLES_IN_FILE.values(), "differs"),
            [(_title(row), row.get("unit"),
              *("" if value is None else page.Rounded("", value) for value in (
                  files.as_number(row.get(key)) for key in TITLES_IN_FILE)),
              "yes" if row.get("differs") else "no") for row in rows])


def _rows(scene):
    """Rows of table_comparison, with lungs at the trunk and eardrums at the
    nearer ear where these are farther from the charge; where no probe has the
    wave, after the answer of the tables."""
    rows = scene.list_of("table_comparison")
    if not rows or _gauge(scene):
        rows = _answer_rows(scene) + rows
    elif injury_table.is_trunk_far(scene):
        rows = [row for row in rows
                if not str(row.get("name")).startswith("lung_")] \
            + _trunk_rows(scene)
    return [*rows, *_ear_rows(scene)]


def _ear_rows(scene):
    """A row as those of table_comparison, of the eardrum that is likelier to
    rupture and of the tables at the nearer ear, where that is farther from the
    charge than the nearest skin."""
    there = ((scene.facts.get("tables") or {}).get("ears") or {}).get("distance")
    if there is None or there <= injury_table.FARTHER_TRUNK * (
            scene.fact("distance") or there):
        return []
    run = max((found.value for (name, _), found in scene.gauge_injury().items()
               if name == "eardrum_rupture"), default=None)
    known, wall = scene.table_answer("eardrum_rupture", "ears")
    return [] if None in (run, known) else [
        {"name": "eardrum_rupture", "place": EAR, "unit": "-", "run": run,
         "tables": known, "before_a_wall": wall}]


def _trunk_rows(scene):
    """Rows as those of table_comparison, of the lungs by the load on the skin of
    the trunk and by the tables at its distance."""
    load = scene.gauge_injury().get(
        ("lung_exposure", injury_table.loaded_side(scene)))
    run = None if load is None or load.is_cut else load.value
    rows = []
    for name, value in (("lung_exposure", run), (
            "lung_lethality", None if run is None else
            probability("lung_lethality", run))):
        known, wall = scene.table_answer(name, "trunk")
        rows.append({"name": name, "place": "trunk", "unit": "-", "run": value,
                     "tables": known, "before_a_wall": wall})
    return [row for row in rows if row["tables"] is not None]


def _gauge(scene):
    """The gauge whose load is compared with the tables; "" if a probe's wave
    is."""
    places = {row.get("place") or PROBE
              for row in scene.list_of("table_comparison")}
    return "".join(places - {PROBE})


def _answer_rows(scene):
    """Rows as those of table_comparison, with the answer of the tables; lungs at
    the trunk where its skin tells of them."""
    answer = (scene.facts.get("tables") or {}).get("answer") or {}
    in_the_open = answer.get("in_the_open") or {}
    known = {"peak_overpressure": (in_the_open.get("overpressure"), "Pa"),
             "impulse": (answer.get("impulse"), "Pa s"),
             "duration": (answer.get("duration"), "s"),
             "arrival": (answer.get("arrival"), "s")}
    rows = [{"name": name, "tables": value, "unit": unit}
            for name, (value, unit) in known.items()]
    place = "trunk" if injury_table.lungs_by(scene) == "skin" else PROBE
    for name in LUNGS:
        value, wall = scene.table_answer(name) if place == PROBE else \
            scene.table_answer(name, "trunk")
        rows.append({"name": name, "place": place, "tables": value,
                     "before_a_wall": wall, "unit": "-"})
    rows.append({"name": "eardrum_rupture", "unit": "-",
                 "tables": in_the_open.get("eardrum_rupture")})
    return [row for row in rows if row["tables"] is not None]


def _with_error(value, unit, is_chance, error):
    value = files.as_number(value)
    if value is None:
        return "–"
    if is_chance:
        return page.chance(value)
    return page.quantity(value, unit) + (
        "" if error is None else f" {page.error(error)}")


def _loads_alone(scene):
    """The answer to a question about loads alone."""
    known = scene.loads()
    if known is None:
        return "The loads on the skin are unknown: loads.h5 is missing."
    if not known.arrived().any():
        return unfinished.NOT_REACHED
    peak, impulse = (error_estimate.of_skin(scene, name)[1:]
                     for name in ("peak", "impulse"))
    unsure = "; numerical error unknown" if None in (*peak, *impulse) else ""
    least = "at least " if known.is_cut_off("impulse") else ""
    return ("The overpressure on the skin reaches "
            f"{_with_error(peak[0], 'Pa', False, peak[1])}, its impulse {least}"
            f"{_with_error(impulse[0], 'Pa s', False, impulse[1])}{unsure}.")


def _certainty(scene, judged):
    """How sure the answer is, a sentence each."""
    parts = unfinished.reservations(scene)
    if injury_table.lungs_by(scene) == "skin":
        why = injury_table.why_by_the_skin(scene)
        parts.append(f"{why[:1].upper()}{why[1:]}: death by lung injury follows "
                     "from the reflected load on the skin.")
    parts += _walls(scene, judged) + _grazed_sides(scene)
    parts += _products(scene) + _runs_ahead(scene)
    parts += _not_simple(scene, judged) + _long_load(scene, judged)
    parts += _askew(scene, judged)
    parts += _tables(scene, judged) + _verdicts(scene, judged)
    parts += injury_table.cut_off(judged, "Scene/End time",
                                  scene.fact("end_time"))
    parts += tissue_places.holes(scene)
    parts += _afterburn(scene) + _model_bias(scene)
    parts += _loads(scene) + EnergyAudit(scene).reservations() + _limits(scene)
    parts += _ground(scene)
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
        f"{_height(known.centroids[first])} above the ground, where the tables "
        f"have {page.milliseconds(expected['arrival'])} for the nearest skin; "
        "loads on feet and legs are of this jet."]


def _not_simple(scene, judged):
    """That lungs are judged by a wave for which their measure is not made."""
    fraction = scene.air_injury().get(("first_phase_fraction", PROBE))
    return [] if fraction is None or fraction.value > SIMPLE or injury_table.find(
        judged, "lung_exposure_air") is None else [
            "The wave beside the body is not simple: its first wave has "
            f"{page.percent(fraction.value)} of the impulse. The load on the lung "
            "is made for simple waves, and taken of both waves together."]


def _long_load(scene, judged):
    """That lungs are judged by a longer load than the first positive phase."""
    load = injury_table.find(judged, "lung_exposure_air")
    longer = scene.air_injury().get(("lung_load_duration", PROBE))
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
    parts = []
    death = injury_table.find(judged, "lung_lethality")
    disagrees = verdict.disagrees(scene, judged)
    if disagrees:
        low, high = injury_table.lungs_of_tables(scene, death.name)
        parts.append(
            "The tables have another verdict on the lungs: death with a "
            f"probability of {page.chance(low)} in the open"
            + (f" and {page.chance(high)} before a wall" if high > low else "")
            + f"{_at_trunk(scene)}, where this run has {death.shown()}. "
            + ("Trust neither: finer cells leave the model's difference from "
               "the tables (below) as it is."
               if any(abs(bias) >= LARGE_BIAS
                      for bias in _known_biases(scene).values()) else
               "Trust neither before a run with finer cells "
               f"({_entry_of_cells(scene)})."))
    differing, unsure, chances, n_carried = [], [], [], 0
    biases, biased = _known_biases(scene), []
    for row in _rows(scene):
        here, known = (files.as_number(row.get(key))
                       for key in ("run", "tables"))
        if not row.get("differs") or here is None or not known:
            continue
        words = COMPARED.get(row.get("name"), str(row.get("name")))
        if row.get("name") in CHANCES:
            told = disagrees and row.get("name") == "lung_lethality"
            if page.chance(here) != page.chance(known) and not told:
                chances.append(f"the {words} is {page.chance(known)}, where "
                               f"this run has {page.chance(here)}")
        else:
            change = here / known - 1.
            # No verdict depends on when the wave comes.
            n_carried += row.get("name") != "arrival"
            least = "at least " if change > 0. \
                and reflections.is_cut_off(scene, row) else ""
            differing.append(f"the {words} is {least}"
                             f"{page.percent(abs(change))} "
                             + ("below" if change < 0. else "above"))
            bias = biases.get(str(row.get("name")).removesuffix(
                "_overpressure"), 0.)
            if bias * change > 0. and abs(bias) >= 0.5 * abs(change):
                biased.append(words)
            if files.as_number(row.get("run_error")) is None:
                unsure.append(f"the {words}")
    if differing:
        parts.append(
            (f"At the {_gauge(scene)}, " if _gauge(scene) else
             "Beside the body, ") + page.joined(differing) + " the tables of "
            "Kingery and Bulmash, by more than "
            + ("the errors of both" if not unsure else
               "the error of the tables, while that of the run is unknown"
               if len(unsure) == len(differing) else
               "is known of both errors (that of the run is unknown of "
               + page.joined(unsure) + ")")
            + ("" if len(biased) == len(differing)
               or (scene.facts.get("tables") or {}).get("is_published", True)
               else " (the TNT equivalence is a ratio of energies, not "
               "measured)")
            + ("." if n_carried == 0 else "; loads and verdicts carry "
               + ("these differences." if n_carried > 1
                  else "this difference."))
            + (f" Most of the difference in {page.joined(biased)} is the known "
               "bias of the model." if biased else "")
            + (" What open sides of the domain send back may be the cause."
               if reflections.open_sides_disturb(scene) else ""))
    other = verdict.other_lungs(scene, judged)
    if other is not None and not disagrees:
        load, known, place = other
        limit, meaning = load.thresholds[0]
        beside = reflections.beside_tables(scene)
        sides = ("above", "below") if load.exceeded(known) else \
            ("below", "above")
        chances.append(
            f"the load on the lung{_at_trunk(scene)} is {page.number(known)}"
            f"{place}, {sides[0]} the {meaning} of {load.shown_limit(limit)}, where this "
            f"run has {load.shown()}, {sides[1]} it"
            + (f"; the tables are{beside}" if beside else ""))
    ear = verdict.other_ears(judged)
    if ear is not None:
        low, high = map(ear.shown, ear.tables)
        chances.append(f"the {ear.short_title()} is {low} in the open"
                       + (f" and {high} before a wall" if high != low else "")
                       + (ear.tables_place and f" {ear.tables_place}")
                       + f", where this run has {ear.shown()}")
    if chances:
        parts.append("By the tables, " + "; ".join(chances) + ".")
    return [" ".join(parts)] if parts else []


def _entry_of_cells(scene):
    """The entry that makes cells finer."""
    return next((row["entry"] for row in scene.list_of("plan")
                 if row.get("item") == "resolution" and row.get("entry")),
                "Scene/Accuracy")


def _at_trunk(scene):
    """Where the tables are asked for lungs, unless that is at the probe."""
    return "" if injury_table.lungs_by(scene) != "skin" else " " + (
        injury_table.at_trunk(scene) or "at the distance of the trunk")


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
