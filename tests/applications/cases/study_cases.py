"""Tests of the application `study`; kinds of run_case.py."""

import glob
import os
import resource
import signal
import subprocess
import time

import full_disk
from case import (check_bound, read_json, read_rows, read_summary, read_text,
                  require)
from folder_cases import read_only
from machine_cases import told_once


def read_table(output):
    return read_rows(output, "study.csv")


def outcome_files(output):
    """When each finished run left its outcome."""
    return {path: os.stat(path).st_mtime_ns for path in
            glob.glob(os.path.join(output, "variants", "*", "outcome.json"))}


def processes_in(folder):
    """Command lines of processes below this working folder that name a folder,
    besides this one's."""
    found = []
    here = os.getcwd()
    for path in glob.glob("/proc/[0-9]*/cmdline"):
        try:
            with open(path, "rb") as file:
                words = file.read().split(b"\0")
            place = os.readlink(os.path.join(os.path.dirname(path), "cwd"))
        except OSError:
            continue
        if any(os.path.join(folder, "variants").encode() in word
               for word in words) and place.startswith(here) and \
                str(os.getpid()) not in path:
            found.append(b" ".join(words).decode())
    return found


def write_study(case, name, lines):
    """A parameter file of its own, whose values may have semicolons."""
    path = case.folder(name)
    with open(path, "w") as file:
        file.write("\n".join(lines) + "\n")
    return path


def study_run(case):
    """The study ends, keeps the bounds, draws its pictures, and recommends a
    file that gives the error it promises."""
    output = case.folder("run")
    case.run(output)
    for bound in case.options.bound:
        check_bound(read_summary(output), bound)
    table = read_table(output)
    best = [row for row in table if row["pareto front"] == "yes"]
    require(best, "nothing is on the Pareto front")
    for name in case.options.compare:
        path = os.path.join(output, "pictures", name)
        require(os.path.getsize(path) > 10000, f"{path} is empty")
    wanted = min((row for row in table if float(row["error"]) <= 0.004),
                 key=lambda row: float(row["core [s]"]))
    require("Fields = true" in read_text(output, "recommended.prm"),
            "recommended.prm writes no fields")
    single = case.folder("recommended")
    blast = os.path.join(os.path.dirname(case.options.application), "blast")
    case.run(single, program=blast,
             file=os.path.join(output, "recommended.prm"))
    error = read_summary(single)["errors"]["density_L1"]
    require(error == float(wanted["error"]),
            f"recommended.prm has error {error} instead of {wanted['error']}")


def study_failures(case):
    """Runs that are refused, unstable or too long are results."""
    base = os.path.join(os.path.dirname(case.options.file),
                        "../blast/verification/sod.prm")
    file = write_study(case, "failures.prm", [
        "subsection Study", f"set Parameter file = {base}",
        "set Settings = Output/Fields=false",
        "set Time limit = 5", "set Cores = 2", "end",
        "subsection Vary end",
        "set Entry = Method/CFL number | Initial state/Kind | "
        "Domain/Coarse leaves | Method/Largest number of retries",
        "set Values = 0.4 | | 10 | ; 0.4 | uniform | 10 | ; "
        "0.4 | | 100000 | ; 10 | | 10 | 0",
        "set Labels = good; refused; long; unstable",
        "end"])
    output = case.folder("run")
    _, _, err = case.run(output, file=file, codes=(2,))
    require("3 of 4 variants did not finish; the first (refused)" in err,
            f"not how many failed: {err}")
    found = {row["end"]: (row["outcome"], row["reason"])
             for row in read_table(output)}
    print(found)
    require(found["good"] == ("stable", ""), "the good one is not stable")
    require(found["refused"][0] == "refused" and "Reference" in
            found["refused"][1], "no reason for the refusal")
    require(found["long"][0] == "timed out", "the long one was not ended")
    require(found["unstable"][0] == "unstable" and found["unstable"][1],
            "no reason for the instability")
    check_bound(read_summary(output), "status == finished")
    require(not processes_in(output), "processes were left")
    require("- refused: refused, " in read_text(output, "study.md"),
            "study.md lacks it")
    summary = read_summary(output)
    require((summary["finished_variants"], summary["failed_variants"]) ==
            (1, 3), "the summary counts otherwise")
    for entry, name in (("Error/Name=densty_L1", "density_L1"),
                        ("Study/Columns=errors.densty_L1",
                         "errors.density_L1")):
        _, _, err = case.run(output, file=file, codes=(1,),
                             extra=["--resume", "--set", entry])
        require(f'did you mean "{name}"' in err, f"misspelt: {err}")
    require('"errors.density_L1",' in read_text(output, "outputs.csv"),
            "outputs.csv lacks an output")


