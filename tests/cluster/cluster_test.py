#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Runs each batch file with stand-ins for srun, scontrol and the applications,
and shows that it calls its application on a shipped file, continues from what
a job before has left, is queued again only where that helps, and hands
options on."""

import glob
import os
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
CLUSTER = os.path.join(ROOT, "applications", "cluster")

# Where a job before leaves what can be gone on from.
TRACES = {"blast": "checkpoint/0001/complete.json", "study": "study.json",
          "biomechanics": "checkpoint/0001/complete.json",
          "head_impact": "checkpoint/0001/complete.json",
          "scene": "blast.stage.json"}
# Where those that are queued again have their checkpoints.
REQUEUED = {"blast": "", "biomechanics": "", "head_impact": "",
            "scene": "blast/"}

# Exit codes of SIGINT, SIGUSR1 and SIGTERM.
STOPPED = (130, 138, 143)


class ClusterTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        os.makedirs(os.path.join(self.root, "build", "bin"))
        for folder in ("parameter_files", "applications"):
            os.symlink(os.path.join(ROOT, folder),
                       os.path.join(self.root, folder))
        self.write("srun", 'exec "$@"')
        self.write("scontrol", 'printf "%s\\n" scontrol "$@"')
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

    def call(self, name, *arguments, code=0):
        """The words that application and scontrol were called with."""
        path = self.root + ":" + os.environ["PATH"]
        run = subprocess.run(
            ["bash", os.path.join(CLUSTER, name + ".sbatch"), *arguments],
            cwd=self.root,
            env={**os.environ, "PATH": path, "SLURM_JOB_ID": "17"},
            capture_output=True, text=True)
        self.assertEqual(run.returncode, code, run.stderr)
        self.errors = run.stderr
        return run.stdout.splitlines()

    def leave(self, name):
        """An empty file of an earlier job."""
        path = os.path.join(self.root, "output", name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        open(path, "w", encoding="utf-8").close()

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
            self.leave(os.path.join(name, trace))
            self.assertIn("--resume", self.call(name))

    def test_starts_again_without_a_complete_checkpoint(self):
        for name in ("blast", "biomechanics", "head_impact"):
            self.leave(os.path.join(name, "checkpoint", "0001", "gas.bin"))
            self.assertNotIn("--resume", self.call(name))
        os.makedirs(os.path.join(self.root, "output", "study"))
        self.assertNotIn("--resume", self.call("study"))

    def test_each_that_is_queued_again_is_tried(self):
        texts = {name: open(os.path.join(CLUSTER, name + ".sbatch"),
                            encoding="utf-8").read() for name in self.names()}
        self.assertEqual(set(TRACES), {name for name, text in texts.items()
                                       if "--resume" in text})
        self.assertEqual(set(REQUEUED), {name for name, text in texts.items()
                                         if "run_or_requeue" in text})

    def test_is_queued_again_after_a_new_checkpoint(self):
        for name, below in REQUEUED.items():
            checkpoint = f"output/{name}/{below}checkpoint"
            for number, code in enumerate(STOPPED):
                self.write(f"build/bin/{name}",
                           f"mkdir -p {checkpoint}/{number}\n"
                           f"touch {checkpoint}/{number}/complete.json\n"
                           f"exit {code}")
                self.assertEqual(self.call(name),
                                 ["scontrol", "requeue", "17"])
            # The number of a checkpoint that was written again is no sign of
            # a standstill.
            path = os.path.join(self.root, checkpoint, "0", "complete.json")
            os.utime(path, (0, 0))
            self.write(f"build/bin/{name}", f"touch '{path}'\nexit 143")
            self.assertIn("requeue", self.call(name))

    def test_is_not_queued_again_without_a_new_checkpoint(self):
        for name, below in REQUEUED.items():
            self.leave(f"{name}/{below}checkpoint/0001/complete.json")
            folder = f"output/{name}/{below}checkpoint/0002"
            self.write(f"build/bin/{name}",
                       f"mkdir -p {folder}; touch {folder}/gas.bin; exit 143")
            self.assertEqual(self.call(name, code=143), [])
            self.assertIn("no new checkpoint", self.errors)

    def test_is_not_queued_again_after_a_failure(self):
        for name, below in REQUEUED.items():
            folder = f"output/{name}/{below}checkpoint/0001"
            for code in (0, 1, 2, 3, 137):
                self.write(f"build/bin/{name}",
                           f"mkdir -p {folder}; touch {folder}/complete.json; "
                           f"exit {code}")
                self.assertEqual(self.call(name, code=code), [])

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
