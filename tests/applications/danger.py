#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Cases that must not be computed are refused before anything is meshed,
others are not: danger.py APPLICATION PROGRAM BLAST, the last being that
program.

Each row of REFUSED is refused with exit code 1 by --check, the first ones also
by a run, in one line that has the words given, before a mesh is made and
without a file. They and each row of FAULTS leave the results of an earlier run
as they are when --overwrite is given. Each
row of ACCEPTED is accepted by --check, which says the words given, and not
those after "without".
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import zlib

import danger_files

FILES = danger_files.FILES
HUMAN = "blast/quickstart_human.prm"
NEAR = "blast/extremes/body_charge_5_cm.prm"
CUT = "blast/extremes/charge_cut.prm"
GROUND = "blast/extremes/charge_on_ground.prm"
CENTER = "Charges/Charge 1/Center="
MASS = "Charges/Charge 1/Mass="
QUICK = "scene/quickstart.prm"
HEAD = "scene/verification/head.prm"

# Application: rows of a name, a parameter file, overrides, words.
REFUSED = {
    "blast": [
        ("charge in a body", NEAR, [CENTER + "0.1, 0, 0"],
         ["Charges/Charge 1", "rigid body overlap", "Body/Shift"]),
        ("charge in a man, first stage", HUMAN, [CENTER + "0, 0, 1.2"],
         ["Charges/Charge 1", "rigid body overlap"]),
        ("charge in a man, no stage", HUMAN,
         [CENTER + "0, 0, 1.2", "First stage/Kind=none"], ["rigid body overlap"]),
        ("charge whose surface is in a body", NEAR, [CENTER + "-0.02, 0, 0"],
         ["rigid body overlap"]),
        ("charge nearer to a body than a cell", NEAR, [CENTER + "-0.027, 0, 0"],
         ["less than the cell size there", "Rigid body/Levels by 1"]),
        ("charge 10 mm from the skin, first stage", HUMAN,
         [CENTER + "0.2, 0, 1.27"], ["the cell size there, 0.02 m", "Center away by"]),
        ("no room to burn", "blast/quickstart.prm",
         [CENTER + "0, 0, 0.055", "First stage/Kind=spherical"],
         ["are needed to burn it"]),
        ("axisymmetric stage without a way", HUMAN,
         [CENTER + "1, 0, 1.27"], ["no axisymmetric stage remains"]),
        ("body 50 m away", NEAR, ["Body/Shift=50, 0, 0"],
         ["Rigid body: it lies outside of the domain", "m away from it"]),
        ("man 50 m away, first stage", HUMAN, ["Body/Shift=-50, 0, 0"],
         ["Rigid body: it lies outside of the domain"]),
        ("body out of a plane domain",
         "blast/extremes/body_cut_by_boundary.prm", ["Body/Shift=0.5, 7, 0"],
         ["Rigid body: it lies outside of the domain"]),
        ("mass cut by the ground", GROUND,
         [MASS + "0.2", CENTER + "0, 0, 0.01",
          "Charges/Charge 1/Ignition points="],
         ["Mass = 0.2 kg the domain would keep 0.7", "side z low",
          "0.01 m from its centre"]),
        ("mass cut by an open side", NEAR, [CENTER + "-0.15, 0, 0"],
         ["the domain would keep", "side x low"]),
        ("mass cut off a plane of symmetry", NEAR, [CENTER + "-0.075, 0.01, 0"],
         ["the domain would keep", "side y low"]),
        ("mass cut by the ground, first stage", HUMAN,
         [CENTER + "2.458, 0, 0.01"], ["the domain would keep", "z low"]),
        ("charge out of the domain", NEAR, [CENTER + "-0.5, 0, 0"],
         ["lies outside of the domain"]),
        ("sizes out of the domain", CUT, [CENTER + "-0.3, 0.08, 0.02"],
         ["lies outside of the domain"]),
        ("surface in millimetres", NEAR,
         ["Body/Kind=surface", "Body/Surface/File=@MAN@"],
         ["man.stl", "Unit = mm would make it 1.756 m"]),
    ],
    "anatomy": [
        ("surface in millimetres", "anatomy/quickstart.prm",
         ["Body/Kind=surface", "Body/Surface/File=@MAN@"],
         ["man.stl", "1756 m", "Unit = mm would make it 1.756 m"]),
        ("head in millimetres", "anatomy/quickstart.prm",
         ["Body/Kind=surface", "Body/Surface/File=@HEAD@"],
         ["Unit = cm would make it 2.2 m, Body/Surface/Unit = mm"]),
        ("person of some millimetres", "anatomy/quickstart.prm",
         ["Body/Kind=surface", "Body/Surface/File=@MAN@",
          "Body/Surface/Organs=phantom", "Body/Scale=1e-6"],
         ["that of a person is 0.3 to 2.6 m"]),
        ("larger than allowed", "anatomy/quickstart.prm",
         ["Body/Kind=surface", "Body/Surface/File=@MAN@",
          "Body/Surface/Unit=mm", "Body/Surface/Largest size=1"],
         ["Body/Surface/Largest size allows 1 m; Body/Surface/Unit or "
          "Body/Scale changes it"]),
    ],
    "scene": [
        ("charge in the body", HEAD, ["Charge/Place=0, 0, 1"], ["in the body"]),
        ("charge cut by the ground", QUICK,
         ["Charge/Mass=0.2", "Charge/Height=0.01"],
         ["Charge/Height: 0.01 m above the ground", "radius of 0.03",
          "would be cut", "Mass of at most"]),
        ("charge 10 mm from the skin", QUICK,
         ["Charge/Distance=0.08", "Scene/Cell size=0.02"],
         ["Charge/Distance: 0.08", "m from the body", "cells of 20 mm",
          "its centre at least"]),
        ("charge on ground beside the body", QUICK,
         ["Charge/Mass=0.2", "Charge/Place=0.27, 0.1, 0.032",
          "Scene/Cell size=0.02"],
         ["Charge/Height", "or a larger Distance"]),
        ("late end", QUICK, ["Scene/End time=1"],
         ["Scene/End time = 1 s", "from 0.001", "s are possible"]),
        ("large mass", QUICK, ["Charge/Mass=1e5"],
         ["Charge/Height", "Mass of at most"]),
        ("far charge", QUICK,
         ["Charge/Place=190, 190, 190", "Scene/End time=1"],
         ["Charge/Place: charge and body are 328 m apart"]),
        ("charge beyond reach", QUICK, ["Charge/Place=30000, 0, 1"],
         ["the blast reaches the body at"]),
        ("surface in millimetres", QUICK,
         ["Body/Kind=surface", "Body/Surface/File=@MAN@",
          "Body/Surface/Organs=phantom"],
         ["Unit = mm would make it 1.756 m"]),
        ("another place of the body in the blast", HEAD,
         ["Blast/Body/Shift=50, 0, 1"],
         ["Blast/Body/Shift = 50, 0, 1 contradicts Body/Shift of the scene"]),
        ("entry of the scene behind one of a stage", HEAD,
         ["Blast/Method/Scheme=discontinuous galerkin"],
         ["stage blast: Body/Kind: bodies need Blast/Method/Scheme ="]),
        ("section of the scene behind one of a stage", HEAD,
         ["Blast/Domain/Upper corner=0.605, 1.28, 1.92"],
         ["Blast/Domain: from", "it does not hold the charge, which is from"]),
        ("other subcells in the blast", HEAD,
         ["Blast/Method/Subcells=3"],
         ["Blast/Method/Subcells = 3 contradicts Scene/Cell size of the scene"]),
        ("entry of a stage that the user wrote", HEAD,
         ["Blast/Domain/Upper corner=1e3"],
         ["Blast/Domain: the gas around a body needs", "three numbers"]),
    ],
    "biomechanics": [
        ("body a metre away", danger_files.BALL, ["Body/Shift=1, 0, 0"],
         ["Loads/Recorded/File", "their middle is -1, 0, 0 m",
          "Shift, Rotation"]),
        ("body that was turned", danger_files.WEDGE, ["Body/Rotation=0, 0, 180"],
         ["Loads/Recorded/File", "Largest misfit = 0.2"]),
        ("another size", danger_files.BALL, ["Body/Scale=1.5"],
         ["Loads/Recorded/File", "mm off the body's surface"]),
    ],
}

