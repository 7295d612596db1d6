# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Maps of a whole run: peak overpressure, impulse, arrival and duration of the
blast in planes and along lines of gauges."""

import glob
import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap, LogNorm, Normalize
from matplotlib.ticker import MaxNLocator

from plot.readers import tables
from plot.figures import injury_maps, style

QUANTITIES = ("peak_overpressure", "impulse", "arrival", "duration")
# Those that are lower limits where the field LIMITS is 1; maps of before 0.2.0
# have none.
OF_PHASE = ("impulse", "duration")
LIMITS = "cut_off"


def take_maps(found):
    """Moves the maps out of what planes.open_planes() gave: by the common
    beginning of their names, a dictionary by quantity, injuries among them."""
    maps = {}
    for name in list(found):
        quantity = found[name][0].quantity
        if quantity in (*QUANTITIES, LIMITS, *injury_maps.INJURIES,
                        injury_maps.LIMITS) and name.endswith("_" + quantity):
            stem = name[:-len(quantity) - 1]
            maps.setdefault(stem, {})[quantity] = found.pop(name)[0]
    return maps


def draw_maps(maps, path):
    """A panel for each quantity; grey where the blast has not arrived, hatched
    where they are lower limits."""
    names = [name for name in QUANTITIES if name in maps]
    figure, axes = four_panels(maps[names[0]])
    for axis in axes.flat[len(names):]:
        axis.set_axis_off()
    arrived = maps["arrival"].values > 0. if "arrival" in maps else None
    for axis, name in zip(axes.flat, names):
        _draw_panel(axis, maps[name], arrived)
        if name in OF_PHASE and LIMITS in maps:
            hatch_limits(axis, maps[LIMITS])
    style.save(figure, path)


def hatch_limits(axis, plane):
    """Where a field is 1, a gauge at a time, if that is anywhere."""
    limits = plane.values > 0.5
    if not np.any(limits):
        return
    left, right, bottom, top = plane.extent()
    rows, columns = limits.shape
    axis.pcolor(np.linspace(left, right, columns + 1),
                np.linspace(bottom, top, rows + 1),
                np.ma.masked_where(~limits, plane.values),
                cmap=ListedColormap(["none"]), hatch="///",
                edgecolor="#808080", linewidth=0.)
    axis.text(0.98, 0.04, "hatched: lower limit (≥)", fontsize=8, ha="right",
              transform=axis.transAxes, bbox={"facecolor": "white", "pad": 2.,
                                              "edgecolor": "none"})


def four_panels(plane):
    """Figure and axes of two by two panels in the shape of a plane, with the
    names of its axes."""
    left, right, bottom, top = plane.extent()
    side = 4.6
    panel = np.clip((side - 1.) * (top - bottom) / (right - left), 1.2, 8.)
    figure, axes = plt.subplots(2, 2, squeeze=False, sharex=True, sharey=True,
                                figsize=(2. * side, 2. * (panel + 0.6)))
    for axis in axes[:, 0]:
        axis.set_ylabel(style.label(plane.axes[1], "m"))
    for axis in axes[-1, :]:
        axis.set_xlabel(style.label(plane.axes[0], "m"))
    return figure, axes


def _draw_panel(axis, plane, arrived):
    values = plane.values if arrived is None else np.where(
        arrived, plane.values, np.nan)
    axis.set(facecolor="#cccccc", title=plane.quantity.replace("_", " "))
    axis.grid(False)
    if not np.any(np.isfinite(values)):
        style.say_nothing(axis, "the blast has not arrived")
        return
    # Near the charge, and where the front stood at the end, values are off
    # the scale that matters elsewhere.
    low, high = np.nanpercentile(values, [4., 99.])
    factor, unit = style.scale_unit(plane.unit, np.nanpercentile(values, 90.))
    low, high = low * factor, high * factor
    spread = (plane.quantity in ("peak_overpressure", "impulse")
              and high > 5. * low > 0.)
    if spread:
        low = max(low, high / 200.)
    if not high > low:
        high = low + 1.
    image = axis.imshow(values * factor, extent=plane.extent(),
                        norm=(LogNorm if spread else Normalize)(low, high),
                        cmap=style.SEQUENTIAL, interpolation="nearest")
    _draw_contours(axis, plane, values * factor, low, high, spread)
    bar = style.colour_bar(axis.figure, image, unit, ax=axis, pad=0.02,
                           fraction=0.05,
                           extend=style.beyond(values * factor, image.norm))
    if spread:
        style.label_decades(bar.ax.yaxis)


def _draw_contours(axis, plane, values, low, high, spread):
    levels = [m * 10. ** e for e in range(-3, 9) for m in (1., 2., 5.)] \
        if spread else MaxNLocator(7).tick_values(low, high)
    levels = [level for level in levels if low < level < high]
    if not levels or plane.quantity == "duration":
        return
    lines = axis.contour(plane.positions(), plane.positions(1), values, levels,
                         colors="white", linewidths=0.6, alpha=0.8)
    axis.clabel(lines, fontsize=7, fmt="%g")


def draw_gauge_lines(folder, pictures):
    """A picture for each line of gauges, each quantity over the distance
    from its beginning; lower limits are marks apart from the curve."""
    for path in sorted(glob.glob(os.path.join(folder, "fields",
                                              "gauges_line_*.csv"))):
        _draw_gauge_line(tables.Table(path), os.path.join(
            pictures, os.path.basename(path).replace(".csv", ".png")))


def _draw_gauge_line(table, path):
    places = np.stack([table[axis] for axis in "xyz" if axis in table])
    way = np.linalg.norm(places - places[:, :1], axis=0)
    arrived = table["arrival"] > 0.
    cut = arrived & (LIMITS in table and table[LIMITS] > 0.)
    figure, axes = plt.subplots(2, 2, sharex=True, figsize=(8., 5.))
    for axis, name in zip(axes.flat, QUANTITIES):
        values = np.where(arrived, table[name], np.nan)
        axis.set_title(name.replace("_", " "))
        if not np.any(arrived):
            style.say_nothing(axis, "the blast has not arrived")
            continue
        factor, unit = style.scale_unit(table.unit(name),
                                        np.nanpercentile(values, 90.))
        limits = cut if name in OF_PHASE else np.zeros_like(cut)
        axis.plot(way, np.where(limits, np.nan, values) * factor)
        if np.any(limits):
            axis.plot(way[limits], values[limits] * factor, "^", markersize=4,
                      fillstyle="none", label="lower limit (≥)")
            axis.legend()
        axis.set_ylabel(unit)
        if name == "peak_overpressure" and np.nanmin(values) > 0.:
            axis.set_yscale("log")
    for axis in axes[-1, :]:
        axis.set_xlabel("along the line [m]")
    begin, end = (", ".join(f"{x:g}" for x in places[:, i]) for i in (0, -1))
    figure.suptitle(f"Gauges from ({begin}) to ({end}) m", x=0.01, ha="left")
    style.save(figure, path)
