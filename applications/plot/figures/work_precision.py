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


class Key:
    """Which colour, marker and line a series has: the colour tells the first
    factor that refines nothing, marker and line tell the others."""

    def __init__(self, study):
        self.factors = [number for number, factor
                        in enumerate(study["factors"])
                        if not factor["refines"]]
        self.names = [study["factors"][number]["name"]
                      for number in self.factors]
        self.first, self.others = [], []
        self.recommended = study["recommended"] is not None
        for row in study["rows"]:
            if not row["error"]:
                continue
            for known, name in zip((self.first, self.others),
                                   self.parts(row)):
                if name not in known:
                    known.append(name)

    def parts(self, row):
        labels = [row["labels"][number] for number in self.factors]
        return (labels[0] if labels else "", ", ".join(labels[1:]))

    def style_of(self, row):
        first, other = self.parts(row)
        number = self.others.index(other)
        if not any(self.others):
            number = self.first.index(first)
        colour = style.COLOURS[self.first.index(first) % 7]
        dashes = STYLES[self.others.index(other) % len(STYLES)]
        return {"color": colour, "linestyle": dashes,
                "marker": MARKERS[number % len(MARKERS)]}

    def legend(self, axis, orders):
        handles = []
        if any(self.first):
            handles.append(Line2D([], [], linestyle="", label=self.names[0]))
        for number, name in enumerate(self.first):
            if not name:
                continue
            order = orders.get(name) if not any(self.others) else None
            label = name + (f" (order {order:.2g})" if order else "")
            marker = ("" if any(self.others)
                      else MARKERS[number % len(MARKERS)])
            handles.append(Line2D([], [], color=style.COLOURS[number % 7],
                                  marker=marker, label=label))
        if any(self.others):
            handles.append(Line2D([], [], linestyle="", label=""))
            handles.append(Line2D([], [], linestyle="",
                                  label=", ".join(self.names[1:])))
            for number, name in enumerate(self.others):
                handles.append(Line2D(
                    [], [], color=style.GREY,
                    linestyle=STYLES[number % len(STYLES)],
                    marker=MARKERS[number % len(MARKERS)],
                    label=name or "–"))
        handles.append(Line2D([], [], linestyle="", label=""))
        handles.append(Line2D([], [], color="black", marker="o",
                              markersize=11, markerfacecolor="none",
                              linestyle="", label="no other is better\n"
                              "in error and cost"))
        if self.recommended:
            handles.append(Line2D([], [], color="black", marker="*",
                                  markersize=11, linestyle="",
                                  label="recommended"))
        axis.legend(handles=handles, loc="upper left",
                    bbox_to_anchor=(1.02, 1.), borderaxespad=0.)


def last_orders(study):
    """The order between the two finest meshes, by the first factor."""
    orders = {}
    for number, label in enumerate(study["series"]):
        rows = [row for row in study["rows"]
                if row["series"] == number and row["order"] is not None]
        if rows:
            orders[label] = min(rows, key=lambda row: row["width"])["order"]
    return orders


def draw_panel(axis, study, key, quantity, label):
    for number in range(len(study["series"])):
        rows = [row for row in study["rows"]
                if row["series"] == number and row["error"]
                and row[quantity]]
        rows.sort(key=lambda row: (-row["width"] if row["width"] else 0.,
                                   row[quantity]))
        if rows:
            axis.plot([row[quantity] for row in rows],
                      [row["error"] for row in rows],
                      markersize=5, **key.style_of(rows[0]))
    front = [row for row in study["rows"] if row["front"] and row["error"]]
    if quantity == "cost":
        axis.plot([row["cost"] for row in front],
                  [row["error"] for row in front], linestyle="", marker="o",
                  markersize=11, markerfacecolor="none", color="black",
                  markeredgewidth=0.8)
    if study["wanted"]:
        axis.axhline(study["wanted"], color=style.GREY, linewidth=0.8)
        axis.annotate("wanted", (0.99, study["wanted"]), (0, 3),
                      xycoords=("axes fraction", "data"), ha="right",
                      textcoords="offset points", fontsize=9,
                      color=style.GREY)
    if study["recommended"] is not None:
        row = study["rows"][study["recommended"]]
        axis.plot(row[quantity], row["error"], marker="*", markersize=11,
                  color="black")
    axis.set_xscale("log")
    axis.set_yscale("log")
    # Costs that hardly differ would get labels with many digits.
    low, high = axis.get_xlim()
    if high < 4. * low:
        middle = (low * high) ** 0.5
        axis.set_xlim(0.25 * middle, 4. * middle)
    axis.grid(True, which="minor", linewidth=0.3)
    axis.set_xlabel(label)


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
