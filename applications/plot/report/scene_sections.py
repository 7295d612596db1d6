# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The scene drawn to scale, and what happens when."""

import re
from typing import NamedTuple

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle

from plot.analysis import person, signals, tissue_places
from plot.readers import files
from plot.figures import body_views, style
from plot.report import page, reflections, unfinished

# kg/m^3, for the size of the charge on the drawing.
EXPLOSIVE_DENSITY = {"tnt": 1630., "c-4": 1601., "petn": 1770.}
SLOW_RISE = 2e-4  # of a pressure in tissue, told from here on [s]
SOLID = "#cfc9be"  # colour of ground and walls


def facts(scene):
    """A table of what the scene is."""
    mass, place = scene.charge_mass(), scene.charge_place()
    what, symmetry = scene.explosive_name(), scene.facts.get("symmetry")
    rows = [("charge", mass and page.Rounded(
        f"{page.given(mass, 'kg')} of {what}", mass, f"kg of {what}"))]
    if place is not None:
        shown = page.point(place)
        rows.append(("centre of the charge",
                     page.Rounded(f"({shown}) m", shown.value, "m")))
    rows += [(name, page.given(scene.fact(key), "m")) for name, key in (
        ("distance to the body", "distance"),
        ("height above ground", "height"),
        ("distance to the skin along x", "distance_along_x"))
             if scene.fact(key) is not None]
    rows += [("body", scene.facts.get("body")),
             ("person" if person.is_person(scene) else "size of the body",
              person.words(scene))]
    if person.place_of_charge(scene) != "from":
        rows.append(("side of the charge", ", ".join(filter(None, (
            person.place_of_charge(scene) + " the person",
            person.azimuth_of_charge(scene),
            person.elevation_of_charge(scene))))))
    for name, unit in (("Rotation", "degrees about x, y, z"), ("Shift", "m")):
        value = scene.parameters.get(f"Body/{name}")
        if value and np.any(files.points_of(value)):
            rows.append((f"{name.lower()} of the body",
                         ", ".join(map(str.strip, value.split(","))) + f" {unit}"))
    rows.append(("plane of symmetry", f"{symmetry} = 0"
                 if symmetry in ("x", "y", "z") else symmetry))
    rows += [("side of the domain", wall) for wall in reflections.walls(scene)]
    rows += [("end of the run", _thousandths(scene.fact("end_time"), "s")),
             ("question", scene.facts.get("question")),
             ("accuracy", scene.facts.get("accuracy")),
             ("gas cells at the skin", _thousandths(
                 scene.fact("cell_size_at_body") or None, "m"))]
    if scene.element_size() and not scene.asks_for_loads():
        rows.append(("mean edge of the body's own hexahedra"
                     if scene.has_own_mesh() else "elements of the body",
                     _thousandths(float(f"{scene.element_size():.3g}"), "m")))
    return page.table(("item", "value"), [
        (name, value) for name, value in rows if value not in (None, "", "–")])


def _thousandths(value, unit):
    """A length in millimetres, a time in milliseconds; None if unknown."""
    return None if value is None else page.Rounded(
        page.given(1e3 * value, f"m{unit}"), value, unit)


def section(scene):
    """Facts and drawing."""
    parts = [facts(scene)]
    if changes := scene.list_of("changes"):
        parts.append(page.table(
            ("entry of the user's own", "value", "otherwise"),
            [(page.tag("code", row.get("entry", "")), row.get("value", ""),
              row.get("before", "")) for row in changes]))
    remarks = [_sentence(str(remark))
               for remark in scene.facts.get("remarks") or []
               # Those stand in the list of warnings.
               if not str(remark).startswith("WARNING")]
    if scene.facts.get("body") == "image":
        remarks.append("The body ends where the images end, and the blast "
                       "passes there as well.")
    if remarks:
        parts.append(page.bullets(remarks))
    if scene.charge_place() is None:
        return parts + [page.missing("the place of the charge, so that nothing "
                                     "can be drawn")]
    ways = "" if _target(scene) is None else (
        "The solid line is the path of the direct wave to the nearest skin, "
        + ("whose reflection by the ground would come after the end of the run. "
           if _ground_is_late(scene) else "which the body keeps from the "
           "reflection by the ground. " if _ground_is_hidden(scene) else
           "the dashed line the path of its reflection by the ground to the "
           "same place. "))
    return parts + [page.figure(
        _draw(scene), f"Drawing of the {scene.explosive_name()} charge, "
        f"{page.given(float(scene.charge_place()[2]), 'm')} above the "
        "ground, and of the body before it, seen from the side.",
        f"The scene from the side, to scale. {ways}{_beside(scene)}Grey: the "
        "skin that the blast loads."
        + (" Above the picture: walls; arrows lead to those beyond its border."
           if reflections.walls(scene) else ""), "svg")]


