#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""plot.py coup judges all five facts on the same filtered histories."""

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
from plot.analysis import coup, signals  # noqa: E402

STEP = 1e-6
TIME = np.arange(2501) * STEP
VAPOUR = -98.99e3  # Pa


def history(*points):
    """Straight lines through points of milliseconds and kilopascals."""
    when, pressure = np.array(points, dtype=float).T
    return 1e3 * np.interp(TIME, 1e-3 * when, pressure)


def swing(start, *extremes):
    """At rest, then one extreme after the other, each 0.2 ms after the last."""
    return history((0., 0.), (start, 0.),
                   *((start + 0.2 * (i + 1), extreme)
                     for i, extreme in enumerate(extremes)))


COUP = swing(0.05, 250., 0.)
CONTRECOUP = swing(0.16, -120., 400., -130., 300., -110., 200., 0.)


def verdicts(first=COUP, last=CONTRECOUP, **options):
    return [holds for _, _, holds in coup.judge(first, last, STEP, **options)]


class FactsTest(unittest.TestCase):
    def test_all(self):
        rows = coup.judge(COUP, CONTRECOUP, STEP)
        self.assertEqual([holds for _, _, holds in rows], [True] * 5)
        # 5 kPa on the ramps to 250 and -120 kPa within 0.2 ms.
        self.assertEqual(rows[0][1], "0.114 ms")
        self.assertEqual(rows[1][1], "first swing -120 kPa")
        self.assertEqual(rows[2][1], "400 kPa, coup 250 kPa")
        self.assertEqual(rows[3][1], "400, 300, 200 kPa")
        self.assertEqual(rows[4][1], "3; dips -120, -130, -110 kPa")

    def test_each(self):
        """Each fact fails alone."""
        for fact, first, last in (
                (0, swing(0.15, 250., 0.), CONTRECOUP),
                (0, COUP, swing(0.4, -120., 400., -130., 300., -110., 200.)),
                (2, swing(0.05, 410., 0.), CONTRECOUP),
                (3, COUP, swing(0.16, -120., 400., -130., 300., -110., 301.)),
                (3, COUP, swing(0.16, -120., 400., -130., 300., -110.)),
                (4, COUP, swing(0.16, -120., 400., -130., 300., -99., 200.)),
                (1, COUP, swing(0.16, 290., -120., 280., -130., 270., -110.))):
            expected = [number != fact for number in range(5)]
            self.assertEqual(verdicts(first, last), expected, (fact, last))

    def test_collapse(self):
        """A later peak, however high, changes neither onset nor sign."""
        late = CONTRECOUP + 20. * swing(0.4, 0., 100., 0.)
        self.assertEqual(verdicts(last=late)[:2], [True, True])

    def test_small_swings(self):
        """Swings below a quarter of the highest peak separate no dips."""
        rows = coup.judge(COUP, swing(0.16, -120., 90., -130., 400., -110.),
                          STEP)
        self.assertEqual(rows[3][1], "400 kPa")
        self.assertEqual(rows[4][1], "2; dips -130, -110 kPa")

    def test_cut_off(self):
        """Dips that reach the least pressure of the fluid count."""
        cut = np.maximum(CONTRECOUP, VAPOUR)
        self.assertFalse(verdicts(last=cut)[4])
        dip = coup.required_dip(VAPOUR)
        self.assertAlmostEqual(dip, 0.95 * VAPOUR)
        self.assertEqual(verdicts(last=cut, dip=dip), [True] * 5)
        self.assertFalse(verdicts(last=0.9 * cut, dip=dip)[4])
        # One that bears more tension changes nothing.
        self.assertEqual(coup.required_dip(-200e3), coup.CAVITATION)
        self.assertEqual(coup.required_dip(None), coup.CAVITATION)

    def test_rest(self):
        rest = np.zeros(len(TIME))
        rows = coup.judge(rest, rest, STEP)
        self.assertEqual([holds for _, _, holds in rows], [False] * 5)
        self.assertEqual(rows[0][1], "no onset")
        self.assertEqual(rows[1][1], "first swing none kPa")


