#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""How right --check is: what it forecasts over what the run then needs, for
runs of every application and for each stage of scenes.

  tests/validation/forecasts.py BUILD FOLDER [--cheap] [NAME...]

Asks BUILD/bin/APPLICATION for a forecast of each case (or of those NAMEd), runs
it in FOLDER and prints forecast / found for the largest number of cells, unknowns,
steps, peak memory and bytes of output, which must lie between 1/1.3 and 1.3,
steps between 1/1.5 and 1.5; a second --check knows the first. A dash is a number
that --check leaves out, where the
case allows that. The estimates that blast prints before its first step stand in
--check, too. Trial runs have the levels of the case, so that the ratios are
those of any machine. With --cheap, only the cases of the test `forecasts` run;
all take ten minutes on one core.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tests", "applications", "cases"))

from case import overrides, read_json  # noqa: E402
from nifti import write_labels  # noqa: E402

FACTORS = {"cells": 1.3, "unknowns": 1.3, "steps": 1.5, "memory_bytes": 1.3,
           "output_bytes": 1.3}
SUMMARISED = ("anatomy", "blast", "biomechanics", "head_impact")


@dataclass
class Case:
    """A run: its levels of trial runs, see CONTRECOUP_CHECK_LEVELS, empty for
    those of four seconds; and the numbers that --check leaves out, as "steps" or
    "STAGE steps"."""
    name: str
    application: str
    file: str
    settings: tuple = ()
    levels: str = "2 1"
    absent: tuple = ()
    cheap: bool = True


BODY = ("Body/Image/File=@IMAGE@", "Body/Kind=image",
        "Body/Image/Labels=1: soft tissue; 2: brain")
FALLING_HEAD = (
    "Mesh/Kind=body", "Mesh/Element size=0.012",
    "Mesh/Smoothing iterations=0", "Body/Kind=shape",
    "Body/Shape/Shape=layered head", "Body/Shift=0, 0, 0.0747",
    "Materials/Set=physiological", "Elements/Kinematics=finite rotation",
    "Elements/Linear bulk viscosity=0.06",
    "Elements/Quadratic bulk viscosity=1.2", "Initial state/Velocity z=-3",
    "Probes/Points=0, 0, 0.07", "Output/Probes every steps=1000",
    "Output/History every steps=1000", "Time/End time=5e-3")
CASES = (
    Case("sod", "blast", "blast/verification/sod.prm", levels="3 1"),
    Case("checkpoints", "blast", "blast/verification/sod.prm",
         ("Output/Checkpoint every steps=20", "Output/Fields=false"), "3 1"),
    Case("tnt_1d", "blast", "blast/verification/tnt_detonation.prm",
         levels="3 1", cheap=False),
    Case("axisymmetric", "blast", "blast/verification/height_of_burst.prm",
         ("Time/End time=0.001", "Adaptation/Largest level=3",
          "Output/Fields interval=0.0003"), "3 1"),
    Case("uniform", "blast", "blast/verification/noh_3d.prm",
         ("Time/End time=0.15",), "5 2", absent=("steps",), cheap=False),
    Case("stages", "blast", "blast/quickstart.prm",
         ("Time/End time=0.0009", "First stage/Cell size=0.002",
          "Output/Fields interval=0"), "3 1", cheap=False),
    Case("people", "blast", "blast/showcase/people.prm", levels="3 1",
         cheap=False),
    Case("body", "blast", "blast/quickstart_human.prm",
         ("Time/End time=0.0024", "Domain/Lower corner=-0.64, 0, 0",
          "Domain/Upper corner=5.12, 2.56, 3.84",
          "Domain/Coarse leaves=9, 4, 6",
          "Adaptation/Limit fireball/Largest level=0",
          "Adaptation/Limit far away/Largest level=0",
          "Rigid body/Levels=2", "First stage/Cell size=0.02",
          "First stage/Spherical cell size=0.002", "Output/Fields=false",
          "Output/Pictures=false"), "3 1"),
    Case("body_fields", "blast", "blast/quickstart_human.prm",
         ("Time/End time=0.004",), "3 1", cheap=False),
    Case("phantom_mesh", "anatomy", "anatomy/quickstart.prm",
         ("Output/Gmsh=true", "Output/Pictures=false")),
    Case("phantom_fine", "anatomy", "anatomy/quickstart.prm",
         ("Mesh/Element size=0.005", "Mesh/Smoothing iterations=5"),
         cheap=False),
    Case("image", "anatomy", "anatomy/quickstart.prm",
         (*BODY, "Mesh/Element size=0.003", "Output/Pictures=false")),
    Case("surface", "anatomy", "anatomy/quickstart.prm",
         ("Body/Kind=surface", "Body/Surface/File=@SURFACE@",
          "Body/Surface/Organs=phantom", "Output/Pictures=false"),
         cheap=False),
    Case("box", "biomechanics", "biomechanics/verification/plane_wave.prm"),
    # Coarse trials have a quarter less nodes for each element.
    Case("small_body", "biomechanics", "biomechanics/quickstart.prm",
         ("Body/Kind=shape", "Body/Shape/Shape=layered head",
          "Probes/Points=", "Mesh/Element size=0.008",
          "Output/Fields=false", "Time/End time=2e-3"), "3 2"),
    Case("phantom", "biomechanics", "biomechanics/quickstart.prm",
         ("Mesh/Element size=0.02", "Time/End time=2e-3"), "1 1"),
    # It falls on the ground, which deforms it the more, the finer its elements.
    Case("struck_head", "biomechanics",
         "biomechanics/verification/bounce.prm",
         FALLING_HEAD, absent=("steps", "output_bytes")),
    Case("phantom_10mm", "biomechanics", "biomechanics/quickstart.prm",
         levels="2 1", cheap=False),
    Case("ale", "head_impact", "head_impact/quickstart.prm",
         ("Mesh/Cell size=0.01", "Output/Pictures=false",
          "Time/End time=4e-4")),
    Case("ale_fields", "head_impact", "head_impact/quickstart.prm",
         ("Mesh/Cell size=0.008",), cheap=False),
    Case("mpm", "head_impact", "head_impact/verification/water_hammer_mpm.prm",
         ("Output/Pictures=false",), absent=("output_bytes",)),
    Case("mpm_head", "head_impact", "head_impact/showcase/paper_mpm.prm",
         ("MPM/Cell size=0.016", "Time/End time=5e-4"), cheap=False),
    Case("sod_study", "study", "study/quickstart.prm"),
    Case("scene", "scene", "scene/verification/head.prm",
         ("Scene/Accuracy=first look", "Scene/Cell size=0.04",
          "Scene/Element size=0.006", "Scene/Error estimate=false"),
         # Its trials refine all of the air still.
         absent=("blast cells", "blast unknowns", "blast memory_bytes",
                 "blast output_bytes")),
    Case("scene_coarser", "scene", "scene/verification/head.prm", cheap=False),
    Case("scene_man", "scene", "scene/quickstart.prm",
         ("Scene/Accuracy=first look",), "", cheap=False),
    # A blast in 1-D, 2-D and 3-D.
    Case("scene_low_charge", "scene", "scene/quickstart.prm",
         ("Scene/Accuracy=first look", "Scene/Question=loads",
          "Scene/Error estimate=false", "Scene/End time=0.008",
          "Charge/Explosive=tnt", "Charge/Mass=0.5", "Charge/Distance=1.5",
          "Charge/Height=0.07"), "", cheap=False),
)