def interrupted(case, end, extra=(), least=2):
    """Starts a study, ends it after its first results; returns exit code and
    results."""
    output = case.folder("run")
    process = case.start(output, extra)
    while process.poll() is None and len(outcome_files(output)) < least:
        time.sleep(0.01)
    process.send_signal(end)
    out, err = process.communicate()
    print(out[-2000:] + err[-2000:])
    deadline = time.time() + 20.
    while processes_in(output) and time.time() < deadline:
        time.sleep(0.05)
    require(not processes_in(output), f"left: {processes_in(output)}")
    before = outcome_files(output)
    require(least <= len(before) < 8, f"{len(before)} runs had ended")
    return process.returncode, before


def resumed(case, before, output=None):
    output = output or case.folder("run")
    case.run(output, extra=["--resume"])
    after = outcome_files(output)
    for path, when in before.items():
        require(after[path] == when, f"{path} was repeated")
    check_bound(read_summary(output), "status == finished")
    require(len(after) == 8 and len(read_table(output)) == 8,
            f"{len(after)} runs instead of 8")
    # Once more: nothing is left to run.
    case.run(output, extra=["--resume"])
    require(outcome_files(output) == after, "finished runs were repeated")


def study_sigterm(case):
    """SIGINT ends study and runs with code 130, SIGTERM with 143; --resume does
    the rest."""
    output = case.folder("run")
    code, first = interrupted(case, signal.SIGINT)
    require(code == 130, f"exit code {code}")
    check_bound(read_summary(output), "status == stopped")
    code, before = interrupted(case, signal.SIGTERM, ["--resume"],
                               len(first) + 1)
    require(code == 143, f"exit code {code}")
    require(first.items() <= before.items(), "a finished run was repeated")
    check_bound(read_summary(output), "status == stopped")
    resumed(case, before)


def study_sigkill(case):
    """SIGKILL leaves no process behind; --resume does the rest."""
    code, before = interrupted(case, signal.SIGKILL)
    require(code == -signal.SIGKILL, f"exit code {code}")
    resumed(case, before)


def fails(case, folder, process, reason):
    """The study ends with 3 and one line that gives the reason; returns the
    results until then."""
    out, err = process.communicate()
    print(out[-2000:] + err[-2000:])
    require(process.returncode == 3, f"exit code {process.returncode}")
    require(len(err.strip().splitlines()) == 1 and reason in err,
            f"not one line with '{reason}': {err}")
    require(not processes_in(folder), f"left: {processes_in(folder)}")
    require(read_json(folder, "manifest.json")["status"] != "finished",
            "it counts as finished")
    return outcome_files(folder)


