"""Tests of output folders, in which nothing may be lost; kinds of run_case.py.
Applications with checkpoints are stopped by --stop-after steps."""

import contextlib
import glob
import json
import os
import re
import resource
import shutil
import signal
import stat
import subprocess
import time
import zlib

import full_disk
import resume_cases
from case import read_bytes, read_json, read_summary, require, snapshot
from machine_cases import told_once

# Files of a user, in places where no application writes.
FOREIGN = ("thesis.txt", "fields/x.txt", "blast/thesis.txt", "anatomy/data.csv",
           "checkpoint/0001/note.txt", "pictures/holiday.jpg", "variants/y.txt")


def manifest(output):
    return read_json(output, "manifest.json")


def put(folder, *names):
    for name in names:
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write("not of Contrecoup: " + name)


def has_foreign(folder):
    for name in FOREIGN:
        path = os.path.join(folder, name)
        require(os.path.exists(path) and read_bytes(path).decode()
                == "not of Contrecoup: " + name, f"{path} is gone or changed")


def is_solver(case):
    return os.path.basename(case.options.application) in (
        "blast", "biomechanics", "head_impact")


def has_steps(case):
    return is_solver(case) or os.path.basename(
        case.options.application) == "scene"


def refused(case, output, message, extra=(), code=1, **keywords):
    """One line on stderr that has the message, and nothing changes in a folder
    of the test besides the lock that a killed run left."""
    watched = output.startswith(case.options.name) and keywords == {}
    before = snapshot(output) if watched else {}
    _, _, err = case.run(output, extra, codes=(code,), **keywords)
    lines = err.strip().splitlines()
    if case.options.mpi > 1:
        # mpirun has its own opinion of exit codes.
        lines = [line for line in lines if line.startswith("error: ")]
    require(len(lines) == 1 and message in lines[0],
            f"not one line with '{message}': {err}")
    after = snapshot(output) if watched else {}
    changed = {name for name in before.keys() | after.keys()
               if name != "lock" and before.get(name) != after.get(name)}
    require(not changed, f"the refused run changed {changed}")


def folder_finished(case):
    """Files of a user survive every command; a finished run stays as it is
    until --overwrite; what was changed is refused, and other entries are
    named. The first --argument is an entry with another value, an earlier end
    where there are checkpoints, which --resume refuses."""
    output = case.folder("run")
    put(output, *FOREIGN)
    case.run(output)
    has_foreign(output)
    require(manifest(output)["status"] == "finished", "it did not finish")
    require(not os.path.exists(os.path.join(output, "lock")), "a lock is left")
    before = snapshot(output)
    _, out, _ = case.run(output)
    require("--overwrite" in out and "finished" in out
            and ("--resume" in out) == has_checkpoint(output), f"it says: {out}")
    require(snapshot(output) == before, "a finished folder was changed")
    other = ["--set", case.options.argument[0]]
    refused(case, output, case.options.argument[0].split("=")[0], other)
    if has_checkpoint(output):
        refused(case, output, "s already", other + ["--resume"])
    _, out, _ = case.run(output, other + ["--overwrite"])
    require("removing" in out, f"it does not say what it removes: {out}")
    has_foreign(output)
    require(manifest(output)["status"] == "finished", "it did not finish")
    entry, value = case.options.argument[0].split("=")
    require(manifest(output)["entries"][entry] == value, "it ran as before")


def folder_foreign(case):
    """Files of a user in the place of results are never overwritten; --output
    cannot be the root, the home folder, or one of another application."""
    for name in case.options.compare:
        output = case.folder("run_" + name.replace("/", "_"))
        put(output, name)
        refused(case, output, name, ["--overwrite"])
        refused(case, output, name)
    refused(case, "/", "root", ["--overwrite"])
    home = case.folder("home")
    put(home, "letter.txt")
    os.environ["HOME"] = os.path.abspath(home)
    refused(case, home, "home", ["--overwrite"])
    if is_solver(case):
        output = case.folder("parameter_files")
        shipped = ("sod.prm", "quickstart.png")
        put(output, *shipped)
        case.run(output)
        require(set(shipped) <= set(os.listdir(output)), "files are gone")
    output = case.folder("locked")
    put(output, "lock")
    refused(case, output, "lock")
    output = case.folder("manifest")
    put(output, "manifest.json")
    refused(case, output, "manifest.json", ["--overwrite"])


