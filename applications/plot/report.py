#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Makes the report of a scene: report.py SCENE_FOLDER

Writes SCENE_FOLDER/report.html, one page that needs nothing besides itself:
what the blast does to the person, with pictures, histories, the injury table,
audits, accuracy, cost and how to reproduce it. What a stage did not leave is
said in one line where it would stand. Exit code 0, or 1 with one line for a
folder or file that is not what it should be.
"""

import os
import sys

import look
import report_accuracy
import report_blast
import report_body
import report_data
import report_headline
import report_injury
import report_page
import report_paper
import report_scene
import usage


def build(scene):
    """All sections."""
    facts = scene.facts
    title = str(facts.get("title") or "Report of a blast on a body")
    page = report_page.Page(title, _subtitle(facts))
    judged = report_injury.judge(scene)
    page.open_with(report_headline.answer(scene, judged))
    page.section("The scene", *report_scene.section(scene))
    page.section("What happens when", *report_scene.timeline(scene))
    page.section("Pressure in the air", *report_blast.air(scene))
    page.section("Pressure on the skin", *report_blast.skin(scene))
    page.section("Histories on the skin", *report_blast.histories(scene))
    # What was not asked for is not missing.
    has_body = scene.biomechanics.exists or facts.get(
        "question") in (None, "injury")
    if has_body:
        page.section("Stress waves in the body", *report_body.waves(scene))
        page.section("Histories in the tissue",
                     *report_body.histories(scene))
    page.section("Injury", *report_injury.table(scene, judged))
    if report_paper.is_that_scene(scene):
        page.section("Beside the published simulation",
                     *report_paper.section(scene))
    if has_body:
        page.section("Energy of the body", *report_body.energy(scene))
    page.section("Conservation of the gas",
                 *report_blast.conservation(scene))
    page.section("What was taken for granted", *report_accuracy.plan(scene))
    page.section("Accuracy", *report_accuracy.statement(scene))
    page.section("The body's mesh", *report_body.mesh(scene))
    page.section("Cost", *report_accuracy.cost(scene))
    page.section("How to reproduce", *report_accuracy.reproduce(scene))
    return page.render()


def _subtitle(facts):
    parts = ["Contrecoup"]
    if facts.get("version"):
        parts[0] += f" {facts['version']}"
    if facts.get("git_revision"):
        parts[0] += f" ({facts['git_revision']})"
    for key, word in (("question", "question"), ("accuracy", "accuracy")):
        if facts.get(key):
            parts.append(f"{word}: {facts[key]}")
    return " · ".join(parts)


def main(arguments):
    if arguments in (["--help"], ["-h"]):
        print(__doc__.strip())
        return 0
    if len(arguments) != 1:
        print("usage: report.py SCENE_FOLDER", file=sys.stderr)
        return 1
    folder = arguments[0]
    look.set_up()
    try:
        if not os.path.isdir(folder):
            raise report_data.BrokenInput(f"{folder}: is not a folder")
        text = build(report_data.Scene(folder))
    except report_data.BrokenInput as problem:
        print(f"report.py: {problem}", file=sys.stderr)
        return 1
    print(report_data.write_page(folder, text))
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