NO_SURFACE = ["Body/Kind=surface", "Body/Surface/File=/nowhere/man.stl"]

# Application: rows of a name, a parameter file, overrides.
FAULTS = {
    "blast": [
        ("no such surface", NEAR, NO_SURFACE),
        ("no such value", NEAR, ["Time/End time=-1"]),
        ("no such entry", NEAR, ["Time/Last time=1"]),
    ],
    "anatomy": [
        ("no such surface", "anatomy/quickstart.prm", NO_SURFACE),
        ("no such value", "anatomy/extremes/needle.prm",
         ["Mesh/Element size=-1"]),
        ("no element", "anatomy/extremes/needle.prm", ["Mesh/Element size=1"]),
    ],
    "scene": [
        ("no such surface", HEAD, NO_SURFACE),
        ("no such value", HEAD, ["Scene/End time=-1"]),
        ("no such value of a stage", HEAD, ["Blast/Method/CFL number=-1"]),
    ],
    "biomechanics": [
        ("no such surface", danger_files.BALL, NO_SURFACE),
        ("no such loads", danger_files.BALL,
         ["Loads/Recorded/File=/nowhere/loads.h5"]),
        ("no such value", danger_files.BALL, ["Time/End time=-1"]),
    ],
}

ACCEPTED = {
    "blast": [
        ("a quarter of a charge", NEAR, [], ["valid"], ["WARNING"]),
        ("a charge one cell from a body", NEAR, [CENTER + "-0.0305, 0, 0"],
         ["valid"], []),
        ("a charge 10 mm from a body in cells of 5 mm", NEAR,
         [CENTER + "-0.035, 0, 0"], ["valid"], []),
        ("sizes that a side cuts", CUT, [], ["valid"], []),
        ("a charge on the ground", GROUND, [], ["valid"], []),
        ("half a charge in the ground", GROUND,
         [MASS + "0.2", CENTER + "0, 0, 0",
          "Charges/Charge 1/Ignition points="], ["valid"], []),
        ("a man cut by his plane of symmetry", HUMAN, [], ["valid"],
         ["WARNING"]),
        ("a man who stands in the ground", HUMAN, ["Body/Shift=0, 0, -0.5"],
         ["WARNING: the rigid body reaches through side z low", "valid"], []),
        ("a body that leaves the domain",
         "blast/extremes/body_cut_by_boundary.prm", [],
         ["WARNING: the rigid body reaches through side x high"], []),
        ("a wall", "blast/verification/body_wedge.prm", [], ["valid"],
         ["WARNING"]),
    ],
    "anatomy": [
        ("surface in millimetres", "anatomy/quickstart.prm",
         ["Body/Kind=surface", "Body/Surface/File=@MAN@",
          "Body/Surface/Unit=mm"], ["x 1.756 m", "on 1 rank, with output in"],
         []),
        ("surface in metres by its scale", "anatomy/quickstart.prm",
         ["Body/Kind=surface", "Body/Surface/File=@MAN@", "Body/Scale=0.001"],
         ["x 1.756 m"], []),
        ("a wall", "anatomy/quickstart.prm",
         ["Body/Kind=surface", "Body/Surface/File=@MAN@",
          "Body/Surface/Unit=cm", "Body/Surface/Largest size=20",
          "Mesh/Element size=0.1"], ["x 17.56 m"], []),
    ],
    "scene": [
        ("the whole", HEAD, [],
         ["stage anatomy:", "stage blast:", "stage biomechanics:",
          "on 1 rank stage by stage, with output in", "wall time",
          "blast would run on 1 rank to time"], [tempfile.gettempdir() + "/", ".prm:"]),
        ("charge on the ground", QUICK,
         ["Charge/Mass=0.2", "Charge/Height=0.032"], ["stage by stage"], []),
        ("charge a little aside", QUICK, ["Charge/Place=2.4, 0.003, 1.27"],
         ["stage by stage"], []),
        ("loads with a preset for injuries", danger_files.LOADS, [],
         ["rigid_body", "valid"], ["set but not used"]),
        ("loads with an entry for injuries", danger_files.LOADS,
         ["Biomechanics/Elements/Kinematics=small strain"],
         ["Biomechanics/Elements/Kinematics is set but not used"], []),
        ("charge near the skin", QUICK, ["Charge/Distance=0.12"],
         ["is not known beforehand", "stage by stage"], []),
    ],
    "biomechanics": [
        ("where they were recorded", danger_files.BALL, [], ["valid"], []),
        ("a wedge where it was", danger_files.WEDGE, [], ["valid"], []),
        ("half of them, mirrored", danger_files.BALL,
         ["Loads/Recorded/File=@HALF@", "Loads/Recorded/Mirror=y"], ["valid"],
         []),
        ("a ball that was turned", danger_files.BALL,
         ["Body/Rotation=0, 180, 0"], ["valid"], []),
        ("another size that is wanted", danger_files.BALL,
         ["Body/Scale=1.5", "Loads/Recorded/Largest misfit=100"], ["valid"],
         []),
    ],
}