def wait_until(process, condition, what):
    while process.poll() is None and not condition():
        time.sleep(0.01)
    require(process.poll() is None, f"it ended before {what}")


def has_checkpoint(output):
    return bool(glob.glob(os.path.join(output, "**", "checkpoint", "*",
                                       "complete.json"), recursive=True))


def folder_lock(case):
    """The second run in a folder is told who is there; after kill -9 the next
    one knows the files for Contrecoup's and begins again. --argument: what
    makes a long run with checkpoints."""
    output = case.folder("run")
    process = case.start(output, case.options.argument)
    number = process.pid
    try:
        wait_until(process, lambda: os.path.exists(
            os.path.join(output, "manifest.json")), "it had begun")
        holder = read_bytes(output, "lock").decode()
        number = int(holder.split("process ")[1].split(" ")[0])
        refused(case, output, f"process {number} on ",
                case.options.argument + ["--overwrite"], ranks=1)
        if is_solver(case):
            wait_until(process, lambda: has_checkpoint(output), "a checkpoint")
    finally:
        # mpirun ends the other ranks.
        os.kill(number, signal.SIGKILL)
        process.communicate()
    require(os.path.exists(os.path.join(output, "lock")), "it was not killed")
    require(manifest(output)["status"] == "started", "it was not killed")
    if is_solver(case):
        refused(case, output, "--resume goes on with it",
                case.options.argument)
    case.run(output, ["--overwrite"])
    require(manifest(output)["status"] == "finished", "it did not finish")


def folder_begins(case):
    """--resume of a run that was killed before it left anything to continue
    from begins, and says so; a folder with files of a user, or of
    another application, is refused. --argument makes a long run without
    checkpoints."""
    output = case.folder("run")
    process = case.start(output, case.options.argument)
    try:
        wait_until(process, lambda: os.path.exists(
            os.path.join(output, "manifest.json")), "it had begun")
    finally:
        for pid in resume_cases.descendants(process.pid):
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        process.communicate()
    require(not has_checkpoint(output), "it left a checkpoint")
    require(manifest(output)["status"] == "started", "it was not killed")
    _, out, _ = case.run(output, ["--resume"])
    require("holds nothing to go on with yet; the run begins" in out,
            f"it does not say that it begins: {out}")
    require(manifest(output)["status"] == "finished", "it did not finish")
    if is_solver(case):
        require(read_summary(output)["resumed_from_step"] is None, "it went on")
    output = case.folder("foreign")
    put(output, "letter.txt")
    refused(case, output, "--resume: ", ["--resume"])
    output = case.folder("other")
    put_other_run(output)
    refused(case, output, "--resume: ", ["--resume"])


def ranks_of(process):
    """The numbers of the ranks of a run under mpirun, in their order."""
    ranks = {}
    for pid in resume_cases.descendants(process.pid):
        word = re.search(r"OMPI_COMM_WORLD_RANK=(\d+)", environment_of(pid))
        if word:
            ranks.setdefault(int(word[1]), pid)
    require(ranks, "mpirun has started no rank")
    return [ranks[rank] for rank in sorted(ranks)]


def environment_of(pid):
    try:
        return read_bytes("/proc", str(pid), "environ").decode(errors="replace")
    except OSError:
        return ""


def folder_signals(case):
    """SIGINT ends with 130, SIGTERM with 143, SIGUSR1 with 138, so that what
    comes after && does not begin; what is left is neither lost without a
    question nor taken for finished, and --resume continues from the
    checkpoint. Under mpirun one of the ranks gets the signal, or mpirun
    SIGUSR1, which is the one that it gives them time for. --argument makes a
    long run; of several --exit codes, these are tried, the last with
    --resume."""
    extra = case.options.argument
    codes = case.options.exit or [130, 138, 143]
    for asked in (signal.Signals(code - 128) for code in codes):
        output = case.folder(f"run_{int(asked)}")
        process = case.start(output, extra)
        wait_until(process, lambda: os.path.exists(
            os.path.join(output, case.options.compare[0])), "its first output")
        time.sleep(0.1)
        if case.options.mpi == 1 or asked == signal.SIGUSR1:
            process.send_signal(asked)
        else:
            os.kill(ranks_of(process)[-1], asked)
        out, err = process.communicate()
        require(process.returncode == 128 + asked,
                f"{asked!r} gave {process.returncode}: {out[-999:]}{err[-999:]}")
        if case.options.mpi == 1:
            require(err == "", f"stderr is {err}")
        require("error: " not in err, f"stderr is {err}")
        if not has_checkpoint(output):
            require(not has_steps(case), "it left no checkpoint")
            continue
        require(manifest(output)["status"] == "stopped", "it did not stop")
        refused(case, output, "--resume goes on with it", extra)
        if 128 + asked == codes[-1]:
            goes_on(case, output)


