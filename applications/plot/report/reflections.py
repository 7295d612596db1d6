# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""What reflects the blast wave to the body and to the probe beside it."""

import math

import numpy as np

from plot.readers import files
from plot.report import least_phases, page
from plot.report.injury_thresholds import SEA_LEVEL

SOUND_SPEED = 340.3  # in standard air [m/s]


def reflectors(scene, has_ground=True):
    """Words for what adds reflections to the positive phase at the first probe:
    the ground, unless its reflection must come later, has been named or is
    that of a surface burst, the body, and walls."""
    found = ["ground"] if has_ground and not is_surface_burst(scene) \
        and not _ground_is_late(scene) else []
    found += ["body"] + (["walls"] if walls(scene) else [])
    return ("the " if len(found) == 1 else "") + page.joined(found)


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


def note(scene):
    """What reflections and the end of the run do to the wave at the first probe,
    as sentences."""
    is_cut = scene.blast.found("results", "probe_1_cut_off")
    merges = _may_merge(scene)
    others = reflectors(scene, has_ground=not merges)
    return (
        "The wave at the probe may have merged with its reflection by the "
        "ground, which raises peak and impulse and lets it arrive earlier"
        if merges else
        "Peak and arrival at the probe are those of the incident wave") + (
        f". {_second_wave(scene, others)}" if _has_second_wave(scene) else
        f"; reflections by {others} may add to impulse and duration.") + (
        " The run ends before the positive phase does: its impulse and duration "
        "are lower limits, and what it does to lungs is unknown."
        if is_cut else "")


def explaining(scene):
    """What may explain a longer or stronger wave at the first probe than that of
    the tables, in words."""
    if not _has_second_wave(scene):
        return "reflections"
    return "the second wave" if _place_of_second_shock(scene) else \
        "reflections or the second wave"


def _has_second_wave(scene):
    """Whether one comes within the positive phase at the first probe."""
    return _later_wave(scene) is not None \
        or least_phases.at_probe(scene) is not None


def _later_wave(scene):
    """Peak [Pa] and its time [s] of a later wave within the positive phase at
    the first probe, as the run recorded it; None without."""
    peak, time, arrival, duration = (
        scene.blast.found("results", "probe_1_" + name) for name in (
            "later_peak_overpressure", "later_peak_time", "arrival",
            "duration"))
    is_within = None not in (peak, time, arrival, duration) \
        and time <= arrival + duration
    return (peak, time) if is_within else None


def _largest_wave(scene):
    """The later wave, if its peak is above that of the incident one; None
    without."""
    later = _later_wave(scene)
    first = scene.incident_peak(1)
    return later if later and first is not None and later[0] > first else None


def _second_wave(scene, others):
    """What is told of a second wave within the positive phase at the first
    probe, before which finer cells may end it, as sentences."""
    least, later = least_phases.at_probe(scene), _later_wave(scene)
    largest = _largest_wave(scene)
    place = _place_of_second_shock(scene)
    return (
        "A second wave comes within the positive phase there"
        + ("" if least is None else
           f", {page.milliseconds(least)} after the arrival or later")
        + ("" if later is None else
           f", with a peak of {page.quantity(later[0], 'Pa')} at "
           f"{page.milliseconds(later[1])}") + ": "
        + (f"the charge's own second shock, which the {place} has at the same "
           "time." if place else
           "the reflection by the ground." if _is_of_the_ground(scene) else
           f"a reflection by {others}." if largest else
           f"the charge's own second shock, or a reflection by {others}.")
        + (" Eardrums and lungs are judged by this larger peak."
           if largest else "")
        + " Impulse, duration and the load on lungs are those of both waves."
        + (" Their errors do not hold, since finer cells may let the pressure "
           "fall to zero between the waves, which leaves the duration that is "
           "called the least." if least is not None else ""))


