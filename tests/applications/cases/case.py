"""One test of run_case.py: its runs, what they left, and why it fails."""

import csv
import glob
import json
import math
import os
import re
import shutil
import subprocess

import samples


class Failed(AssertionError):
    """The claim that was to be proven does not hold."""


class Skipped(Exception):
    """The test cannot run here."""


def require(holds, reason):
    if not holds:
        raise Failed(reason)


class Case:
    """One parameter file with overrides, run in folders below the working
    directory."""

    def __init__(self, options):
        self.options = options
        self.straight_runs = {}
        self.logs = {}  # what straight runs printed
        shutil.rmtree(options.name, ignore_errors=True)
        os.makedirs(options.name)

    def folder(self, name):
        return os.path.join(self.options.name, name)

    def command(self, output, extra=(), ranks=None, file=None, program=None,
                verbose=True):
        """Command line with the last of several overrides of an entry."""
        ranks = ranks or self.options.mpi
        command = []
        if ranks > 1:
            command = [self.options.mpiexec, "-np", str(ranks)]
        command += [program or self.options.application,
                    file or self.options.file]
        words = list(extra)
        # CMake takes a semicolon for the end of an argument.
        overrides = [text.replace("@SEMICOLON@", ";")
                     for text in self.options.set]
        while "--set" in words:
            at = words.index("--set")
            overrides.append(words[at + 1])
            del words[at:at + 2]
        last = {override.split("=", 1)[0]: override for override in overrides}
        for override in last.values():
            command += ["--set", override]
        if output is not None:
            command += ["--output", output]
        if verbose:
            command.append("--verbose")
        return command + words

    def start(self, *arguments, preexec_fn=None, cwd=None, **keywords):
        command = self.command(*arguments, **keywords)
        print("+ " + " ".join(command), flush=True)
        return subprocess.Popen(command, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True,
                                preexec_fn=preexec_fn, cwd=cwd)

    def run(self, *arguments, codes=(0,), **keywords):
        """Runs to the end; returns exit code, stdout and stderr."""
        process = self.start(*arguments, **keywords)
        out, err = process.communicate()
        if process.returncode not in codes:
            print(out[-4000:] + err[-4000:])
            raise Failed(f"exit code {process.returncode}, expected "
                         + " or ".join(map(str, codes)))
        return process.returncode, out, err

    def straight(self, ranks=None, extra=()):
        """The folder of a run from the beginning to the end on so many ranks;
        all that is proven in one test shares it."""
        ranks = ranks or self.options.mpi
        key = (ranks, *extra)
        if key not in self.straight_runs:
            output = self.folder(f"straight_{len(self.straight_runs) + 1}")
            _, log, _ = self.run(output, ranks=ranks, extra=extra)
            self.logs[output] = log
            check_finite(output)
            self.straight_runs[key] = output
        return self.straight_runs[key]


def overrides(settings):
    """Words of a command that set "Section/Entry=value" each."""
    return [word for setting in settings for word in ("--set", setting)]


def read_bytes(*names):
    with open(os.path.join(*names), "rb") as file:
        return file.read()


def read_text(*names):
    return read_bytes(*names).decode()


def read_json(*names):
    return json.loads(read_bytes(*names))


def read_summary(output):
    return read_json(output, "summary.json")


def read_rows(*names):
    """Rows of a table by the names of its columns, without its remarks."""
    return list(csv.DictReader(
        line for line in read_text(*names).splitlines()
        if not line.startswith("#")))


def read_columns(*names):
    """Numbers of a table by the names of its columns, which lose their
    units."""
    rows = read_rows(*names)
    return {name.split(" [")[0]: [float(row[name]) for row in rows]
            for name in rows[0]}


def look_up(summary, key):
    """The entry of @p summary that a dotted key names; those of lists have
    numbers."""
    value = summary
    for part in key.split("."):
        if isinstance(value, list):
            value = dict(zip(map(str, range(len(value))), value))
        if not isinstance(value, dict) or part not in value:
            raise Failed(f"summary.json has no '{key}'; at '{part}' there are:"
                         f" {', '.join(value) if value else 'none'}")
        value = value[part]
    # A result or check is an object with a value and its unit.
    if isinstance(value, dict) and set(value) == {"value", "unit"}:
        return value["value"]
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


