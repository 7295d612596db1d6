# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""How often the report's error estimate covers what finer cells change, for
twenty charges above the ground with gauges alone.

  python3 tests/validation/error_estimate.py BUILD FOLDER [JOBS]

Runs each scene with cells of 40, 20 and 10 mm, twice that for 50 kg, by
BUILD/bin/blast (a folder that is there is kept), estimates the error of each
gauge's peak, impulse and positive phase at the middle size from the largest
one as the report does, and prints the table of
parameter_files/scene/error_estimate.md. JOBS scenes run at a time (1).
"""

import concurrent.futures
import math
import os
import subprocess
import sys

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "applications"))
from plot.readers import tables  # noqa: E402
from plot.report import error_estimate  # noqa: E402

MEASURES = error_estimate.GAUGE_MEASURES

# Explosive, mass [kg], distance along the ground and height of the charge [m].
SCENES = (
    ("tnt", 0.05, 0.5, 1.2), ("tnt", 0.05, 2., 0.5), ("c-4", 0.1, 1., 1.5),
    ("tnt", 0.2, 0.8, 1.2), ("tnt", 0.2, 3., 0.3), ("c-4", 0.5, 1.2, 0.3),
    ("tnt", 0.5, 4., 1.5), ("tnt", 1., 1., 1.8), ("tnt", 1., 2.5, 1.),
    ("tnt", 1., 6., 0.2), ("c-4", 2., 3., 2.), ("tnt", 2., 8., 1.),
    ("tnt", 5., 3., 0.5), ("tnt", 5., 5., 1.), ("c-4", 5., 12., 0.3),
    ("tnt", 10., 4., 2.5), ("tnt", 10., 10., 1.), ("tnt", 20., 8., 0.5),
    ("tnt", 20., 15., 2.), ("tnt", 50., 20., 1.))

LEAF = 0.64  # [m], with 4 subcells
SOUND = 340.  # [m/s]
AFTERBURN = {"tnt": 3.5e6, "c-4": 3.5e6}  # [J/kg], as scenes have it

FILE = """subsection Domain
  set Dimension     = 2
  set Geometry      = axisymmetric
  set Upper corner  = {right}, {top}
  set Coarse leaves = {columns}, {rows}
end
subsection Boundaries
  set x low  = symmetry
  set x high = open
  set y low  = wall
  set y high = open
end
subsection Material
  set Equation of state = jwl in air
  set Explosive         = {explosive}
end
subsection Method
  set CFL number = 0.9
  set Subcells   = 4
end
subsection Charges
  subsection Charge 1
    set Mass   = {mass}
    set Center = 0, {height}
  end
  subsection Afterburn
    set Kind   = miller
    set Energy = {afterburn}
  end
end
subsection First stage
  set Kind         = spherical
  set Cell size    = 0.001
  set Hand over at = radius
  set Radius       = {hand_over}
end
subsection Adaptation
  set Active        = true
  set Sensor        = blast
  set Interval      = 0
  set Noise         = 0.05
  set Buffer side   = ahead
  set Largest level = {level}
end
subsection Probes
  set Points = {points}
end
subsection Time
  set End time = {end}
end
subsection Output
  set Fields = false
