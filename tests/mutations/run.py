#!/usr/bin/env python3
"""Puts small faults into the code, one at a time, and shows which tests catch
them:

  tests/mutations/run.py                 all faults of mutations.toml
  tests/mutations/run.py --only NAME     one of them; repeat for several
  tests/mutations/run.py --from NAME     this one and all after it, to go on
                                         with a run that was interrupted
  tests/mutations/run.py --check         whether the list fits the tree

The faults go into a private copy of the tree with a build folder of its own;
the tree itself is only read. First the tests that the faults name must pass
without any fault. Then, for each fault, the programs of its tests are built
and these tests run. A fault that no test catches "survived": a test is
missing. The results go to results.md beside this file; rows of faults that
were not run stay as they are. Exit code 0: all are caught, 1: some survived or
could not be tried.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
import xml.etree.ElementTree

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
LIST = os.path.join(HERE, "mutations.toml")
RESULTS = os.path.join(HERE, "results.md")

# Is in every copy.
MARK = ".copy_for_mutations"

REQUIRED = {"name", "fault", "file", "old", "new", "tests"}
OPTIONAL = {"targets"}

INTRODUCTION = """\
# Faults that the tests catch

Each row is a fault that was put into the code alone. "Caught by" are the tests
that failed, of those that `mutations.toml` names for it; `survived` means that
none did. Renew all rows, one, or those from one on after an interruption, by

```bash
tests/mutations/run.py
tests/mutations/run.py --only NAME
tests/mutations/run.py --from NAME
```

