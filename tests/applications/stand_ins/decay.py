#!/usr/bin/python3
"""A stand-in for an application, with its command line and output files: the
decay dx/dt = -x by Euler steps. Entry "Flaw" makes it misbehave in one way,
so that self_test.py can see each kind of run_case.py fail. "Writes" names what
it leaves besides history.csv, see extra_files.py."""

import glob
import json
import math
import os
import shutil
import signal
import sys
import time

ENTRIES = {"Time/Largest number of steps": "60",
           "Time/Steps in this run": "0",
           "Output/Checkpoint every steps": "15",
           "Flaw": "none", "Step size": "0.01",
           "Scene": "decay", "Writes": "", "Fails at": "", "Skip": "false",
           "Brief": "false",
           "Loads/Smallest overpressure": "0.0001", "Domain/Size": "given",
           "Domain/Lower corner": "0, 0, 0", "Domain/Upper corner": "1, 1, 1",
           "Domain/Coarse leaves": "1, 1, 1", "Boundaries/y low": "open"}
BUILD = "1.0.0 (decade)"


def flawed(name):
    return entries["Flaw"] == name


def refuse(message, code=1):
    lines = ["error: " + message]
    if flawed("wordy"):
        lines.append("a second line")
    print("\n".join(lines), file=sys.stderr)
    sys.exit(code)


def lines_of(path):
    """Lines of a file and of those that it includes."""
    lines = []
    for line in open(path).read().splitlines():
        lines += lines_of(line[len("include "):]) \
            if line.startswith("include ") else [line]
    return lines


def read(arguments):
    """The parameter file, then the overrides."""
    lines = lines_of(arguments[0])
    lines += [arguments[at + 1] for at, word in enumerate(arguments)
              if word == "--set"]
    for line in filter(None, lines):
        if line.startswith("#"):
            continue
        name, value = line.split("=", 1)
        if name not in ENTRIES:
            refuse(("" if flawed("nameless") else f"{arguments[0]}: ")
                   + f"unknown entry '{name}'")
        entries[name] = value
    if float(entries["Step size"]) <= 0.:
        if flawed("hasty"):
            os.makedirs(output)
        refuse("Step size must be positive")


def check_each(files):
    """--check of one file, or of several with their names; the exit code."""
    code = 0
    for file in files:
        if len(files) > 1 and not flawed("nameless"):
            print(file + ":", flush=True)
        try:
            read([file, *sys.argv[1:]])
            check()
        except SystemExit as end:
            code = max(code, end.code)
    return code


def require_known(run):
    """Only format and entries matter in a checkpoint of another build."""
    builds = f"of {run['version']} ({run['git_revision']}), not of {BUILD}"
    if run["format"] != 1 and not flawed("gullible"):
        refuse("the checkpoint has another format, it is " + builds)
    for name in ENTRIES:
        if name not in run["parameters"] and not flawed("lenient"):
            refuse(f"no entry {name} in a checkpoint " + builds)
    if BUILD not in builds.split(", not")[0] and not flawed("mute"):
        print("checkpoint " + builds)


def restore():
    """Step, value and updates of the last complete checkpoint."""
    markers = glob.glob(os.path.join(output, "checkpoint", "*",
                                     "complete.json"))
    folder = os.path.dirname(max(markers))
    with open(os.path.join(folder, "run.json")) as file:
        require_known(json.load(file))
    text = open(os.path.join(folder, "state.bin")).read()
    if not text.endswith("end\n"):
        if flawed("meddling"):
            open(os.path.join(output, "log.txt"), "a").write("tried\n")
        refuse("checkpoint is truncated")
    step, value, scene, _ = text.split()
    if scene != entries["Scene"]:
        refuse("checkpoint of another scene")
    step, value = int(step), float(value)
    if flawed("forgetful"):
        value = float(f"{value:.1e}")
    if flawed("repeats"):
        step, value = 0, 1.
    path = os.path.join(output, "history.csv")
    rows = open(path).read().splitlines()[:step + 2]
    open(path, "w").write("\n".join(rows) + "\n")
    return step, value


