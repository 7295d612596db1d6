#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws a run of biomechanics: plot_solid.py OUTPUT_FOLDER [y]

Writes PNG files into OUTPUT_FOLDER/pictures and prints their paths: pressure
in the plane y = 0 (or the given one) at up to eight times in the whole body
and in its head, and energies over time.
"""

import csv
import os
import re
import sys

import numpy as np
from matplotlib.collections import PolyCollection

import look
import usage
import vtk_file
from look import plt
from plot_anatomy import EDGES

MOST_TIMES = 8


def list_fields(folder):
    """Times and the files of each output."""
    with open(os.path.join(folder, "fields.pvd"), encoding="utf-8") as file:
        found = re.findall(r'timestep="([^"]*)"[^>]*file="([^"]*)"',
                           file.read())
    result = []
    for time, name in found:
        path = os.path.join(folder, name)
        pieces = [path]
        if path.endswith(".pvtu"):
            with open(path, encoding="utf-8") as file:
                pieces = [os.path.join(os.path.dirname(path), piece)
                          for piece in re.findall(r'Source="([^"]*)"',
                                                  file.read())]
        result.append((float(time), pieces))
    return result


def open_fields(folder):
    """Up to MOST_TIMES of them, the first one only if there are few."""
    found = list_fields(folder)
    found = found[1:] or found
    chosen = np.unique(np.linspace(0, len(found) - 1, MOST_TIMES).astype(int))
    return [found[number] for number in chosen]


def cut(mesh, place):
    """Polygons (x, z) of the cells that y = place cuts, and their numbers."""
    connectivity = mesh["connectivity"].reshape(-1, 8)
    ends = mesh["points"][:, 1][connectivity]
    found = np.flatnonzero((ends.min(axis=1) <= place)
                           & (ends.max(axis=1) > place))
    corners = mesh["points"][connectivity[found]]
    begin, _ = (corners[:, list(side)] for side in EDGES[1])
    return begin[:, :, [0, 2]], found


def cut_fields(fields, place):
    """Of each output the time, and of the cells that y = place cuts polygons
    and pressures, averaged ones if there are."""
    panels = []
    for time, pieces in fields:
        polygons, values = [], []
        for piece in pieces:
            mesh = vtk_file.read(piece)
            shape, found = cut(mesh, place)
            polygons.append(shape)
            # Averages know nothing of what alternates from element to element.
            name = "averaged_pressure" if "averaged_pressure" in mesh \
                else "pressure"
            values.append(mesh[name][found])
        panels.append((time, np.concatenate(polygons), np.concatenate(values)))
    return panels


def cut_values(pieces, place, name):
    """Of one output polygons and a quantity of the cells that y = place cuts;
    None for a quantity that it does not have."""
    polygons, values = [], []
    for piece in pieces:
        mesh = vtk_file.read(piece)
        if name not in mesh:
            return None
        shape, found = cut(mesh, place)
        polygons.append(shape)
        values.append(mesh[name][found])
    return np.concatenate(polygons), np.concatenate(values)


def draw_pressures(panels, head_only, path):
    """What cut_fields() gave, of the whole body or of its upper 0.3 m."""
    top = max(shape[:, :, 1].max() for _, shape, _ in panels)
    bottom = min(shape[:, :, 1].min() for _, shape, _ in panels)
    low = max(bottom, top - 0.3) if head_only else bottom
    shown = [values[shape[:, :, 1].min(axis=1) >= low]
             for _, shape, values in panels]
    largest = np.percentile(np.abs(np.concatenate(shown)), 99.8)
    factor, unit = look.scale_unit("Pa", largest)
    norm = look.about_zero(largest * factor)
    columns = min(4, len(panels)) if head_only else len(panels)
    rows = -(-len(panels) // columns)
    figure, axes = plt.subplots(
        rows, columns, figsize=(3. * columns, 3.2 * rows) if head_only
        else (1.6 * columns, 6.), squeeze=False)
    for axis in axes.flat:
        axis.set_axis_off()
    for axis, (time, shape, values) in zip(axes.flat, panels):
        axis.add_collection(PolyCollection(
            shape, array=values * factor, cmap=look.DIVERGING, norm=norm,
            edgecolors="face", linewidths=0.1))
        axis.set_aspect("equal")
        axis.autoscale_view()
        if head_only:
            axis.set_ylim(low, top + 0.01)
        axis.set_title(f"{1e3 * time:.2f} ms")
    figure.colorbar(axes[0, 0].collections[0], ax=axes, shrink=0.7,
                    label=f"pressure [{unit}]")
    look.save(figure, path)


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
    look.save(figure, path)


def main(arguments):
    if len(arguments) not in (1, 2):
        print(__doc__, file=sys.stderr)
        return 1
    look.set_up()
    folder = arguments[0]
    # Beside the plane of symmetry, where elements have no faces.
    place = float(arguments[1]) if len(arguments) > 1 else 1e-4
    pictures = os.path.join(folder, "pictures")
    os.makedirs(pictures, exist_ok=True)
    panels = cut_fields(open_fields(folder), place)
    draw_pressures(panels, False, os.path.join(pictures, "sagittal.png"))
    draw_pressures(panels, True, os.path.join(pictures, "sagittal_head.png"))
    draw_energies(folder, os.path.join(pictures, "energies.png"))
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
