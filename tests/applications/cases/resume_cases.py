"""Tests of stopped, killed and resumed runs; kinds of run_case.py.

Each continues from a checkpoint, must not compute again what was before it,
and must leave what the straight run has left.
"""

import glob
import math
import os
import signal
import time

from case import (check_bound, checkpoints, compare_bytes, compare_numbers,
                  expand, read_json, read_summary, require)

LIMIT = "Time/Largest number of steps"
# Sections of a summary on the whole run, whatever its starts.
SKIPPED = ("skipped_updates", "quiet_elements")
WHOLE = ("conservation", "errors", "results", "checks", "assumptions",
         "warnings")


def checkpoint_state(output):
    """The newest complete checkpoint, and step and updates before it."""
    complete = [path for path in checkpoints(output)
                if os.path.exists(os.path.join(path, "complete.json"))]
    require(complete, f"{output} holds no complete checkpoint")
    state = read_json(max(complete), "run.json")["state"]
    print(f"{max(complete)}: step {state['step']}")
    return state


def limit_of(case):
    """The number of steps after which a straight run ends, None without."""
    values = [override.split("=", 1)[1] for override in case.options.set
              if override.startswith(LIMIT + "=")]
    return int(values[-1]) if values else None


def go_on(case, output, state, ranks):
    """Resumes and judges. Where a fast machine got past the end of the straight
    run before it was stopped, a longer straight run is made."""
    require(state["step"] > 0, "nothing was computed before the checkpoint")
    limit = limit_of(case)
    extra = []
    if limit is not None and state["step"] >= limit:
        extra = ["--set", f"{LIMIT}={state['step'] + 3}"]
    straight = case.straight(ranks, extra)
    case.run(output, extra=["--resume", *extra], ranks=ranks)
    judge(case, straight, output, state, ranks)


def judge(case, straight, output, state, ranks):
    """The resumed run went on from the checkpoint and ends as the straight
    one, to the last bit on one rank."""
    one, two = read_summary(straight), read_summary(output)
    check_bound(two, "status == finished")
    check_bound(two, f"resumed_from_step == {state['step']}")
    whole = one["performance"]["updates"]
    rest = whole - state["updates"]
    made = two["performance"]["updates"] - state["updates"]
    print(f"{made:.0f} updates after the checkpoint, {whole:.0f} straight "
          "through")
    # A resumed run finds again which leaves are at rest; it may skip more.
    require(0.5 * rest < made <= (1. + 1e-9) * rest < whole,
            f"{made:.0f} updates were made after the checkpoint instead of at "
            f"most {rest:.0f}")
    require_skipping(one, two, state["updates"], rest - made)
    if ranks > 1:
        compare_numbers(case.options.tolerance, straight, output,
                        case.options.compare)
        return
    fields = [os.path.relpath(path, straight) for path in
              glob.glob(os.path.join(straight, "fields", "**", "*.vt[uip]"),
                        recursive=True)]
    compare_bytes(straight, output,
                  expand(straight, case.options.compare) + fields)
    ends = [without_skipping(summary) for summary in (one, two)]
    for key, value in ends[0].items():
        require(are_equal(value, ends[1][key]),
                f"{key} differ: {value} and {ends[1][key]}")


def are_equal(one, two):
    """Whether two parts of summaries are equal; a sum over both parts of a run
    has round-off of its own."""
    if isinstance(one, dict) and isinstance(two, dict):
        return one.keys() == two.keys() and all(
            are_equal(one[key], two[key]) for key in one)
    if isinstance(one, float) and isinstance(two, float):
        return math.isclose(one, two, rel_tol=1e-14)
    return one == two


def without_skipping(summary):
    """Sections on the whole run, but for the fraction of skipped updates."""
    skipped = {"checks": SKIPPED, "assumptions": "quiet_leaves"}
    return {key: {name: value for name, value in summary[key].items()
                  if name not in skipped.get(key, ())}
            if isinstance(summary[key], dict) else summary[key]
            for key in WHOLE if key in summary}


