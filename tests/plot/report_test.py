#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Shows that plot.py report makes a page of a tiny scene that needs nothing besides
itself and says what the files say, that it lives with missing files and refuses
broken ones in one line."""

import contextlib
import html
import io
import json
import os
import re
import shutil
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

import damage_test
import tiny_scene

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "applications"))

from plot import command_line  # noqa: E402 (after the path of the package)
from plot.analysis import signals  # noqa: E402
from plot.figures import (body_loads, body_views, plane_cuts,  # noqa: E402
                          style)
from plot.readers.scene import Scene  # noqa: E402
from plot.report import page as html_page  # noqa: E402


class Made:
    """What a call of plot.py report on a folder gave."""

    def __init__(self, folder, paints=False):
        """Where words alone are looked at, figures are painted roughly."""
        save, render = (style.save, html_page.render) if paints else (
            damage_test.draw_nothing, damage_test.paint_roughly)
        with contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()) as errors, \
                unittest.mock.patch.object(style, "save", save), \
                unittest.mock.patch.object(html_page, "render", render):
            self.code = command_line.run("plot.py", ["report", folder])
        self.errors = errors.getvalue()
        path = os.path.join(folder, "report.html")
        self.page = None
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                self.page = file.read()


def text_of(page):
    """The words of a page."""
    words = re.sub(r"<style>.*?</style>", "", page, flags=re.S)
    words = html.unescape(re.sub(r"<[^>]*>", " ", words))
    return " ".join(words.replace("\u00a0", " ").split())


class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory()
        cls.whole = os.path.join(cls.home.name, "whole")
        tiny_scene.write_all(cls.whole)
        cls.made = Made(cls.whole, paints=True)
        cls.page = cls.made.page or ""
        cls.text = text_of(cls.page)

    @classmethod
    def tearDownClass(cls):
        cls.home.cleanup()

    def copy_without(self, *names):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        copy = os.path.join(folder.name, "scene")
        shutil.copytree(self.whole, copy)
        for name in names + ("report.html",):
            path = os.path.join(copy, name)
            (shutil.rmtree if os.path.isdir(path) else os.remove)(path)
        return copy

    def expect(self, text, *words):
        for word in words:
            self.assertTrue(word in text, f"not in the report: {word}")

    def test_is_made(self):
        self.assertEqual(self.made.code, 0, self.made.errors)
        self.assertFalse("Missing:" in self.text)
        for section in (
                "The scene", "What happens when", "Pressure in the air",
                "Pressure on the skin", "Histories on the skin",
                "Stress waves in the body", "Histories in the tissue",
                "Injury", "Beside the published simulation",
                "Energy of the body", "Conservation of the gas",
                "What was taken for granted", "Accuracy", "The body's mesh",
                "Cost", "How to reproduce"):
            self.expect(self.page, f"  {html.escape(section)}</h2>")
        self.assertEqual(self.page.count("<figure>"), 14)
        self.assertEqual(self.page.count("<figure>"),
                         self.page.count("<figcaption>"))

    def test_needs_nothing_else(self):
        for word in ("<script", "<link", "url(", "@import", "<iframe"):
            self.assertFalse(word in self.page, word)
        for link in re.findall(r'(?:src|href)="([^"]*)"', self.page):
            self.assertRegex(link[:40], r"^(data:image/|#section-)")
        self.expect(self.page, "A tiny &lt;scene&gt;")
        self.assertLess(len(self.page), 8e6)

    def test_alternative_texts(self):
        """Each says what is to be seen, and is no caption."""
        pictures = re.findall(
            r'<figure><img [^>]*?alt="([^"]*)"[^>]*><figcaption>(.*?)'
            "</figcaption></figure>", self.page)
        self.assertEqual(len(pictures), self.page.count("<img"))
        for description, caption in pictures:
            self.assertGreater(len(description), 30)
            self.assertFalse(description in html.unescape(caption)
                             or caption in description, description)
        told = html.unescape(" ".join(words for words, _ in pictures))
        self.expect(told.replace("\u00a0", " "),
                    "after 1.50 and 2.50 ms; the largest is 99.9 kPa",
                    "the C-4 charge, 1.27 m above the ground",
                    "one chart for each of forehead, chest, back, left ear",
                    "coloured by highest pressure, largest principal strain")
        self.assertEqual(len(set(pictures)), len(pictures))

    def test_narrow_windows_and_paper(self):
        """Every cell of a table of several columns knows its heading, and
        what is folded is printed or said to be left out."""
        tables = re.findall(r'<table class="wide">.*?</table>', self.page)
        self.assertGreater(len(tables), 8)
        for table in tables:
            header = re.findall("<th(?: [^>]*)?>(.*?)</th>", table)
            for row in re.findall("<tr>(?:<td.*?</td>)+</tr>", table):
                labels = re.findall('<td[^>]* data-label="([^"]*)"', row)
                self.assertEqual(labels, header)
        folds = re.findall("<details.*?</summary>", self.page)
        self.assertEqual(len(folds), 3)
        for fold in folds:
            self.assertTrue(fold.startswith('<details class="table">')
                            or "not printed" in fold, fold)

    def test_one_scale(self):
        """Pictures of several times have one colour scale."""
        scene = Scene(self.whole)
        figures = []
        with unittest.mock.patch.object(
                style, "save", lambda figure, _: figures.append(figure)):
            views = body_views.views_of(scene.loads(), scene.blast.folder)
            cuts = scene.pressure_planes()["plane_y_0_pressure"]
            plane_cuts.draw_planes(cuts, None, one_scale=True)
            plane_cuts.draw_planes(cuts, None)
            body_loads.draw_times(scene.loads(), views, None,
                                  one_scale=True)
            body_loads.draw_times(scene.loads(), views, None)
        limits = []
        for figure in figures[:2]:
            shown = [image.norm for axis in figure.axes
                     for image in axis.images if len(axis.images) == 1]
            limits.append({(norm.vmin, norm.vmax) for norm in shown})
        for figure in figures[2:]:
            bars = [axis.get_ylim() for axis in figure.axes
                    for bar in axis.child_axes for axis in [bar]]
            limits.append(set(bars))
            self.assertEqual(len(bars), body_loads.MOST_TIMES)
        self.assertEqual([len(found) for found in limits[::2]], [1, 1])
        self.assertEqual([len(found) for found in limits[1::2]],
                         [2, body_loads.MOST_TIMES])
        for figure in figures:
            style.plt.close(figure)

    def test_numbers(self):
        self.expect(
            self.text, "1.04 MPa", "−810 kPa", "0.0542", "931",
            "2.268 kg of C-4", "distance to the body 2.337 m",
            "height above ground 1.270 m", "8.25 mm", "186.1 kg", "−22.0 %",
            "peak 900 kPa, impulse 342 Pa s",
            "268 kPa", "314 kPa", "−15 %", "0.055 %", "1 min 15 s",
            "1 min 01 s", "2.2 GB", "5.5 MB", "mpirun -np 2 scene tiny.prm",
            "abc123")

    def test_injury_of_the_skin(self):
        """What blast found is shown, with the digits that it has had."""
        front, back = (tiny_scene.HARM[name][1] for name in ("chest", "back"))
        self.expect(self.text, "10.8 m/s in front",
                    f"{html_page.number(0.5 * (front + back))} m/s as the",
                    "0.26 of the 50 % lethality", "a probability of 79 %", "0.788",
                    "peak 175 kPa", "0.264")

    def test_brain_of_the_answer(self):
        """Both pressures and the strain, each with its own unit."""
        self.expect(self.text, "Pressures in the brain reach from −810 kPa to "
                    "1.0 MPa, beyond the limit for serious injury by impacts "
                    "and that of cavitation; 95 % of its tissue is strained "
                    "by less than 5.4 %, below the 14 % at which")

    def test_errors(self):
        """Differences to the coarser run over r^0.7 - 1: of the strain half
        its value, which passes the threshold of mild injury."""
        times = 1. / (2. ** 0.7 - 1.), 1. / ((5. / 3.) ** 0.7 - 1.)
        for error in (0.2, 0.1 * times[0], 0.1 * times[1]):
            shown = html_page.percent(error).replace("\u00a0", " ")
            self.expect(self.text, f"± {shown}")
        self.expect(self.text, "Numerical error could change",
                    "The incident peak overpressure is 15 % below Kingery")
        alone = text_of(Made(self.copy_without("coarser_blast",
                                               "coarser_biomechanics")).page)
        self.expect(alone, "is unknown: the scene has no coarser run",
                    "error unknown")

    def test_checks(self):
        """What alternates from element to element is a check, no injury."""
        self.expect(self.text, "are 0.52 times the averages",
                    "−118 N s recorded on the whole body, −118 N s on the "
                    "elements (−0.084 %), after one factor on all pressures, "
                    "0.984,",
                    "(0.008, 2.337, 1.27) m, 3.39 m from the charge")
        self.assertFalse("over its averages" in self.text)

    def test_parasagittal(self):
        self.expect(self.text, "parasagittal plane, y = 0.04 m, through "
                    "skeleton, brain and lung.")

    def test_signals(self):
        """A wave whose turning points and phases are known."""
        time = np.linspace(0., 4., 4001)
        values = np.where(time > 1., np.cos(np.pi * (time - 1.)), 0.)
        tops, dips = signals.extrema(time, values, 0.5)
        self.assertEqual([round(x, 2) for x, _ in tops + dips],
                         [1., 3., 2.])
        phase = signals.positive_phase(time, values)
        begin, end, impulse = phase
        self.assertFalse(signals.is_cut(time, values, phase))
        time, values = time[:1400], values[:1400]
        self.assertTrue(signals.is_cut(
            time, values, signals.positive_phase(time, values)))
        self.assertAlmostEqual(begin, 1., delta=2e-3)
        self.assertAlmostEqual(end, 1.5, delta=2e-3)
        self.assertAlmostEqual(impulse, 1. / np.pi, delta=2e-3)

    def test_other_scene(self):
        """Other than the published one: without the comparison."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        path = os.path.join(folder, "scene.json")
        with open(path, encoding="utf-8") as file:
            facts = file.read()
        tiny_scene.write(path, facts.replace("2.268", "5.5"))
        # Nothing of what blast found is computed again.
        path = os.path.join(folder, "blast", "gauge_injury.csv")
        with open(path, encoding="utf-8") as file:
            found = file.read()
        tiny_scene.write(path, found.replace("10.842", "3.25")
                         .replace("0.78773", "0.131"))
        made = Made(folder)
        self.assertEqual(made.code, 0, made.errors)
        self.assertFalse("published simulation" in made.page)
        self.expect(text_of(made.page), "Missing: fields of biomechanics.",
                    "5.500 kg of C-4", "3.25 m/s in front",
                    "a probability of 13 %")

    def test_head_alone(self):
        """No lungs and legs in it, no places named on it, and brain where
        thinner parts were looked for."""
        folder = self.copy_without("blast/load_gauges.csv",
                                   "blast/gauge_injury.csv",
                                   "biomechanics/injury.csv")
        tiny_scene.write_loads(os.path.join(folder, "blast", "loads.h5"), {})
        path = os.path.join(folder, "scene.json")
        with open(path, encoding="utf-8") as file:
            facts = json.load(file)
        facts["tissue_places"] = [
            {"name": name, "place": place} for name, place
            in zip(("coup", "contrecoup", "spinal cord"),
                   tiny_scene.PROBES.values())]
        facts["body"], facts["remarks"] = "image", ["2 m^2 of skin"]
        tiny_scene.write(path, json.dumps(facts))
        for number in range(3):
            tiny_scene.write_mesh(os.path.join(
                folder, f"biomechanics/fields/solid_{number:04d}.vtu"),
                2e3 * number, 0.2, 4)
        made = Made(folder, paints=True)
        self.assertEqual(made.code, 0, made.errors)
        words = text_of(made.page)
        self.expect(words, "parasagittal plane, y = 0.04 m, through brain.",
                    "No place on the skin was named",
                    "Missing: injury.csv of biomechanics.",
                    "spinal cord (an element of brain)", "2 m² of skin.",
                    "a body of medical images", "where they end it is cut off")
        self.assertFalse("load_gauges.csv" in words)
        self.assertFalse("contrecoup (an" in words)

    def test_missing_stages(self):
        for names, words in (
                (("biomechanics", "blast/loads.h5"), "m/s in front"),
                (("blast", "anatomy", "scene.json"),
                 "Missing: load_gauges.csv of the blast.")):
            made = Made(self.copy_without(*names))
            self.assertEqual(made.code, 0, made.errors)
            self.expect(text_of(made.page), words)

    def test_broken_files(self):
        for name, content in (("scene.json", "{"), ("scene.json", "[]"),
                              ("blast/load_gauges.csv", "time [s],a [Pa]\n1"),
                              ("blast/gauge_injury.csv", "place,peak [Pa]\na"),
                              ("blast/loads.h5", "no HDF5"),
                              ("biomechanics/injury.csv", "measure\nx\n"),
                              ("biomechanics/fields/solid_0001.vtu", "")):
            folder = self.copy_without()
            tiny_scene.write(os.path.join(folder, name), content)
            made = Made(folder)
            self.assertEqual(made.code, 1, name)
            self.assertEqual(made.errors.count("\n"), 1, made.errors)
            self.expect(made.errors, name)
            self.assertIsNone(made.page)

    def test_no_scene(self):
        with tempfile.TemporaryDirectory() as empty:
            for folder in (empty, os.path.join(empty, "nowhere")):
                made = Made(folder)
                self.assertEqual(made.code, 1)
                self.assertEqual(made.errors.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
