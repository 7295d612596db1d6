#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Every entry that selects something refuses to select nothing.

selections.py FOLDER_OF_PROGRAMS

The entries are those that --print-parameters "selects nothing" of each program
prints, and the sections with a name of the user's ("Tissue *"). Each needs a
case: settings with which it selects nothing, for which --check prints one line
of error that names the entry, with exit code 1, and writes nothing. A scene has
the entries of its stages. An entry whose name or meaning is that of a
selection, but which is not printed, fails unless OTHERS tells why.
"""

import os
import re
import subprocess
import sys
import tempfile

import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tests", "applications", "cases"))

from case import overrides  # noqa: E402 (after their path)
from nifti import write_labels  # noqa: E402

FILES = os.path.join(ROOT, "parameter_files")
BOX = "biomechanics/verification/plane_wave.prm"
SOLID_BODY = "biomechanics/extremes/layered_head.prm"
GAS = "blast/verification/charge_axisymmetric.prm"
GAS_BODY = "blast/verification/body_sphere.prm"
BODY = "anatomy/quickstart.prm"
HEAD = "head_impact/quickstart.prm"
GAS_BOX = "head_impact/verification/sod.prm"
VOXELS = "head_impact/showcase/colin_mpm.prm"
DISKS = "head_impact/verification/two_disks.prm"
STUDY = "study/quickstart.prm"
SCENE = "scene/verification/head.prm"
ELEMENTS = "Scene/Element size=0.008"
CUBES = "tests/applications/meshes/two_cubes.msh"

IMAGE = ["Body/Kind=image", "Body/Image/Kind=labels", "Body/Image/File=@IMAGE@",
         "Body/Image/Labels=1: brain; 9: lung"]
MESH = ["Body/Kind=mesh", f"Body/Mesh/File={ROOT}/{CUBES}",
        "Body/Mesh/Tissues=1: brain; 2: skeleton; 9: lung"]
# A region that meets no body in the gas.
BALL = ["Shape=ball", "Center=90, 90, 90", "Radius=1"]


def of(section, entries):
    return [f"{section}/{entry}" for entry in entries]


# By entry or section, the file, the settings, and what the message says in place
# of the entry with the "*" of a section's name replaced by none.
CASES = {
    "blast": {
        "Initial state/Region */Shape": (
            "blast/showcase/hot_ball.prm",
            of("Initial state/Region none", ["Center=99, 99, 99"]),
            'Initial state/Region none = "sphere at 99, 99, 99" selects no gas: '
            "the domain reaches from"),
        "Adaptation/Fine box lower corner": (
            GAS, ["Adaptation/Fine box levels=1",
                  "Adaptation/Fine box lower corner=50, 50",
                  "Adaptation/Fine box upper corner=60, 60"]),
        "Adaptation/Fine box upper corner": (
            GAS, ["Adaptation/Fine box levels=1",
                  "Adaptation/Fine box lower corner=-60, -60",
                  "Adaptation/Fine box upper corner=-50, -50"],
            "Adaptation/Fine box lower corner and upper corner"),
        "Adaptation/Limit */Shape": (
            GAS_BODY, of("Adaptation/Limit none", BALL),
            'Adaptation/Limit none = "ball" selects no leaf'),
        "Rigid body/Finer region */Shape": (
            GAS_BODY, of("Rigid body/Finer region none", BALL),
            'Rigid body/Finer region none = "ball" selects no place of the body'),
        "Charges/Charge *": (
            GAS, ["Charges/Charge none/Center=0, 90"],
            "Charges/Charge none: the charge, from -0.05, 89.95 to 0.05, 90.05 "
            "m, lies outside of the domain"),
        "Probes/Points": (GAS, ["Probes/Points=90, 90"]),
        "Probes/Lines": (GAS, ["Probes/Lines=90, 90 : 91, 91 : 3"]),
        "Probes/Gauge planes": (
            GAS_BODY, ["Probes/Gauge planes=90, 0, 0 : 91, 1, 0 : 3, 3"],
            "Gauge planes"),
        "Pictures/Planes": (GAS_BODY, ["Pictures/Planes=y = 90"]),
        "Loads/Gauges": (GAS_BODY, ["Loads/Record=true",
                                    "Loads/Gauges=far: 90, 90, 90"]),
        "Boundaries/By id": ("blast/verification/mapped_ball.prm",
                             ["Boundaries/By id=77: open"]),
        "Body/Image/Labels": (GAS_BODY, ["Rigid body/Kind=body"] + IMAGE),
        "Body/Mesh/Tissues": (GAS_BODY, ["Rigid body/Kind=body"] + MESH),
    },
    "anatomy": {
        "Body/Image/Labels": (BODY, IMAGE),
        "Body/Mesh/Tissues": (BODY, MESH),
        "Tissues/Tissue *": (
            BODY, ["Tissues/Tissue water/Density=1010"],
            'Tissues/Tissue water = "water" selects no part of the body'),
    },
    "biomechanics": {
        "Supports/Support */Where": (
            BOX, ["Supports/Support none/Where=x>99"],
            'Supports/Support none/Where = "x>99" selects no node of the body: '
            "the body lies from (0, 0, 0) to ("),
        "Loads/Load */Where": (
            BOX, ["Loads/Load none/Where=x>99"],
            'Loads/Load none/Where = "x>99" selects no facet of the body\'s '
            "surface: the body lies from (0, 0, 0) to ("),
        "Mesh/Region */Where": (
            BOX, ["Mesh/Region none/Where=x>99"],
            'Mesh/Region none/Where = "x>99" selects no element'),
        "Mesh/Refined where": (BOX, ["Mesh/Refined where=x>99"],
                               'Mesh/Refined where = "x>99" selects no element'),
        "Mesh/Tissues": (BOX, ["Mesh/Kind=file", f"Mesh/File={ROOT}/{CUBES}",
                               "Mesh/Tissues=1: brain; 2: skeleton; 9: lung"]),
        "Materials/Cavitating tissues": (
            BOX, ["Materials/Cavitating tissues=skeleton, lung"],
            'Materials/Cavitating tissues (lung) = "lung" selects no element: '
            "the tissues of the mesh are skeleton"),
        "Materials/Tissue *": (
            BOX, ["Materials/Tissue lung/Density=1010"],
            'Materials/Tissue lung = "Density = 1010 kg/m^3 instead of 100" '
            "selects no element: the tissues of the mesh are skeleton"),
        "Interface/Tissues": (
            SOLID_BODY, ["Mesh/Element size=0.01", "Interface/Contact=slip",
                         "Interface/Tissues=lung", "Interface/Against=brain"],
            "Interface: the tissues of Tissues"),
        "Interface/Against": (
            SOLID_BODY, ["Mesh/Element size=0.01", "Interface/Contact=slip",
                         "Interface/Tissues=brain", "Interface/Against=lung"],
            "Interface: the tissues of Tissues and Against"),
        "Probes/Points": (
            BOX, ["Probes/Points=0.05, 0, 0; 90, 90, 90"],
            "probe 2 at (90, 90, 90) m is outside of the body"),
        "Measures/Measure *": (
            BOX, ["Measures/Measure none/Probe=77"],
            "Measures/Measure none/Probe = 77, but Probes/Points has 1"),
        "Injury/Measure *": (
            BOX, ["Injury/Measure none/Thresholds=1: harm"],
            "Injury/Measure none: there is no such measure"),
        "Injury/Chest": ("biomechanics/quickstart.prm",
                         ["Mesh/Element size=0.02", "Injury/Chest=9, 9, 9"]),
        "Injury/Active": (
            BOX, ["Injury/Active=true"],
            "Injury/Active = true: injuries of brain and lung are reported"),
        "Body/Image/Labels": (SOLID_BODY, ["Mesh/Kind=body"] + IMAGE),
        "Body/Mesh/Tissues": (SOLID_BODY, ["Mesh/Kind=body"] + MESH),
    },
    "head_impact": {
        "Region */Where": (HEAD, ["Region none/Where=x>99"]),
        "Region */Layer": (HEAD, ["Region none/Layer=scalp"]),
        "Region */Interface": (
            GAS_BOX, ["Rezone/Kind=elastic", "Region gas/Interface=slip"],
            'Region gas/Interface = "slip" selects no'),
        "Side *": (HEAD, ["Side none/Kind=wall"],
                   "Side none: a mesh of kind layered head has no such side"),
        "Plane */Point": (GAS_BOX, ["Plane none/Point=0, 0, 0"]),
        "Plane */Normal": (HEAD, ["Plane wall/Normal=0, 0, -1"], "Plane wall"),
        "Probes/Points": (HEAD, ["Probes/Points=90, 90, 90"]),
        "Injury/Brain": (HEAD, ["Injury/Brain=liver"]),
        "Injury/Skull": (HEAD, ["Injury/Skull=liver"]),
        "Injury/Measure *": (
            HEAD, ["Injury/Measure none/Thresholds=1: harm"],
            "Injury/Measure none: there is no such measure"),
        "Reference/Extent */Region": (
            "head_impact/verification/taylor_bar.prm",
            ["Reference/Extent none/Region=liver"]),
        "Reference/Front/Region": (
            "head_impact/verification/dam_break.prm",
            ["Reference/Front/Region=liver"]),
        "Body/Image/Labels": (VOXELS, IMAGE),
        "Body/Mesh/Tissues": (VOXELS, MESH),
    },
    "study": {
        "Study/Columns": (STUDY, ["Study/Columns=none.csv:last:none"]),
        "Error/Name": (STUDY, ["Error/Kind=known value", "Error/Known value=1",
                               "Error/Name=none.csv:last:none"]),
        "Vary */Entry": (STUDY, ["Vary none/Entry=No/Such", "Vary none/Values=1"],
                         "Vary none"),
    },
    "scene": {
        "Body/Image/Labels": (SCENE, IMAGE),
        "Body/Mesh/Tissues": (SCENE, MESH),
        "Tissues/Tissue *": (
            SCENE, ["Tissues/Tissue water/Density=1010"],
            'Tissues/Tissue water = "water" selects no part of the body: the '
            "tissues of the body are brain"),
        "Injury/Measure *": (
            SCENE, ["Injury/Measure none/Thresholds=1: harm"],
            "Injury/Measure none: there is no such measure"),
        "Blast/Adaptation/Fine box lower corner": (
            SCENE, ["Blast/Adaptation/Fine box levels=1",
                    "Blast/Adaptation/Fine box lower corner=50, 50, 50",
                    "Blast/Adaptation/Fine box upper corner=60, 60, 60"]),
        "Blast/Adaptation/Limit */Shape": (
            SCENE, of("Blast/Adaptation/Limit none", BALL),
            "Blast/Adaptation/Limit none"),
        "Blast/Rigid body/Finer region */Shape": (
            SCENE, of("Blast/Rigid body/Finer region none", BALL),
            "Blast/Rigid body/Finer region none"),
        "Blast/Probes/Points": (SCENE, ["Blast/Probes/Points=90, 90, 90"]),
        "Blast/Probes/Lines": (
            SCENE, ["Blast/Probes/Lines=90, 90, 0 : 91, 91, 0 : 3"]),
        "Blast/Probes/Gauge planes": (
            SCENE, ["Blast/Probes/Gauge planes=90, 0, 0 : 91, 1, 0 : 3, 3"],
            "Gauge planes"),
        "Blast/Pictures/Planes": (SCENE, ["Blast/Pictures/Planes=y = 90"]),
        "Blast/Loads/Gauges": (SCENE, ["Blast/Loads/Gauges=far: 90, 90, 90"]),
        "Biomechanics/Supports/Support */Where": (
            SCENE, [ELEMENTS, "Biomechanics/Supports/Support none/Where=x>99"]),
        "Biomechanics/Loads/Load */Where": (
            SCENE, [ELEMENTS, "Biomechanics/Loads/Load none/Where=x>99"]),
        "Biomechanics/Materials/Cavitating tissues": (
            SCENE, [ELEMENTS, "Biomechanics/Materials/Cavitating tissues=lung"]),
        "Biomechanics/Interface/Tissues": (
            SCENE, [ELEMENTS, "Biomechanics/Interface/Contact=slip",
                    "Biomechanics/Interface/Tissues=lung",
                    "Biomechanics/Interface/Against=brain"],
            "Biomechanics/Interface"),
        "Biomechanics/Interface/Against": (
            SCENE, [ELEMENTS, "Biomechanics/Interface/Contact=slip",
                    "Biomechanics/Interface/Tissues=brain",
                    "Biomechanics/Interface/Against=lung"],
            "Biomechanics/Interface"),
        "Biomechanics/Probes/Points": (
            SCENE, [ELEMENTS, "Biomechanics/Probes/Points=90, 90, 90"]),
        "Biomechanics/Measures/Measure *": (
            SCENE, [ELEMENTS, "Biomechanics/Measures/Measure none/Probe=77"],
            "Biomechanics/Measures/Measure none/Probe = 77"),
    },
}
# Entries that look like a selection and are none, or that a scene sets.
SET_BY_SCENES = "the scene makes gas, body and mesh"
OTHERS = {
    "blast": {"Charges/Charge */Ignition points": "may be outside of the charge",
              "Body/Shape/Tissues": "gives each layer a tissue"},
    "anatomy": {"Body/Shape/Tissues": "gives each layer a tissue"},
    "biomechanics": {"Body/Shape/Tissues": "gives each layer a tissue"},
    "head_impact": {
        "Mesh/Symmetry planes": "planes of the head itself",
        "Body/Shape/Tissues": "gives each layer a tissue",
        "Reference/Shock tube/Interface": "a position of the reference",
        "Reference/Extent */Where": "true where particles are at the end: the "
                                    "run warns"},
    "study": {"Vary */Labels": "names for the report"},
    "scene": {
        "Body/Shape/Tissues": "gives each layer a tissue",
        "Blast/Initial state/Region *": SET_BY_SCENES,
        "Blast/Adaptation/Fine box upper corner": "with the lower corner",
        "Blast/Boundaries/By id": SET_BY_SCENES,
        "Blast/Body/Image/Labels": "Body/Image/Labels of the scene",
        "Blast/Body/Mesh/Tissues": "Body/Mesh/Tissues of the scene",
        "Biomechanics/Body/Image/Labels": "Body/Image/Labels of the scene",
        "Biomechanics/Body/Mesh/Tissues": "Body/Mesh/Tissues of the scene",
        "Biomechanics/Mesh/Region *": SET_BY_SCENES,
        "Biomechanics/Mesh/Refined where": SET_BY_SCENES,
        "Biomechanics/Mesh/Tissues": SET_BY_SCENES,
        "Blast/Charges/Charge *": "the scene makes the charge",
        "Anatomy/Body/Image/Labels": "Body/Image/Labels of the scene",
        "Anatomy/Body/Mesh/Tissues": "Body/Mesh/Tissues of the scene",
        "Anatomy/Tissues/Tissue *": "Tissues/Tissue * of the scene",
        "Biomechanics/Materials/Tissue *": "Tissues/Tissue * of the scene",
        "Biomechanics/Injury/Measure *": "Injury/Measure * of the scene",
        "Biomechanics/Injury/Active": "the scene looks for brain and lung",
        "Biomechanics/Injury/Chest": "the scene looks for the chest"},
}
LOOKS = re.compile(r"(?i)(where|points|lines|planes|gauges|labels|layer|tissues"
                   r"|regions?|against|columns|by id|chest|interface|probe"
                   r"|boxe?s?)$")


def entries(program, *words):
    """Entries that --print-parameters prints, with what it says of them."""
    text = subprocess.run([program, "--print-parameters", *words], check=True,
                          capture_output=True, text=True).stdout
    path, comment, found = [], [], {}
    for line in map(str.strip, text.splitlines()):
        if line.startswith("subsection "):
            path.append(line[len("subsection "):])
        elif line == "end":
            path.pop()
        elif line.startswith("set "):
            name = line[len("set "):].split("=")[0].strip()
            found["/".join(path + [name])] = " ".join(comment)
        comment = comment + [line.lstrip("# ")] if line.startswith("#") else []
    return found


def named_sections(names):
    """Sections with names of the user's, among these entries."""
    return {name.partition("*")[0] + "*" for name in names if "*" in name}


