#!/usr/bin/env python3
"""Runs an application on a shipped parameter file and judges what it leaves.

run_case.py KIND --application PROGRAM --file FILE.prm [options]; the kinds
are the functions in KINDS below, and the first line of each says what it
proves. Exit code 0: proven; 1: not, with the reason on stdout.
"""

import argparse
import csv
import filecmp
import glob
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import time

import cost_cases
import full_disk
import load_cases
import main_job_cases
import scene_cases
import study_cases


REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))


class Failed(Exception):
    """What was to be proven does not hold."""


class Case:
    """One parameter file with overrides, run in folders below the working
    directory."""

    def __init__(self, options):
        self.options = options
        shutil.rmtree(options.name, ignore_errors=True)
        os.makedirs(options.name)

    def folder(self, name):
        return os.path.join(self.options.name, name)

    def command(self, output, extra=(), ranks=None, file=None, program=None):
        ranks = ranks or self.options.ranks
        command = []
        if ranks > 1:
            command = [self.options.mpiexec, "-np", str(ranks)]
        command += [program or self.options.application,
                    file or self.options.file]
        for override in self.options.set:
            command += ["--set", override]
        if output is not None:
            command += ["--output", output]
        return command + list(extra)

    def start(self, *arguments, preexec_fn=None, **keywords):
        command = self.command(*arguments, **keywords)
        print("+ " + " ".join(command), flush=True)
        return subprocess.Popen(command, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True,
                                preexec_fn=preexec_fn)

    def run(self, *arguments, codes=(0,), **keywords):
        """Runs to the end; returns exit code, stdout and stderr."""
        process = self.start(*arguments, **keywords)
        out, err = process.communicate()
        if process.returncode not in codes:
            print(out[-4000:] + err[-4000:])
            raise Failed(f"exit code {process.returncode}, expected "
                         + " or ".join(map(str, codes)))
        return process.returncode, out, err


def read_summary(output):
    with open(os.path.join(output, "summary.json")) as file:
        return json.load(file)


def look_up(summary, key):
    """The entry of @p summary that a dotted key names."""
    value = summary
    for part in key.split("."):
        if not isinstance(value, dict) or part not in value:
            raise Failed(f"summary.json has no '{key}'; at '{part}' there are:"
                         f" {', '.join(value) if value else 'none'}")
        value = value[part]
    return value


def check_bound(summary, bound):
    """@p bound is 'key < number' (of the absolute value), 'key > number' or
    'key == word'."""
    match = re.fullmatch(r"\s*([\w. ]+?)\s*(<|>|==)\s*(\S+)\s*", bound)
    if not match:
        raise Failed(f"not a bound: '{bound}'")
    key, relation, limit = match.groups()
    value = look_up(summary, key)
    if relation == "==":
        holds = str(value) == limit
    elif not isinstance(value, (int, float)):
        holds = False
    elif relation == "<":
        holds = abs(value) < float(limit)
    else:
        holds = value > float(limit)
    print(f"{key} = {value}, required {relation} {limit}")
    if not holds:
        raise Failed(f"{key} = {value} is not {relation} {limit}")


def check_finite(output):
    """No table of the run holds a number that is not one."""
    for name in ("history.csv", "probes.csv"):
        path = os.path.join(output, name)
        if not os.path.exists(path):
            continue
        with open(path, newline="") as file:
            rows = list(csv.reader(file))
        for number, row in enumerate(rows[1:], 2):
            if not all(math.isfinite(float(value)) for value in row):
                raise Failed(f"{path}:{number}: {','.join(row)}")
        if len(rows) < 2:
            raise Failed(f"{path} has no rows")


def checkpoints(output):
    """The numbered checkpoint folders, oldest first."""
    return sorted(path for path in
                  glob.glob(os.path.join(output, "checkpoint", "*"))
                  if os.path.isdir(path))


def compare_numbers(tolerance, first, second, names):
    """Lets numdiff compare the files @p names of two runs."""
    for name in names:
        print(f"numdiff {tolerance} {name}", flush=True)
        run = subprocess.run(
            ["numdiff", "-s", " ,\n\t", *tolerance.split(),
             os.path.join(first, name), os.path.join(second, name)],
            capture_output=True, text=True)
        if run.returncode != 0:
            print(run.stdout[-4000:] + run.stderr)
            raise Failed(f"{name} differs from that of {first}")


