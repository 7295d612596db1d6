# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of loads on a rigid body, and of their histories at named places."""

import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm, Normalize

from plot.readers import tables
from plot.readers.loads import Loads
from plot.analysis import signals
from plot.figures import body_views, style

MOST_TIMES = 6


def draw(folder, pictures):
    """All pictures of the loads of a run, if it recorded some."""
    path = os.path.join(folder, "loads.h5")
    if not os.path.exists(path):
        return
    loads = Loads(path)
    if len(loads.areas) and not loads.arrived().any():
        print("no pictures of loads: the blast does not reach the body")
        return
    views = body_views.views_of(loads, folder)
    if views is not None:
        draw_times(loads, views, os.path.join(pictures, "body_pressure.png"))
        draw_measures(loads, views, os.path.join(pictures, "body_maps.png"))
    gauges = tables.open_table(folder, "load_gauges.csv")
    if gauges is not None:
        draw_gauges(gauges, loads, views,
                    os.path.join(pictures, "body_gauges.png"))


def pick_times(loads):
    """Times from when the front meets the body until it has passed it, denser
    at the beginning."""
    first, last = np.nanpercentile(loads.measure("arrival"), [2., 98.])
    parts = np.linspace(0.15, 1., MOST_TIMES) ** 1.5
    times = first + 1.6 * (last - first) * parts
    return np.unique(np.minimum(times, loads.times[-1]))