def _beside(scene):
    """Why drawn ways are shorter than they are told, where they are."""
    if _target(scene) is None:
        return ""
    way = scene.charge_place() - _target(scene)
    # The picture is seen from -y.
    behind, way = float(way[1]), float(np.linalg.norm(way))
    return "" if way < 1.02 * np.sqrt(max(way**2 - behind**2, 0.)) else (
        f"The charge is {page.given(float(f'{abs(behind):.3g}'), 'm')} "
        f"{'behind' if behind > 0. else 'before'} that place, and lengths are "
        "those in space. ")


def _sentence(text):
    """A line of the log as a sentence on a page."""
    text = text.replace("m^2", "m²").replace("m^3", "m³")
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")


def _draw(scene):
    charge, target = scene.charge_place(), _target(scene)
    figure, axis = plt.subplots(figsize=(8.4, 5.2))
    corners = np.array([charge[[0, 2]], *_draw_body(scene, axis)])
    has_ground = not _ground_is_late(scene)
    bottom = 0. if has_ground else corners[:, 1].min() - 0.3
    top = corners[:, 1].max() + 0.5
    left, right = corners[:, 0].min() - 0.4, corners[:, 0].max() + 0.5
    if has_ground:
        # As high as the words on it need.
        bottom = -max(0.08 * top, 0.045 * (right - left))
        axis.axhspan(bottom, 0., color=SOLID, linewidth=0.)
    side = max(0., 0.8 * (top - bottom) - (right - left)) / 2.
    axis.set(xlim=(left - side, right + side), ylim=(bottom, top),
             aspect="equal", xlabel="x [m]", ylabel="z [m]")
    _draw_walls(scene, axis)
    # Words stand on that side of the charge where no way begins.
    away = -1. if target is not None and charge[0] < target[0] else 1.
    _draw_charge(scene, axis, away, has_ground)
    if target is not None:
        _draw_ways(scene, axis, away, has_ground)
    return figure


def _target(scene):
    """The skin that is nearest to the charge, where the drawn ways end."""
    known = scene.loads()
    if known is None or known.is_flat or not len(known.areas):
        return None
    if scene.facts.get("nearest_skin"):
        return np.array(scene.facts["nearest_skin"])
    return known.centroids[np.linalg.norm(
        known.centroids - scene.charge_place(), axis=1).argmin()]


def _ground_is_late(scene):
    """Whether the reflection by the ground reaches the skin that is nearest to
    the charge after the end of the run."""
    end = scene.fact("end_time")
    if _target(scene) is None or end is None:
        return False
    first = scene.loads().first_arrival()
    return first is not None and reflections.is_late(scene, first, end)


def _ground_is_hidden(scene):
    """Whether the reflection by the ground would come to the skin that is
    nearest to the charge from within the body."""
    charge, target = scene.charge_place(), _target(scene)
    return target is not None and bool(
        (charge * [1., 1., -1.] - target) @ (charge - target) <= 0.)


def _draw_body(scene, axis):
    """Its lower left and upper right corner; nothing without a body."""
    views = body_views.views_of(scene.loads(), scene.blast.folder)
    if views is None:
        return []
    side = [view[0] for view in body_views.VIEWS].index("right")
    low = np.array(views.sides[side].origin)
    high = low + views.side_extent(side)
    axis.imshow(views.paint_side(side), zorder=1, interpolation="bilinear",
                extent=(low[0], high[0], low[1], high[1]))
    axis.grid(False)
    return [low, high]


