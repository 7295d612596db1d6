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
    for axis, cut in zip(axes[0], cuts):
        _draw_wall(run, axis, right, up, low - margin, high + margin)
        axis.set_aspect("equal")
        axis.set_xlim(low[0] - margin, high[0] + margin)
        axis.set_ylim(low[1] - margin, high[1] + margin)
        axis.set_axis_off()
        axis.set_title(f"{1e3 * cut.time:.3g} ms")
    return figure, axes[0]


def _draw_wall(run, axis, right, up, low, high):
    plane = run.impact()
    if plane is None:
        return
    normal = plane.normal[[right, up]]
    along = np.array([-normal[1], normal[0]]) * 2. * np.ptp(
        np.stack([low, high]))
    place = plane.point[[right, up]]
    ends = np.stack([place - along, place + along])
    axis.plot(*ends.T, color="black", linewidth=1.5, zorder=3)


def add_polygons(axis, cut, part, values=None, **options):
    """Polygons of a part of a cut, in one colour without values."""
    colours = {"facecolors": PALE, "edgecolors": PALE} if values is None else {
        "array": values, "edgecolors": "face"}
    collection = PolyCollection(cut.polygons[part], linewidths=0.5,
                                **colours, **options)
    axis.add_collection(collection)
    return collection


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
    norm = style.about_zero(largest * factor)
    pressures = [cut.values["pressure"] * factor for cut in cuts]
    for axis, cut, pressure in zip(axes, cuts, pressures):
        shown = add_polygons(axis, cut, slice(None), pressure,
                             cmap=style.DIVERGING, norm=norm)
    figure.colorbar(shown, ax=axes, shrink=0.85, pad=0.01,
                    extend=style.beyond(np.concatenate(pressures), norm),
                    label=f"pressure [{unit}]")
    return figure


def draw_shear(run, cuts):
    """Largest shear strain of the solids; fluids are pale."""
    solids = [layer for name, layer in run.layer_of.items()
              if run.is_solid(name)]
    parts = [of_layers(run, cut.values, solids) for cut in cuts]
    strains = np.concatenate([cut.values["shear_strain"][part]
                              for cut, part in zip(cuts, parts)])
    largest = float(np.percentile(strains, 99.8)) or 1.
    figure, axes = _panels(run, cuts)
    for axis, cut, part in zip(axes, cuts, parts):
        add_polygons(axis, cut, ~part)
        shown = add_polygons(
            axis, cut, part, 100. * cut.values["shear_strain"][part],
            cmap=style.SEQUENTIAL, norm=PowerNorm(0.5, 0., 100. * largest))
    figure.colorbar(shown, ax=axes, shrink=0.85, pad=0.01,
                    extend=style.beyond(100. * strains, shown.norm),
                    label="shear strain [%]")
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
        for axis, cut, part, speed in zip(own, cuts, parts, speeds):
            add_polygons(axis, cut, ~part)
            shown = add_polygons(axis, cut, part, speed, cmap="viridis",
                                 norm=Normalize(0., largest))
            _add_arrows(axis, run, cut, is_relative, largest)
        figure.colorbar(shown, ax=own, shrink=0.85, pad=0.01,
                        label=f"{name} [m/s]")
    return figure


