# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Judges pressures before and behind in a head:
plot.py coup OUTPUT_FOLDER [KILOHERTZ]

Takes a run of biomechanics whose first and third probe are at the coup and the
contrecoup. Prints what Tan, Saunders and Bagchi (2017) saw in experiments in
shock tubes and whether the run has it: the contrecoup is later by 0.1 ms,
begins negative, has the higher peak, peaks that fade, and three dips below
-100 kPa; in a fluid whose tension is cut off above that
(Materials/Cavitating tissues), three dips that reach the cut-off within 5 %.
All five are judged on the same histories, below KILOHERTZ, 20 by default.
Writes these to pictures/coup.png.
"""

import os

import numpy as np

from plot.readers import files, tables
from plot.analysis import coup
from plot.figures import body_cuts, style


def main(output_folder, kilohertz: float = 1e-3 * coup.BANDWIDTH):
    time, pressures = tables.probe_pressures(
        output_folder, ["coup", "middle", "contrecoup"])
    largest = 0.5e-3 / np.diff(time).max()
    if not 0. < kilohertz < largest:
        raise files.BrokenInput(f"KILOHERTZ must be above 0 and below "
                                f"{largest:.0f}, half the rate of the probes")
    time, pressures = coup.filtered(time, pressures, 1e3 * kilohertz)
    path = os.path.join(output_folder, "parameters.prm")
    entries = files.read_parameters(path)
    with files.reading(path):
        dip = coup.required_dip(
            float(entries["Materials/Least pressure"])
            if entries.get("Materials/Cavitating tissues") else None)
    for fact, found, holds in coup.judge(
            pressures["coup"], pressures["contrecoup"], time[1] - time[0], dip):
        print(f"{fact:40} {found:64} {'yes' if holds else 'no'}")
    body_cuts.draw_probes(output_folder, time, pressures,
                          {"contrecoup": 1e-3 * dip},
                          style.picture(output_folder, "coup"))
