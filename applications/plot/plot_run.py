#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws what a run left: plot_run.py OUTPUT_FOLDER

Writes PNG files into OUTPUT_FOLDER/pictures and prints their paths: the
history, the pressure at the probes, plane cuts through fields, values along
their lowest row of samples, maps of what the blast did, lines of gauges,
loads on a body from four sides and at its named places, and profiles of
one-dimensional runs.
"""

import os
import sys

import loads
import look
import maps
import planes
import profiles
import tables
import usage


def main(arguments):
    if len(arguments) != 1:
        print("usage: plot_run.py OUTPUT_FOLDER", file=sys.stderr)
        return 1
    folder = arguments[0]
    history = tables.open_table(folder, "history.csv")
    if history is None:
        print(f"plot_run.py: {folder} has no history.csv; is it the output "
              "folder of a run?", file=sys.stderr)
        return 1

    look.set_up()
    pictures = os.path.join(folder, "pictures")
    os.makedirs(pictures, exist_ok=True)
    tables.draw_history(history, os.path.join(pictures, "history.png"))
    probes = tables.open_table(folder, "probes.csv")
    if probes is not None:
        tables.draw_probes(probes, tables.open_references(folder),
                           os.path.join(pictures, "probes.png"))
    found = planes.open_planes(folder)
    for name, group in sorted(maps.take_maps(found).items()):
        maps.draw_maps(group, os.path.join(pictures, name + "_maps.png"))
    maps.draw_gauge_lines(folder, pictures)
    for name, cuts in sorted(found.items()):
        stem = os.path.join(pictures, name)
        planes.draw_planes(cuts, stem + ".png")
        planes.draw_lines(cuts, stem + "_lowest.png")
    loads.draw(folder, pictures)
    lines = profiles.open_profiles(folder)
    if lines:
        profiles.draw_profiles(lines, os.path.join(pictures, "profiles.png"))
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
