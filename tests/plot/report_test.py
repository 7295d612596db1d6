#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Shows that plot.py report makes a page of a tiny scene that needs nothing besides
itself and says what the files say, that it lives with missing files and refuses
broken ones in one line."""

import base64
import contextlib
import csv
import html
import io
import json
import math
import os
import re
import shutil
import sys
import tempfile
import types
import unittest
import unittest.mock

import h5py
import numpy as np

import damage_test
import labels
import tiny_scene

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "..", "applications"),
                os.path.join(HERE, "..", "applications", "cases")]

import summaries  # noqa: E402 (after the path of the module)

from plot import command_line  # noqa: E402 (after the path of the package)
from plot.analysis import (person, signals, tissue_places,  # noqa: E402
                           wave_times)
from plot.figures import (body_cuts, body_loads, body_views,  # noqa: E402
                          plane_cuts, style)
from plot.readers import fields, loads, tables  # noqa: E402
from plot.readers.scene import Scene  # noqa: E402
from plot.report import (accuracy, blast_sections,  # noqa: E402
                         body_sections, comparison, error_estimate, headline,
                         injury_table, injury_thresholds, least_phases,
                         load_impulses, page as html_page, paper, reflections,
                         reservations, scene_sections, summary, verdict)


class Columns(dict):
    """Columns of a table by name."""

    @property
    def names(self):
        return list(self)


class Made:
    """Output of a call of plot.py report on a folder."""

    def __init__(self, folder, paints=False):
        """Where words alone are looked at, figures are painted roughly."""
        save, render = (style.save, html_page.render) if paints else (
            damage_test.draw_nothing, damage_test.paint_roughly)
        with contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()) as errors, \
                unittest.mock.patch.object(style, "save", save), \
                unittest.mock.patch.object(html_page, "render", render):
            self.code = command_line.run(["report", folder])
        self.errors = errors.getvalue()
        path = os.path.join(folder, "report.html")
        self.page = None
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                self.page = file.read()


def change_json(folder, name, change):
    """Applies a change to the content of a file."""
    path = os.path.join(folder, name)
    with open(path, encoding="utf-8") as file:
        content = json.load(file)
    change(content)
    tiny_scene.write(path, json.dumps(content))


def text_of(page):
    """The words of a page."""
    words = re.sub(r"<style>.*?</style>", "", page, flags=re.S)
    words = html.unescape(re.sub(r"<[^>]*>", " ", words))
    return " ".join(words.replace("\u00a0", " ").split())


def scene_of_checks(checks):
    """A scene of which only the checks of biomechanics are known, by name."""
    return types.SimpleNamespace(
        measures=dict, blast=types.SimpleNamespace(found=lambda *_: None),
        biomechanics=types.SimpleNamespace(
            found=lambda _, name: checks.get(name), parameter=lambda _: None))


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
                "The scene", "Events over time", "Pressure in the air",
                "Pressure on the skin", "Histories on the skin",
                "Stress waves in the body", "Histories in the tissue",
                "Injury", "Comparison with the published simulation",
                "Energy of the body", "Conservation of the gas",
                "Assumptions", "Accuracy", "The body's mesh",
                "Cost", "How to reproduce"):
            self.expect(self.page, f"  {html_page.escape(section)}</h2>")
        self.assertEqual(self.page.count("<figure"), 15)
        self.assertEqual(self.page.count("<figure"),
                         self.page.count("<figcaption>"))

    def test_volumes_of_organs(self):
        self.expect(self.text, "brain 1.44 1.60 \u22129.8 % the image",
                    "Volumes of organs in the mesh")

    def test_needs_nothing_else(self):
        for word in ("<script", "<link", "url(", "@import", "<iframe"):
            self.assertFalse(word in self.page, word)
        for link in re.findall(r'(?:src|href)="([^"]*)"', self.page):
            self.assertRegex(link[:40], r"^(data:image/|data:text/csv;|"
                             "#section-)")
        self.expect(self.page, "A tiny &lt;scene&gt;")
        self.assertLess(len(self.page), 8e6)

    def test_alternative_texts(self):
        """Each says what is to be seen, and is no caption."""
        pictures = re.findall(
            r'<figure[^>]*><label class="picture"><input [^>]*><img [^>]*?'
            r'alt="([^"]*)"[^>]*></label><figcaption>(.*?)</figcaption>'
            "</figure>", self.page)
        self.assertEqual(len(pictures), self.page.count("<img"))
        for description, caption in pictures:
            self.assertGreater(len(description), 30)
            self.assertFalse(description in html.unescape(caption)
                             or caption in description, description)
        told = html.unescape(" ".join(words for words, _ in pictures))
        self.expect(told.replace("\u00a0", " "),
                    "after 1.50 and 2.50 ms; the largest is 99.9 kPa",
                    "the C-4 charge, 1.27 m above the ground",
                    "one chart for each of forehead, chest, back, left ear; "
                    "the largest peak is 900 kPa at the chest",
                    "in its tissues, from 100 Pa to 6.6 kPa, after 2.00 and",
                    "coloured by maximum pressure, largest principal strain")
        self.assertEqual(len(set(pictures)), len(pictures))

    def test_narrow_windows_and_paper(self):
        """Every cell of a table of several columns knows its heading, and
        what is folded is printed or said to be left out."""
        tables = re.findall(r'<table class="wide"[^>]*>.*?</table>',
                            self.page)
        self.assertGreater(len(tables), 8)
        for table in tables:
            header = re.findall('<th [^>]*scope="col"[^>]*>(.*?)</th>', table)
            self.assertEqual(len(header), table.count("<th") - 1)  # thead
            for row in re.findall("<tr>(?:<td.*?</td>)+</tr>", table):
                labels = re.findall('<td[^>]* data-label="([^"]*)"', row)
                self.assertEqual(labels, header)
        folds = re.findall("<details.*?</summary>", self.page)
        self.assertEqual(len(folds), 3)
        for fold in folds:
            self.assertTrue(fold.startswith('<details class="table">')
                            or "not printed" in fold, fold)

    def test_landmark(self):
        """All but the title is in the main part of the page."""
        before, _, after = self.page.partition("<main>")
        self.assertIn("</h1>", before)
        for word in ("<h2", "<table", "<figure", 'class="answer"'):
            self.assertFalse(word in before, word)
        self.assertEqual(after.count("</main>"), 1)
        self.assertEqual(re.sub(r"\s", "", after.partition("</main>")[2]),
                         "</body></html>")

    def files(self):
        """The rows of all CSV files of the page, by their names."""
        return {name: list(csv.reader(io.StringIO(
            base64.b64decode(content).decode())))
                for name, content in re.findall(
                    '<a class="csv" download="([^"]*)" href="data:text/csv;'
                    'charset=utf-8;base64,([^"]*)"', self.page)}

    def test_tables_as_files(self):
        """Each table has its file, with units and with numbers of which no
        digit is lost."""
        files = self.files()
        self.assertEqual(len(files), self.page.count("<table"))
        for name, rows in files.items():
            self.assertRegex(name, r"^[a-z_0-9]+\.csv$")
            self.assertGreater(len(rows), 1)
            self.assertEqual({len(row) for row in rows}, {len(rows[0])}, name)
            self.assertNotRegex(str(rows), "<[a-z]")
        found = {row[0]: row[1:] for name, rows in files.items()
                 if name.startswith("injury_") for row in rows}
        self.assertEqual(found["measure"][:3], [
            "value", "unit", "least by the numerics"])
        self.assertEqual(found["maximum brain pressure"][:2],
                         [repr(tiny_scene.INJURY[
                             "injury_intracranial_pressure_peak"][0]), "Pa"])
        self.assertEqual(found["front chest wall velocity"][0],
                         repr(tiny_scene.HARM["chest_wall_velocity", "chest"][0]))
        rows = files["the_scene_1.csv"]
        self.assertEqual(rows[0], ["item", "value", "unit of value"])
        self.assertIn(["charge", "2.268", "kg of C-4"], rows)
        self.assertIn(["distance to the body", "2.337", "m"], rows)
        rows = files["table.csv"]
        self.assertIn(["impulse", "Pa s", "150.4", "0.06", "", "", "221.7",
                       "0.1", "", "", "", "yes"], rows)
        rows = files["conservation_of_the_gas_1.csv"]
        self.assertIn(["mass", "186.07", "kg", "145.11", "kg",
                       repr(100. * -0.22005)], rows)
        self.assertEqual(rows[0][-1], "change [%]")
        rows = {row[0]: row for row in files["histories_on_the_skin_1.csv"]}
        self.assertEqual(float(rows["chest"][2]),
                         1e-3 * tiny_scene.GAUGES["chest"][3])
        self.assertEqual(rows["place"][2], "peak [kPa]")
        # Cut phases are told apart from whole ones.
        self.assertEqual(rows["chest"][-1], "complete")

    def test_text_of_files(self):
        """Marks of HTML, dashes and quotes are no part of a value."""
        self.assertEqual(html_page.csv_text(
            ("a", "b", "c"), [
                (html_page.Markup("x<br>&lt;<b>y</b>"), "–",
                 html_page.quantity(1234.5678, "Pa")),
                ('"q", r', html_page.percent(0.123456789),
                 html_page.quantity(1e-7, "Pa"))]),
            'a,b [%],c [Pa]\nx; <y,,1234.5678\n"""q"", r",12.3456789,1e-07\n')

    def test_units_of_files(self):
        """A unit stands over a column alone whose numbers all have it, and
        limits stay limits."""
        self.assertEqual(html_page.csv_text(
            ("a", "b"), [("load", "0.170"), ("share", html_page.percent(0.5)),
                         ("bound", html_page.limit(html_page.number(2.5)))]),
            "a,b,unit of b,limit of b\nload,0.170,,\nshare,50.0,%,\n"
            "bound,2.5,,≥\n")

    def test_one_scale(self):
        """Pictures of several times have one colour scale."""
        scene = Scene(self.whole)
        figures, painted = [], []
        paint = body_views.BodyViews.paint

        def note(views, values, norm, colours):
            painted.append((norm.vmin, norm.vmax))
            return paint(views, values, norm, colours)

        with unittest.mock.patch.object(
                style, "save", lambda figure, _: figures.append(figure)), \
                unittest.mock.patch.object(body_views.BodyViews, "paint",
                                           note):
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
        times = body_loads.MOST_TIMES
        for figure, bars in zip(figures[2:], (2, times)):
            found = [bar.get_ylim() for axis in figure.axes
                     for bar in axis.child_axes]
            self.assertEqual(len(found), bars)
            limits.append(set(found))
        limits += [set(painted[:times]), set(painted[times:])]
        self.assertEqual([len(found) for found in limits[::2]], [1, 1, 1])
        self.assertEqual([len(found) for found in limits[1::2]],
                         [2, times, times])
        for figure in figures:
            style.plt.close(figure)

    def test_labels(self):
        """They are of 8 points at least and overlap nothing, with as many
        places and times as with the phantom."""
        folder = self.copy_without()
        tiny_scene.crowd(folder)
        found, figures = [], []

        def judge(figure, other):
            found.extend(labels.faults(figure))
            figures.append(figure)
            return damage_test.draw_nothing(
                figure, io.BytesIO() if isinstance(other, str) else other) \
                or b"picture"

        with unittest.mock.patch.object(style, "save", judge), \
                unittest.mock.patch.object(html_page, "render", judge), \
                contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(command_line.run(["report", folder]),
                             0)
        self.assertEqual(found, [])
        self.assertEqual(len(figures), 15)

    def test_faults_of_labels_are_found(self):
        style.set_up()
        for width, second, faults in ((8., 0.8, 0), (8., 0.52, 1),
                                      (16., 0.8, 14)):
            figure, axis = style.plt.subplots(figsize=(width, 3.))
            for place, words in ((0.5, "one"), (second, "two")):
                axis.text(place, 0.5, words)
            self.assertEqual(len(labels.faults(figure)), faults)
            style.plt.close(figure)

    def test_numbers(self):
        self.expect(
            self.text, "1.04 MPa", "−810 kPa", "0.0542", "931",
            "2.268 kg of C-4", "distance to the body 2.337 m",
            "height above ground 1.27 m", "8.25 mm", "186.1 kg", "−22.0 %",
            "peak 900 kPa, impulse 342 Pa s",
            "268 kPa", "314 kPa", "−15 %", "0.055 %", "1 min 15 s",
            "1 min 02 s", "2.2 GiB", "5.5 MiB", "mpirun -np 2 scene tiny.prm",
            "abc123")

    def test_injury_of_the_skin(self):
        """Values of blast are shown with their digits."""
        self.expect(self.text, "lung injury trace to moderate (by the numerics "
                    "trace to extensive)", "6.63 m/s", "10.8 m/s",
                    "eardrums probably rupture (79 %, by the numerics 58 to "
                    "89 %, by the tables 95 %)", "79 % 58 to 89 %",
                    "peak 175 kPa", "0.264")
        # The probe in the air is the user's, somewhere else: the load on the
        # skin decides.
        self.assertNotIn("free-field load", self.text)
        self.expect(self.text, "Survives as far as lungs tell (death by lung "
                    "injury: less than 0.1 %)", "No probe beside the body has the wave in the "
                    "open: death by lung injury follows from the reflected load "
                    "on the skin")

    def test_load_on_the_back(self):
        """With the charge behind the person, the back's load and velocity are
        shown, in both runs."""
        self.assertNotIn("back chest wall velocity", self.text)
        folder = self.copy_without("biomechanics/fields.pvd", "blast/fields")
        for stage in ("blast", "coarser_blast"):
            path = os.path.join(folder, stage, "gauge_injury.csv")
            with open(path, encoding="utf-8") as file:
                found = file.read()
            tiny_scene.write(path, re.sub(
                "chest,|back,", lambda match: "back," if match[0] == "chest,"
                else "chest,", found).replace("chest and chest", "chest and "
                                              "back"))
        made = Made(folder)
        self.assertEqual(made.code, 0, made.errors)
        words = text_of(made.page)
        self.expect(words, "back load over the 50 % lethality load",
                    "back chest wall velocity")
        self.assertNotIn("front chest wall velocity", words)

    def test_load_on_the_side(self):
        """For a person side-on to the charge, it is that of the upper arm."""
        folder = self.copy_without("biomechanics/fields.pvd", "blast/fields")
        for stage, arm in (("blast", 0.5), ("coarser_blast", 0.45)):
            path = os.path.join(folder, stage, "gauge_injury.csv")
            with open(path, encoding="utf-8") as file:
                found = file.read()
            tiny_scene.write(path, found + "".join(
                f"{measure},left upper arm,{value},{unit},definition\n"
                for measure, value, unit in (("lung_exposure", arm, "-"), (
                    "chest_wall_velocity", 12., "m/s"))))
        # For one who faces it, an arm is no side of the trunk.
        self.expect(text_of(Made(folder).page),
                    "chest load over the 50 % lethality load 0.264")
        change_json(folder, "scene.json", lambda facts: facts["person"].update(
            side_to_charge="left side"))
        words = text_of(Made(folder).page)
        self.expect(words, "left side load over the 50 % lethality load 0.500",
                    "left chest wall velocity 12.0 m/s",
                    "on the upper arm, which covers the side")
        self.assertNotIn(" chest load over the 50 %", words)

    def test_charge_at_the_feet(self):
        """The wave at the nearest skin does not kill the lungs that are farther
        away; the load on the trunk bounds what does."""
        folder = self.copy_without("biomechanics/fields.pvd", "blast/fields")
        change_json(folder, "scene.json", lambda facts: facts.update(
            charge_place=[0.9, 0., 0.1], height=0.1, distance=0.78))
        tiny_scene.write(os.path.join(folder, "blast", "parameters.prm"),
                         "subsection Probes\n  set Points = 0.9, 0.78, 0.1\nend\n")
        path = os.path.join(folder, "blast", "probe_injury.csv")
        with open(path, encoding="utf-8") as file:
            found = file.read()
        tiny_scene.write(path, found.replace("0.4321", "1.73").replace(
            "1.35e-06", "0.999"))
        words = text_of(Made(folder).page)
        self.expect(words, "Survives as far as lungs tell (death by lung injury: "
                    "less than 0.1 %);",
                    "and chest and lungs are farther from the charge than the "
                    "nearest skin: death by lung injury follows from",
                    "of the reflected load on the skin of the trunk")
        for absent in ("free-field load over", "less than 0.1 % (4.2 % before",
                       "by the tables"):
            self.assertNotIn(absent, words)

    def test_loads_alone(self):
        """Nothing is told of elements that nothing is computed with."""
        folder = self.copy_without("biomechanics", "coarser_biomechanics",
                                   "blast/fields")
        change_json(folder, "scene.json",
                    lambda facts: facts.update(question="loads"))
        words = text_of(Made(folder).page)
        for absent in ("elements of the body", "The body's mesh"):
            self.assertIn(absent, self.text)
            self.assertNotIn(absent, words)

    def test_error_of_loads_alone(self):
        """From both runs, and at least that of all gauges, else unknown."""
        scene = Scene(self.whole)
        peak, impulse = (scene.loads().largest(name)
                         for name in ("peak", "impulse"))
        for factors, gauges, words in (
                ((0.9, 1.), (), "kPa ± 16\u00a0%, its impulse"),
                ((0.9, 1.), (0.3, 0.25), "kPa ± 25\u00a0%, its impulse"),
                (None, (), "; numerical error unknown.")):
            scene.coarser = None if factors is None else types.SimpleNamespace(
                loads=lambda of=factors: types.SimpleNamespace(
                    areas=[1.], largest=lambda name:
                    peak * of[0] if name == "peak" else impulse))
            with unittest.mock.patch.object(
                    error_estimate, "of_scene_gauges", lambda _, of=gauges: {
                        value: {"peak": value} for value in of}):
                self.assertIn(words.replace("± ", "±\u00a0"),
                              headline._loads_alone(scene).replace(
                                  "\u00a0kPa", " kPa"))
        self.assertEqual(error_estimate.of_skin(scene, "peak"),
                         (None, peak, None))

    def test_direction_of_the_charge(self):
        """In words, where it is not straight ahead."""
        scene = Scene(self.whole)
        for side, azimuth, elevation, words in (
                ("front", 27.7, 16.1, ", 28 degrees to the left of where the "
                 "person faces, 16 degrees above the middle of the body"),
                ("right side", -91.4, -0.8, ", 91 degrees to the right of "
                 "where the person faces, 1 degree below the middle of the "
                 "body"),
                ("feet", 30., -80.4, ", 80 degrees towards the feet from the middle of the body"),
                ("front", 0.2, 0.4, ""), ("back", -180., 0., "")):
            scene.facts["person"].update(
                side_to_charge=side, charge_azimuth=azimuth,
                charge_elevation=elevation,
                posture="lying" if side == "feet" else "standing")
            self.assertIn(
                f">{person.place_of_charge(scene)} the person{words}<",
                str(scene_sections.facts(scene)))
            self.assertEqual("of where the person faces." in
                             headline._opening(scene), "faces" in words)

    def test_wave_that_is_not_simple(self):
        """Bowen's curves are made for simple waves."""
        load = types.SimpleNamespace(name="lung_exposure_air")
        for fraction, told in ((0.61, "its first wave has 61 % of the impulse"),
                               (0.9, "")):
            scene = types.SimpleNamespace(air_injury=lambda f=fraction: {
                ("first_phase_fraction", "probe 1"):
                types.SimpleNamespace(value=f)})
            said = " ".join(reservations._not_simple(scene, [load]))
            self.assertEqual(bool(said), bool(told))
            self.assertIn(told, said.replace("\xa0", " "))

    def test_wave_that_runs_ahead(self):
        """Along the ground, of a charge on it alone."""
        for burst, arrival, told in (("hemispherical", 1.3e-3, True),
                                     ("hemispherical", 1.7e-3, False),
                                     ("spherical", 1.3e-3, False)):
            scene = types.SimpleNamespace(
                facts={"tables": {"burst": burst, "answer": {
                    "arrival": 1.82e-3}}},
                loads=lambda a=arrival: types.SimpleNamespace(
                    arrived=lambda: np.array([True, True]),
                    measure=lambda _: np.array([a, 2e-3]),
                    centroids=np.array([[0., 0., 0.04], [0., 0., 1.]])))
            said = " ".join(reservations._runs_ahead(scene)).replace("\xa0", " ")
            self.assertEqual(bool(said), told)
            self.assertIn("first after 1.30 ms, 0.04 m above the ground, where "
                          "the tables have 1.82 ms" if told else "", said)

    def test_late_tension(self):
        """A brain that fluid ruptures in long after the wave has come."""
        time = np.linspace(0., 12e-3, 1201)
        judged = [types.SimpleNamespace(
            name="injury_intracranial_pressure_lowest", exceeded=lambda: True)]
        for lowest, told in ((5e-3, ""), (8e-3, "8.00 ms after the ignition, 3.9 "
                                          "ms after the wave has reached the "
                                          "brain: it swings."),
                             (11e-3, "may fall further after the end of the run")):
            columns = {"time": time, "brain_pressure_5": np.interp(
                time, [4e-3, 4.1e-3, 4.2e-3, lowest - 1e-4, lowest, lowest + 1e-4],
                [0., -40e3, 0., 0., -130e3, 0.])}
            scene = types.SimpleNamespace(biomechanics=types.SimpleNamespace(
                table=lambda _, of=columns: of))
            with unittest.mock.patch.object(tissue_places, "brain_arrival",
                                            lambda _: 4.1e-3):
                said = " ".join(reservations._late_tension(scene, judged))
            self.assertEqual(bool(said), bool(told))
            self.assertIn(told, said.replace("\xa0", " "))
        whole = Scene(self.whole)
        self.assertEqual(tissue_places.brain_arrival(whole), min(
            event.begin for event in scene_sections._tissue_events(whole)
            if event.what.startswith("brain")))

    def test_values_at_the_end(self):
        """That are largest or least there may go on."""
        for values, told in (([0., 1., 2.], (False, True)),
                             ([0., -1., -2.], (True, False)),
                             ([0., 2., 1.], (False, False)),
                             ([0., 0., 0.], (False, False))):
            self.assertEqual(signals.goes_on(np.array(values)), told)

    def test_bounds_hold_the_value(self):
        """That of an endless phase is above those of the load; a row without a
        value of this run has no bounds of it."""
        known = injury_thresholds.KNOWN["lung_lethality"]
        low, high = injury_table.Judged("lung_lethality", 0.4, "-", known, 0.1, "",
                                        None, "lung_lethality", 0.5).bounds()
        self.assertLess(low, 1e-3)
        self.assertEqual(high, 0.4)
        for run, told in ((0.2, True), (None, False)):
            row = {"name": "eardrum_rupture", "unit": "-", "run": run, "tables": 1.}
            with unittest.mock.patch.multiple(
                    comparison, rows_of=lambda _, row=row: [row],
                    _bounds_of_chances=lambda *_: {"run": (0.1, 0.3)}):
                found = comparison.completed_rows(Scene(self.whole), [])
            self.assertEqual("run_least" in found[0], told)

    def test_same_cells_on_the_way(self):
        """In the coarser run, too: its errors do not know of them."""
        scene = Scene(self.whole)
        for part, told in ((0.95, True), (0.6, False)):
            scene.blast.summary["cells"] = 1000
            scene.coarser.blast.summary["cells"] = 1000 * part
            self.assertEqual(bool(error_estimate.same_cells(scene)), told)
        scene.coarser = None
        self.assertEqual(error_estimate.same_cells(scene), [])

    def test_load_in_a_gap(self):
        """Of cells between the ground and a person who lies on it."""
        scene = Scene(self.whole)
        side, cell = injury_table.loaded_side(scene), scene.fact(
            "cell_size_at_body")
        for height, told in ((0.6 * cell, True), (1.1 * cell, False)):
            scene.loads = lambda z=height: types.SimpleNamespace(
                places=lambda: {side: (0., 0., z)})
            with unittest.mock.patch.object(injury_table, "lungs_by",
                                            lambda _: "skin"):
                self.assertEqual(bool(reservations._in_a_gap(scene)), told)

    def test_wave_along_the_body(self):
        """The tables' load on lungs is of somebody who stands."""
        scene = Scene(self.whole)
        judged = injury_table.judge(scene)
        self.assertEqual(reservations._along_the_body(scene, judged), [])
        scene.facts["person"]["side_to_charge"] = "feet"
        said = reservations._along_the_body(scene, judged)[0]
        self.assertIn("at the feet", said)
        self.assertIn("0.560 of what kills half, death by lung injury less than "
                      "0.1 %", said.replace("\xa0", " "))

    def test_eardrums_at_the_nearer_ear(self):
        """Their row has the tables at their distance, in page and file."""
        scene = Scene(self.whole)
        distance = scene.fact("distance")
        for there, count in ((1.01 * distance, 0), (1.3 * distance, 1)):
            scene.facts["tables"]["ears"] = {
                "distance": there, "in_the_open": {"eardrum_rupture": 0.69},
                "before_a_wall": {"eardrum_rupture": 0.99}}
            rows = [row for row in comparison.compared(
                scene, injury_table.judge(scene)) if "nearer ear" in row[0]]
            self.assertEqual(len(rows), count)
        self.assertIn("69 % (99 % before a wall)",
                      str(rows[0][-1]).replace("\xa0", " "))

    def test_load_that_lasts_longer(self):
        """Than the first positive phase, among products."""
        load = types.SimpleNamespace(name="lung_exposure_air", value=0.562,
                                     shown=lambda: "0.562")
        scene = types.SimpleNamespace(
            blast=types.SimpleNamespace(found=lambda *_: 472e-6,
                                        parameter=lambda _: [78.5]),
            air_injury=lambda: {("lung_load_duration", "probe 1"):
                                types.SimpleNamespace(value=1.33e-3)})
        self.expect(reservations._long_load(scene, [load])[0].replace(
            "\xa0", " "), "over 1.33 ms, to the end of a later phase",
                    "first phase of 0.472 ms it is 0.209 instead of 0.562")
        scene.air_injury = dict
        self.assertEqual(reservations._long_load(scene, [load]), [])

    def test_first_swing(self):
        """Its extreme, not where it begins."""
        time = np.linspace(0., 4e-3, 401)
        counter = np.interp(time, [0., 1e-3, 1.2e-3, 1.4e-3, 1.6e-3, 1.8e-3],
                            [0., 0., 35e3, 0., -50e3, 0.])
        told = paper._sign(time, counter, 50e3, [(1.2e-3, 35e3)],
                           [(1.6e-3, -50e3)])
        self.assertIn("its first swing, 35\xa0kPa at 1.20\xa0ms, is positive",
                      told.found)

    def test_charge_that_no_gauge_faces(self):
        """The mean of four gauges misses a side between their axes."""
        scene = Scene(self.whole)
        judged = injury_table.judge(scene)
        for azimuth, off in ((0., ""), (-100., ""), (135., "45°"),
                             (-28., "28°"), (-170., "")):
            scene.facts["person"]["charge_azimuth"] = azimuth
            told = " ".join(reservations._askew(scene, judged))
            self.assertEqual(bool(told), bool(off), azimuth)
            self.assertIn(off, told)
        self.assertEqual(reservations._askew(scene, []), [])
        # Lungs that none of them finds injured are not known to be sound.
        for azimuth in (0., 135.):
            scene.facts["person"]["charge_azimuth"] = azimuth
            for entry in judged:
                if entry.name.startswith(("chest_wall", "lung_exposure")):
                    entry.value = entry.error = 0.01
            lungs = next(one for one in verdict.verdicts(scene, judged)
                         if one.subject == "lungs")
            self.assertIn("no lung injury", lungs.words)
            self.assertEqual("do not face the charge" in str(lungs),
                             azimuth > 0.)
            self.assertEqual((lungs.kind, lungs.is_certain()),
                             ("mid", None) if azimuth else ("good", True))

    def test_name_of_an_explosive(self):
        """As scene.json has it for texts, else for entries."""
        scene = Scene(self.whole)
        self.assertEqual(scene.explosive_name(), "C-4")
        del scene.facts["explosive_title"]
        self.assertEqual(scene.explosive_name(), "c-4")

    def test_wave_that_has_merged(self):
        """With reflections by ground and walls: what they add is told, of the
        probe that they concern, and no later wave is one of them."""
        def reflection(plane, **changes):
            return {"place": "probe 1", "by": plane, "least_delay": 0.,
                    "largest_delay": 9., "merges": True, "peak_rise": 0.584,
                    "impulse_rise": None, **changes}
        scene = Scene(self.whole)
        wall = reflection("wall at x = 3.2 m")
        for rows, words in (
                ([], "Peak and arrival at the probe are those of the incident "
                 "wave; reflections by the body may add"),
                ([wall], "may have merged with its reflection by the wall at "
                 "x = 3.2 m, which adds some 58 % to the peak and an unknown "
                 "part to the impulse and lets it arrive earlier; reflections "
                 "by the body may add to impulse and duration, as may"),
                ([reflection("ground"), wall], "by the ground and wall at "
                 "x = 3.2 m, each of which adds some 58 %"),
                ([reflection("ground", merges=False), wall],
                 "reflections by the ground or body may add"),
                ([wall | {"place": "nearest skin"}],
                 "those of the incident wave")):
            scene.facts["reflections"] = rows
            self.assertIn(words, reflections.note(scene).replace("\xa0", " "))
        found = scene.blast.found
        for key in ("", "probe_2_arrival"):
            scene.blast.found = lambda part, name, key=key: \
                1. if name == key else found(part, name)
            self.assertEqual("the first probe" in accuracy._free_air(scene),
                             bool(key))

    def test_later_wave(self):
        """Is the reflection by the plane in whose time it comes, if it is larger
        than the incident wave; else one of all that may come. Tables are
        compared with the first peak."""
        known = {"arrival": 4e-3, "duration": 3e-3, "peak_overpressure": 93e3,
                 "first_peak_overpressure": 79e3,
                 "later_peak_overpressure": 93e3, "later_peak_time": 5.2e-3,
                 "reference_peak_overpressure": 102e3}

        def told(merges=False, ground=0.9e-3, wall=None, **changes):
            scene = Scene(self.whole)
            scene.facts["reflections"] = [
                {"place": "probe 1", "by": plane, "least_delay": least,
                 "largest_delay": 2.5e-3, "merges": merges}
                for plane, least in (("ground", ground),
                                     ("wall at x = 3 m", wall))
                if least is not None]
            values = known | changes
            scene.blast.found = lambda _, name: values.get(
                name.removeprefix("probe_1_"))
            return reflections.note(scene), scene
        note, scene = told()
        self.assertEqual(
            note, "Peak and arrival at the probe are those of the incident "
            "wave. A second wave comes within the positive phase there, with a "
            "peak of 93.0\xa0kPa at 5.20\xa0ms: the reflection by the ground. "
            "Impulse, duration and the load on lungs are those of both waves.")
        self.assertIn("at 6.00\xa0ms, where the run ends: its peak may be higher: ",
                      told(later_peak_time=6e-3)[0])
        # The eardrum on the first screen is judged by its own load.
        self.assertIn("The last rows, on people in the open, are by the larger "
                      "peak", headline.Lead(scene, []).tables())
        self.assertNotIn("last rows", str(accuracy._free_air(scene)))
        self.assertIn(">79.0\xa0kPa<", str(accuracy._free_air(scene)))
        for words, changes in (
                ("second shock, or a reflection by the body.",
                 {"later_peak_overpressure": 50e3, "merges": True}),
                ("second shock, or a reflection by the ground or body.",
                 {"later_peak_overpressure": 50e3, "wall": 2e-3}),
                (": the reflection by the ground or wall at x = 3 m.",
                 {"wall": 1e-3}),
                (": the reflection by the ground.", {"wall": 2e-3}),
                (": a reflection by the ground or body.",
                 {"later_peak_time": 6.8e-3}),
                ("; reflections by the ground or body may add to impulse and "
                 "duration, as may", {"later_peak_time": 7.2e-3}),
                ("; reflections by the body may add",
                 {"later_peak_time": 7.2e-3, "ground": 3.1e-3})):
            self.assertIn(words, told(**changes)[0])

    def test_phase_that_the_end_cuts(self):
        """It is said next to the tables, with what follows from it."""
        for known in ({}, {"probe_1_cut_off": 1.}):
            scene = Scene(self.whole)
            scene.blast.found = lambda _, name: known.get(name)
            self.assertEqual("lower limits" in reflections.note(scene),
                             bool(known))
            scene.facts["table_comparison"] = [
                {"name": name, "unit": "Pa", "run": 2., "tables": 3.}
                for name in ("peak_overpressure", "impulse")]
            self.assertEqual(
                [row[1].startswith("≥") for row in comparison.compared(scene)],
                [False, bool(known)])
            for row in scene.facts["table_comparison"]:
                row.update(name="reflected_" + row["name"],
                           cut_off=row["name"] == "impulse")
            self.assertEqual(
                [row[1].startswith("≥") for row in comparison.compared(scene)],
                [False, True])
        # Probes have no difference that would be that of the run's end.
        figures = {f"probe_{number}_{kind}{name}": 2. + (kind == "")
                   for number in (1, 2) for kind in ("", "reference_")
                   for name in ("impulse", "arrival", "duration")}
        figures["probe_2_cut_off"] = 1.
        scene.blast.found = lambda _, name: figures.get(name)
        table = str(accuracy._free_air(scene))
        self.assertEqual([table.count(words) for words in (
            ">≥ 3.00\xa0Pa s<", ">≥ 3.00\xa0s<", ">3.00\xa0s<", ">–<",
            ">50\xa0%<", "≥: a lower limit")], [1, 1, 3, 2, 4, 1], table)

    def test_phase_of_the_skin_that_the_end_cuts(self):
        """Impulses there are lower limits, wherever they are told."""
        for duration, is_cut in ((1e-4, False), (1., True)):
            folder = self.copy_without()
            with h5py.File(os.path.join(folder, "blast", "loads.h5"),
                           "a") as file:
                file["duration"] = np.full(len(file["area"]), duration)
            scene = Scene(folder)
            self.assertEqual(" its impulse at least " in
                             headline._loads_alone(scene), is_cut)
            self.assertEqual("On 100\u00a0% of the skin the run ends" in
                             "".join(map(str, blast_sections.skin(scene))),
                             is_cut)
            scene.coarser = scene
            self.assertEqual(
                [[cell.startswith("≥") for cell in row[1:3]]
                 for row in error_estimate._rows_of_skin(scene)],
                [[False] * 2, [is_cut] * 2])
        known = scene.gauge_measures()
        next(iter(known.values()))["cut off"] = 1.
        scene.gauge_measures = lambda: known
        self.assertEqual(sum("impulse ≥ " in event.detail for event in
                             scene_sections._skin_events(scene)), 1)

    def test_load_in_the_air(self):
        """At a probe as far from the charge as the body, Bowen's definition
        gives the exposure and the probability of death."""
        folder = self.copy_without("biomechanics/fields.pvd", "blast/fields")
        change_json(folder, "scene.json", lambda facts: facts.update(
            probe_beside_body=[0.008, 2.337, 1.27]))
        made = Made(folder)
        self.assertEqual(made.code, 0, made.errors)
        self.expect(text_of(made.page),
                    "Survives as far as lungs tell (death by lung injury: less "
                    "than 0.1 %); eardrums",
                    "free-field load over the 50 % lethality load 0.432",
                    "beside the body, 2.34 m from the charge, 1.27 m above the "
                    "ground, in the open",
                    "probability of death by lung injury less than 0.1 %")
        # The reflected load on the skin then has no verdict of its own.
        judged = {entry.name: entry.has_verdict
                  for entry in injury_table.judge(Scene(folder))
                  if "lung_exposure" in entry.name}
        self.assertTrue(judged.pop("lung_exposure_air"))
        self.assertEqual(set(judged.values()), {False}, judged)
        # The tables have another verdict, for an equivalence of energies.
        change_json(folder, "scene.json", lambda facts: facts["tables"].update(
            is_published=False, source="ratio of energies", answer={
                "in_the_open": {**tiny_scene.EFFECT, "lung_lethality": 0.95},
                "before_a_wall": {"lung_lethality": 0.999}}))
        words = text_of(Made(folder).page)
        self.expect(words, "Survival is uncertain (death by lung injury: less "
                    "than 0.1 % by this run, 95 % by the tables)",
                    "The tables have another verdict on the lungs",
                    "(the TNT equivalence is a ratio of energies, not measured)",
                    "ratio of energies, not measured), without ground",
                    "less than 0.1 % (more than 99 % before a wall)")
        # The known bias of the model is most of a difference of 32 %.
        scene = Scene(folder)
        for row in scene.list_of("table_comparison"):
            row["differs"] = row["name"] == "impulse"
        for bias, words in (("-0.24", "Most of the difference in impulse is the "
                             "known bias of the model."),
                            ("-0.1", "ratio of energies"),
                            ("0.24", "ratio of energies")):
            scene.facts["plan"] = [{"item": "model_bias_impulse",
                                    "estimate": bias}]
            told = reservations._tables(scene, injury_table.judge(scene))[0]
            self.expect(told.replace("\xa0", " "), words)
            self.assertEqual("ratio of energies" in told, "ratio" in words)
        # The run ends before the positive phase does.
        change_json(folder, "blast/summary.json", lambda facts:
                    facts["results"].update(
                        probe_1_cut_off=tiny_scene.with_unit(1., "-")))
        path = os.path.join(folder, "blast", "probe_injury.csv")
        with open(path, encoding="utf-8") as file:
            rows = [row for row in file if not row.startswith("lung_")]
        tiny_scene.write(path, "".join(rows))
        words = text_of(Made(folder).page)
        self.expect(words, "Survival not judged (the run ends before the "
                    "positive phase does; death by lung injury by the tables: "
                    "95 %); eardrums")
        self.assertNotIn("free-field load over the 50 % lethality load", words)

    def test_pressure_of_a_place(self):
        """Averaged over the tissue; of the element in older runs."""
        table = {"probe_1_pressure": 1., "probe_1_averaged_pressure": 2.,
                 "probe_2_pressure": 3.}
        self.assertEqual([tables.tissue_pressure(table, f"probe_{number}_")
                          for number in (1, 2)], [2., 3.])

    def test_round_off_of_pressures(self):
        """Round-off before the wave is no pressure."""
        folder = self.copy_without()
        path = os.path.join(folder, "biomechanics", "probes.csv")
        table = tables.Table(path)
        pressures = [i for i, name in enumerate(table.names)
                     if "pressure" in name]
        table.values[:, pressures] = np.maximum(
            table.values[:, pressures], -6.09e-20)
        with open(path, encoding="utf-8") as file:
            header = file.readline()
        np.savetxt(path, table.values, delimiter=",", header=header.rstrip(),
                   comments="")
        words = text_of(Made(folder).page)
        self.expect(words, "then; 0 Pa to ")
        self.assertFalse("·10⁻²⁰" in words)
        self.assertEqual(signals.extremes(np.array([-2e-6, 1.])), (-2e-6, 1.))

    def test_errors_of_gauges(self):
        """No error is below the median of its measure or two per cent, and
        what one of both runs lacks has none."""
        fine = {"a": {"peak": 1., "impulse": 1.}, "b": {"peak": 1.},
                "c": {"peak": 1.}, "d": {"peak": 0.}}
        coarse = {"a": {"peak": 0.9, "impulse": 0.999}, "b": {"peak": 1.},
                  "c": {"peak": 0.95}, "d": {"peak": 1.}}
        errors = error_estimate.of_gauges(fine, coarse, 2.)
        times = 1. / (2. ** 0.7 - 1.)
        for gauge, error in (("a", 0.1), ("b", 0.05), ("c", 0.05)):
            self.assertAlmostEqual(errors[gauge]["peak"], times * error)
        self.assertEqual(errors["a"]["impulse"], 0.02)
        self.assertEqual(errors["d"], {})
        # One run alone that ends within the phase, or has one wave in it.
        same = {"peak": 1., "impulse": 1., "cut off": 0.}
        for other, names, known in (
                ({"cut off": 0.}, (), True), ({"cut off": 1.}, (), False),
                ({"cut off": 0.}, ("a",), False)):
            errors = error_estimate.of_gauges({"a": same}, {
                "a": {**same, **other}}, 2., names)["a"]
            self.assertEqual(errors, {"peak": 0.02, "impulse": 0.02} if known
                             else {"peak": 0.02})

    def test_brain_of_the_answer(self):
        """Exceeded thresholds are told in words."""
        self.expect(self.text, "; brain: fluid may cavitate, HIC15 above the "
                    "limit of road traffic.")

    def test_error_of_the_brain_belongs_to_its_measure(self):
        """Uncertainty by the numerics is said of its own measure alone."""
        names = ("injury_intracranial_pressure_lowest", "injury_hic15")
        for values, errors, words in (
                ((-2e5, 500.), (0.84, 0.1),
                 "HIC15 above the limit of NATO AEP-55, fluid may cavitate "
                 "(uncertain by the numerics)"),
                ((-2e5, 260.), (0.84, 0.2), "fluid may cavitate and HIC15 above "
                 "the limit of NATO AEP-55 (each uncertain by the numerics)"),
                ((-2e5, 260.), (0.1, 0.2),
                 "fluid may cavitate, HIC15 above the limit of NATO AEP-55 "
                 "(uncertain by the numerics)"),
                ((-2e5, 240.), (0.1, 0.2), "fluid may cavitate, HIC15 below its "
                 "thresholds (uncertain by the numerics)"),
                ((-2e5, 240.), (0.84, 0.2), "fluid may cavitate and HIC15 below "
                 "its thresholds (each uncertain by the numerics)"),
                ((-1., 240.), (0.1, 0.2), "below all thresholds (uncertain by "
                 "the numerics: HIC15)"),
                ((-1., 1.), (None, None), "below all thresholds")):
            judged = [injury_table.Judged(
                name, value, "", injury_thresholds.KNOWN[name], error, "")
                      for name, value, error in zip(names, values, errors)]
            self.assertEqual(str(verdict._brain(judged)), "brain: " + words)
        # A measure without a verdict may exceed a threshold all the same.
        name = "injury_intracranial_pressure_peak"
        judged.append(injury_table.Judged(
            name, 1.76e5, "Pa", injury_thresholds.KNOWN[name], None, ""))
        found = verdict._brain(judged)
        self.assertEqual(found.words, "brain: below all thresholds but that of "
                         "an exposure, maximum brain pressure")
        self.assertEqual(found.kind, "mid")

    def test_brain_of_a_run_that_ends_too_early(self):
        """Lower limits below their thresholds do not count as below."""
        def of(name, value, is_cut):
            return injury_table.Judged(name, value, "",
                                       injury_thresholds.KNOWN[name], None, "",
                                       is_cut=is_cut)
        lowest = of("injury_intracranial_pressure_lowest", -1., False)
        for judged, words, kind in (
                ([lowest, of("injury_hic15", 1., True)],
                 "brain: below all thresholds so far (HIC15 not judged, as the "
                 "run ends too early)", "none"),
                ([of("injury_hic15", 1., True)],
                 "brain not judged (the run ends too early)", "none"),
                ([lowest, of("injury_hic15", 260., True)],
                 "brain: HIC15 above the limit of NATO AEP-55", "mid"),
                ([of("injury_intracranial_pressure_lowest", -9e4, True),
                  of("injury_hic15", 1., False)],
                 "brain: below all thresholds so far (minimum brain pressure "
                 "not judged, as the run ends too early)", "none")):
            found = verdict._brain(judged)
            self.assertEqual((str(found), found.kind), (words, kind))

    def test_pressure_of_a_run_that_ends_too_early(self):
        """A least pressure is at or below what was reached."""
        name = "injury_intracranial_pressure_lowest"
        for value, is_certain in ((-9e4, True), (-1.05e5, False),
                                  (-2e5, True)):
            entry = injury_table.Judged(
                name, value, "Pa", injury_thresholds.KNOWN[name], 0.1, "",
                is_cut=True)
            self.assertEqual(entry.shown()[:3], "≤ −")
            self.assertEqual(entry.is_open, value > -1e5)
            self.assertEqual(entry.is_certain(), is_certain)
            self.assertIn("minimum brain pressure (in magnitude) is a lower "
                          "limit", injury_table.cut_off([entry], "End", 3e-3)[0])

    def test_largest_peak_of_another_wave(self):
        """Its error is that of both waves, each beside the same one."""
        time = np.linspace(0., 6., 601)
        scene, coarser = (types.SimpleNamespace(
            facts={}, gauge_measures=lambda peak=max(peaks): {
                "ear": {"peak": peak}},
            blast=types.SimpleNamespace(table=lambda _, over=np.interp(
                time, [1., 1.1, 2., 3., 3.1, 5.], [0., peaks[0], 9., 9., peaks[1], 0.]):
                {"time": time, "ear": over})) for peaks in ((57., 77.), (86., 57.)))
        scene.coarser = coarser
        self.assertAlmostEqual(error_estimate.of_scene_gauges(scene)["ear"]["peak"],
                               20. / 77. / (2. ** 0.7 - 1.))

    def test_what_follows_from_a_lower_limit(self):
        """The value of a coarser run that ends as early, and probabilities."""
        blasts = [types.SimpleNamespace(found=lambda *_, of=skin: of)
                  for skin in (0.8, 1.)]
        scene = types.SimpleNamespace(
            coarser=types.SimpleNamespace(blast=blasts[0]), blast=blasts[1],
            asks_for_loads=lambda: False, has_own_mesh=lambda: False)
        for is_cut, sign in ((True, "≥ "), (False, "")):
            hic, csdm = (injury_table.Judged(
                name, value, "-", injury_thresholds.KNOWN[name], 0.36, "",
                coarser, is_cut=is_cut, is_coarser_cut=is_cut)
                         for name, value, coarser in (
                             ("injury_hic15", 251., 33.8),
                             ("injury_csdm_15", 0., 0.)))
            self.assertEqual(hic.shown_error(), "by the numerics ≥ 161"
                             if is_cut else html_page.error(0.36))
            self.assertIs(summary._measure(csdm)["is_certain"], not is_cut or None)
            chances = list(injury_table._chances(hic))
            self.assertEqual(len(chances), 3)
            for words in chances:
                self.assertEqual(": ≥ " in words, is_cut, words)
            rows = str(error_estimate.section(scene, [hic, csdm])).replace(
                "\u00a0", " ")
            for words in ("33.8<", "251<", "0 %<", "0 % in the coarser run"):
                self.assertIn(f">{sign}{words}", rows)
            self.assertIn("Its gas has 80 % of the skin", rows)

    def test_error_that_is_unknown(self):
        """The answer says of which measures, and why."""
        known = injury_thresholds.Known("probability of death", [(0.5, "x")],
                                        "", "")

        def told(coarser, body, *errors):
            scene = types.SimpleNamespace(
                coarser=coarser, has_own_mesh=lambda: body == "mesh")
            names = ("lung_lethality", "injury_hic15")
            found = [verdict.Verdict("", "w", "mid", "", injury_table.Judged(
                name, 0.1, "-", known._replace(title=f"title of {name}"), error,
                "")) for name, error in zip(names, errors)]
            return verdict.sentence(scene, found)
        run = types.SimpleNamespace(blast=types.SimpleNamespace(exists=True))
        for case, words in (
                ((run, "phantom", 0.1, 0.1), "W; w."),
                ((run, "phantom", None, 0.1), "W; w; numerical error of title of "
                 "lung_lethality unknown: the coarser run has no complete value of it."),
                ((run, "phantom", None, None), "W; w; numerical error unknown: "
                 "the coarser run has no complete value of "
                 "them."),
                ((run, "mesh", 0.1, None), "W; w; numerical error of title of "
                 "injury_hic15 unknown: your own hexahedra have no coarser "
                 "mesh."),
                ((None, "phantom", None, None), "W; w; numerical error unknown: "
                 "the scene has no coarser run.")):
            self.assertEqual(told(*case), words)

    def test_differences_beyond_errors_that_are_unknown(self):
        """Nothing exceeds the errors of both where that of the run is unknown."""
        def row(name, error):
            return {"name": name, "unit": "-", "run": 0.2, "run_error": error,
                    "tables": 0.4, "tables_error": 0.2, "differs": True}

        def told(*rows):
            scene = types.SimpleNamespace(
                list_of=lambda _: rows, facts={}, coarser=object(),
                table_answer=lambda *_: (None, None), loads=lambda: None,
                fact=lambda _: None)
            return reservations._tables(scene, [])[0].replace("\xa0", " ")
        peak, load = row("peak_overpressure", 0.1), row("lung_exposure", None)
        self.assertIn("by more than the errors of both;", told(peak))
        self.assertIn("by more than the error of the tables, while that of the "
                      "run is unknown;", told(load))
        self.assertIn("by more than is known of both errors (that of the run is "
                      "unknown of the free-field load over the 50 % lethality "
                      "load);", told(peak, load))

    def test_probabilities_are_bounded(self):
        """An error of the measure is carried through the curve, and may be as
        large as the measure."""
        known = injury_thresholds.Known("rupture", [(0.5, "likely")], "", "")
        for error, low, high in ((0.1, 0.951, 0.976), (1.5, 0., 1.)):
            found = injury_table.Judged(
                "ear", 0.966, "-", known, error, "", curve="eardrum_rupture",
                of=347e3).bounds()
            self.assertAlmostEqual(found[0], low, 2)
            self.assertAlmostEqual(found[1], high, 2)
        part = injury_table.Judged("x", 0.984, "-", injury_thresholds.Known(
            "fraction of the brain", [], "", ""), 0.47, "")
        self.assertEqual(part.shown_error().replace("\u00a0", " "),
                         "52 to 100 %")
        self.assertEqual(html_page.interval(0.17, 0.999).replace(
            "\u00a0", " "), "17 to 100 %")

    def test_no_measure_changes_its_sign(self):
        """However large its error is."""
        for value, bounds in ((0.007, (0., 0.0175)), (-1e5, (-2.5e5, 0.))):
            entry = injury_table.Judged("x", value, "-", injury_thresholds.Known(
                "strain", [], "", ""), 1.5, "")
            for bound, expected in zip(entry.bounds(), bounds):
                self.assertAlmostEqual(bound, expected)

    def test_digits_that_were_given(self):
        """No zeros at the end that nobody wrote."""
        for value, unit, text in (
                (0.05, "kg", "0.05 kg"), (1., "kg", "1 kg"), (11.3, "m", "11.3 m"),
                (0.49678, "m", "0.4968 m"), (12500., "kg", "12\u202f500 kg"),
                (2e-6, "kg", "2·10⁻⁶ kg"), (100., "mm", "100 mm")):
            self.assertEqual(html_page.given(value, unit).replace("\u00a0", " "),
                             text)
        self.assertEqual([html_page.counted(n, "verdict") for n in (0, 1, 13)],
                         ["no verdicts", "one verdict", "13 verdicts"])

    def test_interruptions(self):
        """A stage that was interrupted says where it went on."""
        def status(places):
            run = types.SimpleNamespace(exists=False, summary={
                "status": "finished", "interruptions": places})
            return accuracy.cost_row("blast", {}, run)[1]
        self.assertEqual(status([]), "finished")
        self.assertEqual(
            status([{"step": 17, "time": 2e-3}, {"step": 1234, "time": 5e-3}]),
            "finished, interrupted: went on from step 17 (2.00\u00a0ms) and "
            "step 1234 (5.00\u00a0ms)")

    def test_size_of_a_coarser_stage(self):
        """The size is that of its own summary; a dash without one."""
        folder = self.copy_without()
        tiny_scene.write(
            os.path.join(folder, "coarser_blast", "summary.json"),
            json.dumps({"application": "blast", "cells": 77, "steps": 99}))
        rows = str(accuracy.cost(Scene(folder))[0])
        self.expect(rows, ">77 cells, 99 steps<", ">–<")

    def test_size_of_a_mesh_that_adapted(self):
        """Its most cells, of which the forecast speaks, and those at the end."""
        folder = self.copy_without()
        tiny_scene.write(
            os.path.join(folder, "coarser_blast", "summary.json"),
            json.dumps({"application": "blast", "cells": 77, "steps": 99,
                        "performance": {"largest_cells": 88}}))
        self.expect(str(accuracy.cost(Scene(folder))[0]),
                    ">88 cells at most, 77 cells at the end, 99 steps<")

    def test_phases_with_two_waves(self):
        """Errors of a positive phase do not hold where finer cells may let the
        pressure fall to zero in a dip before a second wave: that of one run
        alone, or whose overpressure is within its error. Told is the time to
        the first dip."""
        time = np.linspace(0., 4e-3, 401)

        def run(coarser=None, **dips):
            columns = Columns(time=time)
            for name, (dip, value) in dips.items():
                columns[name] = np.interp(
                    time, [1e-3, 1.01e-3, 1e-3 + dip, 1.01e-3 + dip, 3e-3],
                    [0., 100., value, value + 30., 0.])
            known = {"arrival": 1e-3, "peak": 100., "positive phase": 2e-3}
            return types.SimpleNamespace(
                coarser=coarser, facts={}, gauge_measures=lambda: dict.fromkeys(
                    (*dips, "absent"), known),
                blast=types.SimpleNamespace(table=lambda _: columns))
        deep, later = (5e-4, 20.), (1e-3, 20.)
        found = least_phases.of_skin(run(
            chest=deep, back=later, arm=later, leg=later, ear=(1e-3, 1.),
            coarser=run(chest=later, back=deep, arm=(1.1e-3, 35.),
                        leg=(1.1e-3, 30.), ear=(1e-3, 1.))))
        self.assertEqual({name: round(1e3 * value, 2)
                          for name, value in found.items()},
                         {"chest": 0.5, "back": 0.5, "arm": 1., "ear": 1.})
        self.assertEqual(list(least_phases.of_skin(
            run(chest=later, ear=(1e-3, 1.)))), ["ear"])
        single = Columns(time=time, chest=np.interp(
            time, [1e-3, 1.01e-3, 3e-3], [0., 100., 0.]))
        alone = run(chest=later)
        # A shallow dip stays, one below zero after it does not.
        deeper = run(chest=later)
        deeper.blast.table = lambda _: Columns(time=time, chest=np.interp(
            time, [1e-3, 1.01e-3, 1.4e-3, 1.5e-3, 2e-3, 2.1e-3, 3e-3],
            [0., 80., 50., 70., -3., 100., 0.]))
        self.assertAlmostEqual(least_phases.of_skin(deeper)["chest"], 1e-3)
        alone.blast.table = lambda _: single
        self.assertEqual(least_phases.of_skin(alone), {})
        # This run's pressure falls to zero before the coarser one's dip.
        short = run(coarser=run(chest=later, ear=(4e-4, 1.)), chest=deep, ear=deep)
        single["ear"] = single["chest"]
        short.blast.table = lambda _: single
        short.gauge_measures = lambda: dict.fromkeys(("chest", "ear"), {
            "arrival": 1e-3, "peak": 100., "positive phase": 6e-4})
        self.assertEqual(least_phases.of_fewer_waves(short), {"chest"})
        self.expect(self.text, "least positive phase",
                    "each is at least the median of its column",
                    "errors of impulse and phase do not hold",
                    "Errors of peak, impulse and positive phase on the skin are "
                    "each at least the median over all places")

    def test_second_wave_at_the_probe(self):
        """Bounds the load on lungs, and is no reflection where the ground is far
        below and the skin has it at the same time."""
        folder = self.copy_without("biomechanics/fields.pvd", "blast/fields")
        measures = {"arrival": 1.8e-3, "duration": 2e-3,
                    "peak_overpressure": 3e5}
        times = tiny_scene.TIMES
        tiny_scene.write(os.path.join(folder, "coarser_blast", "summary.json"),
                         json.dumps({"application": "blast"}))
        for stage, dip in (("blast", 3e3), ("coarser_blast", 5e3)):
            over = np.interp(
                times, [1.79e-3, 1.8e-3, 2.8e-3, 2.9e-3, 3.8e-3, 4e-3],
                [0., 3e5, dip, 9e4, 0., -1e4])
            tiny_scene.write_table(
                os.path.join(folder, stage, "probes.csv"),
                {"time [s]": times, "probe_1_pressure [Pa]": 101325. + over})
            change_json(folder, stage + "/summary.json", lambda facts:
                        facts.setdefault("results", {}).update({
                            "probe_1_" + name: tiny_scene.with_unit(value, "-")
                            for name, value in measures.items()}))
        tiny_scene.write_table(
            os.path.join(folder, "blast", "load_gauges.csv"),
            {"time [s]": times, "back [Pa]": 2. * over})
        with open(os.path.join(folder, "blast", "parameters.prm"), "a",
                  encoding="utf-8") as file:
            file.write("subsection Loads\n  set Body mass = 70\nend\n")

        def told(height):
            change_json(folder, "scene.json", lambda facts: facts.update(
                probe_beside_body=[0.008, 2.337, height], height=height,
                charge_place=[2.458, 0., height]))
            scene = Scene(folder)
            scene.facts["reflections"][0]["least_delay"] = 1e-3 * height
            return scene, reflections.explaining(scene), reflections.note(scene)
        scene, explaining, note = told(1.27)
        self.assertEqual(explaining, "reflections or the second wave")
        self.assertIn("or a reflection by the ground or body", note)
        load, death = (injury_table.find(injury_table.judge(scene), name)
                       for name in ("lung_exposure_air", "lung_lethality"))
        part = (1. + 6.76 * 2. ** -1.064) / (1. + 6.76 * 1. ** -1.064)
        low, high = load.bounds()
        self.assertAlmostEqual(low / (load.value * (1. - load.error)), part, 2)
        self.assertAlmostEqual(high, load.value * (1. + load.error))
        self.assertIn(", least ", load.shown_error())
        self.assertEqual(death.bounds()[0], injury_thresholds.probability(
            "lung_lethality", low))
        scene.facts["table_comparison"].append(
            {"name": "lung_exposure", "unit": "-", "run": 2., "run_error": 0.1,
             "tables": 3., "differs": False})
        rows = {row[0]: row[1] for row in comparison.compared(scene, [load])}
        self.assertEqual([name for name, run in rows.items()
                          if ", least " in run],
                         ["duration", comparison.COMPARED["lung_exposure"]])
        self.assertIn(", least 1.00\xa0ms", rows["duration"])
        self.assertIn(f", least {low:.3g}",
                      rows[comparison.COMPARED["lung_exposure"]])
        _, explaining, note = told(20.)
        self.assertEqual(explaining, "the second wave")
        self.assertIn("own second shock, which the back has at the same time",
                      note)
        self.assertIn("; the body's reflection may raise it.", note)

    def test_minimum_on_the_skin(self):
        """Is of what follows the arrival, not of noise before it, and an upper
        limit where the pressure falls until the end."""
        folder = self.copy_without("biomechanics/fields.pvd", "blast/fields")
        times = tiny_scene.TIMES
        scene = Scene(folder)
        for place, value, minimum in ((-1, 10., "–"), (-1, -2e3, "≤ −2.00"),
                                      (-2, -2e3, "−2.00")):
            history = np.where(times < tiny_scene.BEGIN, -50., 1e5)
            history[place] = value
            gauges = Columns(time=times, chest=history)
            self.assertIn(f">{minimum}<", str(
                blast_sections._gauge_table(scene, gauges)))

    def test_walls(self):
        """Sides that reflect are named where the wave is told and judged, and
        those that are open are not."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        rows = [{"item": f"side_{side}", "decision": decision, "estimate": apart}
                for side, decision, apart in (
                    ("x_high", "wall at x = 0.64 m", "0.449 m"),
                    ("y_high", "open at y = 2 m", "1.6 m"))]
        change_json(folder, "scene.json", lambda facts: facts.update(
            plan=rows + facts.get("plan", []),
            reflections=facts["reflections"] + [
                facts["reflections"][0] | {"by": "wall at x = 0.64 m"}]))
        text = text_of(Made(folder).page)
        self.expect(text, "above the ground, detonates", "The domain has a wall at x = 0.64 m, "
                    "0.449 m from the body.", "The blast comes back from the wall "
                    "at x = 0.64 m, 0.449 m from the body: verdicts on life and "
                    "lungs", "side of the domain wall at x = 0.64 m",
                    "without ground, body and walls", "reflections by the "
                    "ground, wall at x = 0.64 m or body may add to impulse and "
                    "duration")
        self.assertNotIn("open at y", text)
        self.assertNotIn("comes back from", self.text)

    def test_surface_burst(self):
        """The tables of a charge on the ground have what the ground adds."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        change_json(folder, "scene.json", lambda facts: (
            facts.update(height=0.06, reflections=[]),
            facts["tables"].update(burst="hemispherical")))
        text = text_of(Made(folder).page)
        self.expect(text, "for a bare charge on the ground with a hemispherical "
                    "wave", ", without the body", "those of the incident wave; "
                    "reflections by the body may add to impulse and duration")
        self.assertNotIn("in free air", text)
        self.assertNotIn(") (", text)
        self.expect(self.text, "for a bare charge in free air",
                    ", without ground and body")

    def test_tables_without_a_probe(self):
        """Their answer stands alone where no probe is as far from the charge as
        the body, and is missing where they have none."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        effect = tiny_scene.EFFECT
        change_json(folder, "scene.json", lambda facts: (
            facts.update(table_comparison=[]),
            facts["tables"].update(body_mass=78.5, trunk={
                "distance": 2.51, "in_the_open": effect,
                "before_a_wall": {**effect, "lung_lethality": 0.0421}})))
        self.expect(text_of(Made(folder).page),
                    "in the open, as far as the nearest skin, 2.34 m from the "
                    "charge tables peak overpressure 314 kPa load over the 50 % lethality load at "
                    "the trunk 0.410 (0.410 before a wall) probability of death "
                    "by lung injury at the trunk less than 0.1 % (4.2 % before a "
                    "wall)", "No probe beside the body has the wave of this run",
                    "78.5 kg, at the trunk's 2.51 m. No probe")
        change_json(folder, "scene.json",
                    lambda facts: facts["tables"].update(answer=None,
                                                         trunk=None))
        self.expect(text_of(Made(folder).page), "Missing: an answer of the "
                    "tables of Kingery and Bulmash, which do not cover")

    def test_other_verdict_by_the_skin(self):
        """Without a probe, the load on the skin is compared with the tables, and
        their verdict with that of the run, in the first sentence."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")

        def told(in_the_open, before_a_wall):
            change_json(folder, "scene.json", lambda facts: (
                facts.update(
                    table_comparison=[
                        {"name": name, "place": "chest", "unit": unit,
                         "run": run, "run_error": 0.1, "tables": tables,
                         "tables_error": 0.2, "differs": differs}
                        for name, unit, run, tables, differs in (
                            ("reflected_overpressure", "Pa", 9e5, 2.25e6, True),
                            ("arrival", "s", 1.8e-3, 1.9e-3, False))],
                    plan=[{"item": "resolution", "entry": "Scene/Cell size"}]),
                facts["tables"].update(trunk={
                    "distance": 2.51, "in_the_open": {
                        "lung_lethality": in_the_open},
                    "before_a_wall": {"lung_lethality": before_a_wall}})))
            words = text_of(Made(folder).page)
            with open(os.path.join(folder, "headline.txt"),
                      encoding="utf-8") as file:
                return words, " ".join(file.read().split())
        page, lines = told(0.19, 0.9999)
        for text in page, lines:
            self.expect(text, "Survival is uncertain (death by lung injury: less "
                        "than 0.1 % by this run, 19 to 100 % by the tables at the "
                        "trunk's 2.51 m)",
                        "death with a probability of 19 % in the open and more "
                        "than 99 % before a wall at the trunk's 2.51 m, "
                        "where this run has less than 0.1 % by the load on the "
                        "skin, whose phase ends earlier than that in the open. "
                        "Trust neither "
                        "before a run with finer cells (Scene/Cell size). At "
                        "the chest, the reflected peak overpressure is 60 % "
                        "below the tables of Kingery and Bulmash")
        self.expect(page, "reflected peak overpressure at the chest 900 kPa ± 10 "
                    "% 2.25 MPa ± 20 % arrival at the chest 1.80 ms",
                    "of the reflected load on the skin of the trunk: no probe "
                    "beside the body has the wave in the open; for 24 h")
        self.assertNotIn("farther from the charge than", page)
        # Between the tables' values, and with their verdict, all is well.
        for bounds in (1e-12, 0.9), (2e-3, 0.9):
            for text in told(*bounds):
                self.assertNotIn("survival is uncertain", text.lower())
                self.expect(text, "urvives as far as lungs tell (death by lung "
                            "injury: less than")

    def test_drawing_of_the_scene(self):
        """Ways end at the skin that is nearest to the charge, and no words
        overlap wherever that is."""
        style.set_up()
        for place, end in (((2.458, 0., 1.27), 6e-3), ((-2.5, 0., 0.05), 6e-3),
                           ((0.7, 0., 1.9), 12e-3), ((0.1, 0., 2.5), 12e-3),
                           ((-20., 0., 0.3), 6e-3),
                           ((2.458, 0., 1.27), 1.9e-3)):
            scene = Scene(self.whole)
            scene.facts.update(charge_place=list(place), end_time=end,
                               distance=None)
            figure = scene_sections._draw(scene)
            self.assertEqual(labels.faults(figure), [])
            axis, = figure.axes
            way = axis.lines[0].get_xydata()
            # The length of a way stands above it, not on that by the ground.
            length, = (text for text in axis.texts if
                       text.get_color() == axis.lines[0].get_color())
            box = length.get_window_extent().transformed(
                axis.transData.inverted())
            rising = way[way[:, 0].argsort()]
            self.assertGreater(box.y0, np.interp(
                (box.x0, box.x1), rising[:, 0], rising[:, 1]).max())
            words = " ".join(text.get_text() for text in axis.texts)
            style.plt.close(figure)
            apart = np.linalg.norm(scene.loads().centroids - place, axis=1)
            self.assertAlmostEqual(np.linalg.norm(way[1] - way[0]), apart.min())
            self.assertIn(html_page.given(apart.min(), "m", 3), words)
            is_late = end < 2e-3
            self.assertEqual("above the ground" in words, is_late)
            # No wave comes from below to a crown that faces the charge.
            is_hidden = place[2] > 1.8
            self.assertEqual(scene_sections._ground_is_hidden(scene), is_hidden)
            self.assertEqual("by the ground" in words,
                             not is_late and not is_hidden)

    def test_names_of_close_moments(self):
        """The letters of dotted lines stand in one bracket at their first one,
        no letter at the line of another one."""
        style.set_up()
        figure = scene_sections._draw_timeline(
            [scene_sections.Event("air", "front", time)
             for time in (0., 5e-6, 6e-6, 5e-3)]
            + [scene_sections.Event("skin", "chest", 4e-3, 9.5e-3)])
        self.assertEqual(labels.faults(figure), [])
        self.assertEqual([(text.get_text(), text.xy[0])
                          for text in figure.axes[0].texts],
                         [("(a, b, c)", 0.), ("(d)", 5.)])
        style.plt.close(figure)

    def test_bars_of_low_pictures(self):
        """Have room for their numbers and their name."""
        style.set_up()
        x, z = np.meshgrid(np.linspace(-2., 24., 53), np.linspace(0., 5., 11))
        cuts = []
        for number in range(6):
            cut = types.SimpleNamespace(
                quantity="pressure", unit="Pa", place=0., time=1e-2 * number,
                axes="xz", values=1e5 + 4e4 * np.sin(x + z),
                extent=lambda: (-2., 24., 0., 5.))
            cuts.append(cut)
        drawn = []
        with unittest.mock.patch.object(
                style, "save", lambda figure, _: drawn.append(figure)):
            plane_cuts.draw_planes(cuts, None, True)
        self.assertEqual(labels.faults(drawn[0]), [])
        bars = [bar for axis in drawn[0].axes for bar in axis.child_axes]
        self.assertEqual(len(bars), 2)
        for bar in bars:
            name = bar.yaxis.label.get_window_extent()
            self.assertLess(name.height, 1.1 * bar.get_window_extent().height)
        style.plt.close(drawn[0])

    def test_hidden_place(self):
        """Is numbered on the body, too: a vertex that neither view shows."""
        style.set_up()
        scene = Scene(self.whole)
        views = blast_sections.views_of(scene)
        places = {"chest": scene.loads().centroids[0],
                  "hidden": scene.loads().centroids.mean(axis=0)}
        self.assertEqual([views.spot(side, places["hidden"])
                          for side in (0, 2)], [None, None])
        figure = style.plt.figure()
        body_loads._draw_places(
            figure, types.SimpleNamespace(places=lambda: places), views,
            list(places))
        self.assertEqual(
            [text.get_text() for axis in figure.axes for text in axis.texts
             ].count("2"), 1)
        style.plt.close(figure)

    def test_walls_in_the_drawing(self):
        """To scale within the picture, arrows to those beyond, words off
        the plane of the picture, and none of an open side."""
        style.set_up()
        for side, place, patches, words in (
                ("x_low", -0.4, 1, "wall at x = -0.4 m, 1 m from the body"),
                ("x_high", 9., 0, "wall at x = 9 m, 1 m from the body →"),
                ("z_high", 9., 0, "↑ wall at z = 9 m, 1 m from the body"),
                ("y_high", 0.9, 0,
                 "wall at y = 0.9 m, 1 m from the body, behind")):
            shown = []
            for kind in ("open", "wall"):
                scene = Scene(self.whole)
                scene.facts["plan"] = [{
                    "item": f"side_{side}", "estimate": "1 m",
                    "decision": f"{kind} at {side[0]} = {place:g} m"}]
                figure = scene_sections._draw(scene)
                axis, = figure.axes
                shown.append((len(axis.patches),
                              [text.get_text() for text in axis.texts]))
                self.assertEqual(labels.faults(figure), [])
                style.plt.close(figure)
            self.assertEqual(shown[1][0] - shown[0][0], patches)
            self.assertIn(words, shown[1][1])
            self.assertNotIn("wall", "".join(shown[0][1]))

    def test_verdicts(self):
        """Words for each probability, and for levels of lung injury."""
        for place, value, words in (
                ("lung_lethality", 1e-6, "survives"),
                ("lung_lethality", 0.3, "may die of lung injury"),
                ("lung_lethality", 0.995, "almost certainly dies"),
                ("ear_rupture_left ear", 0.01, "eardrums stay intact"),
                ("ear_rupture_left ear", 0.2, "eardrums may rupture (20\u00a0%)"),
                ("ear_rupture_left ear", 0.6, "eardrums probably rupture (60"
                 "\u00a0%)"),
                ("chest_wall_mean", 2., "no lung injury"),
                ("chest_wall_mean", 14., "lung injury severe")):
            known = injury_thresholds.KNOWN[
                "ear_rupture" if place.startswith("ear") else place]
            scene = types.SimpleNamespace(
                loads=lambda: None, fact=lambda name: None,
                biomechanics=types.SimpleNamespace(found=lambda *_: None),
                facts={}, measures=dict, gauge_injury=dict,
                table_answer=lambda name, *_: (0.5, 0.9)
                if name == "eardrum_rupture" else (None, None))
            found = verdict.verdicts(scene, [injury_table.Judged(
                place, value, "-", known, None, "", curve="given",
                of=0.)])
            self.assertIn(words, str(found[0]))

    def test_two_ears_with_one_word(self):
        """Their probabilities have their sides, and the tables come once."""
        known = injury_thresholds.KNOWN["ear_rupture"]
        def told(*values, tables=(0.64, 0.98)):
            ears = [injury_table.Judged(
                f"ear_rupture_{side} ear", value, "-", known, None, "",
                curve="given", of=0.) for side, value in
                    zip(("left", "right"), values)]
            for ear in ears:
                ear.tables, ear.tables_place = tables, "at the nearer ear's 2.13 m"
            return str(verdict._ears(ears)).replace("\u00a0", " ")
        by_tables = "by the tables, at the nearer ear's 2.13 m, 64 % in the open, " \
            "98 % before a wall"
        self.assertEqual(told(0.17, 0.24), "eardrums probably rupture by the "
                         "tables (left 17 % "
                         f"by this run; right 24 % by this run; {by_tables})")
        self.assertEqual(told(0.2, 0.2), "eardrums probably rupture by the "
                         f"tables (20 % by this run, {by_tables})")
        self.assertEqual(told(0.2, 0.2, tables=(0.3, 0.45)),
                         "eardrums may rupture (20 %, by the tables, at the "
                         "nearer ear's 2.13 m, 30 % in the open, 45 % before a "
                         "wall)")

    def test_ears_by_the_tables(self):
        """A finding that the tables contradict is neither worded nor marked as
        good news; an answer within the bounds contradicts nothing."""
        known = injury_thresholds.KNOWN["ear_rupture"]
        scene = types.SimpleNamespace(
            loads=lambda: None, fact=lambda name: None, measures=dict,
            gauge_injury=dict, facts={"tables": {"ears": {"distance": 2.126}}})
        for answer, kind in ((0.2, "mid"), (0.045, "good"), (None, "good")):
            scene.table_answer = lambda name, *_, low=answer: \
                (low, low and 0.98)
            ear = injury_table.Judged("ear_rupture_left ear", 0.04, "-", known,
                                      None, "", curve="given", of=0.)
            injury_table.ask_tables(scene, [ear])
            self.assertEqual(ear.tables, answer and (answer, 0.98))
            self.assertEqual(verdict._ears([ear]).kind, kind)
            self.assertEqual(injury_table.severity(ear), kind)
            row = injury_table._verdict(ear)
            self.assertEqual("s 2.13\u00a0m, 20" in row,
                             kind == "mid")
            self.assertIs(verdict.other_ears([ear]),
                          ear if kind == "mid" else None)
        # So is one with a threshold within its error.
        for error, kind in ((0.3, "mid"), (0.1, "bad"), (None, "bad")):
            self.assertEqual(injury_table.severity(injury_table.Judged(
                "", 1.2 * known.thresholds[-1][0], "Pa", known, error, "")), kind)

    def test_verdict_of_several_measures(self):
        """It is certain if each that its words are of is."""
        def told(*certain):
            return verdict.Verdict("", "w", "mid", entries=[
                types.SimpleNamespace(is_certain=lambda of=one: of)
                for one in certain]).is_certain()
        self.assertIs(told(True, True), True)
        self.assertIs(told(True, False), False)
        self.assertIs(told(None, False), False)
        self.assertIsNone(told(True, None))
        self.assertIsNone(told())
        known = injury_thresholds.KNOWN["ear_rupture"]
        # The worse ear is far above all thresholds, the other one at its first.
        ears = [injury_table.Judged(
            f"ear_rupture_{side} ear", injury_thresholds.probability(
                "eardrum_rupture", peak), "-", known, 0.2, "",
            curve="eardrum_rupture", of=peak) for side, peak in (
                ("left", 1e6), ("right", 35e3))]
        self.assertEqual([ear.is_certain() for ear in ears], [True, False])
        found = verdict._ears(ears)
        self.assertIn("right eardrum stays intact (4.9", str(found))
        self.assertIs(found.entry, ears[0])
        self.assertIs(found.is_certain(), False)
        self.assertIs(summary._verdict(found)["is_certain"], False)

    def test_part_at_a_gauge(self):
        """It is the last word of the gauge's name."""
        self.assertEqual([person.part_at(name) for name in (
            "ear", "left ear", "right_ear", "upper rear", "near")],
            ["ear", "ear", "ear", "rear", "near"])

    def test_wave_at_no_named_place(self):
        """The wave on the skin is told, and that it does not come."""
        for first, words in ((1e-3, "reaches the skin at 1.00 ms; no place"),
                             (None, "does not reach the body")):
            self.assertIn(words, scene_sections._unnamed(types.SimpleNamespace(
                loads=lambda of=first: types.SimpleNamespace(
                    first_arrival=lambda: of))).replace("\u00a0", " "))
        self.assertIn("does not reach", scene_sections._unnamed(
            types.SimpleNamespace(loads=lambda: None)))

    def test_own_thresholds(self):
        """They change verdict and words, and count as the user's own, also
        where published ones give no verdict."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        tiny_scene.write(
            os.path.join(folder, "parameters.prm"),
            "subsection Injury\n"
            "  subsection Measure Injury HIC15\n"
            "    set Thresholds = 1: headache; 5000: concussion\n"
            "    set Source = our ward\n  end\n"
            "  subsection Measure injury_intracranial_pressure_peak\n"
            "    set Thresholds = 1e9: harm\n  end\n"
            "  subsection Measure chest_wall_back\n"
            "    set Thresholds = 1: bruise\n  end\n"
            "  subsection Measure ear_rupture\n"
            "    set Thresholds = 1e-6: too loud\n  end\nend\n")
        published, own = (
            {entry.name: entry for entry in injury_table.judge(Scene(path))}
            for path in (self.whole, folder))
        hic = own["injury_hic15"]
        self.assertEqual(hic.meaning(), "headache")
        self.assertNotEqual(published["injury_hic15"].meaning(), "headache")
        self.assertEqual(hic.source, "the user's own: our ward")
        peak = "injury_intracranial_pressure_peak"
        self.assertFalse(published[peak].has_verdict)
        self.assertTrue(own[peak].has_verdict)
        self.assertEqual(injury_table.severity(own[peak]), "good")
        ear = own["ear_rupture_left ear"]
        self.assertEqual((ear.meaning(), ear.is_own), ("too loud", True))
        self.assertEqual({name for name, entry in own.items() if entry.is_own},
                         {"injury_hic15", peak} | {
                             name for name in own
                             if name.startswith("ear_rupture")})
        made = Made(folder)
        self.expect(text_of(made.page),
                    f"HIC15 of {hic.shown()} above 1 (headache)",
                    "upture of eardrums above 0.0001 % (too loud): ",
                    "1: headache 5000: concussion the user's own: our ward",
                    "judge nothing, since the table of injuries lacks "
                    "chest_wall_back.")
        with open(os.path.join(folder, "report.json"),
                  encoding="utf-8") as file:
            told = {one["name"]: one for one in json.load(file)["measures"]}
        self.assertEqual(told["injury_hic15"]["verdict"], "headache")
        self.assertTrue(told["injury_hic15"]["is_own"])
        self.assertFalse(told["injury_strain_95"]["is_own"])

    def test_own_thresholds_of_the_load_on_the_skin(self):
        """Where the wave in the open tells of the lungs, the load on the chest
        has the tables beside it if the user's own thresholds judge it."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        for text, expected in (("", None), (
                "subsection Injury\n  subsection Measure lung_exposure\n"
                "    set Thresholds = 0.5: X-ray\n  end\nend\n", (1., 2.))):
            tiny_scene.write(os.path.join(folder, "parameters.prm"), text)
            scene = Scene(folder)
            answer = scene.facts["tables"]["answer"]
            for place, load in (("in_the_open", 1.), ("before_a_wall", 2.)):
                answer[place]["lung_exposure"] = load
            with unittest.mock.patch.object(injury_table, "lungs_by",
                                            return_value="probe"):
                load = injury_table.find(injury_table.judge(scene),
                                         "lung_exposure")
            self.assertEqual(load.tables, expected)
        self.assertEqual(injury_table.severity(load), "mid")

    def test_sentences_of_own_thresholds(self):
        """They say which threshold, and on which side of it the value is."""
        def entry(name, value, limits, error=None, unit="-", place="", **more):
            known = injury_thresholds.KNOWN[name]._replace(
                thresholds=limits, is_own=True, is_exposure=False)
            return injury_table.Judged(name + place, value, unit, known, error,
                                       "", **more)

        def told(found):
            return str(found).replace("\u00a0", " ")
        low, high = [(1e-3, "low"), (0.5, "high")], [(100., "our line")]
        self.assertEqual([entry("injury_hic15", value, high).compared()
                          for value in (5886., 7.)],
                         ["above 100 (our line)", "below 100 (our line)"])
        gas = entry("injury_intracranial_pressure_lowest", -6e4,
                    [(-5e4, "gas")], unit="Pa")
        self.assertEqual([told(gas.compared(value)) for value in (None, -4e4)],
                         ["below −50 kPa (gas)", "above −50 kPa (gas)"])
        scene = types.SimpleNamespace(
            loads=lambda: None, fact=lambda name: None, measures=dict,
            facts={}, table_answer=lambda *_: (None, None))
        given = {"curve": "given", "of": 0.}
        self.assertEqual(told(verdict._life(
            scene, [entry("lung_lethality", 0.3, low, **given)])),
            "death by lung injury above 0.1 % (low): 30 %")
        self.assertEqual(told(verdict._ears([
            entry("ear_rupture", value, low, place=f"_{side} ear", **given)
            for side, value in (("left", 0.7), ("right", 0.2))])),
            "rupture of left eardrum above 50 % (high): 70 %, rupture of "
            "right eardrum above 0.1 % (low): 20 %")
        wall = [entry("chest_wall_mean", value, [(3., "slight")], 0.5, "m/s")
                for value in (2.5, 9.)]
        self.assertEqual([told(verdict._lungs([one])) for one in wall], [
            "no lung injury (chest wall velocity 2.50 m/s, below 3 m/s "
            "(slight), by the numerics 1.25 m/s to 3.75 m/s)",
            "chest wall velocity 9.00 m/s, above 3 m/s (slight)"])
        self.assertIn("of the median lethal one, above 0.001 (low)", told(
            verdict._lungs([entry("lung_exposure_air", 0.3, low)])))

    def test_warnings(self):
        """Those of all stages stand in the report, each once."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        for stage, texts in (("blast", ["late ignition"]),
                             ("biomechanics", ["late ignition", "soft skull"])):
            change_json(folder, stage + "/summary.json",
                        lambda known: known.update(warnings=texts))
        text = text_of(Made(folder).page)
        self.expect(text, "Warnings of the runs late ignition (blast and "
                    "biomechanics) soft skull (biomechanics) no coarser run of "
                    "the body (scene)")
        self.assertEqual(text.count("late ignition"), 1)

    def test_turned_person(self):
        """The front is the person's, with stature, mass and rotation."""
        folder = self.copy_without("blast/fields")
        tiny_scene.write(os.path.join(folder, "parameters.prm"),
                         "subsection Body\n  set Rotation = 0, 0, 90\nend\n")
        change_json(folder, "scene.json", lambda facts: facts["person"].update(
            description="a standing person of 1.62 m and 58 kg",
            forward=[0, 1, 0], left=[-1, 0, 0], side_to_charge="right side"))
        text = text_of(Made(folder).page)
        self.expect(text, "to the right of a standing person of 1.62 m and "
                    "58 kg", "rotation of the body 0, 0, 90 degrees",
                    "sagittal plane (x = 0)", "parallel plane, x = −0.04 m,")
        self.assertNotIn("coronal", text)
        self.assertNotIn("published simulation", text)
        scene = Scene(folder)
        views = blast_sections.views_of(scene)
        # The charge is along +x, the right side of the person.
        self.assertEqual([views.names()[side] for side in views.loaded_sides(
            scene.loads().measure("peak") * scene.loads().areas)][0], "right")

    def test_summary(self):
        """report.json has the verdict, its bounds and the figures by its schema;
        headline.txt has it in lines of a terminal."""
        path = os.path.join(self.whole, "report.json")
        self.assertEqual(summaries.flaw_of(path), "")
        with open(path, encoding="utf-8") as file:
            known = json.load(file)
        self.expect(self.text, known["headline"].replace("\u00a0", " "),
                    *(text.replace("\u00a0", " ")
                      for text in known["reservations"]))
        ears = known["verdicts"][0]
        self.assertLess(ears["least"], ears["value"])
        self.assertEqual(len(known["figures"]), self.page.count("<img"))
        with open(os.path.join(self.whole, "headline.txt"),
                  encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.assertEqual(lines, known["text"])
        self.assertLess(max(map(len, lines)), 79)

    def test_second_peak(self):
        """A value below the ambient pressure, or where the run ends, is no
        peak."""
        time = np.linspace(0., 10., 1001)
        for level, end, found in ((-0.5, -1., False), (0.5, -1., True),
                                  (-0.5, 0.5, False)):
            values = np.interp(time, [0., 1., 1.1, 3., 5., 6., 10.],
                               [0., 0., 1., -1., -1., level, end])
            self.assertEqual(signals.find_peaks(time, values)[1] is not None,
                             found)

    def test_third_front(self):
        """It is not the second one, though it is the larger rise; that is not
        an oscillation behind the first."""
        time = np.linspace(0., 10., 1001)
        for level, moment in ((0.5, 4.), (-0.7, 6.)):
            values = np.interp(time, [0., 1., 1.1, 3., 4., 5., 6., 10.],
                               [0., 0., 1., -1., level, -1., 1., 0.])
            first, second = signals.find_peaks(time, values)
            self.assertAlmostEqual(time[first], 1.1)
            self.assertAlmostEqual(time[second], moment)

    def test_rise_time(self):
        """That of the first peak, which may be below half of a later one."""
        time = np.linspace(0., 10., 1001)
        for later in (0.5, 2.5):
            values = np.interp(time, [0., 1., 2., 4., 5., 10.],
                               [0., 0., 1., 0.2, later, 0.])
            self.assertAlmostEqual(signals.rise_time(time, values), 0.8)

    def test_arrival(self):
        """The middle of the first rise, on skin and in tissue."""
        time = np.linspace(0., 4., 4001)
        for sign in (1., -1.):
            self.assertAlmostEqual(signals.arrival(time, sign * np.interp(
                time, [0., 1., 2., 3.], [0., 0., 1., 0.])), 1.53, 1)
        slow = 5e-4 * np.interp(time, [1., 2., 3.], [0., 1., 0.])
        self.assertAlmostEqual(signals.arrival_span(time, slow), 0.8, 1)
        self.assertEqual(signals.arrival_span(time, 0. * slow), 0.)
        self.assertIn("; the arrival is the middle of a rise of 800\xa0µs",
                      scene_sections._slow_rise(1e-3 * time, slow))
        self.assertEqual(scene_sections._slow_rise(1e-4 * time, slow), "")

    def test_peaks_of_every_step(self):
        """Figures have the peaks of the table, not those of samples."""
        scene = Scene(self.whole)
        gauges = scene.blast.table("load_gauges.csv")
        figure, axis = style.plt.subplots()
        told = body_loads._draw_history(
            axis, gauges, "chest", "black",
            {"peak": 912e3, "peak time": 1.85e-3})
        style.plt.close(figure)
        self.assertTrue(told.startswith("● 912 at 1.85  ▼ "), told)
        largest, later = signals.peaks_of_steps(
            np.arange(5.), np.array([0., 3., 0., 2., 0.]),
            {"peak": 3.5, "peak time": 1.01})
        self.assertEqual((largest, later), ((1.01, 3.5), (3., 2.)))

    def test_exposure(self):
        """Thresholds of an exposure give no verdict: it is neither red nor
        green, and not among those that error could change."""
        self.assertEqual(self.page.count("exposure, no verdict</span>"), 1)
        row = re.search('data-label="measure">maximum brain pressure<.*?</tr>',
                        self.page)[0]
        self.expect(row, 'class="none">exposure, no verdict', "235")
        for word in ('class="bad"', 'class="good"', 'class="mid"', "above"):
            self.assertFalse(word in row, row)
        # The other eight have thresholds, seven of them a verdict: the velocity
        # of one side has none.
        self.expect(self.text, "could change two of seven verdicts: mean chest "
                    "wall velocity and chest load")

    def test_probability(self):
        """A verdict has one, with the interval of the numerical error."""
        self.expect(self.text, "head injury of AIS 2 or worse: 44 % (43 to "
                    "45 %)")

    def test_items_of_the_answer(self):
        """Items that could change it are told in plain words."""
        self.expect(
            self.text, "Beside the body, the peak overpressure is "
            "15 % below and the impulse is 32 % below the tables of Kingery and "
            "Bulmash, by more than the errors of both; loads and verdicts carry "
            "these differences.",
            "Peak overpressure on the skin, ",
            "By the tables, 314 kPa reach an endless wall as far from the "
            "charge as the nearest skin.",
            "Materials/Tissue skin/Density 1200 kg/m^3 1100 kg/m^3",
            "268 kPa ± 4.3 % 314 kPa ± 10 %",
            "(as 1.37 times the mass of TNT for pressures, 1.19 for impulses: "
            "TM 5-855-1 (1986)), without",
            "The run assumes 3.5 MJ/kg of afterburn (at most 7.3 MJ/kg is "
            "possible), which raises the incident peak by at most 28 % and the incident "
            "impulse by at most 32 %.",
            "7.70 % of the largest internal energy of a tissue was stored in "
            "hourglass modes (limit 10 %).",
            "Beyond its limit: number of cells in the positive phase of the wave at "
            "the body (12.3; limit: at least 15).")
        answer = re.search('<div class="doubts">(.*?)</div>', self.page)[1]
        for word in ("duration", "is missing (limit"):
            self.assertFalse(word in answer, word)

    def test_reflections_that_do_not_reach_the_body(self):
        """Are no reservation of the verdict; others are told with their
        place."""
        scene = Scene.__new__(Scene)
        row = {"item": "reflection", "estimate": "0.0084 s", "found": "0.0091 s",
               "limit": "at least 0.0095 s", "holds": False}

        def limits(place, at_body):
            scene.facts = {
                "end_time": 0.0095, "reflection_at_body": at_body,
                "probe_beside_body": [0.289412, 0.5362, 0.3],
                "audit": [row | {"quantity": "first reflection from an open "
                                 f"side at the probe at {place} m"}]}
            limits = reservations._limits(scene)
            self.assertEqual(reflections.open_sides_disturb(scene),
                             bool(limits))
            return limits
        self.assertEqual(limits("3.5, 3, 1.2", 0.02), [])
        told = "Beyond its limit: arrival of a wave reflected by an open side " \
            "of the domain at the probe at {} m (0.0091 s; limit: at least " \
            "0.0095 s)."
        for place, at_body in (("3.5, 3, 1.2", 0.009), ("3.5, 3, 1.2", None),
                               ("0.2894, 0.5362, 0.3", 0.02)):
            self.assertEqual(limits(place, at_body), [told.format(place)])

    def test_limits_of_what_was_not_measured(self):
        """An estimate beyond its limit is named as such."""
        row = {"quantity": "cells", "estimate": "6.6", "found": "unknown",
               "limit": "at least 10", "holds": False}
        scene = types.SimpleNamespace(list_of=lambda _: [row])
        self.assertEqual(reservations._limits(scene), [
            "Beyond its limit: cells (estimated at 6.6, not measured; limit: "
            "at least 10)."])
        row["quantity"] += ", not measured, since there is no probe"
        self.assertEqual(reservations._limits(scene), [
            "Beyond its limit: cells, not measured, since there is no probe "
            "(estimated at 6.6; limit: at least 10)."])
        self.assertIn(">no<", str(accuracy._planned(row)[6]))

    def test_loads_on_other_surface(self):
        """Impulses that differ by more than two per cent along the recorded one
        are named."""
        for mapped, told in (
                (118., ""),
                (136., "get 114.9 % of the impulse that was recorded on the "
                 "skin.")):
            checks = {"loads_largest_recorded_impulse": 118.4,
                      "loads_largest_mapped_impulse": mapped}
            scene = types.SimpleNamespace(
                biomechanics=types.SimpleNamespace(
                    found=lambda _, name: checks.get(name)))
            found = " ".join(reservations._loads(scene)).replace("\xa0", " ")
            self.assertEqual(bool(found), bool(told))
            self.assertIn(told, found)

    def test_loads_at_the_end_of_the_record(self):
        """Impulses that agree when they are largest may differ at the end, and
        across the largest one."""
        for mapped_z, told in ((7., ""), (
                9.72, "At the end of the record its components are (−98.2, 0, "
                "6.99) N s recorded and (−98.7, 0, 9.72) N s on the elements.")):
            checks = {"loads_largest_recorded_impulse": 127.,
                      "loads_largest_mapped_impulse": 127.}
            for name, parts in (("recorded", (-98.17, 0., 6.99)),
                                ("mapped", (-98.71, 0., mapped_z))):
                for axis, part in zip("xyz", parts):
                    checks[f"loads_{name}_impulse_{axis}"] = part
            scene = scene_of_checks(checks)
            said = " ".join(accuracy._checks(scene)).replace("\xa0", " ")
            self.assertIn(told, said)
            self.assertEqual("At the end" in said, bool(told))

    def test_loads_from_both_sides(self):
        """Pushes that cancel have no time when their impulse is largest."""
        checks = {"loads_largest_recorded_impulse": 100.,
                  "loads_largest_mapped_impulse": 99.,
                  "loads_impulse_factor": 1., "loads_pushes_cancel": 1.}
        scene = scene_of_checks(checks)
        self.assertIn(
            "100 N s recorded on the whole body at the end in magnitudes, as pushes from "
            "opposite sides cancel, 99.0 N s on the elements",
            " ".join(accuracy._checks(scene)).replace("\xa0", " "))
        self.assertEqual(reservations._loads(scene), [])
        # The push left on the elements is twice the recorded one.
        for recorded, mapped, difference in ((6., 12., 1.), (0., 1., math.inf),
                                             (0., 0., 0.)):
            checks.update(loads_largest_recorded_push=recorded,
                          loads_largest_mapped_push=mapped)
            self.assertEqual(load_impulses.difference_of_motion(scene),
                             difference)
            said = " ".join(reservations._loads(scene)).replace("\xa0", " ")
            self.assertEqual(bool(said), difference > 0., said)
            if recorded:
                self.expect(said, "is largest, 6.00 N s, its elements received "
                            "12.0 N s")
                self.expect(" ".join(accuracy._checks(scene)).replace(
                    "\xa0", " "), "leaves 6.00 N s of the recorded one when that "
                    "is largest, 12.0 N s on the elements")

    def test_errors_have_that_of_the_loads(self):
        """Results in the body are known no better than its impulse, even if
        both runs agree."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        path = os.path.join(folder, "biomechanics", "summary.json")
        with open(path, encoding="utf-8") as file:
            text = file.read()
        self.assertIn("118.3", text)
        tiny_scene.write(path, text.replace("118.3", "177.6"))
        errors = {entry.name: entry.error
                  for entry in injury_table.judge(Scene(folder))}
        self.assertGreaterEqual(errors["injury_strain_95"], 0.5)
        self.assertLess(errors["ear_rupture_left ear"], 0.5)

    def test_model_bias(self):
        """Is told with its sign, and where it was not measured why."""
        def told(*rows):
            known = [{"item": f"model_bias_{name}", "estimate": value,
                      "decision": why} for name, value, why in rows]
            scene = types.SimpleNamespace(list_of=lambda _: known)
            return " ".join(reservations._model_bias(scene)).replace("\xa0", " ")
        self.assertIn("a peak 5 % below, an impulse 8 % above and a duration "
                      "31 % below the tables",
                      told(("peak", "-0.05", ""), ("impulse", "0.08", ""),
                           ("duration", "-0.31", "")))
        self.assertIn("is unknown: nobody measured it.", told(
            *((name, "unknown", "nobody measured it")
              for name in ("peak", "impulse", "duration"))))
        self.assertEqual(told(), "")

    def test_no_afterburn(self):
        """A balanced explosive has no sentence on effects of nothing."""
        row = {"item": "afterburn", "decision": "left out, by explosive"}
        rows = [row] + [{"item": f"afterburn_{name}", "estimate": "0"}
                        for name in ("peak", "impulse")]
        scene = types.SimpleNamespace(
            list_of=lambda name: rows if name == "audit" else [])
        self.assertEqual(reservations._afterburn(scene), [
            "The run has no afterburn: the explosive's own oxygen burns it."])
        # The oxygen of a user's own explosive is unknown.
        row["decision"] = ("left out by the values of ANFO (Like); it is "
                           "unknown for this explosive")
        for effect in rows[1:]:
            effect["estimate"] = "unknown"
        self.assertEqual(reservations._afterburn(scene),
                         [f"Afterburn is {row['decision']}."])
        row["decision"] = ("1 of at most 2 MJ/kg by the heat of combustion of "
                           "ANFO (Like), Miller's rate, by Like")
        self.assertIn("(at most 2 MJ/kg is possible by the heat of combustion "
                      "of ANFO (Like))", reservations._afterburn(scene)[0])

    def test_other_items_of_the_answer(self):
        """A longer phase on the skin, a place that no blast has reached,
        missing energy, a tissue with hourglass energy, no afterburn."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        for name, before, after in (
                ("biomechanics/summary.json",
                 '"energy_residual": {"value": 3.5e-06',
                 '"hourglass_part_skeleton": {"value": 0.219, "unit": "-"}, '
                 '"energy_residual": {"value": -0.0212'),
                ("blast/gauge_measures.csv",
                 "back,0.0018,200000.0,0.0018,76.0,0.001,0",
                 "back,nan,nan,nan,nan,nan,0"),
                ("scene.json", "3.5 of at most 7.3 MJ/kg, Miller's rate, by "
                 "explosive", "left out")):
            path = os.path.join(folder, name)
            with open(path, encoding="utf-8") as file:
                text = file.read()
            self.assertIn(before, text)
            tiny_scene.write(path, text.replace(before, after))
        text = text_of(Made(folder).page)
        self.expect(
            text, "2.12 % of the body's energy is missing (limit 1 %) and 21.9 % of "
            "the largest internal energy of a tissue was stored in hourglass "
            "modes (limit 10 %), 21.9 % in skeleton: stresses there are less "
            "certain.",
            "The run leaves out afterburn, which would raise the incident "
            "peak by at most 28 %")

    def test_nothing_is_judged_without_a_limit(self):
        """No number without a limit has a "yes", whatever the file says."""
        section = self.page[self.page.index("Assumptions</h2>"):]
        rows = re.findall("<tr>(?:<td.*?</td>)+</tr>",
                          section[:section.index("</section>")])
        self.assertEqual(len(rows), 7)
        for row in rows:
            limit = re.search('data-label="limit">(.*?)</td>', row)[1]
            holds = re.search('data-label="holds">(.*?)</td>', row)[1]
            self.assertEqual("not judged" in holds, limit == "–", row)
        self.assertEqual(sum('"good">yes' in row for row in rows), 2)
        self.assertEqual(sum('"bad">no<' in row for row in rows), 1)

    def test_errors(self):
        """Differences to the coarser run over r^0.7 - 1: of the strain half
        its value, which passes the threshold of mild injury."""
        times = 1. / (2. ** 0.7 - 1.), 1. / ((5. / 3.) ** 0.7 - 1.)
        # The first one is that of the chest's peak.
        for error in (0.2 * times[0], 0.1 * times[1], 0.02):
            shown = html_page.percent(error).replace("\u00a0", " ")
            self.expect(self.text, f"± {shown}")
        self.expect(self.text, "Numerical error could change")
        alone = text_of(Made(self.copy_without("coarser_blast",
                                               "coarser_biomechanics")).page)
        self.expect(alone, "is unknown: the scene has no coarser run",
                    "error unknown")

    def test_errors_that_are_unknown(self):
        """Each verdict counts, also one of unknown error among others."""
        def entry(name, certain):
            return types.SimpleNamespace(
                name=name, has_verdict=True, is_certain=lambda: certain,
                short_title=lambda: name)
        run = types.SimpleNamespace(blast=types.SimpleNamespace(exists=True))
        scene = types.SimpleNamespace(coarser=run, has_own_mesh=lambda: False)
        words = reservations._verdicts(scene, [
            entry("ear", True), entry("lung", False), entry("chest", None)])
        self.assertEqual(words, ["Numerical error could change one of three "
                                 "verdicts: lung; it is unknown of chest: the "
                                 "coarser run has no complete value of it."])

    def test_lungs_by_the_worse_measure(self):
        """A load above its threshold counts where the chest wall is slow; that
        on the skin, which is reflected, only without one in the open."""
        def judged(name, value, *thresholds):
            return injury_table.Judged(
                name, value, "-", injury_thresholds.Known(
                    name, list(thresholds), "", ""), None, "")
        wall = judged("chest_wall_mean", 2.77, (3.6, "trace or slight injury"))
        limit = 0.2, "threshold of lung injury"
        skin = judged("lung_exposure_back", 0.25, limit)
        for load, words in ((0.216, "lung injury possible"),
                            (0.19, "no lung injury")):
            air = judged("lung_exposure_air", load, limit)
            found = verdict._lungs([wall, skin, air])
            self.assertEqual(found.words, words)
        self.assertEqual(verdict._lungs([wall, skin]).words,
                         "lung injury possible")
        self.assertNotIn(verdict.UNSURE, str(verdict._lungs([wall, skin])))
        skin.error = 0.5
        self.assertIn(verdict.UNSURE, str(verdict._lungs([wall, skin])))
        # A load that the end of the run cuts off may yet exceed it.
        cut = injury_table.Judged(
            "lung_exposure_back", 0.1, "-", injury_thresholds.Known(
                "", [limit], "", ""), None, "", is_cut=True)
        self.assertEqual(verdict._lungs([wall, cut]).words, "lungs not judged")
        wall.value = 4.
        self.assertEqual(verdict._lungs([wall, cut]).words,
                         "lung injury trace to slight injury")
        # "None" by the numerics of one measure, while the other one excludes it.
        wall.error, air.value, air.error = 0.25, 0.28, 0.1
        self.assertIn("none to slight injury; the load on the lung is "
                      "above the threshold of lung injury",
                      str(verdict._lungs([wall, air])))
        air.error = 0.5
        self.assertNotIn("the load on the lung", str(verdict._lungs([wall, air])))
        # Without a gauge at chest and back the load alone decides, or nothing.
        self.assertEqual(verdict._lungs([skin]).words, "lung injury possible")
        mesh = judged("injury_chest_wall_velocity_mesh", 1.)
        self.assertEqual(verdict._lungs([mesh]).words, "lungs not judged")
        self.assertIsNone(verdict._lungs([]))

    def cut_off(self, *changes):
        """A copy of the scene whose run ends before all loads on the skin do,
        with changes of what it found."""
        folder = self.copy_without("biomechanics/fields.pvd", "blast/fields")
        path = os.path.join(folder, "blast", "gauge_injury.csv")
        with open(path, encoding="utf-8") as file:
            found = file.read()
        for before, after in changes:
            self.assertIn(before, found)
            found = found.replace(before, after)
        head, *rows = found.splitlines()
        tiny_scene.write(path, "\n".join(
            [head + ",cut off [-]", *(row + ",1" for row in rows)]) + "\n")
        return folder

    def test_loads_that_the_end_cuts(self):
        """Their measures are lower limits in all that a scene says, and no
        verdict where they are below all thresholds."""
        mild = (("6.632", "1.2"), ("0.26398", "0.1"), ("0.78773", "0.01"))
        folder = self.cut_off(*mild)
        change_json(folder, "scene.json", lambda facts: facts["tables"].update(
            trunk={"distance": 2.34, "in_the_open": {"lung_lethality": 0.021},
                   "before_a_wall": {"lung_lethality": 0.73}}))
        made = Made(folder)
        self.assertEqual(made.code, 0, made.errors)
        self.expect(
            text_of(made.page), "Survival not judged (the run ends before the "
            "positive phase does; death by lung injury by the tables at the "
            "trunk's 2.34 m: 2.1 to 73 %)", "eardrums not judged (≥ 1.0 %, by the "
            "tables 95 %); lungs not judged (the run ends too early)",
            "≥ 1.20 m/s", "≥ 0.100", "not judged: the run ends too early",
            "The run ends too early, after 6 ms: rupture probability of the left "
            "eardrum, mean chest wall velocity, chest load over the 50 % "
            "lethality load, probability of death by lung injury and other "
            "measures with ≥ are lower limits, and later extremes of the rest "
            "are unknown; a "
            "later Scene/End time gives all of it")
        folder = self.cut_off(*mild)
        Made(folder)
        with open(os.path.join(folder, "report.json"),
                  encoding="utf-8") as file:
            told = json.load(file)
        self.assertEqual({one["name"] for one in told["measures"]
                          if one["is_lower_limit"]},
                         {one["name"] for one in told["measures"]
                          if not one["name"].startswith("injury_")})
        self.assertEqual({one["severity"] for one in told["measures"]
                          if one["is_lower_limit"]}, {"none"})
        # Thresholds exceeded already stay so.
        self.expect(text_of(Made(self.cut_off()).page),
                    "eardrums probably rupture (≥ 79 %",
                    "lung injury trace to moderate or worse")
        self.assertNotIn("lower limit", self.text.replace(
            "their values are lower limits", ""))

    def test_lungs_in_the_open_of_a_run_that_ends_early(self):
        """The load next to the body decides where that on the skin is cut."""
        folder = self.cut_off(("6.632", "1.2"))
        change_json(folder, "scene.json", lambda facts: facts.update(
            probe_beside_body=[0.008, 2.337, 1.27]))
        path = os.path.join(folder, "blast", "probe_injury.csv")
        with open(path, encoding="utf-8") as file:
            found = file.read()
        tiny_scene.write(path, found.replace("0.4321", "0.12"))
        self.expect(text_of(Made(folder).page), "Survives as far as lungs tell (", "no lung injury "
                    "(by the load alone, 0.120 of the median lethal one")

    def test_ground_below_the_body(self):
        """That biomechanics leaves it out may change the verdict."""
        scene = types.SimpleNamespace(list_of=lambda _: [
            {"item": "rigid_body"}])
        self.assertEqual(reservations._ground(scene), [])
        scene.list_of = lambda _: [{"item": "ground_of_body"}]
        self.assertIn("leaves out the ground", reservations._ground(scene)[0])

    def test_brains_that_are_held_have_no_verdict(self):
        for value in (1., 0., None):
            stage = types.SimpleNamespace(found=lambda group, name: {
                ("checks", "brain_is_held"): value}[group, name])
            found = verdict._held(types.SimpleNamespace(biomechanics=stage))
            self.assertEqual(found is not None, value == 1., value)

    def test_lungs_by_the_tables(self):
        """Where one of run and tables alone has a load above the threshold, that
        is said, of the load on the trunk by its own distance: the tables' is
        between that in the open and before a wall."""
        def words(name, value, in_the_open, *at_trunk):
            load = injury_table.Judged(
                name, value, "-", injury_thresholds.Known(
                    "load", [(0.2, "threshold of lung injury")], "", ""), None,
                "")
            scene = types.SimpleNamespace(
                table_answer=lambda _, where="answer":
                at_trunk if where == "trunk" else (in_the_open, None), facts={},
                list_of=lambda _: [], gauge_injury=dict, coarser=None)
            with unittest.mock.patch.object(
                    injury_table, "lungs_by",
                    lambda _: "skin" if at_trunk else "probe"):
                return (str(verdict._by_tables(scene, [load],
                                               verdict._lungs([load]))),
                        " ".join(reservations._tables(scene, [load])))
        for load, tables in (
                (("lung_exposure_air", 0.107), (0.21,)),
                (("lung_exposure", 0.107), (0.5, 0.21, 0.9)),
                (("lung_exposure", 0.107), (0.1, 0.21, 0.9))):
            told, doubt = words(*load, *tables)
            place = " in the open" if tables[1:] == (0.21, 0.9) \
                and load[1] < 0.21 else ""
            self.assertIn("by the tables lung injury possible, load 0.210"
                          + place, told)
            self.assertIn(f"is 0.210{place}, above the threshold of lung injury "
                          "of 0.2, where this run has 0.107, below it", doubt)
        told, doubt = words("lung_exposure_air", 0.25, 0.15)
        self.assertIn("by the tables no lung injury, load 0.150", told)
        self.assertIn("is 0.150, below the threshold", doubt)
        told, doubt = words("lung_exposure", 0.107, 0.5, 0.15, 0.5)
        self.assertIn("possible, load 0.500 before a wall", told)
        self.assertIn("is 0.500 before a wall, above the threshold", doubt)
        for load, *tables in ((("lung_exposure_air", 0.107), 0.15),
                              (("lung_exposure_air", 0.107), None),
                              (("lung_exposure_air", 0.25), 0.3),
                              (("lung_exposure", 0.107), 0.5, 0.1, 0.5),
                              (("lung_exposure", 0.25), 0.5, 0.15, 0.5),
                              (("lung_exposure", 0.107), 0.5, None, None)):
            for text in words(*load, *tables):
                self.assertNotIn("tables", text)

    def test_sides_that_the_front_grazes(self):
        """Are among what could change the verdict."""
        scene = types.SimpleNamespace(warnings=lambda: {
            "grazed side: the front runs along A": ["blast"], "skin: a": []})
        self.assertEqual(reservations._grazed_sides(scene),
                         ["The front runs along A."])

    def test_lungs_of_a_phase_that_is_cut(self):
        """Are sound so far where life is not judged."""
        for life, words, kind in ((verdict.UNJUDGED, "no lung injury so far",
                                   "none"), ("survives", "no lung injury", "good")):
            told = {"_life": verdict.Verdict("life", life, "none"),
                    "_ears": None, "_held": None, "_brain": None,
                    "_by_tables": verdict.Verdict("lungs", verdict.SOUND, "good")}
            with unittest.mock.patch.multiple(verdict, **{
                    name: lambda *_, one=one: one
                    for name, one in told.items()}):
                lungs = verdict.verdicts(types.SimpleNamespace(facts={}), [])[1]
            self.assertEqual((lungs.words, lungs.kind), (words, kind))

    def test_lungs_beside_the_tables_at_the_trunk(self):
        """Where the trunk is farther off than the nearest skin, the first screen
        has the load on its skin with its error, and both of the tables."""
        scene = Scene(self.whole)
        effect = tiny_scene.EFFECT
        scene.facts["tables"]["trunk"] = {
            "distance": 3., "in_the_open": effect,
            "before_a_wall": {**effect, "lung_exposure": 0.9}}
        with unittest.mock.patch.object(injury_table, "is_trunk_far",
                                        lambda _: True):
            judged = injury_table.judge(scene)
            rows = {row[0]: row[1:] for row in comparison.compared(scene, judged)}
        load = next(entry for entry in judged
                    if entry.name.startswith("lung_exposure"))
        run, tables = rows["load over the 50\u00a0% lethality load at the trunk"]
        self.assertEqual(run, f"{load.shown()} {html_page.error(load.error)}")
        self.assertEqual(tables, "0.410 (0.900 before a wall)")

    def test_curves_of_head_injury_keep_their_order(self):
        """AIS 3 or worse includes AIS 4, where the fits cross, too."""
        chances = [injury_thresholds.probability(f"hic15_ais{level}", 8246.)
                   for level in (2, 3, 4)]
        self.assertEqual(chances, sorted(chances, reverse=True))

    def test_gauge_named_back_is_no_chest(self):
        """A box with a gauge of that name has no lungs."""
        box = types.SimpleNamespace(
            facts={"person": {"description": "a shape"}}, measures=dict,
            gauge_injury=lambda: {("lung_exposure", "back"): 0.04})
        self.assertFalse(injury_table.has_chest(box))
        box.facts["person"]["posture"] = "standing"
        self.assertTrue(injury_table.has_chest(box))

    def test_errors_of_zero(self):
        """The coarser run bounds a measure that is zero in this one."""
        known = injury_table.Known("fraction of the brain", [], "", "")
        entry = injury_table.Judged("injury_part", 0., "-", known, math.inf, "",
                                    0.018)
        self.assertEqual(entry.bounds(), (0., 0.018))
        self.assertIn("1.8", entry.shown_error())
        entry = injury_table.Judged("injury_dose", 0., "s", known._replace(
            title="dose"), math.inf, "", 2e-5)
        self.assertTrue(entry.shown_error().startswith("up to 20"))
        entry = injury_table.Judged("injury_part", 0., "-", known, 0., "", 0.)
        self.assertEqual(entry.bounds(), (0., 0.))
        self.assertIn("too", entry.shown_error())

    def test_checks(self):
        """Oscillation between elements is a check, no injury."""
        self.expect(self.text, "by 0.52 times its averages",
                    "118 N s recorded on the whole body when it is largest, "
                    "118 N s along it on the elements (−0.084 %), after all "
                    "pressures were "
                    "multiplied by 0.984 so that",
                    "(0.008, 2.337, 1.27) m, 3.39 m from the charge")
        self.assertFalse("over its averages" in self.text)

    def test_parasagittal(self):
        self.expect(self.text, "parallel plane, y = 0.04 m, through "
                    "skeleton, brain and lung, with one")

    def test_signals(self):
        """A wave whose turning points are known; runs that end after and in its
        positive phase."""
        time = np.linspace(0., 4., 4001)
        values = np.where(time > 1., np.cos(np.pi * (time - 1.)), 0.)
        tops, dips = signals.extrema(time, values, 0.5)
        self.assertEqual([round(x, 2) for x, _ in tops + dips],
                         [1., 3., 2.])

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
                    "5.5 kg of C-4", "3.25 m/s",
                    "eardrums probably rupture by the tables (13 % by this "
                    "run, by the numerics 58 to 89 %, by the tables 95 %)")

    def test_lying_person(self):
        """Cuts are those of the standing person, of the head, too."""
        scenes = []
        for angles in ("0, 0, 0", "0, -90, 0", "0, 0, 90", "10, -70, 20"):
            axes = person.turned_axes({"Body/Rotation": angles})
            folder = self.copy_without("blast/fields")
            change_json(folder, "scene.json", lambda facts, axes=axes:
                        facts["person"].update(zip(
                            ("forward", "left", "up"), axes.tolist())))
            for number in range(3):
                tiny_scene.write_mesh(os.path.join(
                    folder, f"biomechanics/fields/solid_{number:04d}.vtu"),
                    2e3 * number, axes=axes)
            scenes.append(Scene(folder))
            # Without what scene knows of the person.
            alone = Scene(folder)
            alone.facts = {}
            alone.biomechanics.parameters.update({
                "Body/Rotation": angles, "Body/Kind": "phantom",
                "Mesh/Kind": "body"})
            scenes.append(alone)
        with unittest.mock.patch.object(html_page, "render",
                                        damage_test.paint_roughly), \
                unittest.mock.patch.object(style, "save",
                                           damage_test.draw_nothing):
            words = [text_of("".join(map(str, body_sections.waves(scene))))
                     for scene in scenes]
        for scene, text in zip(scenes, words):
            self.expect(text, "Pressure in the head, in the sagittal plane",
                        "each element of the head over the whole run")
            self.assertEqual("drawn with the head up" in text,
                             person.axes(scene)[2, 2] < 0.99)
        areas = []
        for scene in scenes:
            pieces = scene.field_list()[1][1]
            frame = body_sections._frame(scene, pieces)
            shape, values = fields.cut_values(pieces, frame.middle + 1e-4,
                                              "pressure", frame.axes)
            low = body_cuts.limits([shape], True)[1][0]
            head = shape[:, :, 1].max(axis=1) > low
            area = 0.5 * np.abs(np.cross(
                shape[:, 2] - shape[:, 0], shape[:, 3] - shape[:, 1]))
            areas.append([(area * values)[part].sum() / area[part].sum()
                          for part in (head, ~head)] + [area.sum()])
        np.testing.assert_allclose(areas, [areas[0]] * len(areas), 1e-4)

    def test_whole_body_is_no_top(self):
        """A head alone is drawn whole, as shape or mesh of unknown kind."""
        for kind, height, words in (
                ("shape", 0.15, "body"), ("shape", 1.7, "top of the body"),
                ("mesh", 0.25, "body"), ("image", 0.25, "head"),
                ("phantom", 1.7, "head")):
            self.assertEqual(body_sections._top(
                types.SimpleNamespace(facts={"body": kind}),
                types.SimpleNamespace(height=height)), words)

    def test_unfinished_stage(self):
        """How far it has come stands at the sections that show it; a stage that
        the scene has not asked for is not shown."""
        folder = self.copy_without("blast/fields", "biomechanics/fields.pvd")
        change_json(folder, "biomechanics/summary.json", lambda facts:
                    facts.update(status="stopped", time=5.1e-3))
        text = text_of(Made(folder).page)
        words = ("he stage biomechanics is unfinished (stopped), at 5.10 ms of "
                 "6.00 ms: extremes")
        # The items that could change the verdict, and four sections.
        self.assertEqual(text.count(words), 5, text[:3000])
        self.assertNotIn("unfinished", self.text)
        change_json(folder, "scene.json", lambda facts: facts.update(
            question="loads", stages=[
                stage for stage in facts["stages"]
                if not stage["name"].endswith("biomechanics")]))
        text = text_of(Made(folder).page)
        for words in ("unfinished", "Stress waves", "Histories in the tissue",
                      "Energy of the body", "HIC15", "biomechanics/"):
            self.assertNotIn(words, text)

    def test_head_alone(self):
        """No lungs and legs in it, no places named on it, and brain where
        thinner parts were looked for."""
        folder = self.copy_without("blast/load_gauges.csv",
                                   "blast/gauge_injury.csv",
                                   "blast/gauge_measures.csv",
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
        tiny_scene.write_history(os.path.join(folder, "biomechanics"),
                                 ("gelatin",))
        made = Made(folder, paints=True)
        self.assertEqual(made.code, 0, made.errors)
        words = text_of(made.page)
        self.expect(words, "parallel plane, y = 0.04 m, through brain, ",
                    "no place was named",
                    "this body has neither a brain nor a chest",
                    "spinal cord (an element of brain)", "2 m² of skin.",
                    "in front of a standing person", "ends where the images end")
        self.assertFalse("load_gauges.csv" in words)
        self.assertFalse("contrecoup (an" in words)

    def test_thin_tissue(self):
        """Places in tissues for which elements are too large have a mark, and
        no statement takes their pressures."""
        def words_of(**thin):
            folder = self.copy_without()
            change_json(folder, "biomechanics/summary.json", lambda facts:
                        facts["checks"].update(thin))
            return folder, text_of(Made(folder).page)
        folder, words = words_of(thin_brain=tiny_scene.with_unit(1., "-"))
        self.expect(words, "brain, coup †", "brain, contrecoup †")
        # At the chart of events and at the table of extremes.
        self.assertEqual(words.count("† The elements are too large"), 2)
        brain = tissue_places.BRAIN
        self.assertNotIn(brain, body_sections.tissue_pressures(Scene(folder)))
        # The skull is a layer, which the rest of its tissue is not.
        folder, _ = words_of(thin_skull=tiny_scene.with_unit(1., "-"))
        bones = [tissue_places.Place(number, None, tissue_places.SKELETON, name)
                 for number, name in enumerate(("skull", "pelvis"), 1)]
        with unittest.mock.patch.object(tissue_places, "_named_places",
                                        return_value=bones):
            self.assertEqual([place.title() for place in
                              tissue_places.find_places(Scene(folder))],
                             ["skull †", "pelvis"])
        folder, words = words_of()
        self.assertNotIn("†", words)
        self.assertIn(brain, body_sections.tissue_pressures(Scene(folder)))

    def test_own_hexahedra(self):
        """Tissues of the user's own have their names, and a box has no head."""
        folder = self.copy_without("blast/fields")
        change_json(folder, "scene.json",
                    lambda facts: facts.update(body="mesh"))
        tiny_scene.write(os.path.join(folder, "anatomy", "parts.csv"),
                         "part,name,tissue,tissue name\n0,SHELL,13,acrylic\n")
        for number in range(3):
            tiny_scene.write_mesh(os.path.join(
                folder, f"biomechanics/fields/solid_{number:04d}.vtu"),
                2e3 * number, 0.2, 13)
        words = text_of(Made(folder).page)
        self.expect(words, "y = 0.04 m, through acrylic, with one", "acrylic 1",
                    "Extremes of each element of the body")
        self.assertNotIn("other tissue", words)

    def test_loaded_sides(self):
        """The loaded side and the front, unless another has a tenth more."""
        scene = Scene(self.whole)
        views = body_views.views_of(scene.loads(), scene.blast.folder)
        front, left = views.normals[:, 0], views.normals[:, 1]
        for back, beside in ((1.05, 0), (1.2, 2)):
            self.assertEqual(views.loaded_sides(
                3. * (left < -0.9) + (front > 0.9) + back * (front < -0.9)),
                (3, beside))

    def test_silhouette(self):
        """A box has straight sides: its facets are no patches beyond them."""
        path = os.path.join(self.copy_without(), "blast", "loads.h5")
        axes = np.repeat([0, 1], 2)
        normals = np.zeros((4, 3))
        normals[range(4), axes] = 1., -1., 1., -1.
        vertices = np.array([[x, y, z] for x in (-1., 1.) for y in (-1., 1.)
                             for z in (-1., 1.)])
        corners = [[4, 6, 7, 5], [0, 1, 3, 2], [2, 3, 7, 6], [0, 4, 5, 1]]
        with h5py.File(path, "a") as file:
            for name in list(file):
                if len(file[name]) == 144:
                    values = file[name][:4]
                    del file[name]
                    file[name] = values
            file["centroid"][:] = file["normal"][:] = normals
            file["area"][:] = 4.
            file["vertex"] = vertices
            file["connectivity"] = np.ravel([[3, 4, *one] for one in corners])
        views = body_views.BodyViews(loads.Loads(path), [])
        for side in views.sides:
            shown = side.total.reshape(side.shape) > 0.
            wide = np.count_nonzero(shown.any(axis=0)) * views.pixel
            self.assertAlmostEqual(wide, 2., delta=2. * views.pixel)
            self.assertEqual(np.count_nonzero(shown), np.count_nonzero(
                shown.any(axis=0)) * np.count_nonzero(shown.any(axis=1)))
        self.assertEqual(views.bare_part(), 0.)
        # Gaps that small patches leave on a side are skin with gas.
        with h5py.File(path, "a") as file:
            file["area"][:] = 3.
        views = body_views.BodyViews(loads.Loads(path), [])
        self.assertGreater(np.count_nonzero(views.sides[0].gaps), 0)
        self.assertEqual(views.bare_part(), 0.)
        gap = np.zeros((5, 5), bool)
        gap[1:4, 1:4] = True
        picture = np.where(gap, 1., 0.5)[:, :, None] * np.ones(3)
        body_views._close(picture, ~gap, gap)
        self.assertTrue(np.all(picture == 0.5))
        # A side on the ground has no facets: it is seen grey, not white.
        with h5py.File(path, "a") as file:
            file["normal"][0] = -1., 0., 0.
        views = body_views.BodyViews(loads.Loads(path), [])
        self.assertEqual(views.bare_part(), 1.)
        front = views.paint_side(0)
        self.assertTrue(np.all(front[views.sides[0].silhouette]
                               == body_views.BARE))
        for flaw in ([3, 4, 0, 1, 2, 8] * 4, [3, 4, 0, 1, 2, 3] * 3,
                     [3, 4, 0, 1, 2, 3] * 3 + [3, 9, 0, 1]):
            with h5py.File(path, "a") as file:
                del file["connectivity"]
                file["connectivity"] = flaw
            self.assertRaises(ValueError, loads.Loads, path)

    def test_times_with_waves(self):
        """Pictures begin when waves arrive and end with them."""
        scene = Scene(self.whole)
        history = scene.biomechanics.table("history.csv")
        outputs = [(time, []) for time in np.linspace(0., 4e-3, 41)]
        arrival = history["time"][np.argmax(history["stored_energy"] > 0.)]
        found = wave_times.of_body(outputs, history, None)
        self.assertLess(abs(found[0][0] - arrival), 2e-4)
        self.assertEqual(found[-1], outputs[-1])
        calm = tables.Table(os.path.join(scene.biomechanics.folder,
                                         "history.csv"))
        calm.values[:, calm.names.index("stored_energy")] = np.where(
            (calm["time"] > 1e-3) & (calm["time"] < 2e-3), 1., 1e-4)
        found = wave_times.of_body(outputs, calm, None)
        self.assertTrue(1e-3 < found[0][0] < found[-1][0] < 2e-3)
        # Where a hand is struck before the chest is.
        late = {"time": calm["time"], "probe_1_pressure": np.where(
            calm["time"] > 1.6e-3, 1e5, 1e3)}
        found = wave_times.of_body(outputs, calm, Columns(late))
        self.assertGreater(found[0][0], 1.6e-3)
        self.assertEqual(wave_times.of_body(outputs, None, None), outputs)
        cuts = scene.pressure_planes()["plane_y_0_pressure"]
        still = [types.SimpleNamespace(values=np.full((3, 4), 101325.))] * 3
        self.assertEqual(wave_times.of_planes(still + cuts + still), cuts)
        self.assertEqual(wave_times.of_planes(still), still)
        self.assertEqual(wave_times.denser(range(30), 4, 2.), [0, 3, 12, 29])

    def test_blast_that_does_not_arrive(self):
        """Where nothing is to be seen, a line says why; what is not known of a
        part of the skin is left out."""
        peaks = Scene(self.whole).loads().measure("peak")
        for facets, unknown, count in ((slice(3), np.nan, 0),
                                       (slice(None), np.nan, 3),
                                       (slice(None), 0., 3)):
            folder = self.copy_without()
            path = os.path.join(folder, "blast", "loads.h5")
            with h5py.File(path, "r+") as file:
                for name in ("arrival", "peak", "impulse"):
                    file[name][facets] = unknown
            known = loads.Loads(path)
            self.assertEqual(np.isnan(known.measure("peak")).sum(),
                             3 if count == 0 else len(peaks))
            self.assertEqual(known.largest("peak"),
                             peaks[3:].max() if count == 0 else 0.)
            self.assertEqual(known.first_arrival() is None, count > 0)
            made = Made(folder)
            self.assertEqual(made.code, 0, made.errors)
            words = text_of(made.page)
            self.assertEqual(words.count("The blast does not reach the body "
                                         "before the run ends."), count)
            self.assertEqual("Peak overpressure on the skin, " in words,
                             count == 0)
            self.assertEqual(headline._loads_alone(Scene(folder)).startswith(
                "The blast does not reach"), count > 0)
            self.assertNotRegex(words, r"\bnan\b")

    def test_marks_of_verdicts(self):
        """Each part with a verdict has a mark, where one of its places is seen
        from the loaded sides; else a hollow one."""
        spots = {(2, "back"): (0.1, 1.2), (1, "arm"): (0.2, 1.3)}

        class Views:
            """Views whose sides show few places."""
            @staticmethod
            def spot(side, place, even_hidden=False):
                return (0.3, 1.) if even_hidden else spots.get((side, place))

        for places, expected in (
                (["chest", "back"], (2, (0.1, 1.2))),
                (["arm"], (1, (0.2, 1.3))), (["chest"], (2, (0.3, 1.)))):
            mark = body_loads.Mark(places, "", "")
            self.assertEqual(mark.spot(Views, (2, 1)), expected)
            self.assertEqual(mark.is_seen, places != ["chest"])
        scene = Scene(self.whole)
        views = body_views.views_of(scene.loads(), scene.blast.folder)
        beyond = views.high + 1.
        self.assertIsNone(views.spot(0, beyond))
        spot = views.spot(0, beyond, True)
        self.assertTrue(np.all(np.array(spot) <= views.side_extent(0)))

    def test_colours_about_zero(self):
        """White at zero, the same size as dark on both sides; bars end where
        values end, pointed where some are beyond."""
        norm, colours = style.signed_scale(-50., 200.)
        whole = style.about_zero(200.)
        for value in (-50., -10., 0., 90., 200.):
            np.testing.assert_allclose(
                colours(norm(value)),
                style.plt.get_cmap(style.DIVERGING)(whole(value)), atol=0.02)
        for values, ends in (([-50., 200.], "neither"), ([-51., 3.], "min"),
                             ([0., 201.], "max"), ([-60., 999.], "both")):
            self.assertEqual(style.beyond(values, norm), ends)
        self.assertEqual(style.signed_scale(0., 0.)[0].vmax, 1e-9)
        scene = Scene(self.whole)
        views = body_views.views_of(scene.loads(), scene.blast.folder)
        areas = scene.loads().areas
        means = views.means(areas)
        self.assertTrue(np.all((means >= areas.min() * (1. - 1e-9))
                               & (means <= areas.max() * (1. + 1e-9))))

    def test_missing_stages(self):
        for names, words in (
                (("biomechanics", "blast/loads.h5"), "front chest wall velocity"),
                (("blast", "anatomy", "scene.json"),
                 "Missing: load_gauges.csv of the blast.")):
            made = Made(self.copy_without(*names))
            self.assertEqual(made.code, 0, made.errors)
            self.expect(text_of(made.page), words)

    def test_broken_files(self):
        for name, content in (("scene.json", "{"), ("scene.json", "[]"),
                              ("blast/load_gauges.csv", "time [s],a [Pa]\n1"),
                              ("blast/gauge_injury.csv", "measure,place\na"),
                              ("blast/gauge_measures.csv", "place,peak [Pa]\na"),
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