def _is_of_the_ground(scene):
    """Whether the second wave at the first probe is the ground's reflection
    alone: larger than the incident wave, which neither the charge's second
    shock nor the body's reflection is, no later than at the speed of sound, and
    where no walls are."""
    largest, arrival = _largest_wave(scene), scene.blast.found(
        "results", "probe_1_arrival")
    charge, probe = scene.charge_place(), scene.probe_place(1)
    if largest is None or charge is None or probe is None or walls(scene) \
            or is_late(scene, probe, arrival, largest[1]):
        return False
    direct, mirrored = _ways(charge, probe)
    return largest[1] <= arrival + (mirrored - direct) / SOUND_SPEED


def _place_of_second_shock(scene):
    """Where on the skin, as far from the charge, the second wave at the first
    probe shows that no reflection is in it; None where one may be."""
    if walls(scene) or not (is_surface_burst(scene) or _ground_is_late(scene)):
        return None
    return least_phases.place_of_same_wave(scene)


def _may_merge(scene):
    """Whether the wave at the first probe may have merged with its reflection:
    one that meets the ground at more than 40 degrees, where regular reflection
    of strong shocks ends, unless its peak is below that of the tables or the
    ground's reflection comes later."""
    distance, height = scene.fact("distance"), scene.fact("height")
    may_merge = None not in (distance, height) and math.atan2(
        distance, 2. * height) > math.radians(40.)
    peaks = [[files.as_number(row.get(key)) for key in ("run", "tables")]
             for row in scene.list_of("table_comparison")
             if row.get("name") == "peak_overpressure"]
    is_lower = any(None not in pair and pair[0] < pair[1] for pair in peaks)
    return may_merge and not is_lower and not is_surface_burst(scene) \
        and not _ground_is_late(scene) and not _is_of_the_ground(scene)


def _ways(charge, place):
    """Lengths of the straight way from charge to place and of that by the
    ground."""
    return math.dist(charge, place), math.hypot(
        *(charge - place)[:2], charge[2] + place[2])


def is_late(scene, place, arrival, time):
    """Whether the ground's reflection comes to a place after a time, even as fast
    as it can: to the ground as the front of the direct wave, which is at the
    place at its arrival, and from there in the flow behind that front, as a wave
    of the same strength."""
    charge = scene.charge_place()
    direct, mirrored = _ways(charge, place)
    peak = _incident_peak(scene)
    if not peak:
        return arrival * mirrored / max(direct, 1e-300) > time
    ground = mirrored * max(charge[2] / max(charge[2] + place[2], 1e-300), 1e-3)

    def duration(begin, end, speed, power):
        # The overpressure of a spherical wave falls faster than one over the
        # radius, and slower than one over its cube.
        radii = np.linspace(begin, end, 200)
        return (end - begin) * np.mean(1. / speed(
            peak / SEA_LEVEL * (direct / radii) ** np.where(
                radii < direct, power, 1.)))
    return arrival + duration(direct, ground, _front_speed, 1.) \
        + duration(ground, mirrored, _following_speed, 3.) > time


def _front_speed(over):
    """Speed of a shock [m/s] by its overpressure in parts of the ambient
    pressure: the relation of Rankine and Hugoniot in standard air."""
    return SOUND_SPEED * np.sqrt(1. + 6. / 7. * over)


def _following_speed(over):
    """Speed of a shock of the same overpressure in the flow behind that one."""
    squared = 1. + 6. / 7. * over
    compression = 6. * squared / (squared + 5.)
    return _front_speed(over) * (1. - 1. / compression) \
        + np.sqrt((1. + over) / compression) * _front_speed(over / (1. + over))


def _incident_peak(scene):
    """Overpressure in the open at the body's distance [Pa], the larger one of
    run and tables; 0 where neither knows it."""
    rows = [row for row in scene.list_of("table_comparison")
            if row.get("name") == "peak_overpressure"]
    known = [files.as_number(row.get(key)) for row in rows
             for key in ("run", "tables")]
    return max((peak for peak in known if peak is not None), default=0.)


def _ground_is_late(scene):
    """Whether it comes to the probe after the positive phase."""
    charge, probe = scene.charge_place(), scene.probe_place(1)
    arrival, duration = (scene.blast.found("results", "probe_1_" + name)
                         for name in ("arrival", "duration"))
    if charge is None or probe is None or not arrival or not duration:
        return False
    return is_late(scene, probe, arrival, arrival + duration)
