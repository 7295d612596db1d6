#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Shows that the report on a head says what the files of its run say, that
figures with another last digit are found, and that damaged files are refused in
one line: head_report_test.py OUTPUT_FOLDER of a run with Output/Pictures."""

import contextlib
import copy
import io
import os
import re
import shutil
import sys
import tempfile
import types
import unittest
import unittest.mock

import numpy as np

import damage_test

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path += [os.path.join(HERE, "..", "applications", "cases"),
             os.path.join(HERE, "..", "..", "applications")]

import head_figures  # noqa: E402 (after the paths of the modules)
import report_reader  # noqa: E402
from plot import command_line  # noqa: E402
from plot.figures import head_figures as head_cuts  # noqa: E402
from plot.readers import cuts, head_run  # noqa: E402
from plot.report import (head_report, injury_table,  # noqa: E402
                         injury_thresholds, page as html_page)

OUTPUT = None
# Columns of tables whose figures are all checked, by section.
CHECKED = {"Contact and rebound": ("whole head", "when"),
           "Pressure and strain over time": (
               "value", "when", "highest pressure", "when it is highest",
               "lowest pressure", "when it is lowest"),
           "Energy": ("at the start", "at the end"),
           "Injury": ("value and its estimated error",)}
# A mean that only the picture shows, and what the summary has no time of.
UNCHECKED = "largest mean over"


class Made:
    """Output of plot.py head on a folder, with figures painted roughly."""

    def __init__(self, folder):
        with contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()) as errors, \
                unittest.mock.patch.object(html_page, "render",
                                           damage_test.paint_roughly):
            self.code = command_line.run(["head", folder])
        self.errors = errors.getvalue()


class FiguresTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.files = head_figures.Files(OUTPUT)
        with open(os.path.join(OUTPUT, "report.html"),
                  encoding="utf-8") as file:
            # Pictures take long to read again and again.
            cls.page = re.sub("base64,[^\"]*", "", file.read())

    def judge(self, text):
        return head_figures.check_report(report_reader.Page(text), self.files)

    def test_accepts(self):
        self.assertGreater(self.judge(self.page),
                           65 if self.files.is_file else 80)

    def test_corners_are_numbered_as_cuts_take_them(self):
        """Opposite corners of cells have one middle."""
        run = head_run.HeadRun(OUTPUT)
        points = run.arrays(run.fields()[0][1])["points"]
        size = np.linalg.norm(points[:, 7] - points[:, 0], axis=1)
        for first, second in ((1, 6), (2, 5), (3, 4)):
            off = np.linalg.norm(points[:, 0] + points[:, 7] - points[:, first]
                                 - points[:, second], axis=1)
            self.assertLess(np.median(off / size), 0.1)

    def test_rejects_another_digit(self):
        count = 0
        for section, columns in CHECKED.items():
            begin = self.page.index(f"{section}</h2>")
            end = self.page.index("</section>", begin)
            for row in re.finditer("<tr>.*?</tr>", self.page[begin:end]):
                if UNCHECKED in row[0]:
                    continue
                for column in columns:
                    count += self.reject(begin + row.start(), row[0], column)
        self.assertGreaterEqual(count, 45 if self.files.is_file else 50)

    def reject(self, place, row, column):
        """Whether there was a digit to change in the cell of a column."""
        cell = re.search(f'data-label="{column}">(.*?)</td>', row)
        number = cell and re.search(report_reader.NUMBER, cell[1])
        # A zero has no digit that counts.
        if not number or not re.search("[1-9]", number[0]):
            return 0
        digits = re.match(r"[−\d\u202f.]*", number[0])[0]
        last = place + cell.start(1) + number.start() + len(digits) - 1
        digit = int(self.page[last])
        changed = (self.page[:last] + str(digit - 1 if digit else 1)
                   + self.page[last + 1:])
        with self.assertRaises(AssertionError, msg=row):
            self.judge(changed)
        return 1


class DamageTest(unittest.TestCase):
    """Files of the run in a folder of its own, which may be damaged."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.join(folder.name, "run")
        shutil.copytree(OUTPUT, self.folder, ignore=shutil.ignore_patterns(
            "checkpoint*", "pictures", "report.*"))

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def refuses(self, name):
        made = Made(self.folder)
        self.assertEqual(made.code, 1)
        self.assertRegex(made.errors, rf"^plot.py head: .*{name}: .*\n$")
        self.assertFalse(os.path.exists(self.path("report.html")))

    def test_cut_files(self):
        for name in ("fields/ale_0001.vtu", "history.csv", "summary.json"):
            whole = self.path(name)
            shutil.copy(whole, whole + ".whole")
            # In the first columns of a line: a row without its last digits is none
            # that is cut off.
            with open(whole, "rb") as file:
                half = file.read(os.path.getsize(whole) // 2)
            os.truncate(whole, half.rindex(b"\n") + 12)
            with self.subTest(name):
                self.refuses(name)
            os.replace(whole + ".whole", whole)

    def test_missing_plane(self):
        with open(self.path("parameters.prm"), encoding="utf-8") as file:
            text = file.read()
        with open(self.path("parameters.prm"), "w", encoding="utf-8") as file:
            file.write(re.sub(r"set Point += .*", "set Point = 1, x", text))
        self.refuses("parameters.prm")

    def test_missing_fields(self):
        os.remove(self.path("fields.pvd"))
        os.remove(self.path("injury.csv"))
        made = Made(self.folder)
        self.assertEqual((made.code, made.errors), (0, ""))
        with open(self.path("report.html"), encoding="utf-8") as file:
            text = file.read()
        self.assertIn("Missing: fields", text)
        self.assertIn("Missing: injury.csv", text)


class CutTest(unittest.TestCase):
    """Where a plane cuts hexahedra."""

    CUBE = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0),
                     (0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)], dtype=float)

    @staticmethod
    def area(polygons):
        x, y = polygons[..., 0], polygons[..., 1]
        following = np.roll(polygons, -1, axis=1)
        return 0.5 * np.abs(np.sum(x * following[..., 1]
                                   - y * following[..., 0], axis=1)).sum()

    def test_cube(self):
        for axis, shown in ((0, (1, 2)), (1, (0, 2)), (2, (0, 1))):
            for place in (0., 0.3, 0.999):
                polygons, owners = cuts.cut_hexahedra(
                    np.stack([self.CUBE + 2., self.CUBE]), axis, place, shown)
                self.assertAlmostEqual(self.area(polygons), 1.)
                self.assertEqual(set(owners), {1})

    def test_turned(self):
        """A cube on its tip, cut through its middle: a regular hexagon."""
        up = np.ones(3) / np.sqrt(3.)
        right = np.array([1., -1., 0.]) / np.sqrt(2.)
        turn = np.stack([right, np.cross(up, right), up])
        polygons, _ = cuts.cut_hexahedra(
            ((self.CUBE - 0.5) @ turn.T)[None], 2, 0., (0, 1))
        self.assertAlmostEqual(self.area(polygons), 0.75 * np.sqrt(3.))

    def test_run(self):
        """Cuts of the run's quarter of a ball of 91 mm, in all directions,
        away from faces of cells: cells have straight edges."""
        run = head_run.HeadRun(OUTPUT)
        if not run.is_layered():
            self.skipTest("another body than the ball whose area is known")
        points = run.arrays(run.fields()[0][1])["points"]
        for axis, shown, part in ((0, (1, 2), 0.5), (1, (0, 2), 0.5),
                                  (2, (0, 1), 0.25)):
            polygons, _ = cuts.cut_hexahedra(points, axis, 0.0123, shown)
            circle = part * np.pi * (0.091**2 - 0.0123**2)
            self.assertLess(self.area(polygons), circle)
            self.assertGreater(self.area(polygons), 0.97 * circle)

    def test_motion_of_the_skull(self):
        """A head that moves and turns as a rigid body has no motion left, be
        its fields of cells or of particles."""
        run = head_run.HeadRun(OUTPUT)
        run.mirrors = [1]
        arrays = run.arrays(run.fields()[0][1])
        points = arrays["points"] - run.middle(arrays["points"])
        arrays["velocity"] = np.array([2., 0., -3.]) + np.cross(
            [0., 22., 0.], points)
        for is_of_particles in (False, True):
            found = {name: values[:, :1] for name, values in arrays.items()} \
                if is_of_particles else arrays
            with unittest.mock.patch.object(
                    run, "arrays", lambda _, of=found: dict(of)), \
                    unittest.mock.patch.object(
                        run, "has_particles", lambda of=is_of_particles: of), \
                    unittest.mock.patch.object(run, "spacing", lambda: 0.01):
                cut = run.cut(run.fields()[0])
            for values in (cut.values, cut.centres):
                self.assertGreater(np.abs(values["velocity"]).max(), 3.)
                left = head_cuts.velocity_of(values, slice(None), True)
                self.assertLess(np.abs(left).max(), 1e-5)

    def test_published_impact(self):
        """Only the published speed and the shipped sizes are those of the
        paper; an oblique impact is told with both speeds."""
        run = head_run.HeadRun(OUTPUT)
        if not run.is_layered():
            self.skipTest("another body than the paper's")
        self.assertTrue(run.is_published())
        run.history.values[:, run.history.names.index("momentum_x")] = \
            0.5 * run.history["momentum_z"]
        self.assertFalse(run.is_published())
        self.assertEqual(head_report._impact_speed(run).replace(
            "\u00a0", " "), "3.35 m/s, of which 3.00 m/s are towards the plane")

    def test_wedge(self):
        """The middle of a wedge is its section."""
        wedge = self.CUBE * (1., 0.06, 1.)
        wedge[:, 1] = (wedge[:, 1] - 0.03) * (0.01 + wedge[:, 0])
        polygons, _ = cuts.cut_hexahedra(wedge[None], 1, 0., (0, 2))
        self.assertAlmostEqual(self.area(polygons), 1.)

    def test_beside(self):
        polygons, owners = cuts.cut_hexahedra(self.CUBE[None], 0, 1.5,
                                              (1, 2))
        self.assertEqual((len(polygons), len(owners)), (0, 0))


