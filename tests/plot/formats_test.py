#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The numbers of formats are the same wherever they stand, and the drawing
program refuses newer ones in one line that names the file."""

import json
import os
import re
import sys
import tempfile
import unittest

import numpy as np

import tiny_scene

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(REPOSITORY, "applications"))

from plot.commands import study  # noqa: E402
from plot.readers import files, formats, tables  # noqa: E402
from plot.readers.scene import Scene  # noqa: E402


def read(path):
    with open(os.path.join(REPOSITORY, path), encoding="utf-8") as file:
        return file.read()


class Formats(unittest.TestCase):
    def test_numbers_agree(self):
        header = read("include/contrecoup/io/file/file_format.h")
        numbers = {name: int(number) for name, number in re.findall(
            r'constexpr FileFormat \w+{"(\w+)", (\d+)};', header)}
        self.assertIn("checkpoint", numbers)
        for name, number in formats.NUMBERS.items():
            self.assertEqual(numbers.setdefault(name, number), number)
        for name in ("summary", "scene", "report"):
            schema = json.loads(read(f"applications/schemas/{name}.schema.json"))
            self.assertEqual(schema["properties"]["format"]["const"],
                             numbers[name])
            self.assertIn("format", schema["required"])
        listed = re.findall(r"^\| `(\w+)` \| (\d+) \|",
                            read("applications/README.md"), re.M)
        self.assertEqual({name: int(number) for name, number in listed}, numbers)

    def refuse(self, path, reader):
        with self.assertRaises(files.BrokenInput) as caught:
            reader()
        self.assertIn(path, str(caught.exception))
        self.assertIn("has format 99, this program reads up to 1",
                      str(caught.exception))

    def test_newer_json_is_refused(self):
        readers = {
            "scene.json": Scene, "blast/summary.json": Scene,
            "study.json": study.main, "summary.json": tables.open_references}
        for name, reader in readers.items():
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, name)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as file:
                    json.dump({"format": 99}, file)
                self.refuse(path, lambda: reader(folder))

    def test_newer_loads_are_refused(self):
        import h5py
        with tempfile.TemporaryDirectory() as folder:
            tiny_scene.write_scene(folder)
            path = os.path.join(folder, "blast", "loads.h5")
            os.makedirs(os.path.dirname(path), exist_ok=True)
            tiny_scene.write_loads(path, {})
            scene = Scene(folder)
            scene.loads().file.close()
            with h5py.File(path, "r+") as file:
                file.attrs["format"] = np.bytes_("contrecoup loads 99")
            self.refuse(path, Scene(folder).loads)


if __name__ == "__main__":
    unittest.main()