def compare_bytes(first, second, names):
    for name in names:
        one, two = (os.path.join(run, name) for run in (first, second))
        if not filecmp.cmp(one, two, shallow=False):
            raise Failed(f"{name} is not the same to the last bit in {first} "
                         f"and {second}")


def bounds(case):
    """The run ends with one of the exit codes, and its summary keeps all
    bounds."""
    output = case.folder("run")
    code, out, err = case.run(output, codes=case.options.exit or (0,))
    told = out if code == 0 else err
    if case.options.message not in told:
        raise Failed(f"nothing says '{case.options.message}': {told}")
    check_finite(output)
    summary = read_summary(output)
    for bound in case.options.bound:
        check_bound(summary, bound)


def regression(case):
    """The tables of the run agree with the committed ones."""
    output = case.folder("run")
    case.run(output)
    check_finite(output)
    if os.environ.get("CONTRECOUP_UPDATE_REFERENCES") == "1":
        os.makedirs(case.options.reference, exist_ok=True)
        for name in case.options.compare:
            shutil.copy(os.path.join(output, name), case.options.reference)
    compare_numbers(case.options.tolerance, case.options.reference, output,
                    case.options.compare)


def ranks(case):
    """One rank and several give the same tables."""
    count = case.options.ranks
    case.run(case.folder("serial"), ranks=1)
    case.run(case.folder("parallel"), ranks=max(count, 2))
    check_finite(case.folder("serial"))
    compare_numbers(case.options.tolerance, case.folder("serial"),
                    case.folder("parallel"), case.options.compare)


def convergence(case):
    """The error falls with at least the required order as the mesh is
    refined; each --vary value halves the mesh width of the one before."""
    errors = []
    entry, values = case.options.vary.split("=", 1)
    for value in values.split("|"):
        output = case.folder(value)
        case.run(output, extra=["--set", f"{entry}={value}"])
        check_finite(output)
        errors.append(look_up(read_summary(output), case.options.error))
        print(f"{entry} = {value}: {case.options.error} = {errors[-1]:.6e}")
    orders = [math.log2(coarse / fine)
              for coarse, fine in zip(errors, errors[1:])]
    print("orders: " + ", ".join(f"{order:.3f}" for order in orders))
    if not orders or not orders[-1] >= case.options.order:
        raise Failed(f"order of {case.options.error} is below "
                     f"{case.options.order}")


def same(case):
    """Runs with each --vary value leave the same tables and checkpoints, to
    the last bit."""
    entry, values = case.options.vary.split("=", 1)
    outputs = []
    for value in values.split("|"):
        outputs.append(case.folder(value))
        case.run(outputs[-1], extra=["--set", f"{entry}={value}"])
        check_finite(outputs[-1])
        for bound in case.options.bound if len(outputs) == 1 else ():
            check_bound(read_summary(outputs[-1]), bound)
    states = [[os.path.relpath(path, output)
               for folder in checkpoints(output)
               for path in sorted(glob.glob(os.path.join(folder, "*.bin")))]
              for output in outputs]
    if not states[0] or any(state != states[0] for state in states):
        raise Failed(f"the runs left other checkpoints: {states}")
    for output in outputs[1:]:
        compare_bytes(outputs[0], output, case.options.compare + states[0])


def check_stopped(output):
    check_bound(read_summary(output), "status == stopped")
    if not checkpoints(output):
        raise Failed("a stopped run left no checkpoint")


def stop(case, output):
    """Runs a few steps, up to a checkpoint."""
    steps = f"Time/Steps in this run={case.options.stop_after}"
    case.run(output, extra=["--set", steps])
    check_stopped(output)


def interrupt(case, output):
    """Starts a run and sends SIGTERM soon after its first output; to mpirun
    SIGUSR1, which leaves its ranks the time that they need."""
    process = case.start(output)
    while process.poll() is None and not (
            glob.glob(os.path.join(output, "fields", "*"))
            or os.path.exists(os.path.join(output, "history.csv"))):
        time.sleep(0.01)
    time.sleep(0.1)
    process.send_signal(
        signal.SIGUSR1 if case.options.ranks > 1 else signal.SIGTERM)
    out, err = process.communicate()
    if process.returncode != 0:
        print(out[-4000:] + err[-4000:])
        raise Failed(f"exit code {process.returncode} after the signal")
    check_stopped(output)


def resume(case):
    """A run stopped after some steps and resumed equals one that went
    straight through, to the last bit in serial."""
    stop_and_go(case, stop)


