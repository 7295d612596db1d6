# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws a run of biomechanics: plot.py solid OUTPUT_FOLDER [Y]

Writes PNG files into OUTPUT_FOLDER/pictures and prints their paths: pressure
in the plane y = 0 (or Y [m]) at up to eight times in the whole body and in its
head, and energies over time.
"""

import os

from plot.analysis import wave_times
from plot.readers import fields, files
from plot.figures import body_cuts, style

# Beside the plane of symmetry, where elements have no faces [m].
BESIDE = 1e-4


def main(output_folder, y: float = BESIDE):
    with files.reading(os.path.join(output_folder, "fields.pvd")):
        panels = fields.cut_fields(
            wave_times.fields_to_draw(output_folder), y)
    pictures = style.pictures_folder(output_folder)
    for name, head_only in (("sagittal", False), ("sagittal_head", True)):
        body_cuts.draw_pressures(panels, head_only,
                                 os.path.join(pictures, name + ".png"))
    body_cuts.draw_energies(output_folder,
                            os.path.join(pictures, "energies.png"))
