# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Measures of injury with their errors, thresholds and verdicts."""

import math

from plot.analysis import person
from plot.readers import stage
from plot.report import (error_estimate, injury_thresholds, least_phases,
                         load_impulses, page)
from plot.report.injury_thresholds import Known
from plot.report.judged import Judged

# Names of the measures of gauge_injury.csv; of chest and back, and of an upper
# arm that is turned to the charge, the side with the larger load is shown.
SIDES = ("chest", "back")
ARMS = {"left side": "left upper arm", "right side": "right upper arm"}
SKIN_NAMES = {("chest_wall_velocity", "trunk"): "chest_wall_mean",
              ("chest_wall_velocity", "chest"): "chest_wall_front",
              ("chest_wall_velocity", "back"): "chest_wall_back",
              ("chest_wall_velocity", "left upper arm"): "chest_wall_left",
              ("chest_wall_velocity", "right upper arm"): "chest_wall_right",
              ("lung_exposure", "chest"): "lung_exposure",
              ("lung_exposure", "back"): "lung_exposure_back",
              ("lung_exposure", "left upper arm"): "lung_exposure_left",
              ("lung_exposure", "right upper arm"): "lung_exposure_right"}
# Shown measures of probe_injury.csv, at a probe as far from the charge as the
# body.
AIR_NAMES = {"lung_exposure": "lung_exposure_air",
             "lung_lethality": "lung_lethality"}
# Beyond these, relative to the nearest skin, ears and trunk are not where the
# probe is; loads of lungs rise steeply.
FARTHER, FARTHER_TRUNK = 1.15, 1.05
ASKEW = 25.  # degrees from the nearest gauge's axis to the charge
# Told with the checks of the run.
NO_INJURY = ("injury_pressure_roughness",)
UNKNOWN = stage.Measure("", None, "")
PRESSURES = ("injury_intracranial_pressure_peak",
             "injury_intracranial_pressure_lowest")
# Measures of the motion of the head as a whole.
OF_THE_MOTION = ("injury_hic15", "injury_bric")
TENSIONS = ("injury_cavitating_fraction", "injury_cavitation_dose")
GROUPS = (("Ears", ("ear_",)),
          ("Chest and lungs", ("chest_", "injury_chest", "injury_lung",
                               "injury_adjusted_severity", "lung_")),
          ("Brain and head", ("injury_",)))


def cut_off(judged, entry, end):
    """Which measures that could be judged the end of the run [s], or None, makes
    lower limits, and the @p entry that helps."""
    cut = [one.short_title() + (" (in magnitude)" if one.value < 0. else "")
           for one in judged if one.is_cut and one.thresholds]
    if cut and any(one.is_cut and not one.thresholds for one in judged):
        cut.append("other measures with ≥")
    after = "" if end is None else f", after {page.given(1e3 * end, 'ms')}"
    return [f"The run ends too early{after}: {page.joined(cut)} "
            + ("are lower limits" if len(cut) > 1 else "is a lower limit")
            + ", and later extremes of the rest are unknown; a later "
            f"{entry} gives all of it."] if cut else []


def judge(scene):
    """All measures, those of the skin first."""
    side = loaded_side(scene) if has_chest(scene) else ""
    lungs = lungs_by(scene)
    all_known = injury_thresholds.of_run(scene)
    coarser = {} if scene.coarser is None else _measures_of(
        scene, scene.coarser, side, lungs, all_known)
    of_gauges = error_estimate.of_scene_gauges(scene)
    judged = []
    for name, (measure, known) in _measures_of(
            scene, scene, side, lungs, all_known).items():
        value, (other, _) = measure.value, coarser.get(name, (UNKNOWN, None))
        # A lower limit is no value to compare with.
        error, causes = (None, "") if other.value is None or (
            other.is_cut and not measure.is_cut) else error_estimate.of(
                scene, name, value, other.value)
        curve, of, least_part = "", None, 1.
        if name.startswith("ear_rupture_"):
            place, curve = name[len("ear_rupture_"):], "eardrum_rupture"
            of = scene.gauge_measures().get(place, {}).get("peak")
            error = of_gauges.get(place, {}).get("peak")
        elif name == "lung_lethality":
            # Its load stands before it.
            curve, load = name, find(judged, "lung_exposure_air") or find(
                judged, SKIN_NAMES["lung_exposure", side])
            of, error, least_part = load.value, load.error, load.least_part
        elif name == "lung_exposure_air":
            error = _at_least(error, error_estimate.of_result(
                scene, "probe_1_peak_overpressure") or 0.)
            least_part = least_phases.part_of_load(scene, least_phases.PROBE)
        elif name.startswith(("chest_wall_", "lung_")):
            # Errors of peak and duration can cancel in what follows from both.
            error = _at_least(error, of_gauges.get(side, {}).get("peak", 0.))
            if name == SKIN_NAMES.get(("lung_exposure", side)):
                least_part = least_phases.part_of_load(scene, side)
        else:
            error = _at_least(error, load_impulses.difference_of_motion(scene)
                              if name in OF_THE_MOTION else
                              load_impulses.difference(scene))
        judged.append(Judged(name, value, measure.unit, known, error, causes,
                             other.value, curve if of is not None else "", of,
                             measure.is_cut, least_part, other.is_cut))
    _share_errors(judged)
    ask_tables(scene, judged)
    return judged