def draw_times(loads, views, path, one_scale=False):
    """Overpressure at up to six times, each with its own colour scale or all
    with one."""
    times = pick_times(loads)
    columns = min(3, len(times))
    rows = -(-len(times) // columns)
    figure, axes = _panels(views, rows, columns)
    shown = [loads.overpressure(time) for time in times]
    # Corners, as between foot and ground, are off the scale that matters.
    spans = np.array([np.percentile(values, [0.2, 99.5]) for values in shown])
    if one_scale:
        spans[:] = spans[:, 0].min(), spans[:, 1].max()
    for number, (axis, time, values, (low, high)) in enumerate(
            zip(axes, times, shown, spans), 1):
        factor, unit = style.scale_unit("Pa", max(-low, high))
        low, high = low * factor, high * factor
        _draw_body(figure, axis, views, values * factor,
                   *style.signed_scale(low, high), unit,
                   None if not one_scale else
                   # One scale of all stands at the end of each row.
                   [one * factor for one in shown]
                   if number % columns == 0 or number == len(times) else [])
        time_factor, time_unit = style.scale_unit("s", times[-1])
        axis.set_title(f"{time * time_factor:.3g} {time_unit}")
    figure.suptitle("Overpressure on the body", x=0.01, ha="left")
    style.save(figure, path)


def draw_measures(loads, views, path):
    names = [name for name in ("peak", "impulse", "arrival") if name in loads]
    figure, axes = _panels(views, 1, len(names))
    titles = {"peak": "peak overpressure", "impulse": "positive impulse",
              "arrival": "arrival"}
    units = {"peak": "Pa", "impulse": "Pa s", "arrival": "s"}
    for axis, name in zip(axes, names):
        values = loads.measure(name)
        axis.set_title(titles[name])
        low, high = np.nanpercentile(values, [1., 99.5])
        factor, unit = style.scale_unit(units[name], high)
        low, high = low * factor, high * factor
        is_wide = name != "arrival" and high > 5. * low > 0.
        norm = (LogNorm if is_wide else Normalize)(
            low, high if high > low else low + 1.)
        _draw_body(figure, axis, views, values * factor, norm,
                   plt.get_cmap(style.SEQUENTIAL), unit)
    style.save(figure, path)


class Mark:
    """A part of the body with a verdict: where it may be marked, the best place
    first; words, a colour."""

    def __init__(self, places, words, colour):
        self.places, self.words, self.colour = places, words, colour
        self.is_seen = True

    def spot(self, views, sides):
        """The first of its places that one of these sides shows: the side, and
        where that is in its view; or where the first place is behind what the
        first side shows."""
        for place in self.places:
            for side in sides:
                found = views.spot(side, place)
                if found is not None:
                    return side, found
        self.is_seen = False
        return sides[0], views.spot(sides[0], self.places[0], True)


def verdict_figure(loads, views, marks):
    """The body from the two sides that the blast loads most, coloured by its
    peak overpressure, with the parts that have a verdict."""
    values = loads.measure("peak")
    factor, unit = style.scale_unit("Pa", loads.largest("peak"))
    low, high = np.nanpercentile(values, [1., 99.5]) * factor
    norm = Normalize(min(low, 0.), high if high > low else low + 1.)
    sides = views.loaded_sides(np.nan_to_num(values) * loads.areas)
    figure, axes = plt.subplots(1, 2, figsize=(3.9, 4.2))
    # Both at one scale.
    widest, highest = np.max([views.side_extent(side) for side in sides],
                             axis=0)
    spots = [(mark, *mark.spot(views, sides)) for mark in marks]
    for axis, side in zip(axes, sides):
        axis.set_axis_off()
        width, height = views.side_extent(side)
        axis.imshow(views.paint_side(side, values * factor, norm,
                                     plt.get_cmap(style.SEQUENTIAL)),
                    extent=(0., width, 0., height))
        axis.set_xlim(0.5 * (width - widest), 0.5 * (width + widest))
        axis.set_ylim(0.5 * (height - highest), 0.5 * (height + highest))
        axis.set_title(views.names()[side], fontsize=10)
        level = np.inf
        for mark, _, spot in sorted(
                (one for one in spots if one[1] == side),
                key=lambda one: -one[2][1]):
            level = min(spot[1], level - 0.075 * height)
            # Hollow where it is behind what is seen.
            axis.plot(*spot, marker="o", markersize=6,
                      color=mark.colour if mark.is_seen else "white",
                      markeredgecolor="white" if mark.is_seen
                      else mark.colour)
            axis.annotate(
                mark.words, spot, (1.05 * width, level), fontsize=9,
                color=mark.colour, va="center", weight="bold",
                arrowprops={"arrowstyle": "-", "linewidth": 0.6,
                            "color": mark.colour})
    bar = figure.colorbar(plt.cm.ScalarMappable(norm, style.SEQUENTIAL),
                          ax=axes, location="bottom", shrink=0.8, aspect=30,
                          extend=style.beyond(views.means(values) * factor,
                                              norm))
    bar.set_label(f"peak overpressure [{unit}]", fontsize=9)
    bar.outline.set_visible(False)
    return figure


def _panels(views, rows, columns):
    """Axes for pictures of the body from all sides."""
    width, height = views.extent()
    side = 3.25
    figure, axes = plt.subplots(
        rows, columns, squeeze=False,
        figsize=(side * columns, (side - 0.5) * rows * height / width
                 + 0.7 * rows + 0.2))
    for axis in axes.flat:
        axis.set_axis_off()
    return figure, list(axes.flat)


def _draw_body(figure, axis, views, values, norm, colours, unit, bar_of=None):
    """The body from all sides, in the colours of values of its facets. @p
    bar_of: values of all pictures that share the bar, none without a bar."""
    picture = views.paint(values, norm, colours)
    axis.set_axis_on()
    axis.set_xticks([])
    axis.set_yticks([])
    for spine in axis.spines.values():
        spine.set_visible(False)
    axis.grid(False)
    axis.imshow(picture, extent=(0., views.extent()[0], 0.,
                                 views.extent()[1]))
    for name, place in views.labels():
        axis.annotate(name, (place, 0.), (0, -4), textcoords="offset points",
                      ha="center", va="top", fontsize=9, color=style.GREY)
    if bar_of is None:
        bar_of = [values]
    if not bar_of:
        return
    means = np.concatenate([views.means(part) for part in bar_of])
    bar = figure.colorbar(
        plt.cm.ScalarMappable(norm, colours),
        cax=axis.inset_axes([1.02, 0.05, 0.025, 0.9]),
        extend=style.beyond(means, norm))
    bar.set_label(unit, fontsize=9)
    bar.ax.tick_params(labelsize=9)
    if isinstance(norm, LogNorm):
        style.label_decades(bar.ax.yaxis)
    bar.outline.set_visible(False)


def draw_gauges(gauges, loads, views, path):
    """Saves gauges_figure(), if there are places and times."""
    if gauges.others("time") and len(gauges["time"]) >= 3:
        style.save(gauges_figure(gauges, loads, views), path)


def gauges_figure(gauges, loads, views, measures=None):
    """A panel for each place; the body with the places next to them. @p
    measures: those of gauge_measures.csv by place, whose peaks are of every
    step."""
    names = gauges.others("time")
    columns = min(len(names), 2 if len(names) < 5 else 3)
    rows = -(-len(names) // columns)
    width = 2.6 * columns
    figure = plt.figure(
        figsize=(width + 2.4 * (views is not None),
                 max(1.6 * rows, 3.) + 0.9))
    part = figure
    if views is not None:
        body, part = figure.subfigures(1, 2, width_ratios=[2.4, width])
        _draw_places(body, loads, views, names)
    axes = part.subplots(rows, columns, squeeze=False, sharex=True)
    for axis in axes.flat[len(names):]:
        axis.set_axis_off()
    shown = _time_span(gauges, names)
    time_factor, time_unit = style.scale_unit("s", gauges["time"][-1])
    for number, (axis, name) in enumerate(zip(axes.flat, names)):
        told = _draw_history(axis, gauges, name, style.COLOURS[number % 6],
                             (measures or {}).get(name, {}))
        axis.set_title(f"{number + 1}  {name}", fontsize=10, pad=16)
        axis.annotate(told, (0., 1.), (0, 3), xycoords="axes fraction",
                      textcoords="offset points", fontsize=8) \
            .set_in_layout(False)
        axis.set_xlim(shown[0] * time_factor, shown[1] * time_factor)
        if number + columns >= len(names):
            axis.set_xlabel(style.label("time", time_unit))
            axis.tick_params(labelbottom=True)
    figure.suptitle("Overpressure at places on the body; ● first and ▼ second "
                    "peak", x=0.01, ha="left")
    return figure


def _time_span(gauges, names):
    """From shortly before the first arrival to the end."""
    time = gauges["time"]
    over = np.abs(np.stack([gauges[name] for name in names]))
    arrived = np.flatnonzero(over.max(axis=0) > 0.01 * over.max())
    begin = time[arrived[0]] if arrived.size else time[0]
    return max(begin - 0.05 * (time[-1] - begin), time[0]), time[-1]


def _draw_history(axis, gauges, name, colour, measures):
    """The curve with its peaks marked; what they are, in words."""
    time, over = gauges["time"], gauges[name]
    factor, unit = style.scale_unit("Pa", np.max(np.abs(over)))
    time_factor, time_unit = style.scale_unit("s", time[-1])
    axis.axhline(0., color=style.GREY, linewidth=0.6)
    axis.fill_between(time * time_factor, 0., over * factor, color=colour,
                      alpha=0.15, linewidth=0.)
    axis.plot(time * time_factor, over * factor, color=colour, linewidth=1.2)
    told = []
    for peak, marker, mark in zip(signals.peaks_of_steps(time, over, measures),
                                  "ov", "●▼"):
        if peak is None:
            continue
        place = peak[0] * time_factor, peak[1] * factor
        axis.plot(*place, marker=marker, markersize=4, color=colour)
        told.append(f"{mark} {place[1]:.3g} at {place[0]:.3g}")
    axis.set_ylabel(unit)
    axis.margins(y=0.15)
    return "  ".join(told) + f" {time_unit}" * bool(told)


def _draw_places(figure, loads, views, names):
    """Where the places are, seen from in front and from behind."""
    places, sides = loads.places(), (0, 2)
    known = {name: [views.spot(side, places[name]) for side in sides]
             for name in names if name in places}
    hidden = [name for name, spots in known.items() if spots == [None, None]]
    for name in hidden:
        side = views.nearer_side(sides, places[name])
        known[name][sides.index(side)] = views.spot(side, places[name], True)
    for number, (axis, side) in enumerate(zip(figure.subplots(2, 1), sides)):
        axis.set_axis_off()
        width, height = views.side_extent(side)
        axis.imshow(views.paint_side(side), extent=(0., width, 0., height))
        axis.set_title(views.names()[side], fontsize=10)
        spots = {name: found[number] for name, found in known.items()}
        for is_right in (False, True):
            names_here = [name for name, spot in spots.items()
                          if spot is not None
                          and (spot[0] >= 0.49 * width) == is_right]
            names_here.sort(key=lambda name: -spots[name][1])
            level = np.inf
            for name in names_here:
                # Numbers stand next to the body, apart from each other.
                level = min(spots[name][1], level - 0.06 * height)
                # Hollow where it is behind what is seen.
                axis.plot(*spots[name], marker="o", markersize=3.5,
                          color="white" if name in hidden else "black",
                          markeredgecolor="black" if name in hidden
                          else "white", markeredgewidth=0.5)
                axis.annotate(
                    str(names.index(name) + 1), spots[name],
                    ((1.15 if is_right else -0.15) * width, level),
                    fontsize=9, ha="center", va="center",
                    arrowprops={"arrowstyle": "-", "linewidth": 0.5,
                                "color": style.GREY})
        axis.set_xlim(-0.25 * width, 1.25 * width)
