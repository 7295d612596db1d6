# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of the outputs of a study over its factors: curves over one, and
charts with contours over two."""

import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

from plot.figures import style, work_precision

MOST_PANELS, MOST_COLUMNS = 12, 3
# Axes whose numbers span more than this factor are logarithmic, unless the smallest
# are nothing next to the largest, as probabilities of what does not happen.
LOGARITHMIC_X, LOGARITHMIC_Y = 4., 10.
NOTHING = 1e-6


def numbers(study, factor):
    """Values of a factor in all rows; None where one is no number."""
    values = [row["numbers"][factor] for row in study["rows"]]
    return None if None in values else values


def numeric_factors(study):
    """Factors with at least two different numbers, those of meshes last."""
    found = [number for number in range(len(study["factors"]))
             if len(set(numbers(study, number) or [])) > 1]
    return sorted(found, key=lambda number: study["factors"][number]["refines"])


def shown_columns(study):
    """Columns with at least one finite value, in lists as long as a picture can
    show."""
    known = [number for number in range(len(study["columns"]))
             if any(value(row, number) is not None for row in study["rows"])]
    return [known[begin:begin + MOST_PANELS]
            for begin in range(0, len(known), MOST_PANELS)]


def value(row, column):
    return row["columns"][column] if row["columns"] else None


def spans(values, ratio):
    """Whether positive numbers span more than this ratio, and none is NOTHING."""
    return min(values) > NOTHING * max(values) > 0. \
        and max(values) > ratio * min(values)


def title(study):
    """Title of a picture, with the number of runs that have no values, and the
    outputs that no run has."""
    missing = sum(not row["columns"] for row in study["rows"])
    shown = [number for page in shown_columns(study) for number in page]
    unknown = [column["title"] for number, column
               in enumerate(study["columns"]) if number not in shown]
    return study["title"] + (
        f" ({missing} of {len(study['rows'])} runs did not finish)"
        if missing else "") + (
            "\nwithout a value: " + ", ".join(unknown) if unknown else "")


def pictures(study, folder, name):
    """The axes and the columns of each picture, NAME, then NAME_2 and so on, which
    is saved before the next one."""
    for number, columns in enumerate(shown_columns(study), 1):
        across = min(len(columns), MOST_COLUMNS)
        rows = math.ceil(len(columns) / across)
        figure, axes = plt.subplots(
            rows, across, squeeze=False,
            figsize=(4.2 * across + 0.6, 3.3 * rows + 0.6))
        for axis in axes.flat[len(columns):]:
            axis.set_visible(False)
        yield list(axes.flat[:len(columns)]), columns
        figure.suptitle(title(study), x=0.01, ha="left")
        work_precision.save(figure, folder,
                            name if number == 1 else f"{name}_{number}")


def scale(axis, direction, values, ratio):
    """Makes the "x" or "y" axis of values that span this ratio logarithmic."""
    if spans(values, ratio):
        axis.set(**{f"{direction}scale": "log"})
        style.label_decades(getattr(axis, f"{direction}axis"))


def label_factor(axis, direction, factor, values):
    axis.set(**{f"{direction}label": style.label(factor["name"],
                                                 factor["unit"])})
    scale(axis, direction, values, LOGARITHMIC_X)


def lines_by_label(study, across):
    """Rows by the labels of all factors but the one across, in their order;
    each sorted along that factor."""
    lines = {}
    for row in study["rows"]:
        label = ", ".join(text for number, text in enumerate(row["labels"])
                          if number != across)
        lines.setdefault(label, []).append(row)
    for rows in lines.values():
        rows.sort(key=lambda row: row["numbers"][across])
    return lines


def draw_curves(study, folder):
    """Each output over the first factor with numbers, a line for each
    combination of the others. Returns whether there was something to draw."""
    factors = numeric_factors(study)
    if not factors or not shown_columns(study):
        return False
    across = factors[0]
    lines = lines_by_label(study, across)
    others = ", ".join(factor["name"]
                       for number, factor in enumerate(study["factors"])
                       if number != across)
    for axes, columns in pictures(study, folder, "curves"):
        for axis, column in zip(axes, columns):
            draw_curve(axis, study, across, column, lines)
        if others:
            # Next to the last panel of the first row.
            axes[min(len(axes), MOST_COLUMNS) - 1].legend(
                title=others, loc="upper left", bbox_to_anchor=(1.02, 1.),
                borderaxespad=0.)
    return True


def is_lower_limit(row, column):
    """Whether the run cut this output off."""
    return bool(row.get("lower_limits")) and row["lower_limits"][column]


def mark_lower_limit(axis, x, y, is_negative):
    """An arrow to where the output may continue; returns it."""
    arrow, offset, side = ("↓", -3, "top") if is_negative else (
        "↑", 3, "baseline")
    axis.annotate(arrow, (x, y), (0, offset), ha="center", va=side,
                  fontsize=11, textcoords="offset points")
    return arrow


def draw_curve(axis, study, across, column, lines):
    """An output over a factor; arrows away from zero where it is a lower
    limit."""
    found = [number for row in study["rows"]
             if (number := value(row, column)) is not None]
    factor, unit = style.scale_unit(study["columns"][column]["unit"] or "-",
                                    max(map(abs, found)))
    for number, (label, rows) in enumerate(lines.items()):
        axis.plot([row["numbers"][across] for row in rows],
                  [math.nan if value(row, column) is None
                   else value(row, column) * factor for row in rows],
                  label=label, markersize=4,
                  color=style.COLOURS[number % len(style.COLOURS)],
                  marker=work_precision.MARKERS[
                      number % len(work_precision.MARKERS)])
    arrows = {mark_lower_limit(axis, row["numbers"][across],
                               value(row, column) * factor,
                               value(row, column) < 0.)
              for row in study["rows"] if is_lower_limit(row, column)}
    notes = [f"{' '.join(sorted(arrows))} cut off by the end of the run"] \
        if arrows else []
    unknown = [row["numbers"][across] for row in study["rows"]
               if value(row, column) is None]
    if unknown:
        axis.vlines(unknown, 0., 1., transform=axis.get_xaxis_transform(),
                    color=style.GREY, linestyle=":", linewidth=0.8)
        notes.append("dotted: unknown")
    axis.set_title("; ".join(notes), fontsize=8)
    reference = study["reference_columns"]
    if reference and reference[column] is not None:
        work_precision.draw_level(axis, reference[column] * factor,
                                  "reference run", 8, "--")
    label_factor(axis, "x", study["factors"][across], numbers(study, across))
    axis.set_ylabel(style.label(study["columns"][column]["title"], unit))
    scale(axis, "y", found, LOGARITHMIC_Y)


def draw_chart(study, folder):
    """Contours of each output over two factors with numbers, as in charts of
    pressure and impulse. Returns whether the study has two such factors and
    no others."""
    factors = numeric_factors(study)
    if len(factors) != 2 or len(study["factors"]) != 2 \
            or not shown_columns(study):
        return False
    across, upwards = sorted(factors)
    x = sorted(set(numbers(study, across)))
    y = sorted(set(numbers(study, upwards)))
    if len(x) * len(y) != len({tuple(row["numbers"])
                               for row in study["rows"]}):
        return False
    for axes, columns in pictures(study, folder, "chart"):
        for axis, column in zip(axes, columns):
            _draw_panel(axis, study, column, x, y)
            label_factor(axis, "x", study["factors"][across], x)
            label_factor(axis, "y", study["factors"][upwards], y)
    return True


def _draw_panel(axis, study, column, x, y):
    """An output over both factors with numbers, which has these values."""
    grid = np.full((len(y), len(x)), np.nan)
    for row in study["rows"]:
        if value(row, column) is not None:
            across, upwards = row["numbers"]
            grid[y.index(upwards), x.index(across)] = value(row, column)
    draw_contours(axis, study["columns"][column], x, y, grid)
    for row in study["rows"]:
        if is_lower_limit(row, column):
            mark_lower_limit(axis, *row["numbers"], value(row, column) < 0.)


def levels_of(values):
    """Round numbers between the smallest and the largest of these, ten to a
    decade at most where they span decades."""
    low, high = float(np.min(values)), float(np.max(values))
    if spans([low, high], LOGARITHMIC_Y):
        decades = range(math.floor(math.log10(low)),
                        math.ceil(math.log10(high)) + 1)
        steps = (1., 2., 5.) if high < 1e4 * low else (1.,)
        levels = [step * 10.**decade for decade in decades for step in steps]
    else:
        levels = plt.MaxNLocator(8).tick_values(low, high)
    return [level for level in levels if low < level < high]


def draw_contours(axis, column, x, y, grid):
    """Map of an output with contours; the runs are dots, crosses where one has
    no value."""
    found = grid[np.isfinite(grid)]
    factor, unit = style.scale_unit(column["unit"] or "-",
                                    float(np.max(np.abs(found))))
    values = np.ma.masked_invalid(grid * factor)
    axis.set(title=style.label(column["title"], unit), facecolor="#cccccc")
    axis.grid(False)
    levels = levels_of(found * factor)
    if levels and min(grid.shape) > 1:
        shades, norm = (np.geomspace, LogNorm()) \
            if spans(found, LOGARITHMIC_Y) else (np.linspace, None)
        ends = shades(float(values.min()), float(values.max()), 24)
        axis.contourf(x, y, values, levels=ends, norm=norm,
                      cmap=style.SEQUENTIAL, alpha=0.6, extend="both")
        lines = axis.contour(x, y, values, levels=levels, colors="black",
                             linewidths=0.9)
        axis.clabel(lines, fmt=lambda level: f"{level:g}", fontsize=8)
    for (j, i), number in np.ndenumerate(grid):
        known = np.isfinite(number)
        axis.plot(x[i], y[j], color="black", markersize=3,
                  marker="o" if known else "x", clip_on=False)
        if known and not levels:
            axis.annotate(f"{values[j, i]:.3g}", (x[i], y[j]), fontsize=8,
                          ha="center", va="bottom")
