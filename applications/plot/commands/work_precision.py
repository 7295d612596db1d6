# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws error against cost: plot.py work_precision ERROR PNG SERIES...

ERROR is a name below "errors" in summary.json, such as density_L1. A SERIES
is LABEL=FOLDER,FOLDER,...: output folders of one method on finer and finer
meshes, drawn as one line.
"""

import os

from plot.readers import files, json_shape
from plot.readers.files import BrokenInput
from plot.figures import work_precision


def read_point(folder, error):
    """Wall time [s] and error of a run."""
    summary = files.read_json(os.path.join(folder, "summary.json"),
                              json_shape.SUMMARY)
    if error not in summary.get("errors", {}):
        raise BrokenInput(f"{folder} has no error '{error}'; it has: "
                          + ", ".join(summary.get("errors", {})))
    return summary["performance"]["wall_seconds"], summary["errors"][error]


def main(error, png, series, *more_series):
    lines = {}
    for text in (series, *more_series):
        label, sign, folders = text.partition("=")
        if not sign:
            raise BrokenInput(f"{text}: must be LABEL=FOLDER,FOLDER,...")
        lines[label] = sorted(read_point(folder, error)
                              for folder in folders.split(","))
    work_precision.draw_lines(lines, error, png)