def require_skipping(straight, resumed, before, n_missed):
    """Skipped updates are counted over all starts. Gas: they differ by those that
    the last start skipped or computed otherwise, of all that there were; a first
    stage counts among these, but skips none. Solid: the last start skips none,
    while the first one skipped at least as large a share as all of the way."""
    all_updates = straight["performance"]["updates"]
    for name in SKIPPED:
        if name not in straight["checks"]:
            continue
        one, two = (summary["checks"][name]["value"]
                    for summary in (straight, resumed))
        lower, upper = one * before / all_updates, one
        if name == "skipped_updates":
            share = 10. * abs(n_missed) / all_updates
            lower, upper = one - share, one + share
        require(lower - 1e-9 <= two <= upper + 1e-9,
                f"{name} is {two} instead of {lower} to {upper}")


def stop(case, output, steps, ranks=None):
    """Runs a few steps, up to a checkpoint."""
    case.run(output, ranks=ranks,
             extra=["--set", f"Time/Steps in this run={steps}"])
    state = checkpoint_state(output)
    check_bound(read_summary(output), "status == stopped")
    require(state["step"] == steps, f"the run stopped after {state['step']} steps")
    return state


def start_endless(case, output, ranks):
    """Starts a run that writes checkpoints and has no limit of steps; returns
    it once the first checkpoint is complete."""
    extra = ["--set",
             f"Output/Checkpoint every steps={case.options.stop_after[0]}"]
    if limit_of(case) is not None:
        extra += ["--set", LIMIT + "=1000000000"]
    process = case.start(output, ranks=ranks, extra=extra)
    while process.poll() is None and not glob.glob(
            os.path.join(output, "checkpoint", "*", "complete*")):
        time.sleep(0.005)
    return process


def end(process, code):
    out, err = process.communicate()
    if process.returncode != code:
        print(out[-4000:] + err[-4000:])
    require(process.returncode == code,
            f"exit code {process.returncode} instead of {code}")


def descendants(pid):
    """Numbers of a process and of all that it has started."""
    children = {}
    for path in glob.glob("/proc/[0-9]*/stat"):
        try:
            with open(path, encoding="utf-8", errors="replace") as file:
                text = file.read()
        except OSError:
            continue
        parent = int(text.rpartition(")")[2].split()[1])
        children.setdefault(parent, []).append(int(text.split()[0]))
    found = [pid]
    for parent in found:
        found += children.get(parent, [])
    return found


def resume_on(case, ranks):
    for steps in case.options.stop_after:
        output = case.folder(f"stopped_at_{steps}_on_{ranks}")
        go_on(case, output, stop(case, output, steps, ranks), ranks)


def terminate_on(case, ranks):
    output = case.folder(f"terminated_on_{ranks}")
    process = start_endless(case, output, ranks)
    # mpirun leaves its ranks no time after SIGTERM.
    asked = signal.SIGUSR1 if ranks > 1 else signal.SIGTERM
    process.send_signal(asked)
    end(process, 128 + asked)
    state = checkpoint_state(output)
    summary = read_summary(output)
    check_bound(summary, "status == stopped")
    check_bound(summary, f"steps == {state['step']}")
    go_on(case, output, state, ranks)


def kill_on(case, ranks):
    output = case.folder(f"killed_on_{ranks}")
    process = start_endless(case, output, ranks)
    for pid in descendants(process.pid):
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    end(process, -signal.SIGKILL)
    require(not os.path.exists(os.path.join(output, "summary.json")),
            "the run had ended before it was killed")
    go_on(case, output, checkpoint_state(output), ranks)


def resume(case):
    """A run stopped after some steps and resumed equals one that went straight
    through, to the last bit in serial, and repeats no step."""
    resume_on(case, 1)


def sigterm(case):
    """The same with a run that a signal stops."""
    terminate_on(case, 1)


def sigkill(case):
    """The same with a run that is killed after a checkpoint."""
    kill_on(case, 1)


def parallel_resume(case):
    """A run on several ranks that is stopped and resumed."""
    resume_on(case, case.options.ranks[-1])


def parallel_sigterm(case):
    """The same with a run that a signal stops."""
    terminate_on(case, case.options.ranks[-1])


def parallel_sigkill(case):
    """The same with a run that is killed after a checkpoint."""
    kill_on(case, case.options.ranks[-1])


KINDS = {kind.__name__: kind for kind in
         (resume, sigterm, sigkill, parallel_resume, parallel_sigterm,
          parallel_sigkill)}