def ask_tables(scene, judged):
    """Gives eardrums and lungs what the tables have at their distance, where no
    bounds of their kind reach that."""
    ears = [entry for entry in judged if entry.name.startswith("ear_rupture_")]
    answers = [(ears, ears_of_tables(scene, ears), at_distance(scene, "ears"))]
    load = "lung_exposure_air" if lungs_by(scene) == "probe" else \
        SKIN_NAMES["lung_exposure", loaded_side(scene)]
    for name, key in (("lung_lethality",) * 2, ("lung_exposure", load)):
        entry = find(judged, key)
        if entry is not None:
            answers.append(([entry], lungs_of_tables(scene, name),
                            at_trunk(scene).strip()))
    # Thresholds of the user's own judge the load on the skin, too.
    skin = find(judged, SKIN_NAMES["lung_exposure", loaded_side(scene)])
    if skin is not None and skin.is_own and skin.name != load:
        answers.append(([skin], scene.table_answer("lung_exposure"), ""))
    for entries, known, place in answers:
        bounds = [entry.bounds() or 2 * (entry.value,) for entry in entries]
        if None in known or any(high >= known[0] and low <= known[1]
                                for low, high in bounds):
            continue
        for entry in entries:
            entry.tables, entry.tables_place = known, place


def at_distance(scene, part):
    """Where the tables are asked for the "ears" or the "trunk", as "at the nearer
    ear's 2.13 m"; "" where that is at the nearest skin."""
    distance = ((scene.facts.get("tables") or {}).get(part) or {}).get("distance")
    name = "nearer ear" if part == "ears" else part
    return "" if distance is None else \
        f"at the {name}'s {page.quantity(distance, 'm')}"


def at_trunk(scene):
    """The same after a blank for what tells whether lungs kill, see lungs_by()."""
    place = at_distance(scene, "trunk") if lungs_by(scene) == "skin" else ""
    return place and f" {place}"


def ears_of_tables(scene, ears):
    """Values of the tables on eardrums in the open and before a wall, at the
    distance of the nearer ear; None each where that is unknown."""
    known = scene.table_answer("eardrum_rupture", "ears")
    places = [entry.name.removeprefix("ear_rupture_") for entry in ears]
    # As of a scene before 0.2.0.
    return scene.table_answer("eardrum_rupture") \
        if None in known and not are_far(scene, places) else known


def _at_least(error, least):
    """The larger of both; no error is known without the first."""
    return None if error is None else max(error, least)


def _share_errors(judged):
    """Both extremes of the brain's pressure have the larger relative error of
    the two, since one of them may agree by chance; so have both measures of
    tension, unknown where they are zero and only the error of the minimum
    pressure reaches tension."""
    for names in (PRESSURES, TENSIONS):
        entries = [entry for entry in judged if entry.name in names
                   and entry.error is not None and entry.value]
        for entry in entries:
            entry.error = max(other.error for other in entries)
    lowest = find(judged, PRESSURES[1])
    for entry in judged:
        if entry.name in TENSIONS and not entry.value \
                and lowest is not None and lowest.is_certain() is False:
            entry.error = None


def loaded_side(scene):
    """The side with the largest exposure of the lung."""
    injury = scene.gauge_injury()
    return max((side for side in (*SIDES, ARMS.get(person.side_to_charge(scene)))
                if ("lung_exposure", side) in injury), default=SIDES[0],
               key=lambda side: injury["lung_exposure", side].value)


def has_chest(scene):
    """Whether the body has lungs, or is a person with gauges at the trunk; any
    other body may have a gauge of the same name."""
    return "injury_lung_exposure" in scene.measures() or (
        person.is_person(scene) and any(
            ("lung_exposure", side) in scene.gauge_injury() for side in SIDES))


def has_probe_at_body(scene):
    """Whether the first probe in the air is the scene's own, as far from the
    charge as the body."""
    return scene.facts.get("probe_beside_body") is not None


def lungs_by(scene):
    """Basis to judge lungs by: the wave at the "probe" next to the body, the
    load on the "skin" where there is no such probe or the trunk is farther
    from the charge than that, as with a charge at the feet, or nothing
    ("")."""
    if not has_chest(scene):
        return ""
    return "probe" if has_probe_at_body(scene) and not is_trunk_far(scene) \
        else "skin"


