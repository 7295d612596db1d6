#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of runs: where labels stand."""

import os
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

import labels

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "applications"))

from plot.figures import histories, style  # noqa: E402
from plot.readers import tables  # noqa: E402


class RunTest(unittest.TestCase):
    def setUp(self):
        style.set_up()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def drawn(self, draw, *arguments):
        """The figure that is drawn."""
        with unittest.mock.patch.object(style, "save") as save:
            draw(*arguments)
        figure = save.call_args[0][0]
        self.addCleanup(style.plt.close, figure)
        return figure

    def test_peaks_of_early_references(self):
        """Stand clear of the axis, its ticks and the title."""
        time = np.linspace(0., 11e-3, 1101)
        columns, references = [time], {}
        header = "time [s]"
        for number, (peak, arrival) in enumerate(
                ((1.66e6, 0.3e-3), (6.9e5, 0.5e-3), (1e5, 9e-3)), 1):
            late = np.maximum(time - arrival, 0.)
            columns.append(1e5 + peak * (time >= arrival) * np.exp(-late / 1e-3))
            header += f",probe_{number}_pressure [Pa]"
            references[f"probe_{number}"] = {
                "peak_overpressure": 0.92 * peak, "arrival": arrival,
                "duration": 2e-3, "impulse": 5e-4 * peak}
        path = os.path.join(self.folder, "probes.csv")
        np.savetxt(path, np.transpose(columns), delimiter=",", header=header,
                   comments="")
        figure = self.drawn(histories.draw_probes, tables.Table(path),
                            references, "")
        self.assertEqual(labels.faults(figure), [])
        left = figure.axes[0].bbox.x0
        with labels.drawn() as found:
            figure.canvas.draw()
        own = {label.words: label.box.x0 for label in found
               if label.words.endswith(" MPa")}
        self.assertEqual(set(own), {"1.66 MPa", "reference: 1.53 MPa"})
        self.assertGreater(min(own.values()), left)


if __name__ == "__main__":
    unittest.main()
