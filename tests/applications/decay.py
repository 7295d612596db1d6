#!/usr/bin/env python3
"""A stand-in for an application, with its command line and output files: the
decay dx/dt = -x by Euler steps. Entry "Flaw" makes it misbehave in one way,
so that self_test.py can see each kind of run_case.py fail."""

import glob
import json
import math
import os
import shutil
import signal
import sys
import time

ENTRIES = {"Steps": "60", "Checkpoint every": "15", "Flaw": "none",
           "Step size": "0.01", "Scene": "decay",
           "Time/Steps in this run": "0"}


def refuse(message, code=1):
    lines = [message]
    if entries["Flaw"] == "wordy":
        lines.append("a second line")
    print("\n".join(lines), file=sys.stderr)
    sys.exit(code)


def read(arguments):
    """The parameter file, then the overrides."""
    lines = open(arguments[0]).read().splitlines()
    lines += [arguments[at + 1] for at, word in enumerate(arguments)
              if word == "--set"]
    for line in filter(None, lines):
        name, value = line.split("=", 1)
        if name not in ENTRIES:
            refuse(f"unknown entry '{name}'")
        entries[name] = value
    if float(entries["Step size"]) <= 0.:
        if entries["Flaw"] == "hasty":
            os.makedirs(output)
        refuse("Step size must be positive")


def restore():
    """Step and value of the last complete checkpoint."""
    folder = max(glob.glob(os.path.join(output, "checkpoint", "*", "complete")))
    folder = os.path.dirname(folder)
    text = open(os.path.join(folder, "state")).read()
    if not text.endswith("end\n"):
        if entries["Flaw"] == "meddling":
            open(os.path.join(output, "log.txt"), "a").write("tried\n")
        refuse("checkpoint is truncated")
    step, value, scene, _ = text.split()
    if scene != entries["Scene"]:
        refuse("checkpoint of another scene")
    if entries["Flaw"] == "forgetful":
        value = f"{float(value):.6e}"
    path = os.path.join(output, "history.csv")
    rows = open(path).read().splitlines()[:int(step) + 2]
    open(path, "w").write("\n".join(rows) + "\n")
    return int(step), float(value)


def save(step, value):
    folder = os.path.join(output, "checkpoint", f"{step:04d}")
    if entries["Flaw"] == "careless":
        shutil.rmtree(os.path.dirname(folder), ignore_errors=True)
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "state"), "w") as file:
        file.write(f"{step} {value!r} {entries['Scene']} " + " " * (1 << 16)
                   + "end\n")
    open(os.path.join(folder, "complete"), "w").close()


def summarise(status, step, value):
    exact = math.exp(-step * float(entries["Step size"]))
    with open(os.path.join(output, "summary.json"), "w") as file:
        json.dump({"status": status, "errors": {"x": abs(value - exact)},
                   "conservation": {}}, file)


def advance(value):
    step_size = float(entries["Step size"])
    if entries["Flaw"] == "rank" and "OMPI_COMM_WORLD_SIZE" in os.environ:
        value *= 1. + 1e-7
    if entries["Flaw"] == "nan":
        value = math.nan
    if entries["Flaw"] == "order":
        return value * (1. - 0.9 * step_size)
    return value * (1. - step_size)


def run():
    stopped = []
    signal.signal(signal.SIGTERM, lambda *_: stopped.append(True))
    step, value = 0, 1.
    if "--resume" in sys.argv:
        step, value = restore()
    else:
        os.makedirs(output)
        open(os.path.join(output, "history.csv"), "w").write("step,x\n0,1.\n")
    last = step + int(entries["Time/Steps in this run"])
    while step < int(entries["Steps"]):
        value = advance(value)
        step += 1
        with open(os.path.join(output, "history.csv"), "a") as history:
            history.write(f"{step},{value!r}\n")
        if stopped or step == last:
            save(step, value)
            return summarise("stopped", step, value)
        if step % int(entries["Checkpoint every"]) == 0:
            save(step, value)
        time.sleep(0.005)
    return summarise("finished", step, value)


entries = dict(ENTRIES)
output = sys.argv[sys.argv.index("--output") + 1]
read(sys.argv[1:])
if "--check" in sys.argv:
    print(f"{entries['Steps']} steps")
    if entries["Flaw"] == "hasty":
        os.makedirs(output)
    sys.exit(0)
if os.environ.get("OMPI_COMM_WORLD_RANK", "0") != "0":
    sys.exit(0)
try:
    run()
except OSError as error:
    refuse(f"cannot write: {error.strerror}", code=3)