def write_image(path):
    """A ball of 6 cm with another of 3 cm in it, in voxels of 2 mm."""
    places = np.indices((70, 70, 70)) - 34.5
    radius = 2. * np.sqrt((places ** 2).sum(axis=0))
    labels = 1 * (radius < 60.) + (radius < 30.)
    write_labels(path, labels, 2., -69.)


def write_surface(build, folder, path):
    person = os.path.join(folder, "person")
    subprocess.run(
        [os.path.join(build, "bin", "anatomy"),
         os.path.join(ROOT, "parameter_files/anatomy/quickstart.prm"),
         "--output", person, "--set", "Output/Pictures=false", "--overwrite"],
        check=True, stdout=subprocess.DEVNULL)
    shutil.copy(os.path.join(person, "surface.stl"), path)


def bytes_in(folder):
    """On disk."""
    return sum(os.path.getsize(os.path.join(here, name))
               for here, _, names in os.walk(folder) for name in names)


def found_in(folder):
    """Needs of a run of a solver or of anatomy."""
    summary = read_json(os.path.join(folder, "summary.json"))
    performance = summary["performance"]
    cells = performance.get("largest_cells", summary["cells"])
    return {"cells": cells,
            "unknowns": cells * summary.get("unknowns", 0) / summary["cells"],
            "steps": summary.get("steps", 0),
            "memory_bytes": performance["peak_memory_bytes"],
            "output_bytes": bytes_in(folder)}


def joined(runs, output):
    """Needs of several runs, one after the other."""
    return {"cells": max(run["cells"] for run in runs),
            "unknowns": max(run["unknowns"] for run in runs),
            "steps": sum(run["steps"] for run in runs),
            "memory_bytes": max(run["memory_bytes"] for run in runs),
            "output_bytes": output}


def found_by(case, folder):
    """Rows of names and what was needed."""
    if case.application in SUMMARISED:
        return {case.application: found_in(folder)}
    if case.application == "study":
        variants = os.path.join(folder, "variants")
        runs = [found_in(os.path.join(variants, name, "run"))
                for name in os.listdir(variants)]
        return {"study": joined(runs, bytes_in(folder))}
    rows = {stage["name"]: found_in(os.path.join(folder, stage["name"]))
            for stage in read_json(os.path.join(folder, "scene.json"))
            ["stages"]}
    own = bytes_in(folder) - sum(row["output_bytes"] for row in rows.values())
    rows["report"] = {"cells": 0, "unknowns": 0, "steps": 0, "memory_bytes": 0,
                      "output_bytes": own}
    return rows