def _draw_walls(scene, axis):
    """Walls within the picture, and words for all of them above it."""
    told = {"left": [], "right": []}
    for side, words in reflections.wall_sides(scene):
        direction, end = side.split("_")
        if side == "z_low":
            continue  # the ground
        align = "right" if side in ("x_high", "y_high") else "left"
        # The picture is seen from -y.
        limits, span = (axis.get_xlim(), axis.axvspan) if direction == "x" \
            else (axis.get_ylim(), axis.axhspan)
        if direction == "y":
            words += ", behind" if end == "high" else ", before it"
        elif limits[0] < (place := float(re.search(
                r"= (\S+) m", words)[1])) < limits[1]:
            span(place, limits[end == "high"], color=SOLID, linewidth=0.)
        else:
            arrow = {"x_low": "←", "x_high": "→", "z_high": "↑"}[side]
            words = f"{words} {arrow}" if align == "right" else f"{arrow} {words}"
        told[align].append(words)
    for align, lines in told.items():
        axis.annotate("\n".join(lines), (float(align == "right"), 1.), (0., 4.),
                      xycoords="axes fraction", textcoords="offset points",
                      ha=align, va="bottom", fontsize=9)


def _draw_charge(scene, axis, away, has_ground):
    """The charge, what it is and how high."""
    charge, mass = scene.charge_place(), scene.charge_mass()
    density = EXPLOSIVE_DENSITY.get(scene.explosive().lower(), 1600.)
    radius = (3. * (mass or 1.) / (4. * np.pi * density)) ** (1. / 3.)
    sides = {"ha": "left" if away > 0. else "right",
             "textcoords": "offset points"}
    height = page.given(float(charge[2]), "m")
    axis.add_patch(Circle((charge[0], charge[2]), radius, zorder=4,
                          color=style.COLOURS[1]))
    _widen(axis, axis.annotate(
        f"{page.given(mass, 'kg')} {scene.explosive_name()}"
        + ("" if has_ground else f"\n{height} above the ground"),
        (charge[0], charge[2] + radius), (6. * away, 6.), va="bottom", **sides))
    if has_ground:
        axis.annotate("", (charge[0], 0.), (charge[0], charge[2]),
                      arrowprops={"arrowstyle": "<->", "color": style.GREY})
        beside = away * radius * (charge[2] < 3. * radius)  # of a low disc
        axis.annotate(height, (charge[0] + beside, 0.5 * charge[2]), (
            8. * away, 0.), va="center", color=style.GREY, **sides)


def _widen(axis, label):
    """Makes room for a label at the side."""
    for _ in range(4):  # a wider picture has a smaller scale
        axis.apply_aspect()
        box = label.get_window_extent().transformed(axis.transData.inverted())
        left, right = axis.get_xlim()
        axis.set_xlim(min(left, box.x0), max(right, box.x1))


def _draw_ways(scene, axis, away, has_ground):
    """Ways of the direct and of the reflected wave to the nearest skin, with
    their lengths."""
    charge, target = scene.charge_place(), _target(scene)
    line = {"color": style.COLOURS[0], "linewidth": 1.2}
    direct = scene.fact("distance") or np.linalg.norm(charge - target)
    axis.plot([charge[0], target[0]], [charge[2], target[2]], **line)
    middle = 0.5 * (charge + target)
    # Above the line, where the way by the ground never is, towards the end to
    # which it falls.
    end = -away if target[2] <= charge[2] else away
    axis.annotate(page.given(direct, "m", 3), (middle[0], middle[2]),
                  (2. * end, 4.), textcoords="offset points",
                  ha="right" if end < 0. else "left", va="bottom",
                  color=style.COLOURS[0])
    if not has_ground or _ground_is_hidden(scene):
        return
    bent = np.linalg.norm(charge * [1., 1., -1.] - target)
    ground = charge[0] + charge[2] / (charge[2] + target[2]) * (
        target[0] - charge[0])
    axis.plot([charge[0], ground, target[0]], [charge[2], 0., target[2]],
              linestyle="--", **line)
    axis.annotate(f"{page.given(bent, 'm', 3)} by the ground",
                  (ground, 0.5 * axis.get_ylim()[0]), ha="center",
                  va="center", color="black", fontsize=9)


