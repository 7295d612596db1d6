# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Views of the code on a shock, the mesh and a body: subcells of leaves,
their reconstruction and fluxes, adaptation, cut cells, a recorded load."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PatchCollection
from matplotlib.patches import Rectangle

from plot.figures import style

KILO = 1e-3
BUFFER, HALVED, MERGED = style.COLOURS[5], style.COLOURS[1], style.COLOURS[2]


def outline(axis, leaves, which=None, **options):
    """Edges of leaves."""
    chosen = slice(None) if which is None else which
    axis.add_collection(PatchCollection(
        [Rectangle(corner, *edges) for corner, edges in zip(
            leaves.corners[chosen], leaves.edges[chosen])],
        **{"facecolor": "none", "edgecolor": "black", **options}))


def paint(axis, leaves, values, norm, colours):
    """Subcells in the colours of values, grey without gas."""
    shown = np.where(leaves.open > 0., values, np.nan)
    colours = plt.get_cmap(colours).with_extremes(bad=style.BODY)
    ends = np.arange(leaves.n + 1) / leaves.n
    for corner, edges, means in zip(leaves.corners, leaves.edges, shown):
        picture = axis.pcolormesh(*(corner[:, None] + np.outer(edges, ends)),
                                  means, norm=norm, cmap=colours)
    return picture


def plain(axis, box, title=None):
    """A picture of the box x, y in equal scales, in millimetres."""
    axis.set(xlim=box[0], ylim=box[1], aspect="equal",
             xlabel=style.label("x", "mm"))
    axis.grid(False)
    for direction in (axis.xaxis, axis.yaxis):
        direction.set_major_formatter(lambda x, _: f"{1e3 * x:.0f}")
    if title:
        axis.set_title(title, fontsize=10)


def bar(axes, picture, words):
    style.colour_bar(picture.axes.figure, picture, words, ax=axes, shrink=0.85,
                     pad=0.02)


# One time step.

def limited(backward, forward):
    """Limited differences of neighbouring subcells, limiter mc."""
    bound = np.where(backward * forward > 0.,
                     np.minimum(np.abs(backward), np.abs(forward)), 0.)
    return np.sign(backward) * np.minimum(2. * bound,
                                          0.5 * np.abs(backward + forward))


def draw_step(line, picture):
    """Draws the effect of a step in a leaf; see commands.walk.Line."""
    n, x, edge = line.n, line.x, line.edge
    figure, (above, below) = plt.subplots(2, 1, sharex=True,
                                          figsize=(5.8, 4.6))
    pressure = KILO * line.pressure
    above.stairs(pressure, np.append(x - 0.5 * edge, x[-1] + 0.5 * edge),
                 baseline=None, color=style.GREY, linewidth=1.,
                 label="mean of a subcell")
    half = 0.5 * limited(pressure[1:-1] - pressure[:-2],
                         pressure[2:] - pressure[1:-1])
    for i, slope in enumerate(half, 1):
        ends = x[i] + 0.5 * edge * np.array([-1., 1.])
        above.plot(ends, pressure[i] + np.array([-slope, slope]),
                   color=style.COLOURS[0],
                   label="limited slope" if i == 1 else None)
        for k, marker in ((1, ">"), (0, "<")):
            # Traces at the faces of the leaf, from the left and the right.
            if 2 - k <= i < n + 3 - k:
                label = "trace at a face" if (i, k) == (2, 1) else None
                above.plot(ends[k], pressure[i] + (2 * k - 1) * slope, marker,
                           color=style.COLOURS[1], markersize=6, label=label)
    above.set_ylabel(style.label("pressure", "kPa"))
    faces = x[2] + edge * (np.arange(n + 1) - 0.5)
    below.plot(faces, line.flux, "D", color=style.COLOURS[0],
               label="mass flux through a face, mean of the step")
    below.bar(x[2:2 + n], line.change, 0.5 * edge, color=style.COLOURS[4],
              label="flux in minus flux out of a subcell")
    below.set(xlabel=style.label("x", "mm"), ylabel="kg/(m² s)")
    for axis in (above, below):
        axis.grid(False)
        for i, face in enumerate(faces):
            axis.axvline(face, color="black",
                         linewidth=1.4 if i in (0, n) else 0.4)
        for low in (x[0], x[n + 2]):
            axis.axvspan(low - 0.5 * edge, low + 1.5 * edge, color="#eeeeee",
                         zorder=0)
        axis.set_xlim(x[0] - 0.5 * edge, x[-1] + 0.5 * edge)
    below.xaxis.set_major_formatter(lambda place, _: f"{1e3 * place:.1f}")
    above.legend(loc="upper right")
    above.set_ylim(0.8 * pressure.min(), 1.08 * pressure.max())
    below.set_ylim(0., 1.55 * line.flux.max())
    below.legend(loc="upper right")
    for place, words in ((x[0] + 0.5 * edge, "neighbour"),
                         (x[2] + 0.5 * (n - 1) * edge,
                          f"one leaf: {n} subcells"),
                         (x[-1] - 0.5 * edge, "neighbour")):
        above.annotate(words, (place, 1.01), ha="center", fontsize=9,
                       xycoords=("data", "axes fraction"))
    style.save(figure, picture)


# One adaptation.

