# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws what a run left: plot.py run OUTPUT_FOLDER

Writes PNG files into OUTPUT_FOLDER/pictures and prints their paths: the
history, the pressure at the probes, plane cuts through fields, values along
their lowest row of samples, maps of what the blast did and would do to people,
lines of gauges, loads on a body from four sides and at its named places, and profiles of
one-dimensional runs.
"""

import functools

from plot.analysis import wave_times
from plot.readers import files, planes, tables
from plot.readers.profiles import open_profiles
from plot.figures import (blast_maps, body_loads, histories, injury_maps,
                          plane_cuts, profiles, style)


def main(output_folder):
    history = tables.open_table(output_folder, "history.csv")
    if history is None:
        raise files.BrokenInput(f"{output_folder} has no history.csv; is it "
                                "the output folder of a run?")
    pictures = style.pictures_folder(output_folder)
    path = functools.partial(style.picture, output_folder)
    histories.draw_history(history, path("history"))
    probes = tables.open_table(output_folder, "probes.csv")
    if probes is not None:
        histories.draw_probes(probes, tables.open_references(output_folder),
                              path("probes"))
    found = planes.open_planes(output_folder)
    for name, group in sorted(blast_maps.take_maps(found).items()):
        blast_maps.draw_maps(group, path(f"{name}_maps"))
        if injury_maps.are_in(group):
            injury_maps.draw(group, path(f"{name}_injury"))
    blast_maps.draw_gauge_lines(output_folder, pictures)
    for name, cuts in sorted(found.items()):
        cuts = wave_times.planes_to_draw(cuts)
        plane_cuts.draw_planes(cuts, path(name))
        plane_cuts.draw_lines(cuts, path(f"{name}_lowest"))
    body_loads.draw(output_folder, pictures)
    lines = open_profiles(output_folder)
    if lines:
        profiles.draw_profiles(lines, path("profiles"))
