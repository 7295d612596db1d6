# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of history.csv and probes.csv over time."""

import matplotlib.pyplot as plt
import numpy as np

from plot.figures import style


def _time_axis(table):
    """Time in readable units, and the axis label."""
    time = table["time"]
    factor, unit = style.scale_unit("s", np.max(np.abs(time)))
    return time * factor, style.label("time", unit)


def draw_history(table, path):
    """One panel for each unit among the columns of the history."""
    groups = {}
    for name in table.others("step", "time"):
        groups.setdefault(table.unit(name), []).append(name)
    rows = -(-len(groups) // 2)
    figure, axes = plt.subplots(rows, 2, squeeze=False, sharex=True,
                                figsize=(9.6, 2.5 * rows + 0.4))
    for spare in axes.flat[len(groups):]:
        spare.set_axis_off()
    for axis, (unit, names) in zip(axes.flat, groups.items()):
        _draw_group(axis, table, unit, names)
    for axis in axes[-1, :]:
        axis.set_xlabel(_time_axis(table)[1])
    style.save(figure, path)


def _draw_group(axis, table, unit, names):
    time = _time_axis(table)[0]
    columns = [table[name] for name in names]
    together = np.concatenate(columns)
    largest = np.abs(together).max()
    smallest = together[together > 0.].min(initial=largest)
    is_log = np.all(together >= 0.) and largest > 100. * smallest > 0.
    factor, shown = style.scale_unit(unit, largest)
    for name, values in zip(names, columns):
        if np.max(np.abs(values)) < 1e-9 * largest:
            values = np.zeros_like(values)
        if is_log:
            values = np.where(values > 0., values, np.nan)
        axis.plot(time, values * factor, label=name.replace("_", " "))
    if is_log:
        axis.set_yscale("log")
    else:
        axis.ticklabel_format(axis="y", useOffset=False)
        _tell_constant(axis, columns, factor)
    axis.set_ylabel(style.label("", shown).strip())
    if len(names) > 1:
        axis.legend()
    else:
        axis.set_title(names[0].replace("_", " "))


def _tell_constant(axis, columns, factor):
    """A conserved total: the axis hides round-off, a note tells it."""
    if len(columns) > 1 or columns[0][0] == 0.:
        return
    first = columns[0][0]
    change = np.max(np.abs(columns[0] / first - 1.))
    if change < 1e-9:
        width = 0.1 * abs(first) * factor
        axis.set_ylim(first * factor - width, first * factor + width)
        axis.annotate(f"relative change at most {change:.0e}", (0.02, 0.85),
                      xycoords="axes fraction", color=style.GREY, fontsize=9)


def draw_probes(table, references, path):
    """Overpressure against time at each probe, one below the other, and what
    references say."""
    names = [name for name in table.names
             if "pressure" in name and "dynamic" not in name]
    if not names:
        return
    figure, axes = plt.subplots(len(names), 1, squeeze=False, sharex=True,
                                figsize=(7., 1.5 * len(names) + 0.8))
    for number, (axis, name) in enumerate(zip(axes[:, 0], names)):
        probe = name.replace("_pressure", "")
        _draw_probe(axis, table, name, references.get(probe, {}),
                    style.COLOURS[number % 6])
        axis.set_title(probe.replace("_", " "))
    axes[-1, 0].set_xlabel(_time_axis(table)[1])
    figure.suptitle("Overpressure at the probes"
                    + "; dashed: reference" * bool(references),
                    x=0.01, ha="left")
    style.save(figure, path)


def _draw_probe(axis, table, name, known, colour):
    time = _time_axis(table)[0]
    over = table[name] - table[name][0]
    factor, unit = style.scale_unit("Pa", max(
        np.max(np.abs(over)), known.get("peak_overpressure", 0.)))
    style.draw_wave(axis, time, over * factor, colour, 1.5)
    peak = np.argmax(over)
    axis.annotate(f"{over[peak] * factor:.3g} {unit}",
                  (time[peak], over[peak] * factor), (14, -4),
                  textcoords="offset points", fontsize=9)
    axis.set_ylabel(unit)
    if "peak_overpressure" in known and "arrival" in known:
        axis.set_xlim(axis.get_xlim())
        _draw_reference(axis, known, time[-1] / table["time"][-1], factor,
                        unit)


def _draw_reference(axis, known, time_factor, factor, unit):
    """A cross at arrival and peak, which the title tells, and Friedlander's
    curve through them with the reference's duration and impulse."""
    arrival = known["arrival"] * time_factor
    peak = known["peak_overpressure"] * factor
    axis.plot(arrival, peak, "x", markersize=7, markeredgewidth=1.5,
              color="black")
    # Next to the cross of an early arrival are the axis and its ticks.
    axis.set_title(f"reference: {peak:.3g} {unit}", loc="right", fontsize=9,
                   fontweight="normal")
    if known.get("duration", 0.) > 0. and known.get("impulse", 0.) > 0.:
        decay = _friedlander_decay(
            known["impulse"] / (known["peak_overpressure"]
                                * known["duration"]))
        x = np.linspace(0., 1.5, 300)
        axis.plot(arrival + x * known["duration"] * time_factor,
                  peak * (1. - x) * np.exp(-decay * x), color="black",
                  linestyle="--", linewidth=1.)


def _friedlander_decay(part):
    """The decay b for which (1 - x) exp(-b x) has the integral @p part from 0
    to 1, by bisection."""
    low, high = 1e-3, 1e3
    for _ in range(60):
        b = np.sqrt(low * high)
        low, high = (b, high) if (1. - (1. - np.exp(-b)) / b) / b > part \
            else (low, b)
    return b
