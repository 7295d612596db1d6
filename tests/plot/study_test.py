#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Curves and charts of the outputs of a study."""

import math
import os
import sys
import tempfile
import unittest
import unittest.mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "applications"))

from plot.figures import study_curves, style, work_precision  # noqa: E402

DISTANCES, MASSES = (1., 2., 4., 8.), (0.5, 1., 2.)


def factor(name, unit, values):
    return {"name": name, "unit": unit, "refines": False,
            "labels": [f"{value:g}" for value in values]}


def study(missing=(), masses=MASSES):
    """Peaks of charges over distance; the runs of these numbers failed."""
    rows = [{"labels": [f"{distance:g}", f"{mass:g}"],
             "numbers": [distance, mass],
             "columns": [2e5 * mass / distance**2, None]}
            for distance in DISTANCES for mass in masses]
    for number in missing:
        rows[number]["columns"] = []
    return {"title": "Peaks", "rows": rows, "reference_columns": [],
            "factors": [factor("Distance", "m", DISTANCES),
                        factor("Mass", "kg", masses)],
            "columns": [{"title": "peak", "unit": "Pa"},
                        {"title": "never known", "unit": "-"}]}


class StudyPicturesTest(unittest.TestCase):
    def setUp(self):
        style.set_up()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def drawn(self, draw, found):
        """The figure that a function saves; None if it draws nothing."""
        with unittest.mock.patch.object(work_precision, "save") as save:
            self.assertEqual(draw(found, self.folder), save.called)
            return save.call_args[0][0] if save.called else None

    def test_lower_limits(self):
        """Values cut off by a run's end have arrows, in curves and charts."""
        cut = study()
        cut["rows"][4]["lower_limits"] = [True, False]
        axis, = self.drawn(study_curves.draw_curves, cut).axes
        self.assertEqual([text.xy for text in axis.texts
                          if text.get_text() == "↑"], [(2., 50.)])
        self.assertIn("cut off", axis.get_title(loc="left"))
        axis, = self.drawn(study_curves.draw_chart, cut).axes
        self.assertEqual([text.xy for text in axis.texts
                          if text.get_text() == "↑"], [(2., 1.)])
        for row in cut["rows"]:
            row["columns"][0] *= -1.
        axis, = self.drawn(study_curves.draw_curves, cut).axes
        self.assertEqual([text.xy for text in axis.texts
                          if text.get_text() == "↓"], [(2., -50.)])
        self.assertIn("↓ cut off", axis.get_title(loc="left"))

    def test_curves(self):
        """A line for each mass, gaps where a run failed, units at the axes."""
        figure = self.drawn(study_curves.draw_curves, study(missing=[1]))
        axis, = figure.axes
        self.assertEqual(axis.get_xlabel(), "Distance [m]")
        self.assertEqual(axis.get_ylabel(), "peak [kPa]")
        self.assertEqual((axis.get_xscale(), axis.get_yscale()),
                         ("log", "log"))
        self.assertEqual([line.get_label() for line in axis.lines],
                         ["0.5", "1", "2"])
        self.assertEqual(list(axis.lines[0].get_ydata()),
                         [100., 25., 6.25, 1.5625])
        self.assertNotEqual(*[axis.lines[1].get_ydata()[0]] * 2)
        self.assertIn("1 of 12 runs", figure._suptitle.get_text())

    def test_probabilities(self):
        """Tiny probabilities are zero on the axis, not powers of ten."""
        found = study()
        for row in found["rows"]:
            row["columns"][0] = math.exp(-8. * row["numbers"][0])
        figure = self.drawn(study_curves.draw_curves, found)
        self.assertEqual(figure.axes[0].get_yscale(), "linear")

    def test_chart(self):
        """Contours over distance and mass; crosses where a run failed."""
        figure = self.drawn(study_curves.draw_chart, study(missing=[1]))
        axis = figure.axes[0]
        self.assertEqual((axis.get_xlabel(), axis.get_ylabel()),
                         ("Distance [m]", "Mass [kg]"))
        self.assertEqual(axis.get_title(loc="left"), "peak [kPa]")
        markers = [line.get_marker() for line in axis.lines]
        self.assertEqual((markers.count("o"), markers.count("x")), (11, 1))

    def test_many_outputs(self):
        """Each has a panel, in as many pictures as that needs; what no run has
        is named."""
        many = study()
        many["columns"] = [{"title": f"peak {number}", "unit": "Pa"}
                           for number in range(26)] + many["columns"][1:]
        for row in many["rows"]:
            row["columns"] = [row["columns"][0] + number for number
                              in range(26)] + [None]
        for draw, name in ((study_curves.draw_curves, "curves"),
                           (study_curves.draw_chart, "chart")):
            with unittest.mock.patch.object(work_precision, "save") as save:
                self.assertTrue(draw(many, self.folder))
            self.assertEqual([call[0][2] for call in save.call_args_list],
                             [name, name + "_2", name + "_3"])
            figures = [call[0][0] for call in save.call_args_list]
            shown = [axis.get_ylabel() if name == "curves" else
                     axis.get_title(loc="left") for figure in figures
                     for axis in figure.axes if axis.get_visible()]
            self.assertEqual(shown, [f"peak {number} [kPa]"
                                     for number in range(26)])
            for figure in figures:
                self.assertIn("without a value: never known",
                              figure._suptitle.get_text())

    def test_no_chart(self):
        """One mass gives a curve alone, and outputs without a value nothing."""
        one = study(masses=[1.])
        self.assertIsNotNone(self.drawn(study_curves.draw_curves, one))
        self.assertIsNone(self.drawn(study_curves.draw_chart, one))
        none = study(missing=range(12))
        self.assertIsNone(self.drawn(study_curves.draw_curves, none))
        self.assertIsNone(self.drawn(study_curves.draw_chart, none))

    def test_words_are_no_axis(self):
        words = study()
        for row in words["rows"]:
            row["numbers"][0] = None
        figure = self.drawn(study_curves.draw_curves, words)
        self.assertEqual(figure.axes[0].get_xlabel(), "Mass [kg]")

    def test_levels(self):
        for values in ([1., 2000.], [0., 1.], [-3., 5.]):
            levels = study_curves.levels_of(values)
            self.assertGreaterEqual(len(levels), 3, values)
            self.assertEqual(levels, sorted(levels))


if __name__ == "__main__":
    unittest.main()