class FilterTest(unittest.TestCase):
    def amplitude(self, frequency):
        """Amplitude and phase of a unit sine after the filter of 10 kHz."""
        time = np.arange(20000) * STEP
        grid, found = signals.low_pass(
            time, np.sin(2. * np.pi * frequency * time), 10e3)
        middle = (grid > 5e-3) & (grid < 15e-3)
        turns = 2. * np.pi * frequency * grid[middle]
        sine, cosine = (2. * np.mean(found[middle] * wave(turns))
                        for wave in (np.sin, np.cos))
        return np.hypot(sine, cosine), np.arctan2(cosine, sine)

    def test_gain(self):
        for frequency, gain in ((1e3, 1.), (10e3, np.sqrt(0.5)),
                                (30e3, 0.02894)):
            found, phase = self.amplitude(frequency)
            self.assertLess(abs(found - gain), 3e-4, frequency)
            if gain > 0.5:
                self.assertLess(abs(phase), 1e-3)

    def test_constant(self):
        grid, found = signals.low_pass(TIME, np.full(len(TIME), 3.), 1e3)
        np.testing.assert_allclose(found, 3., rtol=1e-12)
        self.assertEqual((grid[0], grid[-1]), (TIME[0], TIME[-1]))

    def test_ends(self):
        """The end of a history does not reach its beginning."""
        _, found = signals.low_pass(TIME, history((0., 0.), (2.4, 0.),
                                                  (2.5, 1e3)), 10e3)
        self.assertLess(np.abs(found[:len(found) // 2]).max(), 1.)

    def test_uneven_steps(self):
        time = np.sort(np.concatenate([TIME[::2], TIME[1::6]]))
        grid, found = signals.low_pass(time, np.sin(2e3 * np.pi * time), 20e3)
        part = (grid > 2e-4) & (grid < 2.3e-3)
        np.testing.assert_allclose(found[part],
                                   np.sin(2e3 * np.pi * grid[part]), atol=1e-4)


class CommandTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, last, entries="", first=COUP):
        names = ["time [s]"] + [f"probe_{number}_pressure [Pa]"
                                for number in (1, 2, 3)]
        np.savetxt(os.path.join(self.folder, "probes.csv"),
                   np.array([TIME, first, 0.5 * first, last]).T,
                   delimiter=",", header=",".join(names), comments="")
        with open(os.path.join(self.folder, "parameters.prm"), "w",
                  encoding="utf-8") as file:
            file.write(f"subsection Materials\n{entries}\nend\n")

    def call(self, *arguments):
        with contextlib.redirect_stdout(io.StringIO()) as out, \
                contextlib.redirect_stderr(io.StringIO()) as errors:
            code = command_line.run(["coup", self.folder, *arguments])
        return code, out.getvalue().splitlines(), errors.getvalue()

    def test_command(self):
        self.write(CONTRECOUP)
        code, lines, errors = self.call()
        self.assertEqual((code, errors), (0, ""))
        self.assertEqual([line.split()[-1] for line in lines[:5]], ["yes"] * 5)
        picture = os.path.join(self.folder, "pictures", "coup.png")
        self.assertTrue(os.path.exists(picture))

    def test_bandwidth(self):
        """A spike of 3 us at the coup is not seen below 5 kHz."""
        spike = history((0., 0.), (1., 0.), (1.002, 2000.), (1.004, 0.),
                        (2.5, 0.))
        self.write(CONTRECOUP, first=COUP + spike)
        self.assertEqual(self.verdicts("100")[2], "no")
        self.assertEqual(self.verdicts("5")[2], "yes")

    def verdicts(self, *arguments):
        return [line.split()[-1] for line in self.call(*arguments)[1]]

    def test_cavitating(self):
        law = (f"  set Cavitating tissues = gelatin\n"
               f"  set Least pressure = {VAPOUR}")
        cut = np.maximum(CONTRECOUP, VAPOUR)
        for entries, holds in (
                ("", "no"), (law, "yes"),
                ("  set Cavitating tissues = \n  set Least pressure = -1e4",
                 "no")):
            self.write(cut, entries)
            self.assertEqual(self.verdicts()[4], holds, entries)

    def test_bad_input(self):
        self.write(CONTRECOUP)
        for kilohertz in ("0", "-3", "500"):
            code, lines, errors = self.call(kilohertz)
            self.assertEqual((code, lines, errors.count("\n")), (1, [], 1))
            self.assertIn("KILOHERTZ must be above 0 and below", errors)
        self.write(CONTRECOUP, "  set Cavitating tissues = gelatin")
        code, lines, errors = self.call()
        self.assertEqual((code, lines, errors.count("\n")), (1, [], 1))
        self.assertIn("parameters.prm", errors)


if __name__ == "__main__":
    unittest.main()