def lungs_of_tables(scene, name):
    """The least and the largest value by the tables of a measure of the lungs at
    what tells whether these kill, see lungs_by(): that in the open, where the
    skin tells up to that before a wall; None each where they have none."""
    return scene.table_answer(name, "trunk") if lungs_by(scene) == "skin" \
        else 2 * scene.table_answer(name)[:1]


def off_the_gauges(scene):
    """How far the charge is off the nearest of the axes of chest, back and sides
    [degrees], from ASKEW on, where none of their gauges faces it; else 0."""
    azimuth = (scene.facts.get("person") or {}).get("charge_azimuth")
    off = 0. if azimuth is None else abs((azimuth + 45.) % 90. - 45.)
    return off if off >= ASKEW else 0.


def why_by_the_skin(scene):
    """Why the load on the skin tells of lungs, a clause."""
    return page.joined(filter(None, (
        "" if has_probe_at_body(scene) else
        "no probe beside the body has the wave in the open",
        is_trunk_far(scene) and "chest and lungs are farther from the charge "
        "than the nearest skin")))


def is_trunk_far(scene):
    """Whether chest, back and upper arms are farther from the charge than the
    nearest skin."""
    return are_far(scene, (*SIDES, *ARMS.values()), FARTHER_TRUNK)


def are_far(scene, names, farther=FARTHER):
    """Whether all these gauges on the skin are farther from the charge than the
    nearest skin."""
    known, distance = scene.loads(), scene.fact("distance")
    places = known.places() if known is not None and distance else {}
    return bool(places.keys() & set(names)) and all(
        math.dist(scene.charge_place(), places[name]) > farther * distance
        for name in names if name in places)


def of_file(name, measure, all_known):
    """Known facts on a Measure of injury.csv, which has its own limits."""
    known = all_known.get(name, Known(injury_thresholds.title(name), [],
                                      measure.threshold, ""))
    return known._replace(limits=measure.limits or known.limits)


def _measures_of(scene, run, side, lungs, all_known):
    """Each Measure and what is known of it, by name; @p run: the Scene or its
    coarser Run, @p lungs: see lungs_by()."""
    found = _of_skin(run, side, all_known)
    load = run.gauge_injury().get(("lung_exposure", side))
    if lungs == "skin" and load is not None:
        found["lung_lethality"] = stage.Measure(
            "lung_lethality", injury_thresholds.probability(
                "lung_lethality", load.value), load.unit,
            is_cut=load.is_cut), all_known["lung_lethality"]._replace(
                limits="of the reflected load on the skin of the trunk: "
                + why_by_the_skin(scene) + "; for 24 h without treatment")
    if lungs == "probe":
        for (measure, place), one in run.air_injury().items():
            name = AIR_NAMES.get(measure)
            if place == least_phases.PROBE and name is not None:
                found[name] = one, all_known[name]
    found.update((name, (measure, of_file(name, measure, all_known)))
                 for name, measure in run.measures().items()
                 if name not in (*NO_INJURY, *injury_thresholds.OF_CURVES))
    if "lung_exposure_air" in found:
        # The thresholds are those of the load in the open, which is known.
        for name, (measure, known) in found.items():
            if name.startswith(("lung_exposure", "injury_lung_exposure")) \
                    and name != "lung_exposure_air" and not known.is_own:
                found[name] = measure, known._replace(is_exposure=True)
    return found


def _of_skin(run, side, all_known):
    """Those of the recorded loads alone, eardrums first, as in the table; of
    chest and back those of a side, and their mean."""
    gauges, ears, others = run.gauge_measures(), {}, {}
    for (measure, place), found in run.gauge_injury().items():
        name = SKIN_NAMES.get((measure, place))
        if measure == "eardrum_rupture":
            known = all_known["ear_rupture"]
            peak = gauges.get(place, {}).get("peak")
            ears[f"ear_rupture_{place}"] = found, known._replace(
                title=known.title.replace("an eardrum", f"the {place}drum"),
                limits=known.limits if peak is None else
                f"peak {page.quantity(peak, 'Pa')}; {known.limits}")
        elif name is not None and side and place in (side, "trunk"):
            others[name] = found, all_known[name]
    return ears | others


def find(judged, name):
    """The measure of that name, or None."""
    return next((entry for entry in judged if entry.name == name), None)


