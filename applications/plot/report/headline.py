# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The answer of a report in a few plain sentences, and how certain it is."""

import math
import re

from plot.analysis import signals
from plot.report import injury_table, load_impulses, page, reflections

MERGING = 40.  # degrees of incidence, from which reflections may merge
LARGE_DIFFERENCE = 0.1  # to Kingery and Bulmash
LARGE_LOAD_DIFFERENCE = 0.02  # of impulses on skin and elements
LONG_ENOUGH = 0.01  # s, until the largest strains that a front causes
# Of items of the audit, for readers who do not know the plan.
WORDS = {"reflection": "arrival of a wave reflected by an open side of the "
         "domain",
         "resolution": "number of cells in the positive phase at the body",
         "rigid_body": "displacement of the body over a cell of the gas"}
# Usual limits of the audit of a body's energy; hourglass energy is told from
# the smaller one on.
LARGEST_RESIDUAL, LARGEST_HOURGLASS, NOTED_HOURGLASS = 0.01, 0.1, 0.05


def answer(scene, judged):
    """What this blast does to this person, and how sure that is."""
    sentences = [_opening(scene)]
    sentences += [words for words in (_lung(judged), _ears(judged),
                                      _brain(judged)) if words]
    if len(sentences) == 1:
        sentences.append("The injury is unknown: the scene has neither gauges "
                         "at chest and ears nor measures of injury.")
    certainty = _certainty(scene, judged)
    return page.tag("div", page.paragraph(" ".join(sentences)),
                    *([page.bullets(certainty)] if certainty else []),
                    kind="answer")


def _opening(scene):
    mass, place = scene.charge_mass(), scene.charge_place()
    body = {None: "a standing man", "phantom": "a standing man",
            "surface": "a person given by a surface",
            "image": "a body from medical images"}.get(
                scene.facts.get("body"), "a body")
    charge = "The charge" if mass is None else (
        f"{page.quantity(mass, 'kg')} of {scene.explosive_name()}")
    distance, height = scene.fact("distance"), scene.fact("height")
    where = f"in front of {body}" if distance is None else \
        f"{page.number(distance)} m from {body}"
    if height is None and place is not None:
        height = float(place[2])
    if height is not None:
        where += f", {page.number(height)} m above the ground"
    return f"{charge} detonates {where}."


def _lung(judged):
    """The chest wall's velocity, as the mean over the trunk and at the
    side with the larger load, and the lung's exposure by Bowen."""
    wall, lung = _wall(judged), _exposure(judged)
    return " ".join(words for words in (wall, lung) if words)


def _wall(judged):
    mean = injury_table.find(judged, "chest_wall_mean")
    for name, where in (("chest_wall_front", "in front"),
                        ("chest_wall_back", "at the back"),
                        ("injury_chest_wall_velocity", "in front")):
        side = injury_table.find(judged, name)
        if side is not None:
            break
    else:
        return ""
    if mean is None:
        return (f"The chest wall velocity {where} is "
                f"{page.quantity(side.value, 'm/s')}; levels of injury are of "
                "the mean over the sides alone.")
    return (f"The expected lung injury is {mean.meaning() or 'none'} by the "
            "mean chest wall velocity over the trunk, "
            f"{page.quantity(mean.value, 'm/s')}; {where} it is "
            f"{page.quantity(side.value, 'm/s')}.")


def _exposure(judged):
    """Bowen's exposure in the free field, or that of the skin."""
    text = ""
    air = injury_table.find(judged, "lung_exposure_air")
    death = injury_table.find(judged, "lung_lethality")
    if air is not None and death is not None:
        text = (f"The wave beside the body is {page.number(air.value, 2)} of "
                "the 50 % lethality load of the lung, by which "
                f"{_in_words(death.value)} of standing persons die. ")
    for name, side in (("lung_exposure_back", "back"),
                       ("lung_exposure", "chest"),
                       ("injury_lung_exposure", "chest")):
        skin = injury_table.find(judged, name)
        if skin is not None:
            return (f"{text}The {side} load is {page.number(skin.value, 2)} "
                    "of " + ("it." if text else "the 50 % lethality load."))
    return text.strip()