def folder_signals_in_forecast(case):
    """SIGTERM while a scene tries coarser runs of its blast ends it with 143, and
    the screen says so."""
    os.environ.update(XDG_CACHE_HOME=os.path.abspath("no_forecasts"),
                      CONTRECOUP_CHECK_SECONDS="4")
    output = case.folder("run")
    log = os.path.join(output, "log.txt")
    process = case.start(output)
    wait_until(process, lambda: os.path.exists(log) and b"Calibrating" in
               read_bytes(log).partition(b"stage blast:")[2], "its trial runs")
    process.send_signal(signal.SIGTERM)
    out, err = process.communicate()
    require(process.returncode == 143 and err == "",
            f"it gave {process.returncode}: {out[-999:]}{err[-999:]}")
    require("stopped in the forecast" in out, f"the screen ends with {out[-999:]}")
    require(b"blast would run" not in read_bytes(log),
            "the forecast took a stopped run for a whole one")


def goes_on(case, output):
    """--resume begins with the step of the newest checkpoint, a scene's on one
    rank, and after another precision was refused."""
    newest = max(glob.glob(os.path.join(output, "**", "checkpoint", "*",
                                        "complete.json"), recursive=True))
    step = read_json(os.path.dirname(newest), "run.json")["state"]["step"]
    require(step > 0, "the checkpoint is of the beginning")
    few = ["--set", "Time/Steps in this run=2"] if is_solver(case) else []
    # Other numbers of ranks and precisions of solvers: see folder_ranks().
    if not is_solver(case):
        refused(case, output, "--overwrite begins that stage anew",
                case.options.argument + ["--resume", "--set",
                                         "Blast/Method/Precision=double"],
                ranks=1)
    case.run(output, case.options.argument + few + ["--resume"],
             ranks=None if is_solver(case) else 1)
    stage = os.path.dirname(os.path.dirname(os.path.dirname(newest)))
    begin = read_summary(stage)["resumed_from_step"]
    require(begin == step, f"it went on from step {begin}, not from {step}")


def folder_read_only(case):
    """A folder that is not writable is refused with 1, and a file system that
    turns read-only in the middle of a run ends it with 3. --argument: what
    makes a long run with checkpoints."""
    output = case.folder("run")
    put(output, "a_file")
    refused(case, os.path.join(output, "a_file"), "output folder")
    refused(case, os.path.join(output, "a_file", "below"), "output folder")
    if full_disk.NAMESPACE not in os.environ:
        without_mounts(case, output)
        return
    with full_disk.small_disk(case.folder("disk"), 256 << 20) as (folder, _, _):
        process = case.start(folder, case.options.argument)
        wait_until_under_way(case, process, folder)
        with read_only(folder):
            out, err = process.communicate()
        require(process.returncode == 3,
                f"exit code {process.returncode}: {out[-999:]}{err[-999:]}")
        told_once(err, "Read-only file system", ranks=case.options.mpi)
        if not os.path.exists(os.path.join(folder, "manifest.json")):
            return
        require(manifest(folder)["status"] != "finished", "it is finished")
        extra = ["--resume"] if has_steps(case) else []
        if is_solver(case):
            extra += ["--set", "Time/Steps in this run=1"]
        case.run(folder, case.options.argument + extra)


def wait_until_under_way(case, process, folder):
    """Until a run has a checkpoint; what has no steps, until it has begun."""
    if has_steps(case):
        wait_until(process, lambda: has_checkpoint(folder), "a checkpoint")
    else:
        wait_until(process, lambda: os.path.exists(
            os.path.join(folder, "lock")), "it had begun")