def table(scene, judged):
    """The injury table, by parts of the body."""
    if not judged:
        return [_nothing_judged(scene)]
    parts, left = [], list(judged)
    for title, beginnings in GROUPS:
        group = [entry for entry in left if entry.name.startswith(beginnings)]
        left = [entry for entry in left if entry not in group]
        if group:
            parts += [page.tag("h3", title), table_of(group)]
    return parts + [page.paragraph(
        "Errors are relative, or bounds of what lies between 0 and 100\u00a0%, and "
        "cover the numerics alone. They are "
        + ("unknown without a coarser run. " if scene.coarser is None else
           "estimated from the coarser run of this scene (see the section on "
           "accuracy) and unknown of what that run lacks. ") +
        "Thresholds are those commonly cited; they and the tissue properties "
        "are less certain than the numerics."
        + (" ≥: a lower limit, since the run ends too early"
           + ("; ≤: the least value may be lower."
              if any(entry.is_cut and entry.value < 0. for entry in judged)
              else ".") if any(entry.is_cut for entry in judged) else "")
        + (" AIS: abbreviated injury scale, 1 (minor) to 6 (untreatable)."
           if any("AIS" in meaning for entry in judged
                  for _, meaning in entry.thresholds) else ""),
        kind="note")]


def _nothing_judged(scene):
    """Why the table is empty."""
    if not scene.has_no_gauges():
        return page.missing("injury.csv of biomechanics and gauge_injury.csv of "
                            "the blast")
    history = scene.biomechanics.table("history.csv")
    reason = "this body has neither a brain nor a chest" \
        if history is not None and not any(
            f"internal_energy_{tissue}" in history
            for tissue in ("brain", "lung")) else \
        "the question is loads, and no gauge stands at chest or ears" \
        if scene.asks_for_loads() else ""
    return page.paragraph(f"There is no measure of injury: {reason}.",
                          kind="note") if reason else page.missing(
                              "injury.csv of biomechanics")


def table_of(group):
    """A table of some judged measures."""
    return page.table(
        ("measure", "value and its estimated error",
         "thresholds and their source", "verdict", "limitations"),
        [_row(entry) for entry in group], widths=(20, 14, 29, 15, 22),
        data=(("measure", "value", "unit", "least by the numerics",
               "largest by the numerics", "lower limit", "thresholds",
               "source", "verdict", "limitations"),
              [_data_row(entry) for entry in group]))


def _row(entry):
    line = page.Markup("<br>")
    error = [page.tag("small", "error unknown" + (
        "" if entry.coarser is None else
        f" ({entry.shown_coarser()} in the coarser run)"))] \
        if entry.error is None else [
            entry.shown_error(), page.tag("small", f"due to {entry.error_of}")]
    return (entry.title, line.join([page.tag("b", entry.shown()), *error]),
            line.join([*(f"{entry.shown_limit(limit)}: {meaning}"
                         for limit, meaning in entry.thresholds),
                       page.tag("small", entry.source)]),
            _verdict(entry), entry.limits)


def _data_row(entry):
    """The same for the CSV file, with all digits."""
    return (entry.title, page.Rounded("", entry.value), entry.unit,
            *("" if bound is None else page.Rounded("", bound)
              for bound in entry.sure_bounds()),
            "yes" if entry.is_cut else "no",
            "; ".join(f"{limit!r}: {meaning}"
                      for limit, meaning in entry.thresholds),
            entry.source, _verdict(entry), entry.limits)


def _verdict(entry):
    if not entry.thresholds:
        return page.tag("span", "no threshold", kind="none")
    if entry.is_open:
        return page.tag("span", "not judged: the run ends too early",
                        kind="none")
    if not entry.has_verdict:
        return page.tag("span", "exposure, no verdict", kind="none")
    count = entry.exceeded()
    is_lowest = entry.thresholds[0][0] < 0.
    word = entry.compared() if entry.is_own else (
        "exceeded: " if is_lowest else "above: ") + entry.meaning() \
        if count else "not reached" if is_lowest else "below"
    certain = entry.is_certain()
    note = "" if certain is None else "; the error does not change this" \
        if certain else "; a threshold lies within the error"
    note += entry.tables and "; " + entry.shown_tables() or ""
    return page.Markup().join((
        page.tag("span", word, kind=severity(entry)), note,
        *(page.tag("small", "; " + words) for words in _chances(entry))))


def severity(entry):
    """Good below all thresholds, by the tables and the errors, too, bad above
    all, else mid; none of what has no verdict."""
    count = entry.exceeded()
    if entry.has_verdict and (entry.is_certain() is False or (
            count == 0 and entry.other_by_tables() is not None)):
        return "mid"
    return "none" if not entry.has_verdict else "good" if count == 0 else \
        "bad" if count == len(entry.thresholds) else "mid"


def _chances(entry):
    """Probabilities in words, with their interval."""
    shown = page.least_chance if entry.is_cut else page.chance
    for event, value, bounds in entry.chances():
        yield f"{event}: {shown(value)}" + (
            f" ({page.interval(*bounds)})" if bounds and not entry.is_cut
            else "")
