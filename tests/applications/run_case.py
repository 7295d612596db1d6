#!/usr/bin/env python3
"""Runs an application on a shipped parameter file and judges what it leaves.

run_case.py KIND[,KIND...] --application PROGRAM --file FILE.prm [options]; the
kinds are the functions in KINDS below, and the first line of each says what it
proves. Several kinds share the runs that they have in common. Exit code 0:
proven; 1: not, with the reason on stdout; 77: cannot run here.
"""

import argparse
import glob
import json
import math
import os
import re
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "cases"))

import cost_cases
import field_cases
import folder_cases
import full_disk
import load_cases
import machine_cases
import main_job_cases
import number_cases
import picture_cases
import resume_cases
import samples
import scene_cases
import study_cases
from case import (Case, Failed, Skipped, check_bound, check_finite,
                  checkpoints, compare_arrays, compare_bytes, compare_numbers,
                  expand, look_up, read_bytes, read_json, read_summary,
                  require, snapshot)
from summaries import flaw_of


REPOSITORY = os.path.dirname(os.path.dirname(HERE))
# Values in a table that regressions keep as it is.
LARGEST_TABLE = 5000
SAMPLES = ".samples.csv"
# Their summaries are those of tools, not of runs in time.
NO_SCHEMA = ("anatomy", "study")


def schema(case):
    """Each summary.json of blast, biomechanics and head_impact, and each
    scene.json, of the run is as its schema says."""
    found = 0
    for here, _, names in os.walk(case.straight()):
        for name in {"summary.json", "scene.json"} & set(names):
            path = os.path.join(here, name)
            if read_json(path).get("application") in NO_SCHEMA:
                continue
            flaw = flaw_of(path)
            if flaw:
                raise Failed(f"{path}: {flaw}")
            found += 1
    if not found:
        raise Failed("the run left nothing that has a schema")


def bounds(case):
    """The run ends with one of the exit codes, and its summary keeps all
    bounds; "history.x" is the last value of column x of history.csv, "probes.x"
    of probes.csv."""
    if not case.options.exit and not case.options.message:
        output = case.straight()
    else:
        output = case.folder("run")
        code, out, err = case.run(output, case.options.argument,
                                  codes=case.options.exit or (0,))
        told = out if code == 0 else err
        if case.options.message not in told:
            raise Failed(f"nothing says '{case.options.message}': {told}")
        check_finite(output)
    summary = read_summary(output)
    for table in ("history", "probes"):
        if any(bound.startswith(table + ".") for bound in case.options.bound):
            columns = samples.read(os.path.join(output, table + ".csv"))
            summary[table] = {name.split(" [")[0]: float(values[-1])
                              for name, values in columns.items()}
    for bound in case.options.bound:
        check_bound(summary, bound)


def reference_of(case, output, name):
    """Where the numbers of a file are kept: a table as it is, of long ones and
    of other files some samples."""
    here = os.path.join(case.options.reference, name.replace("/", "_"))
    if name.endswith(".csv"):
        with open(os.path.join(output, name), encoding="utf-8") as file:
            if sum(line.count(",") + 1 for line in file) <= LARGEST_TABLE:
                return here
    return here + SAMPLES


def update_references(case, output):
    shutil.rmtree(case.options.reference, ignore_errors=True)
    os.makedirs(case.options.reference)
    for name in expand(output, case.options.compare):
        path, reference = (os.path.join(output, name),
                           reference_of(case, output, name))
        if not reference.endswith(SAMPLES):
            shutil.copy(path, reference)
            continue
        with open(reference, "w", encoding="utf-8") as file:
            file.write(samples.summarise(samples.read(path)))


def regression(case):
    """The tables of the run, and samples of its other files, agree with the
    committed ones."""
    output = case.straight()
    if os.environ.get("CONTRECOUP_UPDATE_REFERENCES") == "1":
        update_references(case, output)
    names = expand(output, case.options.compare)
    references = [reference_of(case, output, name) for name in names]
    if set(map(os.path.basename, references)) != \
            set(os.listdir(case.options.reference)):
        raise Failed(f"the references are of other files than {names}")
    for name, reference in zip(names, references):
        path = os.path.join(output, name)
        if not reference.endswith(SAMPLES):
            compare_arrays(name, case.options.tolerance,
                           samples.read(reference), samples.read(path), output)
            continue
        with open(reference, encoding="utf-8") as file:
            worst, reasons = samples.compare_summaries(
                case.options.tolerance, name, file.read(),
                samples.summarise(samples.read(path)))
        print(f"{name}: {worst:.3g} of the tolerance")
        if reasons:
            raise Failed(f"{name} differs in {output}: {reasons[0]}")