def sigterm(case):
    """The same with a run that a signal stops."""
    stop_and_go(case, interrupt)


def stop_and_go(case, stop_run):
    straight, stopped = case.folder("straight"), case.folder("stopped")
    case.run(straight)
    stop_run(case, stopped)
    case.run(stopped, extra=["--resume"])
    check_bound(read_summary(stopped), "status == finished")
    if case.options.ranks > 1:
        compare_numbers(case.options.tolerance, straight, stopped,
                        case.options.compare)
        return
    fields = [os.path.relpath(path, straight) for path in
              glob.glob(os.path.join(straight, "fields", "**", "*.vtu"),
                        recursive=True)]
    compare_bytes(straight, stopped, case.options.compare + fields)
    ends = [{key: read_summary(run).get(key)
             for key in ("conservation", "errors")}
            for run in (straight, stopped)]
    if ends[0] != ends[1]:
        raise Failed(f"summaries differ: {ends[0]} and {ends[1]}")


def check(case):
    """The file passes --check, which writes nothing."""
    output = case.folder("run")
    _, out, _ = case.run(output, extra=["--check"])
    if not out.strip():
        raise Failed("--check printed no plan")
    if os.path.exists(output):
        raise Failed(f"--check wrote {os.listdir(output)} into {output}")


def pictures(case):
    """The run draws the named pictures by itself, and they are not empty."""
    output = case.folder("run")
    _, log, _ = case.run(output)
    if f"pictures in {output}/pictures" not in log:
        raise Failed("the run does not say that it has drawn pictures")
    for name in case.options.compare:
        path = os.path.join(output, "pictures", name)
        with open(path, "rb") as file:
            content = file.read()
        if content[:4] != b"\x89PNG" or len(content) < 10000:
            raise Failed(f"{path} is not a picture of any content")


def stem(case):
    """The Mach stem of the run is smooth: bounds of 'deviation', see stem.py.
    """
    output = case.folder("run")
    case.run(output)
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                          "stem.py")
    run = subprocess.run([script, output], capture_output=True, text=True)
    if run.returncode != 0:
        raise Failed(f"stem.py failed: {run.stderr}")
    for bound in case.options.bound:
        check_bound({"deviation": float(run.stdout)}, bound)


def wedge(case):
    """Bounds of the angles of shocks at a wedge of --angle, see wedge.py."""
    output = case.folder("run")
    case.run(output)
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                          "wedge.py")
    run = subprocess.run([script, output, case.options.angle],
                         capture_output=True, text=True)
    print(run.stdout, run.stderr)
    if run.returncode != 0:
        raise Failed(f"wedge.py failed: {run.stderr}")
    for bound in case.options.bound:
        check_bound(json.loads(run.stdout), bound)


def reflection(case):
    """Bounds of 'regular_up_to', the ground range [m] up to which a blast from
    --height is reflected regularly, see triple_point.py."""
    output = case.folder("run")
    case.run(output)
    script = os.path.join(REPOSITORY, "applications", "plot",
                          "triple_point.py")
    run = subprocess.run([script, output, case.options.height],
                         capture_output=True, text=True)
    print(run.stdout, run.stderr)
    found = re.search(r"Regular reflection up to .* ([0-9.]+) m", run.stdout)
    if run.returncode != 0 or not found:
        raise Failed("triple_point.py found no end of regular reflection")
    for bound in case.options.bound:
        check_bound({"regular_up_to": float(found[1])}, bound)


def expect_refusal(case, output, **keywords):
    """The application stops with one line on stderr that has the message."""
    codes = case.options.exit or (1,)
    _, _, err = case.run(output, codes=codes, **keywords)
    lines = [line for line in err.splitlines() if line.strip()]
    print(err)
    if len(lines) != 1:
        raise Failed(f"{len(lines)} lines on stderr instead of one")
    if case.options.message not in lines[0]:
        raise Failed(f"the message lacks '{case.options.message}'")
    return lines[0]


def failure(case):
    """A run that fails leaves its last checkpoint as it was; resumed it fails
    in the same words, and with what mends it goes on to its end."""
    output = case.folder("run")
    words = expect_refusal(case, output)
    if not checkpoints(output):
        raise Failed("the run that failed left no checkpoint")
    last = max(checkpoints(output))
    before = snapshot(last)
    again = expect_refusal(case, output, extra=["--resume"])
    if again != words:
        raise Failed("the resumed run failed in other words")
    if snapshot(last) != before:
        raise Failed(f"{last} is no longer as it was")
    case.run(output, extra=["--resume", *case.options.argument])
    check_bound(read_summary(output), "status == finished")