def missing(application, marked, known):
    """Entries and sections that lack a case, and cases that none has."""
    handled = {**CASES[application], **OTHERS[application]}
    looks = {name for name, told in known.items()
             if LOOKS.search(name.split("/")[-1])
             or re.search("is true|a true value", told)}
    # One case of an entry in it serves a section, and one of it its entries.
    serve = set(handled) | named_sections(CASES[application])
    return [f"{application}: {name} has no case" for name in
            sorted((marked | looks) - serve)
            if not named_sections([name]) & set(handled)] + \
        [f"{application}: no entry {name} selects" for name in
         sorted(set(CASES[application]) - marked)]


def all_missing(folder):
    wrong, of_stages = [], set()
    for application in CASES:
        program = os.path.join(folder, application)
        known = entries(program)
        if application == "scene":
            known = {name: told for name, told in known.items()
                     if name.split("/")[0] not in
                     ("Anatomy", "Blast", "Biomechanics")}
        marked = set(entries(program, "selects nothing")) & set(known) | \
            named_sections(known)
        if application == "scene":
            marked |= of_stages
        elif application in ("anatomy", "blast", "biomechanics"):
            of_stages |= {f"{application.capitalize()}/{name}"
                          for name in marked}
        wrong += missing(application, marked, known)
    return wrong