class Event(NamedTuple):
    """Something that happened: a bar from begin to end, or a moment."""
    lane: str
    what: str
    begin: float
    end: float = None
    mark: float = None
    detail: str = ""
    is_cut: bool = False  # whether it continues after the run

    def last(self):
        """The last of its times [s]."""
        return max(time for time in (self.begin, self.end, self.mark)
                   if time is not None)


def events(scene):
    """All events, by lanes: in the air, on the skin, in the tissue."""
    # The first stage ends before the front meets the ground, another before it
    # meets the body.
    hand_overs = re.findall(
        r"first stage ends at (\S+) s with its front at (\S+) m",
        scene.blast.log())
    return [Event("air", "detonation", 0.), *(
        Event("air", f"front {float(radius):.2f} m from the charge", float(time),
              detail="end of a first stage in fewer dimensions")
        for time, radius in hand_overs),
            *_skin_events(scene), *_tissue_events(scene)]


def _skin_events(scene):
    gauges = scene.blast.table("load_gauges.csv")
    found = []
    for name, measures in scene.gauge_measures().items() if gauges else ():
        if measures["peak"] <= 0. or name not in gauges:
            continue
        _, second = signals.peaks_of_steps(gauges["time"], gauges[name],
                                           measures)
        found.append(Event(
            "skin", name, measures["arrival"],
            measures["arrival"] + measures["positive phase"],
            second and second[0],
            f"peak {page.quantity(measures['peak'], 'Pa')}, impulse "
            + page.limit(page.quantity(measures["impulse"], "Pa s"),
                         measures["cut off"] > 0.),
            measures["cut off"] > 0.))
    return sorted(found, key=lambda event: event.begin)


def _tissue_events(scene):
    probes, found = scene.biomechanics.table("probes.csv"), []
    if probes is None:
        return found
    # The recorded time at which biomechanics begins.
    time = probes["time"] + (scene.biomechanics.parameter(
        "Loads/Recorded/Time offset") or [0.])[0]
    for place in tissue_places.find_places(scene):
        values = place.pressure(probes)
        begin = signals.arrival(time, values)
        if begin is None:
            continue
        near = (time >= begin) & (time <= begin + signals.FIRST_WAVES)
        largest = int(np.argmax(np.where(near, np.abs(values), 0.)))
        found.append(Event(
            "tissue", place.title(), begin, None, float(time[largest]),
            f"{page.quantity(float(values[largest]), 'Pa')} then; "
            + " to ".join(
                page.limit(page.quantity(bound, "Pa"), is_last) for bound, is_last
                in zip(signals.extremes(values), signals.goes_on(values)))
            + " over the whole run" + _slow_rise(time, values)))
    return sorted(found, key=lambda event: event.begin)


def _slow_rise(time, values):
    """How long the rise lasts whose middle is called the arrival, a clause; ""
    for a fast one."""
    span = signals.arrival_span(time, values)
    return "" if span < SLOW_RISE else \
        f"; the arrival is the middle of a rise of {page.quantity(span, 's', 2)}"


def timeline(scene):
    """Picture and table of the events."""
    found = events(scene)
    if len(found) < 2:
        return [page.missing("histories of the blast and of biomechanics")]
    rows, in_order = [], sorted(found, key=lambda event: event.begin)
    for event in in_order:
        if event.lane == "skin":
            text = f"{event.what}: the wave arrives"
            if event.mark is not None:
                text += f", second peak at {page.milliseconds(event.mark)}"
            text += ", positive phase " + (
                "continues at the end of the run" if event.is_cut else
                f"ends at {page.milliseconds(event.end)}")
        elif event.lane == "tissue":
            text = (f"{event.what}: the wave arrives, the magnitude of the "
                    "overpressure within 2.5 ms is largest at "
                    + page.milliseconds(event.mark))
        else:
            text = event.what
        rows.append((page.milliseconds(event.begin), text, event.detail))
    return [_timeline_chart(scene, found), page.folded_table(
        "All events as a table", page.table(
            ("time", "event", "values"), rows, numbers=(0,), data=(
                ("place", "medium", "begin [s]", "end of the positive phase "
                 "[s]", "second peak or largest pressure [s]", "values"),
                [(event.what, event.lane, *(
                    "" if time is None else page.Rounded("", time) for time in
                    (event.begin, None if event.is_cut else event.end,
                     event.mark)), event.detail) for event in in_order])))]


