"""Tests of the application `scene`; kinds of run_case.py."""

import glob
import html
import json
import os
import re
import signal
import subprocess
import time

import numpy

import full_disk
import resume_cases
import samples
from case import check_bound, read_bytes, read_json, read_rows, read_summary, \
    read_text, require
from summaries import flaw_of

STAGES = ("anatomy", "blast", "biomechanics")
ALL_STAGES = STAGES + ("coarser_blast", "coarser_biomechanics")


def statuses(output):
    """Names of stages and how they stand, from scene.json."""
    stages = read_json(output, "scene.json")["stages"]
    return {stage["name"]: stage["status"] for stage in stages}


def injury_table(output):
    return {row["measure"]: float(row["value"])
            for row in read_rows(output, "biomechanics", "injury.csv")}


def require_body_mass(output):
    """Lungs are judged by the mass of the mesh, and those of an adult where the
    body has none, on the skin and in the body alike."""
    expected = read_json(output, "anatomy", "summary.json")["mass"]
    if not any((row["kind"], row["name"]) == ("tissue", "lung")
               for row in read_rows(output, "anatomy", "quality.csv")):
        expected = 78.5
    for stage in ("blast", "biomechanics"):
        text = read_text(output, stage, "parameters.prm")
        told = float(re.search(r"set Body mass *= (\S+)", text)[1])
        require(abs(told / expected - 1.) < 0.05,
                f"{stage} has a body of {told} kg, not {expected}")


def require_charge(output):
    """scene.json tells of the charge what the blast was given."""
    facts = read_json(output, "scene.json")
    words = re.search(r"subsection Charge 1\n.*?set Center *= ([^\n]*)\n"
                      r".*?set Mass *= (\S+)",
                      read_text(output, "blast", "parameters.prm"),
                      re.S)
    place = [float(word) for word in words[1].split(",")]
    expected = [*place, place[2], float(words[2])]
    told = [*facts["charge_place"], facts["height"], facts["charge_mass"]]
    require(all(abs(one - two) < 1e-9 for one, two in zip(told, expected)),
            f"place, height and mass of the charge are {told} in scene.json, "
            f"{expected} in the blast")


def require_own_names(output):
    """Assumptions are decided by entries as the scene calls them, by those of
    a stage only where the scene has none."""
    wanted = {"symmetry": "Scene/Symmetry", "rigid_body": "",
              "viscosity": "Scene/End time", "gravity": "Scene/End time",
              "reflection": "Scene/End time",
              "first_stage": "Blast/First stage/Hand over at",
              "quiet_leaves": "Blast/Method/Skip quiet leaves",
              "strain": "Biomechanics/Elements/Kinematics"}
    facts = read_json(output, "scene.json")
    for rows in (facts["plan"], facts["audit"]):
        found = {row["item"]: row["entry"] for row in rows}
        require({item: found.get(item) for item in wanted} == wanted,
                f"entries of what was taken for granted: {found}")


def require_own_tissues(case, output):
    """Each entry of a tissue among the overrides is listed as a change of the
    libraries, and the masses of the mesh have the densities."""
    changes = {row["entry"]: row["value"].split()[0] for row in
               read_json(output, "scene.json").get("changes", [])}
    wanted = {entry: float(value) for entry, _, value in (
        text.partition("=") for text in case.options.set)
        if entry.startswith("Tissues/Tissue ")}
    for entry, value in wanted.items():
        require(entry in changes and float(changes[entry]) == value,
                f"{entry} is not among the changes: {changes}")
        if entry.endswith("/Density"):
            density = mesh_density(output,
                                   entry.split("/")[1].partition(" ")[2])
            require(abs(density - value) < 1e-9 * value,
                    f"{entry} is {density} in the mesh")
    if wanted and "Anatomy/Output/Pictures=false" not in case.options.set:
        require(os.path.exists(os.path.join(output, "anatomy", "pictures",
                                            "cuts.png")),
                "the cuts of the body are not drawn")