def _in_words(part):
    """A probability, without digits that mean nothing."""
    if part > 0.99:
        return "more than 99 %"
    return page.percent(part) if part >= 0.001 else "less than 0.1 %"


def _ears(judged):
    ears = [entry for entry in judged if entry.name.startswith("ear_")]
    if not ears:
        return ""
    if len(ears) == 1:
        return "Unprotected eardrums rupture with a probability of " \
            f"{_in_words(ears[0].value)}."
    left, right = (
        (entry.name[len("ear_rupture_"):] + "drum", _in_words(entry.value))
        for entry in ears[:2])
    return f"Unprotected, the {left[0]} ruptures with a probability of " \
        f"{left[1]}, the {right[0]} with one of {right[1]}."


def _brain(judged):
    high = injury_table.find(judged, "injury_intracranial_pressure_peak")
    low = injury_table.find(judged, "injury_intracranial_pressure_lowest")
    strain = injury_table.find(judged, "injury_strain_95")
    if high is None or low is None:
        return ""
    text = (f"Brain pressure ranges from {page.quantity(low.value, 'Pa', 2)} "
            f"to {page.quantity(high.value, 'Pa', 2)}; its minimum is "
            + ("below" if low.exceeded() else "above") + " the "
            f"{page.plain(low.thresholds[0][0], 'Pa')} at which fluid may "
            "cavitate.")
    if strain is not None:
        limit = strain.thresholds[0][0]
        text += (f" In 95 % of the brain the strain is below "
                 f"{page.percent(strain.value)}, "
                 + (f"under the {page.plain(100. * limit, '%')} at which "
                    "mild injury begins" if strain.exceeded() == 0
                    else f"a threshold of {strain.meaning()} is exceeded")
                 + ".")
    return text


def _certainty(scene, judged):
    """How sure the answer is, a sentence each."""
    parts = _verdicts(judged) + _free_air(scene) + _afterburn(scene)
    parts += _loads(scene) + _energy(scene) + _limits(scene)
    parts += _cut_phases(scene)
    if any(entry.name == "injury_strain_95" for entry in judged):
        parts.append(
            "No limit of brain pressure or strain is agreed on for blast: the "
            "published limits were found for impacts, and survived blasts "
            "exceed the pressure limits.")
    end = scene.fact("end_time")
    if end is not None and end < LONG_ENOUGH and any(
            entry.name in ("injury_strain_95", "injury_hic15")
            for entry in judged):
        parts.append(
            f"The run ends after {page.milliseconds(end)}, while brain strain "
            "and head motion still grow: their values are lower limits.")
    failed = [stage.get("name") for stage in scene.list_of("stages")
              if stage.get("status") == "failed"
              and not str(stage.get("name")).startswith("coarser_")]
    if failed:
        parts.append("The scene is not complete: " + page.joined(
            str(name) for name in failed) + " failed.")
    return parts


def _verdicts(judged):
    """Which verdicts the numerical error could change."""
    known = [entry for entry in judged if entry.has_verdict
             and entry.is_certain() is not None]
    if not known:
        return ["The numerical error of these verdicts is unknown: the scene "
                "has no coarser run."] if judged else []
    open_ones = [entry for entry in known if not entry.is_certain()]
    return ["Numerical error could change "
            + (page.count_in_words(len(open_ones)) if open_ones else "none")
            + f" of {page.count_in_words(len(known))} verdicts"
            + (": " + page.joined(entry.short_title() for entry in open_ones)
               if open_ones else "") + "."]


def _may_merge(scene):
    """Whether the ground's reflection may have merged with the incident wave
    at the probe: regular reflection of strong shocks in air ends at an angle of
    incidence of 40 degrees (von Neumann's detachment criterion)."""
    charge, probe = scene.charge_place(), scene.probe_place(1)
    if charge is None or probe is None:
        return False
    way = math.hypot(*(charge - probe)[:2])
    return math.degrees(math.atan2(way, charge[2] + probe[2])) > MERGING


