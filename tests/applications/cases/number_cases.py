# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Proves that every quantity that two outputs of a scene tell has one value:
--estimate, --check, screen, report, JSON and tables; kinds of run_case.py."""

import concurrent.futures
import os
import re

import main_job_cases
import report_figures
import samples
import scene_cases
from case import overrides, read_json, read_rows, read_text, require
from report_figures import require_chance
from report_reader import require_same
from summaries import values_of

AT_ONCE = 2
AMBIENT = 101325.  # Pa
# Entries of six small scenes: kinds of explosive, persons, sides and places.
SCENES = {
    "front": ["Charge/Explosive=tnt", "Charge/Mass=1", "Charge/Distance=2",
              "Scene/End time=0.003"],
    "back_in_free_air": [
        "Charge/Mass=0.5", "Charge/Distance=1.5", "Charge/Height=11.27",
        "Body/Shift=0, 0, 10", "Body/Rotation=0, 0, 180",
        "Scene/End time=0.0022"],
    "side_of_a_small_person": [
        "Charge/Explosive=anfo", "Charge/Mass=5", "Charge/Distance=3",
        "Body/Phantom/Stature=1.62", "Body/Phantom/Mass=58",
        "Body/Rotation=0, 0, 90", "Scene/End time=0.004"],
    "own_explosive_before_a_child": [
        "Charge/Explosive=custom", "Charge/Custom explosive/Like=c-4",
        "Charge/Custom explosive/Name=my mix",
        "Charge/Custom explosive/Energy density=8e9", "Charge/Mass=1",
        "Charge/Distance=2.5", "Charge/Height=0.8",
        "Body/Phantom/Stature=1.4", "Body/Phantom/Mass=35",
        "Body/Phantom/Head scale=1.1", "Scene/End time=0.0038"],
    "without_first_stage": [
        "Charge/Explosive=petn 1.77", "Charge/Mass=20", "Charge/Distance=5",
        "Body/Phantom/Mass=110", "Blast/First stage/Kind=none",
        "Scene/End time=0.0055"],
    "from_the_left": [
        "Charge/Explosive=composition b", "Charge/Mass=2",
        "Charge/Place=1.5, 1.5, 1.2", "Scene/End time=0.0028"]}


def one_number(case):
    """Scenes tell each quantity with one value, whatever the output: those of
    SCENES that --argument names, or all."""
    names = case.options.argument or SCENES
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        outcomes = {name: pool.submit(prove, case, name, SCENES[name])
                    for name in names}
    flaws = []
    for name, outcome in outcomes.items():
        try:
            print(f"{name}: {outcome.result()} numbers agree")
        except (AssertionError, ValueError) as flaw:
            flaws.append(f"{name}: {flaw}")
    require(not flaws, "\n".join(flaws))


def prove(case, name, entries):
    """Runs a scene and compares all that it tells; the count of numbers."""
    output = case.folder(name)
    extra = overrides(entries)
    _, estimate, _ = case.run(output, extra + ["--estimate"])
    _, check, _ = case.run(output, extra + ["--check"])
    _, screen, _ = case.run(output, extra, verbose=False)
    files = report_figures.Files(output)
    main_job_cases.check_summary(files)
    main_job_cases.check_one_number(files, output)
    main_job_cases.check_audit(files, output)
    scene_cases.require_charge(output)
    return (check_estimate(estimate, files) + check_tables(files)
            + check_plan(check, screen, files) + check_screen(screen, files)
            + check_stages(screen, files)
            + check_histories(files) + report_figures.check_report(output))


def check_estimate(text, files):
    """The first answer has the charge, the person and the numbers of the tables
    that scene.json has."""
    facts = files.scene
    answer = facts["tables"]["answer"]
    places = answer["in_the_open"], answer["before_a_wall"]
    wanted = [(r"run: (\S+ kg) of", facts["charge_mass"]),
              (r" at (\S+ m) from", facts["distance"]),
              (r"air: peak (\S+ kPa)", places[0]["overpressure"]),
              (r"impulse (\S+ Pa s)", answer["impulse"]),
              (r"arrival (\S+ ms)", answer["arrival"]),
              (r"positive phase (\S+ ms)", answer["duration"]),
              (r"wall there: peak (\S+ kPa)", places[1]["overpressure"])]
    trunk = facts["tables"]["trunk"]
    if facts["person"].get("side_to_charge") in ("head", "feet"):
        wanted.append((r"alone loads the lung in the open: (\S+) of",
                       (trunk or answer)["along_body"]["lung_exposure"]))
    if trunk is not None and trunk["distance"] <= 1.05 * facts["distance"]:
        # The nearest skin is its, and its lungs are told once.
        trunk = None
    require((trunk is not None) == ("  the trunk is " in text),
            f"trunk: {trunk}, --estimate: {text}")
    if trunk is not None:
        wanted += [(r"trunk is (\S+ m) from", trunk["distance"]),
                   (r"there loads the lung with (\S+) of",
                    trunk["in_the_open"]["lung_exposure"]),
                   (r"; before a wall (\S+), ",
                    trunk["before_a_wall"]["lung_exposure"])]
    ears = facts["tables"].get("ears")
    told = re.search(r"nearer ear is (\S+ m) from .* rupture (.*?); before a wall "
                     r"(.*)", text)
    if told:
        wanted.append((r"nearer ear is (\S+ m) from", ears["distance"]))
    for words, place in zip(told.groups()[1:] if told else (),
                            ("in_the_open", "before_a_wall"), strict=False):
        require_chance(words, ears[place]["eardrum_rupture"], "eardrum")
    require(told or ears is None or ears["distance"] < 1.05 * facts["distance"],
            f"ears: {ears}, --estimate: {text}")
    for pattern, value in wanted:
        require_same(re.search(pattern, text)[1], value, pattern)
    require(facts["person"]["description"] in text, f"another person: {text}")
    effects = re.findall(r"rupture (.*?%); .* lung .*with (\S+) of .* injury: "
                         r"(.*%)", text)
    for effect, place in zip(effects, places, strict=True):
        require_chance(effect[0], place["eardrum_rupture"], "eardrum")
        require_same(effect[1], place["lung_exposure"], "lung exposure")
        require_chance(effect[2], place["lung_lethality"], "lethality")
    return len(wanted) + 6


def check_tables(files):
    """The tables' wave in scene.json is the reference of the blast's probe, and
    that which the run is compared with."""
    answer = files.scene["tables"]["answer"]
    known = {"arrival": answer["arrival"], "impulse": answer["impulse"],
             "duration": answer["duration"],
             "peak_overpressure": answer["in_the_open"]["overpressure"],
             **answer["in_the_open"]}
    results, count = values_of(files.summary["blast"], "results"), 0
    for row in files.scene["table_comparison"]:
        reference = results.get("probe_1_reference_" + row["name"],
                                row["tables"])
        for value in (row["tables"], reference):
            # The probe is as far from the charge as the body to 1e-3.
            require(abs(value / known[row["name"]] - 1.) < 1e-3,
                    f"{row}: {value}, not {known[row['name']]}")
        count += 2
    require(count >= 8, f"{count} quantities are compared with the tables")
    return count


def head_of(text):
    """Description of the coming run: the first lines of a screen."""
    lines = text.splitlines()
    return lines[:1] + [line for line in lines if line.startswith(
        ("  expected ", "  changed: "))]


def check_plan(check, screen, files):
    """--check and the run begin with the same lines, whose numbers are those of
    scene.json; the table of --check is its plan."""
    facts = files.scene
    require(head_of(check) == head_of(screen),
            f"--check: {head_of(check)}; run: {head_of(screen)}")
    head = head_of(check)[0]
    wanted = [(r"\): (\S+ kg) of", facts["charge_mass"]),
              (r", (\S+ m) from the nearest", facts["distance"]),
              (r"skin.*, (\S+ m) above", facts["height"]),
              (r"cells of (\S+ mm)", facts["cell_size_at_body"]),
              (r"elements of (\S+ mm)", facts["element_size"])]
    for pattern, value in wanted:
        require_same(re.search(pattern, head)[1], value, pattern)
    for change in facts["changes"]:
        require(any(change["entry"] in line and change["value"] in line
                    and change["before"] in line for line in head_of(check)),
                f"{change} is not in {head_of(check)}")
    rows = {}
    for line in check.splitlines():
        cells = re.split(r"  +", line.strip())
        rows.setdefault(cells[0], cells[1:])
    # Further rows of scene.json are those of the blast.
    shown = [row for row in facts["plan"] if row["item"] in rows]
    require(len(shown) >= 8, f"--check has {len(shown)} rows of the plan")
    for row in shown:
        # A stage names its entries without its own name.
        cells = rows[row["item"]]
        cells += ["Blast/" + cell for cell in cells]
        for key in ("decision", "estimate", "limit", "entry"):
            # --check tells what a stage finds out in its set-up as unknown.
            require(row.get(key, "") in ("", *cells)
                    or (key == "estimate" and "unknown" in cells),
                    f"plan: {row}, --check: {cells}")
    return len(wanted) + 3 * len(shown)


def check_screen(screen, files):
    """Warnings and answer of the screen are those of report.json, without
    estimates that the run has measured otherwise, and headline.txt, and its
    table of tables those of scene.json."""
    report = read_json(files.output, "report.json")
    lines = screen.splitlines()
    warnings = [line.removeprefix("WARNING: ") for line in lines
                if line.startswith("WARNING: ")]
    known = {entry["text"] for entry in report["warnings"]}
    log = read_text(files.output, "log.txt")
    unknown = [warning for warning in warnings if warning not in known
               and "{0} is measured at".format(
                   warning.partition(" is estimated at ")[0]) not in log]
    require(not unknown and len(warnings) == len(set(warnings)),
            f"screen: {warnings}, report.json: {known}")
    # Any difference from the tables is a warning in both.
    for told in (warnings, known):
        require(any("run and tables of Kingery" in text for text in told)
                == any(row["differs"] for row in
                       files.scene["table_comparison"]),
                f"differences from the tables in warnings: {told}")
    place = next(number for number, line in enumerate(lines)
                 if line.startswith("report in "))
    answer = []
    while lines[place - 1].startswith("  "):
        place -= 1
        answer.insert(0, lines[place][2:])
    headline = read_text(files.output, "headline.txt").splitlines()
    require(answer and answer == headline[:len(answer)],
            f"screen: {answer}, headline.txt: {headline}")
    return len(warnings) + len(answer)


def check_stages(screen, files):
    """Memory and disk of each stage on the screen are those of scene.json."""
    told = re.findall(r"^stage (\w+) took .*, (\S+ \w+) of memory, (\S+ \w+) on "
                      "disk$", screen, re.M)
    stages = {stage["name"]: stage for stage in files.scene["stages"]}
    require(told, f"the screen tells of no stage: {screen}")
    for name, memory, disk in told:
        require_same(memory, stages[name]["peak_memory"], name)
        require_same(disk, stages[name]["disk"], name)
    return 2 * len(told)


def check_histories(files):
    """Summaries say what the last rows of histories say, and the measures of
    the probe those of its own table."""
    count = 0
    for stage in ("blast", "biomechanics"):
        summary = files.summary[stage]
        last = read_rows(files.output, stage, "history.csv")[-1]
        require(float(last["step"]) == summary["steps"], f"{stage}: {last}")
        require_same(last["time [s]"], summary["time"], f"end of {stage}")
        count += 2
    summary = files.summary["blast"]
    last = read_rows(files.output, "blast", "history.csv")[-1]
    for column, text in last.items():
        name = column.split(" [")[0]
        known = summary["conservation"].get(name + "_last")
        if known is not None:
            require(abs(float(text) - known) <= 1e-9 * abs(known),
                    f"{name}: {text}, {known}")
            count += 1
    results = values_of(summary, "results")
    largest = samples.read(os.path.join(
        files.output, "blast", "probes.csv"))["probe_1_pressure [Pa]"].max()
    require(abs(results["probe_1_peak_overpressure"] + AMBIENT - largest)
            <= 1e-9 * largest, f"probe 1: {largest}")
    for (measure, place), value in files.skin.items():
        name = f"{place.replace(' ', '_')}_{measure}"
        if place.startswith("probe ") and name in results:
            require(results[name] == value, f"{name}: {results[name]}")
            count += 1
    require(count >= 6, f"{count} numbers of histories were compared")
    return count


KINDS = {"one_number": one_number}
