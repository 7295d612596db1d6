#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Shows that figures of a report that differ from the files in the last digit
that is shown are found: those of the tests of the main job."""

import contextlib
import io
import os
import re
import sys
import tempfile
import unittest

import tiny_scene

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path += [os.path.join(HERE, "..", "applications", "cases"),
             os.path.join(HERE, "..", "..", "applications")]

import report_figures  # noqa: E402 (after the paths of the modules)
import report_reader  # noqa: E402
from plot import command_line  # noqa: E402

CHECKS = (report_figures.check_facts, report_figures.check_injury,
          report_figures.check_headline, report_figures.check_tables,
          report_figures.check_gauges, report_figures.check_events,
          report_figures.check_summary_file,
          report_figures.check_conservation, report_figures.check_free_air,
          report_figures.check_audit, report_figures.check_differences,
          report_figures.check_energy, report_figures.check_mesh,
          report_figures.check_cost)


def other_digit(text, number):
    """@p text with the last digit of a match changed by one."""
    digits = re.match(r"[−\d\u202f.]*", number[0])[0]
    last = number.start() + len(digits) - 1
    digit = int(text[last])
    return text[:last] + str(digit - 1 if digit else 1) + text[last + 1:]


class FiguresTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.home.cleanup)
        tiny_scene.write_all(cls.home.name)
        tiny_scene.write(os.path.join(cls.home.name, "anatomy",
                                      "summary.json"), "{}")
        with contextlib.redirect_stdout(io.StringIO()):
            command_line.run(["report", cls.home.name])
        cls.files = report_figures.Files(cls.home.name)
        with open(os.path.join(cls.home.name, "report.html"),
                  encoding="utf-8") as file:
            # Pictures take long to read again and again.
            cls.page = re.sub("base64,[^\"]*", "", file.read())

    def judge(self, text):
        page = report_reader.Page(text)
        return sum(check(page, self.files) for check in CHECKS)

    def test_accepts(self):
        self.assertEqual(self.judge(self.page), 218)

    def rejects_each(self, pattern, least, until=""):
        """Every number in what a pattern's group matches before a text."""
        count = 0
        part = self.page.partition(until)[0] if until else self.page
        for match in re.finditer(pattern, part, re.S):
            for number in re.finditer(report_reader.NUMBER, match[1]):
                changed = other_digit(match[1], number)
                page = (self.page[:match.start(1)] + changed
                        + self.page[match.end(1):])
                with self.assertRaises(AssertionError, msg=changed):
                    self.judge(page)
                count += 1
        self.assertGreaterEqual(count, least)

    def test_rejects_values_of_injuries(self):
        self.rejects_each('data-label="value and its estimated error"><b>'
                          "(.*?)<small>", 14)

    def test_rejects_the_answer(self):
        self.rejects_each('<p(?: class="verdict")?>([^<]*)</p>', 6, "<nav>")
        self.rejects_each("<li>([^<]*)</li>", 9, "<nav>")

    def test_rejects_events(self):
        self.rejects_each('data-label="values">(peak [^<]*)</td>', 8)

    def test_rejects_places(self):
        self.rejects_each('data-label="(?:arrival|peak|impulse|positive phase|'
                          r'minimum) \[[^\]]*\]">(.*?)</td>', 20)

    def test_rejects_free_air_and_conservation(self):
        self.rejects_each('data-label="(?:found|Kingery and Bulmash|'
                          "estimate|at the start|at the end|difference)"
                          '">([^<]*?)</td>', 10)

    def test_rejects_differences(self):
        self.rejects_each('data-label="(?:coarser run|this run|estimated error)"'
                          '>([^<]*?)</td>', 20)

    def test_rejects_energies(self):
        self.rejects_each('data-label="value">([^<]*\u00a0J)</td>', 5)

    def test_misses_an_energy(self):
        """Rows that do not add up."""
        row = re.search("<tr><td[^>]*>gained as the step.*?</tr>", self.page)[0]
        with self.assertRaisesRegex(AssertionError, "are in no row"):
            self.judge(self.page.replace(row, ""))

    def test_numbers(self):
        for text, value, half in (
                ("−810 kPa", -8.1e5, 500.), ("1.04 MPa", 1.04e6, 5e3),
                ("3.50·10⁻⁴ %", 3.5e-6, 5e-9), ("12\u202f345 J", 12345., 0.5),
                ("0.0542", 0.0542, 5e-5), ("9.9 m/s", 9.9, 0.05),
                ("2.268 kg of", 2.268, 5e-4), ("8.25 mm", 8.25e-3, 5e-6)):
            found = report_reader.quantity(text)
            self.assertAlmostEqual(found[0] / value, 1.)
            self.assertAlmostEqual(found[1] / half, 1.)


if __name__ == "__main__":
    unittest.main()