def _free_air(scene):
    """Large differences of the wave beside the body to measurements."""
    carried, added = [], []
    for name, words in (("peak_overpressure", "incident peak overpressure"),
                        ("impulse", "impulse"), ("duration", "duration")):
        here, known = (scene.blast.found("results", "probe_1_" + stem + name)
                       for stem in ("", "reference_"))
        if not here or not known \
                or abs(here / known - 1.) <= LARGE_DIFFERENCE:
            continue
        change = here / known - 1.
        is_added = change > 0. and (name != "peak_overpressure"
                                    or _may_merge(scene))
        (added if is_added else carried).append(
            f"the {words} is {page.percent(abs(change))} "
            + ("below" if change < 0. else "above"))
    parts = []
    if carried:
        parts.append("Beside the body, " + page.joined(carried) + " Kingery "
                     "and Bulmash; loads and verdicts carry "
                     + ("these differences." if len(carried) > 1
                        else "this difference."))
    if added:
        parts.append("Beside the body, " + page.joined(added) + " Kingery and "
                     f"Bulmash; reflections by {reflections.reflectors(scene)} "
                     "contribute to this.")
    return parts


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
    energy = re.match(r"[\d.e+-]+(?= of at most ([\d.e+-]+) MJ/kg)",
                      rows["afterburn"].get("decision") or "")
    effects = page.joined(
        f"the incident {word} by at most {page.percent(rise)}"
        for rise, word in zip(known, ("peak", "impulse")) if rise is not None)
    text = "The run leaves out afterburn" if energy is None else (
        f"The run assumes {energy[0]} MJ/kg of afterburn "
        f"(at most {energy[1]} MJ/kg is possible)")
    if effects:
        text += f", which {'would raise' if energy is None else 'raises'} " \
            + effects
    return [text + "."]


def _fraction(row):
    """The estimate of a row of the plan, or None."""
    try:
        return float(row.get("estimate"))
    except (AttributeError, TypeError, ValueError):
        return None


def _loads(scene):
    """A large difference of the impulse on the elements to the recorded one."""
    found = load_impulses.largest(scene)
    if found is None:
        return []
    axis, recorded, mapped = found
    if abs(mapped / recorded - 1.) <= LARGE_LOAD_DIFFERENCE:
        return []
    return [f"The elements get {page.percent(mapped / recorded, 3)} of the "
            f"impulse that was recorded on the skin along {axis}."]


def _energy(scene):
    """What of the body's energy is missing or in hourglass modes."""
    found = []
    for name, entry, usual, noted, text in (
            ("energy_residual", "Largest residual", LARGEST_RESIDUAL, None,
             "of the body's energy is missing"),
            ("hourglass_part", "Largest hourglass part", LARGEST_HOURGLASS,
             NOTED_HOURGLASS,
             "of the largest internal energy was stored in hourglass modes")):
        part = scene.biomechanics.found("checks", name)
        limit = (scene.biomechanics.parameter(f"Energy audit/{entry}")
                 or [usual])[0]
        if part is not None and abs(part) > min(limit, noted or limit):
            warning = "" if noted is None else \
                f"warning from {page.plain(100. * noted, '%')}, "
            found.append(f"{page.percent(abs(part))} {text} ({warning}"
                         f"limit {page.plain(100. * limit, '%')})")
    return [page.joined(found) + "."] if found else []


def _limits(scene):
    """Items of the audit beyond their limits."""
    failed = [f"{WORDS.get(row.get('item')) or row.get('quantity')} "
              f"({row.get('found')}; limit: {row.get('limit')})"
              for row in scene.list_of("audit")
              if row.get("holds") is False and row.get("limit")]
    return ["Beyond " + ("their limits" if len(failed) > 1 else "its limit")
            + ": " + "; ".join(failed) + "."] if failed else []


def _cut_phases(scene):
    """Places whose positive phase goes on at the end of the run."""
    gauges = scene.blast.table("load_gauges.csv")
    if gauges is None:
        return []
    cut = [name for name, measures in scene.gauge_measures().items()
           if name in gauges and measures["peak"] > 0.
           and signals.is_cut(gauges["time"], measures)]
    if not cut:
        return []
    return ["The run ends before the positive phase does at "
            + page.joined(cut) + ": the impulse there is a lower limit."]