def require_own_thresholds(case, output):
    """Thresholds among the overrides decide the verdict, as the user's own."""
    wanted = {entry: text.replace("@SEMICOLON@", ";") for entry, _, text in (
        text.partition("=") for text in case.options.set)
        if entry.startswith("Injury/Measure ")}
    for entry, text in wanted.items():
        name = entry.split("/")[1].partition(" ")[2]
        told = next(one for one in read_json(output, "report.json")["measures"]
                    if one["name"] == name)
        rows = [word.partition(":") for word in text.split(";")]
        meanings = [""] + [meaning.strip() for value, _, meaning in rows
                           if told["value"] > float(value)]
        require(told["is_own"] and told["verdict"] == meanings[-1],
                f"{entry} gives the verdict {told}")
        require(entry in [row["entry"] for row in
                          read_json(output, "scene.json")["changes"]],
                f"{entry} is not among the changes")
        require("(the user's own)" in
                read_text(output, "biomechanics", "injury.csv"),
                "injury.csv has no thresholds of the user")


def mesh_density(output, tissue):
    """Density of a tissue in the mesh that anatomy made [kg/m^3]."""
    row = next(row for row in read_rows(output, "anatomy", "quality.csv")
               if (row["kind"], row["name"]) == ("tissue", tissue))
    return float(row["mass [kg]"]) / float(row["volume [m^3]"])


def require_repeatable(output):
    """The line of scene.json calls the scene from any folder, with all that was
    asked for: a finished one is left as it is."""
    line = read_json(output, "scene.json")["command"]
    found = subprocess.run(["bash", "-c", line], cwd="/", capture_output=True,
                           text=True, check=False)
    require(found.returncode == 0 and "finished before" in found.stdout,
            f"{line} gave {found.returncode}: {found.stdout}{found.stderr}")


def require_coarser_run(output, expected):
    """scene.json has the ratios of what the coarser run has made, and errors by
    it alone."""
    scene = read_json(output, "scene.json")
    require(scene["coarser_run"] == expected,
            f"coarser_run is {scene['coarser_run']}")
    errors = [row["run_error"] for row in scene["table_comparison"]]
    require(expected or not any(errors), f"errors of the run are {errors}")


def scene_run(case):
    """Every stage runs and keeps the bounds of the biomechanics summary; with
    other entries, stages whose inputs are the same are taken as they are."""
    output = case.folder("run")
    case.run(output)
    for bound in case.options.bound:
        check_bound(read_summary(os.path.join(output, "biomechanics")), bound)
    require(statuses(output) == dict.fromkeys(ALL_STAGES, "finished"),
            f"stages are {statuses(output)}")
    require("<html" in read_bytes(output, "report.html").decode(),
            "there is no report")
    require_body_mass(output)
    require_charge(output)
    require_own_tissues(case, output)
    require_own_thresholds(case, output)
    require_own_names(output)
    require_repeatable(output)
    require_coarser_run(output, {"cell_ratio": 2., "element_ratio": 5. / 3.})
    loads = os.stat(os.path.join(output, "blast", "loads.h5")).st_mtime_ns
    case.run(output, ["--resume", "--set", "Scene/Report=false"])
    require(statuses(output) == dict.fromkeys(ALL_STAGES, "reused"),
            f"stages of a second run are {statuses(output)}")
    case.run(output, ["--resume", "--set", "Scene/Report=false"],
             file=os.path.join(output, "parameters.prm"))
    require(statuses(output) == dict.fromkeys(ALL_STAGES, "reused"),
            f"stages of a run of its parameters.prm are {statuses(output)}")
    before = injury_table(output)
    case.run(output, ["--overwrite", "--set", "Tissues/Set=physiological",
                      "--set", "Scene/Report=false"])
    require(statuses(output)["blast"] == "reused"
            and statuses(output)["coarser_blast"] == "reused",
            "other tissues made the blast run again")
    require(statuses(output)["biomechanics"] == "finished",
            "other tissues did not make biomechanics run again")
    require(injury_table(output) != before, "other tissues changed nothing")
    # Another title leaves nothing to make.
    _, out, _ = case.run(output, ["--overwrite", "--set", "Scene/Title=again",
                                  "--set", "Tissues/Set=physiological",
                                  "--set", "Scene/Report=false"])
    require(re.search("^--overwrite takes anatomy, blast, .* as they are$", out,
                      re.M), f"nothing is made anew, which is not said: {out}")
    require(os.stat(os.path.join(output, "blast", "loads.h5")).st_mtime_ns
            == loads, "the loads of a blast that was reused are new")
    # The coarser run of the earlier scene is there still.
    case.run(output, ["--overwrite", "--set", "Scene/Error estimate=false",
                      "--set", "Tissues/Set=physiological",
                      "--set", "Scene/Report=false"])
    require_coarser_run(output, None)