def without_mounts(case, output):
    """As folder_read_only() where nothing can be mounted, as in most containers:
    a folder without the right to write, and files that may grow no more."""
    os.chmod(output, stat.S_IRUSR | stat.S_IXUSR)
    refused(case, output, "is not writable",
            preexec_fn=full_disk.obey_permissions)
    os.chmod(output, stat.S_IRWXU)
    folder = case.folder("limited")
    process = case.start(folder, case.options.argument, preexec_fn=lambda:
                         full_disk.limit_files(resource.RLIM_INFINITY))
    wait_until_under_way(case, process, folder)
    full_disk.limit_running(process, 1)
    out, err = process.communicate()
    require(process.returncode == 3,
            f"exit code {process.returncode}: {out[-999:]}{err[-999:]}")
    told_once(err, "File too large", ranks=case.options.mpi)


@contextlib.contextmanager
def read_only(folder):
    """Mounts the folder once more, read-only, over itself: files that are open
    stay so, which a file system that is in use would not allow otherwise."""
    subprocess.run(["mount", "--bind", folder, folder], check=True)
    try:
        # Refused while a file is open that was opened after the first mount.
        for _ in range(1000):
            remount = subprocess.run(
                ["mount", "-o", "remount,bind,ro", folder], text=True,
                capture_output=True)
            if remount.returncode == 0:
                break
            time.sleep(0.001)
        require(remount.returncode == 0, remount.stderr)
        yield
    finally:
        subprocess.run(["umount", folder], check=True)


def folder_ranks_fail(case):
    """All ranks but the first cannot write their part of a checkpoint: exit code
    3, one line, and the run continues from the checkpoint before. --argument
    makes a long run with checkpoints."""
    output = case.folder("run")
    process = case.start(output, case.options.argument)
    wait_until(process, lambda: has_checkpoint(output), "a checkpoint")
    for rank in ranks_of(process)[1:]:
        resource.prlimit(rank, resource.RLIMIT_FSIZE, (1000, 1000))
    _, err = process.communicate()
    require(process.returncode == 3, f"exit code {process.returncode}: {err}")
    told_once(err, "checkpoint", "File too large", ranks=case.options.mpi)
    require(manifest(output)["status"] == "failed", "it has not failed")
    case.run(output, case.options.argument
             + ["--resume", "--set", "Time/Steps in this run=1"], ranks=1)


def folder_cache(case):
    """--check does without its cache where none can be kept: the place is a
    file, a folder that is not writable, or one that is not there. With the last,
    which is the home as well, whoever starts others and draws makes the --compare
    files."""
    put(case.folder(""), "a_file")
    closed = case.folder("closed")
    os.makedirs(closed)
    os.chmod(closed, 0)
    os.environ["CONTRECOUP_CHECK_SECONDS"] = "0.2"
    for place in (case.folder("a_file"), closed, "/proc/nowhere"):
        os.environ["XDG_CACHE_HOME"] = os.path.abspath(place)
        _, out, err = case.run(case.folder("run"), ["--check"])
        require("The parameters are valid." in out and err == "",
                f"with the cache in {place}: {out}{err}")
        require(not os.path.exists(case.folder("run")), "--check wrote results")
    os.chmod(closed, stat.S_IRWXU)
    require(not os.listdir(closed) or os.geteuid() == 0, "it was not closed")
    if is_solver(case):
        return
    os.environ["HOME"] = os.environ["XDG_CONFIG_HOME"] = "/proc/nowhere"
    output = case.folder("run")
    _, _, err = case.run(output)
    require(err == "", f"stderr is {err}")
    for name in case.options.compare:
        require(os.path.getsize(os.path.join(output, name)) > 0,
                f"{name} is empty")


def folder_no_report(case):
    """A scene whose report fails says why, on the screen and in the log, and that
    it is not there; the next start makes it."""
    output = case.folder("run")
    # Python reads it in place of the library.
    with open(case.folder("matplotlib.py"), "w", encoding="utf-8") as file:
        file.write("raise ValueError('no pictures today')\n")
    os.environ["PYTHONPATH"] = os.path.abspath(case.folder(""))
    _, out, err = case.run(output, codes=(3,))
    why = "failed: ValueError: no pictures today"
    require("WARNING: no report: " in out and why in out, f"it said {out}")
    require(why in read_bytes(output, "log.txt").decode(), "log.txt has no reason")
    require(err.startswith("error: all stages are finished, but there is no report"),
            f"stderr is {err}")
    del os.environ["PYTHONPATH"]
    case.run(output)
    require(os.path.exists(os.path.join(output, "report.html")),
            "the next start made no report")


