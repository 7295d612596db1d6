#!/usr/bin/env python3
"""Shows that each kind of run_case.py accepts an application that does as it
should, and rejects one with a flaw. The application is decay.py.

Stand-ins mostly sleep, so several tests run at a time. A case is a copy of this
process, which has read all modules before.

self_test.py           all, unless the files are those that have passed
self_test.py --note    all, and notes in self_test.sha256 that they have passed
self_test.py NAME...   such as JudgementTest.test_bounds
"""

import contextlib
import glob
import hashlib
import importlib.util
import json
import multiprocessing
import os
import subprocess
import sys
import tempfile
import traceback
import unittest

import run_case
from run_case import folder_cases

HERE = os.path.dirname(os.path.abspath(__file__))
AT_ONCE = 4
# The digest of the files that have passed, so that they need not pass again with
# every change of something else.
NOTED = os.path.join(HERE, "self_test.sha256")


class SelfTest(unittest.TestCase):
    """A folder with a parameter file for decay.py, and how to judge it."""

    program = "decay.py"
    file = "decay.prm"

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        self.write("decay.prm", "Time/Largest number of steps=60\n")
        self.environment = dict(os.environ)
        for name in ("CONTRECOUP_TEST_NAMESPACE", "CI"):
            self.environment.pop(name, None)

    def write(self, name, text):
        path = os.path.join(self.root, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def case(self, kind, *options, flaw="none"):
        """Runs one case; returns its exit code and output."""
        arguments = [kind, "--name=case", "--file=" + self.file,
                     "--set=Flaw=" + flaw, "--application="
                     + os.path.join(HERE, "stand_ins", self.program), *options]
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            child = os.fork()
            if child == 0:
                self.become(arguments, out, err)
            code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
            out.seek(0)
            err.seek(0)
            self.assertEqual(err.read().decode(), "")
            return code, out.read().decode()

    def become(self, arguments, out, err):
        """Continues as run_case.py with these arguments, in the test's folder
        and environment, to the end of the process."""
        code = 1
        try:
            os.dup2(out.fileno(), 1)
            os.dup2(err.fileno(), 2)
            sys.stdout, sys.stderr = open(1, "w"), open(2, "w")
            os.chdir(self.root)
            os.environ.clear()
            os.environ.update(self.environment)
            sys.argv = [os.path.join(HERE, "run_case.py"), *arguments]
            code = run_case.main(arguments)
        except SystemExit as end:
            code = end.code
        except BaseException:
            traceback.print_exc()
        finally:
            with contextlib.suppress(OSError):
                sys.stdout.flush()
                sys.stderr.flush()
            os._exit(code)

    def accepts(self, *arguments, **keywords):
        code, out = self.case(*arguments, **keywords)
        self.assertEqual(code, 0, out)

    def rejects(self, reason, *arguments, **keywords):
        code, out = self.case(*arguments, **keywords)
        self.assertEqual(code, 1, out)
        self.assertIn("FAILED", out)
        self.assertIn(reason, out)


class JudgementTest(SelfTest):
    def test_bounds(self):
        self.accepts("bounds", "--bound=errors.x < 2e-3",
                     "--bound=status == finished")
        self.rejects("is not < 1e-3", "bounds", "--bound=errors.x < 1e-3")
        self.rejects("no 'errors.y'", "bounds", "--bound=errors.y < 1")
        self.rejects("history.csv:3", "bounds", flaw="nan")

    def test_schema(self):
        self.accepts("schema")
        self.rejects("'' is too short", "schema", flaw="unitless")

    def test_several_kinds(self):
        options = ("bounds,resume", "--bound=errors.x < 2e-3")
        self.accepts(*options)
        self.rejects("FAILED: resume", *options, flaw="repeats")
        self.rejects("FAILED: bounds", *options, "--bound=errors.x < 1e-3")

    def test_needs(self):
        options = ("bounds", "--needs=/no/such/file")
        self.assertEqual(self.case(*options)[0], 77)
        self.environment["CI"] = "true"
        self.assertEqual(self.case(*options)[0], 1)

    def test_regression(self):
        options = ("regression", "--reference=references", "--tolerance=1e-12",
                   "--set=Writes=stem", "--compare=history.csv",
                   "--compare=fields/*.vti")
        self.environment["CONTRECOUP_UPDATE_REFERENCES"] = "1"
        self.accepts(*options)
        del self.environment["CONTRECOUP_UPDATE_REFERENCES"]
        self.accepts(*options)
        self.rejects("history.csv differs", *options,
                     "--set=Step size=0.0100000001")
        self.rejects("plane_0000.vti differs", *options, flaw="kink")
        self.rejects("references are of other files", *options,
                     "--compare=summary.json")

    def test_ranks(self):
        options = ("ranks", "--ranks=2", "--ranks=3")
        self.accepts(*options)
        self.rejects("history.csv differs", *options, flaw="rank")
        self.accepts(*options, "--tolerance=1e-10", "--tolerance=x=1e-5",
                     flaw="rank")
        self.rejects("history.csv differs", *options, "--tolerance=1e-6",
                     "--tolerance=history.csv:x=1e-10 absolute", flaw="rank")

    def test_same(self):
        options = ("same", "--vary=Skip=true|false")
        self.accepts(*options)
        self.rejects("not the same to the last bit", *options, flaw="skips")

    def test_convergence(self):
        options = ("convergence", "--error=errors.x", "--order=0.9",
                   "--vary=Step size=0.008|0.004|0.002")
        self.accepts(*options)
        self.rejects("order", *options, flaw="order")

    def test_check_files(self):
        self.write("scenes/first.prm", "Scene=first\n")
        self.write("scenes/more/second.prm", "Scene=second\n")
        self.file = "scenes/first.prm"
        self.accepts("check_files")
        self.rejects("--check wrote", "check_files", flaw="hasty")
        for flaw in ("silent", "rankless"):
            self.rejects("printed no plan", "check_files", flaw=flaw)
        self.rejects("not used", "check_files", flaw="thoughtless")
        self.rejects("0 reports are of", "check_files", flaw="nameless")
        self.write("scenes/more/second.prm", "Scenery=second\n")
        self.rejects("1 of 2 files: more/second.prm", "check_files")
        skip = "--needs=more/second.prm=/no/such/file"
        self.assertEqual(self.case("check_files", skip)[0], 77)
        self.environment["CI"] = "true"
        self.assertEqual(self.case("check_files", skip)[0], 1)

    def test_refusal(self):
        options = ("refusal", "--message=must be positive",
                   "--set=Step size=0")
        self.accepts(*options)
        self.rejects("was written", *options, flaw="hasty")
        self.rejects("2 lines", *options, flaw="wordy")
        self.rejects("lacks", *options, "--message=not this")
        self.rejects("exit code 0", "refusal", "--message=")
        program = "--application=" + os.path.join(HERE, "stand_ins", self.program)
        table = [["--name=decay_refuses_" + name, program, "--file=decay.prm",
                  "--set=" + entry, "--message=" + message]
                 for name, entry, message in (
                     ("stops", "Stops=5", "unknown entry 'Stops'"),
                     ("time", "Stops=5", "must be positive"))]
        self.write("table.json", json.dumps(table[:1]))
        self.accepts("refusals", "--argument=table.json")
        self.write("table.json", json.dumps(table))
        self.rejects("2 refusals, 1 failed", "refusals", "--argument=table.json")
        self.rejects("FAILED: refusals: decay_refuses_time\n", "refusals",
                     "--argument=table.json")
        self.environment["CONTRECOUP_ONLY"] = "_stops"
        self.accepts("refusals", "--argument=table.json")
        self.environment["CONTRECOUP_ONLY"] = "no_such"
        self.rejects("no name has", "refusals", "--argument=table.json")
        self.accepts("refusal", "--message=unknown entry 'Stops'",
                     "--content=Stops=1")


class ResumeTest(SelfTest):
    def test_resume(self):
        options = ("resume", "--stop-after=5", "--stop-after=20")
        self.accepts(*options)
        self.rejects("history.csv is not the same", *options, flaw="forgetful")
        self.rejects("resumed_from_step", *options, flaw="repeats")
        self.rejects("updates were made", *options, flaw="wasteful")
        self.rejects("results differ", *options, flaw="low")
        self.rejects("skipped_updates is 0.1 instead", *options, flaw="dozing")

    def test_sigterm(self):
        options = ("sigterm", "--stop-after=2")
        self.accepts(*options)
        # A run that is past the end of the straight one when it is stopped.
        self.accepts(*options, "--set=Time/Largest number of steps=2")
        self.rejects("exit code 0 instead of 143", *options,
                     "--set=Brief=true")
        self.rejects("exit code 0 instead of 143", *options, flaw="content")
        self.rejects("history.csv is not the same", *options, flaw="forgetful")
        self.rejects("resumed_from_step", *options, flaw="repeats")
        self.rejects(" is not == ", *options, flaw="late")

    def test_sigkill(self):
        options = ("sigkill", "--stop-after=2")
        self.accepts(*options)
        self.rejects("history.csv is not the same", *options, flaw="forgetful")
        self.rejects("resumed_from_step", *options, flaw="repeats")
        self.rejects("exit code 0 instead of -9", *options, "--set=Brief=true")

    def test_on_two_ranks(self):
        for kind in ("parallel_resume", "parallel_sigterm",
                     "parallel_sigkill"):
            options = (kind, "--stop-after=5", "--ranks=2")
            self.accepts(*options)
            self.rejects("history.csv differs", *options, flaw="forgetful")
            self.rejects("resumed_from_step", *options, flaw="repeats")

    def test_failure(self):
        options = ("failure", "--exit=2", "--message=it fails",
                   "--set=Fails at=40", "--argument=--set",
                   "--argument=Fails at=")
        self.accepts(*options)
        self.rejects("no checkpoint", *options, flaw="untidy")
        self.rejects("in other words", *options, flaw="talkative")
        self.rejects("exit code 2", *options, "--argument=--set",
                     "--argument=Fails at=50")

    def test_damaged_checkpoint(self):
        options = ("damaged_checkpoint", "--message=is truncated")
        self.accepts(*options)
        self.rejects("changed its output", *options, flaw="meddling")

    def test_foreign_checkpoint(self):
        options = ("foreign_checkpoint", "--message=of another scene")
        self.accepts(*options, "--argument=--set", "--argument=Scene=growth")
        self.rejects("exit code 0", *options)

    def test_other_build(self):
        self.accepts("other_build")
        self.rejects("exit code 0", "other_build", flaw="gullible")
        self.rejects("exit code 0", "other_build", flaw="lenient")
        self.rejects("does not name both", "other_build", flaw="mute")
        self.rejects("history.csv is not the same", "other_build",
                     flaw="forgetful")

    def test_disk(self):
        self.accepts("disk")
        self.rejects("no longer intact", "disk", flaw="careless")
        self.rejects("manifest.json says finished", "disk", flaw="boastful")
        self.rejects("half-written", "disk", flaw="messy")

    def test_parallel_disk(self):
        self.accepts("parallel_disk")
        self.rejects("no longer intact", "parallel_disk", flaw="careless")

    def test_quota(self):
        self.accepts("quota")
        self.rejects("exit code -25, expected 3", "quota", flaw="fragile")

    def test_disk_anew(self):
        self.write("decay.prm", "Time/Largest number of steps=6\n")
        options = ("disk_anew", "--set=Output/Checkpoint every steps=2")
        self.accepts(*options)
        self.rejects("manifest.json says finished", *options, flaw="boastful")
        self.rejects("not the same to the last bit", *options, flaw="changing")

    def test_disk_without_mount(self):
        """The same where nothing may be mounted."""
        self.write("bin/unshare", "#!/bin/sh\nexit 1\n")
        folder = os.path.join(self.root, "bin")
        os.chmod(os.path.join(folder, "unshare"), 0o755)
        self.environment["PATH"] = folder + ":" + os.environ["PATH"]
        self.test_disk()


class ResultTest(SelfTest):
    def setUp(self):
        super().setUp()
        self.write("decay.prm", "Time/Largest number of steps=2\n")

    def test_pictures(self):
        options = ("pictures", "--set=Writes=pictures",
                   "--compare=history.png")
        self.accepts(*options)
        self.rejects("of one colour", *options, flaw="blank")
        self.rejects("is no picture", *options, flaw="cut")
        self.rejects("does not say", "pictures", "--compare=history.png")

    def test_stem(self):
        options = ("stem", "--set=Writes=stem", "--bound=deviation < 1e-3")
        self.accepts(*options)
        self.rejects("deviation", *options, flaw="kink")

    def test_wedge(self):
        options = ("wedge", "--set=Writes=wedge", "--angle=60",
                   "--bound=reflected > 19", "--bound=reflected < 21")
        self.accepts(*options)
        self.rejects("is not < 21", *options, flaw="steep")

    def test_reflection(self):
        options = ("reflection", "--set=Writes=reflection", "--height=1",
                   "--bound=regular_up_to > 1.15",
                   "--bound=regular_up_to < 1.25")
        self.accepts(*options)
        self.rejects("is not < 1.25", *options, flaw="far")
        self.rejects("plot.py triple_point", "reflection", "--set=Writes=stem",
                     "--height=1")

    def test_gauge_lines(self):
        options = ("gauge_lines", "--set=Writes=line", "--vary=Skip=false|true",
                   "--bound=peak < 0.05", "--bound=rise < 1e-9",
                   "--bound=unknown == 0")
        self.accepts(*options)
        self.rejects("peak = 0.1", *options, flaw="other")
        self.rejects("rise = 0.56", *options, flaw="deadly")

    def test_foreign_reader(self):
        if importlib.util.find_spec("meshio") is None:
            self.skipTest("there is no python3-meshio")
        options = ("foreign_reader", "--set=Writes=vtu")
        self.accepts(*options)
        self.rejects("meshio cannot read", *options, flaw="words")

    def test_arrival(self):
        options = ("arrival", "--set=Writes=gauges",
                   "--bound=first_sample > 0.45", "--bound=first_sample < 0.55",
                   "--bound=samples_at_rest < 3",
                   "--bound=impulse_difference < 1e-9")
        self.accepts(*options)
        self.rejects("first_sample", *options, flaw="early")
        self.rejects("impulse_difference", *options, flaw="leaky")

    def test_gauge_order(self):
        options = ("gauge_order", "--set=Writes=gauges",
                   "--vary=Step size=0.04|0.02", "--error=1 0.01 1.98",
                   "--bound=order_1 > 0.9", "--bound=error_1 < 0.03")
        self.accepts(*options)
        self.rejects("order_1", *options, flaw="flat")
        last = options[:3] + ("--error=1 0.01 last 1",) + options[4:]
        self.accepts(*last)
        self.rejects("order_1", *last, "--error=1 0.01 1")


class CostTest(SelfTest):
    def test_presets(self):
        promise = "# peaks {} %, impulses {} %; updates {} times\n"
        steps = "Time/Largest number of steps="
        self.write("scene.prm", "#   1  5.0  10.0\ninclude fast.prm\n")
        self.write("fast.prm", promise.format(10, 5, 1)
                   + "Step size=0.1\n" + steps + "3\n")
        self.write("fine.prm", promise.format(5, 2.5, 2)
                   + "Step size=0.05\n" + steps + "6\n")
        self.file = "scene.prm"
        options = ("presets", "--compare=fast", "--compare=fine")
        self.accepts(*options)
        self.write("fine.prm", promise.format(5, 2.5, 2)
                   + "Step size=0.06\n" + steps + "6\n")
        self.rejects("the error is 6.00 %", *options)
        self.write("fine.prm", promise.format(5, 2.5, 2)
                   + "Step size=0.05\n" + steps + "9\n")
        self.rejects("makes 3.00 times", *options)

    def test_domain(self):
        options = ("domain", "--bound=difference < 0.02",
                   "--bound=short_difference > 0.1")
        self.write("decay.prm", "Time/Largest number of steps=2\n")
        self.accepts(*options)
        self.rejects("is not < 0.02", *options, flaw="narrow")

    def test_whole_body(self):
        options = ("whole_body", "--set=Boundaries/y low=symmetry",
                   "--bound=difference < 1e-9", "--bound=across < 1e-9",
                   "--bound=part < 0.51", "--bound=whole < 0.51")
        self.write("decay.prm", "Time/Largest number of steps=2\n")
        self.accepts(*options)
        self.rejects("difference = ", *options, flaw="halved")


class SceneTest(SelfTest):
    program = "stand_in_scene.py"

    def test_run(self):
        options = ("scene_run", "--bound=status == finished")
        self.accepts(*options)
        self.rejects("is not == late", "scene_run", "--bound=status == late")
        self.rejects("is not among the changes", *options,
                     "--set=Tissues/Tissue foam/Density=100")
        self.rejects("stages of a second run", *options, flaw="restless")
        self.rejects("other tissues made the blast", *options,
                     flaw="forgetful")
        self.rejects("other tissues changed nothing", *options, flaw="deaf")
        self.rejects("which is not said", *options, flaw="wordless")
        self.rejects("report", *options, flaw="silent")
        self.rejects("coarser_run is {", *options, flaw="lingering")
        self.rejects("blast has a body of 50", *options, flaw="heavy")
        self.rejects("height and mass of the charge", *options, flaw="low")
        self.rejects("false gave 1", *options, flaw="unrepeatable")
        self.rejects("what was taken for granted", *options, flaw="foreign")

    def test_ranks(self):
        options = ("scene_ranks", "--ranks=2", "--set=Pause=0")
        self.accepts(*options)
        for flaw in ("injuries", "loads", "peaks"):
            self.rejects(flaw + " on 2 ranks", *options, flaw=flaw)
        self.accepts(*options, "--tolerance=injuries:str*=2e-5",
                     flaw="injuries")

    def test_sigkill(self):
        self.accepts("scene_sigkill")
        self.rejects("injuries are others", "scene_sigkill", flaw="careless")
        self.rejects("went on from step 0", "scene_sigkill", flaw="repeats")
        self.rejects("updates instead of", "scene_sigkill", flaw="wasteful")
        self.rejects("exit code 0", "scene_sigkill", flaw="ruthless")
        self.rejects("ended before it was killed", "scene_sigkill",
                     flaw="hurried")

    def test_parallel_sigkill(self):
        options = ("scene_parallel_sigkill", "--ranks=2",
                   "--set=Pause=0.2")
        self.accepts(*options)
        self.rejects("after kills on 2 ranks", *options, flaw="careless")
        self.rejects("went on from step 0", *options, flaw="repeats")
        self.rejects("updates instead of", *options, flaw="wasteful")

    def test_failure(self):
        self.accepts("scene_failure")
        self.rejects("stderr is", "scene_failure", flaw="wordy")
        self.rejects("blast was not kept", "scene_failure", flaw="lossy")

    def test_full_disk(self):
        options = ("scene_full_disk", "--set=Large=true", "--set=Pause=0")
        self.accepts(*options)
        self.rejects("stage.json", *options, flaw="destructive")
        self.rejects("stderr on 1 ranks", *options, flaw="wordy")
        self.rejects("exit code 0", *options, "--set=Large=")


class NumbersTest(SelfTest):
    program = "stand_in_numbers.py"

    def setUp(self):
        super().setUp()
        subprocess.run([os.path.join(HERE, "stand_ins", self.program),
                        os.path.join(self.root, "drawn")], check=True,
                       stdout=subprocess.DEVNULL)

    def test_one_number(self):
        self.accepts("one_number")
        for flaw, reason in [("estimate", "air: peak"), ("check", "--check: "),
                             ("plan", "plan: "), ("answer", "headline.txt"),
                             ("stage", "anatomy: the report shows '2.26 GiB'"),
                             ("table", "impulse"), ("history", "end of blast"),
                             ("report", "2.278"),
                             ("silent", "in warnings")]:
            self.rejects(reason, "one_number", flaw=flaw)


class FolderTest(SelfTest):
    def setUp(self):
        super().setUp()
        self.add_program("blast")

    def add_program(self, name):
        os.symlink(os.path.join(HERE, "stand_ins", "stand_in_folder.py"),
                   os.path.join(self.root, name))

    def case(self, kind, *options, flaw="none"):
        return super().case(kind, "--application=./blast", *options, flaw=flaw)

    def test_finished(self):
        options = ("folder_finished", "--argument=Steps=4")
        self.accepts(*options)
        self.rejects("is gone or changed", *options, flaw="greedy")
        self.rejects("it says: ", *options, flaw="forgetful")
        self.rejects("not say what it removes", *options, flaw="silent")
        self.rejects("exit code 0", *options, flaw="rewinds")

    def test_foreign(self):
        options = ("folder_foreign", "--compare=history.csv",
                   "--compare=fields/fields_0000.vtu")
        self.accepts(*options)
        self.rejects("exit code 0", *options, flaw="ruthless")

    def test_lock(self):
        options = ("folder_lock", "--argument=--set", "--argument=Steps=1000")
        self.accepts(*options)
        self.rejects("exit code 0", *options, flaw="shares")
        self.rejects("exit code 0", *options, flaw="forgetful")

    def test_begins(self):
        options = ("folder_begins", "--argument=--set",
                   "--argument=Steps=1000", "--argument=--set",
                   "--argument=Brief=true")
        self.accepts(*options)
        self.rejects("does not say that it begins", *options, flaw="silent")
        self.rejects("exit code 0", *options, flaw="rash")

    def test_signals(self):
        options = ("folder_signals", "--compare=history.csv",
                   "--argument=--set", "--argument=Steps=1000")
        self.accepts(*options)
        self.rejects("gave 0", *options, flaw="content")
        self.rejects("went on from step 0", *options, flaw="repeats")

    def test_read_only(self):
        options = ("folder_read_only", "--argument=--set",
                   "--argument=Steps=1000")
        self.accepts(*options)
        self.rejects("exit code 0", *options, flaw="careless")
        self.rejects("exit code 1", *options, flaw="confused")

    def test_ranks(self):
        options = ("folder_ranks", "--argument=Precision=single",
                   "--set=Steps=20", "--stop-after=6", "--mpi=2")
        self.accepts(*options)
        self.rejects("went on from step 0", *options, flaw="repeats")
        self.rejects("exit code 0", *options, flaw="forgetful")

    def test_cache(self):
        self.accepts("folder_cache")
        self.rejects("no cache in", "folder_cache", flaw="cached")
        self.add_program("study")
        options = ("folder_cache", "--application=./study",
                   "--compare=history.csv")
        self.accepts(*options)
        self.rejects("stderr is there is no home", *options, flaw="homesick")
        self.rejects("report.html", *options, "--compare=report.html")

    def test_no_report(self):
        options = ("folder_no_report", "--set=Brief=true")
        self.accepts(*options)
        self.rejects("it said", *options, flaw="mute")
        self.rejects("exit code 0", *options, flaw="content")

    def test_stop_in_drawing(self):
        options = ("folder_stop_in_drawing", "--set=Brief=true")
        self.accepts(*options)
        self.rejects("it does not say 'asked to stop", *options, flaw="mute")
        self.rejects("gave 3", *options, flaw="content")
        self.add_program("scene")
        self.accepts(*options, "--application=./scene")

    def test_default(self):
        for name, (file, _) in folder_cases.BRIEF.items():
            self.write("files/" + file, "")
            if name != "blast":
                self.add_program(name)
        options = ("folder_default", "--file=files/scene/verification/head.prm",
                   "--application=" + os.path.join(self.root, "blast"))
        self.accepts(*options)
        self.rejects("does not say 'results in", *options, flaw="shared")


class StudyTest(SelfTest):
    program = "study"

    def setUp(self):
        super().setUp()
        # Where it is, there is the application blast as well.
        for name in ("study", "blast"):
            os.symlink(os.path.join(HERE, "stand_ins", "stand_in_study.py"),
                       os.path.join(self.root, name))

    def case(self, kind, *options, flaw="none"):
        return super().case(kind, "--application=./study", *options,
                            flaw=flaw)

    def test_run(self):
        options = ("study_run", "--bound=status == finished",
                   "--compare=a.png")
        self.accepts(*options)
        self.rejects("is not == late", "study_run", "--bound=status == late")
        self.rejects("is empty", *options, flaw="blank")
        self.rejects("has error 0.5", *options, flaw="wrong")

    def test_distance(self):
        options = ("study_distance", "--set=Writes=distances")
        self.accepts(*options)
        self.rejects("loads_chest_peak: [", *options, flaw="wrong")
        self.rejects("results.probe_1_peak_overpressure: [", *options,
                     flaw="rising")
        self.rejects("deaths: [", *options, flaw="deathless")
        self.rejects("curves.png is empty", *options, flaw="blank")

    def test_sigterm(self):
        self.accepts("study_sigterm")
        self.rejects("was repeated", "study_sigterm", flaw="restless")
        self.rejects("exit code 143", "study_sigterm", flaw="confused")

    def test_storage(self):
        self.accepts("study_storage")
        self.rejects("was repeated", "study_storage", flaw="restless")
        self.rejects("exit code 0", "study_storage", flaw="careless")
        self.rejects("it counts as finished", "study_storage",
                     flaw="boastful")

    def test_quota(self):
        self.accepts("study_quota")
        self.rejects("was repeated", "study_quota", flaw="restless")
        self.rejects("exit code 0", "study_quota", flaw="careless")

    def test_sigkill(self):
        self.accepts("study_sigkill")
        self.rejects("was repeated", "study_sigkill", flaw="restless")


def names(suite):
    """Names of all tests in a suite of suites."""
    for test in suite:
        if isinstance(test, unittest.TestSuite):
            yield from names(test)
        else:
            yield test.id()


def prove(name):
    """Runs one test; returns its name and what is wrong with it."""
    result = unittest.TestResult()
    unittest.defaultTestLoader.loadTestsFromName(name).run(result)
    flaws = [text for _, text in result.failures + result.errors]
    if result.testsRun != 1 or result.skipped:
        flaws.append("it did not run")
    return name, flaws


def digest():
    """Digest of the Python files under test and of the tests themselves."""
    total = hashlib.sha256()
    for path in sorted(glob.glob(os.path.join(HERE, "**", "*.py"),
                                 recursive=True)):
        with open(path, "rb") as file:
            total.update(os.path.relpath(path, HERE).encode() + file.read())
    return total.hexdigest() + "\n"


def main(arguments):
    notes, tried = arguments == ["--note"], digest()
    arguments = [] if notes else arguments
    if not arguments and not notes and os.path.exists(NOTED):
        with open(NOTED, encoding="utf-8") as file:
            if file.read() == tried:
                print("the files are those that have passed")
                return 0
    wanted = [f"{__name__}.{name}" for name in arguments] or list(names(
        unittest.defaultTestLoader.loadTestsFromModule(sys.modules[__name__])))
    wrong = 0
    with multiprocessing.get_context("fork").Pool(AT_ONCE) as workers:
        for name, flaws in workers.imap_unordered(prove, wanted):
            print(name, "FAILED" if flaws else "ok", flush=True)
            print("".join(flaws), end="", flush=True)
            wrong += bool(flaws)
    print(f"{len(wanted)} tests, {wrong} failed")
    if notes and not wrong:
        with open(NOTED, "w", encoding="utf-8") as file:
            file.write(tried)
    return 1 if wrong or not wanted else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
