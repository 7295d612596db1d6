#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The figures of the walk through the code in source/README.md, of a run that this
test makes: walk_test.py BLAST. Fields give back the means of subcells, fluxes are
those of the shock, facets have cells next to them."""

import contextlib
import io
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path += [os.path.join(HERE, "..", "applications", "cases"),
             os.path.join(HERE, "..", "..", "applications")]

import picture_cases  # noqa: E402 (after the paths of the modules)
from plot import command_line  # noqa: E402
from plot.commands import walk  # noqa: E402
from plot.readers import leaves  # noqa: E402
from plot.readers.loads import Loads  # noqa: E402

FILE = os.path.join(HERE, "..", "..", "parameter_files", "blast", "showcase",
                    "walk.prm")
BLAST = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else None
# Behind the shock, by the jump conditions, as in the file.
DENSITY, VELOCITY, PRESSURE = 2.234483, 237.198, 245833.3


class WalkTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        home = tempfile.TemporaryDirectory()
        cls.addClassCleanup(home.cleanup)
        cls.folder = os.path.join(home.name, "walk")
        subprocess.run([BLAST, FILE, "--output", cls.folder], check=True,
                       stdout=subprocess.DEVNULL)
        cls.run_ = leaves.LeafRun(cls.folder)
        cls.states = cls.run_.states()
        cls.loads = Loads(cls.run_.path("loads.h5"))

    def test_means_of_subcells(self):
        for n in (2, 4, 8):
            means = np.random.default_rng(n).random(n)
            places = np.linspace(0., 1., n)
            fields = np.interp(places, (np.arange(n) + 0.5) / n, means)
            np.testing.assert_allclose(leaves.subcell_values(n) @ fields,
                                       means, atol=1e-13)

    def test_mass(self):
        """Open means over all leaves are the mass that the run says."""
        table = self.run_.table("history.csv")
        for number in (0, len(self.states) - 1):
            state = self.states[number]
            mass = (state.density * state.open
                    * (state.edges.prod(axis=1) / state.n**2)[:, None, None]
                    ).sum()
            self.assertAlmostEqual(mass / table["mass"][number], 1., delta=1e-6)

    def test_fluxes(self):
        """That behind the shock is the mass flux of the gas there."""
        arrival = walk.Load(self.states, self.loads).arrival
        number = walk.pick_step(self.states, 0.5 * arrival)
        line = walk.Line(self.states[number], self.states[number + 1])
        self.assertEqual(len(line.pressure), line.n + 4)
        self.assertAlmostEqual(line.flux[0] / (DENSITY * VELOCITY), 1.,
                               delta=0.01)
        self.assertAlmostEqual(line.pressure[0] / PRESSURE, 1., delta=0.01)
        self.assertTrue(np.all(np.diff(line.flux) < 0.))

    def test_load(self):
        load = walk.Load(self.states, self.loads)
        self.assertAlmostEqual(load.samples.max() / load.peak, 1., delta=1e-6)
        # Facet and gas differ by what the gas moves towards the wall.
        cell = np.interp(load.times, load.cell_times, load.cell)
        self.assertLess(np.abs(cell - load.samples).max(), 0.3 * load.peak)
        self.assertGreater(np.corrcoef(cell, load.samples)[0, 1], 0.98)

    def test_pictures(self):
        with contextlib.redirect_stdout(io.StringIO()):
            code = command_line.run(["walk", self.folder])
            self.assertEqual(code, 0)
            for name in ("step", "adaptation", "cut_cells", "load"):
                picture_cases.check_picture(os.path.join(
                    self.folder, "pictures", f"walk_{name}.png"))


if __name__ == "__main__":
    unittest.main()