def scene_own_mesh(case):
    """Hexahedra of one's own go through the chain as they are: all stages have as
    many, forecast, plan and report say so, errors of what happens in them are
    unknown, and another size of elements is refused."""
    output = case.folder("run")
    _, plan, _ = case.run(output, ["--check"])
    _, out, _ = case.run(output, verbose=False)
    anatomy = read_json(output, "anatomy", "summary.json")
    count = anatomy["cells"]
    forecast = re.search(r"^ +biomechanics +(\d+) ", plan, re.M)
    require(forecast and int(forecast[1]) == count == read_json(
        output, "biomechanics", "summary.json")["cells"],
            f"{count} hexahedra, {forecast} in the forecast")
    for text in (plan, out):
        require(f", {count} hexahedra of one's own, " in text,
                f"the plan does not say so: {text}")
    scene = read_json(output, "scene.json")
    require(abs(scene["element_size"] ** 3 * count / anatomy["volume"] - 1.)
            < 1e-6, f"size of elements: {scene['element_size']}")
    require(statuses(output) == dict.fromkeys(
        (*STAGES, "coarser_blast"), "finished"), f"{statuses(output)}")
    require_coarser_run(output, {"cell_ratio": 2., "element_ratio": None})
    flaw = flaw_of(os.path.join(output, "scene.json"))
    require(not flaw, f"scene.json: {flaw}")
    measures = [entry for entry in read_json(output, "report.json")["measures"]
                if entry["name"].startswith("injury_")]
    require(measures and all(entry["least"] is None for entry in measures),
            f"errors are known: {measures}")
    page = html.unescape(read_bytes(output, "report.html").decode())
    # In the answer, below it and next to the coarser run.
    require(page.count("your own hexahedra have no coarser mesh") == 3,
            "the report does not say why")


# Parts of each value.
TOLERANCES = ["injuries:*=1e-6", "loads:*=1e-6", "peaks:*=1e-6"]


def compare(kind, found, expected, where, own=()):
    """Two tables of numbers by name agree; a test's own tolerances, see
    samples.py, come after the others."""
    tolerances = TOLERANCES + [text for text in own
                               if text.startswith(kind + ":")]
    worst, reasons = samples.compare(tolerances, kind, expected, found)
    print(f"{kind} {where}: {worst:.3g} of the tolerance")
    require(not reasons, f"{kind} {where}: " + "; ".join(reasons))


def compare_injuries(found, expected, where, own=()):
    found, expected = ({name: numpy.array([value])
                        for name, value in table.items()}
                       for table in (found, expected))
    compare("injuries", found, expected, where, own)


def loads(output):
    """Peak and impulse of the load on each facet of the body."""
    values = samples.read(os.path.join(output, "blast", "loads.h5"))
    return {name: values[name] for name in ("peak", "impulse")}


def peaks(output):
    """The largest pressure at each probe, of the air and of the body."""
    found = {}
    for stage in STAGES[1:]:
        path = os.path.join(output, stage, "probes.csv")
        for name, values in samples.read(path).items():
            if "pressure" in name:
                found[f"{stage} {name}"] = values.max(keepdims=True)
    require(found, "no probe has a pressure")
    return found


