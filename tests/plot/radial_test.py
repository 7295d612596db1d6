#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The charge of the paper by ALE and by blast, as plot.py compare_radial tables it:
radial_test.py ALE_AT_REST ALE_EACH_MICROSECOND ALE_SMOOTHED BLAST, each a folder
of runs with the folders that are named below. Widths, peaks and impulses have what
was found and a tenth more, peaks and impulses as differences from shells of
0.25 mm that move with the gas, by

    tests/references/lagrangian_blast.py 0.00025 0.0001 0 0.5 at-once 0.25
"""

import contextlib
import io
import json
import os
import sys
import tempfile
import unittest

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(HERE, "..", "..", "applications"))

from plot import command_line  # noqa: E402 (after the path of the package)
from plot.readers import radial  # noqa: E402

PEAK, IMPULSE = 7.709, 79.70  # MPa, Pa s
CONSTANT = 1e-10
REFERENCE = os.path.join(HERE, "..", "..", "parameter_files", "head_impact",
                         "verification", "paper_cone_reference.csv")
# Label: which argument, its folder, and the largest width of the shock [cells],
# difference of the peak and of the impulse at 0.25 m [%].
RUNS = {
    "at rest, 2 mm": (0, "248, 1, 1", 2.74, 14.43, 7.42),
    "at rest, 1 mm": (0, "496, 1, 1", 2.77, 5.37, 2.72),
    "at rest, 0.5 mm": (0, "992, 1, 1", 2.79, 3.48, 1.19),
    "each microsecond, 2 mm": (1, "248, 1, 1", 2.65, 10.4, 3.28),
    "each microsecond, 1 mm": (1, "496, 1, 1", 2.25, 3.25, 0.67),
    "smoothed, 2 mm": (2, "straight_1", 2.03, 2.09, 13.32),
    "blast, 2 mm": (3, "62", 3.03, 9.74, 8.19),
    "blast, 1 mm": (3, "125", 2.74, 6.42, 2.9),
    "blast, 0.5 mm": (3, "250", 2.81, 4.06, 1.35)}
# Largest mean errors of density, velocity and pressure.
ERRORS = {"at rest, 2 mm": (0.231, 26.1, 37.9e3),
          "each microsecond, 2 mm": (0.19, 21.9, 33.6e3)}
FOLDERS = []


def tables(*arguments):
    """Exit code, tables (rows of words by the first one) and errors."""
    with contextlib.redirect_stdout(io.StringIO()) as out, \
            contextlib.redirect_stderr(io.StringIO()) as errors:
        code = command_line.run(["compare_radial", *arguments])
    found = []
    for block in out.getvalue().split("\n\n"):
        rows = [[word.strip() for word in line.strip("|").split("|")]
                for line in block.splitlines() if line.startswith("|")]
        found.append({row[0]: row[1:] for row in rows})
    return code, found, errors.getvalue()


class RunsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folders = {label: os.path.join(FOLDERS[run[0]], run[1])
                       for label, run in RUNS.items()}
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.picture = os.path.join(folder.name, "profiles.png")
        cls.code, found, cls.errors = tables(
            cls.picture, "0.25",
            *(f"{label}={path}" for label, path in cls.folders.items()),
            "shells=" + REFERENCE)
        cls.constant, cls.history, cls.shocks = found[:3]

    def test_mass_and_energy_are_kept(self):
        self.assertEqual((self.code, self.errors), (0, ""))
        for label in RUNS:
            row = self.constant[label]
            self.assertLess(float(row[1]), CONSTANT, label)
            self.assertLess(float(row[3]), CONSTANT, label)
        # 46.56 mg and 102.00 J in the cone of 1.134 degrees.
        ratio = [float(row[2]) / float(row[0])
                 for row in (self.constant[label] for label in RUNS)]
        self.assertLess(max(ratio) / min(ratio) - 1., 5e-3)

    def test_energy_becomes_motion_alike(self):
        for time, row in self.history.items():
            if time in ("0", "time, s") or set(time) <= {"-"}:
                continue
            shares = [float(word) for word in row[2::3]]
            self.assertEqual(len(shares), len(RUNS))
            self.assertLess(max(shares) - min(shares), 2.1, time)

    def test_shock(self):
        wrong = []
        for label, (_, _, width, peak, impulse) in RUNS.items():
            row = self.shocks[label]
            found = (float(row[3]), 100. * (float(row[4]) / PEAK - 1.),
                     100. * (float(row[5]) / IMPULSE - 1.))
            if not (found[0] < width and abs(found[1]) < peak
                    and abs(found[2]) < impulse):
                wrong.append("%s: %.2f cells, peak %+.2f %%, impulse %+.2f %%"
                             % (label, *found))
        self.assertEqual(wrong, [])

    def test_errors(self):
        for label, bounds in ERRORS.items():
            path = os.path.join(self.folders[label], "summary.json")
            with open(path, encoding="utf-8") as file:
                errors = json.load(file)["errors"]
            for name, bound in zip(("density", "velocity", "pressure"),
                                   bounds):
                self.assertLess(errors[name + "_L1"], bound, label)

    def test_picture(self):
        with open(self.picture, "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
        self.assertGreater(os.path.getsize(self.picture), 20000)


class ScriptTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def refusal(self, *arguments):
        code, _, errors = tables(os.path.join(self.folder, "p.png"),
                                 *arguments)
        self.assertEqual(code, 1)
        self.assertEqual(errors.count("\n"), 1, errors)
        return errors

    def test_width_of_a_ramp(self):
        """From 100 to 0 kPa within 10 cells of 1 mm, 80 % of that."""
        radius = 1e-3 * np.arange(100.)
        over = 1e5 * np.clip((60e-3 - radius) / 10e-3, 0., 1.)
        profile = radial.RadialProfile(radius, over, over, 1e5 + over)
        for found, right in zip(profile.shock(), (1e5, 0., 8e-3, 8.)):
            self.assertAlmostEqual(found, right, delta=1e-9 * (1. + right))

    def test_a_shock_at_the_end_has_no_width(self):
        radius = np.arange(10.)
        over = np.where(radius < 9., 1e5, 5e4)
        over[-1] = 0.
        profile = radial.RadialProfile(radius, over, over, 1e5 + over)
        self.assertIsNotNone(profile.shock())
        profile = radial.RadialProfile(radius, over, over, np.full(10, 1e5))
        self.assertIsNone(profile.shock())

    def test_refusals(self):
        table = self.write("table.csv", "position,density\n0,1\n1,1\n")
        self.assertIn("no table of position, density, velocity and pressure",
                      self.refusal("0.25", table))
        self.assertIn("no history.csv or no fields.pvd",
                      self.refusal("0.25", self.folder))
        self.assertIn("missing.csv", self.refusal("0.25", "missing.csv"))
        self.assertIn("'near'", self.refusal("near", REFERENCE))
        self.assertIn("usage:", self.refusal("0.25"))
        for name, text in (("history.csv", "time [s],mass [kg]\n0,1\n1,1\n"),
                           ("fields.pvd", "<VTKFile><Collection>"
                            "<DataSet timestep='0' file='a.vtu'/>"
                            "<DataSet timestep='1' file='a.vtu'/>"
                            "</Collection></VTKFile>"),
                           ("a.vtu", "cut off")):
            self.write(name, text)
        self.assertIn("a.vtu", self.refusal("0.25", self.folder))


if __name__ == "__main__":
    FOLDERS = sys.argv[1:5]
    unittest.main(argv=sys.argv[:1])
