# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws a run of biomechanics: plot.py solid OUTPUT_FOLDER [Y]

Writes PNG files into OUTPUT_FOLDER/pictures and prints their paths: pressure
in the body's middle plane (or Y [m] to the left of it) at up to eight times in
the whole body and in its head, along the body's own axes, and energies over
time.
"""

import os

from plot.analysis import person, wave_times
from plot.readers import fields, files
from plot.readers.stage import Stage
from plot.figures import body_cuts, style

# Next to the plane of symmetry, where elements have no faces [m].
BESIDE = 1e-4


def main(output_folder, y: float = BESIDE):
    entries = Stage(output_folder).parameters
    axes = person.turned_axes(entries)
    shift = files.points_of(entries.get("Body/Shift"))
    place = y + (float(axes[1] @ shift[0]) if len(shift) else 0.)
    with files.reading(os.path.join(output_folder, "fields.pvd")):
        panels = fields.cut_fields(
            wave_times.fields_to_draw(output_folder), place, axes)
    for name, head_only in (("sagittal", False), ("sagittal_head", True)):
        body_cuts.draw_pressures(panels, head_only,
                                 style.picture(output_folder, name))
    body_cuts.draw_energies(output_folder,
                            style.picture(output_folder, "energies"))
