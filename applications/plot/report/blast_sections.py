# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The blast in the air and on the skin: pictures, histories, resultant force,
conservation."""

import matplotlib.pyplot as plt
import numpy as np

from plot.readers import files, loads
from plot.analysis import person, signals, wave_times
from plot.figures import (body_loads, body_views, injury_maps, plane_cuts,
                          style)
from plot.report import (error_estimate, injury_table, injury_thresholds,
                         least_phases, page, reflections, unfinished)
from plot.report.injury_thresholds import KNOWN

# Maps of people: the measure with thresholds, its name, and the level whose
# area is told, with what happens there.
PEOPLE = {
    "lung_lethality": ("lung_lethality", "death by lung injury", 0.5,
                       "half of the people would die"),
    "eardrum_rupture": ("ear_rupture", "rupture of an eardrum", 0.5,
                        "half of the eardrums would rupture"),
    "peak_overpressure": ("peak_overpressure", "peak overpressure",
                          4. * injury_maps.PSI, "4 psi are exceeded")}
# Limits by which mapped_injury_values() in C++ knows lungs: part of the impulse in
# a simple wave, and probabilities of death.
SIMPLE, CERTAIN, HARMLESS = 0.75, 0.99, 1e-3
SEEN_BARE = 2e-3  # part of a view, above which a hole is seen


def air(scene):
    """Pressure on plane cuts."""
    found = scene.pressure_planes()
    if not found:
        return [page.missing("plane cuts of pressure in blast/fields")]
    parts = []
    for name, cuts in sorted(found.items()):
        picked = _pick(scene, cuts)
        picture = page.drawn(plane_cuts.draw_planes, picked,
                             one_scale=True)
        axis = name.split("_")[1]
        place = f"{cuts[0].place:g}".replace("-", "−")
        parts.append(page.figure(
            picture,
            f"Maps of overpressure in the plane {axis} = {place} m, after "
            f"{page.moments([cut.time for cut in picked])}; the largest is "
            + page.quantity(plane_cuts.largest_overpressure(picked), "Pa")
            + ".",
            f"Overpressure in the air in the plane {axis} = {place} m, with "
            "one colour scale for all times: red above, blue below the ambient "
            "pressure. Colours follow the square root of the overpressure, "
            "which shows weak waves as well. "
            + ("The body is grey." if _cuts_body(scene, axis, cuts[0].place)
               else "The body is not in this plane.")))
    return parts


def _cuts_body(scene, axis, place):
    """Whether a plane goes through the body, by the centres of its facets; a
    body without recorded loads may be there."""
    known = scene.loads()
    if known is None or known.is_flat or not len(known.areas):
        return True
    along = known.centroids[:, "xyz".index(axis)]
    size = float(np.sqrt(known.areas.max()))
    return along.min() - size < place < along.max() + size


def people(scene):
    """Effects of the blast on people in planes of gauges; nothing where no
    such plane was asked for."""
    known = injury_thresholds.of_run(scene)
    own = {name: known[measure].thresholds for name, (measure, *_)
           in PEOPLE.items() if known[measure].is_own}
    parts = []
    others = scene.coarser.gauge_planes() if scene.coarser else {}
    for plane, maps in scene.gauge_planes().items():
        if not injury_maps.are_in(maps):
            continue
        coarse = others.get(plane, {})
        words = []
        for name, (_, title, level, what) in PEOPLE.items():
            words += [(f"{title} above {_limit(name, limit)} ({meaning})"
                       if meaning else what)
                      + _area(scene, maps, coarse, name, limit)
                      for limit, meaning in own.get(name, [(level, "")])]
        drawn = page.drawn(injury_maps.draw, maps, own={
            name: dict(levels) for name, levels in own.items()})
        parts.append(page.figure(
            drawn,
            "Maps of the probability that an eardrum ruptures, the probability "
            "of death by lung injury, the chest wall velocity and the peak "
            "overpressure.",
            f"What the blast would do to people who stand in {_of_gauges(maps)}, "
            f"{_among_whom(scene)}: " + "; ".join(words)
            + ". " + (
                "Limits by the numerics are from the coarser run, as those of "
                "other figures" if coarse else
                "The numerical error of these areas is unknown")
            + ". Grey, and counted as unknown: the blast has not arrived, the "
            "body or the charge is there, or, of lungs, the blast is not over, "
            "not simple (the first wave has at most "
            f"{page.percent(SIMPLE)} of the impulse) or beside the products of "
            "the explosive, where the duration is open; among these no curve "
            f"was measured. Lungs are known, too, where more than "
            f"{page.percent(CERTAIN)} die by the first wave or fewer than "
            f"{page.percent(HARMLESS)} would by an endless one. Lungs"
            f"{_mass_of_people(scene)} by side-on plus dynamic "
            f"pressure and positive phase ({KNOWN['lung_lethality'].source}), "
            f"eardrums by the peak ({KNOWN['ear_rupture'].source}); "
            f"4 psi: {KNOWN['peak_overpressure'].source}; "
            + ("lines are thresholds of the user's own for "
               + page.joined(PEOPLE[name][1] for name in own) + "; "
               if own else "")
            + "the chest wall velocity: "
            f"{KNOWN['chest_wall_velocity_air'].limits}."
            + _limits_of_velocity(maps) + _step_of_stages(scene)
            + reflections.note_on_maps(scene) + _beside_verdict(scene, maps)))
    return parts


def _beside_verdict(scene, maps):
    """What the map has as far from the charge as the trunk of a person whose
    lungs are judged by the load on the skin."""
    trunk = (scene.facts.get("tables") or {}).get("trunk") or {}
    distance = trunk.get("distance") or scene.fact("distance")
    charge = scene.charge_place()
    found = None if distance is None or charge is None \
        or injury_table.lungs_by(scene) != "skin" else \
        injury_maps.at_distance(maps, "lung_lethality", charge, distance)
    if found is None:
        return ""
    least, largest = map(page.chance, found)
    return (" As far from the charge as the "
            f"{'trunk' if trunk else 'skin'}, {page.quantity(distance, 'm')}, "
            "deaths by lung injury in the map are "
            + (least if least == largest else f"{least} to {largest}")
            + ": of the wave in the open. The verdict on the person is by the "
            "load on the skin.")


def _of_gauges(maps):
    """The plane of the maps and its area in words."""
    plane = next(iter(maps.values()))
    normal, = set("xyz") - set(plane.axes)
    place = f"{plane.place:g}".replace("-", "−")
    return (f"the plane {normal} = {place} m of gauges "
            f"({page.number(injury_maps.area(maps))} m²"
            + (" with its mirror image" if plane.copies > 1 else "") + ")")


def _among_whom(scene):
    """Which bodies the wave of the maps has met."""
    body = "person" if person.is_person(scene) else "body"
    return (f"as if nobody but the meshed {body} were there, "
            f"{'who' if body == 'person' else 'which'} reflects the wave and "
            "shields from it: maps and areas beside and behind "
            f"the {body} are those of the wave so changed"
            if scene.loads() is not None else "as if nobody were there")


def _step_of_stages(scene):
    """Where maps go from the cells of a first stage to larger ones, in words."""
    for row in scene.list_of("audit"):
        if row.get("item") == "first_stage" \
                and str(row.get("found")).endswith(" m"):
            place = row["found"].replace(" ", "\u00a0")
            return (" Peaks may have a step where the first stage ended, "
                    f"within {place} of the charge: it has smaller cells, which "
                    "give higher peaks.")
    return ""


def _limits_of_velocity(maps):
    """Where the run ends before the chest wall is slower, in words."""
    limits = injury_maps.area_of_limits(maps)
    return (f" It is a lower limit (≥, hatched) on {page.number(limits)} m²: the "
            "run ends too early there.") if limits > 0. else ""


def _limit(name, limit):
    """A threshold of the user's own in words."""
    return page.plain(limit, "Pa") if name == "peak_overpressure" \
        else page.plain(100. * limit, "%")


