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
    if gauges and gauges.others("time") and len(gauges["time"]) >= 3:
        style.save(gauges_figure(gauges, loads, views),
                   os.path.join(pictures, "body_gauges.png"))


def pick_times(loads):
    """Times from when the front meets the body until it has passed it, denser
    at the beginning."""
    first, last = np.nanpercentile(loads.measure("arrival"), [2., 98.])
    times = first + 1.6 * (last - first) \
        * np.linspace(0.15, 1., MOST_TIMES) ** 1.5
    return np.unique(np.minimum(times, loads.times[-1]))


def draw_times(loads, views, path, one_scale=False):
    """Overpressure at up to six times, each with its own colour scale or all
    with one."""
    times = pick_times(loads)
    columns = min(3, len(times))
    figure, axes = _panels(views, -(-len(times) // columns), columns)
    shown = [loads.overpressure(time) for time in times]
    # Corners, as between foot and ground, are off the scale that matters.
    spans = np.array([np.percentile(values, [0.2, 99.5]) for values in shown])
    if one_scale:
        spans[:] = spans[:, 0].min(), spans[:, 1].max()
    for number, (axis, time, values, (low, high)) in enumerate(
            zip(axes, times, shown, spans), 1):
        factor, unit = style.scale_unit("Pa", max(-low, high))
        # One scale of all stands at the end of each row.
        barred = [values] if not one_scale else shown \
            if number % columns == 0 or number == len(times) else []
        _draw_body(axis, views, values * factor,
                   *style.signed_scale(low * factor, high * factor), unit,
                   [one * factor for one in barred])
        time_factor, time_unit = style.scale_unit("s", times[-1])
        axis.set_title(f"{time * time_factor:.3g} {time_unit}")
    figure.suptitle("Overpressure on the body", x=0.01, ha="left")
    style.save(figure, path)


def draw_measures(loads, views, path):
    known = [one for one in (("peak", "peak overpressure", "Pa"),
                             ("impulse", "positive impulse", "Pa s"),
                             ("arrival", "arrival", "s")) if one[0] in loads]
    figure, axes = _panels(views, 1, len(known))
    for axis, (name, title, unit) in zip(axes, known):
        axis.set_title(title)
        values = loads.measure(name)
        low, high = np.nanpercentile(values, [1., 99.5])
        factor, unit = style.scale_unit(unit, high)
        low, high, values = low * factor, high * factor, values * factor
        is_wide = name != "arrival" and high > 5. * low > 0.
        norm = (LogNorm if is_wide else Normalize)(
            low, high if high > low else low + 1.)
        _draw_body(axis, views, values, norm, plt.get_cmap(style.SEQUENTIAL),
                   unit, [values])
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
        axis.set(xlim=(0.5 * (width - widest), 0.5 * (width + widest)),
                 ylim=(0.5 * (height - highest), 0.5 * (height + highest)))
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
    style.colour_bar(
        figure, plt.cm.ScalarMappable(norm, style.SEQUENTIAL),
        f"peak overpressure [{unit}]", ax=axes, location="bottom", shrink=0.8,
        aspect=30, extend=style.beyond(views.means(values) * factor, norm))
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


def _draw_body(axis, views, values, norm, colours, unit, barred):
    """The body from all sides, in the colours of values of its facets. @p
    barred: values of all pictures that share the bar, none without a bar."""
    axis.set_axis_on()
    axis.set(xticks=[], yticks=[])
    axis.spines[:].set_visible(False)
    axis.grid(False)
    width, height = views.extent()
    axis.imshow(views.paint(values, norm, colours),
                extent=(0., width, 0., height))
    for name, place in views.labels():
        axis.annotate(name, (place, 0.), (0, -4), textcoords="offset points",
                      ha="center", va="top", fontsize=9, color=style.GREY)
    if not barred:
        return
    means = np.concatenate([views.means(part) for part in barred])
    bar = style.colour_bar(
        axis.figure, plt.cm.ScalarMappable(norm, colours), unit,
        cax=axis.inset_axes([1.02, 0.05, 0.025, 0.9]),
        extend=style.beyond(means, norm))
    bar.ax.tick_params(labelsize=9)
    if isinstance(norm, LogNorm):
        style.label_decades(bar.ax.yaxis)


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
    time = gauges["time"]
    time_factor, time_unit = style.scale_unit("s", time[-1])
    # From shortly before the first arrival to the end.
    over = np.abs(np.stack([gauges[name] for name in names])).max(axis=0)
    arrival = time[np.argmax(over > 0.01 * over.max())]
    begin = max(arrival - 0.05 * (time[-1] - arrival), time[0])
    for number, (axis, name) in enumerate(zip(axes.flat, names)):
        told = _draw_history(axis, gauges, name, style.COLOURS[number % 6],
                             (measures or {}).get(name, {}))
        axis.set_title(f"{number + 1}  {name}", fontsize=10, pad=16)
        axis.annotate(told, (0., 1.), (0, 3), xycoords="axes fraction",
                      textcoords="offset points", fontsize=8) \
            .set_in_layout(False)
        axis.set_xlim(begin * time_factor, time[-1] * time_factor)
        if number + columns >= len(names):
            axis.set_xlabel(style.label("time", time_unit))
            axis.tick_params(labelbottom=True)
    figure.suptitle("Overpressure at places on the body; ● first and ▼ second "
                    "peak", x=0.01, ha="left")
    return figure


def _draw_history(axis, gauges, name, colour, measures):
    """The curve with its peaks marked; what they are, in words."""
    time, over = gauges["time"], gauges[name]
    factor, unit = style.scale_unit("Pa", np.max(np.abs(over)))
    time_factor, time_unit = style.scale_unit("s", time[-1])
    style.draw_wave(axis, time * time_factor, over * factor, colour, 1.2)
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
        spots = [(name, found[number]) for name, found in known.items()
                 if found[number] is not None]
        levels = {-0.15: np.inf, 1.15: np.inf}  # of the last number at each side
        for name, spot in sorted(spots, key=lambda one: (
                one[1][0] >= 0.49 * width, -one[1][1])):
            beside = 1.15 if spot[0] >= 0.49 * width else -0.15
            # Numbers stand next to the body, apart from each other.
            levels[beside] = min(spot[1], levels[beside] - 0.06 * height)
            # Hollow where it is behind what is seen.
            colours = ("white", "black") if name in hidden else ("black", "white")
            axis.plot(*spot, marker="o", markersize=3.5, color=colours[0],
                      markeredgecolor=colours[1], markeredgewidth=0.5)
            axis.annotate(
                str(names.index(name) + 1), spot,
                (beside * width, levels[beside]), fontsize=9, ha="center",
                va="center", arrowprops={"arrowstyle": "-", "linewidth": 0.5,
                                         "color": style.GREY})
        axis.set_xlim(-0.25 * width, 1.25 * width)
