#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws what a study found: plot_study.py OUTPUT_FOLDER

Reads study.json there and writes, as PNG and SVG, pictures/work_precision
(error against cost and against unknowns) or pictures/stability_map (what
became of each variant over the plane of two factors).
"""

import json
import os
import re
import sys
import textwrap

import look
import usage

import matplotlib.pyplot as plt  # noqa: E402 (after look chose the backend)
from matplotlib.colors import ListedColormap  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Patch  # noqa: E402

MARKERS = "osD^vPX*"
STYLES = ["-", "--", ":", "-."]

# Outcome: colour, letter in the map, words of the legend.
OUTCOMES = {
    "stable": ("#009E73", "", "stable"),
    "retried": ("#F0E442", "r", "stable after cutting back steps"),
    "inaccurate": ("#E69F00", "", "finished, but less accurate than wanted"),
    "refused": ("#BBBBBB", "–", "refused, with a line that says why"),
    "unstable": ("#D55E00", "u", "unstable: no step was small enough"),
    "timed out": ("#CC79A7", "t", "ended at the time limit"),
    "failed": ("#000000", "f", "failed: the process or the machine"),
}

COSTS = {"core seconds": "cost [core seconds]", "wall seconds": "wall time [s]",
         "updates": "updates of unknowns or elements", "memory": "peak memory [byte]"}


def read_study(folder):
    with open(os.path.join(folder, "study.json"), encoding="utf-8") as file:
        return json.load(file)


def error_label(study, width):
    """What the error is, in lines of so many letters; the group of a measure in
    summary.json says nothing to a reader."""
    words = re.sub(r"\b(assumptions|errors|conservation|performance)\.", "",
                   study["error"])
    return "\n".join(textwrap.wrap(words, width))


def save(figure, folder, name):
    figure.savefig(os.path.join(folder, f"{name}.svg"),
                   metadata={"Date": None})
    look.save(figure, os.path.join(folder, f"{name}.png"))


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

    def look_of(self, row):
        first, other = self.parts(row)
        number = self.others.index(other)
        if not any(self.others):
            number = self.first.index(first)
        colour = look.COLOURS[self.first.index(first) % 7]
        style = STYLES[self.others.index(other) % len(STYLES)]
        return {"color": colour, "linestyle": style,
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
            handles.append(Line2D([], [], color=look.COLOURS[number % 7],
                                  marker=marker, label=label))
        if any(self.others):
            handles.append(Line2D([], [], linestyle="", label=""))
            handles.append(Line2D([], [], linestyle="",
                                  label=", ".join(self.names[1:])))
            for number, name in enumerate(self.others):
                handles.append(Line2D(
                    [], [], color=look.GREY,
                    linestyle=STYLES[number % len(STYLES)],
                    marker=MARKERS[number % len(MARKERS)],
                    label=name or "–"))
        handles.append(Line2D([], [], linestyle="", label=""))
        handles.append(Line2D([], [], color="black", marker="o",
                              markersize=11, markerfacecolor="none",
                              linestyle="", label="no other is better\nin error and cost"))
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
                      markersize=5, **key.look_of(rows[0]))
    front = [row for row in study["rows"] if row["front"] and row["error"]]
    if quantity == "cost":
        axis.plot([row["cost"] for row in front],
                  [row["error"] for row in front], linestyle="", marker="o",
                  markersize=11, markerfacecolor="none", color="black",
                  markeredgewidth=0.8)
    if study["wanted"]:
        axis.axhline(study["wanted"], color=look.GREY, linewidth=0.8)
        axis.annotate("wanted", (0.99, study["wanted"]), (0, 3),
                      xycoords=("axes fraction", "data"), ha="right",
                      textcoords="offset points", fontsize=9,
                      color=look.GREY)
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


def judged(row, study):
    """The outcome of a row, for the map."""
    usable = row["outcome"] in ("stable", "retried")
    if usable and row["error"] and row["error"] > study["wanted"] > 0.:
        return "inaccurate"
    return row["outcome"]


def letter_of(row, kind):
    """What stands in a cell of the map: error, number of retries, letter."""
    text = OUTCOMES[kind][1]
    if row["outcome"] == "retried":
        text = f"{row['retries']:.0f}"
    if row["error"]:
        text = f"{row['error']:.1e}".replace("e-0", "e-") + (
            f"\n({text})" if text else "")
    return text


def draw_stability_map(study, folder):
    across, upwards = study["factors"]
    shown = [kind for kind in OUTCOMES
             if any(judged(row, study) == kind for row in study["rows"])]
    kinds = list(OUTCOMES)
    cells = [[None] * len(across["labels"]) for _ in upwards["labels"]]
    width = max(4., 0.55 * len(across["labels"]) + 1.5)
    height = max(3., 0.38 * len(upwards["labels"]) + 1.2)
    figure, axis = plt.subplots(figsize=(width + 3., height))
    for row in study["rows"]:
        i = across["labels"].index(row["labels"][0])
        j = upwards["labels"].index(row["labels"][1])
        kind = judged(row, study)
        cells[j][i] = kinds.index(kind)
        axis.annotate(letter_of(row, kind), (i, j), ha="center", va="center",
                      fontsize=7, color="white" if kind in
                      ("unstable", "failed", "stable") else "black")
    colours = ListedColormap([OUTCOMES[kind][0] for kind in kinds])
    grid = [[float("nan") if cell is None else cell for cell in line]
            for line in cells]
    axis.imshow(grid, cmap=colours, vmin=-0.5, vmax=len(kinds) - 0.5,
                aspect="auto")
    crowded = (len(across["labels"]) > 8
               or max(map(len, across["labels"])) > 10)
    axis.set_xticks(range(len(across["labels"])), across["labels"],
                    rotation=45 if crowded else 0,
                    ha="right" if crowded else "center",
                    rotation_mode="anchor" if crowded else None)
    axis.set_yticks(range(len(upwards["labels"])), upwards["labels"])
    axis.set_xticks([i - 0.5 for i in range(len(across["labels"]))],
                    minor=True)
    axis.set_yticks([j - 0.5 for j in range(len(upwards["labels"]))],
                    minor=True)
    axis.grid(False)
    axis.grid(True, which="minor", color="white", linewidth=1.5)
    axis.tick_params(which="both", length=0)
    axis.set_xlabel(across["name"])
    axis.set_ylabel(upwards["name"])
    title = study["title"]
    if study["error"]:
        title += "\nin the cells: " + error_label(study, 70)
    axis.set_title(title)
    words = {kind: OUTCOMES[kind][2] for kind in shown}
    if "retried" in words:
        words["retried"] += " (number)"
    axis.legend(handles=[Patch(color=OUTCOMES[kind][0], label=text)
                         for kind, text in words.items()],
                loc="upper left", bbox_to_anchor=(1.02, 1.), borderaxespad=0.)
    save(figure, folder, "stability_map")


def main(arguments):
    if len(arguments) != 1:
        print("usage: plot_study.py OUTPUT_FOLDER", file=sys.stderr)
        return 1
    if not os.path.exists(os.path.join(arguments[0], "study.json")):
        print(f"plot_study.py: {arguments[0]} has no study.json; is it the "
              "output folder of a study?", file=sys.stderr)
        return 1
    study = read_study(arguments[0])
    look.set_up()
    folder = os.path.join(arguments[0], "pictures")
    os.makedirs(folder, exist_ok=True)
    if study["mode"] == "stability map":
        draw_stability_map(study, folder)
    elif any(row["error"] for row in study["rows"]):
        draw_work_precision(study, folder)
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