def _area(scene, maps, coarse, name, level):
    """Where a quantity exceeds a level, in words."""
    found = injury_maps.area_above(maps, name, level)
    goes_on = injury_maps.goes_beyond(maps, name, level)
    doubts = ["it continues beyond the plane"] if goes_on else []
    if name in coarse:
        here, there = injury_maps.common_areas_above(maps, coarse, name, level)
        known_there = injury_maps.area_above(coarse, name, level)
        low, high = (page.number(limit) for limit in error_estimate.of_area(
            scene, found, there - here,
            injury_maps.area(maps) - injury_maps.area_unknown(maps, name)))
        if here < COMMON * found or there < COMMON * known_there:
            doubts.append("error unknown: the coarser run knows other places")
        elif str(low) != str(high):
            doubts.append(f"by the numerics at least {low} m²" if goes_on else
                          f"by the numerics {low} to {high} m²")
    unknown = injury_maps.area_unknown(maps, name)
    if unknown > 0.:
        doubts.append(f"unknown on a further {page.number(unknown)} m²")
    return f" on {'at least ' * goes_on}{page.number(found)} m²" + (
        f" ({', '.join(doubts)})" if doubts else "")


def _mass_of_people(scene):
    """By which their lungs are judged, in words."""
    mass = scene.blast.parameter("Loads/Body mass")
    return f" of people of {page.given(mass[0], 'kg')}" if mass else ""


