# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of pressure in cuts through a body, with its energies and probes."""

import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

from plot.analysis import wave_times
from plot.readers import fields, tables
from plot.figures import style


HEAD = 0.3  # height of what is drawn of a head [m]


def limits(shapes, head_only):
    """Limits of polygons, or of their upper part: left and right, bottom and
    top."""
    points = np.concatenate([shape.reshape(-1, 2) for shape in shapes])
    low, top = points[:, 1].min(), points[:, 1].max()
    low = max(low, top - HEAD) if head_only else low
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
        _add_cut(axis, shape, values * factor, norm)
        axis.set(aspect="equal", xlim=across, ylim=(low, top),
                 title=f"{1e3 * time:.2f} ms")
    figure.colorbar(axes[0, 0].collections[0], ax=axes, shrink=0.7,
                    extend=style.beyond(factor * np.concatenate(shown), norm),
                    label=f"pressure [{unit}]")
    style.save(figure, path)


def _add_cut(axis, polygons, values, norm):
    axis.add_collection(PolyCollection(
        polygons, array=values, cmap=style.DIVERGING, norm=norm,
        edgecolors="face", linewidths=0.1))


def draw_energies(folder, path):
    table = tables.Table(os.path.join(folder, "history.csv"))
    figure, axis = plt.subplots(figsize=(7., 4.))
    for name in ("external_work", "kinetic_energy", "stored_energy",
                 "hourglass_energy", "bulk_viscosity_energy",
                 "relaxation_energy", "energy_residual"):
        axis.plot(1e3 * table["time"], table[name],
                  label=name.replace("_", " "))
    axis.set(xlabel="time [ms]", ylabel="energy [J]")
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
    axis.set(xlabel="time [ms]", ylabel="pressure [kPa]")
    axis.legend(ncol=3)
    norm = style.about_zero(0.8e-3 * max(np.abs(values).max()
                                         for values in pressures.values()))
    drawn = []
    for number, (when, pieces) in enumerate(outputs):
        part = figure.add_subplot(grid[1, number], aspect="equal",
                                  title=f"{1e3 * when:.2f} ms")
        part.set_axis_off()
        shape, values = fields.cut_values(pieces, 1e-4, "pressure")
        drawn.append(1e-3 * values)
        _add_cut(part, shape, drawn[-1], norm)
        part.autoscale_view()
    if outputs:
        figure.colorbar(part.collections[0], ax=figure.axes[1:],
                        extend=style.beyond(np.concatenate(drawn), norm),
                        label="pressure [kPa]", shrink=0.9)
    style.save(figure, path)