def ranks(case):
    """One rank and others give the same numbers."""
    serial = case.straight(1)
    for count in case.options.ranks:
        compare_numbers(case.options.tolerance, serial, case.straight(count),
                        case.options.compare)


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
    the last bit but for the number of computed updates."""
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
        compare_bytes(outputs[0], output,
                      expand(output, case.options.compare))
        for state in states[0]:
            require_same_state(read_bytes(outputs[0], state),
                               read_bytes(output, state), state)


def require_same_state(first, second, name):
    """Two checkpoints differ at most in the number of computed updates, which in
    the second one is that of possible updates, the number after it."""
    apart = [i for i, (one, two) in enumerate(zip(first, second)) if one != two]
    for begin in range(apart[0] - 7, apart[0] + 1) if apart else ():
        if apart[-1] < begin + 8 and \
                second[begin:begin + 8] == second[begin + 8:begin + 16]:
            apart = []
            break
    require(len(first) == len(second) and not apart,
            f"{name} is not the same to the last bit: {len(apart)} bytes differ")


def check_files(case):
    """Every parameter file below the folder of --file passes --check, which one
    process does for all of them: it prints a plan of each, sets no entry without
    effect, and writes nothing."""
    folder = os.path.dirname(os.path.abspath(case.options.file))
    files = sorted(glob.glob(os.path.join(folder, "**", "*.prm"),
                             recursive=True))
    left_out = {os.path.join(folder, entry.split("=", 1)[0])
                for entry in case.options.needs
                if not os.path.exists(entry.split("=", 1)[1])}
    checked = [file for file in files if file not in left_out]
    wrong = [os.path.relpath(file, folder) for file in check(case, checked)]
    print(f"{len(files)} files, {len(wrong)} refused, {len(left_out)} not "
          "checked for want of what they need")
    if wrong or not files:
        raise Failed(f"{len(wrong)} of {len(files)} files: {', '.join(wrong)}")
    if left_out:
        raise Skipped(f"there is nothing to check {sorted(left_out)} with")


def check(case, files):
    """Those files that --check refuses."""
    here = case.folder("here")
    os.makedirs(here)
    process = case.start("run", extra=["--check", *files[1:]], file=files[0],
                         cwd=here)
    out, err = process.communicate()
    if os.listdir(here):
        raise Failed(f"--check wrote {os.listdir(here)}")
    lines = [line for line in err.splitlines() if line.strip()]
    refused = [file for file in files
               if any(tells_of(line, file) for line in lines)]
    others = [line for line in lines
              if not any(tells_of(line, file) for file in refused)]
    if others or process.returncode != (1 if refused else 0):
        raise Failed(f"exit code {process.returncode}, stderr: {err[-2000:]}")
    print(err)
    for file in files:
        plan = out if len(files) == 1 else report_of(file, files, out)
        if file not in refused and not re.search(
                r" would (.|\n)* on \d+ ranks?\b", plan):
            raise Failed(f"--check printed no plan of {file}, or not for how "
                         f"many ranks: {plan[-2000:]}")
        # Sizes that a file chooses for itself are no reason for a warning.
        coarse = [line for line in plan.splitlines()
                  if line.startswith("WARNING: ") and (
                      "thinner than the elements" in line
                      or "see Scene/Cell size" in line)]
        if coarse:
            raise Failed(f"{file} warns of its own sizes: {coarse}")
        # Files for loads that another run records get them on the command line,
        # presets have entries for the choices of those that include them.
        unused = [line for line in plan.splitlines() if "set but not used" in line
                  and "Loads/Recorded/File is empty" not in line
                  and os.path.basename(os.path.dirname(file)) != "presets"]
        if unused:
            raise Failed(f"{file}: {unused}")
    return refused


def tells_of(line, file):
    """Whether a line of stderr refuses a file."""
    return line.startswith("error: ") and re.search(
        re.escape(file) + "[\":]", line)


def report_of(file, files, out):
    """Text between the line with this file's name and the next one's."""
    headings = {name + ":" for name in files}
    lines = out.splitlines()
    if lines.count(file + ":") != 1:
        raise Failed(f"{lines.count(file + ':')} reports are of {file}")
    rest = lines[lines.index(file + ":") + 1:]
    end = next((number for number, line in enumerate(rest)
                if line in headings), len(rest))
    return "\n".join(rest[:end])


def stem(case):
    """The Mach stem of the run is smooth: bounds of 'deviation', see stem.py.
    """
    output = case.straight()
    script = os.path.join(HERE, "cases", "stem.py")
    run = subprocess.run([script, output], capture_output=True, text=True)
    if run.returncode != 0:
        raise Failed(f"stem.py failed: {run.stderr}")
    for bound in case.options.bound:
        check_bound({"deviation": float(run.stdout)}, bound)


def wedge(case):
    """Bounds of the angles of shocks at a wedge of --angle, see wedge.py."""
    output = case.straight()
    script = os.path.join(HERE, "cases", "wedge.py")
    run = subprocess.run([script, output, case.options.angle],
                         capture_output=True, text=True)
    print(run.stdout, run.stderr)
    if run.returncode != 0:
        raise Failed(f"wedge.py failed: {run.stderr}")
    for bound in case.options.bound:
        check_bound(json.loads(run.stdout), bound)


def reflection(case):
    """Bounds of 'regular_up_to', the ground range [m] up to which a blast from
    --height is reflected regularly, see plot.py triple_point."""
    output = case.straight()
    program = os.path.join(REPOSITORY, "applications", "plot", "plot.py")
    run = subprocess.run(
        [program, "triple_point", output, case.options.height],
        capture_output=True, text=True)
    print(run.stdout, run.stderr)
    found = re.search(r"Regular reflection up to .* ([0-9.]+) m", run.stdout)
    if run.returncode != 0 or not found:
        raise Failed("plot.py triple_point found no end of regular reflection")
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
    in the same words, and with what mends it continues to its end."""
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
    if os.path.basename(case.options.application) == "scene" \
            and not case.options.argument:
        _, out, err = case.run(output, extra=["--estimate"], codes=(0, 1))
        if out and err:
            raise Failed(f"--estimate answers before it refuses: {out}")