def changed_leaves(before, after):
    """Leaves after an adaptation that come of halved ones, and merged ones."""
    known, halved, merged = set(before.keys()), [], []
    for i, (level, x, y) in enumerate(after.keys()):
        if (level - 1, x // 2, y // 2) in known:
            halved.append(i)
        elif (level, x, y) not in known:
            merged.append(i)
    return halved, merged


def draw_adaptation(before, after, picture):
    """Leaves before and after an adaptation, and what became of them."""
    halved, merged = changed_leaves(before, after)
    changed = halved + merged
    margin = before.edges.max()
    ends = after.corners + after.edges
    box = tuple(zip(np.maximum(after.corners[changed].min(axis=0) - margin,
                               after.corners.min(axis=0)),
                    np.minimum(ends[changed].max(axis=0) + margin,
                               ends.max(axis=0))))
    finest = [i for i in halved if after.levels[i] == after.levels.max()]
    figure, axes = plt.subplots(1, 2, figsize=(7.4, 3.9), sharey=True)
    norm = plt.Normalize(KILO * before.pressure.min(),
                         KILO * before.pressure.max())
    for axis, leaves, title in zip(axes, (before, after), (
            "before", "after, one time step later")):
        painted = paint(axis, leaves, KILO * leaves.pressure, norm, "Purples")
        outline(axis, leaves, linewidth=0.4)
        plain(axis, box, title)
    kinds = ((merged, "merged", {"edgecolor": MERGED}),
             (halved, "halved", {"edgecolor": HALVED}),
             (finest, "to the finest level: AMR buffer",
              {"edgecolor": HALVED, "facecolor": BUFFER}))
    for which, _, colours in kinds:
        outline(axes[1], after, which, linewidth=1.6, **colours)
    axes[0].set_ylabel(style.label("y", "mm"))
    figure.legend(handles=[
        Rectangle((0, 0), 1, 1, linewidth=1.6, label=name,
                  **{"facecolor": "none", **colours})
        for _, name, colours in kinds],
        loc="lower center", ncols=3, bbox_to_anchor=(0.5, -0.06))
    bar(axes, painted, "pressure [kPa]")
    style.save(figure, picture)


# Cut cells.

def inside(points, box):
    """Which points [..., direction] are in the box x, y."""
    return np.all([(points[..., d] > box[d][0]) & (points[..., d] < box[d][1])
                   for d in range(2)], axis=0)


def draw_facets(axis, loads, box, arrow=0.):
    """Facets as pieces of the surface, with normals into the gas of some length
    [m]."""
    for i in np.flatnonzero(inside(loads.centroids, box)):
        place, normal = loads.centroids[i, :2], loads.normals[i, :2]
        along = 0.5 * loads.areas[i] * np.array([-normal[1], normal[0]])
        axis.plot(*zip(place - along, place + along), linewidth=2.,
                  color=style.COLOURS[1], solid_capstyle="butt")
        if arrow > 0.:
            axis.annotate("", place + arrow * normal, place, arrowprops={
                "arrowstyle": "->", "color": style.COLOURS[1],
                "linewidth": 0.8})


def draw_cut_cells(leaves, loads, box, picture):
    """Open fractions of subcells, and the facets in them."""
    figure, axis = plt.subplots(figsize=(5.4, 4.3))
    painted = paint(axis, leaves, leaves.open, plt.Normalize(0., 1.),
                    "Blues_r")
    edge = leaves.edges.min() / leaves.n
    centres = leaves.centres()
    shown = inside(centres, box)
    for place, part in zip(centres[shown], leaves.open[shown]):
        axis.add_patch(Rectangle(place - 0.5 * edge, edge, edge,
                                 facecolor="none", edgecolor="#777777",
                                 linewidth=0.4))
        if 0. < part < 0.995:
            axis.text(*(place + edge * np.array([0.46, -0.42])),
                      f"{part:.2f}", ha="right", fontsize=7,
                      color="white" if part < 0.5 else "black")
    outline(axis, leaves, linewidth=1.4)
    draw_facets(axis, loads, box, 0.6 * edge)
    plain(axis, box)
    axis.set_ylabel(style.label("y", "mm"))
    bar(axis, painted, "open fraction of a subcell's volume")
    style.save(figure, picture)


# One recorded load.

def draw_load(load, leaves, loads, box, picture):
    """The samples of one facet, the pressure of its cell, and where it is."""
    figure, (history, place) = plt.subplots(
        1, 2, figsize=(7.2, 2.7), width_ratios=[1.35, 1.])
    history.plot(1e3 * load.cell_times, KILO * load.cell, color=style.GREY,
                 linewidth=1., label="gas in its cell")
    history.stairs(KILO * load.samples, 1e3 * np.append(0., load.times),
                   baseline=None, color=style.COLOURS[1],
                   label="on the facet: loads.h5")
    history.plot(1e3 * load.arrival, 0., "^", color=style.COLOURS[0],
                 label="arrival")
    history.axhline(KILO * load.peak, color=style.COLOURS[0], linewidth=0.8,
                    linestyle="--", label="peak")
    history.set(xlim=(1e3 * load.begin, 1e3 * load.times[-1]),
                xlabel=style.label("time", "ms"),
                ylabel=style.label("overpressure", "kPa"))
    history.legend(loc="lower right")
    history.grid(False)
    over = KILO * (leaves.pressure - load.ambient)
    painted = paint(place, leaves, over, plt.Normalize(0., over.max()),
                    style.SEQUENTIAL)
    outline(place, leaves, linewidth=1., edgecolor="white")
    draw_facets(place, loads, box)
    edge = leaves.edges.min() / leaves.n
    place.add_patch(Rectangle(load.centre - 0.5 * edge, edge, edge,
                              facecolor="none", linewidth=2.,
                              edgecolor=style.COLOURS[5]))
    plain(place, box, f"at {1e3 * leaves.time:.3f} ms")
    bar(place, painted, "overpressure [kPa]")
    style.save(figure, picture)