def study_storage(case):
    """A folder that turns read-only in the middle of a study, then a full disk:
    exit code 3 and one line each; runs that had ended are not repeated."""
    if full_disk.NAMESPACE not in os.environ:
        limited(case)
        return
    with full_disk.small_disk(case.folder("run"), 64 << 20) as (folder, _,
                                                                grow):
        disk = os.path.dirname(folder)
        process = case.start(folder)
        while process.poll() is None and not outcome_files(folder):
            time.sleep(0.01)
        with read_only(folder):
            before = fails(case, folder, process, "Read-only file system")
        require(0 < len(before) < 8, f"{len(before)} runs had ended")
        used = sum(full_disk.sizes(folder)) + 4096 * len(
            full_disk.sizes(folder))
        subprocess.run(["mount", "-o", f"remount,size={used + (96 << 10)}",
                        disk], check=True)
        process = case.start(folder, ["--resume"])
        after = fails(case, folder, process, "No space left on device")
        require(before.items() <= after.items(), "a finished run was repeated")
        grow()
        resumed(case, after, folder)


def limited(case):
    """As study_storage() where nothing can be mounted: in the middle of a study
    files may grow no more."""
    folder = case.folder("run")
    process = case.start(folder, preexec_fn=lambda: full_disk.limit_files(
        resource.RLIM_INFINITY))
    while process.poll() is None and not outcome_files(folder):
        time.sleep(0.01)
    full_disk.limit_running(process, 1)
    before = fails(case, folder, process, "File too large")
    require(0 < len(before) < 8, f"{len(before)} runs had ended")
    resumed(case, before, folder)


def study_quota(case):
    """Where not even the entries of a run can be asked for, the study ends with 3.
    Runs on 1 and on each of --ranks whose files may not grow as large as
    they must, while the small ones that the study itself writes may, then runs
    on the last of --ranks whose disk is full: this is no property of a variant,
    so the study ends with 3 and says why; runs that had ended are not
    repeated."""
    _, _, err = case.run(case.folder("entries"), codes=(3,), preexec_fn=lambda:
                         full_disk.limit_files(4 << 10, ignore=False))
    told_once(err, "standard output")
    for ranks in (1, *case.options.ranks):
        folder = case.folder(f"run_on_{ranks}")
        # Runs of 100 leaves have many steps to tell of.
        one_of_two(case, folder, ranks, "File too large", lambda:
                   full_disk.limit_files(100 << 10, ignore=False))
    if full_disk.NAMESPACE not in os.environ:
        return
    files = full_disk.sizes(os.path.join(folder, "variants"))
    with full_disk.small_disk(case.folder("disk"), sum(files) - (50 << 10)
                              + 4096 * len(files)) as (folder, limits, grow):
        one_of_two(case, folder, ranks, "No space left on device",
                   limits, grow)


def one_of_two(case, folder, ranks, reason, limits,
               grow=lambda: None):
    """The second of two runs cannot write its files, for that reason, until it
    may grow()."""
    extra = ["--set", "Vary scheme/Values=finite volume | |", "--set",
             "Vary scheme/Labels=finite volume", "--set",
             "Vary leaves/Values=10; 100", "--set",
             "Study/Settings=Output/Fields=false; Output/History every steps=1",
             "--set", f"Study/Ranks={ranks}", "--set", f"Study/Cores={ranks}"]
    before = fails(case, folder, case.start(folder, extra, preexec_fn=limits),
                   reason)
    require(len(before) == 1, f"{len(before)} runs had ended")
    grow()
    case.run(folder, extra + ["--resume"])
    after = outcome_files(folder)
    require(before.items() <= after.items(), "a finished run was repeated")
    outcomes = read_summary(folder)["outcomes"]
    require(outcomes == {"stable": 2}, f"outcomes are {outcomes}")


