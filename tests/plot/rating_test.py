#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The rating of ISO/TS 18571 for curves whose scores are known, and plot.py
agreement."""

import contextlib
import io
import os
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "applications"))

from plot import command_line  # noqa: E402 (after the path of the package)
from plot.analysis import rating  # noqa: E402

POINTS = 400


def pulse(late=0.):
    """A sine of one within the middle of the interval."""
    x = np.linspace(0., 1., POINTS) - late
    return np.where((x > 0.3) & (x < 0.7),
                    np.sin(np.pi * (x - 0.3) / 0.4)**2, 0.)


class RatingTest(unittest.TestCase):
    def test_identical(self):
        for curve in (pulse(), -3e5 * pulse(), np.linspace(1., 2., POINTS)):
            found = rating.rate(curve, curve)
            np.testing.assert_allclose(found, 1., rtol=1e-12)
            self.assertEqual(rating.grade(found.total), "excellent")

    def test_shifted(self):
        """By 20 of 400 points: a quarter of the largest shift. Nothing but
        phase and corridor suffers."""
        for late in (20, -20):
            found = rating.rate(pulse(), np.roll(pulse(), late))
            self.assertEqual(found.phase, 0.75)
            self.assertAlmostEqual(found.magnitude, 1., 12)
            self.assertAlmostEqual(found.slope, 1., 12)
            self.assertLess(found.corridor, 0.9)
            self.assertAlmostEqual(found.total, 0.4 * found.corridor + 0.55, 12)

    def test_shifted_too_far(self):
        """The pulse is later by 0.25 of the interval; 0.2 is tried."""
        found = rating.rate(pulse(), pulse(0.25))
        self.assertEqual(found.phase, 0.)

    def test_offset(self):
        """Half way between both corridors: (1 / 2)^2."""
        reference = pulse() / pulse().max()
        for offset, score in ((0.05, 1.), (0.275, 0.25), (0.5, 0.), (2., 0.)):
            found = rating.rate(reference, reference + offset)
            self.assertAlmostEqual(found.corridor, score, 9)
            self.assertAlmostEqual(found.slope, 1., 9)
            self.assertEqual(found.phase, 1.)

    def test_scaled(self):
        """Slopes twice as large have a relative error of 1, half of what
        scores nothing; values that fit nowhere cannot be warped to others."""
        reference = np.linspace(1., 2., POINTS)
        found = rating.rate(reference, 2. * reference)
        self.assertAlmostEqual(found.slope, 0.5, 9)
        self.assertEqual(found.magnitude, 0.)
        # 1.2 times a level of 1, by far the longest part, errs by 0.2 of 0.5.
        level = np.concatenate([np.linspace(0., 1., 5), np.ones(POINTS - 5)])
        self.assertAlmostEqual(rating.rate(level, 1.2 * level).magnitude, 0.6,
                               1)

    def test_slope_means(self):
        """Differences over two points, then means over nine: of a
        saw with a period of three points nothing is left."""
        values = np.arange(60) % 3.
        raw, means = np.gradient(values), rating.slopes(values)
        self.assertEqual(means[0], raw[0])
        self.assertAlmostEqual(means[2], raw[:5].mean(), 12)
        self.assertAlmostEqual(means[30], raw[26:35].mean(), 12)
        self.assertLess(np.abs(means[5:-5]).max(), 1e-12)

    def test_unlike(self):
        found = rating.rate(pulse(), -pulse())
        self.assertLess(found.total, 0.58)
        self.assertEqual(rating.grade(found.total), "poor")

    def test_warping(self):
        """The path is the cheapest of all, by trying all."""
        random = np.random.default_rng(1)

        def least(one, other, i, j, width):
            if i < 0 or j < 0 or abs(i - j) > width:
                return np.inf
            here = (one[i] - other[j])**2
            if i == 0 and j == 0:
                return here
            return here + min(least(one, other, *step, width) for step in (
                (i - 1, j), (i, j - 1), (i - 1, j - 1)))

        for width in (1, 2, 6):
            one, other = random.normal(size=(2, 6))
            pairs = rating.warped(one, other, width)
            self.assertEqual((tuple(pairs[0]), tuple(pairs[-1])),
                             ((0, 0), (5, 5)))
            self.assertLessEqual(np.abs(pairs[:, 0] - pairs[:, 1]).max(), width)
            cost = ((one[pairs[:, 0]] - other[pairs[:, 1]])**2).sum()
            self.assertAlmostEqual(cost, least(one, other, 5, 5, width), 12)

    def test_constant_reference(self):
        with self.assertRaises(ValueError):
            rating.rate(np.ones(POINTS), pulse())

    def test_grades(self):
        self.assertEqual([rating.grade(total) for total in
                          (0.95, 0.94, 0.81, 0.8, 0.59, 0.58, 0.)],
                         ["excellent", "good", "good", "fair", "fair", "poor",
                          "poor"])


class CommandTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, *pressures, until=2e-3):
        """A run with as many probes."""
        folder = os.path.join(self.folder, name)
        os.makedirs(folder, exist_ok=True)
        names = ["time [s]"] + [f"probe_{i + 1}_pressure [Pa]"
                                for i in range(len(pressures))]
        np.savetxt(os.path.join(folder, "probes.csv"), np.array(
            [np.linspace(0., until, POINTS), *pressures]).T, delimiter=",",
            header=",".join(names), comments="")
        return folder

    def call(self, *arguments):
        with contextlib.redirect_stdout(io.StringIO()) as out, \
                contextlib.redirect_stderr(io.StringIO()) as errors:
            code = command_line.run(["agreement", *arguments])
        return code, out.getvalue().splitlines(), errors.getvalue()

    def test_command(self):
        run = self.write("run", pulse(), pulse(0.05), pulse())
        reference = self.write("reference", pulse(), pulse())
        code, lines, errors = self.call(run, reference)
        self.assertEqual((code, errors, len(lines)), (0, "", 3))
        self.assertEqual(lines[1].split(),
                         ["1", "1.000", "1.000", "1.000", "1.000", "1.000",
                          "excellent"])
        self.assertEqual(lines[2].split()[2], "0.750")

    def test_bad_input(self):
        run = self.write("run", pulse())
        flat = self.write("flat", np.ones(POINTS))
        empty = os.path.join(self.folder, "empty")
        os.makedirs(empty)
        for arguments, words in (
                ((run, empty), "empty has no pressures in probes.csv"),
                ((run, flat), "the reference does not change over time"),
                ((run, run, "0"), "KILOHERTZ must be above 0")):
            code, _, errors = self.call(*arguments)
            self.assertEqual((code, errors.count("\n")), (1, 1), errors)
            self.assertIn(words, errors)


if __name__ == "__main__":
    unittest.main()