def scene_ranks(case):
    """One rank and each of --ranks give the same injuries, the same loads on
    the body and the same peaks at probes."""
    expected, own = case.straight(1), case.options.tolerance
    for ranks in case.options.ranks:
        output, where = case.straight(ranks), f"on {ranks} ranks"
        compare_injuries(injury_table(output), injury_table(expected), where,
                         own)
        compare("loads", loads(output), loads(expected), where, own)
        compare("peaks", peaks(output), peaks(expected), where, own)


def newest_state(output, stage):
    """Step and updates of the newest complete checkpoint of a stage; step -1
    without. One that is being removed does not count."""
    newest = {"step": -1, "updates": 0.}
    for marker in glob.glob(os.path.join(output, stage, "checkpoint", "*",
                                         "complete.json")):
        try:
            state = read_json(os.path.dirname(marker), "run.json")["state"]
        except (OSError, ValueError):
            continue
        newest = max(newest, state, key=lambda one: one["step"])
    return newest


def kill_in(case, output, stage, extra, ranks=1):
    """Starts or resumes the scene and kills it in a stage, which has steps
    beyond those of an earlier start by then; the anatomy has no steps. Returns
    the state in the newest checkpoint."""
    since = time.time() - 0.01
    before = newest_state(output, stage)["step"]
    record = os.path.join(output, stage + ".stage.json")
    process = case.start(output, extra, ranks=ranks)
    while process.poll() is None and not (
            is_started(record, since) and (
                stage == "anatomy"
                or newest_state(output, stage)["step"] > before)):
        time.sleep(0.005)
    for pid in resume_cases.descendants(process.pid):
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    out, err = process.communicate()
    require(process.returncode == -signal.SIGKILL,
            f"the scene ended before it was killed in {stage}: "
            + out[-2000:] + err[-2000:])
    require(is_started(record, since), f"{stage} had ended before the kill")
    state = newest_state(output, stage)
    print(f"killed in {stage}, checkpoint of step {state['step']}")
    return state


def went_on(output, straight, stage, state):
    """A finished stage went on from a checkpoint and computed no step before
    it again."""
    summary = read_json(output, stage, "summary.json")
    begin = summary["resumed_from_step"]
    require(begin == state["step"] > 0, f"{stage} went on from step {begin}, "
            f"not from {state['step']}")
    whole = read_json(straight, stage, "summary.json")["performance"]["updates"]
    rest, made = (updates - state["updates"] for updates in (
        whole, summary["performance"]["updates"]))
    print(f"{stage}: {made:.0f} updates after the checkpoint, {whole:.0f} "
          "straight through")
    # A resumed run finds again which leaves are at rest; it may skip more.
    require(made <= (1. + 1e-6) * rest < whole,
            f"{stage} made {made:.0f} updates instead of {rest:.0f}")


def is_started(record, since):
    """Whether a stage was begun after a time and is not finished."""
    try:
        return (os.stat(record).st_mtime >= since
                and '"started"' in read_bytes(record).decode())
    except OSError:
        return False


def scene_sigkill(case):
    """Killed three times in each stage and resumed, a scene continues from
    the last checkpoint each time and ends with the same loads and injuries as
    without; a checkpoint of another build is refused and kept."""
    straight = case.straight(1)
    output = case.folder("killed")
    extra = []
    for stage in STAGES:
        for _ in range(3):
            last = kill_in(case, output, stage, extra)
            extra = ["--resume"]
        if stage == STAGES[0]:
            continue
        refuses_other_key(case, output, stage, extra)
        # The next call finishes this stage.
        if stage == STAGES[-1]:
            case.run(output, extra)
        else:
            kill_in(case, output, STAGES[STAGES.index(stage) + 1], extra)
        went_on(output, straight, stage, last)
    require(injury_table(output) == injury_table(straight),
            "the injuries are others")
    for name in ("blast/load_gauges.csv", "blast/history.csv",
                 "biomechanics/history.csv", "biomechanics/probes.csv"):
        if os.path.exists(os.path.join(straight, name)):
            require(read_bytes(output, name) == read_bytes(straight, name),
                    f"{name} is not the same")