def call(program, file, overrides, extra):
    words = [program,
             file if os.path.exists(file) else os.path.join(FILES, file)]
    for override in overrides:
        words += ["--set", override]
    return subprocess.run(words + extra + ["--verbose"], capture_output=True, text=True,
                          env={**os.environ, "CONTRECOUP_CHECK_SECONDS": "0"})


def judge_refusal(run, words):
    """Flaw of a refusal; empty if there is none."""
    if run.returncode != 1:
        return f"exit code {run.returncode}"
    lines = run.stderr.strip().splitlines()
    if len(lines) != 1 or not lines[0].startswith("error: "):
        return f"{len(lines)} lines"
    if " cells, " in run.stdout or os.path.exists("output"):
        return "it was meshed, or files were left"
    missing = [word for word in words if word not in lines[0]]
    return f"without {missing}" if missing else ""


def put_earlier_run(application, folder):
    """Results that --overwrite would remove; returns their content."""
    content = {name: f"of an earlier run: {name}\n".encode() for name in
               ("summary.json", "history.csv", "mesh.vtu", "scene.json")}
    record = {"application": application, "status": "finished",
              "names": {"results": list(content), "others": []},
              "results": {name: {"bytes": len(text), "crc32": zlib.crc32(text)}
                          for name, text in content.items()},
              "input_files": {}, "entries": {}}
    content["manifest.json"] = json.dumps(record).encode()
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for name, text in content.items():
        with open(os.path.join(folder, name), "wb") as file:
            file.write(text)
    return content


