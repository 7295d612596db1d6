# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Reflections of the blast wave to the body and to the probe next to it."""

import re

from plot.readers import files
from plot.report import least_phases, page

SKIN = "nearest skin"
# Quantities that grow with the positive phase.
OF_THE_PHASE = ("impulse", "duration")


def reflectors(scene, time=None):
    """Words for what may reflect a wave to the first probe within its positive
    phase, or with its peak at a time: planes that bring it there, unless they
    have merged with the incident wave, and the body."""
    return page.joined([*_planes(scene, time), "body"], "or")


def _planes(scene, time=None):
    """Names of the planes among them."""
    if "reflections" not in scene.facts:  # as of a scene before 0.2.0
        return [] if is_surface_burst(scene) else ["ground"]
    arrival, duration = _at_probe(scene, "arrival", "duration")

    def comes(row):
        delays = [files.as_number(row.get(key))
                  for key in ("least_delay", "largest_delay")]
        if None in (*delays, arrival, duration):
            return True
        return delays[0] <= duration if time is None else \
            delays[0] <= time - arrival <= delays[1]
    return [str(row.get("by")) for row in _rows(scene, least_phases.PROBE)
            if not row.get("merges") and comes(row)]


def _at_probe(scene, *names):
    """Results at the first probe, None each where they are unknown."""
    return [scene.blast.found("results", f"probe_1_{name}") for name in names]


def _rows(scene, place):
    """Reflections at a place, of scene.json."""
    return [row for row in scene.list_of("reflections")
            if row.get("place") == place]


def _merged(scene):
    """Those at the first probe that have merged with the incident wave."""
    return [row for row in _rows(scene, least_phases.PROBE)
            if row.get("merges")]


def is_surface_burst(scene):
    """Whether charge and ground make one wave, that of hemispherical tables."""
    return (scene.facts.get("tables") or {}).get("burst") == "hemispherical"


def place_of_burst(scene):
    """Where the tables have the charge, in words."""
    return "on the ground with a hemispherical wave" if is_surface_burst(scene) \
        else "in free air"


def walls(scene):
    """Sides of the domain that reflect, by the user's choice, in words: "wall at
    x = 0.64 m, 0.45 m from the body"."""
    return [words for _, words in wall_sides(scene)]


def wall_sides(scene):
    """The same with the names of the sides, such as "x_low"."""
    return [(str(row["item"])[5:],
             f"{row.get('decision')}, {row.get('estimate')} from the body")
            for row in scene.list_of("plan")
            if str(row.get("item")).startswith("side_")
            and str(row.get("decision")).startswith(("wall", "symmetry"))]


def is_cut_off(scene, row):
    """Whether the run's value next to the tables is a lower limit, as it ends
    before the positive phase does; scenes before 0.2.0 tell it of the
    probe."""
    return bool(row.get(
        "cut_off", row.get("name") in OF_THE_PHASE
        and scene.blast.found("results", "probe_1_cut_off")))


def note(scene, probe="the probe"):
    """Effects of reflections and of the end of the run on the wave at the
    first probe, as sentences."""
    merged = _merged(scene)
    return (
        (f"The wave at {probe} may have merged with its reflection by the "
         + page.joined(str(row.get("by")) for row in merged)
         + (", which adds " if len(merged) == 1 else ", each of which adds ")
         + _rises(merged[0]) + " and lets it arrive earlier" if merged else
         f"Peak and arrival at {probe} are those of the incident wave")
        + (f". {_second_wave(scene)}" if _has_second_wave(scene) else
           f"; reflections by the {reflectors(scene)} may add to impulse and "
           "duration, as may the charge's own second shock.")
        + (" The run ends before the positive phase does: its impulse and "
           "duration are lower limits, and what it does to lungs is unknown."
           if scene.blast.found("results", "probe_1_cut_off") else ""))


def beside_tables(scene):
    """What merged reflections add to the wave of the tables, a clause; "" where
    none has merged."""
    merged = _merged(scene)
    return "" if not merged else (
        " without the merged reflection by the "
        + page.joined(str(row.get("by")) for row in merged) + ", which adds "
        + _rises(merged[0]))


def note_on_people(scene):
    """By which peak people at the first probe are judged, as a sentence; "" if
    by that of the incident wave."""
    return " The last rows, on people in the open, are by the larger peak of " \
        "the second wave." if _largest_wave(scene) else ""


def _rises(row):
    """Rises by a merged reflection, in words."""
    return page.joined(
        ("an unknown part" if rise is None else f"some {page.percent(rise, 2)}")
        + f" to the {name}" for name, rise in (
            (name, files.as_number(row.get(f"{name}_rise")))
            for name in ("peak", "impulse")))


def explaining(scene):
    """Possible reason for a longer or stronger wave at the first probe than
    that of the tables, in words."""
    if not _has_second_wave(scene):
        return "reflections or a second shock"
    return "the second wave" if _place_of_second_shock(scene) else \
        "reflections or the second wave"