class WarningsTest(unittest.TestCase):
    """Warnings of a run stand on the first screen."""

    def test_words(self):
        silent, warned = (types.SimpleNamespace(summary=summary) for summary in
                          ({}, {"warnings": ["layers: <2 cells"]}))
        self.assertEqual(head_report.warnings({"": silent}), "")
        words = str(head_report.warnings({"ALE": silent, "MPM": warned}))
        self.assertIn("<h3>Warnings of the runs</h3>", words)
        self.assertIn("MPM: layers: &lt;2 cells", words)


class AnswerTest(unittest.TestCase):
    """The first screen judges by thresholds of the user's own."""

    def test_own_thresholds(self):
        run = head_run.HeadRun(OUTPUT)
        measures = head_report.measures(run)
        for limit, words in ((1e-9, "above"), (2e3, "below")):
            judged = [injury_table.Judged(
                name, measures[name].value, "-",
                injury_thresholds.KNOWN[name]._replace(
                    thresholds=[(limit, "our line")], is_own=True), None, "")
                      for name in ("injury_hic15", "injury_strain_95")]
            text = str(head_report.answer(run, judged)).replace("\u00a0", " ")
            limit = html_page.plain(limit, "-")
            self.assertRegex(
                text, rf"HIC15 is [^ ]+, {words} {limit} \(our line\)\.")
            self.assertRegex(text, "strained by less than [^ ]+, which is "
                             rf"{words} {limit} \(our line\)\.")

    def test_pressures_of_an_impact(self):
        """Thresholds that were found for blunt impacts give a verdict."""
        run = head_run.HeadRun(OUTPUT)
        peak = "injury_intracranial_pressure_peak"
        for value, words in ((203e3, "minor injury"), (1e3, "")):
            measures = {**head_report.measures(run)}
            measures[peak] = copy.copy(measures[peak])
            measures[peak].value, measures[peak].is_cut = value, False
            with unittest.mock.patch.object(head_report, "measures",
                                            lambda _, known=measures: known):
                judged = head_report.judge(run)
            found = injury_table.find(judged, peak)
            self.assertTrue(found.has_verdict)
            self.assertNotIn("blast", found.limits)
            self.assertEqual(found.meaning(), words)
            self.assertEqual("203\u00a0kPa: minor injury" in str(
                head_report.answer(run, judged)), bool(words))

    def test_pressures_so_far(self):
        """An extreme is told as that so far where the contact lasts when the run
        ends, as is its force, and where it is at the end."""
        def told(lasts, falls):
            run = head_run.HeadRun(OUTPUT)
            names, values = run.history.names, run.history.values
            bump = np.sin(np.linspace(0., np.pi, len(values)))
            for column, name in enumerate(names):
                if name.startswith("least_pressure"):
                    values[:, column] = -np.arange(len(values)) if falls \
                        else -bump
                elif name.startswith(("largest_", "void_volume")):
                    values[:, column] = bump
            run.is_cut_off = lambda: lasts
            text = str(head_report.answer(run, [])).replace("\u00a0", " ")
            self.assertIn("N at most so far (mean" if lasts else
                          "N at most (mean", text)
            pressures = re.findall(
                r"reaches from (\S+ \w+)( so far)? \(.*?\) to (\S+ \w+)( so "
                r"far)? \(", text)
            rows = re.findall(r"([≤≥]) [−\d]", str(head_report._extrema(run)))
            return {(bool(low), bool(high))
                    for _, low, _, high in pressures}, set(rows)
        self.assertEqual(told(False, False), ({(False, False)}, set()))
        self.assertEqual(told(False, True), ({(True, False)}, {"≤"}))
        self.assertEqual(told(True, False), ({(True, True)}, {"≤", "≥"}))


