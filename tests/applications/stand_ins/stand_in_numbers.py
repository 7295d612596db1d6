#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A stand-in for the application scene that tells the quantities of the tiny
scene of tests/plot, one value for each. Entry "Flaw" makes one output tell
another, see self_test.py. Drawing takes long: `stand_in_numbers.py FOLDER` draws
the scene there, and runs copy the folder "drawn"."""

import json
import os
import re
import shutil
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
# Lines of the screen; a flaw has another number in place of one.
HEAD = """\
scene 0.1.0 (abc123): 2.268 kg of C-4 and a standing person of 1.76 m and \
78.5 kg, 2.337 m from the nearest skin, 1.27 m above the ground; cells of 20 mm \
at the skin, elements of 10 mm
  expected in free air: the front reaches the body at 1.8 ms with 314 kPa
  changed: Materials/Tissue skin/Density = 1200 kg/m^3, in the library 1100 kg/m^3
"""
ESTIMATE = """\
without a run: 2.268 kg of C-4 at 2.337 m from a standing person of 1.76 m and \
78.5 kg
  in the open air: peak 314.4 kPa, impulse 221.7 Pa s, arrival 1.8 ms, positive \
phase 2.38 ms
  eardrums rupture 94.8 %; loads the lung with 0.41 of what kills half, death by \
lung injury: less than 0.1 %
  before a wall there: peak 314.4 kPa
  eardrums rupture 94.8 %; loads the lung with 0.41 of what kills half, death by \
lung injury: 4.21 %
"""
LOG = """\
the front reaches the body at 1.8 ms with 314 kPa
stage biomechanics took 1 min 15 s
  gravity  left out  its speed  0.00029  0.00033  at most 0.05  Scene/End time
"""
WARNING = "run and tables of Kingery and Bulmash differ by more than their errors"
PLAN = [{"item": f"item_{number}", "decision": "left out",
         "estimate": f"0.{number}", "limit": "at most 0.9",
         "entry": "Scene/End time"} for number in range(1, 9)]
OTHERS = {"estimate": ("peak 314.4", "peak 315.4"),
          "check": ("cells of 20 mm", "cells of 21 mm"),
          "plan": ("0.7", "0.6"),
          "stage": ("2.25 GiB", "2.26 GiB")}


def draw(folder):
    """The tiny scene with what the report does not read, and its report."""
    sys.path[:0] = [os.path.join(HERE, "..", "cases"),
                    os.path.join(HERE, "..", "..", "plot"),
                    os.path.join(HERE, "..", "..", "..", "applications")]
    import numpy
    import tiny_scene
    from case import read_rows
    from plot import command_line

    def change(name, *groups):
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            facts = json.load(file)
        for *path, values in groups:
            place = facts
            for key in path:
                place = place.setdefault(key, {})
            place.update(values)
        tiny_scene.write(os.path.join(folder, name), json.dumps(facts))

    tiny_scene.write_all(folder)
    end, steps = tiny_scene.TIMES[-1], numpy.arange(len(tiny_scene.TIMES))
    results = {}
    for row in read_rows(folder, "blast", "gauge_measures.csv"):
        place = row.pop("place")
        results.update({
            f"loads_{place} {name.split(' [')[0]}".replace(" ", "_"):
            float(value) for name, value in row.items()})
    results["probe_1_reference_arrival"] = 1.8e-3
    change("scene.json", ({"plan": PLAN, "warnings": [WARNING]},), ("tables", "answer", {
        "impulse": 221.7, "arrival": 1.8e-3, "duration": 2.38e-3}))
    change("blast/summary.json", ({"time": end},),
           ("conservation", {"mass_last": 146., "mass_relative_change":
                             146. / 186.07 - 1.}),
           ("results", {name: tiny_scene.with_unit(value, "-")
                        for name, value in results.items()}))
    change("biomechanics/summary.json", ({"time": end},), ("results", {
        name: tiny_scene.with_unit(*value)
        for name, value in tiny_scene.INJURY.items()}))
    tiny_scene.write(os.path.join(folder, "anatomy", "summary.json"), "{}")
    tiny_scene.write(os.path.join(folder, "log.txt"), LOG)
    with open(os.path.join(folder, "blast", "parameters.prm"), "a",
              encoding="utf-8") as file:
        file.write("subsection Charge 1\n  set Center = 2.458, 0, 1.27\n"
                   "  set Mass = 2.268\nend\n")
    pressure = numpy.where(steps == 72, 101325. + 267701.8, 101325.)
    tiny_scene.write_table(os.path.join(folder, "blast", "probes.csv"), {
        "time [s]": tiny_scene.TIMES, "probe_1_pressure [Pa]": pressure})
    tiny_scene.write_table(os.path.join(folder, "blast", "history.csv"), {
        "step": steps, "time [s]": tiny_scene.TIMES,
        "mass [kg]": 186. - steps / 6., "energy [J]": 0. * steps + 6.02e6})
    command_line.run(["report", folder])
    path = os.path.join(folder, "report.html")
    with open(path, encoding="utf-8") as file:
        page = file.read()
    tiny_scene.write(path, re.sub("base64,[^\"]*", "", page))


def tell(text, flaw=""):
    print(text.replace(*OTHERS[flaw]) if flaw in OTHERS else text, end="")


def spoil(path, old, new):
    """Has another number in place of the first one like it in a file."""
    with open(path, encoding="utf-8") as file:
        before, _, after = file.read().partition(old)
    with open(path, "w", encoding="utf-8") as file:
        file.write(before + new + after)


def main(output, flaw):
    if "--estimate" in sys.argv:
        return tell(ESTIMATE, flaw)
    if "--check" in sys.argv:
        tell(HEAD, flaw if flaw == "check" else "")
        return tell("".join("  " + "  ".join(row.values()) + "\n"
                            for row in PLAN), flaw)
    shutil.copytree("drawn", output)
    if flaw == "table":
        spoil(os.path.join(output, "scene.json"), '"tables": 221.7',
              '"tables": 222.7')
    if flaw == "history":
        spoil(os.path.join(output, "blast", "history.csv"), ",0.006,", ",0.0061,")
    if flaw == "report":
        spoil(os.path.join(output, "report.html"), "2.268", "2.278")
    tell(HEAD + ("" if flaw == "silent" else f"WARNING: {WARNING}\n"))
    tell("".join(f"stage {stage} took 1 min 15 s, 2.25 GiB of memory, 5.5 MiB on "
                 "disk\n" for stage in ("anatomy", "blast")), flaw)
    with open(os.path.join(output, "headline.txt"), encoding="utf-8") as file:
        lines = file.read().splitlines()
    if flaw == "answer":
        lines[0] += " 1"
    return tell("".join(f"  {line}\n" for line in lines)
                + f"report in {output}/report.html\n")


if __name__ == "__main__":
    if len(sys.argv) == 2:
        draw(sys.argv[1])
    else:
        main(sys.argv[sys.argv.index("--output") + 1],
             next(word[len("Flaw="):] for word in sys.argv
                  if word.startswith("Flaw=")))
