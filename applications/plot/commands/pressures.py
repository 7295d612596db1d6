# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws pressures at the probes of a run of biomechanics:
plot.py pressures OUTPUT_FOLDER NAME[=KILOPASCALS] ...

Names are those of probe 1, 2, and so on, each with a measured extreme of its
pressure, if there is one. Prints both side by side and writes
pictures/pressures.png, with cuts through the body at y = 0.
"""

from plot.readers import files, tables
from plot.figures import body_cuts, style


def main(output_folder, name, *more_names):
    names, references = [], {}
    for argument in (name, *more_names):
        name, _, number = argument.partition("=")
        names.append(name)
        if number:
            with files.reading(argument):
                references[name] = float(number)
    time, pressures = tables.probe_pressures(output_folder, names)
    print(f"{'':16} {'highest':>8} {'lowest':>8} {'measured':>9}  [kPa]")
    for name, values in pressures.items():
        print(f"{name:16} {1e-3 * values.max():8.0f} "
              f"{1e-3 * values.min():8.0f} {references.get(name, ''):>9}")
    body_cuts.draw_probes(output_folder, time, pressures, references,
                          style.picture(output_folder, "pressures"))
