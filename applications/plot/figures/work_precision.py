# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of error against cost, of studies."""

import os
import re
import textwrap

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

from plot.figures import style

MARKERS = "osD^vPX*"
STYLES = ["-", "--", ":", "-."]
COSTS = {"core seconds": "cost [core seconds]", "wall seconds": "wall time [s]",
         "updates": "updates of unknowns or elements",
         "memory": "peak memory [byte]"}


def error_label(study, width):
    """Name of the error, in lines of so many letters; the group of a measure
    in summary.json says nothing to a reader."""
    words = re.sub(r"\b(results|checks|assumptions|errors|conservation|performance)\.", "",
                   study["error"])
    return "\n".join(textwrap.wrap(words, width))


def save(figure, folder, name):
    figure.savefig(os.path.join(folder, f"{name}.svg"),
                   metadata={"Date": None})
    style.save(figure, os.path.join(folder, f"{name}.png"))


def draw_level(axis, value, words, fontsize, linestyle="-"):
    """A line across an axis with words at its right end."""
    axis.axhline(value, color=style.GREY, linewidth=0.8, linestyle=linestyle)
    axis.annotate(words, (0.99, value), (0, 3), ha="right", color=style.GREY,
                  xycoords=("axes fraction", "data"),
                  textcoords="offset points", fontsize=fontsize)


class Key:
    """Which colour, marker and line a series has: the colour tells the first
    factor that refines nothing, marker and line tell the others."""

    def __init__(self, study):
        self.factors = [number for number, factor
                        in enumerate(study["factors"])
                        if not factor["refines"]]
        self.names = [study["factors"][number]["name"]
                      for number in self.factors]
        parts = [self.parts(row) for row in study["rows"] if row["error"]]
        # Each once, in their order.
        self.first, self.others = (list(dict.fromkeys(names)) for names in
                                   (zip(*parts) if parts else ((), ())))
        self.recommended = study["recommended"] is not None

    def parts(self, row):
        labels = [row["labels"][number] for number in self.factors]
        return (labels[0] if labels else "", ", ".join(labels[1:]))

    def style_of(self, row):
        first, other = self.parts(row)
        first, other = self.first.index(first), self.others.index(other)
        number = other if any(self.others) else first
        return {"color": style.COLOURS[first % 7],
                "linestyle": STYLES[other % len(STYLES)],
                "marker": MARKERS[number % len(MARKERS)]}

    def legend(self, axis, orders):
        handles = []

        def add(label, **options):
            handles.append(Line2D([], [], label=label,
                                  **{"linestyle": "", **options}))

        has_others = any(self.others)
        if any(self.first):
            add(self.names[0])
        for number, name in enumerate(self.first):
            order = None if has_others else orders.get(name)
            if name:
                add(name + (f" (order {order:.2g})" if order else ""),
                    color=style.COLOURS[number % 7], linestyle="-",
                    marker="" if has_others else MARKERS[number % len(MARKERS)])
        if has_others:
            add("")
            add(", ".join(self.names[1:]))
            for number, name in enumerate(self.others):
                add(name or "–", color=style.GREY,
                    linestyle=STYLES[number % len(STYLES)],
                    marker=MARKERS[number % len(MARKERS)])
        add("")
        add("no other is better\nin error and cost", color="black", marker="o",
            markersize=11, markerfacecolor="none")
        if self.recommended:
            add("recommended", color="black", marker="*", markersize=11)
        axis.legend(handles=handles, loc="upper left",
                    bbox_to_anchor=(1.02, 1.), borderaxespad=0.)


def last_orders(study):
    """The order between the two finest meshes, by the first factor."""
    rows = [row for row in reversed(study["rows"]) if row["order"] is not None]
    # The finest one of a series comes last.
    return {study["series"][row["series"]]: row["order"]
            for row in sorted(rows, key=lambda row: -row["width"])}


def draw_panel(axis, study, key, quantity, label):
    for number, _ in enumerate(study["series"]):
        rows = sorted((row for row in study["rows"] if row["series"] == number
                       and row["error"] and row[quantity]),
                      key=lambda row: (-(row["width"] or 0.), row[quantity]))
        if rows:
            axis.plot([row[quantity] for row in rows],
                      [row["error"] for row in rows],
                      markersize=5, **key.style_of(rows[0]))
    if quantity == "cost":
        front = [row for row in study["rows"] if row["front"] and row["error"]]
        axis.plot([row["cost"] for row in front],
                  [row["error"] for row in front], linestyle="", marker="o",
                  markersize=11, markerfacecolor="none", color="black",
                  markeredgewidth=0.8)
    if study["wanted"]:
        draw_level(axis, study["wanted"], "wanted", 9)
    if study["recommended"] is not None:
        row = study["rows"][study["recommended"]]
        axis.plot(row[quantity], row["error"], marker="*", markersize=11,
                  color="black")
    axis.set(xscale="log", yscale="log", xlabel=label)
    # Costs that hardly differ would get labels with many digits.
    low, high = axis.get_xlim()
    if high < 4. * low:
        middle = (low * high) ** 0.5
        axis.set_xlim(0.25 * middle, 4. * middle)
    axis.grid(True, which="minor", linewidth=0.3)


def draw_work_precision(study, folder):
    key = Key(study)
    figure, axes = plt.subplots(1, 2, sharey=True, figsize=(11., 4.6))
    draw_panel(axes[0], study, key, "cost", COSTS[study["cost"]])
    draw_panel(axes[1], study, key, "unknowns", "unknowns at the end")
    axes[0].set_ylabel(error_label(study, 40))
    axes[0].set_title("against cost: lower left is better")
    axes[1].set_title("against size")
    figure.suptitle(study["title"], x=0.01, ha="left")
    key.legend(axes[1], last_orders(study))
    save(figure, folder, "work_precision")