def folder_stop_in_drawing(case):
    """A signal that ends the drawing of report or pictures is named as the cause,
    with its exit code. All else is there: --resume of a scene makes the report,
    and whatever draws pictures alone is finished."""
    is_scene = case.options.application.endswith("scene")
    for asked in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1):
        output = case.folder("run" if is_scene else f"run_{int(asked)}")
        # Python reads it in place of the library. All processes of the run get
        # the signal, as from a terminal or mpirun.
        with open(case.folder("matplotlib.py"), "w", encoding="utf-8") as file:
            file.write(f"import os\nos.killpg(0, {int(asked)})\n")
        os.environ["PYTHONPATH"] = os.path.abspath(case.folder(""))
        process = case.start(output, ["--resume"] if is_scene else (),
                             preexec_fn=os.setsid)
        out, err = process.communicate()
        del os.environ["PYTHONPATH"]
        require(process.returncode == 128 + asked and err == "",
                f"{asked!r} gave {process.returncode}: {out[-999:]}{err[-999:]}")
        why = f"asked to stop by {asked.name}"
        for told in (out, read_bytes(output, "log.txt").decode()):
            require(re.search(f"^WARNING: no .*failed: {why}$", told, re.M),
                    f"it does not say '{why}': {told}")
        status = manifest(output)["status"]
        require(status == ("stopped" if is_scene else "finished"),
                f"the folder is {status}")
    if is_scene:
        require("--resume makes it" in out, f"it does not say how to go on: {out}")
        case.run(output, ["--resume"])
        require(os.path.exists(os.path.join(output, "report.html")),
                "--resume made no report")


def folder_ranks(case):
    """A run continues from a checkpoint of another number of ranks; one of
    another precision is refused in one line and stays as it is. --argument is
    the entry of the other precision."""
    output, step = case.folder("run"), case.options.stop_after[0]
    case.run(output, ["--set", f"Time/Steps in this run={step}"])
    for ranks in (1, 2, 3):
        if ranks == case.options.mpi:
            continue
        case.run(output, ["--resume", "--set", "Time/Steps in this run=1"],
                 ranks=ranks)
        begin = read_summary(output)["resumed_from_step"]
        require(begin == step, f"on {ranks} ranks it went on from step {begin}, "
                f"not from {step}")
        step += 1
    refused(case, output, case.options.argument[0].split("=")[0],
            ["--resume", "--set", case.options.argument[0]])
    case.run(output, ["--resume"])
    require(read_summary(output)["status"] == "finished", "it did not finish")


# For each application, a file that is soon done and the entries for that.
BRIEF = {
    "anatomy": ("anatomy/extremes/needle.prm", ["Output/Pictures=false"]),
    "blast": ("blast/verification/sod.prm", ["Output/Fields=false"]),
    "biomechanics": ("biomechanics/verification/plane_wave.prm", []),
    "head_impact": ("head_impact/verification/sod.prm", []),
    "study": ("study/quickstart.prm",
              ["Study/Parameter file=@FILES@/blast/verification/sod.prm",
               "Vary scheme/Values=finite volume | |",
               "Vary scheme/Labels=finite volume", "Vary leaves/Values=10"]),
    "scene": ("scene/verification/head.prm",
              ["Scene/Question=loads", "Scene/Accuracy=first look",
               "Scene/Cell size=0.04",
               "Scene/Forecast=false", "Scene/Report=false",
               "Scene/End time=0.0005", "Anatomy/Output/Pictures=false"])}


