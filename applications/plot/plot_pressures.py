#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws pressures at the probes of a run of biomechanics:
plot_pressures.py OUTPUT_FOLDER NAME[=KILOPASCALS] ...

Names are those of probe 1, 2, and so on, each with a measured extreme of its
pressure, if there is one. Prints both side by side and writes
pictures/pressures.png, with cuts through the body at y = 0.
"""

import os
import sys

import numpy as np
from matplotlib.collections import PolyCollection

import look
import tables
import usage
import vtk_file
from look import plt
from plot_solid import cut, open_fields


def draw(folder, time, pressures, references, path):
    """Pressures by name over time, with measured extremes [kPa] by name."""
    figure = plt.figure(figsize=(9., 6.))
    fields = open_fields(folder)
    grid = figure.add_gridspec(2, max(1, len(fields)), height_ratios=[2, 1])
    axis = figure.add_subplot(grid[0, :])
    for name, values in pressures.items():
        line, = axis.plot(1e3 * time, 1e-3 * values, label=name)
        if name in references:
            axis.axhline(references[name], color=line.get_color(),
                         linewidth=0.8, linestyle="--")
    axis.set_xlabel("time [ms]")
    axis.set_ylabel("pressure [kPa]")
    axis.legend(ncol=3)
    norm = look.about_zero(0.8e-3 * max(np.abs(values).max()
                                        for values in pressures.values()))
    for number, (when, pieces) in enumerate(fields):
        part = figure.add_subplot(grid[1, number])
        part.set_axis_off()
        part.set_title(f"{1e3 * when:.2f} ms")
        for piece in pieces:
            mesh = vtk_file.read(piece)
            shape, found = cut(mesh, 1e-4)
            part.add_collection(PolyCollection(
                shape, array=1e-3 * mesh["pressure"][found], norm=norm,
                cmap=look.DIVERGING, edgecolors="face", linewidths=0.1))
        part.set_aspect("equal")
        part.autoscale_view()
    if fields:
        figure.colorbar(part.collections[0], ax=figure.axes[1:],
                        label="pressure [kPa]", shrink=0.9)
    look.save(figure, path)


def pressures_of(folder, names):
    """Time and pressures by name, of as many probes; None without any."""
    table = tables.open_table(folder, "probes.csv")
    if table is None:
        print(f"{folder} has no probes.csv", file=sys.stderr)
        return None, None
    return table["time"], {
        name: table[f"probe_{number}_pressure"]
        for number, name in enumerate(names, start=1)}


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 1
    folder = arguments[0]
    names, references = [], {}
    for argument in arguments[1:]:
        name, _, number = argument.partition("=")
        names.append(name)
        if number:
            references[name] = float(number)
    time, pressures = pressures_of(folder, names)
    if time is None:
        return 1
    print(f"{'':16} {'highest':>8} {'lowest':>8} {'measured':>9}  [kPa]")
    for name, values in pressures.items():
        print(f"{name:16} {1e-3 * values.max():8.0f} "
              f"{1e-3 * values.min():8.0f} {references.get(name, ''):>9}")
    look.set_up()
    pictures = os.path.join(folder, "pictures")
    os.makedirs(pictures, exist_ok=True)
    draw(folder, time, pressures, references,
         os.path.join(pictures, "pressures.png"))
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
