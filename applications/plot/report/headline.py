# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Beginning of a report: the verdict, the answer of the tables next to it,
what could change it, and the warnings of the runs."""

import math

from plot.analysis import person
from plot.readers import files
from plot.readers.scene import COARSER
from plot.report import (comparison, error_estimate, injury_table, page, reflections,
                         reservations, unfinished, verdict)

BOUNDS = "for probabilities the bounds that follow from those of their load"
LEVEL = 0.1  # m, difference in height that the wave does not notice
MOST_LINES = 3  # of what could change the verdict, in the text version


class Lead:
    """All that a report begins with."""

    def __init__(self, scene, judged):
        self.verdicts = verdict.verdicts(scene, judged)
        self.sentence = _loads_alone(scene) if not self.verdicts and \
            scene.asks_for_loads() else verdict.sentence(scene, self.verdicts)
        self.opening = _opening(scene)
        self.reservations = reservations.of(scene, judged)
        self.warnings = scene.warnings()
        self.rows = comparison.completed_rows(scene, judged)
        self.compared = comparison.compared(scene, judged)
        self.gauge = comparison.gauge(scene)
        self.has_probe = bool(scene.list_of("table_comparison")) \
            and not self.gauge
        self.charge = f"a bare charge {reflections.place_of_burst(scene)}" \
            + _equivalence(scene)
        mass = files.as_number((scene.facts.get("tables") or {}).get(
            "body_mass"))
        self.lungs = "" if mass is None or not any(
            row.get("name") in comparison.LUNGS for row in self.rows) else (
                f"; lungs of a person of {page.given(float(f'{mass:.3g}'), 'kg')}"
                + (injury_table.at_trunk(scene) and f",{injury_table.at_trunk(scene)}"))
        self.explaining = reflections.explaining(scene)
        self.trunk = "; loads of skin, as at the trunk, are not compared with " \
            "those of air" if any(row.get("place") == "trunk"
                                  for row in self.rows) else ""
        self.reflections = reflections.note(scene) \
            + reflections.note_on_people(scene)
        self.heights = _heights(scene)
        probe = scene.facts.get("probe_beside_body")
        distance = scene.fact("distance")
        self.distance = "" if distance is None else \
            f", {page.quantity(distance, 'm')} from the charge"
        self.where = self.distance + (
            f", {page.height(probe)} above the ground" if probe else "")
        left_out = ([] if reflections.is_surface_burst(scene) else ["ground"]) \
            + ["body"] + (["walls"] if reflections.walls(scene) else [])
        self.left_out = ("" if len(left_out) > 1 else "the ") \
            + page.joined(left_out)
        self.file = comparison.file_of(self.rows)

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
                    f"{BOUNDS}; what differs by more is marked."
                    if self.gauge else "."),
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
    others = [f"the {name} {page.height(places[name])}"
              for name in ("chest", *ears[:1]) if name in places
              and abs(places[name][2] - probe[2]) > LEVEL]
    return (f" The probe is {page.height(probe)} above the ground, "
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
    peak, impulse = (comparison.with_error(one[0], unit, False, one[1])
                     for one, unit in ((peak, "Pa"), (impulse, "Pa s")))
    least = "at least " if known.is_cut_off("impulse") else ""
    return (f"The overpressure on the skin reaches {peak}, its impulse "
            f"{least}{impulse}{unsure}.")
