#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""How right the times are that --check predicts: check_times.py BIN_FOLDER

Prints, as rows 'name,value,unit', the predicted over the needed processor time
of runs, and for the shipped man scene what --check itself takes and says.
Nothing else should run meanwhile.
"""

import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
FILES = os.path.join(ROOT, "parameter_files")

# Shortened as in tests/applications/blast_plans.cmake.
RUNS = {
    "stages": ("blast/quickstart.prm", [
        "Time/End time=0.0012", "First stage/Cell size=0.002",
        "Output/Fields interval=0"]),
    "adaptive": ("blast/verification/height_of_burst.prm", [
        "Time/End time=0.0015", "Adaptation/Largest level=3",
        "Output/Fields interval=0.0003"]),
    "uniform": ("blast/verification/noh_3d.prm", ["Time/End time=0.3"]),
    "body": ("blast/quickstart_human.prm", [
        "Time/End time=0.003", "Rigid body/Levels=2",
        "First stage/Cell size=0.02", "Pictures/Planes=",
        "First stage/Spherical cell size=0.002", "Output/Fields=false",
        "Output/Pictures=false"]),
}
MAN = "scene/quickstart.prm"
UNITS = {"s": 1., "min": 60., "h": 3600., "d": 86400., "ms": 1e-3}


def call(program, file, settings, *arguments):
    command = [program, os.path.join(FILES, file), *arguments]
    for setting in settings:
        command += ["--set", setting]
    return subprocess.run(command, check=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, text=True).stdout


def predicted_over_needed(blast, file, settings):
    """Ratio of predicted to needed processor time of a run."""
    with tempfile.TemporaryDirectory() as folder:
        os.environ["XDG_CACHE_HOME"] = folder
        call(blast, file, settings, "--check")
        (cache,) = glob.glob(os.path.join(folder, "contrecoup", "*.json"))
        with open(cache, encoding="utf-8") as kept:
            predicted = json.load(kept)["seconds"]
        output = os.path.join(folder, "run")
        call(blast, file, settings, "--output", output)
        with open(os.path.join(output, "summary.json"),
                  encoding="utf-8") as summary:
            needed = json.load(summary)["performance"]["core_seconds"]
    return predicted / needed


def seconds_said(text):
    """The sum of the wall times that --check of a scene's stages says: the
    last row of its table."""
    lines = text.splitlines()
    heading = next(line for line in lines if " wall time " in line)
    last = next(line for line in lines if line.startswith("  all "))
    found = [last[heading.index("wall time"):heading.index("output")]]
    return sum(float(number) * UNITS[unit] for entry in found
               for number, unit in re.findall(r"([\d.e+-]+) (\w+)", entry))


def main(arguments):
    if len(arguments) != 1:
        print("usage: check_times.py BIN_FOLDER", file=sys.stderr)
        return 1
    blast, scene = (os.path.join(arguments[0], name)
                    for name in ("blast", "scene"))
    for name, (file, settings) in RUNS.items():
        ratio = predicted_over_needed(blast, file, settings)
        print(f"check_time_{name},{ratio:.4g},predicted over needed",
              flush=True)
    with tempfile.TemporaryDirectory() as folder:
        os.environ["XDG_CACHE_HOME"] = folder
        begin = time.time()
        text = call(scene, MAN, [], "--check")
        print(f"check_man_scene,{time.time() - begin:.4g},s that --check "
              "takes")
        print(f"check_man_scene_says,{seconds_said(text):.4g},s that it says")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