def refusal(case):
    """Bad input: one line on stderr, the exit code, and nothing written."""
    output = case.options.output or case.folder("run")
    output = output.replace("@FOLDER@", case.options.name)
    if case.options.content is not None:
        # A parameter file made of the shipped one and further lines.
        with open(case.options.file) as shipped:
            text = shipped.read()
        case.options.file = case.folder("case.prm")
        with open(case.options.file, "w") as file:
            file.write(text + "\n" + case.options.content + "\n")
    with open(case.folder("a_file"), "w") as file:
        file.write("in the way\n")
    expect_refusal(case, output, extra=case.options.argument)
    if os.path.exists(output):
        raise Failed(f"{output} was written: {os.listdir(output)}")


def snapshot(folder):
    """Contents of all files below a folder."""
    found = {}
    for here, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(here, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder)] = file.read()
    return found


def damaged_checkpoint(case):
    """A truncated checkpoint is refused in one line, and nothing changes."""
    output = case.folder("run")
    stop(case, output)
    for folder in checkpoints(output):
        largest = max(glob.glob(os.path.join(folder, "*")),
                      key=os.path.getsize)
        os.truncate(largest, os.path.getsize(largest) // 2)
        print(f"truncated {largest}")
    before = snapshot(output)
    expect_refusal(case, output, extra=["--resume"])
    if snapshot(output) != before:
        raise Failed("the refused run changed its output folder")


def foreign_checkpoint(case):
    """A checkpoint of another scene is refused, and nothing changes."""
    output = case.folder("run")
    stop(case, output)
    before = snapshot(output)
    expect_refusal(case, output, extra=["--resume", *case.options.argument],
                   file=case.options.other_file)
    if snapshot(output) != before:
        raise Failed("the refused run changed its output folder")


def disk(case):
    """A disk that fills in the middle of a run: exit code 3, one line, and
    the run goes on from its last checkpoint once there is room."""
    full_disk.enter_namespace()
    straight, output = case.folder("straight"), case.folder("run")
    case.run(straight)
    stop(case, output)
    before = {name: snapshot(name) for name in checkpoints(output)}
    with full_disk.nearly_full(output, max(before)) as (folder, limits):
        expect_refusal(case, folder, extra=["--resume"], preexec_fn=limits)
    if snapshot(max(before)) != before[max(before)]:
        raise Failed(f"{max(before)} is no longer intact")
    case.run(output, extra=["--resume"])
    compare_bytes(straight, output, case.options.compare)


def of_module(kind):
    def judged(case):
        try:
            kind(case, check_bound, read_summary)
        except AssertionError as reason:
            raise Failed(str(reason)) from reason
    return judged


KINDS = {kind.__name__: kind for kind in
         (bounds, regression, ranks, same, convergence, resume, sigterm,
          check, pictures, stem, wedge, reflection, refusal, failure,
          damaged_checkpoint,
          foreign_checkpoint,
          disk)}
KINDS.update({name: of_module(kind)
              for name, kind in {**study_cases.KINDS, **cost_cases.KINDS,
                                 **load_cases.KINDS,
                                 **scene_cases.KINDS,
                                 **main_job_cases.KINDS}.items()})


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("--name", required=True, help="folder of this test")
    parser.add_argument("--application", required=True)
    parser.add_argument("--file", required=True)
    parser.add_argument("--other-file")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--argument", action="append", default=[])
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--mpiexec", default="mpirun")
    parser.add_argument("--exit", type=int, action="append")
    parser.add_argument("--message", default="")
    parser.add_argument("--output")
    parser.add_argument("--content")
    parser.add_argument("--bound", action="append", default=[])
    parser.add_argument("--reference")
    parser.add_argument("--compare", action="append", default=[])
    parser.add_argument("--tolerance", default="-r 1e-10")
    parser.add_argument("--stop-after", type=int, default=5)
    parser.add_argument("--vary")
    parser.add_argument("--error")
    parser.add_argument("--order", type=float)
    parser.add_argument("--height")
    parser.add_argument("--angle")
    options = parser.parse_args(arguments)
    options.compare = options.compare or ["history.csv"]
    return options


def main(arguments):
    options = parse(arguments)
    try:
        KINDS[options.kind](Case(options))
    except Failed as reason:
        print(f"FAILED: {reason}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