def _has_second_wave(scene):
    """Whether one comes within the positive phase at the first probe."""
    return _later_wave(scene) is not None \
        or least_phases.at_probe(scene) is not None


def _later_wave(scene):
    """Peak [Pa] and its time [s] of a later wave within the positive phase at
    the first probe, as the run recorded it; None without."""
    peak, time, arrival, duration = _at_probe(
        scene, "later_peak_overpressure", "later_peak_time", "arrival", "duration")
    return (peak, time) if None not in (peak, time, arrival, duration) \
        and time <= arrival + duration else None


def _largest_wave(scene):
    """The later wave, if its peak is above that of the incident one; None
    without."""
    later = _later_wave(scene)
    first = scene.incident_peak(1)
    return later if later and first is not None and later[0] > first else None


def _second_wave(scene):
    """Sentences on a second wave within the positive phase at the first probe,
    before which finer cells may end it."""
    least, later = least_phases.at_probe(scene), _later_wave(scene)
    return (
        "A second wave comes within the positive phase there"
        + ("" if least is None else
           f", {page.milliseconds(least)} after the arrival or later")
        + ("" if later is None else
           f", with a peak of {page.quantity(later[0], 'Pa')} at "
           f"{page.milliseconds(later[1])}"
           + (", where the run ends: its peak may be higher"
              if later[1] >= 0.999 * (scene.fact("end_time") or later[1]) else ""))
        + f": {_cause_of_second_wave(scene)}."
        + " Impulse, duration and the load on lungs are those of both waves."
        + (" Their errors do not hold, since finer cells may let the pressure "
           "fall to zero between the waves, which leaves the duration that is "
           "called the least." if least is not None else ""))


def _cause_of_second_wave(scene):
    """Where it comes from, in words. Neither the charge's second shock nor the
    body's reflection is larger than the incident wave."""
    place, later = _place_of_second_shock(scene), _later_wave(scene)
    time = later and later[1]
    if place:
        return "the charge's own second shock, which the " \
            f"{place} has at the same time; the body's reflection may raise it"
    if not _largest_wave(scene):
        return "the charge's own second shock, or a reflection by the " \
            + reflectors(scene, time)
    planes = _planes(scene, time)
    return f"the reflection by the {page.joined(planes, 'or')}" if planes else \
        f"a reflection by the {reflectors(scene)}"


def _place_of_second_shock(scene):
    """Where on the skin, as far from the charge, the second wave at the first
    probe shows that no reflection is in it; None where one may be."""
    if _merged(scene) or _planes(scene) or "reflections" not in scene.facts:
        return None
    return least_phases.place_of_same_wave(scene)


def is_elsewhere(scene, row):
    """Whether an item of the audit is that of a wave which open sides send to
    gauges alone, neither to the body nor to the probe next to it, before the
    end."""
    if row.get("item") != "reflection":
        return False
    at_body, end = map(scene.fact, ("reflection_at_body", "end_time"))
    probe, place = scene.facts.get("probe_beside_body"), _place_of(row)
    is_of_probe = probe and place and all(
        abs(found - known) < 1e-3 for found, known in zip(
            map(float, place.split(",")), probe))
    return not is_of_probe and None not in (at_body, end) and at_body >= end


def _place_of(row):
    """Coordinates in an item of the audit, as text, or None."""
    place = re.search(r" at ([^a-z]+) m$", str(row.get("quantity")))
    return place and place[1]


def _of_open_sides(scene):
    """Items of the audit by which open sides send a wave to gauges before the
    end."""
    return [row for row in scene.list_of("audit")
            if row.get("item") == "reflection" and row.get("holds") is False]


def open_sides_disturb(scene):
    """Whether open sides send a wave to the body, or to the probe next to it,
    before the end."""
    return any(not is_elsewhere(scene, row) for row in _of_open_sides(scene))


def note_on_maps(scene):
    """Where and when open sides send a wave to gauges first, as a sentence; ""
    if they do not before the end."""
    row = next(iter(_of_open_sides(scene)), None)
    if row is None:
        return ""
    place, found = _place_of(row), row.get("found")
    return (" Open sides of the domain send a wave back to gauges before the end"
            + (f", first to the one at {place} m" if place else "")
            + (f" at {found}" if found != "unknown" else
               f" at an estimated {row.get('estimate')}")
            + ": figures of the maps may have it in them.")


def is_late(scene, arrival, time):
    """Whether the ground's reflection comes to the nearest skin, which the wave
    reaches at its arrival, after a time."""
    delays = [files.as_number(row.get("least_delay"))
              for row in _rows(scene, SKIN) if row.get("by") == "ground"]
    return any(delay is not None and arrival + delay > time
               for delay in delays)
