#!/usr/bin/python3
"""A stand-in for the application scene: three stages that write what tests of
scenes look at, and the names of two of a coarser run. Entry "Flaw" makes it misbehave in one way, see self_test.py."""

import glob
import json
import os
import sys
import time

STAGES = ("anatomy", "blast", "biomechanics")
ENTRIES = {"Flaw": "none", "Tissues/Set": "first", "Pause": "0.4", "Large": "",
           "Blast/Output/Checkpoint every steps": "1",
           "Biomechanics/Output/Checkpoint every steps": "1",
           "Biomechanics/Energy audit/Largest residual": "1",
           "Biomechanics/Energy audit/Largest hourglass part": "1"}


# Assumptions, and the entries that decide otherwise.
OWN_NAMES = {"symmetry": "Scene/Symmetry", "rigid_body": "",
             "viscosity": "Scene/End time", "gravity": "Scene/End time",
             "reflection": "Scene/End time",
             "first_stage": "Blast/First stage/Hand over at",
             "quiet_leaves": "Blast/Method/Skip quiet leaves",
             "strain": "Biomechanics/Elements/Kinematics"}


def rows_of(names):
    return [{"item": item,
             "entry": "Time/End time" if flaw == "foreign" else entry}
            for item, entry in names.items()]


def path(*names):
    return os.path.join(output, *names)


def write(text, *names):
    os.makedirs(os.path.dirname(path(*names)), exist_ok=True)
    with open(path(*names) + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(file.name, path(*names))


def read(*names):
    try:
        with open(path(*names), encoding="utf-8") as file:
            return json.load(file)
    except OSError:
        return {}


def key_of(stage):
    """Key of the entries that a stage depends on."""
    if stage == "biomechanics" or flaw == "forgetful":
        return entries["Tissues/Set"]
    return "scene"


def fail(stage, reason, code):
    print(f"error: stage {stage}: {reason}", file=sys.stderr)
    if flaw == "wordy":
        print("more", file=sys.stderr)
    sys.exit(code)


def run_stage(stage):
    """Takes a finished stage as it is, else runs it on from its checkpoint,
    a number of steps; returns its status."""
    record = read(stage + ".stage.json")
    if (record.get("status") == "finished" and record["key"] == key_of(stage)
            and flaw != "restless"):
        return "reused"
    if (record and record["key"] != key_of(stage) and newest(stage) > 0
            and "--overwrite" not in sys.argv and flaw != "ruthless"
            and record["status"] == "started"):
        print(f"a checkpoint of stage {stage} from elsewhere; --overwrite "
              "begins that stage anew", file=sys.stderr)
        sys.exit(1)
    try:
        write(json.dumps({"status": "started", "key": key_of(stage)}),
              stage + ".stage.json")
        compute(stage)
    except OSError as error:
        if flaw == "destructive":
            os.remove(path("anatomy.stage.json"))
        fail(stage, " ".join(str(error).split()), 3)
    write(json.dumps({"status": "finished", "key": key_of(stage)}),
          stage + ".stage.json")
    return "finished"


def newest(stage):
    """The step of the newest checkpoint of a stage."""
    markers = glob.glob(path(stage, "checkpoint", "*", "complete.json"))
    return int(os.path.basename(os.path.dirname(max(markers)))) \
        if markers else 0


def compute(stage):
    first = step = 0 if flaw == "repeats" else newest(stage)
    while step < 20:
        time.sleep(float(entries["Pause"]) / 20.)
        step += 1
        if stage != "anatomy":
            folder = f"{step:04d}"
            write(json.dumps({"state": {"step": step, "updates": step}}),
                  stage, "checkpoint", folder, "run.json")
            write("", stage, "checkpoint", folder, "complete.json")
    if stage == "anatomy":
        write("kind,name\ntissue,lung\n", stage, "quality.csv")
    if stage == "blast":
        write_loads()
        write("step\n1\n", stage, "load_gauges.csv")
    if stage == "biomechanics":
        if float(entries["Biomechanics/Energy audit/Largest residual"]) <= 0.:
            if flaw == "lossy":
                os.remove(path("blast.stage.json"))
            fail(stage, "energy audit", 2)
        write_injuries(first)
    write("step\n1\n", stage, "history.csv")
    write(f"time [s],probe_1_pressure [Pa]\n1,{rounded(5., 'peaks')}\n", stage,
          "probes.csv")
    mass = 50. if flaw == "heavy" and stage == "blast" else 5.
    write("subsection Charges\n  subsection Charge 1\n    set Center = 1, 0, 2"
          f"\n    set Mass   = 3\nset Body mass = {mass}\n",
          stage, "parameters.prm")
    write(json.dumps({"status": "finished", "resumed_from_step": first,
                      "performance": {"updates": step + (
                          first if flaw == "wasteful" else 0)},
                      "mass": mass}), stage, "summary.json")


def write_loads():
    """More than the small disk of a test holds, where that is the test."""
    import h5py
    import numpy
    with h5py.File(path("blast", "loads.h5"), "w") as file:
        file["peak"] = numpy.ones((9 << 17) if entries["Large"] else 10)
        file["impulse"] = numpy.full(10, rounded(2., "loads"))


def rounded(value, what):
    """With the flaw of that name, other on several ranks."""
    several = "OMPI_COMM_WORLD_SIZE" in os.environ
    return value * (1.00001 if flaw == what and several else 1.)


def write_injuries(first):
    strain = 0.01 if entries["Tissues/Set"] == "first" else 0.02
    if flaw == "deaf":
        strain = 0.01
    if flaw == "careless" and first > 0:
        strain *= 1.001
    write(f"measure,value\nstrain,{rounded(strain, 'injuries')}\n",
          "biomechanics", "injury.csv")


def main():
    statuses = {}
    for stage in STAGES:
        begin = time.time()
        status = run_stage(stage)
        statuses[stage] = {"name": stage, "status": status,
                           "wall_seconds": time.time() - begin}
    is_reused = all(found["status"] == "reused" for found in statuses.values())
    if is_reused and "--overwrite" in sys.argv and flaw != "wordless":
        print(f"--overwrite takes {', '.join(STAGES)} as they are")
    for stage in STAGES[1:]:
        statuses["coarser_" + stage] = {"name": "coarser_" + stage,
                                        "status": statuses[stage]["status"]}
    has_coarser = entries.get("Scene/Error estimate") != "false" \
        or flaw == "lingering"
    write(json.dumps({"stages": list(statuses.values()), "charge_mass": 3.,
                      "coarser_run": {"cell_ratio": 2., "element_ratio": 5. / 3.}
                      if has_coarser else None, "table_comparison": [],
                      "charge_place": [1., 0., 2.],
                      "plan": rows_of(OWN_NAMES), "audit": rows_of(OWN_NAMES),
                      "height": 1. if flaw == "low" else 2.,
                      "command": "false" if flaw == "unrepeatable"
                      else "echo finished before"}), "scene.json")
    if flaw != "silent":
        write("<html></html>", "report.html")


if __name__ == "__main__":
    entries = dict(ENTRIES)
    for at, word in enumerate(sys.argv):
        if word == "--set":
            name, value = sys.argv[at + 1].split("=", 1)
            entries[name] = value
    output = sys.argv[sys.argv.index("--output") + 1]
    flaw = entries["Flaw"]
    if os.environ.get("OMPI_COMM_WORLD_RANK", "0") == "0":
        os.makedirs(output, exist_ok=True)
        if flaw != "hurried" or "killed" not in output:
            main()