class ParticlesTest(unittest.TestCase):
    """Statements of a report that only a run of particles has."""

    @staticmethod
    def run_of(force="0", **parameters):
        """A run of 10 J at the start gives back 2 J beyond what was stored;
        planes do 1 J besides friction."""
        history = {"kinetic_energy": np.array([10., 5.]),
                   "internal_energy": np.array([0., -1.]),
                   "stored_energy": np.array([0., 1.]),
                   "external_work": np.array([0., 0.5]),
                   "friction_work": np.array([0., -0.5]),
                   "transfer_loss": np.array([0., 6.]),
                   "contact_loss": np.array([0., 0.5]),
                   "energy_residual": np.zeros(2), "time": np.array([0., 1.])}
        return types.SimpleNamespace(
            history=history, planes=[], parameters=parameters,
            has_particles=lambda: parameters.get("Method") == "mpm",
            found=lambda group, name: 1e-15,
            parameter=lambda name: [float(force)])

    def energy(self, run):
        with unittest.mock.patch.object(head_report, "figure", return_value=""):
            return "".join(map(str, head_report.energy(run, "")))

    def test_ledger_closes_with_its_rows(self):
        run = self.run_of(Method="mpm")
        rows = dict(head_report.ledger(run))
        self.assertAlmostEqual(
            np.ptp(rows["both"] - rows["work of planes and body forces"]
                   + rows["transfer loss"] + rows["contact loss"]), 0.)
        text = self.energy(run).replace("\u00a0", " ")
        for words in ("forces, less transfer loss and contact loss, to round",
                      "20 % were given back by the matter beyond",
                      "10 % are work of planes at rest other than by friction",
                      *rows):
            self.assertIn(words, text)

    def test_parts_of_the_work_are_its_sum(self):
        along = "thereof planes, along their normals"
        for force, planes, columns, names in (
                ("0", 1, {}, [along, "thereof friction"]),
                ("1", 1, {}, [along + ", and body forces", "thereof friction"]),
                ("1", 1, {"contact_work": 0.25, "slip_work": 0.5},
                 ["thereof body forces", along, "thereof friction",
                  "thereof slipping interfaces"]),
                ("0", 1, {"contact_work": 0.25, "slip_work": 0.75},
                 [along, "thereof friction", "thereof slipping interfaces"])):
            run = self.run_of(force=force)
            run.planes = planes * ["wall"]
            for name, value in columns.items():
                run.history[name] = np.array([0., value])
            rows = dict(head_report.ledger(run))
            parts = [name for name in rows if name.startswith("thereof")]
            self.assertEqual(parts, names)
            np.testing.assert_allclose(
                sum(rows[name] for name in parts),
                rows["work of planes" + (
                    ", body forces and slipping interfaces"
                    if "slip_work" in columns else " and body forces")])

    def test_forces_of_bodies_are_no_error(self):
        for force in ("1", "nan"):
            self.assertNotIn("planes at rest", self.energy(
                self.run_of(force=force, Method="mpm")))

    def test_cells_lose_nothing(self):
        text = self.energy(self.run_of(Method="ale"))
        self.assertIn("planes and body forces, to round-off", text)
        self.assertNotIn("given back", text)

    def test_pressures_are_averages_where_they_are_smoothed(self):
        for method, smoothing, said in (
                ("mpm", "liquids and gels", True), ("mpm", "none", False),
                ("ale", "liquids and gels", False)):
            words = head_report._smoothing(self.run_of(
                Method=method, **{"MPM/Smoothing": smoothing}))
            self.assertEqual(f"(MPM/Smoothing = {smoothing})" in words, said)