"""


class Problem(Exception):
    """One line that says what is wrong."""


class Mutation:
    """A fault: in one file, one text in place of another."""

    def __init__(self, entry):
        name = entry.get("name", "?")
        if not REQUIRED <= entry.keys() <= REQUIRED | OPTIONAL:
            raise Problem(f"{name}: must have {', '.join(sorted(REQUIRED))} "
                          f"and may have {', '.join(sorted(OPTIONAL))}")
        self.name, self.fault = name, entry["fault"]
        self.file, self.tests = entry["file"], entry["tests"]
        # Texts of several lines begin with a line of their own.
        self.old = entry["old"].strip("\n")
        self.new = entry["new"].strip("\n")
        self.targets = entry.get("targets", [])

    def problems(self, root):
        """Reasons why it cannot be put into this tree."""
        try:
            with open(os.path.join(root, self.file), encoding="utf-8") as file:
                count = file.read().count(self.old)
        except OSError as error:
            return [f"{self.name}: {self.file}: {error.strerror}"]
        found = []
        if count != 1:
            found.append(f"{self.name}: {self.file} has its old text {count} "
                         "times instead of once")
        if self.old == self.new:
            found.append(f"{self.name}: its new text is its old one")
        return found


def read_list():
    with open(LIST, "rb") as file:
        mutations = [Mutation(entry)
                     for entry in tomllib.load(file)["mutation"]]
    names = [mutation.name for mutation in mutations]
    for name in names:
        if names.count(name) > 1:
            raise Problem(f"{name}: two faults have this name")
    return mutations


def registered_tests(build):
    """The command of each test of a build folder, by name. ctest itself tells
    no commands of programs that are not built."""
    tests = {}
    for folder, _, names in os.walk(build):
        if "CTestTestfile.cmake" not in names:
            continue
        with open(os.path.join(folder, "CTestTestfile.cmake"),
                  encoding="utf-8") as file:
            for name, words in re.findall(
                    r"^add_test\(\[=*\[(.+?)\]=*\] (.*)\)$", file.read(),
                    re.MULTILINE):
                tests[name] = [first or second for first, second in re.findall(
                    r'"((?:[^"\\]|\\.)*)"|(\S+)', words)]
    if not tests:
        raise Problem(f"{build}: no build folder with tests")
    return tests


def matching(tests, expression):
    return sorted(name for name in tests if re.search(expression, name))


def check(mutations, build):
    """Whether the list fits the tree and, with a build folder, its tests."""
    problems = [text for mutation in mutations
                for text in mutation.problems(ROOT)]
    tests = registered_tests(build) if build else None
    for mutation in mutations:
        if tests and not matching(tests, mutation.tests):
            problems.append(f"{mutation.name}: no test is named "
                            f"{mutation.tests}")
    return problems


class Copy:
    """A private copy of the tree, with a build folder in it."""

    def __init__(self, folder, jobs):
        self.folder, self.jobs = os.path.abspath(folder), jobs
        self.build = os.path.join(self.folder, "build")
        if os.path.realpath(self.folder) == os.path.realpath(ROOT):
            raise Problem("--folder must not be the tree itself")
        # Whatever is not in the tree is removed from the copy.
        if (os.path.isdir(self.folder) and os.listdir(self.folder)
                and not os.path.exists(self.path(MARK))):
            raise Problem(f"--folder {folder}: holds files, none of which is "
                          f"{MARK}; name an empty or new folder")
        os.makedirs(self.folder, exist_ok=True)
        with open(self.path(MARK), "w", encoding="utf-8"):
            pass

    def path(self, name):
        return os.path.join(self.folder, name)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def synchronise(self):
        """Makes the copy equal to the tree; what is equal keeps its times, so
        that little is built again. Returns whether it must be configured."""
        configures = not os.path.exists(os.path.join(self.build,
                                                     "build.ninja"))
        listed = subprocess.run(
            ["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others",
             "--exclude-standard"], check=True, capture_output=True)
        names = {os.fsdecode(name) for name in listed.stdout.split(b"\0")
                 if name and os.path.isfile(os.path.join(ROOT,
                                                         os.fsdecode(name)))}
        for here, folders, files in os.walk(self.folder):
            if here == self.folder and "build" in folders:
                folders.remove("build")
            for file in files:
                path = os.path.join(here, file)
                if os.path.relpath(path, self.folder) not in names | {MARK}:
                    os.remove(path)
                    configures |= not file.endswith(".pyc")
        for name in names:
            with open(os.path.join(ROOT, name), "rb") as file:
                content = file.read()
            is_new = not os.path.exists(self.path(name))
            if not is_new and self.read(name) == content:
                continue
            configures |= is_new or name.endswith(("CMakeLists.txt", ".cmake"))
            os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
            with open(self.path(name), "wb") as file:
                file.write(content)
            os.chmod(self.path(name),
                     os.stat(os.path.join(ROOT, name)).st_mode)
        return configures

    def configure(self):
        command(["cmake", "--preset", "release"], self.folder)

    def build_for(self, tests, targets):
        """Builds what the commands of these tests name; None does it all."""
        wanted = set(targets)
        known = {line.partition(":")[0] for line in subprocess.run(
            ["ninja", "-C", self.build, "-t", "targets", "all"], check=True,
            capture_output=True, text=True).stdout.splitlines()}
        for words in tests or []:
            for word in words:
                path = word.rpartition("=")[2]
                if path.startswith(self.build + "/"):
                    wanted.add(os.path.relpath(path, self.build))
        # Some words name folders of tests.
        wanted = {name for name in wanted if name in known or name in targets}
        if tests is not None and not wanted:
            return
        command(["cmake", "--build", self.build, "-j", str(self.jobs)]
                + (["--target", *sorted(wanted)] if tests is not None else []),
                self.folder)

    def run_tests(self, names):
        """How each of these tests ended; of all tests for None."""
        report = os.path.join(self.build, "mutation.xml")
        if os.path.exists(report):
            os.remove(report)
        words = ["ctest", "--test-dir", self.build, "-j", str(self.jobs),
                 "--output-junit", report]
        if names is not None:
            words += ["-R", "^(" + "|".join(map(re.escape, names)) + ")$"]
        run = subprocess.run(words, check=False, text=True,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)
        if not os.path.exists(report):
            raise Problem("ctest left no report")
        found = {case.get("name"): case.get("status")
                 for case in xml.etree.ElementTree.parse(report).iter(
                     "testcase")}
        for name in re.findall(r"Test +#\d+: (\S+) [ .]*\*\*\*Timeout",
                               run.stdout):
            found[name] = "late"
        return found

    def built(self):
        """Files that ninja has built, and at last its own records of that."""
        with open(os.path.join(self.build, ".ninja_log"),
                  encoding="utf-8") as file:
            names = {line.split("\t")[3] for line in file if "\t" in line}
        for name in sorted(names) + [".ninja_deps", ".ninja_log"]:
            path = os.path.join(self.build, name)
            if os.path.isfile(path) and not os.path.islink(path):
                yield path

    def saved(self, path):
        return os.path.join(self.build, "without_fault",
                            os.path.relpath(path, self.build))

    def save(self):
        """Keeps what is built without a fault."""
        for path in self.built():
            copy_changed(path, self.saved(path))

    def restore(self):
        """Puts back what a fault has changed; ninja builds nothing again whose
        times are those of its records."""
        for path in self.built():
            if os.path.exists(self.saved(path)):
                copy_changed(self.saved(path), path)
            else:
                os.remove(path)


def copy_changed(source, target):
    """Copies a file with its time, unless the target has that time."""
    if (os.path.exists(target)
            and os.stat(target).st_mtime_ns == os.stat(source).st_mtime_ns):
        return
    os.makedirs(os.path.dirname(target), exist_ok=True)
    shutil.copy2(source, target)



def command(words, folder):
    """Runs a command of the build."""
    run = subprocess.run(words, cwd=folder, check=False, text=True,
                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT)
    if run.returncode != 0:
        raise Problem(" ".join(words[:3]) + " failed:\n" + run.stdout[-3000:])


class Trial:
    """Tries faults in a copy."""

    def __init__(self, copy, all_tests):
        self.copy, self.all_tests = copy, all_tests
        self.tests = registered_tests(copy.build)

    def names(self, mutation):
        return None if self.all_tests else matching(self.tests, mutation.tests)

    def run(self, names, targets):
        """Tests that did not pass."""
        self.copy.build_for(
            None if names is None else [self.tests[name] for name in names],
            targets)
        found = self.copy.run_tests(names)
        failed = sorted(name for name, status in found.items()
                        if status == "fail")
        # On a busy machine a test that ran into its limit proves nothing.
        idle = sorted(name for name in names or found
                      if found.get(name) not in ("run", "fail", "disabled"))
        if idle and not failed:
            raise Problem("without an end, or not run: " + ", ".join(idle))
        return failed

    def check_without_faults(self, mutations):
        """The tests must pass as long as nothing is wrong."""
        if self.all_tests:
            names, targets = None, []
        else:
            names = sorted({name for mutation in mutations
                            for name in self.names(mutation)})
            targets = sorted({target for mutation in mutations
                              for target in mutation.targets})
        count = len(self.tests if names is None else names)
        print(f"without a fault: {count} tests", flush=True)
        failed = self.run(names, targets)
        if failed:
            raise Problem("these tests fail without any fault: "
                          + ", ".join(failed))
        self.copy.save()

    def try_out(self, mutation):
        """Tests that caught a fault, none if it survived."""
        path = self.copy.path(mutation.file)
        with open(path, encoding="utf-8") as file:
            before = file.read()
        times = os.stat(path)
        try:
            with open(path, "w", encoding="utf-8") as file:
                file.write(before.replace(mutation.old, mutation.new))
            return self.run(self.names(mutation), mutation.targets)
        finally:
            with open(path, "w", encoding="utf-8") as file:
                file.write(before)
            os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
            self.copy.restore()


def read_results():
    """Rows of the present table by name of the fault."""
    rows = {}
    if os.path.exists(RESULTS):
        with open(RESULTS, encoding="utf-8") as file:
            for line in file:
                match = re.match(r"\| `(\w+)` \|", line)
                if match:
                    rows[match[1]] = line
    return rows


def write_results(mutations, rows):
    """The table, with a row for each fault of the list, in its order."""
    with open(RESULTS, "w", encoding="utf-8") as file:
        file.write(INTRODUCTION)
        file.write("| name | fault | file | caught by |\n"
                   "|---|---|---|---|\n")
        file.writelines(kept_row(mutation, rows)
                        or row_of(mutation, "not tried yet")
                        for mutation in mutations)


def kept_row(mutation, rows):
    """The row of an earlier trial, unless the fault was another one then."""
    row = rows.get(mutation.name, "")
    is_same = f"| {mutation.fault} | `{mutation.file}` |" in row
    return row if is_same else ""


def row_of(mutation, outcome):
    return (f"| `{mutation.name}` | {mutation.fault} | `{mutation.file}` | "
            f"{outcome} |\n")


def told(failed):
    """Names of the first tests that caught a fault, and how many more."""
    shown = ", ".join(f"`{name}`" for name in failed[:4])
    more = f" and {len(failed) - 4} more" if len(failed) > 4 else ""
    return shown + more if failed else "**survived**"


def try_all(mutations, chosen, copy, all_tests):
    """Number of faults that were not caught."""
    if copy.synchronise():
        copy.configure()
    problems = check(chosen, copy.build)
    if problems:
        raise Problem("; ".join(problems))
    trial = Trial(copy, all_tests)
    trial.check_without_faults(chosen)
    not_caught = 0
    for mutation in chosen:
        begin = time.monotonic()
        try:
            failed = trial.try_out(mutation)
            outcome = told(failed)
        except Problem as problem:
            print(f"{mutation.name}: {problem}", file=sys.stderr)
            failed, outcome = [], f"**not tried: {str(problem).splitlines()[0]}**"
        seconds = time.monotonic() - begin
        not_caught += 0 if failed else 1
        print(f"{mutation.name}: {outcome} ({seconds:.0f} s)", flush=True)
        rows = read_results()
        rows[mutation.name] = row_of(mutation, outcome)
        write_results(mutations, rows)
    return not_caught


def choose(mutations, only, first):
    """Those of these names, or the first one and all after it."""
    names = [mutation.name for mutation in mutations]
    for name in [*only, first or names[0]]:
        if name not in names:
            raise Problem(f"{name}: no fault has this name; --list shows all")
    if only:
        return [mutations[names.index(name)] for name in only]
    return mutations[names.index(first) if first else 0:]


def parse(arguments):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--only", action="append", default=[], metavar="NAME",
                       help="try this fault alone; may be repeated")
    which.add_argument("--from", dest="first", metavar="NAME",
                       help="go on with this fault: leave out those before it")
    parser.add_argument("--list", action="store_true",
                        help="show the faults and end")
    parser.add_argument("--check", action="store_true",
                        help="check that each fault fits the tree and end")
    parser.add_argument("--build", metavar="FOLDER",
                        help="with --check: a build folder, whose tests the "
                             "faults must name")
    parser.add_argument("--all-tests", action="store_true",
                        help="run the whole suite for each fault, for hours")
    parser.add_argument("--folder", metavar="FOLDER",
                        help="keep copy and build here for the next time; "
                             "what else is in the folder is removed")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count(),
                        help="processors to use")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    try:
        mutations = read_list()
        chosen = choose(mutations, options.only, options.first)
        if options.list:
            for mutation in chosen:
                print(f"{mutation.name}: {mutation.fault}\n  {mutation.file}, "
                      f"{mutation.tests}")
            return 0
        problems = check(mutations, options.build)
        for problem in problems:
            print(problem)
        if options.check or problems:
            print(f"{len(mutations)} faults, {len(problems)} problem(s)")
            return 1 if problems else 0
        with tempfile.TemporaryDirectory() as temporary:
            copy = Copy(options.folder or os.path.join(temporary, "copy"),
                        options.jobs)
            os.makedirs(copy.folder, exist_ok=True)
            return 1 if try_all(mutations, chosen, copy,
                                options.all_tests) else 0
    except Problem as problem:
        print(f"error: {problem}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
