#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Debian packages of one build have the files, control data and permissions that Debian
expects, and their programs run: package_test.py CPACK BUILD. tests/install/in_bare_root
tries packages for all processors in a Debian of their own."""

import os
import re
import shutil
import sys
import unittest

from command import run

CPACK, BUILD = sys.argv.pop(1), os.path.abspath(sys.argv.pop(1))
NAMES = ("contrecoup", "libcontrecoup-dev")
PROGRAMS = ("anatomy", "biomechanics", "blast", "head_impact", "scene", "study")


@unittest.skipUnless(shutil.which("dpkg-shlibdeps") or "CI" in os.environ,
                     "no dpkg-dev")
class PackageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = os.path.join(BUILD, "tests", "install", "package")
        shutil.rmtree(cls.folder, ignore_errors=True)
        os.makedirs(cls.folder)
        run(CPACK, "--config", os.path.join(BUILD, "CPackConfig.cmake"), "-B",
            cls.folder, cwd=cls.folder, env={
                **os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
        cls.tree = os.path.join(cls.folder, "tree")
        cls.files, cls.fields = {}, {}
        for name in NAMES:
            (package,) = (os.path.join(cls.folder, file) for file
                          in os.listdir(cls.folder)
                          if re.fullmatch(rf"{name}_0.*\.deb", file))
            # Mode, owner, size, day, time, path.
            cls.files[name] = {row[5]: row for row in (
                line.split(None, 5) for line
                in run("dpkg-deb", "-c", package).splitlines())}
            cls.fields[name] = dict(
                line.split(": ", 1) for line
                in run("dpkg-deb", "-f", package).splitlines() if ": " in line)
            run("dpkg-deb", "-x", package, cls.tree)

    def test_control_data(self):
        program, library = (self.fields[name] for name in NAMES)
        for fields in program, library:
            self.assertRegex(fields["Maintainer"], r"^[^<>]+ <[^@ ]+@[^@ ]+>$")
            self.assertRegex(fields["Description"], "^what a blast does")
        self.assertEqual(program["Section"], "science")
        needed = set(re.findall(r"(?:^|, )([^ ,|]+)", program["Depends"]))
        for name in ("libc6", "libstdc++6", "openmpi-bin", "python3-h5py",
                     "python3-matplotlib"):
            self.assertIn(name, needed)
        self.assertRegex(program["Depends"], r"libdeal\.ii")
        self.assertNotIn("-dev", program["Depends"])
        self.assertIn(f"contrecoup (= {program['Version']})",
                      library["Depends"])

    def test_files(self):
        for rows in self.files.values():
            for mode, owner, *_, path in rows.values():
                self.assertEqual(owner, "root/root", path)
                self.assertIn(mode[1:], ("rwxr-xr-x", "rw-r--r--", "rwxrwxrwx"),
                              path)
                self.assertEqual(mode[1:] == "rwxrwxrwx", mode[0] == "l", path)
        program, library = (
            {path for path in rows if not path.endswith("/")}
            for rows in self.files.values())
        self.assertFalse(program & library)
        for name in PROGRAMS:
            self.assertIn(f"./usr/bin/{name}", program)
            self.assertIn(f"./usr/share/man/man1/{name}.1.gz", program)
        for name in ("copyright", "changelog.gz", "changelog.Debian.gz"):
            self.assertIn(f"./usr/share/doc/contrecoup/{name}", program)
        for path in program:
            self.assertNotRegex(path, r"\.h$|\.cmake$|\.so$|__pycache__|\.pyc$")
            if "/man/" in path:
                self.assertRegex(path, r"\.gz$")
        self.assertTrue(any(path.endswith("/ContrecoupConfig.cmake")
                            for path in library))

    def test_programs_are_stripped_and_run(self):
        for name in PROGRAMS:
            path = os.path.join(self.tree, "usr", "bin", name)
            self.assertNotIn(".symtab", run("readelf", "-SW", path))
            # An empty folder would be the current one.
            paths = re.search(r"RUNPATH.*\[(.*)\]", run("readelf", "-dW", path))
            self.assertNotIn("", paths[1].split(":"))
            self.assertRegex(run(path, "--version"), rf"^{name} \d")


if __name__ == "__main__":
    unittest.main()