def folder_default(case):
    """Without --output each application takes output/APPLICATION/NAME, below
    where it is started, for files of the same name a folder each, and finds its
    results there when it is started once more. FILE tells where the parameter
    files are."""
    here = os.path.abspath(case.folder("work"))
    files = os.path.abspath(os.path.join(os.path.dirname(case.options.file),
                                         "../.."))
    before = {}
    for application, (file, entries) in BRIEF.items():
        os.makedirs(here, exist_ok=True)
        shutil.copy(os.path.join(files, file), os.path.join(here, "same.prm"))
        extra = [word for entry in entries
                 for word in ("--set", entry.replace("@FILES@", files))]
        folder = os.path.join("output", application, "same")
        for words in ("results in " + folder, "finished before"):
            _, out, _ = case.run(None, extra, file="same.prm", cwd=here,
                                 program=os.path.join(os.path.dirname(
                                     case.options.application), application))
            require(words in out, f"{application} does not say '{words}': {out}")
        for name, content in before.items():
            require(snapshot(name) == content,
                    f"{application} changed the results of {name}")
        require(manifest(os.path.join(here, folder))["application"]
                == application, f"the results are not of {application}")
        before[os.path.join(here, folder)] = snapshot(
            os.path.join(here, folder))
    require(sorted(os.listdir(here)) == ["output", "same.prm"]
            and sorted(os.listdir(os.path.join(here, "output")))
            == sorted(BRIEF), "there is more than results")


def put_other_run(output):
    """A folder of a blast that has finished."""
    put(output, "history.csv", "log.txt")
    content = read_bytes(output, "history.csv")
    with open(os.path.join(output, "manifest.json"), "w",
              encoding="utf-8") as file:
        json.dump({"application": "blast", "status": "finished",
                   "names": {"results": ["history.csv", "probes.csv"],
                             "others": ["log.txt", "blast/"]},
                   "results": {"history.csv": {
                       "bytes": len(content), "crc32": zlib.crc32(content)}},
                   "input_files": {}, "entries": {}}, file)


def folder_stages(case):
    """Files of another application go with --overwrite only. A stage whose
    results were cut, changed or deleted is made again, and the log says why;
    other entries replace a stage only with --overwrite and only when the new
    one is complete; files of the user stay."""
    output = case.folder("run")
    put(output, *FOREIGN)
    put_other_run(output)
    refused(case, output, 'holds a run of "blast" (finished)')
    refused(case, output, "holds no stage of a scene", ["--resume"])
    _, out, _ = case.run(output, ["--overwrite"])
    require("removing what the earlier run (blast, finished) left" in out
            and not os.path.exists(os.path.join(output, "history.csv")),
            f"the results of a blast are left in a scene: {out}")
    has_foreign(output)
    before = snapshot(output)
    _, out, _ = case.run(output)
    require("finished before" in out and snapshot(output) == before,
            f"a finished scene was changed: {out}")
    loads = os.path.join(output, "blast", "loads.h5")
    whole = os.path.getsize(loads)
    for damage, words in (
            (lambda: os.truncate(loads, whole // 2), "bytes instead of"),
            (lambda: flip_byte(loads), "has changed"),
            (lambda: os.remove(loads), "is missing")):
        damage()
        _, out, _ = case.run(output)
        require("stage blast has to be made anew" in out and words in out,
                f"the log does not say '{words}': {out[-2000:]}")
        require(os.path.getsize(loads) == whole, "the loads are not whole")
        has_foreign(output)
    other = ["--set", "Charge/Mass=0.02"]
    refused(case, output, '"Charge/Mass" was', other)
    # Killed while the new blast is made: the old one is still complete.
    old = read_bytes(loads)
    process = case.start(output, other + ["--overwrite"])
    wait_until(process, lambda: os.path.exists(
        os.path.join(output, "blast.new", "history.csv")), "the new blast")
    process.kill()
    process.communicate()
    require(read_bytes(loads) == old, "the old blast is no longer complete")
    case.run(output, other + ["--overwrite"])
    require(read_bytes(loads) != old, "the blast was not made anew")
    has_foreign(output)
    for ending in (".new", ".old"):
        require(not glob.glob(os.path.join(output, "*" + ending + "*")),
                f"{ending} is left")


def flip_byte(path):
    with open(path, "r+b") as file:
        file.seek(os.path.getsize(path) // 2)
        byte = file.read(1)[0]
        file.seek(-1, os.SEEK_CUR)
        file.write(bytes([byte ^ 1]))


KINDS = {kind.__name__: kind for kind in
         (folder_finished, folder_foreign, folder_lock, folder_begins,
          folder_signals, folder_signals_in_forecast, folder_read_only,
          folder_cache, folder_default, folder_no_report,
          folder_stop_in_drawing, folder_ranks, folder_ranks_fail,
          folder_stages)}