def refusals(case):
    """All refusals of an application, which the JSON file of --argument lists as
    words of run_case.py; CONTRECOUP_ONLY in the environment is part of the names
    of those to try."""
    chosen = os.environ.get("CONTRECOUP_ONLY", "")
    with open(case.options.argument[0], encoding="utf-8") as file:
        tried = [options for words in json.load(file)
                 for options in [parse(["refusal", *words])]
                 if chosen in options.name]
    failed = []
    for options in tried:
        name, options.name = options.name, case.folder(options.name)
        print(f"---- {name}", flush=True)
        if prove(Case(options), "refusal") != 0:
            failed.append(name)
    print(f"---- {len(tried)} refusals, {len(failed)} failed")
    if failed or not tried:
        raise Failed(", ".join(failed) or f"no name has '{chosen}'")


def damaged_checkpoint(case):
    """A truncated checkpoint is refused in one line, and nothing changes."""
    output = case.folder("run")
    resume_cases.stop(case, output, case.options.stop_after[0])
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
    resume_cases.stop(case, output, case.options.stop_after[0])
    before = snapshot(output)
    expect_refusal(case, output, extra=["--resume", *case.options.argument],
                   file=case.options.other_file)
    if snapshot(output) != before:
        raise Failed("the refused run changed its output folder")


KINDS = {kind.__name__: kind for kind in
         (schema, bounds, regression, ranks, same, convergence, check_files, stem,
          wedge, reflection, refusal, refusals, failure, damaged_checkpoint,
          foreign_checkpoint)}
for module in (resume_cases, machine_cases, picture_cases, field_cases,
               study_cases, cost_cases, load_cases, folder_cases, scene_cases,
               main_job_cases, number_cases):
    KINDS.update(module.KINDS)


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kinds", type=lambda text: text.split(","))
    parser.add_argument("--name", required=True, help="folder of this test")
    parser.add_argument("--application", required=True)
    parser.add_argument("--file", required=True)
    parser.add_argument("--other-file")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--argument", action="append", default=[])
    parser.add_argument("--mpi", type=int, default=1)
    parser.add_argument("--ranks", type=int, action="append")
    parser.add_argument("--needs", action="append", default=[])
    parser.add_argument("--mpiexec", default="mpirun")
    parser.add_argument("--exit", type=int, action="append")
    parser.add_argument("--message", default="")
    parser.add_argument("--output")
    parser.add_argument("--content")
    parser.add_argument("--bound", action="append", default=[])
    parser.add_argument("--reference")
    parser.add_argument("--compare", action="append", default=[])
    parser.add_argument("--tolerance", action="append", default=[])
    parser.add_argument("--stop-after", type=int, action="append")
    parser.add_argument("--vary")
    parser.add_argument("--error")
    parser.add_argument("--order", type=float)
    parser.add_argument("--height")
    parser.add_argument("--angle")
    options = parser.parse_args(arguments)
    options.compare = options.compare or ["history.csv"]
    options.tolerance = options.tolerance or ["1e-10"]
    options.ranks = options.ranks or [2]
    options.stop_after = options.stop_after or [5]
    for kind in options.kinds:
        if kind not in KINDS:
            parser.error(f"unknown kind '{kind}'; there are "
                         + ", ".join(sorted(KINDS)))
    return options


def prove(case, kind):
    """Runs one kind; returns 0, 1 or 77."""
    try:
        KINDS[kind](case)
    except AssertionError as reason:
        print(f"FAILED: {kind}: {reason}", flush=True)
        return 1
    except (OSError, KeyError, ValueError) as reason:
        # A file that a run should have left is missing or damaged.
        print(f"FAILED: {kind}: {type(reason).__name__}: {reason}", flush=True)
        return 1
    except Skipped as reason:
        # Where a change is judged nothing may be left out unseen.
        print(f"SKIPPED: {kind}: {reason}", flush=True)
        return 1 if os.environ.get("CI") else 77
    return 0


def main(arguments):
    options = parse(arguments)
    missing = [path for path in options.needs
               if "=" not in path and not os.path.exists(path)]
    if missing:
        print(f"SKIPPED: there is no {', '.join(missing)}")
        return 1 if os.environ.get("CI") else 77
    if any(kind in machine_cases.ON_A_DISK for kind in options.kinds):
        full_disk.enter_namespace()
    case = Case(options)
    codes = [prove(case, kind) for kind in options.kinds]
    return 1 if 1 in codes else max(codes)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