def _timeline_chart(scene, found):
    """Picture of the events on skin and in tissue, or why there is none."""
    lanes = {event.lane for event in found}
    if lanes == {"air"}:
        return page.paragraph(_unnamed(scene), kind="note")
    caption = "Events since the detonation. "
    if "skin" in lanes:
        caption += ("Bars: positive phases on the skin; triangles: peak "
                    "of a second wave, reflected by the ground, walls or the "
                    "body, or sent by the charge itself. ")
    if "tissue" in lanes:
        caption += ("Lines: from the arrival in the tissue, which is slow in "
                    "lungs, to the largest magnitude of the overpressure within 2.5 ms. ")
    rises = _rises(scene)
    if rises:
        caption += ("Arrivals are the middle of the first rise, which lasts "
                    f"{page.quantity(float(np.median(rises)), 's', 2)} (median "
                    "on the skin): events that are closer, or in tissue within "
                    "their own rise, have no order. ")
    return page.figure(
        _draw_timeline(found), "Chart of events on a time axis, one row for "
        "each place on the skin and in the tissue, from "
        f"{page.milliseconds(min(event.begin for event in found))} to "
        + page.milliseconds(max(event.last() for event in found))
        + "; the table below lists them.", caption + "Dotted lines: (a) "
        + "; ".join(f"({'abcdefgh'[i + 1]}) {event.what}" if i >= 0 else
                    event.what for i, event in enumerate(
                        (event for event in found if event.lane == "air"),
                        -1)) + "."
        + tissue_places.thin_note([event.what for event in found]), "svg")


def _unnamed(scene):
    """Sentence on a wave that arrives at no named place."""
    known = scene.loads()
    first = known and known.first_arrival()
    if first is None:
        return unfinished.NOT_REACHED
    return (f"The wave reaches the skin at {page.milliseconds(first)}; no place "
            "on the skin or in the tissue is named.")


def _rises(scene):
    """Durations of the first rise at all gauges that the wave reaches [s]."""
    gauges = scene.blast.table("load_gauges.csv")
    return [signals.rise_time(gauges["time"], gauges[name])
            for name in (gauges.others("time") if gauges else ())
            if gauges[name].max() > 0.]


def _draw_timeline(found):
    last = max(event.last() for event in found)
    rows = [event for event in found if event.lane != "air"]
    figure, axis = plt.subplots(figsize=(9., 0.185 * len(rows) + 1.2))
    for row, event in enumerate(rows):
        if event.lane == "skin":
            axis.barh(row, 1e3 * (event.end - event.begin),
                      left=1e3 * event.begin, height=0.6,
                      color=style.COLOURS[0], alpha=0.75)
            if event.mark is not None:
                axis.plot(1e3 * event.mark, row, marker="v", markersize=5,
                          color="white", markeredgecolor="black",
                          markeredgewidth=0.7)
        else:
            axis.plot([1e3 * event.begin, 1e3 * event.mark], [row, row],
                      color=style.COLOURS[1], marker="|", linewidth=2.)
            axis.plot(1e3 * event.mark, row, marker="o", markersize=4,
                      color=style.COLOURS[1])
    groups = []  # letters of nearly equal times, and the first of these
    for letter, event in zip("abcdefgh", (event for event in found
                                          if event.lane == "air")):
        axis.axvline(1e3 * event.begin, color="black", linewidth=0.9,
                     linestyle=":")
        if groups and event.begin - groups[-1][1] < \
                0.04 * last * len(groups[-1][0]):
            groups[-1][0].append(letter)
        else:
            groups.append(([letter], event.begin))
    for letters, begin in groups:
        axis.annotate(f"({', '.join(letters)})", (1e3 * begin, -0.65), (0, 3),
                      textcoords="offset points", fontsize=9,
                      ha="center" if len(letters) == 1 else "left",
                      annotation_clip=False)
    axis.set_yticks(range(len(rows)), [event.what for event in rows])
    axis.set(xlim=(0., 1.03e3 * last), ylim=(len(rows) - 0.4, -0.8),
             xlabel="time since the detonation [ms]")
    axis.grid(axis="y", visible=False)
    return figure