def save(step, value):
    folder = os.path.join(output, "checkpoint", f"{step:04d}")
    if flawed("careless"):
        for path in glob.glob(os.path.join(output, "checkpoint", "*", "*.bin")):
            with open(path, "r+") as file:
                file.write("spoilt")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "state.bin"), "w") as file:
        file.write(f"{step} {value!r} {entries['Scene']} " + " " * (1 << 16)
                   + "end\n")
    with open(os.path.join(folder, "run.json"), "w") as file:
        json.dump({"state": {"step": step, "updates": 10 * step},
                   "version": BUILD.split(" (")[0], "format": 1,
                   "git_revision": BUILD.split(" (")[1][:-1],
                   "parameters": entries}, file)
    with open(os.path.join(folder, "complete.json"), "w") as file:
        file.write('{"files": {}}')


def results():
    """Measures of a blast in a domain that ends at the upper corner, with an
    error of the step size."""
    upper = float(entries["Domain/Upper corner"].split(",")[0])
    far = 1. + math.exp(-upper)
    size = float(entries["Step size"])
    is_part = flawed("halved") and is_half()
    return {"loads_impulse_x": value_of(1. if is_part else 2., "N s"),
            "loads_impulse_y": value_of(0.5 if is_part else 0., "N s"),
            "loads_chest_peak": value_of(far, "Pa"),
            "loads_chest_impulse": value_of(far, "Pa s"),
            "probe_1_peak_overpressure": value_of(5e3 * (1. - size), "Pa"),
            "probe_1_impulse": value_of(10. * (1. - 0.5 * size), "Pa s")}


def is_half():
    return entries["Boundaries/y low"] == "symmetry"


def assumptions():
    """That a plane of symmetry leaves half of the gas, if there is one."""
    return {"modelled_part": {
        "decision": "half of the gas", "quantity": "fraction", "unit": "-",
        "estimate": 0.5, "measured": 0.5, "at_most": None, "holds": None,
        "entry": "Boundaries"}} if is_half() else {}


def value_of(value, unit):
    return {"value": value, "unit": "" if flawed("unitless") else unit}


def size_domain():
    """Domain/Size = by time makes it large; the parameters say how large."""
    if entries["Domain/Size"] == "by time" and not flawed("narrow"):
        entries["Domain/Upper corner"] = "10, 10, 10"
    with open(os.path.join(output, "parameters.prm"), "w") as file:
        for name in ("Lower corner", "Upper corner", "Coarse leaves"):
            file.write(f"  set {name} = {entries['Domain/' + name]}\n")


def check():
    """Prints the answer to --check."""
    if flawed("silent"):
        return
    if flawed("thoughtless"):
        print("WARNING: Step size is set but not used: Flaw is thoughtless")
    ranks = "" if flawed("rankless") else " on 1 rank"
    print(f"decay would run{ranks}\nThe parameters are valid.")


def write_manifest(status):
    with open(os.path.join(output, "manifest.json"), "w") as file:
        json.dump({"status": "finished" if flawed("boastful") else status},
                  file)


def summarise(status, step, value, first):
    write_manifest(status)
    exact = math.exp(-step * float(entries["Step size"]))
    with open(os.path.join(output, "summary.json"), "w") as file:
        json.dump({"application": "decay", "format": 1, "version": "1",
                   "git_revision": "0", "status": status,
                   "time": step * float(entries["Step size"]),
                   "steps": step, "retries": 0, "ranks": 1, "unknowns": 10,
                   "wall_seconds": 1., "checks": {
                       "skipped_updates": value_of(
                           0.1 if first and flawed("dozing") else 0.5, "-")},
                   "assumptions": assumptions(),
                   "timers": {}, "warnings": [], "errors": {"x": abs(value - exact)},
                   "interruptions": [],
                   "resumed_from_step":
                       first if "--resume" in sys.argv else None,
                   "performance": {
                       "peak_memory_bytes": 1e6, "wall_seconds": 1.,
                       "core_seconds": 1., "updates_per_second": 10.,
                       "updates_per_second_per_core": 10., "updates": 10 * (
                           step + (first if flawed("wasteful") else 0))},
                   "results": results() | {"probe_1_peak": value_of(
                       1. if first and flawed("low") else 2., "Pa")},
                   "cells": 10,
                   "conservation": {"mass_first": 0.5 if is_half() else 1.}},
                  file)


