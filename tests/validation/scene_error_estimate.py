# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""How often the report's error estimate covers what finer cells change, for
ten scenes with the phantom, one of them with tissue.

  python3 tests/validation/scene_error_estimate.py BUILD FOLDER [NUMBER ...]

Runs each scene, or those of these numbers from 1, by BUILD/bin/scene (a finished
one is kept) with cells of 20 mm and its own coarser run with 40 mm, and with
cells of 10 mm. Estimates the errors of the injury table and of peak, impulse
and positive phase at the gauges as the report does, and prints the tables of
parameter_files/scene/error_estimate.md.
"""

import math
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "applications"))
from plot.readers.scene import Scene  # noqa: E402
from plot.report import error_estimate, injury_table  # noqa: E402

# Explosive, mass [kg], distance and height [m], afterburn [J/kg], end [s], and
# the entries of the body.
SCENES = (
    ("tnt", 0.2, 0.8, 1.2, 0., 3e-3, {}),
    ("tnt", 1., 2., 1., 0., 6e-3, {}),
    ("c-4", 2.268, 2.337, 1.27, 3.5e6, 5e-3, {}),
    ("tnt", 5., 5., 1., 0., 12e-3, {}),
    ("tnt", 0.05, 0.5, 1.2, 0., 2.5e-3, {}),
    ("tnt", 10., 4., 0.5, 0., 9e-3, {}),
    ("c-4", 0.5, 1.2, 0.3, 0., 4e-3, {}),
    ("tnt", 0.5, 5., 1., 0., 16e-3, {}),
    ("c-4", 1., 1., 1.8, 3.5e6, 4e-3, {}),
    ("tnt", 1., 2.5, 1., 3.5e6, 7e-3, {"Stature": 1.55, "Mass": 50}))
WITH_TISSUE = 10
SIZES = ((0.02, "fast", 0.01), (0.01, "balanced", 0.005))
SHOWN_MEASURES = ("ear_rupture_left ear", "chest_wall_front", "chest_wall_mean",
                  "lung_exposure")
SHOWN_PEAKS = ("chest", "forehead", "back")

FILE = """subsection Scene
  set Question       = {question}
  set Accuracy       = {accuracy}
  set Cell size      = {cells}
  set Element size   = {elements}
  set End time       = {end}
  set Error estimate = {estimate}
  set Report         = false
  set Forecast       = false
end
subsection Charge
  set Explosive        = {explosive}
  set Mass             = {mass}
  set Distance         = {distance}
  set Height           = {height}
  set Afterburn energy = {afterburn}
end
subsection Body
  set Kind = phantom
  subsection Phantom
{body}
  end
end
"""


def write_scene(path, number, size):
    explosive, mass, distance, height, afterburn, end, body = \
        SCENES[number - 1]
    cells, accuracy, elements = SIZES[size]
    with open(path, "w", encoding="utf-8") as file:
        file.write(FILE.format(
            question="injury" if number == WITH_TISSUE else "loads",
            accuracy=accuracy, cells=cells, elements=elements, end=end,
            estimate="true" if size == 0 else "false", explosive=explosive,
            mass=mass, distance=distance, height=height, afterburn=afterburn,
            body="\n".join(f"    set {name} = {value}"
                           for name, value in body.items())))


def run(build, folder, number, size):
    """Runs a scene with cells of SIZES unless it is finished; returns it."""
    output = os.path.join(folder, f"{number}_{size}")
    done = output + ".done"
    if not os.path.exists(done):
        file = os.path.join(folder, f"{number}_{size}.prm")
        write_scene(file, number, size)
        subprocess.run([os.path.join(build, "bin", "scene"), file, "--output",
                        output, "--overwrite"], check=True,
                       stdout=subprocess.DEVNULL)
        with open(done, "w", encoding="utf-8"):
            pass
    return Scene(output)


def compare(middle, fine):
    """Estimated error and change by finer cells, both relative, by kind
    ("injury" or a measure of gauges) and name."""
    found = {}
    changed = {entry.name: entry.value for entry in injury_table.judge(fine)}
    for entry in injury_table.judge(middle):
        if entry.error is not None and entry.name in changed:
            found["injury", entry.name] = (
                entry.error, changed[entry.name] / entry.value - 1.)
    finer = fine.gauge_measures()
    for gauge, errors in error_estimate.of_scene_gauges(middle).items():
        values = middle.gauge_measures()[gauge]
        for name, error in errors.items():
            value = finer.get(gauge, {}).get(name, math.nan)
            if math.isfinite(value):
                found[name, gauge] = error, value / values[name] - 1.
    return found


def is_covered(pair):
    return abs(pair[1]) <= pair[0]


def cell(pair):
    return "–" if pair is None else \
        f"±{100. * pair[0]:.0f}, {100. * pair[1]:+.0f}"


def row(number, found):
    """A row of the table of scenes."""
    explosive, mass, distance, height, afterburn, end, _ = SCENES[number - 1]
    cells = [explosive, *(f"{value:g}" for value in (
        mass, distance, height, 1e-6 * afterburn, 1e3 * end))]
    cells += [cell(found.get(("injury", name))) for name in SHOWN_MEASURES]
    cells += [cell(found.get(("peak", gauge))) for gauge in SHOWN_PEAKS]
    covered = sum(map(is_covered, found.values()))
    return "| " + " | ".join(cells) + f" | {covered} of {len(found)} |"


def print_details(found):
    """Each measure of injury, and what is not covered at gauges."""
    for (kind, name), pair in found.items():
        if kind == "injury" or not is_covered(pair):
            print(f"  {kind} {name}: {cell(pair)}"
                  + ("" if is_covered(pair) else ", not covered"))


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    build, folder = (os.path.abspath(path) for path in sys.argv[1:3])
    os.makedirs(folder, exist_ok=True)
    counts = {}
    for number in map(int, sys.argv[3:] or range(1, len(SCENES) + 1)):
        found = compare(*(run(build, folder, number, size)
                          for size in range(len(SIZES))))
        print(row(number, found), flush=True)
        print_details(found)
        for (kind, _), pair in found.items():
            covered, count = counts.get(kind, (0, 0))
            counts[kind] = covered + is_covered(pair), count + 1
    print("covered: " + ", ".join(
        f"{kind} {covered} of {count}"
        for kind, (covered, count) in counts.items()))


if __name__ == "__main__":
    main()
