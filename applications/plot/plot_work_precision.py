#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws error against cost: plot_work_precision.py ERROR PNG SERIES...

ERROR is a name below "errors" in summary.json, such as density_L1. A SERIES
is LABEL=FOLDER,FOLDER,...: output folders of one method on finer and finer
meshes, drawn as one line.
"""

import json
import os
import sys

import matplotlib.pyplot as plt

import look
import usage

MARKERS = "osD^vP"


def read_point(folder, error):
    """Wall time [s] and error of a run."""
    with open(os.path.join(folder, "summary.json"),
              encoding="utf-8") as file:
        summary = json.load(file)
    if error not in summary["errors"]:
        raise SystemExit(f"{folder} has no error '{error}'; it has: "
                         + ", ".join(summary["errors"]))
    return summary["performance"]["wall_seconds"], summary["errors"][error]


def main(arguments):
    if len(arguments) < 3 or not all("=" in text for text in arguments[2:]):
        print(__doc__, file=sys.stderr)
        return 1
    error, path = arguments[:2]
    look.set_up()
    figure, axis = plt.subplots(figsize=(6., 4.2))
    for number, series in enumerate(arguments[2:]):
        label, folders = series.split("=", 1)
        points = sorted(read_point(folder, error)
                        for folder in folders.split(","))
        axis.loglog(*zip(*points), label=label, markersize=5,
                    marker=MARKERS[number % len(MARKERS)])
    axis.set_xlabel("wall time [s]")
    axis.set_ylabel(error.replace("_", " "))
    axis.set_title("Error against cost: lower left is better")
    axis.legend()
    look.save(figure, path)
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
