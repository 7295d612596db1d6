#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of runs: where labels stand, and what is marked as a lower limit."""

import os
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

import labels
import tiny_files

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "applications"))

from plot.figures import blast_maps, histories, style  # noqa: E402
from plot.readers import planes, tables  # noqa: E402

LINE = """x [m],y [m],peak_overpressure [Pa],impulse [Pa s],arrival [s],duration [s]
1,0,3e5,90,1e-3,2e-3
2,0,2e5,80,2e-3,3e-3
3,0,1e5,30,3e-3,1e-3
4,0,nan,nan,nan,nan
"""


class RunTest(unittest.TestCase):
    def setUp(self):
        style.set_up()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        os.makedirs(os.path.join(self.folder, "fields"))

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

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

    def gauge_line(self, text):
        """Points of curve and marks of each quantity."""
        self.write(os.path.join("fields", "gauges_line_1.csv"), text)
        figure = self.drawn(blast_maps.draw_gauge_lines, self.folder, "")
        return {axis.get_title(loc="left"):
                [np.isfinite(line.get_ydata()).sum() for line in axis.lines]
                for axis in figure.axes}, figure

    def test_lines_of_gauges(self):
        """Mark impulse and duration where the end of the run cuts them off."""
        whole, limited = LINE.splitlines(), []
        for row, word in zip(whole, ("cut_off [-]", "0", "0", "1", "nan")):
            limited.append(f"{row},{word}\n")
        found, figure = self.gauge_line("".join(limited))
        self.assertEqual(found, {"peak overpressure": [3], "arrival": [3],
                                 "impulse": [2, 1], "duration": [2, 1]})
        words = [text.get_text() for axis in figure.axes if axis.get_legend()
                 for text in axis.get_legend().get_texts()]
        self.assertEqual(words, ["lower limit (≥)"] * 2)
        self.assertEqual(labels.faults(figure), [])
        # Lines of before have no such column.
        found, _ = self.gauge_line(LINE)
        self.assertEqual(set(map(tuple, found.values())), {(3,)})

    def test_planes_of_gauges(self):
        """Hatch the same."""
        fields = {name: (np.tile(np.arange(1., 6.), (3, 1)), unit) for name, unit in (
            ("peak_overpressure", "Pa"), ("impulse", "Pa s"),
            ("arrival", "s"), ("duration", "s"))}

        def hatched():
            tiny_files.write_plane(
                os.path.join(self.folder, "fields", "gauges_plane_1.vti"),
                fields, [0., 0.], [2., 1.], 5e-3)
            maps = blast_maps.take_maps(planes.open_planes(self.folder))
            self.assertEqual(set(maps["gauges_plane_1"]), set(fields))
            figure = self.drawn(blast_maps.draw_maps, maps["gauges_plane_1"], "")
            return {axis.get_title(loc="left"): one.get_array().count()
                    for axis in figure.axes for one in axis.collections
                    if one.get_hatch()}
        self.assertEqual(hatched(), {})
        fields["cut_off"] = np.tile([0., 0., 0., 1., np.nan], (3, 1)), "-"
        self.assertEqual(hatched(), {"impulse": 3, "duration": 3})


if __name__ == "__main__":
    unittest.main()