# Least part of an area that two runs must both know, to compare it.
COMMON = 0.5
# Gauges that stand for a part with a verdict, in order.
PLACES = {"eardrums": ("left ear", "right ear"), "lungs": ("chest", "back"),
          "brain": ("forehead", "vertex")}
NOT_REACHED = page.paragraph(unfinished.NOT_REACHED, kind="note")
COLOURS = {"good": "#1f6b3a", "mid": "#8a5a00", "bad": "#a12a1c",
           "none": style.GREY}


def verdict_figure(scene, verdicts):
    """The body with its loads and the parts that have a verdict."""
    known, views = scene.loads(), views_of(scene)
    if known is None or views is None:
        return page.missing("loads.h5 of a body in the blast's folder")
    if not known.arrived().any():
        return NOT_REACHED
    places, marks = known.places(), []
    for one in verdicts:
        ear = one.entry.name.removeprefix("ear_rupture_") if one.entry else ""
        names = [name for name in (ear, *PLACES.get(one.subject, ()))
                 if name in places]
        if not names and one.subject == "brain":
            names = _skin_at_coup(scene, places)
        if names:
            marks.append(body_loads.Mark([places[name] for name in names],
                                         one.label(), COLOURS[one.kind]))
    with files.reading(scene.blast.path("loads.h5")):
        picture = body_loads.verdict_figure(known, views, marks)
        largest = page.quantity(known.largest("peak"), "Pa")
    return page.figure(
        picture, "The body from the sides that the blast loads most, coloured "
        f"by the peak overpressure, {largest} at most"
        + (", with marks at " + page.joined(mark.words for mark in marks)
           if marks else "") + ".", "Peak overpressure on the skin, "
        f"{largest} at most." + _peak_beside_tables(scene)
        + (" Marks have the colour of their verdict: green below all "
           "thresholds, red above all, brown between, or where a threshold lies "
           "within the error, or measures or the tables differ, grey where the "
           "end of the run leaves a part unjudged"
           + ("." if all(mark.is_seen for mark in marks) else
              "; hollow ones are behind what is seen.") if marks else ""))


def _peak_beside_tables(scene):
    """Sentences: place and error of the largest peak on the skin, and the
    reflected peak of the tables."""
    known = scene.loads()
    where = known.centroids[np.nanargmax(known.measure("peak"))]
    text = f" The largest peak is at ({page.point(where, 3)}) m."
    error = error_estimate.of_skin(scene, "peak")[2]
    if error is not None:
        text += f" Its numerical error is {page.error(error)}."
    wall = scene.table_answer("overpressure")[1]
    if wall is not None:
        text += (f" By the tables, {page.quantity(wall, 'Pa')} reach an endless "
                 "wall as far from the charge as the nearest skin.")
    return text


