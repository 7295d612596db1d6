# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of a head that hits a plane: cuts, and histories."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize, PowerNorm

from plot.analysis import signals
from plot.figures import style

PALE = "#e3e6e9"  # what a picture says nothing of
MOST_ARROWS = 32
SPAN = 5e-5  # of running means [s]
LAYER_COLOURS = {"brain": style.COLOURS[3], "csf": style.COLOURS[0],
                 "skull": style.COLOURS[1], "scalp": style.COLOURS[2]}


def of_layers(run, values, layers):
    """Whether polygons or cells belong to regions of some layers."""
    numbers = [index for index, name in enumerate(run.regions)
               if run.layer_of[name] in layers]
    return np.isin(np.round(values["region"]).astype(int), numbers)


def _panels(run, cuts):
    """Axes, for each cut one, that show the same part of the plane."""
    _, right, up = run.cut_axes()
    points = np.concatenate([cut.polygons.reshape(-1, 2) for cut in cuts])
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.06 * (high - low).max()
    width = 10. / max(len(cuts), 3)
    figure, axes = plt.subplots(
        1, len(cuts), squeeze=False, figsize=(
            width * len(cuts) + 0.9,
            width * (high - low)[1] / (high - low)[0] + 0.45))
    low, high = low - margin, high + margin
    for axis, cut in zip(axes[0], cuts):
        if run.planes:
            _draw_wall(run.planes[0], axis, [right, up], np.ptp([low, high]))
        axis.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]),
                 title=f"{1e3 * cut.time:.3g} ms")
        axis.set_axis_off()
    return figure, axes[0]


def _draw_wall(plane, axis, shown, size):
    """A plane, longer than the picture of this size along the axes shown."""
    normal, place = plane.normal[shown], plane.point[shown]
    along = np.array([-normal[1], normal[0]]) * 2. * size
    axis.plot(*np.stack([place - along, place + along]).T, color="black",
              linewidth=1.5, zorder=3)


def add_polygons(axis, cut, part, values=None, **options):
    """Polygons of a part of a cut, in one colour without values."""
    colours = {"facecolors": PALE, "edgecolors": PALE} if values is None else {
        "array": values, "edgecolors": "face"}
    return axis.add_collection(PolyCollection(
        cut.polygons[part], linewidths=0.5, **colours, **options))


def _paint(axes, cuts, parts, values, label, **options):
    """Parts of cuts in the colours of values, all else pale, and their bar."""
    for axis, cut, part, of_part in zip(axes, cuts, parts, values):
        add_polygons(axis, cut, ~part)
        shown = add_polygons(axis, cut, part, of_part, **options)
    axes[0].figure.colorbar(
        shown, ax=axes, shrink=0.85, pad=0.01, label=label,
        extend=style.beyond(np.concatenate(values), shown.norm))


def draw_pressure(run, cuts):
    """Pressure in all layers, on the scale of what lies within the skull."""
    inside = np.concatenate([
        cut.values["pressure"][of_layers(run, cut.values, ("brain", "csf"))]
        for cut in cuts])
    if not inside.size:
        inside = np.concatenate([cut.values["pressure"] for cut in cuts])
    largest = float(np.percentile(np.abs(inside), 99.8)) or 1.
    factor, unit = style.scale_unit("Pa", largest)
    figure, axes = _panels(run, cuts)
    pressures = [cut.values["pressure"] * factor for cut in cuts]
    _paint(axes, cuts, [np.ones(len(values), bool) for values in pressures],
           pressures, f"pressure [{unit}]", cmap=style.DIVERGING,
           norm=style.about_zero(largest * factor))
    return figure


def draw_shear(run, cuts):
    """Largest shear strain of the solids; fluids are pale."""
    solids = [layer for name, layer in run.layer_of.items()
              if run.is_solid(name)]
    parts = [of_layers(run, cut.values, solids) for cut in cuts]
    strains = [cut.values["shear_strain"][part]
               for cut, part in zip(cuts, parts)]
    largest = float(np.percentile(np.concatenate(strains), 99.8)) or 1.
    figure, axes = _panels(run, cuts)
    _paint(axes, cuts, parts, [100. * strain for strain in strains],
           "shear strain [%]", cmap=style.SEQUENTIAL,
           norm=PowerNorm(0.5, 0., 100. * largest))
    return figure


