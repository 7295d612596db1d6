#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Shows what the comparison of two runs of one head says:
methods_report_test.py OUTPUT_FOLDER of a head of particles. The second run is
a copy whose forces and pressures are a fifth larger."""

import contextlib
import csv
import io
import json
import os
import shutil
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path += [os.path.join(HERE, "..", "applications", "cases"),
             os.path.join(HERE, "..", "..", "applications")]

from plot import command_line  # noqa: E402 (after the paths of the modules)
from plot.readers.head_run import HeadRun  # noqa: E402
from plot.report import methods_report  # noqa: E402

OUTPUT = None
FACTOR = 1.2


def scaled_copy(folder):
    """A copy of the run with larger forces and pressures in its tables."""
    shutil.copytree(OUTPUT, folder, symlinks=True)
    for name in ("history.csv", "probes.csv"):
        path = os.path.join(folder, name)
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        raised = [i for i, title in enumerate(rows[0])
                  if "pressure" in title or title.startswith("contact_force")]
        for row in rows[1:]:
            for i in raised:
                row[i] = repr(FACTOR * float(row[i]))
        with open(path, "w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows(rows)
    path = os.path.join(folder, "summary.json")
    with open(path, encoding="utf-8") as file:
        summary = json.load(file)
    summary["results"]["peak_contact_force"]["value"] *= FACTOR
    with open(path, "w", encoding="utf-8") as file:
        json.dump(summary, file)


class DifferencesTest(unittest.TestCase):
    """Differences of tables of known numbers, without any run."""

    ROWS = [("mass", "kg", [4., 4.]),
            ("largest pressure of brain", "Pa", [1e5, 1.05e5]),
            ("least pressure of brain", "Pa", [-5e4, -4e4]),
            ("least pressure at a probe", "Pa", [-300., 9036.]),
            ("largest pressure at a probe", "Pa", [0., 2e3]),
            ("contact ends", "s", [1e-4, 1.5e-4]),
            ("momentum changes its sign", "s", [None, 2e-3])]

    def test_those_near_zero_are_absolute(self):
        found = [methods_report.shown_difference(values, unit, part)
                 for (_, unit, values), part in zip(
                     self.ROWS, methods_report.relative_differences(
                         self.ROWS))]
        self.assertEqual(found[:3], ["+0.0 %", "+5.0 %", "-20.0 %"])
        self.assertEqual(found[3:5], [
            "+" + methods_report.page.quantity(9336., "Pa"),
            "+" + methods_report.page.quantity(2000., "Pa")])
        self.assertEqual(found[5:], ["+50.0 %", "–"])

    def test_the_limit_is_a_part_of_the_largest_pressure(self):
        self.assertEqual(methods_report.largest_pressure(self.ROWS), 1e5)
        limit = methods_report.NEAR_ZERO * 1e5
        self.assertIsNone(methods_report.difference([.99 * limit, 0.], 1e5))
        self.assertEqual(methods_report.difference([1.01 * limit, 0.], 1e5),
                         -1.)
        self.assertEqual(methods_report.largest_pressure(self.ROWS[:1]), 0.)

    def test_the_answer_counts_relative_differences_only(self):
        class Run:
            summary = {}

            def __init__(self, end):
                self.history = {"time": [0., end]}

        pair = methods_report.Pair.__new__(methods_report.Pair)
        for ends in ((5e-3, 5e-3), (5e-3, 4.5e-3)):
            pair.runs, pair.names = tuple(map(Run, ends)), ["ALE", "MPM"]
            text = methods_report.answer(pair, self.ROWS)
            self.assertIn("1 of 3 quantities", text)
            self.assertNotIn("probe", text)
            self.assertEqual("end at different times, after 5.00" in text,
                             ends[1] < ends[0])


class MethodsTest(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.other = os.path.join(self.place.name, "other")
        scaled_copy(self.other)

    def tearDown(self):
        self.place.cleanup()

    def run_script(self, *arguments):
        with contextlib.redirect_stdout(io.StringIO()) as told, \
                contextlib.redirect_stderr(io.StringIO()) as errors:
            code = command_line.run(["methods", *arguments])
        return code, told.getvalue(), errors.getvalue()

    def test_differences_are_those_of_the_tables(self):
        pair = methods_report.Pair(HeadRun(OUTPUT),
                                   HeadRun(self.other))
        self.assertEqual(pair.names, ["MPM 1", "MPM 2"])
        seen = 0
        for name, unit, values in methods_report.quantities(pair):
            if values[0] and (unit == "Pa" or name.startswith("largest contact "
                                                              "force")):
                self.assertAlmostEqual(values[1] / values[0], FACTOR, 9, name)
                seen += 1
            elif name == "mass":
                self.assertEqual(values[0], values[1])
        self.assertGreaterEqual(seen, 9)
        # The contact lasts when these short runs end.
        self.assertIn("contact impulse until the end of the run",
                      [row[0] for row in methods_report.quantities(pair)])

    def test_the_page_names_them_and_has_its_pictures(self):
        folder = os.path.join(self.place.name, "both")
        code, told, errors = self.run_script(OUTPUT, self.other, folder)
        self.assertEqual((code, errors), (0, ""))
        for line in told.splitlines():
            self.assertTrue(os.path.getsize(line) > 1000, line)
        for name in ("contact_of_both", "pressures_csf", "pressures_brain",
                     "probes_1", "pressure_of_both"):
            self.assertIn(name + ".png", told)
        with open(os.path.join(folder, "report.html"),
                  encoding="utf-8") as file:
            text = file.read()
        self.assertIn("+20.0 %", text)
        self.assertIn("Farthest:", text)
        self.assertNotIn("http", text.replace("http://www.w3.org", ""))

    def test_runs_are_left_alone(self):
        before = sorted(os.listdir(self.other))
        code, _, errors = self.run_script(OUTPUT, self.other, self.other)
        self.assertEqual((code, errors.count("\n")), (1, 1))
        self.assertIn("holds a run", errors)
        code, told, _ = self.run_script(OUTPUT, self.other)
        self.assertEqual(code, 0)
        beside = self.other + "_against_" + os.path.basename(OUTPUT)
        self.assertIn(os.path.join(beside, "report.html"), told)
        self.assertEqual(sorted(os.listdir(self.other)), before)

    def test_what_is_no_head_is_refused_in_one_line(self):
        empty = os.path.join(self.place.name, "empty")
        os.makedirs(empty)
        for arguments in ((OUTPUT, empty), (empty, OUTPUT), (OUTPUT,)):
            code, _, errors = self.run_script(*arguments)
            self.assertEqual(code, 1, arguments)
            self.assertEqual(errors.count("\n"), 1, errors)


if __name__ == "__main__":
    OUTPUT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
