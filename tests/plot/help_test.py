#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Every command of plot.py, and every link to it, answers --help with what it is
for, and a call with too few or too many arguments with its usage."""

import ast
import os
import subprocess
import unittest

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                      "..", "..", "applications", "plot")
PROGRAM = os.path.join(FOLDER, "plot.py")


def modules():
    """Docstrings of the commands by name."""
    found = {}
    for name in os.listdir(os.path.join(FOLDER, "commands")):
        if name.endswith(".py") and name != "__init__.py":
            with open(os.path.join(FOLDER, "commands", name),
                      encoding="utf-8") as file:
                found[name[:-3]] = ast.get_docstring(ast.parse(file.read()),
                                                     clean=False).strip()
    return found


def call(*command):
    run = subprocess.run(command, capture_output=True, text=True)
    return run.returncode, run.stdout.strip(), run.stderr.strip()


class HelpTest(unittest.TestCase):
    def test_all_commands(self):
        self.assertGreaterEqual(len(modules()), 12)
        code, told, errors = call(PROGRAM, "--help")
        self.assertEqual((code, errors), (0, ""))
        for name in modules():
            self.assertIn(f"\n  {name} ", told)
        code, told, errors = call(PROGRAM)
        self.assertEqual((code, told), (1, ""))

    def test_each_command(self):
        for name, documentation in modules().items():
            self.assertIn(f"plot.py {name} ", documentation)
            self.assertEqual(call(PROGRAM, name, "--help"),
                             (0, documentation, ""))
            code, told, errors = call(PROGRAM, name)
            self.assertEqual((code, told), (1, ""))
            self.assertRegex(errors, rf"\Ausage: plot.py {name} [A-Z].*\Z")

    def test_unknown(self):
        code, told, errors = call(PROGRAM, "paint", "folder")
        self.assertEqual((code, told), (1, ""))
        self.assertRegex(errors, r"\Aplot.py: there is no command 'paint'; .*"
                         r"\banatomy, .*\Z")

    def test_no_number(self):
        self.assertEqual(
            call(PROGRAM, "triple_point", "folder", "high"),
            (1, "", "plot.py triple_point: HEIGHT must be a number, not "
             "'high'"))


if __name__ == "__main__":
    unittest.main()
