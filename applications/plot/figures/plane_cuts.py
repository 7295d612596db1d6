# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of plane cuts through fields, and of their lowest row of samples."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import PowerNorm
from matplotlib.ticker import MaxNLocator

from plot.analysis import wave_times
from plot.figures import style

BAR = 1.  # inches, least height of a colour bar


def _time(plane, planes):
    """The time of a plane, in one unit for all planes."""
    factor, unit = style.scale_unit("s", planes[-1].time)
    return f"{plane.time * factor:.3g} {unit}"


def _name(plane):
    return "over" * (plane.quantity == "pressure") + plane.quantity


def _shown(plane, background):
    """Values to draw: overpressure for a pressure, else the quantity."""
    return plane.values - background if plane.quantity == "pressure" \
        else plane.values


def largest_overpressure(planes):
    """[Pa]"""
    background = wave_times.background(planes)
    return max(float(np.nanmax(_shown(plane, background)))
               for plane in planes)


def _limits(planes, shown):
    """Lower and upper limits of that part of the plane in which anything is to
    be seen at any time, along both axes."""
    # Bodies have no values.
    seen = np.any([~(np.abs(values) <= wave_times.SEEN
                     * np.nanmax(np.abs(values))) for values in shown], axis=0)
    left, right, bottom, top = planes[0].extent()
    limits = []
    for low, high, part in ((left, right, seen.any(axis=0)),
                            (bottom, top, seen.any(axis=1))):
        places = np.flatnonzero(part)
        step = (high - low) / part.size
        margin = 0.05 * (high - low)
        limits.append((low, high) if not places.size else
                      (max(low, low + step * places[0] - margin),
                       min(high, low + step * (places[-1] + 1) + margin)))
    return limits


def draw_planes(planes, path, one_scale=False):
    """The quantity at these times, each with its own colour scale or all with
    one."""
    background = wave_times.background(planes)
    shown = [_shown(plane, background) for plane in planes]
    together = np.concatenate([values[np.isfinite(values)]
                               for values in shown])
    columns = 1 if len(planes) < 3 else 3
    rows = -(-len(planes) // columns)
    limits = _limits(planes, shown)
    width, height = (high - low for low, high in limits)
    side = 8. if columns == 1 else 3.3
    bar_height = (side - 1.) * height / width
    figure, axes = plt.subplots(
        rows, columns, squeeze=False, sharex=True, sharey=True,
        figsize=(side * columns, (np.clip(bar_height, 1.2, 8.) + 0.6) * rows))
    for axis in axes.flat[len(planes):]:
        axis.set_axis_off()
    for number, (axis, plane, values) in enumerate(
            zip(axes.flat, planes, shown), 1):
        image = _draw_panel(axis, plane, values, together if one_scale
                            else values[np.isfinite(values)])
        # The scale of all stands at the end of each row.
        if not one_scale or number % columns == 0 or number == len(planes):
            _draw_bar(axis, plane, image, bar_height)
        # Not above a bar that is higher than the picture.
        axis.set_title(_time(plane, planes), y=1.)
    # All axes share these.
    axes[0, 0].set(xlim=limits[0], ylim=limits[1])
    for axis in axes[:, 0]:
        axis.set_ylabel(style.label(planes[0].axes[1], "m"))
    for axis in axes[-1, :]:
        axis.set_xlabel(style.label(planes[0].axes[0], "m"))
    style.save(figure, path)


def _draw_panel(axis, plane, values, scaled_by):
    """Colours reach from the least to the largest of @p scaled_by."""
    factor, unit = style.scale_unit(plane.unit, np.max(np.abs(scaled_by)))
    low, high = np.min(scaled_by) * factor, np.max(scaled_by) * factor
    if low == high:
        high = low + 1.
    if plane.quantity == "pressure":
        colours, norm = style.DIVERGING, style.about_zero(max(-low, high))
    else:
        colours, norm = style.SEQUENTIAL, PowerNorm(0.5, low, high)
    image = axis.imshow(values * factor, extent=plane.extent(), norm=norm,
                        cmap=colours, interpolation="bilinear")
    axis.set_facecolor(style.BODY)
    axis.grid(False)
    return image, unit, (low, high)


def _draw_bar(axis, plane, drawn, height):
    """@p height: that of the picture [inches]; a low one has a higher bar."""
    image, unit, limits = drawn
    part = max(1., BAR / height)
    is_short = height < 2. * BAR
    label = style.label(_name(plane), unit)
    bar = style.colour_bar(
        axis.figure, image, label.replace(" [", "\n[") if is_short else label,
        cax=axis.inset_axes([1.02, 0.5 * (1. - part), 0.03, part]))
    bar.ax.yaxis.set_major_locator(MaxNLocator(3 if is_short else 5))
    bar.ax.set_ylim(*limits)


def draw_lines(planes, path):
    """The quantity along the first axis at the lower edge of the planes,
    which is the ground in a vertical cut."""
    background = wave_times.background(planes)
    largest = max(np.nanmax(np.abs(_shown(plane, background)[0]))
                  for plane in planes)
    factor, unit = style.scale_unit(planes[0].unit, largest)
    figure, axis = plt.subplots(figsize=(7., 3.8))
    colours = plt.get_cmap("viridis")(np.linspace(0., 0.9, len(planes)))
    for plane, colour in zip(planes, colours):
        axis.plot(plane.positions(), _shown(plane, background)[0] * factor,
                  color=colour, label=_time(plane, planes))
    first = planes[0]
    axis.set(title=f"{_name(first)} along the lowest samples, "
             f"{first.axes[1]} = {first.lower[1]:.2g} m",
             xlabel=style.label(first.axes[0], "m"),
             ylabel=style.label(_name(first), unit))
    axis.legend(title="time")
    style.save(figure, path)
