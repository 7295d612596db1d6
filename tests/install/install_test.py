#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Installed programs find what they need wherever they are started, and other
programs are built with the installed library: install_test.py CMAKE BUILD.
The prefix is moved after the installation and is read-only."""

import glob
import os
import re
import shutil
import sys
import tempfile
import unittest

from command import run

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
CMAKE, BUILD = sys.argv.pop(1), os.path.abspath(sys.argv.pop(1))
# 1 m from 0.8535 kg of TNT, by Kingery and Bulmash (1984): peak overpressure [Pa]
# at its arrival [s], impulse of the positive phase [Pa s].
PEAK, ARRIVAL, IMPULSE = 831e3, 0.557e-3, 159.
FILES = "share/contrecoup/parameter_files/blast/verification"


def listing(folder):
    """Paths of all files below a folder with size and time of change."""
    return sorted((path, os.stat(path).st_size, os.stat(path).st_mtime_ns)
                  for here, _, names in os.walk(folder)
                  for path in (os.path.join(here, name) for name in names))


class InstallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        home = os.path.join(BUILD, "tests", "install", "tree")
        if os.path.exists(home):
            run("chmod", "-R", "u+w", home)
            shutil.rmtree(home)
        first, cls.prefix = (os.path.join(home, name)
                             for name in ("first", "a prefix"))
        run(CMAKE, "--install", BUILD, "--prefix", first)
        os.rename(first, cls.prefix)
        run("chmod", "-R", "a-w", cls.prefix)
        cls.before = listing(cls.prefix)
        cls.home = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.home)
        # Neither HOME nor paths of libraries.
        cls.environment = {name: value for name, value in os.environ.items()
                           if name.startswith(("OMPI_", "PRTE_", "OMP_"))}
        cls.environment["PATH"] = "/usr/bin:/bin"

    @classmethod
    def tearDownClass(cls):
        assert listing(cls.prefix) == cls.before, "a run changed the prefix"

    def installed(self, program, *words):
        return run(os.path.join(self.prefix, "bin", program), *words,
                   cwd=self.home, env=self.environment)

    def build(self, source, *options):
        """Builds a project against the library; returns its folder."""
        folder = tempfile.mkdtemp(dir=self.home)
        run(CMAKE, "-S", source, "-B", folder, "-D",
            f"CMAKE_PREFIX_PATH={self.prefix}", *options)
        run(CMAKE, "--build", folder)
        return folder

    def test_programs_check_their_files(self):
        printed = self.installed(
            "blast", os.path.join(self.prefix, FILES, "sod.prm"), "--check")
        self.assertIn("The parameters are valid.", printed)
        for name in ("anatomy", "biomechanics", "head_impact", "scene",
                     "study"):
            self.assertRegex(self.installed(name, "--version"),
                             rf"^{name} \d+\.\d+\.\d+ \(")

    def test_a_run_is_drawn_by_the_program_beside_it(self):
        prefix = os.path.join(os.path.dirname(self.prefix), "linked")
        run("cp", "-al", self.prefix, prefix)
        program = os.path.join(prefix, "share/contrecoup/plot/plot.py")
        run("chmod", "u+w", os.path.dirname(program))
        os.remove(program)
        with open(program, "w", encoding="utf-8") as file:
            file.write('#!/bin/sh\necho "$0" > drawn\n')
        os.chmod(program, 0o755)
        words = (os.path.join(prefix, "bin", "blast"),
                 os.path.join(prefix, FILES, "sod.prm"), "--output", "sod", "--set",
                 "Output/Pictures=true", "--set",
                 "Method/Scheme=discontinuous galerkin")
        run(*words, cwd=self.home, env=self.environment)
        with open(os.path.join(self.home, "drawn"), encoding="utf-8") as file:
            self.assertEqual(file.read().strip(), program)
        # The kernels of such schemes are loaded from beside the others.
        run("chmod", "u+w", os.path.join(prefix, "lib"))
        for path in glob.glob(os.path.join(prefix, "lib/*_further_schemes.so*")):
            os.remove(path)
        with self.assertRaisesRegex(AssertionError,
                                    "galerkin needs a library that is built"):
            run(*words, cwd=tempfile.mkdtemp(dir=self.home), env=self.environment)

    def test_the_example(self):
        folder = self.build(
            os.path.join(self.prefix, "share/doc/contrecoup/example"))
        printed = run(
            os.path.join(folder, "example"),
            os.path.join(self.prefix, FILES, "kingery_bulmash.prm"),
            # Open MPI 5, which it starts by itself, asks for a home.
            cwd=self.home, env=self.environment | {"HOME": self.home})
        found = [(float(time), float(pressure)) for time, pressure
                 in re.findall(r"^([0-9.e-]+) ([0-9.e+]+)$", printed, re.M)]
        self.assertEqual(len(found), 8, printed)
        for time, pressure in found:
            if time < ARRIVAL:
                self.assertAlmostEqual(pressure, 101325., delta=1.)
        after = next(pressure for time, pressure in found if time > ARRIVAL)
        self.assertGreater(after - 101325., 0.6 * PEAK)
        self.assertLess(after - 101325., 1.1 * PEAK)
        impulse = float(re.search(r"^impulse (\S+) Pa s$", printed, re.M)[1])
        self.assertAlmostEqual(impulse, IMPULSE, delta=0.1 * IMPULSE)

    def test_lanes_of_another_width_are_not_linked(self):
        source = os.path.join(SOURCE, "tests", "install", "other_lanes")
        self.build(source)
        width = run("nm", "-DC", os.path.join(self.prefix, "lib",
                                              "libcontrecoup_base.so"))
        has_avx = "library_has_lanes_of_bits<128u>" not in width
        with self.assertRaisesRegex(AssertionError,
                                    "library_has_lanes_of_bits<"):
            self.build(source,
                       "-D", "FLAGS=" + ("-mno-avx" if has_avx else "-mavx"))

    def test_without_tests_googletest_is_not_needed(self):
        folder = os.path.join(self.home, "untested")
        run(CMAKE, "-S", SOURCE, "-B", folder, "-D", "BUILD_TESTING=OFF",
            "-D", "CMAKE_DISABLE_FIND_PACKAGE_GTest=ON")
        self.assertFalse(os.path.exists(
            os.path.join(folder, "CTestTestfile.cmake")))


if __name__ == "__main__":
    unittest.main()