def forecast_of(case, check):
    """The same from what --check says."""
    if case.application == "scene":
        return {stage["name"]: stage for stage in check["stages"]}
    return {case.application: check}


def unlike_plan(check, folder):
    """Estimates of the plan of a run that --check does not show."""
    wrong = []
    for name, item in read_json(os.path.join(folder, "summary.json"))[
            "assumptions"].items():
        row = re.search(rf"^ +{name} +{re.escape(item['decision'])} +(\S+)",
                        check, re.MULTILINE)
        limit = item.get("at_most") or item.get("at_least")
        if limit is None or item["estimate"] is None:
            continue
        if not row or row[1] == "unknown" or abs(
                float(row[1]) - item["estimate"]) > 0.1 * item["estimate"]:
            wrong.append(f"{name}: {item['estimate']:.3g} in the run, "
                         f"{row and row[1]} by --check")
    return wrong


def run(case, build, folder, inputs):
    """The forecast and what was found, as rows of names and figures, and what
    else is wrong with --check."""
    settings = [setting.replace("@IMAGE@", inputs["image"])
                .replace("@SURFACE@", inputs["surface"])
                for setting in case.settings]
    output = os.path.join(folder, case.name)
    shutil.rmtree(output, ignore_errors=True)
    command = [os.path.join(build, "bin", case.application),
               os.path.join(ROOT, "parameter_files", case.file),
               "--output", output, *overrides(settings)]
    check = os.path.join(folder, case.name + ".json")
    environment = dict(os.environ, CONTRECOUP_CHECK_FILE=check,
                       XDG_CACHE_HOME=os.path.join(folder, "cache"))
    environment.pop("CONTRECOUP_CHECK_SECONDS", None)
    if case.levels:
        environment["CONTRECOUP_CHECK_LEVELS"] = case.levels
    told = [subprocess.run(command + ["--check", "--verbose"], check=True,
                           capture_output=True, text=True, env=environment
                           ).stdout for _ in range(2)]
    forecast = forecast_of(case, read_json(check))
    with open(os.path.join(folder, case.name + ".txt"), "w",
              encoding="utf-8") as screen:
        screen.write("".join(told))
        screen.flush()
        subprocess.run(command, check=True, stdout=screen, stderr=screen,
                       env=environment)
    flaws = unlike_plan(told[0], output) if case.application == "blast" else []
    if "Calibrating" in told[1]:
        flaws.append("the second --check forgot the first")
    return forecast, found_by(case, output), flaws


def judge(case, forecast, found, flaws):
    """Prints the ratios; returns what is wrong."""
    wrong = [f"{case.name}: {flaw}" for flaw in flaws]
    for row, needed in found.items():
        told = forecast.get(row, {})
        words = []
        for figure, factor in FACTORS.items():
            value = told.get(figure) or 0.
            label = figure if case.application != "scene" \
                else f"{row} {figure}"
            if not value or not needed[figure]:
                is_due = bool(needed[figure]) and label not in case.absent
                words.append("missing" if is_due else "-")
                wrong += [f"{case.name}: no {label}"] if is_due else []
                continue
            ratio = value / needed[figure]
            holds = 1. / factor < ratio < factor
            words.append(f"{ratio:.3f}" + ("" if holds else " !"))
            if not holds:
                wrong.append(f"{case.name}: {label} {value:.4g}, found "
                             f"{needed[figure]:.4g}")
        print(f"{case.name:15} {row:21}" +
              "".join(f"{word:>12}" for word in words), flush=True)
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build")
    parser.add_argument("folder")
    parser.add_argument("names", nargs="*")
    parser.add_argument("--cheap", action="store_true")
    options = parser.parse_args()
    folder = os.path.abspath(options.folder)
    os.makedirs(folder, exist_ok=True)
    shutil.rmtree(os.path.join(folder, "cache"), ignore_errors=True)
    inputs = {name: os.path.join(folder, name + ending)
              for name, ending in (("image", ".nii"), ("surface", ".stl"))}
    cases = [case for case in CASES
             if (case.name in options.names if options.names
                 else case.cheap or not options.cheap)]
    write_image(inputs["image"])
    if any("@SURFACE@" in text for case in cases for text in case.settings):
        write_surface(options.build, folder, inputs["surface"])
    print(f"{'forecast / found':37}" +
          "".join(f"{figure.split('_')[0]:>12}" for figure in FACTORS))
    wrong = []
    for case in cases:
        try:
            wrong += judge(case, *run(case, options.build, folder, inputs))
        except subprocess.CalledProcessError as failure:
            wrong.append(f"{case.name}: {failure}: {failure.stderr or ''}")
    for line in wrong:
        print(line)
    return 1 if wrong or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