end
"""


def levels(mass):
    """Levels of cells of 40, 20 and 10 mm, twice that for large charges."""
    return (2, 3, 4) if mass < 50. else (1, 2, 3)


def gauges(distance):
    """Places (r, z) [m]: four heights of a person, and one farther out."""
    return [(distance, height) for height in (0.1, 0.7, 1.3, 1.7)] \
        + [(1.5 * distance, 1.3)]


def phase_bound(mass):
    """A time that is longer than a positive phase [s]."""
    return 5.5e-3 * mass ** (1. / 3.)


def domain(mass, distance, height):
    """Numbers of leaves for which sound that an open side reflects comes after
    the positive phase."""
    late = SOUND * phase_bound(mass)
    columns = math.ceil((1.5 * distance + 0.5 * late) / LEAF)
    top = height
    while any(math.hypot(r, 2. * top - height - z)
              < math.hypot(r, height - z) + late
              for r, z in gauges(distance)):
        top += 0.1 * LEAF
    return columns, math.ceil(max(top, 2.) / LEAF)


def hand_over(distance, height):
    """Radius of the front at the hand-over [m], before it meets a gauge or the
    ground."""
    return 0.9 * min([height] + [math.hypot(r, z - height)
                                 for r, z in gauges(distance)])


def write_scene(path, scene, level):
    explosive, mass, distance, height = scene
    columns, rows = domain(mass, distance, height)
    with open(path, "w", encoding="utf-8") as file:
        file.write(FILE.format(
            explosive=explosive, mass=mass, height=height, level=level,
            columns=columns, rows=rows, right=columns * LEAF, top=rows * LEAF,
            afterburn=AFTERBURN[explosive],
            hand_over=hand_over(distance, height),
            points="; ".join(f"{r}, {z}" for r, z in gauges(distance)),
            end=1.5 * distance / SOUND + phase_bound(mass)))


def run(build, folder, number, level):
    """Runs a scene at a level unless its folder is there."""
    output = os.path.join(folder, f"{number}_{level}")
    if not os.path.exists(os.path.join(output, "summary.json")):
        file = os.path.join(folder, f"{number}_{level}.prm")
        write_scene(file, SCENES[number], level)
        subprocess.run([os.path.join(build, "bin", "blast"), file, "--output",
                        output, "--overwrite"], check=True,
                       stdout=subprocess.DEVNULL)
    return output


def measures_of(output):
    """MEASURES of each gauge: numbers by gauge and name."""
    table = tables.open_table(output, "probes.csv")
    time, found = table["time"], {}
    for name in table.names:
        if name.endswith("_pressure"):
            found[name] = measure(time, table[name] - table[name][0])
    return found


def measure(time, over):
    """Peak, impulse and length of the positive phase that has the peak; nan for
    a phase that the end of the run cuts."""
    peak = int(np.argmax(over))
    begin = int(np.argmax(over > 0.05 * over[peak]))
    after = np.nonzero(over[peak:] <= 0.)[0]
    if len(after) == 0:
        return {"peak": over[peak], "impulse": math.nan,
                "positive phase": math.nan}
    end = peak + int(after[0])
    return {"peak": over[peak],
            "impulse": np.trapz(over[begin:end], time[begin:end]),
            "positive phase": time[end] - time[begin]}


def compare(outputs):
    """Estimated error and change by finer cells, both relative to the middle
    run, by gauge and measure."""
    coarse, middle, fine = (measures_of(output) for output in outputs)
    errors = error_estimate.of_gauges(middle, coarse, 2.)
    return {(gauge, name): (errors[gauge][name],
                            fine[gauge][name] / middle[gauge][name] - 1.)
            for gauge in middle for name in MEASURES
            if math.isfinite(fine[gauge][name])
            and errors[gauge].get(name) is not None}


def row(scene, compared):
    """A row of the table, and how many of how many are covered."""
    cells = [scene[0].upper(), *(f"{value:g}" for value in scene[1:])]
    covered = [abs(change) <= error for error, change in compared.values()]
    for name in MEASURES:
        pairs = [pair for key, pair in compared.items() if key[1] == name]
        errors, changes = zip(*pairs) if pairs else ((), ())
        cells.append("–" if not pairs else
                     f"±{100. * np.median(errors):.0f}, "
                     f"{100. * min(changes):+.0f} to {100. * max(changes):+.0f}")
    cells.append(f"{sum(covered)} of {len(covered)}")
    return "| " + " | ".join(cells) + " |", sum(covered), len(covered)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    build, folder = (os.path.abspath(path) for path in sys.argv[1:3])
    os.makedirs(folder, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(
            int((sys.argv + ["1"])[3])) as pool:
        outputs = [[pool.submit(run, build, folder, number, level)
                    for level in levels(scene[1])]
                   for number, scene in enumerate(SCENES)]
        results = []
        for scene, runs in zip(SCENES, outputs):
            results.append(row(scene, compare([one.result() for one in runs])))
            print(results[-1][0], flush=True)
    print(f"covered: {sum(one[1] for one in results)} of "
          f"{sum(one[2] for one in results)}")


if __name__ == "__main__":
    main()