def refuses_other_key(case, output, stage, extra):
    """A checkpoint of a stage that another build has begun is not thrown away
    without a question."""
    path = os.path.join(output, stage + ".stage.json")
    before, record = read_bytes(path), read_json(path)
    with open(path, "w", encoding="utf-8") as file:
        json.dump({**record, "key": "of another build"}, file)
    state = newest_state(output, stage)
    _, _, err = case.run(output, extra, codes=(1,))
    require(len(err.strip().splitlines()) == 1 and "--overwrite" in err
            and "checkpoint of stage " + stage in err, f"stderr is {err}")
    require(newest_state(output, stage) == state, "the checkpoint is gone")
    with open(path, "wb") as file:
        file.write(before)


def scene_parallel_sigkill(case):
    """Killed once in the blast and once in biomechanics on each of the first
    two of --ranks, a scene continues from the last checkpoint and ends with
    the same injuries."""
    for ranks in case.options.ranks[:2]:
        straight = case.straight(ranks)
        output = case.folder(f"killed_on_{ranks}")
        resumed = ["--resume"]
        blast = kill_in(case, output, "blast", [], ranks)
        body = kill_in(case, output, "biomechanics", resumed, ranks)
        went_on(output, straight, "blast", blast)
        case.run(output, resumed, ranks=ranks)
        went_on(output, straight, "biomechanics", body)
        compare_injuries(injury_table(output), injury_table(straight),
                         f"after kills on {ranks} ranks")


def scene_failure(case):
    """A stage that fails ends the scene with its exit code and one line that
    names it; what is finished is kept and reused."""
    output = case.folder("run")
    _, _, err = case.run(
        output, ["--set", "Biomechanics/Energy audit/Largest residual=0",
                 "--set", "Biomechanics/Energy audit/Largest hourglass part=0"],
        codes=(2,))
    require(len(err.strip().splitlines()) == 1
            and "stage biomechanics: energy audit" in err,
            f"stderr is {err}")
    case.run(output, ["--resume"])
    require(statuses(output)["blast"] == "reused",
            "the finished blast was not kept")


def no_room(case, folder, extra, ranks, limits, reason):
    """The scene ends in the blast with exit code 3 and one line that gives the
    reason; what is finished stays."""
    _, _, err = case.run(folder, extra, ranks=ranks, codes=(3,),
                         preexec_fn=limits)
    print(err)
    lines = [line for line in err.splitlines() if line.strip()
             and (ranks == 1 or line.startswith("error: "))]
    require(len(lines) == 1 and "stage blast" in lines[0]
            and reason in lines[0], f"stderr on {ranks} ranks is {err}")
    require(read_json(folder, "anatomy.stage.json")["status"] == "finished",
            "the finished anatomy is lost")
    require(read_json(folder, "blast.stage.json")["status"] != "finished",
            "the blast counts as finished")


def scene_full_disk(case):
    """Files that may not grow as large as they must, on the last of --ranks, then
    a disk that fills, on 1 and each of --ranks: exit code 3 and one line each;
    the scene continues once there is room."""
    full_disk.enter_namespace()
    full = "No space left on device" if full_disk.NAMESPACE in os.environ \
        else "File too large"
    with full_disk.small_disk(case.folder("run"), 8 << 20) as (folder, limits,
                                                               grow):
        no_room(case, folder, [], case.options.ranks[-1],
                lambda: full_disk.limit_files(1 << 20, ignore=False),
                "File too large")
        for ranks in (1, *case.options.ranks):
            no_room(case, folder, ["--resume"], ranks, limits, full)
        grow()
        case.run(folder, ["--resume"])
        found = statuses(folder)
        require(found == {**dict.fromkeys(found, "finished"),
                          "anatomy": "reused"}, f"stages are {found}")


KINDS = {"scene_run": scene_run,
         "scene_full_disk": scene_full_disk,
         "scene_ranks": scene_ranks,
         "scene_sigkill": scene_sigkill,
         "scene_parallel_sigkill": scene_parallel_sigkill,
         "scene_own_mesh": scene_own_mesh,
         "scene_failure": scene_failure}
