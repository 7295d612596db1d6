# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Tables of a run, history.csv and probes.csv, and their pictures."""

import csv
import math
import os
import re

import matplotlib.pyplot as plt
import numpy as np

import look


class Table:
    """Columns by name, with units; the header reads 'name [unit],...'."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            header = next(csv.reader(file))
            self.values = np.loadtxt(file, delimiter=",", ndmin=2)
        self.names, self.units = [], []
        for entry in header:
            match = re.fullmatch(r"\s*(.*?)\s*(?:\[(.*)\])?\s*", entry)
            self.names.append(match[1])
            self.units.append(match[2] or "-")
        if self.values.shape[1] != len(header):
            raise ValueError(f"{path}: {len(header)} names for "
                             f"{self.values.shape[1]} columns")

    def __contains__(self, name):
        return name in self.names

    def __getitem__(self, name):
        return self.values[:, self.names.index(name)]

    def unit(self, name):
        return self.units[self.names.index(name)]

    def others(self, *names):
        return [name for name in self.names if name not in names]


def open_table(folder, name):
    path = os.path.join(folder, name)
    return Table(path) if os.path.exists(path) else None


def _time_axis(table):
    """Time in readable units, and the axis label."""
    time = table["time"]
    factor, unit = look.scale_unit("s", np.max(np.abs(time)))
    return time * factor, look.label("time", unit)


def _panels(count):
    columns = 1 if count == 1 else 2
    rows = math.ceil(count / columns)
    figure, axes = plt.subplots(rows, columns, squeeze=False, sharex=True,
                                figsize=(4.6 * columns + 0.4,
                                         2.3 * rows + 0.4))
    for spare in axes.flat[count:]:
        spare.set_axis_off()
    return figure, axes.flat


def draw_history(table, path):
    """One panel for each column of the history."""
    names = table.others("step", "time")
    time, time_label = _time_axis(table)
    figure, axes = _panels(len(names))
    for axis, name in zip(axes, names):
        values = table[name]
        factor, unit = look.scale_unit(table.unit(name),
                                       np.max(np.abs(values)))
        axis.plot(time, values * factor, color=look.COLOURS[0])
        axis.set_title(name)
        axis.set_ylabel(unit or "-")
        axis.set_xlabel(time_label)
        axis.ticklabel_format(axis="y", useOffset=False)
        spread = np.ptp(values)
        if spread <= 1e-9 * np.max(np.abs(values)):
            _show_as_constant(axis, values, factor)
    look.save(figure, path)


def _show_as_constant(axis, values, factor):
    """A conserved total: the axis hides round-off, a note tells it."""
    middle = values[0] * factor
    width = 0.1 * abs(middle) if middle != 0. else 1.
    axis.set_ylim(middle - width, middle + width)
    if middle != 0.:
        change = np.max(np.abs(values / values[0] - 1.))
        axis.annotate(f"relative change at most {change:.0e}", (0.02, 0.85),
                      xycoords="axes fraction", color=look.GREY, fontsize=9)


def draw_probes(table, path):
    """Overpressure against time at each probe, one below the other."""
    names = [name for name in table.names
             if "pressure" in name and "dynamic" not in name]
    if not names:
        return
    time, time_label = _time_axis(table)
    figure, axes = plt.subplots(len(names), 1, squeeze=False, sharex=True,
                                figsize=(7., 1.5 * len(names) + 0.8))
    for number, (axis, name) in enumerate(zip(axes[:, 0], names)):
        over = table[name] - table[name][0]
        factor, unit = look.scale_unit("Pa", np.max(np.abs(over)))
        colour = look.COLOURS[number % 6]
        axis.axhline(0., color=look.GREY, linewidth=0.6)
        axis.fill_between(time, 0., over * factor, color=colour, alpha=0.15,
                          linewidth=0.)
        axis.plot(time, over * factor, color=colour)
        peak = np.argmax(over)
        axis.annotate(f"{over[peak] * factor:.3g} {unit}",
                      (time[peak], over[peak] * factor), (6, -4),
                      textcoords="offset points", fontsize=9)
        axis.set_title(name)
        axis.set_ylabel(unit)
    axes[-1, 0].set_xlabel(time_label)
    figure.suptitle("Overpressure at the probes", x=0.01, ha="left")
    look.save(figure, path)