def _add_arrows(axis, run, cut, is_relative, largest):
    """One arrow in each direction from the head's centre, of the cell in the
    middle of the layer."""
    part = of_layers(run, cut.centres, ("csf",))
    place = cut.centres["place"][part]
    velocity = velocity_of(cut.centres, part, is_relative)
    centre = 0.5 * (place.min(axis=0) + place.max(axis=0))
    away = place - centre
    angles = (np.arange(MOST_ARROWS) + 0.5) * 2. * np.pi / MOST_ARROWS
    wanted = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    chosen = []
    for direction in wanted:
        along = away @ direction
        beside = np.linalg.norm(away - along[:, None] * direction, axis=1)
        beside[along <= 0.] = np.inf
        # The middle one of the cells that this direction meets.
        here = np.flatnonzero(beside <= 1.5 * beside.min())
        chosen.append(here[np.argsort(along[here])[len(here) // 2]])
    chosen = np.unique(chosen)
    size = np.ptp(place[:, 1])
    axis.quiver(*place[chosen].T, *velocity[chosen].T, angles="xy",
                scale_units="xy", scale=largest / (0.13 * size), width=0.006,
                color="black", zorder=4)


def _time_axis(axis, run):
    axis.set_xlim(0., 1e3 * run.history["time"][-1])
    axis.set_xlabel("time [ms]")


def smoothed(run, values):
    """Running mean over SPAN, of rows that are evenly apart."""
    time = run.history["time"]
    if len(time) < 5:
        return values
    even = np.linspace(time[0], time[-1], 2 * len(time))
    means = signals.smooth(even, np.interp(even, time, values), SPAN)
    return np.interp(time, even, means)


def draw_contact(run):
    """Force and area over time, of the whole head."""
    history = run.history
    time = 1e3 * history["time"]
    figure, axes = plt.subplots(1, 2, figsize=(9.4, 3.1))
    force = history["contact_force"]
    mean = smoothed(run, force)
    shown, unit = style.scale_unit("N", max(mean.max(), 1e-12))
    axes[0].plot(time, force * shown, color=style.COLOURS[5], linewidth=0.5,
                 label="each row of the history")
    axes[0].plot(time, mean * shown, color=style.COLOURS[0],
                 label=f"mean over {1e6 * SPAN:.0f} µs")
    axes[0].set_ylim(0., 1.6 * mean.max() * shown or 1.)
    axes[0].set_ylabel(f"contact force [{unit}]")
    axes[0].legend(loc="upper right")
    axes[1].plot(time, history["contact_area"] * 1e4,
                 color=style.COLOURS[0])
    axes[1].set_ylabel("contact area [cm²]")
    axes[1].set_ylim(bottom=0.)
    for axis in axes:
        _time_axis(axis, run)
    return figure


def draw_velocity(run):
    """Mean velocity of everything along the normal, and of solid layers."""
    time = 1e3 * run.history["time"]
    figure, axis = plt.subplots(figsize=(9., 3.1))
    axis.axhline(0., color=style.GREY, linewidth=0.7)
    normal = run.impact().normal
    for name in run.regions:
        if run.is_solid(name):
            layer = run.layer_of[name]
            parts = [normal[d] * run.history[f"velocity_{'xyz'[d]}_{name}"]
                     for d in range(3) if d not in run.mirrors]
            axis.plot(time, sum(parts), linewidth=0.9, label=name,
                      color=LAYER_COLOURS.get(layer))
    axis.plot(time, run.normal_velocity(), color="black", label="whole head")
    rebound = run.rebound()
    if rebound is not None:
        axis.axvline(1e3 * rebound, color=style.GREY, linestyle=":")
        axis.annotate(f"rebound {1e3 * rebound:.3g} ms",
                      (1e3 * rebound, 0.04), (5, 0), fontsize=9,
                      xycoords=("data", "axes fraction"),
                      textcoords="offset points")
    axis.set_ylabel("velocity from the wall [m/s]")
    axis.legend(loc="upper left", bbox_to_anchor=(1., 1.))
    _time_axis(axis, run)
    return figure


def draw_pressures(run):
    """Least and largest pressure of the layers within the skull."""
    time = 1e3 * run.history["time"]
    layers = [layer for layer in ("csf", "brain") if run.region(layer)]
    figure, axes = plt.subplots(1, len(layers), squeeze=False, sharey=True,
                                figsize=(9.4, 3.1))
    columns = [run.column(name + "_pressure", layer) for layer in layers
               for name in ("least", "largest")]
    factor, unit = style.scale_unit("Pa", max(np.abs(column).max()
                                              for column in columns))
    for axis, layer in zip(axes[0], layers):
        axis.axhline(0., color=style.GREY, linewidth=0.7)
        for number, name in enumerate(("largest", "least")):
            axis.plot(time, factor * run.column(name + "_pressure", layer),
                      color=style.COLOURS[1 - number], linewidth=0.9,
                      label=name)
        axis.set_title(run.region(layer))
        axis.legend()
        _time_axis(axis, run)
    axes[0, 0].set_ylabel(f"pressure [{unit}]")
    return figure


def draw_strains(run):
    """Largest shear strain of each solid, and largest speed in the CSF."""
    time = 1e3 * run.history["time"]
    figure, axes = plt.subplots(1, 2, figsize=(9.4, 3.1))
    for name in run.regions:
        if run.is_solid(name):
            axes[0].plot(
                time, 100. * run.history[f"largest_shear_strain_{name}"],
                label=name, color=LAYER_COLOURS.get(run.layer_of[name]))
    axes[0].set_ylabel("largest shear strain [%]")
    axes[0].legend()
    for name in run.regions:
        if not run.is_solid(name):
            axes[1].plot(time, run.history[f"largest_speed_{name}"],
                         label=name,
                         color=LAYER_COLOURS.get(run.layer_of[name]))
    axes[1].set_ylabel("largest speed [m/s]")
    axes[1].set_ylim(bottom=0.)
    axes[1].legend()
    for axis in axes:
        _time_axis(axis, run)
    return figure


def draw_probes(run, names):
    """Pressure at the probes; @p names say where they are."""
    time = 1e3 * run.probes["time"]
    columns = [run.probes[f"pressure_{number + 1}"]
               for number in range(len(names))]
    factor, unit = style.scale_unit("Pa", max(np.abs(column).max()
                                              for column in columns))
    figure, axis = plt.subplots(figsize=(9., 3.3))
    axis.axhline(0., color=style.GREY, linewidth=0.7)
    for column, name in zip(columns, names):
        axis.plot(time, factor * column, linewidth=0.9, label=name)
    axis.set_ylabel(f"pressure [{unit}]")
    axis.legend(loc="upper left", bbox_to_anchor=(1., 1.))
    _time_axis(axis, run)
    return figure


def draw_energy(run, ledger):
    """@p ledger has for each kind its name and its column [J]."""
    time = 1e3 * run.history["time"]
    figure, axis = plt.subplots(figsize=(9., 3.1))
    for number, (name, column) in enumerate(ledger):
        axis.plot(time, column, label=name,
                  color=style.COLOURS[number % len(style.COLOURS)],
                  linestyle="-" if number < 3 else "--" if number < len(
                      style.COLOURS) else ":")
    axis.set_ylabel("energy [J]")
    axis.legend(loc="upper left", bbox_to_anchor=(1., 1.))
    _time_axis(axis, run)
    return figure