def _skin_at_coup(scene, places):
    """Adds the skin that is nearest to the side of the brain towards the
    charge to places; its name in a list."""
    skin, coup = scene.loads().centroids, [
        row.get("place") for row in scene.list_of("tissue_places")
        if row.get("name") == "coup"]
    if not coup or not len(skin):
        return []
    apart = np.linalg.norm(skin - np.array(coup[0], float), axis=1)
    places["coup"] = skin[int(apart.argmin())]
    return ["coup"]


def views_of(scene):
    """The body from the person's four sides, or None."""
    known = person.axes(scene)
    return body_views.views_of(
        scene.loads(), scene.blast.folder, body_views.NAMELESS
        if known is None else tuple(map(tuple, known)))


def _pick(scene, cuts):
    """Six times around and after the arrival at the body, denser at first."""
    known = scene.loads()
    begin = (known and known.first_arrival()) or 0.
    # The last one before the arrival is the first picture.
    first = max([i for i, cut in enumerate(cuts) if cut.time < begin] or [0])
    later = wave_times.of_planes(cuts[first:], wave_times.SEEN)
    return wave_times.denser(later, wave_times.MOST_PLANES, 2.)


def skin(scene):
    """The body from four sides."""
    known = scene.loads()
    views = views_of(scene)
    if known is None or views is None:
        return [page.missing("loads.h5 of a body in the blast's folder")]
    if not known.arrived().any():
        return [NOT_REACHED]
    with files.reading(scene.blast.path("loads.h5")):
        moments = body_loads.pick_times(known)
        times = page.drawn(body_loads.draw_times, known, views, one_scale=True)
        measures = page.drawn(body_loads.draw_measures, known, views)
        largest = page.quantity(known.largest("peak"), "Pa")
        cut = known.areas[known.cut_off()].sum() / known.areas.sum()
    bare = "" if views.bare_part() < SEEN_BARE else (
        " Even grey: skin that no gas reaches, as that on the ground.")
    return [
        page.figure(times, f"The body: {', '.join(views.names())}, "
                    "coloured by the overpressure on its skin after "
                    f"{page.moments(moments)}.",
                    "Overpressure on the skin while the wave passes, from four "
                    "sides, with one colour scale for all times. Colours "
                    "follow the square root of the overpressure." + bare),
        page.figure(measures, "The body from four sides, coloured by peak "
                    f"overpressure, {largest} at most, by positive impulse "
                    "and by arrival.",
                    "Peak overpressure, impulse of the positive phase and "
                    "arrival of the wave on the skin, over the whole run."
                    + (f" On {page.percent(cut)} of the skin the run ends before "
                       "the positive phase does: impulses there are lower "
                       "limits." if cut > 0. else "") + bare)]


def histories(scene):
    """Overpressure at named places, and the resultant force."""
    gauges = scene.blast.table("load_gauges.csv")
    parts = []
    if scene.has_no_gauges():
        parts.append(page.paragraph(
            "There are no histories on the skin: no place was named (entry "
            "Blast/Loads/Gauges).", kind="note"))
    elif gauges is None or len(gauges.values) < 3 or scene.loads() is None:
        parts.append(page.missing("load_gauges.csv of the blast"))
    elif not scene.loads().arrived().any():
        return [NOT_REACHED]
    else:
        parts.append(page.figure(
            body_loads.gauges_figure(
                gauges, scene.loads(), views_of(scene),
                scene.gauge_measures()),
            "Curves of overpressure over time, one chart for each of "
            + ", ".join(gauges.others("time")) + "; the largest peak is "
            + _largest_peak(scene) + ", and the table below has all peaks.",
            "Overpressure at named places on the skin: mean over the facets "
            "within the radius of a gauge, or of the nearest one (number and "
            "distance are in log.txt of the blast). Dots mark the first peak, triangles the "
            "second one; above the curves both stand with overpressure and "
            "time. The places are numbered on the body, hollow where they are "
            "behind what is seen.", "svg"))
        parts += [_gauge_table(scene, gauges), _gauge_errors(scene, gauges)]
    force = resultant(scene)
    if force is not None:
        parts.append(page.figure(
            _draw_force(*force),
            "Two charts with curves for x, y and z over time: the force on the "
            "body, which reaches "
            + page.quantity(float(np.abs(force[1]).max()), "N")
            + ", and its integral over time.",
            "Resultant force of the overpressure on the whole body along the "
            "three axes, and its cumulative impulse, including drag.", "svg"))
    return parts


