# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A picture of what became of each variant of a study over the plane of two
factors."""

import matplotlib.pyplot as plt
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
    usable = row["outcome"] in ("stable", "retried", "finished")
    if usable and row["error"] and row["error"] > study["wanted"] > 0.:
        return "inaccurate"
    return row["outcome"]


def letter_of(row, kind):
    """Text in a cell of the map: error, number of retries, letter."""
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
                      ("unstable", "failed", "stable", "finished")
                      else "black")
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
        title += "\nin the cells: " + work_precision.error_label(study, 70)
    axis.set_title(title)
    words = {kind: OUTCOMES[kind][2] for kind in shown}
    if "retried" in words:
        words["retried"] += " (number)"
    axis.legend(handles=[Patch(color=OUTCOMES[kind][0], label=text)
                         for kind, text in words.items()],
                loc="upper left", bbox_to_anchor=(1.02, 1.), borderaxespad=0.)
    work_precision.save(figure, folder, "stability_map")