def velocity_of(values, part, is_relative):
    """Velocities of a part of a cut, or what they differ by from the skull's as
    a rigid body."""
    return values["velocity"][part] - is_relative * values["carried"][part]


def draw_speed(run, cuts):
    """Speed of the CSF with arrows: as it is, and less the skull's as a rigid
    body, each on a scale of its own."""
    kinds = ["speed"] + ["less skull's"] * (run.region("skull") is not None)
    figure, axes = _panels(run, cuts * len(kinds))
    for is_relative, name in enumerate(kinds):
        parts = [of_layers(run, cut.values, ("csf",)) for cut in cuts]
        speeds = [np.linalg.norm(velocity_of(cut.values, part, is_relative),
                                 axis=1) for cut, part in zip(cuts, parts)]
        largest = max(speed.max() for speed in speeds) or 1.
        own = axes[is_relative * len(cuts):(is_relative + 1) * len(cuts)]
        _paint(own, cuts, parts, speeds, f"{name} [m/s]", cmap="viridis",
               norm=Normalize(0., largest))
        for axis, cut in zip(own, cuts):
            _add_arrows(axis, run, cut, is_relative, largest)
    return figure


def _add_arrows(axis, run, cut, is_relative, largest):
    """One arrow in each direction from the head's centre, of the cell in the
    middle of the layer."""
    part = of_layers(run, cut.centres, ("csf",))
    place = cut.centres["place"][part]
    velocity = velocity_of(cut.centres, part, is_relative)
    away = place - 0.5 * (place.min(axis=0) + place.max(axis=0))
    angles = (np.arange(MOST_ARROWS) + 0.5) * 2. * np.pi / MOST_ARROWS
    chosen = []
    for direction in np.stack([np.cos(angles), np.sin(angles)], axis=1):
        along = away @ direction
        beside = np.linalg.norm(away - along[:, None] * direction, axis=1)
        beside[along <= 0.] = np.inf
        # The middle one of the cells that this direction meets.
        here = np.flatnonzero(beside <= 1.5 * beside.min())
        chosen.append(here[np.argsort(along[here])[len(here) // 2]])
    chosen = np.unique(chosen)
    axis.quiver(*place[chosen].T, *velocity[chosen].T, angles="xy",
                scale_units="xy", scale=largest / (0.13 * np.ptp(place[:, 1])),
                width=0.006, color="black", zorder=4)


def _charts(run, count, size=(9.4, 3.1), **options):
    """Axes, side by side, over the time of the run [ms]."""
    figure, axes = plt.subplots(1, count, squeeze=False, figsize=size, **options)
    for axis in axes[0]:
        axis.set(xlim=(0., 1e3 * run.history["time"][-1]), xlabel="time [ms]")
    return figure, axes[0]


def _chart(run, label, height=3.1):
    """One of them, with room for a legend at its side."""
    figure, (axis,) = _charts(run, 1, (9., height))
    axis.set_ylabel(label)
    return figure, axis


def _legend_beside(axis):
    axis.legend(loc="upper left", bbox_to_anchor=(1., 1.))


def smoothed(run, values):
    """Running mean over SPAN, of rows that are evenly apart."""
    time = run.history["time"]
    return np.interp(time, *signals.smooth(time, values, SPAN))


def draw_contact(run):
    """Force and area over time, of the whole head."""
    time = 1e3 * run.history["time"]
    figure, (left, right) = _charts(run, 2)
    force = run.history["contact_force"]
    mean = smoothed(run, force)
    shown, unit = style.scale_unit("N", max(mean.max(), 1e-12))
    left.plot(time, force * shown, color=style.COLOURS[5], linewidth=0.5,
              label="each row of the history")
    left.plot(time, mean * shown, color=style.COLOURS[0],
              label=f"mean over {1e6 * SPAN:.0f} µs")
    left.set(ylim=(0., 1.6 * mean.max() * shown or 1.),
             ylabel=f"contact force [{unit}]")
    left.legend(loc="upper right")
    right.plot(time, run.history["contact_area"] * 1e4, color=style.COLOURS[0])
    right.set(ylabel="contact area [cm²]", ylim=(0., None))
    return figure


def draw_velocity(run):
    """Mean velocity of everything along the normal, and of solid layers."""
    time = 1e3 * run.history["time"]
    figure, axis = _chart(run, "velocity from the wall [m/s]")
    axis.axhline(0., color=style.GREY, linewidth=0.7)
    for name in filter(run.is_solid, run.regions):
        parts = [component * run.history[f"velocity_{'xyz'[d]}_{name}"]
                 for d, component in enumerate(run.planes[0].normal)
                 if d not in run.mirrors]
        axis.plot(time, sum(parts), linewidth=0.9, label=name,
                  color=LAYER_COLOURS.get(run.layer_of[name]))
    axis.plot(time, run.normal_velocity(), color="black", label="whole head")
    rebound = run.rebound()
    if rebound is not None:
        axis.axvline(1e3 * rebound, color=style.GREY, linestyle=":")
        axis.annotate(f"rebound {1e3 * rebound:.3g} ms",
                      (1e3 * rebound, 0.04), (5, 0), fontsize=9,
                      xycoords=("data", "axes fraction"),
                      textcoords="offset points")
    _legend_beside(axis)
    return figure


def draw_pressures(run):
    """Least and largest pressure of the layers within the skull."""
    time = 1e3 * run.history["time"]
    layers = [layer for layer in ("csf", "brain") if run.region(layer)]
    figure, axes = _charts(run, len(layers), sharey=True)
    columns = {(name, layer): run.column(name + "_pressure", layer)
               for layer in layers for name in ("largest", "least")}
    factor, unit = style.scale_unit("Pa", np.abs(list(columns.values())).max())
    for axis, layer in zip(axes, layers):
        axis.axhline(0., color=style.GREY, linewidth=0.7)
        for name, colour in zip(("largest", "least"), style.COLOURS[1::-1]):
            axis.plot(time, factor * columns[name, layer], color=colour,
                      linewidth=0.9, label=name)
        axis.set_title(run.region(layer))
        axis.legend()
    axes[0].set_ylabel(f"pressure [{unit}]")
    return figure


def draw_strains(run):
    """Largest shear strain of each solid, and largest speed in the CSF."""
    figure, axes = _charts(run, 2)
    for name in run.regions:
        axis, factor, quantity = (axes[0], 100., "shear_strain") \
            if run.is_solid(name) else (axes[1], 1., "speed")
        axis.plot(1e3 * run.history["time"],
                  factor * run.history[f"largest_{quantity}_{name}"],
                  label=name, color=LAYER_COLOURS.get(run.layer_of[name]))
    axes[0].set_ylabel("largest shear strain [%]")
    axes[1].set(ylabel="largest speed [m/s]", ylim=(0., None))
    for axis in axes:
        axis.legend()
    return figure


def draw_probes(run, names):
    """Pressure at the probes; @p names say where they are."""
    columns = [run.probes[f"pressure_{number}"]
               for number, _ in enumerate(names, 1)]
    factor, unit = style.scale_unit("Pa", np.abs(columns).max())
    figure, axis = _chart(run, f"pressure [{unit}]", 3.3)
    axis.axhline(0., color=style.GREY, linewidth=0.7)
    for column, name in zip(columns, names):
        axis.plot(1e3 * run.probes["time"], factor * column, linewidth=0.9,
                  label=name)
    _legend_beside(axis)
    return figure


def draw_energy(run, ledger):
    """@p ledger has for each kind its name and its column [J]."""
    figure, axis = _chart(run, "energy [J]")
    for number, (name, column) in enumerate(ledger):
        axis.plot(1e3 * run.history["time"], column, label=name,
                  color=style.COLOURS[number % len(style.COLOURS)],
                  linestyle="-" if number < 3 else "--" if number < len(
                      style.COLOURS) else ":")
    _legend_beside(axis)
    return figure