def judge_loss(run, folder, before):
    """Flaw of a run that was refused in a folder with results."""
    if run.returncode != 1 or len(run.stderr.strip().splitlines()) != 1:
        return f"exit code {run.returncode}"
    after = {}
    for name in os.listdir(folder):
        with open(os.path.join(folder, name), "rb") as file:
            after[name] = file.read()
    return "" if after == before else f"left are {sorted(after)}"


def judge_acceptance(run, words, others):
    """Flaw of the output of --check; empty if there is none."""
    if run.returncode != 0:
        return f"exit code {run.returncode}"
    missing = [word for word in words if word not in run.stdout]
    if missing:
        return f"without {missing}"
    found = [word for word in others if word in run.stdout]
    return f"with {found}" if found else ""


def main(application, program, blast):
    places = danger_files.write(application, blast)

    def fill(texts):
        for place, path in places.items():
            texts = [text.replace(f"@{place}@", path) for text in texts]
        return texts

    n_failed = 0
    shutil.rmtree("output", ignore_errors=True)

    def tell(name, problem, run):
        nonlocal n_failed
        print(f"{'FAILED' if problem else 'ok'}: {name}"
              f"{': ' + problem if problem else ''}\n    "
              f"{run.stderr.strip()}", flush=True)
        if problem:
            n_failed += 1
            print(run.stdout[-2000:])

    for row, (name, file, overrides, words) in enumerate(
            REFUSED[application]):
        extras = [["--check"]]
        if row < 2:
            extras.append(["--output", "output"])
        for extra in extras:
            run = call(program, file, fill(overrides), extra)
            tell(f"refuses {name} ({extra[0]})", judge_refusal(run, words), run)
    for name, file, overrides, *_ in (FAULTS[application]
                                      + REFUSED[application][:2]):
        before = put_earlier_run(application, "earlier")
        run = call(program, file, fill(overrides),
                   ["--overwrite", "--output", "earlier"])
        tell(f"keeps results despite {name}",
             judge_loss(run, "earlier", before), run)
    for name, file, overrides, words, others in ACCEPTED[application]:
        run = call(program, file, fill(overrides),
                   ["--check", "--output", "output"])
        tell(f"accepts {name}", judge_acceptance(run, words, others), run)
    return 1 if n_failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
