"""Tests of a machine that fails in the middle of a run, and of checkpoints
that another build has written; kinds of run_case.py."""

import contextlib
import glob
import json
import os
import shutil
import zlib

import full_disk
import resume_cases
from case import (checkpoints, compare_bytes, expand, read_json, read_summary,
                  require, snapshot)


def told_once(err, *words, ranks=1):
    """The one line on stderr, which has all the words. mpirun adds its own."""
    lines = [line for line in err.splitlines() if line.strip()]
    if ranks > 1:
        lines = [line for line in lines if line.startswith("error: ")]
    print(err)
    require(len(lines) == 1, f"{len(lines)} lines on stderr instead of one")
    for word in words:
        require(all(word in line for line in lines),
                f"the message lacks '{word}'")


def unfinished(folder):
    """Nothing in the folder of a run that failed is taken for a result that
    is complete."""
    partial = glob.glob(os.path.join(folder, "**", "*.partial"), recursive=True)
    require(not partial, f"half-written: {partial}")
    status = read_json(folder, "manifest.json")["status"]
    require(status in ("started", "failed", "stopped"),
            f"manifest.json says {status}")


@contextlib.contextmanager
def full(output, checkpoint):
    """A disk that has no room for a checkpoint; yields the folder to run in,
    what limits the process, and the reason that is to be given."""
    reason = "No space left on device" if full_disk.NAMESPACE in os.environ \
        else "File too large"
    with full_disk.nearly_full(output, checkpoint) as (folder, limits):
        yield folder, limits, reason


@contextlib.contextmanager
def rationed(output, checkpoint):
    """The same with a limit to the size of files, which is how a quota shows
    that needs no file system of its own. The application has to see to the
    signal of this limit itself."""
    largest = max(full_disk.sizes(checkpoint)) // 2
    yield (output, lambda: full_disk.limit_files(largest, ignore=False),
           "File too large")


def stopped(case, name, ranks=1):
    """A folder with a run that has stopped at a checkpoint; all that is proven
    in one test begins with copies of the same."""
    first = case.folder(f"stopped_on_{ranks}")
    if not os.path.exists(first):
        resume_cases.stop(case, first, case.options.stop_after[0], ranks)
    return shutil.copytree(first, case.folder(name))


def goes_on_later(case, name, hindrance, ranks=1):
    """A run is stopped, resumed where it cannot write its next checkpoint, and
    resumed once more where it can."""
    straight, output = case.straight(ranks), stopped(case, name, ranks)
    last = max(checkpoints(output))
    before = snapshot(last)
    with hindrance(output, last) as (folder, limits, reason):
        _, _, err = case.run(folder, extra=["--resume"], ranks=ranks,
                             codes=(3,), preexec_fn=limits)
        told_once(err, reason, ranks=ranks)
        unfinished(folder)
    require(snapshot(last) == before, f"{last} is no longer intact")
    state = resume_cases.checkpoint_state(output)
    case.run(output, extra=["--resume"], ranks=ranks)
    resume_cases.judge(case, straight, output, state, ranks)


def disk(case):
    """A disk that fills in the middle of a run: exit code 3, one line, and the
    run continues from its last checkpoint once there is room."""
    goes_on_later(case, "full", full)


def parallel_disk(case):
    """The same on the last of --ranks."""
    ranks = case.options.ranks[-1]
    goes_on_later(case, f"full_on_{ranks}", full, ranks)


def quota(case):
    """The same with a limit to the size of files: no signal ends the run."""
    goes_on_later(case, "rationed", rationed)


def disk_anew(case):
    """On 1 and on each of --ranks, files that may not grow as large as an
    application without steps makes them, then a disk with half the room that it
    needs: exit code 3, one line, nothing that counts as finished; with room the
    same command makes the --compare files."""
    straight = case.straight()
    sizes = full_disk.sizes(straight)
    on_a_disk = full_disk.NAMESPACE in os.environ
    for ranks in (1, *case.options.ranks):
        output = case.folder(f"full_on_{ranks}")
        with full_disk.small_disk(output, sum(sizes) // 2) as (folder, limits,
                                                               grow):
            for limited, reason in (
                    (lambda: full_disk.limit_files(max(sizes) // 2,
                                                   ignore=False),
                     "File too large"),
                    (limits, "No space left on device" if on_a_disk
                     else "File too large")):
                _, _, err = case.run(folder, ranks=ranks, codes=(3,),
                                     preexec_fn=limited)
                told_once(err, reason, ranks=ranks)
                unfinished(folder)
            grow()
            case.run(folder, ranks=ranks, preexec_fn=limits)
            require(read_summary(folder)["status"] == "finished",
                    "it did not finish")
            compare_bytes(straight, os.path.abspath(folder),
                          expand(straight, case.options.compare))


def change_run(output, change):
    """Changes what the checkpoints of a run say of it."""
    for folder in checkpoints(output):
        run = read_json(folder, "run.json")
        change(run)
        text = json.dumps(run).encode()
        with open(os.path.join(folder, "run.json"), "wb") as file:
            file.write(text)
        marker = read_json(folder, "complete.json")
        marker["files"]["run.json"] = {"bytes": len(text),
                                       "crc32": zlib.crc32(text)}
        with open(os.path.join(folder, "complete.json"), "w",
                  encoding="utf-8") as file:
            json.dump(marker, file)


def other_build(case):
    """A checkpoint of another build: the run continues and says so, or, where
    format or entries are others, is refused in a line that names both."""
    straight, output = case.straight(), stopped(case, "other_build")
    state = resume_cases.checkpoint_state(output)
    run = read_json(max(checkpoints(output)), "run.json")
    builds = ["0.0.7 (0123456789ab)",
              f"{run['version']} ({run['git_revision']})"]
    entry = next(iter(run["parameters"]))

    def rebuild(run):
        run.update({"version": "0.0.7", "git_revision": "0123456789ab"})

    def reformat(run):
        rebuild(run)
        run["format"] += 1

    def forget(run):
        rebuild(run)
        del run["parameters"][entry]

    for change, words in ((reformat, "format"), (forget, entry)):
        copy = stopped(case, "refused")
        change_run(copy, change)
        before = snapshot(copy)
        _, _, err = case.run(copy, extra=["--resume"], codes=(1,))
        told_once(err, words, *builds)
        require(snapshot(copy) == before, "the refused run changed its folder")
        shutil.rmtree(copy)
    change_run(output, rebuild)
    _, out, _ = case.run(output, extra=["--resume"])
    require(all(build in out for build in builds),
            "the log does not name both builds")
    resume_cases.judge(case, straight, output, state, 1)


KINDS = {kind.__name__: kind for kind in
         (disk, parallel_disk, quota, disk_anew, other_build)}
# Those that need a disk of their own.
ON_A_DISK = ("disk", "parallel_disk", "disk_anew", "study_storage",
             "study_quota", "folder_read_only")
