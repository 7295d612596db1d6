# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A picture of what became of each variant of a study over the plane of two
factors."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

from plot.figures import work_precision

# Outcome: colour, letter in the map, words of the legend.
OUTCOMES = {
    "stable": ("#009E73", "", "stable"),
    "finished": ("#009E73", "", "finished"),
    "retried": ("#F0E442", "r", "stable after cutting back steps"),
    "inaccurate": ("#E69F00", "", "finished, but less accurate than wanted"),
    "refused": ("#BBBBBB", "–", "refused, with a line that says why"),
    "unstable": ("#D55E00", "u", "unstable: no step was small enough"),
    "timed out": ("#CC79A7", "t", "ended at the time limit"),
    "failed": ("#000000", "f", "failed: the process or the machine"),
}


def judged(row, study):
    """The outcome of a row, for the map."""
    is_usable = row["outcome"] in ("stable", "retried", "finished")
    return "inaccurate" if is_usable and row["error"] \
        and row["error"] > study["wanted"] > 0. else row["outcome"]


def letter_of(row, kind):
    """Text in a cell of the map: error, number of retries, letter."""
    text = f"{row['retries']:.0f}" if row["outcome"] == "retried" \
        else OUTCOMES[kind][1]
    if row["error"]:
        text = f"{row['error']:.1e}".replace("e-0", "e-") + (
            f"\n({text})" if text else "")
    return text


def draw_stability_map(study, folder):
    across, upwards = (factor["labels"] for factor in study["factors"])
    kinds = list(OUTCOMES)
    grid = np.full((len(upwards), len(across)), np.nan)
    figure, axis = plt.subplots(figsize=(
        max(4., 0.55 * len(across) + 1.5) + 3.,
        max(3., 0.38 * len(upwards) + 1.2)))
    for row in study["rows"]:
        i, j = across.index(row["labels"][0]), upwards.index(row["labels"][1])
        kind = judged(row, study)
        grid[j, i] = kinds.index(kind)
        axis.annotate(letter_of(row, kind), (i, j), ha="center", va="center",
                      fontsize=7, color="white" if kind in
                      ("unstable", "failed", "stable", "finished")
                      else "black")
    axis.imshow(grid, vmin=-0.5, vmax=len(kinds) - 0.5, aspect="auto",
                cmap=ListedColormap([OUTCOMES[kind][0] for kind in kinds]))
    crowded = len(across) > 8 or max(map(len, across)) > 10
    axis.set_xticks(range(len(across)), across,
                    rotation=45 if crowded else 0,
                    ha="right" if crowded else "center",
                    rotation_mode="anchor" if crowded else None)
    axis.set_yticks(range(len(upwards)), upwards)
    axis.set_xticks(np.arange(len(across)) - 0.5, minor=True)
    axis.set_yticks(np.arange(len(upwards)) - 0.5, minor=True)
    axis.grid(False)
    axis.grid(True, which="minor", color="white", linewidth=1.5)
    axis.tick_params(which="both", length=0)
    title = study["title"]
    if study["error"]:
        title += "\nin the cells: " + work_precision.error_label(study, 70)
    xlabel, ylabel = (factor["name"] for factor in study["factors"])
    axis.set(title=title, xlabel=xlabel, ylabel=ylabel)
    seen = {judged(row, study) for row in study["rows"]}
    axis.legend(handles=[Patch(color=colour, label=words + (
        " (number)" if kind == "retried" else ""))
                         for kind, (colour, _, words) in OUTCOMES.items()
                         if kind in seen],
                loc="upper left", bbox_to_anchor=(1.02, 1.), borderaxespad=0.)
    work_precision.save(figure, folder, "stability_map")
