# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws a body that anatomy made: plot.py anatomy OUTPUT_FOLDER

Writes PNG files into OUTPUT_FOLDER/pictures and prints their paths: the body
from outside, cuts by tissue, and mesh quality.
"""

import csv
import os

from plot.analysis import person
from plot.readers import files, vtk_file
from plot.readers.stage import Stage
from plot.figures import anatomy_mesh, style


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def main(output_folder):
    path = os.path.join(output_folder, "mesh.vtu")
    if not os.path.exists(path):
        raise files.BrokenInput(f"{output_folder} has no mesh.vtu; is it the "
                                "output folder of anatomy?")
    surface = os.path.join(output_folder, "surface.vtu")
    if os.path.exists(surface):
        anatomy_mesh.draw_outside(
            vtk_file.read(surface), style.picture(output_folder, "body"),
            person.axes_by_entries(Stage(output_folder).parameters))
    names = {int(row["tissue"]): row["tissue name"]
             for row in read_table(os.path.join(output_folder, "parts.csv"))}
    anatomy_mesh.draw_cuts(vtk_file.read(path), names,
                           style.picture(output_folder, "cuts"))
    anatomy_mesh.draw_quality(
        read_table(os.path.join(output_folder, "quality.csv")),
        style.picture(output_folder, "quality"))
