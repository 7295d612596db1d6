#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Damages each file that the report of a scene reads, and shows that it makes a
page without them or refuses them in one line that names the file, with exit
code 1 and without a page; never with a traceback."""

import contextlib
import copy
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

import tiny_files
import tiny_scene

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "applications"))

from plot import command_line  # noqa: E402 (after the path of the package)
from plot.figures import style  # noqa: E402
from plot.readers.files import BrokenInput  # noqa: E402
from plot.readers.scene import Scene  # noqa: E402
from plot.report import body_sections, page as html_page  # noqa: E402

JSON_FILES = ("scene.json", "blast/summary.json", "biomechanics/summary.json")
TABLES = {
    "blast/history.csv": lambda scene: scene.blast.table("history.csv"),
    "blast/load_gauges.csv":
        lambda scene: scene.blast.table("load_gauges.csv"),
    "blast/gauge_measures.csv": lambda scene: scene.gauge_measures(),
    "blast/gauge_injury.csv": lambda scene: scene.gauge_injury(),
    "blast/probe_injury.csv": lambda scene: scene.air_injury(),
    "biomechanics/history.csv":
        lambda scene: scene.biomechanics.table("history.csv"),
    "biomechanics/probes.csv":
        lambda scene: scene.biomechanics.table("probes.csv"),
    "biomechanics/injury.csv": lambda scene: scene.measures(),
    "anatomy/quality.csv": lambda scene: body_sections.mesh(scene)}
PLANE = "blast/fields/plane_y_0_0001.vti"
ARRAYS = ("blast/loads.h5", PLANE, "biomechanics/fields/solid_0001.vtu")
PICTURES = ("blast/fields", "blast/loads.h5", "biomechanics/fields",
            "biomechanics/fields.pvd")
WRONG = {"words": "x", "number": 7.5, "list": [[]], "object": {"x": []},
         "truth": True, "nan": float("nan"), "infinity": float("inf")}


def draw_nothing(figure, path):
    """Instead of style.save(): the files are read all the same."""
    style.plt.close(figure)
    if not isinstance(path, str):
        path.write(b"picture")


def paint_roughly(figure, _kind):
    """Instead of page.render(): all is painted, in few dots and without a
    search for the best places."""
    stream = io.BytesIO()
    figure.set_layout_engine("none")
    figure.savefig(stream, format="png", dpi=20)
    style.plt.close(figure)
    return stream.getvalue()


def read_arrays(scene):
    scene.loads()
    scene.pressure_planes()
    for _, pieces in scene.field_list():
        scene.field(pieces)


def put(path, content):
    """As another file: HDF5 knows those that are still open."""
    with open(path + ".new", "wb") as file:
        file.write(content)
    os.replace(path + ".new", path)


def kind_of(value):
    return {str: "words", bool: "truth", int: "number", float: "number",
            list: "list", dict: "object"}[type(value)]


def places(value, path=()):
    """Paths to all that is in a JSON value."""
    items = value.items() if isinstance(value, dict) else enumerate(
        value) if isinstance(value, list) else ()
    for key, item in items:
        yield path + (key,)
        yield from places(item, path + (key,))


def changed(value, path, change):
    """A copy in which change(container, key) was done at @p path."""
    value = copy.deepcopy(value)
    container = value
    for key in path[:-1]:
        container = container[key]
    change(container, path[-1])
    return value


class DamageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.home.cleanup)
        cls.whole = os.path.join(cls.home.name, "whole")
        tiny_scene.write_all(cls.whole)
        # Without pictures that take long; without all, for the many of JSON.
        cls.tables = cls.copy_without("tables", *PICTURES)
        cls.brief = cls.copy_without(
            "brief", *PICTURES, "biomechanics/probes.csv",
            "biomechanics/history.csv", "blast/load_gauges.csv")

    @classmethod
    def copy_without(cls, name, *files):
        copy = os.path.join(cls.home.name, name)
        shutil.copytree(cls.whole, copy)
        for file in files:
            path = os.path.join(copy, file)
            (shutil.rmtree if os.path.isdir(path) else os.remove)(path)
        return copy

    def setUp(self):
        self.count = 0

    def judge(self, folder, name, what, may_live):
        """One page, or one line about the file."""
        self.count += 1
        page = os.path.join(folder, "report.html")
        if os.path.exists(page):
            os.remove(page)
        with unittest.mock.patch.object(style, "save", draw_nothing), \
                unittest.mock.patch.object(html_page, "render",
                                           paint_roughly), \
                contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()) as errors:
            code = command_line.run(["report", folder])
        words = f"{name}, {what}: {errors.getvalue()}"
        self.assertEqual(os.path.exists(page), code == 0, words)
        if code == 0:
            self.assertTrue(may_live, words + "a page was made")
            self.assertEqual(errors.getvalue(), "", words)
            return
        self.assertEqual(code, 1, words)
        self.assertEqual(errors.getvalue().count("\n"), 1, words)
        stem = os.path.splitext(name)[0]
        self.assertIn(os.path.join(folder, stem), errors.getvalue(), words)

    def damage(self, folder, name, contents):
        """Tries @p contents: bytes, what they are, whether a page may be."""
        path = os.path.join(folder, name)
        with open(path, "rb") as file:
            whole = file.read()
        try:
            for content, what, may_live in contents:
                put(path, content)
                with self.subTest(file=name, damage=what):
                    self.judge(folder, name, what, may_live)
        finally:
            put(path, whole)

    def test_whole(self):
        for folder in (self.tables, self.brief):
            self.judge(folder, "scene.json", "not damaged", True)
            self.assertTrue(os.path.exists(os.path.join(folder,
                                                        "report.html")))
        scene = Scene(self.whole)
        self.assertTrue(scene.loads() and scene.pressure_planes())
        self.assertEqual(len(scene.field_list()), 3)

    def test_json(self):
        """Cut anywhere, each value of each other kind or infinite, null, and
        without each name."""
        def set_to(value):
            def change(container, key):
                container[key] = value
            return change

        def remove(container, key):
            del container[key]

        def contents(whole):
            text = json.dumps(whole)
            for part in range(40):
                yield (text[:len(text) * part // 40].encode(),
                       f"cut at {part} of 40", False)
            for other in (b"[]", b"7", b"null", b"\xff\xfe{}", b'"x"'):
                yield other, f"is {other}", False
            for path in places(whole):
                value = whole
                for key in path:
                    value = value[key]
                for kind, wrong in WRONG.items() if value is not None else ():
                    if kind == kind_of(value):
                        continue
                    yield (json.dumps(changed(whole, path, set_to(wrong)))
                           .encode(), f"{path} is {wrong!r}", False)
                for what, change in (("missing", remove),
                                     ("null", set_to(None))):
                    if self.may_miss(path):
                        yield (json.dumps(changed(whole, path, change))
                               .encode(), f"{path} is {what}", True)

        for name in JSON_FILES:
            with open(os.path.join(self.brief, name), "rb") as file:
                whole = json.load(file)
            before = self.count
            self.damage(self.brief, name, contents(whole))
            print(f"{name}: {self.count - before} inputs")
            self.assertGreater(self.count - before, 100)

    @staticmethod
    def may_miss(path):
        """A page of each costs more than a refusal: every fifth of those in
        lists and groups."""
        return len(path) == 1 or sum(map(len, map(str, path))) % 5 == 0

    def test_tables(self):
        """Cut, other words for numbers, rows of other lengths, empty; then a
        page without a column."""
        for name, read in TABLES.items():
            with open(os.path.join(self.whole, name), "rb") as file:
                whole = file.read()
            text = whole.decode()
            lines = text.splitlines()
            middle = lines[len(lines) // 2]
            for content, what in (
                    (text[:len(text) * 4 // 5] + ",,x", "cut"),
                    (re.sub(r",-?[0-9.]+", ",one", text), "words"),
                    (text.replace(middle, middle + ",7"), "wide"),
                    (text.replace(middle, middle.partition(",")[0]), "short"),
                    (re.sub(r",-?[0-9.]+[^,\n]*", ",nan", text), "nan"),
                    ("", "empty")):
                # A measure may be unknown.
                if what == "nan" and name.endswith("/injury.csv"):
                    continue
                self.refuse(name, content.encode(), what, read)
            self.refuse(name, b"\xff" + whole, "no text", read)
            with self.subTest(file=name):
                self.damage(self.tables, name, [("\n".join(
                    line.partition(",")[2] for line in lines).encode(),
                    "without its first column", True)])
        print(f"tables: {self.count} inputs")
        self.assertGreater(self.count, 50)

    def refuse(self, name, content, what, read=read_arrays):
        """Sections of a report refuse the file in one line about it."""
        self.count += 1
        path = os.path.join(self.whole, name)
        with open(path, "rb") as file:
            whole = file.read()
        try:
            put(path, content)
            scene = Scene(self.whole)
            with self.subTest(file=name, damage=what), self.assertRaisesRegex(
                    BrokenInput,
                    re.escape(os.path.splitext(path)[0])) as refusal:
                read(scene)
            self.assertNotIn("\n", str(getattr(refusal, "exception", "")))
        finally:
            put(path, whole)

    def test_arrays(self):
        """Cut, of other sizes, or no numbers."""
        for name in ARRAYS:
            with open(os.path.join(self.whole, name), "rb") as file:
                whole = file.read()
            for part in range(20):
                self.refuse(name, whole[:len(whole) * part // 20],
                            f"cut at {part} of 20")
            self.refuse(name, b"\xff" * 100, "other bytes")
        with open(os.path.join(self.whole, PLANE), "rb") as file:
            whole = file.read()
        for before, after, what in (
                (b"Float64", b"UInt8", "bytes"),
                (b'Extent="0 59 0 0 0 29"', b'Extent="0 59 0 0 0 28"',
                 "fewer points"),
                (b'Extent="0 59 0 0', b'Extent="0 59 0 1', "a block"),
                (b'Extent="0 59 0 0 0 29"', b'Extent="0 1799 0 0 0 0"',
                 "a line"),
                (b'Extent="0 59', b'Extent="zero 59', "words"),
                (b' Spacing="', b' Space="', "no spacing"),
                (b' Origin="-1.0', b' Origin="nan', "nowhere"),
                (b'"TimeValue"', b'"Time"', "no time"),
                (b'format="binary">AQ', b'format="binary">Ag', "a block is missing"),
                (b'format="binary">AQAAAAAAAA',
                 b'format="binary">//////////', "many blocks")):
            self.assertIn(before, whole)
            self.refuse(PLANE, whole.replace(before, after), what)
        values = np.full((4, 4), np.inf)
        path = os.path.join(self.home.name, "infinite.vti")
        tiny_files.write_plane(path, {"pressure": (values, "Pa")}, [0., 0.],
                               [1., 1.])
        with open(path, "rb") as file:
            self.refuse(PLANE, file.read(), "infinite")
        self.damage_loads()
        print(f"arrays: {self.count} inputs")
        self.assertGreater(self.count, 90)

    def damage_loads(self):
        """Each data set is missing, has one value less, or is words."""
        import h5py
        path = os.path.join(self.whole, "blast", "loads.h5")
        other = os.path.join(self.home.name, "loads.h5")
        with h5py.File(path, "r") as file:
            names = list(file)
        for name in names:
            for what in ("missing", "short", "words"):
                shutil.copy(path, other)
                with h5py.File(other, "r+") as file:
                    values = file[name][:]
                    del file[name]
                    if what == "short":
                        file[name] = values[:-1]
                    elif what == "words":
                        file[name] = np.bytes_("x")
                with open(other, "rb") as file:
                    self.refuse("blast/loads.h5", file.read(),
                                f"{name} is {what}")


if __name__ == "__main__":
    unittest.main()
