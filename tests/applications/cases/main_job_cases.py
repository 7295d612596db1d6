# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Tests of the main job, a scene from the charge to its report; kinds of
run_case.py."""

import math
import os
import re
import subprocess
import xml.etree.ElementTree as xml

import report_figures
from case import (check_bound, overrides, read_json, read_summary, read_text,
                  require)
from report_figures import COARSER, STAGES
from summaries import flaw_of, values_of

# Peaks [Pa] on the skin by test and place: of the test's own run, of which
# 3 % may be missing, and of another run with what the test's differs by.
REGRESSION = 0.03
PEAKS = {
    # quickstart.prm as in the test, but with cells of 20 mm at the skin
    # ("Scene/Accuracy=fast"): 829 and 592 kPa. Cells of 10 and 5 mm have 905
    # and 1008, 582 and 649.
    "scene_main_job": {"chest": (777648., 829159., -0.062),
                       "forehead": (597915., 592485., 0.009)},
    # The phantom of the same stature and mass, whose skin has no stairs of 10
    # mm as the STL file has: its peaks with the same cells. The places on the
    # surface are warped with the organs.
    "scene_main_job_surface": {"chest": (824662., 805168., 0.024),
                               "forehead": (705324., 659336., 0.070)}}
ARRIVED = 1e-3 * 101325.  # Pa; what is weaker has not arrived
LONGEST_SCREEN = 25  # lines
# A person of another stature and mass than the phantom's.
OTHER_PERSON = ["Body/Phantom/Stature=1.62", "Body/Phantom/Mass=58",
                "Output/Pictures=false"]


def main_job(case):
    """The scene runs from the charge to its report: peaks on the skin are the
    stored ones, the bounds of the summary of biomechanics hold, and every
    figure of the report is that of the files."""
    output = case.folder("run")
    _, out, _ = case.run(output, verbose=False)
    lines = out.splitlines()
    log = read_text(output, "log.txt").splitlines()
    lost = [line for line in lines
            if line not in log and "% of the simulated time" not in line]
    require(len(lines) <= LONGEST_SCREEN and not lost,
            f"the screen has {len(lines)} lines; log.txt lacks {lost}")
    here = f"report in {output}/report.html"
    require(here in lines and lines[lines.index(here) - 1].startswith("  "),
            f"the screen has no answer before the report's place: {out}")
    prove(case, output)


def main_job_surface(case):
    """The same with a person of a surface: the STL file that anatomy makes of
    a phantom of another stature, with the organs of the phantom."""
    person = case.folder("person")
    anatomy = os.path.join(os.path.dirname(case.options.application),
                           "anatomy")
    subprocess.run(
        [anatomy, case.options.other_file, "--output", person]
        + overrides(OTHER_PERSON), check=True, stdout=subprocess.DEVNULL)
    output = case.folder("run")
    surface = os.path.abspath(os.path.join(person, "surface.stl"))
    case.run(output, ["--set", f"Body/Surface/File={surface}"])
    prove(case, output)
    scene = read_json(output, "scene.json")
    fit = scene["organ_fit"]
    require(fit["checks_held"] == 1. and fit["inside"] >= 0.97
            and min(fit["brain_cover"], fit["lung_cover"]) >= 0.008,
            f"organs fit poorly: {fit}")
    require(any("the person faces +x, 0 degrees" in remark
                for remark in scene["remarks"]),
            f"the way that the person faces is not said: {scene['remarks']}")


def prove(case, output):
    files = report_figures.Files(output)
    statuses = {stage["name"]: stage["status"]
                for stage in files.scene["stages"]}
    require(statuses == dict.fromkeys(STAGES + COARSER, "finished"),
            f"stages are {statuses}")
    for name in ("scene.json", "blast/summary.json",
                 "biomechanics/summary.json"):
        flaw = flaw_of(os.path.join(output, name))
        require(not flaw, f"{name}: {flaw}")
    for bound in case.options.bound:
        check_bound(read_summary(os.path.join(output, "biomechanics")), bound)
    check_peaks(files, PEAKS.get(case.options.name, {}))
    check_summary(files)
    check_one_number(files, output)
    check_audit(files, output)
    check_fields(case, output)
    count = report_figures.check_report(output)
    require(count > 100, f"{count} figures were compared")


def check_audit(files, output):
    """The scene's audit has the limits of the blast's, and no others."""
    text = read_text(output, "log.txt")
    # The log has the lines of all stages; the scene's audit is at its end.
    stages = text.rindex("\nstage ")
    lines = [line for line in text[stages:].splitlines(keepends=True)
             if not line.startswith("WARNING")]
    for name, item in files.summary["blast"]["assumptions"].items():
        if not isinstance(item, dict) or "quantity" not in item:
            continue
        rows = [line for line in lines if item["quantity"] in line]
        has_limit = item.get("at_most", item.get("at_least")) is not None
        require(rows, f"the audit of the scene lacks {name}")
        for row in rows:
            require((" at most " in row or " at least " in row) == has_limit,
                    f"{name} has a limit: {has_limit}, but: {row}")


def check_fields(case, output):
    """The fields of body, plane and skin are there for ParaView at several
    times, those of all the gas on demand; so are the loads."""
    wanted = "Blast/Output/Volume fields=true" in case.options.set
    for stage, names in (("biomechanics", {None}), ("blast", {
            "plane y = 0", "skin", *(["gas"] if wanted else [])})):
        path = os.path.join(output, stage, "fields.pvd")
        require(os.path.exists(path), f"{path} is missing")
        times = {}
        for entry in xml.parse(path).iter("DataSet"):
            require(os.path.exists(os.path.join(output, stage,
                                                entry.get("file"))),
                    f"{path} lists {entry.get('file')}")
            times.setdefault(entry.get("timestep"), set()).add(
                entry.get("name"))
        require(len(times) > 3, f"{path} has {len(times)} times")
        require(names == set.union(*times.values()), f"{path} has {times}")
    for name in ("loads.h5", "loads.xdmf"):
        path = os.path.join(output, "blast", name)
        require(os.path.exists(path), f"{path} is missing")


def check_peaks(files, stored):
    """Peaks of the places that are stored, against this run before and
    another one."""
    for place, (coarse, fine, difference) in stored.items():
        peak = files.peak(place)
        print(f"{place}: {peak:.6g} Pa, {peak / coarse - 1:+.2%} of the stored "
              f"{coarse:.6g}, {peak / fine - 1:+.1%} of the other {fine:.6g}")
        require(abs(peak / coarse - 1.) < REGRESSION,
                f"{place}: {peak} Pa is not within 3 % of {coarse}")
        require(abs(peak / fine - 1. - difference) < REGRESSION,
                f"{place}: {peak} Pa is {peak / fine - 1:+.1%} of {fine}, not "
                f"{difference:+.1%}")


def check_summary(files):
    """Summaries say the same as the tables of peaks and injuries. The former
    have the values at steps; a sample is the mean over one step or several,
    so that the largest lacks at most half of what two samples change there,
    and exceeds the peak by round-off alone."""
    blast = values_of(files.summary["blast"], "results")
    for name, samples in files.gauges.items():
        key = f"loads_{name.replace(' ', '_')}_peak"
        largest = max(samples)
        if name != "time" and blast[key] is None:
            require(largest < ARRIVED,
                    f"{key} is unknown, the table has {largest}")
            continue
        if name == "time" or blast[key + "_time"] >= files.gauges["time"][-1]:
            continue
        at = samples.index(largest)
        beside = samples[max(at - 2, 0):at + 3]
        lack = blast[key] / largest - 1.
        print(f"{key}: the samples lack {lack:.2%}")
        require(-1e-12 <= lack <= 0.5 * (1. - min(beside) / largest),
                f"{key} is {blast[key]}, the table has {largest}")
    body = values_of(files.summary["biomechanics"], "results")
    for name, value in files.injury.items():
        require(abs(body[name] - value) <= 1e-6 * abs(value),
                f"{name} is {body[name]} in the summary, {value} in the "
                "table")


def check_one_number(files, output):
    """A quantity that occurs in two outputs has one value: measures of gauges
    in the table and in the summary, the announced wave and the reference."""
    results = values_of(files.summary["blast"], "results")
    for place, measures in files.places.items():
        for name, value in measures.items():
            key = f"loads_{place}_{name}".replace(" ", "_")
            # The summary has marks of lower limits alone.
            told = results.get(key, 0.) if name == "cut off" else results[key]
            require(told == value or (told is None and math.isnan(value)),
                    f"{key} is {told}, the table has {value}")
    check_impulse(files, results)
    told = re.search(r"reaches the body at (\S+) ms with (\S+) kPa",
                     read_text(output, "log.txt"))
    for text, name, scale in ((told[1], "arrival", 1e3),
                              (told[2], "peak_overpressure", 1e-3)):
        known = scale * results["probe_1_reference_" + name]
        require(text == f"{known:.3g}",
                f"the announced {name} is {text}, the reference {known}")


def check_impulse(files, results):
    """The impulse on the body is one in blast and biomechanics, up to the single
    precision of the samples."""
    if "biomechanics" not in files.summary:
        return
    checks = values_of(files.summary["biomechanics"], "checks")
    recorded, told = ([values.get(name + axis, 0.) for axis in "xyz"]
                      for values, name in ((checks, "loads_recorded_impulse_"),
                                           (results, "loads_impulse_")))
    require(math.dist(recorded, told) <= 1e-4 * math.hypot(*recorded),
            f"impulse of biomechanics: {recorded}, of blast: {told}")


KINDS = {"main_job": main_job, "main_job_surface": main_job_surface}
