#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Runs tests/run, applications/quickstart and applications/package with stand-ins for
the programs that they call, and shows that builds, tests and ranks get every core."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
SCRIPTS = ("tests/run", "applications/quickstart", "applications/package",
           "applications/common.sh", "source/cmake/debian_packages.txt")
CORES = 3


class ScriptsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        for name in SCRIPTS:
            path = os.path.join(self.root, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            shutil.copy(os.path.join(ROOT, name), path)
        os.mkdir(os.path.join(self.root, "bin"))
        self.calls = os.path.join(self.root, "calls.txt")
        # coreutils' nproc heeds these two variables, too.
        self.write("nproc", 'echo "${OMP_NUM_THREADS:-${OMP_THREAD_LIMIT:-'
                   f'{CORES}}}}}"')
        self.write("dpkg-query", "printf installed")
        self.write("awk", "echo 1000")  # 6 GB of memory for each core
        for name in ("cmake", "cpack", "ctest", "apt-get", "sudo"):
            self.record(name)
        self.record("mpirun", f'while [ "$1" != --output ]; do shift; done; '
                    'mkdir -p "$2"; echo x >"$2/report.html"')

    def write(self, name, text):
        path = os.path.join(self.root, "bin", name)
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + text + "\n")
        os.chmod(path, 0o755)

    def record(self, name, more=""):
        """A stand-in that notes how it was called, and with how many threads."""
        self.write(name, f'echo "{name} $*, threads: $OMP_NUM_THREADS" '
                   f'>>"{self.calls}"\n{more}')

    def run_script(self, script, *arguments, expected=0, **variables):
        """The lines of what a script called, and what it wrote; it ends with the
        exit code @p expected."""
        path = os.path.join(self.root, "bin") + ":" + os.environ["PATH"]
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith("OMP_")}
        run = subprocess.run(
            [os.path.join(self.root, script), *arguments],
            cwd=self.root, env={**environment, "PATH": path, **variables},
            capture_output=True, text=True)
        self.assertEqual(run.returncode, expected, run.stdout + run.stderr)
        with open(self.calls, encoding="utf-8") as file:
            return file.read().splitlines(), run.stdout

    def call_of(self, program, calls):
        found = [line for line in calls if line.startswith(program + " ")]
        self.assertTrue(found, calls)
        return found[-1]

    def check_tests(self, **variables):
        calls, output = self.run_script("tests/run", "-R", "gas", **variables)
        self.assertRegex(self.call_of("cmake", calls), f"-j {CORES} .*all")
        tests = self.call_of("ctest", calls)
        self.assertRegex(tests, f"-j {CORES + 1} .*-R gas")
        self.assertTrue(tests.endswith("threads: 1"), tests)
        self.assertIn(f"running the tests on {CORES} core(s)", output)

    def test_tests_run_on_every_core(self):
        self.check_tests()

    def test_faults_of_the_tree_are_told_before_anything_is_compiled(self):
        self.record("ctest", "exit 8")
        calls, output = self.run_script("tests/run", expected=8)
        self.assertIn("^checks_", self.call_of("ctest", calls))
        self.assertFalse([call for call in calls if " --build " in call], calls)
        self.assertNotIn("building", output)

    def test_threads_of_the_caller_are_no_limit(self):
        self.check_tests(OMP_NUM_THREADS="1")
        self.check_tests(OMP_THREAD_LIMIT="1")

    def test_quickstart_has_a_rank_for_every_core(self):
        for variables in ({}, {"OMP_NUM_THREADS": "1"}):
            calls, _ = self.run_script("applications/quickstart", **variables)
            self.assertRegex(self.call_of("cmake", calls),
                             f"-j {CORES} .*scene")
            self.assertRegex(self.call_of("mpirun", calls), f"-np {CORES} ")

    def test_package_builds_for_each_processor_and_packs_then(self):
        calls, _ = self.run_script("applications/package")
        for processor in ("x86-64", "x86-64-v3", "x86-64-v4"):
            (build,) = [call for call in calls if
                        f"--build build-package/{processor} " in call]
            self.assertIn(f" -j {CORES} ", build)
            # The manual is what the programs print, which run on any machine.
            self.assertEqual(" all," in build, processor == "x86-64", build)
        self.assertTrue(calls[-1].startswith(
            "cpack --config x86-64/CPackConfig.cmake"), calls)

    def test_nothing_is_packed_that_was_not_built(self):
        self.record("cmake", 'case "$*" in *--build*v3*) exit 1;; esac')
        calls, _ = self.run_script("applications/package", expected=1)
        self.assertFalse([call for call in calls if call.startswith("cpack")])

    def test_nproc_is_asked_in_one_place(self):
        for name in SCRIPTS[:4]:
            with open(os.path.join(ROOT, name), encoding="utf-8") as file:
                asked = re.findall(r"^[^#\n]*\bnproc\b.*$", file.read(), re.M)
            self.assertEqual(len(asked), name.endswith("common.sh"), asked)


if __name__ == "__main__":
    unittest.main()
