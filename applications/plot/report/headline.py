# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The answer of a report in a few plain sentences."""

from plot.report import injury_table, page

LARGE_DIFFERENCE = 0.1  # of the incident peak to Kingery and Bulmash
LONG_ENOUGH = 0.01  # s, until the largest strains that a front causes


def answer(scene, judged):
    """What this blast does to this person, and how sure that is."""
    sentences = [_opening(scene)]
    sentences += [words for words in (_lung(judged), _ears(judged),
                                      _brain(judged)) if words]
    if len(sentences) == 1:
        sentences.append("What it does to a person cannot be told: neither "
                         "loads on the skin nor measures of injury are there.")
    return page.tag("div", *(page.paragraph(text) for text in
                             (" ".join(sentences), _certainty(scene, judged))
                             if text), kind="answer")


def _opening(scene):
    mass, place = scene.charge_mass(), scene.charge_place()
    body = {None: "a standing man", "phantom": "a standing man",
            "surface": "a person of a given surface",
            "image": "a body of medical images"}.get(
                scene.facts.get("body"), "a body")
    charge = "The charge" if mass is None else (
        f"{page.quantity(mass, 'kg')} of {scene.explosive().upper()}")
    where = ""
    if scene.fact("distance") is not None:
        where += f", {page.quantity(scene.fact('distance'), 'm')} away"
    height = scene.fact("height")
    if height is None and place is not None:
        height = float(place[2])
    if height is not None:
        where += f" and {page.quantity(height, 'm')} above the ground"
    return f"{charge} goes off before {body}{where}."


def _lung(judged):
    mean = injury_table.find(judged, "chest_wall_mean")
    front = injury_table.find(judged, "chest_wall_front") \
        or injury_table.find(judged, "injury_chest_wall_velocity")
    if front is None:
        return ""
    bowen = injury_table.find(judged, "lung_exposure") \
        or injury_table.find(judged, "injury_lung_exposure")
    worst = front.meaning() or "none"
    best = mean.meaning() or "none" if mean else worst
    words = worst if worst == best else f"between {best} and {worst}"
    text = (f"The injury of the lungs to expect is {words}: the chest wall is "
            f"pushed in at {page.quantity(front.value, 'm/s')} in front")
    text += f", {page.quantity(mean.value, 'm/s')} as the mean of front and " \
            "back" if mean else ""
    if bowen is not None:
        text += (f", and the chest load is "
                 f"{page.number(bowen.value, 2)} of the 50 % lethality load")
    return text + "."


def _ears(judged):
    ears = [entry for entry in judged if entry.name.startswith("ear_")]
    ears = ears or [entry for entry in judged
                    if entry.name == "injury_eardrum_rupture"]
    if not ears:
        return ""
    worst = max(entry.value for entry in ears)
    part = "more than 99 %" if worst > 0.99 \
        else f"{page.number(100. * worst, 2)} %"
    return ("Unprotected eardrums rupture with a probability of "
            f"{part}.")


def _brain(judged):
    high = injury_table.find(judged, "injury_intracranial_pressure_peak")
    low = injury_table.find(judged, "injury_intracranial_pressure_lowest")
    strain = injury_table.find(judged, "injury_strain_95")
    if high is None or low is None:
        return ""
    text = (f"Pressures in the brain reach from {_pressure(low.value)} to "
            f"{_pressure(high.value)}")
    exceeded = [name for name, entry in (
        ("the limit for serious injury by impacts",
         high if high.exceeded() == 2 else None),
        ("that of cavitation", low if low.exceeded() else None)) if entry]
    text += ", beyond " + " and ".join(exceeded) if exceeded \
        else ", within the known limits"
    if strain is not None:
        text += (f"; 95 % of its tissue is strained by less than "
                 f"{page.number(100. * strain.value, 2)} %, "
                 + ("below the 14 % at which mild injury begins"
                    if strain.exceeded() == 0
                    else f"which means: {strain.meaning()}"))
    return text + "."


def _pressure(value):
    return page.quantity(value, "Pa", 2)


def _certainty(scene, judged):
    """How sure the answer is."""
    known = [entry for entry in judged if entry.thresholds
             and entry.is_certain() is not None]
    parts = []
    if known:
        open_ones = [entry for entry in known if not entry.is_certain()]
        parts.append(
            "Numerical error could change "
            + (f"{len(open_ones)} of {len(known)} verdicts: " + "; ".join(
                entry.title for entry in open_ones) if open_ones
               else f"none of {len(known)} verdicts") + ".")
    elif judged:
        parts.append("The numerical error of these verdicts is unknown: the scene "
                     "has no coarser run.")
    parts += _free_air(scene) + _limits(scene)
    if any(entry.name == "injury_strain_95" for entry in judged):
        parts.append(
            "What pressures and strains mean for a brain in a blast is open: "
            "the limits were found for impacts, and blasts that were survived "
            "exceed that of pressure.")
    end = scene.fact("end_time")
    if end is not None and end < LONG_ENOUGH and any(
            entry.name in ("injury_strain_95", "injury_hic15")
            for entry in judged):
        parts.append(
            f"The run ends after {page.milliseconds(end)}, while strains of "
            "the brain and motion of the head still grow: they are lower "
            "limits.")
    failed = [stage.get("name") for stage in scene.list_of("stages")
              if stage.get("status") == "failed"
              and not str(stage.get("name")).startswith("coarser_")]
    if failed:
        parts.append("The scene is not complete: " + ", ".join(
            str(name) for name in failed) + " failed.")
    return " ".join(parts)


def _free_air(scene):
    """The peak beside the body, where it differs from measurements."""
    here, known = (scene.blast.found("assumptions", "probe_1_" + name)
                   for name in ("peak_overpressure",
                                "reference_peak_overpressure"))
    if not here or not known or abs(here / known - 1.) <= LARGE_DIFFERENCE:
        return []
    change = here / known - 1.
    return ["The incident peak overpressure is "
            f"{page.number(100. * abs(change), 2)} % "
            f"{'below' if change < 0. else 'above'} Kingery and Bulmash, more "
            "than that of a fine mesh: loads and verdicts carry this "
            "difference."]


def _limits(scene):
    """Items of plan and audit beyond their limits."""
    failed = [str(row.get("item")).replace("_", " ")
              for row in scene.list_of("audit") if row.get("holds") is False]
    return ["Beyond its limit: " + ", ".join(failed)
            + " (see what was taken for granted)."] if failed else []
