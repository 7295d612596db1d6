# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of pressure in cuts through a body, with its energies and probes."""

import csv
import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

from plot.analysis import wave_times
from plot.readers import fields, vtk_file
from plot.figures import style


HEAD = 0.3  # height of what is drawn of a head [m]


def limits(shapes, head_only):
    """Limits of polygons, or of their upper part: left and right, bottom and
    top."""
    points = np.concatenate([shape.reshape(-1, 2) for shape in shapes])
    top = points[:, 1].max()
    low = max(points[:, 1].min(), top - HEAD) if head_only \
        else points[:, 1].min()
    across = points[points[:, 1] >= low, 0]
    return (across.min() - 0.01, across.max() + 0.01), (low, top + 0.01)


def draw_pressures(panels, head_only, path):
    """Draws panels of cut_fields(), of the whole body or of its upper HEAD."""
    across, (low, top) = limits([shape for _, shape, _ in panels], head_only)
    shown = [values[shape[:, :, 1].max(axis=1) > low]
             for _, shape, values in panels]
    largest = np.percentile(np.abs(np.concatenate(shown)), 99.8)
    factor, unit = style.scale_unit("Pa", largest)
    norm = style.about_zero(largest * factor)
    columns = min(4, len(panels)) if head_only else len(panels)
    rows = -(-len(panels) // columns)
    figure, axes = plt.subplots(
        rows, columns, figsize=(2.5 * columns, 2.7 * rows) if head_only
        else (1.25 * columns, 5.2), squeeze=False)
    for axis in axes.flat:
        axis.set_axis_off()
    for axis, (time, shape, values) in zip(axes.flat, panels):
        axis.add_collection(PolyCollection(
            shape, array=values * factor, cmap=style.DIVERGING, norm=norm,
            edgecolors="face", linewidths=0.1))
        axis.set_aspect("equal")
        axis.set_xlim(across)
        axis.set_ylim(low, top)
        axis.set_title(f"{1e3 * time:.2f} ms")
    figure.colorbar(axes[0, 0].collections[0], ax=axes, shrink=0.7,
                    extend=style.beyond(factor * np.concatenate(shown), norm),
                    label=f"pressure [{unit}]")
    style.save(figure, path)


def draw_energies(folder, path):
    with open(os.path.join(folder, "history.csv"), newline="",
              encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [name.split(" [")[0] for name in rows[0]]
    table = np.array(rows[1:], dtype=float)
    time = 1e3 * table[:, names.index("time")]
    figure, axis = plt.subplots(figsize=(7., 4.))
    for name in ("external_work", "kinetic_energy", "stored_energy",
                 "hourglass_energy", "bulk_viscosity_energy",
                 "relaxation_energy", "energy_residual"):
        axis.plot(time, table[:, names.index(name)],
                  label=name.replace("_", " "))
    axis.set_xlabel("time [ms]")
    axis.set_ylabel("energy [J]")
    axis.legend()
    style.save(figure, path)


def draw_probes(folder, time, pressures, references, path):
    """Pressures by name over time, with measured extremes [kPa] by name, and
    cuts if the run has fields."""
    figure = plt.figure(figsize=(9., 6.))
    has_fields = os.path.exists(os.path.join(folder, "fields.pvd"))
    outputs = wave_times.fields_to_draw(folder) if has_fields else []
    grid = figure.add_gridspec(2, max(1, len(outputs)), height_ratios=[2, 1])
    axis = figure.add_subplot(grid[0, :])
    for name, values in pressures.items():
        line, = axis.plot(1e3 * time, 1e-3 * values, label=name)
        if name in references:
            axis.axhline(references[name], color=line.get_color(),
                         linewidth=0.8, linestyle="--")
    axis.set_xlabel("time [ms]")
    axis.set_ylabel("pressure [kPa]")
    axis.legend(ncol=3)
    norm = style.about_zero(0.8e-3 * max(np.abs(values).max()
                                         for values in pressures.values()))
    drawn = []
    for number, (when, pieces) in enumerate(outputs):
        part = figure.add_subplot(grid[1, number])
        part.set_axis_off()
        part.set_title(f"{1e3 * when:.2f} ms")
        for piece in pieces:
            mesh = vtk_file.read(piece)
            shape, found = fields.cut(mesh, 1e-4)
            drawn.append(1e-3 * mesh["pressure"][found])
            part.add_collection(PolyCollection(
                shape, array=drawn[-1], norm=norm,
                cmap=style.DIVERGING, edgecolors="face", linewidths=0.1))
        part.set_aspect("equal")
        part.autoscale_view()
    if outputs:
        figure.colorbar(part.collections[0], ax=figure.axes[1:],
                        extend=style.beyond(np.concatenate(drawn), norm),
                        label="pressure [kPa]", shrink=0.9)
    style.save(figure, path)
