#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Shows that the cheap ones of these references make what is stored of them, and
what others published."""

import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
VERIFICATION = os.path.join(os.path.dirname(os.path.dirname(HERE)),
                            "parameter_files", "blast", "verification")


def run(script, *arguments):
    return subprocess.run([sys.executable, os.path.join(HERE, script),
                           *arguments], check=True, capture_output=True,
                          text=True).stdout


def profile(path):
    return np.genfromtxt(path, delimiter=",", skip_header=3)


class ReferencesTest(unittest.TestCase):
    def test_lagrangian_blast(self):
        """Density in shells that start with 4 and 2 mm, against that stored of
        0.5 mm, as means over the ball of 0.5 m: 0.243 and 0.136 kg/m^3."""
        stored = profile(os.path.join(VERIFICATION, "paper_1d_reference.csv"))
        places = np.linspace(0.0005, 0.4995, 1000)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "profile.csv")
            for width, bound in (("0.004", 0.267), ("0.002", 0.149)):
                run("lagrangian_blast.py", width, "1e-4", "0", "0.5", path)
                found, expected = (np.interp(places, rows[:, 0], rows[:, 1])
                                   for rows in (profile(path), stored))
                error = np.average(abs(found - expected), weights=places**2)
                print(f"{width} m: {error:.4f} kg/m^3, required < {bound}")
                self.assertLess(error, bound)

    def test_normal_reflection(self):
        """A weak shock doubles its overpressure, a strong one has eight times."""
        sys.path.insert(0, HERE)
        import lagrangian_blast
        self.assertAlmostEqual(lagrangian_blast.met_by_wall(1e-3), 2e-3, 9)
        self.assertAlmostEqual(lagrangian_blast.met_by_wall(1e15) / 1e15, 8., 6)

    def test_taylor_maccoll(self):
        """Sims' table (1964) for Mach 2 and a cone of 20 degrees, and the pressure
        that test body_cone takes."""
        shock, mach, pressure = map(float, re.findall(
            r"\d+\.\d+", run("taylor_maccoll.py", "2", "20")))
        self.assertAlmostEqual(shock, 37.8, delta=0.05)
        self.assertAlmostEqual(mach, 1.57, delta=0.005)
        self.assertAlmostEqual(pressure, 1.911527, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