def study_head(case):
    """Heads against a wall, with and without a remap, on two meshes: curves of
    history.csv are compared, and updates do not depend on the machine."""
    base = os.path.join(case.options.other_file,
                        "../../head_impact/quickstart.prm")
    file = write_study(case, "head.prm", [
        "subsection Study", "set Application = head_impact",
        f"set Parameter file = {base}", "set Cost = updates",
        "set Settings = Output/Fields=false; Output/Pictures=false; "
        "Output/History every steps=5; Time/End time=1e-4",
        "set Columns = checks.rezones; timers.advance; "
        "assumptions.cavitation_CSF.measured", "end",
        "subsection Error", "set Kind = reference run",
        "set Reference = Rezone/Interval=1e-6; Mesh/Cell size=0.02",
        "set Quantity = history curve", "set Name = contact_force", "end",
        "subsection Vary rezone",
        "set Entry = Rezone/Kind | Rezone/Interval",
        "set Values = elastic | 2e-5; none |", "end",
        "subsection Vary size", "set Entry = Mesh/Cell size",
        "set Values = 0.03; 0.02", "set Refinement = by size", "end"])
    output = case.folder("head")
    case.run(output, file=file)
    table = read_table(output)
    require(len(table) == 4, f"{len(table)} heads")
    for row in table:
        print(row)
        require(float(row["updates"]) ==
                float(row["cells"]) * float(row["steps"]), "updates differ")
        is_rezoned = row["rezone"].startswith("elastic")
        require(float(row["checks.rezones"]) == 5. * is_rezoned,
                "there are other rezones")
    for coarse, fine in (table[:2], table[2:]):
        require(float(coarse["error"]) > float(fine["error"]) > 0. and
                float(fine["order"]) > 0., "larger cells are no worse")
    require("No run has" not in read_text(output, "study.md"),
            "a column is empty")


def study_any_file(case):
    """Files of other applications, and of one, two and three dimensions, as they
    are."""
    study_head(case)
    for name in ("toro_3", "double_mach", "sedov_3d"):
        base = os.path.join(case.options.other_file, name + ".prm")
        file = write_study(case, name + ".prm", [
            "subsection Study", f"set Parameter file = {base}",
            "set Settings = Time/Largest number of steps=2; "
            "Output/Fields=false",
            "set Design = one at a time", "end",
            "subsection Error", "set Kind = reference run",
            "set Reference = Method/CFL number=0.1; "
            "Time/Largest number of steps=8",
            "set Name = conservation.energy_last", "end",
            "subsection Vary CFL", "set Entry = Method/CFL number",
            "set Values = 0.2; 0.4", "end",
            "subsection Vary limiter", "set Entry = Method/Limiter",
            "set Values = minmod; mc", "end"])
        output = case.folder(name)
        case.run(output, file=file)
        table = read_table(output)
        require(len(table) == 3, f"{name}: {len(table)} rows")
        for row in table:
            require(row["outcome"] in ("stable", "retried", "finished")
                    and float(row["error"]) >= 0., f"{name}: {row}")


def column_of(table, address):
    """Numbers of the column with this address in all rows."""
    name = next(name for name in table[0] if name.startswith(address))
    return [float(row[name]) for row in table]


def study_distance(case):
    """A series of scenes over distance gives its curves: the columns of the table
    are what the scenes left, they fall with the distance, and are drawn."""
    output = case.folder("run")
    case.run(output)
    table = read_table(output)
    for address in ("blast/results.probe_1_peak_overpressure",
                    "blast/results.loads_chest_peak",
                    "biomechanics/results.injury_intracranial_pressure_peak"):
        stage, name = address.split("/results.")
        told = column_of(table, address)
        left = [read_summary(os.path.join(row["folder"], stage))["results"][name]
                ["value"] for row in table]
        print(f"{address}: {told}")
        require(told == left and len(told) == 3, f"{address}: {told}, {left}")
        require(told == sorted(told, reverse=True), f"{address}: {told}")
    deaths = column_of(table, "blast/probe_injury.csv:lung_lethality")
    require(deaths == sorted(deaths, reverse=True) and deaths[0] > 0.9,
            f"deaths: {deaths}")
    require(os.path.getsize(os.path.join(output, "pictures", "curves.png"))
            > 10000, "curves.png is empty")


KINDS = {kind.__name__: kind for kind in
         (study_run, study_failures, study_sigterm, study_sigkill,
          study_storage, study_quota, study_any_file, study_distance)}
