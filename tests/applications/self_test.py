#!/usr/bin/env python3
"""Shows that each kind of run_case.py accepts an application that does as it
should, and rejects one with a flaw. The application is decay.py."""

import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))


class RunCaseTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        with open(os.path.join(self.root, "decay.prm"), "w") as file:
            file.write("Steps=60\n")
        self.environment = dict(os.environ)
        self.environment.pop("CONTRECOUP_TEST_NAMESPACE", None)

    def case(self, kind, *options, flaw="none"):
        """Runs one case; returns its exit code and output."""
        run = subprocess.run(
            [sys.executable, os.path.join(HERE, "run_case.py"), kind,
             "--name=case", "--file=decay.prm", "--set=Flaw=" + flaw,
             "--application=" + os.path.join(HERE, "decay.py"), *options],
            cwd=self.root, capture_output=True, text=True,
            env=self.environment)
        self.assertEqual(run.stderr, "")
        return run.returncode, run.stdout

    def accepts(self, *arguments, **keywords):
        code, out = self.case(*arguments, **keywords)
        self.assertEqual(code, 0, out)

    def rejects(self, reason, *arguments, **keywords):
        code, out = self.case(*arguments, **keywords)
        self.assertEqual(code, 1, out)
        self.assertIn("FAILED", out)
        self.assertIn(reason, out)

    def test_bounds(self):
        self.accepts("bounds", "--bound=errors.x < 2e-3",
                     "--bound=status == finished")
        self.rejects("is not < 1e-3", "bounds", "--bound=errors.x < 1e-3")
        self.rejects("no 'errors.y'", "bounds", "--bound=errors.y < 1")
        self.rejects("history.csv:3", "bounds", flaw="nan")

    def test_regression(self):
        options = ("regression", "--reference=references", "--tolerance=-r 0")
        self.environment["CONTRECOUP_UPDATE_REFERENCES"] = "1"
        self.accepts(*options)
        del self.environment["CONTRECOUP_UPDATE_REFERENCES"]
        self.accepts(*options)
        self.rejects("history.csv differs", *options,
                     "--set=Step size=0.0100000001")

    def test_ranks(self):
        self.accepts("ranks", "--ranks=2")
        self.rejects("history.csv differs", "ranks", "--ranks=2", flaw="rank")

    def test_convergence(self):
        options = ("convergence", "--error=errors.x", "--order=0.9",
                   "--vary=Step size=0.008|0.004|0.002")
        self.accepts(*options)
        self.rejects("order", *options, flaw="order")

    def test_resume(self):
        self.accepts("resume")
        self.rejects("history.csv is not the same", "resume",
                     flaw="forgetful")

    def test_sigterm(self):
        self.accepts("sigterm")
        self.rejects("not == stopped", "sigterm", "--set=Steps=1")

    def test_check(self):
        self.accepts("check")
        self.rejects("--check wrote", "check", flaw="hasty")

    def test_refusal(self):
        options = ("refusal", "--message=must be positive",
                   "--set=Step size=0")
        self.accepts(*options)
        self.rejects("was written", *options, flaw="hasty")
        self.rejects("2 lines", *options, flaw="wordy")
        self.rejects("lacks", *options, "--message=not this")
        self.rejects("exit code 0", "refusal", "--message=")
        self.accepts("refusal", "--message=unknown entry 'Stops'",
                     "--content=Stops=1")

    def test_damaged_checkpoint(self):
        options = ("damaged_checkpoint", "--message=is truncated")
        self.accepts(*options)
        self.rejects("changed its output", *options, flaw="meddling")

    def test_foreign_checkpoint(self):
        options = ("foreign_checkpoint", "--message=of another scene")
        self.accepts(*options, "--argument=--set", "--argument=Scene=growth")
        self.rejects("exit code 0", *options)

    def test_disk(self):
        options = ("disk", "--message=cannot write", "--exit=3")
        self.accepts(*options)
        self.rejects("", *options, flaw="careless")

    def test_disk_without_mount(self):
        """The same where nothing may be mounted."""
        self.environment["PATH"] = os.path.join(self.root, "bin")
        os.makedirs(self.environment["PATH"])
        with open(os.path.join(self.environment["PATH"], "unshare"),
                  "w") as file:
            file.write("#!/bin/sh\nexit 1\n")
        os.chmod(file.name, 0o755)
        self.environment["PATH"] += ":" + os.environ["PATH"]
        self.test_disk()


if __name__ == "__main__":
    unittest.main()
