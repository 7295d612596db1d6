#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Runs each batch file with a stand-in for srun and for the applications, and
shows that it calls its application on a shipped file, goes on from what a job
before has left, and hands options on."""

import glob
import os
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
CLUSTER = os.path.join(ROOT, "applications", "cluster")

# Where a job before leaves what can be gone on from.
TRACES = {"blast": "checkpoint/0001/complete.json", "study": "table.csv",
          "biomechanics": "checkpoint/0001/complete.json",
          "scene": "blast.stage.json"}


class ClusterTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        os.makedirs(os.path.join(self.root, "build", "bin"))
        os.symlink(os.path.join(ROOT, "parameter_files"),
                   os.path.join(self.root, "parameter_files"))
        self.write("srun", 'exec "$@"')
        for name in self.names():
            self.write(f"build/bin/{name}", 'printf "%s\\n" "$0" "$@"')

    def names(self):
        found = [os.path.basename(path)[:-len(".sbatch")] for path in
                 sorted(glob.glob(os.path.join(CLUSTER, "*.sbatch")))]
        self.assertTrue(found)
        return found

    def write(self, name, text):
        path = os.path.join(self.root, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + text + "\n")
        os.chmod(path, 0o755)

    def call(self, name, *arguments):
        """The words that the application was called with."""
        path = self.root + ":" + os.environ["PATH"]
        run = subprocess.run(
            ["bash", os.path.join(CLUSTER, name + ".sbatch"), *arguments],
            cwd=self.root, env={**os.environ, "PATH": path},
            capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout.splitlines()

    def test_every_application_has_one(self):
        applications = {name for name in os.listdir(
            os.path.join(ROOT, "applications")) if os.path.exists(
                os.path.join(ROOT, "applications", name, "main.cc"))}
        self.assertEqual(set(self.names()), applications)

    def test_example(self):
        for name in self.names():
            words = self.call(name)
            self.assertEqual(words[0], f"build/bin/{name}")
            self.assertTrue(os.path.isfile(os.path.join(ROOT, words[1])),
                            words[1])
            self.assertEqual(words[2], "--output")
            self.assertNotIn("--resume", words)

    def test_arguments(self):
        for name in self.names():
            words = self.call(name, "a b.prm", "here", "--set", "A/B=c d")
            self.assertEqual(words[1:], ["a b.prm", "--output", "here",
                                         "--set", "A/B=c d"])

    def test_goes_on(self):
        for name, trace in TRACES.items():
            path = os.path.join(self.root, "output", name, trace)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            open(path, "w", encoding="utf-8").close()
            self.assertIn("--resume", self.call(name))

    def test_asks_slurm(self):
        for name in self.names():
            with open(os.path.join(CLUSTER, name + ".sbatch"),
                      encoding="utf-8") as file:
                text = file.read()
            for option in ("job-name", "nodes", "ntasks-per-node", "mem",
                           "time"):
                self.assertIn(f"#SBATCH --{option}=", text)


if __name__ == "__main__":
    unittest.main()
