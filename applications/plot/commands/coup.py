# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Judges pressures before and behind in a head: plot.py coup OUTPUT_FOLDER

Takes a run of biomechanics whose first and third probe are at the coup and the
contrecoup. Prints what Tan, Saunders and Bagchi (2017) saw in experiments in
shock tubes and whether the run has it: the contrecoup is later by 0.1 ms,
begins negative, has the higher peak, peaks that fade, and three dips below
-100 kPa. Writes pictures/coup.png.
"""

import os

from plot.readers import tables
from plot.analysis import coup
from plot.figures import body_cuts, style


def main(output_folder):
    time, pressures = tables.probe_pressures(
        output_folder, ["coup", "middle", "contrecoup"])
    for fact, found, holds in coup.judge(time, pressures["coup"],
                                         pressures["contrecoup"]):
        print(f"{fact:46} {found:58} {'yes' if holds else 'no'}")
    body_cuts.draw_probes(
        output_folder, time, pressures, {"contrecoup": 1e-3 * coup.CAVITATION},
        os.path.join(style.pictures_folder(output_folder), "coup.png"))
