#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Shows that the report of a tiny scene is sound in a browser, and that each
fault a page can have there is found."""

import os
import sys
import tempfile
import unittest

import browser
import page_checks
import tiny_scene

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "applications"))

from plot import command_line  # noqa: E402 (after the path of the package)

DOT = ("data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAA"
       "CklEQVR4nGNgAAAAAgABSK+kcQAAAABJRU5ErkJggg==")
SOUND = ('<!DOCTYPE html><html><meta charset="utf-8"><title>x</title><body>'
         f'<figure><img src="{DOT}" alt="A single pixel of a black picture">'
         "<figcaption>A picture.</figcaption></figure></body></html>")
FAULTY = {
    "console": ("</body>", "<script>console.error('broken')</script></body>"),
    "exception": ("</body>", "<script>throw new Error('x')</script></body>"),
    "asks for": ("</body>", '<link rel="stylesheet" href="x.css"></body>'),
    "not loaded": (DOT, "data:image/png;base64,AAAA"),
    "no alternative": (' alt="A single pixel of a black picture"', ""),
    "its caption": ("A single pixel of a black picture",
                    "A picture of a black pixel, alone"),
    "is 900 wide": ("</body>", '<p style="width:900px;margin:0 0 0 -8px">x</p>'
                    "</body>"),
    "too wide in a window of 400: td": (
        "</body>", '<table style="overflow:hidden"><tr><td>' + 80 * "x"
        + "</table></body>"),
    "picture 1 is 0.50 of its size": (
        f'src="{DOT}"', "src='data:image/svg+xml,<svg xmlns=\"http://www.w3."
        "org/2000/svg\" width=\"200\" height=\"9\"/>' width=\"100\""),
    "folded away": ("</body>", '<details class="table"><summary>x</summary>'
                    "<table><tr><td>vanished</table></details></body>"),
    "page 1 of 2 ends at": ("</body>", '<p style="break-before:page">x</p>'
                            "</body>")}


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.window = browser.Browser(browser.find_browser())
        cls.addClassCleanup(cls.window.close)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def faults(self, content):
        path = os.path.join(self.folder, "page.html")
        with open(path, "w", encoding="utf-8") as file:
            file.write(content)
        return page_checks.find_faults(self.window, path, self.folder)

    def test_sound(self):
        self.assertEqual(self.faults(SOUND), [])

    def test_faults_are_found(self):
        caption = SOUND.replace("A picture.",
                                "A picture of a black pixel, alone.")
        for name, (before, after) in FAULTY.items():
            page = caption if name == "its caption" else SOUND
            self.assertIn(before, page)
            found = self.faults(page.replace(before, after))
            # An exception is told on the console.
            word = "console" if name == "exception" else name
            self.assertTrue(any(word in fault for fault in found),
                            f"{name}: {found}")

    def test_report(self):
        scene = os.path.join(self.folder, "scene")
        tiny_scene.write_all(scene)
        tiny_scene.crowd(scene)
        self.assertEqual(command_line.run(["report", scene]), 0)
        self.assertEqual(page_checks.find_faults(
            self.window, os.path.join(scene, "report.html"), self.folder), [])


if __name__ == "__main__":
    page_checks.leave_without_programs()
    unittest.main()