def _largest_peak(scene):
    """A peak and its place in words."""
    peaks = {name: measures["peak"] for name, measures
             in scene.gauge_measures().items()}
    name = max(peaks, key=peaks.get, default=None)
    return "unknown" if name is None else \
        f"{page.quantity(peaks[name], 'Pa')} at the {name}"


def _gauge_table(scene, gauges):
    rows = []
    time = gauges["time"]
    for name, measures in scene.gauge_measures().items():
        if measures["peak"] <= 0. or name not in gauges:
            continue
        after = gauges[name][time >= measures["arrival"]]
        lowest = float(after.min())
        is_cut = measures["cut off"] > 0.
        rows.append((
            name, page.number(1e3 * measures["arrival"]),
            page.limit(page.number(1e-3 * measures["peak"]),
                       signals.goes_on(gauges[name])[1]),
            page.limit(page.number(measures["impulse"]), is_cut),
            page.limit(page.number(1e3 * measures["positive phase"]), is_cut),
            page.Rounded(("≤ " if after[-1] == lowest else "")
                         + page.number(1e-3 * lowest), 1e-3 * lowest)
            if lowest < -1. else "–",
            page.number(1e6 * signals.rise_time(time, gauges[name]), 2)))
    header = ("place", "arrival [ms]", "peak [kPa]", "impulse [Pa s]",
              "positive phase [ms]", "minimum [kPa]", "rise time [µs]")
    return page.table(
        header, rows,
        "Arrival: the middle of the first rise. The positive phase lasts "
        "from the arrival, and the impulse from the foot of the rise, until the "
        "overpressure first falls to zero after its peak; ≥ means that the run ended before. Minimum: of what follows the "
        "arrival; a dash means that the pressure does not fall below the ambient "
        "pressure before the end of the run, ≤ that it falls until then. Rise "
        "time: from a tenth to nine tenths of the first peak; cells and "
        "patches lengthen it.", numbers=range(1, 7),
        data=(header + ("positive phase",),
              [row + ("cut by the end of the run" if row[4].startswith("≥")
                      else "complete",) for row in rows]))


def _gauge_errors(scene, gauges):
    """Errors of the table of gauges, a row each."""
    errors = error_estimate.of_scene_gauges(
        scene, least_phases.of_fewer_waves(scene))
    if not errors:
        return page.paragraph("The numerical errors of this table are unknown: "
                              "the scene has no coarser run.", kind="note")
    known = scene.gauge_measures()
    least = least_phases.of_skin(scene)
    rows = [(name, *(page.error(errors[name][measure])
                     if measure in errors.get(name, {}) else "unknown"
                     for measure in error_estimate.GAUGE_MEASURES),
             page.milliseconds(least[name]) if name in least else "–")
            for name, measures in known.items()
            if measures["peak"] > 0. and name in gauges]
    return page.table(
        ("place", "error of peak", "error of impulse",
         "error of positive phase", "least positive phase"), rows,
        "Numerical errors, estimated from the coarser run; each is at least the "
        "median of its column. Where the pressure dips and rises again within "
        "the positive phase of this run or of the coarser one, errors of impulse "
        "and phase do not hold if finer cells may let it fall to zero in the "
        "dip, after the least positive phase: where the dip is below zero, or "
        "above it by less than its error, or in one run alone. A dash: no such dip shows; cells that "
        "merge two waves hide it, too. Unknown where a run ends before the phase "
        "does, or the phase of the coarser one alone has a later "
        "wave.",
        numbers=(1, 2, 3, 4))


