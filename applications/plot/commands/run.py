# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws what a run left: plot.py run OUTPUT_FOLDER

Writes PNG files into OUTPUT_FOLDER/pictures and prints their paths: the
history, the pressure at the probes, plane cuts through fields, values along
their lowest row of samples, maps of what the blast did and would do to people,
lines of gauges, loads on a body from four sides and at its named places, and profiles of
one-dimensional runs.
"""

import os

from plot.analysis import wave_times
from plot.readers import files, planes, profiles, tables
from plot.figures import (blast_maps, body_loads, histories, injury_maps,
                          line_profiles, plane_cuts, style)


def main(output_folder):
    history = tables.open_table(output_folder, "history.csv")
    if history is None:
        raise files.BrokenInput(f"{output_folder} has no history.csv; is it "
                                "the output folder of a run?")
    pictures = style.pictures_folder(output_folder)
    histories.draw_history(history, os.path.join(pictures, "history.png"))
    probes = tables.open_table(output_folder, "probes.csv")
    if probes is not None:
        histories.draw_probes(probes, tables.open_references(output_folder),
                              os.path.join(pictures, "probes.png"))
    found = planes.open_planes(output_folder)
    for name, group in sorted(blast_maps.take_maps(found).items()):
        blast_maps.draw_maps(group, os.path.join(pictures, name + "_maps.png"))
        if injury_maps.are_in(group):
            injury_maps.draw(group,
                             os.path.join(pictures, name + "_injury.png"))
    blast_maps.draw_gauge_lines(output_folder, pictures)
    for name, cuts in sorted(found.items()):
        stem = os.path.join(pictures, name)
        cuts = wave_times.planes_to_draw(cuts)
        plane_cuts.draw_planes(cuts, stem + ".png")
        plane_cuts.draw_lines(cuts, stem + "_lowest.png")
    body_loads.draw(output_folder, pictures)
    lines = profiles.open_profiles(output_folder)
    if lines:
        line_profiles.draw_profiles(lines,
                                    os.path.join(pictures, "profiles.png"))