def results(output):
    """The tables, planes, skins and load files of a run, without its
    checkpoints."""
    found = []
    for here, folders, names in os.walk(output):
        folders[:] = [name for name in folders if name != "checkpoint"]
        found += [os.path.join(here, name) for name in names
                  if name.endswith((".csv", ".vti", ".vtp", ".h5"))]
    return sorted(found)


def check_finite(output):
    """No table, plane or load file of the run holds a number that is not one;
    in a plane, "no number" may stand for what is in a body or has not
    arrived, as on the skin."""
    for path in results(output):
        if path.endswith(".csv"):
            check_table(path)
            continue
        for name, values in samples.read(path).items():
            # Nothing is known where no blast has arrived.
            of_skin = name in ("peak", "impulse", "arrival", "duration")
            reason = samples.flaw(
                values, may_miss=of_skin or path.endswith((".vti", ".vtu")))
            may_lack_all = of_skin or "gauges_" in path or "_maps" in path
            if reason and not (may_lack_all and "no numbers" in reason):
                raise Failed(f"{path}: {name} {reason}")


def check_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    if len(rows) < 2:
        raise Failed(f"{path} has no rows")
    for number, row in enumerate(rows[1:], 2):
        columns = len(rows[0])
        if rows[0][1:] == ["n_masters", "masters and weights"]:
            columns = 2 + 2 * int(row[1])
        if len(row) != columns:
            raise Failed(f"{path}:{number}: {len(row)} values in {columns} "
                         "columns")
        for value in row:
            try:
                finite = math.isfinite(float(value))
            except ValueError:
                finite = True
            if not finite and not (value == "nan" and re.search(
                    "gauges_line|gauge_measures", path)):
                raise Failed(f"{path}:{number}: {','.join(row)}")


def checkpoints(output):
    """The numbered checkpoint folders, oldest first."""
    return sorted(path for path in
                  glob.glob(os.path.join(output, "checkpoint", "*"))
                  if os.path.isdir(path))


def snapshot(folder):
    """Contents of all files below a folder."""
    return {os.path.relpath(os.path.join(here, name), folder):
            read_bytes(here, name)
            for here, _, names in os.walk(folder) for name in names}


def compare_bytes(first, second, names):
    """The files are the same to the last bit; HDF5 files, which note when they
    were made, hold the same numbers."""
    for name in names:
        one, two = (os.path.join(run, name) for run in (first, second))
        if name.endswith(".h5"):
            same = samples.are_equal(samples.read(one), samples.read(two))
        else:
            same = read_bytes(one) == read_bytes(two)
        if not same:
            raise Failed(f"{name} is not the same to the last bit in {first} "
                         f"and {second}")


def expand(output, patterns):
    """The files of a run that names with * and ? stand for."""
    found = []
    for pattern in patterns:
        paths = sorted(glob.glob(os.path.join(output, pattern)))
        if not paths:
            raise Failed(f"{output} has no {pattern}")
        found += [os.path.relpath(path, output) for path in paths]
    return found


def compare_numbers(tolerances, first, second, patterns):
    """The files of two runs agree, see samples.py for the tolerances."""
    names = expand(first, patterns)
    if names != expand(second, patterns):
        raise Failed(f"{first} has other files than {second}")
    for name in names:
        one, two = (samples.read(os.path.join(run, name))
                    for run in (first, second))
        compare_arrays(name, tolerances, one, two, second)


def compare_arrays(name, tolerances, one, two, second):
    """Says how near two files are, and where they are not near enough."""
    worst, reasons = samples.compare(tolerances, name, one, two)
    print(f"{name}: {worst:.3g} of the tolerance", flush=True)
    if reasons:
        print("\n".join(reasons[:20]))
        raise Failed(f"{name} differs in {second}: {reasons[0]}")