def advance(value):
    step_size = float(entries["Step size"])
    if flawed("rank") and "OMPI_COMM_WORLD_SIZE" in os.environ:
        value *= 1. + 1e-7
    if flawed("skips") and entries["Skip"] == "true":
        value *= 1. + 1e-15
    if flawed("nan"):
        value = math.nan
    if flawed("order"):
        return value * (1. - 0.9 * step_size)
    return value * (1. - step_size)


def fails_at(step):
    """Whether the run fails now, as it does again when it is resumed."""
    return entries["Fails at"] and step == int(entries["Fails at"])


def run():
    stopped = []
    for number in (signal.SIGTERM, signal.SIGUSR1):
        signal.signal(number, lambda asked, _: stopped.append(asked))
    step, value = 0, 1.
    if "--resume" in sys.argv:
        step, value = restore()
    else:
        os.makedirs(output, exist_ok=True)
        if flawed("changing") and os.path.exists(
                os.path.join(output, "checkpoint")):
            value = 1.1
        open(os.path.join(output, "history.csv"), "w").write("step,x\n0,1.\n")
    write_manifest("started")
    size_domain()
    first = step
    last = step + int(entries["Time/Steps in this run"])
    end = int(entries["Time/Largest number of steps"])
    if entries["Brief"] == "true":
        end = 1
    while step < end:
        value = advance(value)
        step += 1
        with open(os.path.join(output, "history.csv"), "a") as history:
            history.write(f"{step},{value!r}\n")
        if fails_at(step):
            if flawed("untidy"):
                shutil.rmtree(os.path.join(output, "checkpoint"))
            refuse("it fails" + (" again" if "--resume" in sys.argv
                                 and flawed("talkative") else ""), code=2)
        if stopped or step == last:
            if not (stopped and flawed("late")):
                save(step, value)
            summarise("stopped", step, value, first)
            sys.exit(128 + stopped[0] if stopped and not flawed("content")
                     else 0)
        if step % int(entries["Output/Checkpoint every steps"]) == 0:
            save(step, value)
        time.sleep(0.001)
    if entries["Writes"]:
        import extra_files
        extra_files.write(output, entries)
    return summarise("finished", step, value, first)


def gather_ranks():
    """Only the first rank computes, once no other can be hit by a signal."""
    rank = int(os.environ.get("OMPI_COMM_WORLD_RANK", "0"))
    names = [f"{output}_rank_{other}" for other in range(
        1, int(os.environ.get("OMPI_COMM_WORLD_SIZE", "1")))]
    if rank > 0:
        signal.signal(signal.SIGUSR1, signal.SIG_IGN)
        open(names[rank - 1], "w").close()
        sys.exit(0)
    while not all(map(os.path.exists, names)):
        time.sleep(0.005)


if __name__ == "__main__":
    entries = dict(ENTRIES)
    output = "output"
    if "--output" in sys.argv:
        output = sys.argv[sys.argv.index("--output") + 1]
    if "--check" in sys.argv:
        code = check_each([word for at, word in enumerate(sys.argv)
                           if at > 0 and not word.startswith("--")
                           and sys.argv[at - 1] not in ("--set", "--output")])
        if flawed("hasty"):
            os.makedirs(output)
        sys.exit(code)
    read(sys.argv[1:])
    gather_ranks()
    if flawed("fragile"):
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
    try:
        run()
    except OSError as error:
        if flawed("messy"):
            open(os.path.join(output, "state.partial"), "w").close()
        refuse(f"cannot write: {error.strerror}", code=3)