def resultant(scene):
    """Times and force [N] of the overpressure on the whole body, or None."""
    known = scene.loads()
    if known is None or known.is_flat or not len(known.areas):
        return None
    force = np.zeros((len(known.times), 3))
    weights = known.normals * known.areas[:, None]
    block = 4096
    with files.reading(scene.blast.path("loads.h5")):
        for begin in range(0, len(known.areas), block):
            part = known.file["overpressure"][begin:begin + block]
            force -= part.T.astype(float) @ weights[begin:begin + block]
    force *= scene.mirror_factor()
    for axis, _ in loads.mirror_planes(
            scene.blast.folder, known.centroids):
        force[:, axis] = 0.
    return known.times, force


def _draw_force(time, force):
    steps = np.diff(time, prepend=0.)[:, None]
    impulse = np.cumsum(force * steps, axis=0)
    figure, axes = plt.subplots(1, 2, figsize=(9., 3.3))
    for axis, values, name, unit in (
            (axes[0], 1e-3 * force, "force", "kN"),
            (axes[1], impulse, "cumulative impulse", "N s")):
        for d, colour in zip(range(3), style.COLOURS):
            axis.plot(1e3 * time, values[:, d], color=colour,
                      label="xyz"[d], linewidth=1.2)
        axis.set_xlabel("time [ms]")
        axis.set_ylabel(f"{name} [{unit}]")
        axis.legend()
    return figure


def conservation(scene):
    """Mass and energy of the gas, and checks of the loads."""
    summary = scene.blast.summary
    if not summary:
        return [page.missing("summary.json of the blast")]
    rows = []
    totals = summary.get("conservation") or {}
    for key, value in totals.items():
        if not key.endswith("_first"):
            continue
        name = key[:-len("_first")]
        last = files.as_number(totals.get(name + "_last"))
        change = files.as_number(
            totals.get(name + "_relative_change"))
        unit = "J" if "energy" in name else "kg"
        value = files.as_number(value)
        if value is None or last is None or change is None:
            continue
        rows.append((name.replace("_", " "), page.quantity(value, unit, 4),
                     page.quantity(last, unit, 4),
                     page.percent(change, 3)))
    parts = [page.table(
        ("total in the domain", "at the start", "at the end", "change"),
        rows, _computed_part(scene), numbers=(1, 2, 3))]
    parts.append(page.paragraph(_open_sides(scene)))
    rows = []
    for name, text in (
            ("loads_impulse_difference", "impulse on the body: recorded on the "
             "facets against momentum lost by the gas"),
            ("loads_force_difference", "force on the body: recorded on the "
             "facets against momentum lost by the gas, root mean square over "
             "time"),
            ("loads_sampled_peak_loss", "peak on the worst facet or gauge: "
             "fraction missed by the recorded samples")):
        value = scene.blast.found("checks", name)
        if value is not None:
            rows.append((text, page.percent(value)))
    if rows:
        parts.append(page.table(("check of the loads", "difference"), rows,
                                numbers=(1,)))
    return parts


def _computed_part(scene):
    """Which part of the gas the totals are of, where that is not all."""
    part = {2: "half", 4: "quarter", 8: "eighth"}.get(scene.mirror_factor())
    return f"Of the {part} of gas and charge that is computed, on one side of " \
        "each plane of symmetry." if part else ""


def _open_sides(scene):
    sides = [key.split("/")[1] for key, value
             in scene.blast.parameters.items()
             if key.startswith("Boundaries/") and value == "open"]
    if not sides:
        return ("No side of the domain is open: any change is a numerical "
                "error.")
    return (("The sides " if len(sides) > 1 else "The side ")
            + page.joined(sorted(sides))
            + (" are" if len(sides) > 1 else " is") + " open. Gas that leaves "
            "the domain there is part of the change. In closed domains, tests "
            "of the code show that mass and energy are conserved to 10⁻¹² in "
            "double and 10⁻⁷ in single precision.")