def write_image(path):
    """Labels 1 in a ball of 6 voxels of 5 mm."""
    radius = numpy.sqrt(((numpy.indices((16, 16, 16)) - 8) ** 2).sum(axis=0))
    write_labels(path, radius < 6., 5.)


def flaw_of(folder, here, application, entry):
    """Flaw of the refusal; empty if there is none."""
    file, settings, *told = CASES[application][entry]
    expected = told[0] if told else entry.replace("*", "none")
    command = [os.path.join(folder, application), os.path.join(FILES, file),
               "--check", "--output", os.path.join(here, "run"),
               *overrides(setting.replace("@IMAGE@", os.path.join(
                   here, "image.nii")) for setting in settings)]
    run = subprocess.run(command, capture_output=True, text=True, cwd=here,
                         env={**os.environ, "CONTRECOUP_CHECK_SECONDS": "0"})
    lines = [line for line in run.stderr.splitlines() if line.strip()]
    print(f"{application}: {entry}: {run.stderr.strip()}", flush=True)
    if run.returncode != 1 or len(lines) != 1 or expected not in lines[0]:
        return f"{application}: {entry}: exit code {run.returncode}, " \
               f"'{expected}' expected: {run.stderr.strip()[-300:]}"
    return ""


def main():
    folder = os.path.abspath(sys.argv[1])
    wrong = all_missing(folder)
    with tempfile.TemporaryDirectory() as here:
        write_image(os.path.join(here, "image.nii"))
        wrong += filter(None, (flaw_of(folder, here, application, entry)
                               for application, cases in CASES.items()
                               for entry in cases))
        if set(os.listdir(here)) != {"image.nii"}:
            wrong.append(f"--check wrote {os.listdir(here)}")
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
