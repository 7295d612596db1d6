# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of the mesh of a body: from outside, cut by tissue, its quality."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Patch

from plot.readers import fields
from plot.figures import style
from plot.figures.body_views import NAMELESS, VIEWS

# By the numbers of tissues: none, soft tissue, skin, skeleton, brain, spinal
# cord, cerebrospinal fluid, lung, heart, liver, water, gelatin, polycarbonate.
TISSUE_COLOURS = ["#ffffff", "#e8b9a0", "#c98d70", "#f2ecd9", "#d98cb3",
                  "#a6458a", "#8ecae6", "#7fb7a4", "#b5362f", "#7d3c2a",
                  "#5aa9e6", "#f4d58d", "#9aa5b1"]
# Colours of the user's new tissues, which have the numbers from there on.
NEW_COLOURS = ["#3d8b37", "#c44e9c", "#e07b00", "#46537a", "#a3b830"]
SIDES = ("front", "left side", "back")


def render(mesh, view, pixels=700):
    """Brightness of the nearest facet in each pixel, and the extent."""
    _, (right, right_sign), (up, up_sign), (depth, depth_sign) = view
    corners = mesh["points"][mesh["connectivity"].reshape(-1, 4)]
    low, high = mesh["points"].min(axis=0), mesh["points"].max(axis=0)
    height, width = high[up] - low[up], high[right] - low[right]
    size = max(height, width) / pixels
    shape = (int(height / size) + 2, int(width / size) + 2)
    normals = mesh["normal"].reshape(-1, 3)
    light = np.zeros(3)
    light[[depth, up, right]] = (0.75 * depth_sign, 0.5 * up_sign,
                                 -0.43 * right_sign)
    bright = 0.25 + 0.75 * np.clip(normals @ light, 0., 1.)
    nearest = np.full(shape, -np.inf)
    picture = np.full(shape, np.nan)
    edge = np.linalg.norm(corners[:, 1] - corners[:, 0], axis=1).max()
    n = int(np.ceil(edge / size)) + 1
    for s in (np.arange(n) + 0.5) / n:
        for t in (np.arange(n) + 0.5) / n:
            points = ((1 - s) * (1 - t) * corners[:, 0]
                      + s * (1 - t) * corners[:, 1]
                      + s * t * corners[:, 2] + (1 - s) * t * corners[:, 3])
            across = (points[:, right] - low[right] if right_sign > 0
                      else high[right] - points[:, right])
            column = (across / size).astype(int)
            row = ((points[:, up] - low[up]) / size).astype(int)
            away = depth_sign * points[:, depth]
            order = np.argsort(away, kind="stable")
            row, column, away = row[order], column[order], away[order]
            # The last of several facets in one pixel is the nearest.
            closer = away > nearest[row, column]
            place = row[closer], column[closer]
            picture[place] = bright[order][closer]
            nearest[place] = away[closer]
    return picture, (0., shape[1] * size, 0., shape[0] * size)


def draw_outside(mesh, path, axes=None):
    """The body from three sides, those of a person whose front, left side and
    top point along axes, which are rows."""
    names = NAMELESS if axes is None else SIDES
    if axes is not None:
        mesh = {**mesh, **{name: mesh[name].reshape(-1, 3) @ axes.T
                           for name in ("points", "normal")}}
    pictures = [render(mesh, view) for view, _ in zip(VIEWS, SIDES)]
    widths = [extent[1] for _, extent in pictures]
    height = max(extent[3] for _, extent in pictures)
    figure, panels = plt.subplots(
        1, len(SIDES), gridspec_kw={"width_ratios": widths},
        figsize=(min(10., 4.8 * sum(widths) / height + 1.5), 5.2))
    for axis, name, (picture, extent) in zip(panels, names, pictures):
        axis.imshow(picture, cmap="copper", vmin=-0.2, vmax=1.1,
                    extent=extent, interpolation="nearest")
        axis.set_title(name)
        axis.set_axis_off()
    style.save(figure, path)


def draw_cut(axis, mesh, normal, place):
    """Where the plane x_normal = place cuts cells, by tissue."""
    others = [d for d in range(3) if d != normal]
    polygons, cut = fields.cut(mesh, place, normal)
    tissues = mesh["tissue"][cut]
    axis.add_collection(PolyCollection(
        polygons, facecolors=[colour_of(number) for number in tissues],
        edgecolors="#00000030", linewidths=0.1))
    axis.set_aspect("equal")
    axis.autoscale_view()
    if axis.dataLim.width < 0.6 * axis.dataLim.height:
        axis.tick_params(axis="x", labelrotation=90)  # side by side too wide
    axis.grid(False)
    axis.set(xlabel=f"{'xyz'[others[0]]} [m]", ylabel=f"{'xyz'[others[1]]} [m]",
             title=f"{'xyz'[normal]} = {place:.3f} m")
    return set(tissues)


def colour_of(tissue):
    """Colour of a tissue by its number."""
    beyond = int(tissue) - len(TISSUE_COLOURS)
    return TISSUE_COLOURS[tissue] if beyond < 0 \
        else NEW_COLOURS[beyond % len(NEW_COLOURS)]


def draw_cuts(mesh, names, path):
    low, high = mesh["points"].min(axis=0), mesh["points"].max(axis=0)
    size = high - low
    # Just next to the planes of symmetry, where no element has its faces.
    middle = 0.5 * (low + high) + 1e-4 * size
    cuts = [(1, middle[1]), (0, middle[0]), (2, middle[2])]
    if size[2] > 2. * size[1]:
        cuts = [(1, 1e-4), (0, -0.02), (2, low[2] + 0.955 * size[2]),
                (2, low[2] + 0.72 * size[2])]
        figure = plt.figure(figsize=(10., 6.3))
        grid = figure.add_gridspec(2, 4, width_ratios=[1., 1.2, 1.2, 0.5])
        axes = [figure.add_subplot(place) for place in (
            grid[:, 0], grid[:, 1], grid[0, 2], grid[1, 2])]
    else:
        figure, axes = plt.subplots(1, 4, figsize=(10., 3.6))
        axes[3].set_axis_off()
    seen = set()
    for axis, (normal, place) in zip(axes, cuts):
        seen |= draw_cut(axis, mesh, normal, place)
    figure.legend(handles=[Patch(facecolor=colour_of(number),
                                 edgecolor=style.GREY, label=names[number])
                           for number in sorted(seen)],
                  loc="upper center", bbox_to_anchor=(0.5, 0.), ncols=5)
    style.save(figure, path)


def draw_quality(rows, path):
    rows = [row for row in rows if row["kind"] == "part"]
    names = [row["name"] for row in rows]
    columns = [("volume [m^3]", 1e3, "volume [litre]", "log"),
               ("smallest scaled Jacobian", 1., "smallest scaled Jacobian",
                "linear"),
               ("time step [s]", 1e6, "time step [µs]", "log")]
    figure, axes = plt.subplots(1, 3, sharey=True,
                                figsize=(11., 0.3 * len(rows) + 1.5))
    for axis, (key, factor, label, scale), colour in zip(axes, columns,
                                                         style.COLOURS):
        values = [factor * float(row[key]) for row in rows]
        axis.barh(names, values, color=colour)
        axis.set(xlabel=label, xscale=scale)
        for place, value in enumerate(values):
            axis.annotate(f" {value:.3g}", (value, place), va="center",
                          fontsize=8)
        axis.margins(x=0.25)
    axes[0].invert_yaxis()
    style.save(figure, path)
