# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws what a study found: plot.py study OUTPUT_FOLDER

Reads study.json there and writes, as PNG and SVG, pictures/work_precision
(error against cost and against unknowns) or pictures/stability_map (what
became of each variant over the plane of two factors); of the outputs that
Study/Columns names, pictures/curves (over the first factor with numbers) and
pictures/chart (contours over two such factors), beyond twelve outputs in
further pictures (curves_2, chart_2 and so on).
"""

import os

from plot.readers import files, json_shape
from plot.readers.files import BrokenInput
from plot.figures import (stability_map, study_curves, style,
                          work_precision)


def main(output_folder):
    path = os.path.join(output_folder, "study.json")
    if not os.path.exists(path):
        raise BrokenInput(f"{output_folder} has no study.json; is it the "
                          "output folder of a study?")
    study = files.read_json(path, {"mode": json_shape.WORDS})
    pictures = style.pictures_folder(output_folder)
    if study["mode"] == "stability map":
        stability_map.draw_stability_map(study, pictures)
    elif any(row["error"] for row in study["rows"]):
        work_precision.draw_work_precision(study, pictures)
    study_curves.draw_curves(study, pictures)
    study_curves.draw_chart(study, pictures)
