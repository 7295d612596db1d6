# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws the path of the triple point: plot.py triple_point OUTPUT_FOLDER HEIGHT

Reads the pressure planes of an axisymmetric run (Pictures/Planes = all) with
a charge HEIGHT [m] above ground, y = 0. The blast in free air is a sphere
around the charge, whose radius is seen above it. Where the front along the
ground is ahead of that sphere there is a Mach stem; its upper end is the
triple point. Writes OUTPUT_FOLDER/pictures/triple_point.png and prints the
path and the ground range at which the stem begins, where a parabola through
the path meets the ground.

Stems shorter than a captured front is wide cannot be seen. If the run has
probes on the ground, the range where reflection ceases to be regular is found
from them as well: where the gas behind the reflected wave, seen from the point
of reflection, no longer is supersonic, so that what happens above the ground
can reach that point. Two-shock theory has its limit a tenth of a degree on.
"""

from plot.readers.files import BrokenInput
from plot.analysis import triple_point
from plot.figures import mach_stem, style


def main(output_folder, height: float):
    path = triple_point.follow_path(output_folder, height)
    if path:
        for row in zip(path.times, path.ranges, path.heights):
            print("time %.6g s  range %.4f m  height %.4f m" % row)
        print(f"Mach stem from a ground range of {path.parabola[-1]:.4f} m on")
    reflection = triple_point.mach_numbers(output_folder, height)
    limit = triple_point.sonic_range(*reflection) if reflection else None
    if limit:
        print(f"Regular reflection up to a ground range of {limit:.4f} m")
    if not path and not reflection:
        raise BrokenInput(
            f"{output_folder} has neither a Mach stem in its pressure planes "
            "(Pictures/Planes = all) nor six probes on the ground")
    mach_stem.draw(path, reflection, limit, height,
                   style.picture(output_folder, "triple_point"))