class RowsTest(unittest.TestCase):
    """Times are those of rows, which leave steps out."""

    def test_words(self):
        for every, words in ((1., ""), (10., ", told at the next row of "
                                        "history.csv, one of 10 steps")):
            run = types.SimpleNamespace(parameter=lambda _, of=every: [of])
            self.assertEqual(head_report._row_times(run), words)


class Struck(head_run.HeadRun):
    """A run of an impact with outputs every 0.2 ms, without files."""

    def __init__(self, is_published=False, end=5e-3, **states):
        self.known, self.end, self.is_paper = states, end, is_published

    def is_published(self):
        return self.is_paper

    def fields(self):
        return [(2e-4 * n, []) for n in range(round(self.end / 2e-4) + 1)]

    def contact(self, name):
        return self.known.get(name)

    def last_contact(self):
        return self.known.get("contact_end")

    def rebound(self):
        return self.known.get("rebound")


class PickedTest(unittest.TestCase):
    """Cuts show the impact, whenever it is, each state once."""

    IMPACT = {"contact_begin": 1e-3, "peak_contact_force_time": 1.78e-3,
              "rebound": 2.51e-3, "contact_end": 3.99e-3}

    def times(self, run):
        return [round(1e3 * time, 3) for time, _ in run.picked()]

    def words(self, run):
        return head_report.choice(run, [time for time, _ in run.picked()]
                                  ).replace("\u00a0", " ")

    def test_states(self):
        run = Struck(**self.IMPACT)
        self.assertEqual(self.times(run), [1.2, 1.8, 2.6, 4.])
        self.assertEqual(
            self.words(run),
            "Times are those of outputs that are the nearest to states of the "
            "impact from the first contact on: 1.20 ms to first contact (1.00 ms); 1.80 ms to largest "
            "force (1.78 ms); 2.60 ms to rebound (2.51 ms); 4.00 ms to end of "
            "contact (3.99 ms).")
        flow = [types.SimpleNamespace(time=time) for time, _ in run.picked()]
        self.assertEqual([round(1e3 * cut.time, 3)
                          for cut in run.picked_flow(flow)], [1.8, 4.])

    def test_doubles(self):
        """Two states in one output, and a contact that continues."""
        run = Struck(**{**self.IMPACT, "peak_contact_force_time": 2.78e-3,
                        "rebound": 2.71e-3})
        self.assertEqual(self.times(run), [1.2, 2., 2.8, 4.])
        self.assertIn("2.80 ms to largest force (2.78 ms) and rebound (2.71 "
                      "ms); 4.00 ms to end of contact (3.99 ms); 2.00 ms is "
                      "shown beside these.", self.words(run))
        times = self.times(Struck(contact_begin=4.1e-3,
                                  peak_contact_force_time=4.96e-3))
        self.assertEqual((len(times), times[0], times[-1]), (4, 4.2, 5.))

    def test_without_contact(self):
        run = Struck()
        self.assertEqual(self.times(run), [0.2, 1.4, 2.6, 5.])
        self.assertEqual(self.words(run), "")
        self.assertEqual(self.times(Struck(end=0.)), [])

    def test_published(self):
        run = Struck(is_published=True, **self.IMPACT)
        self.assertIn(5., self.times(run))
        self.assertIn(1., self.times(run))
        self.assertRegex(self.words(run),
                         "published pictures.*; .* are shown beside these")


class CrossingTest(unittest.TestCase):
    def test_crossing(self):
        time = np.array([0., 1., 2., 3.])
        self.assertEqual(head_run.first_crossing(
            time, np.array([-3., -1., 3., -1.])), 1.25)
        self.assertIsNone(head_run.first_crossing(
            time, np.array([3., -1., -3., 0.])))


if __name__ == "__main__":
    OUTPUT = sys.argv.pop()
    unittest.main()
