# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The report on a scene: all its sections, in order."""

from plot.report import (accuracy, blast_sections, body_sections, headline,
                         injury_table, page, paper, scene_sections, summary,
                         unfinished)


def build(scene):
    """The page, and what report.json holds."""
    facts = scene.facts
    title = str(facts.get("title") or "Report of a blast on a body")
    parts = page.Page(title, _subtitle(facts))
    judged = injury_table.judge(scene)
    lead = headline.Lead(scene, judged)
    parts.open_with(lead.answer(), page.tag(
        "div", blast_sections.verdict_figure(scene, lead.verdicts),
        page.tag("div", lead.tables(), lead.doubts()), kind="first"))
    parts.section("The scene", *scene_sections.section(scene))
    parts.section("Events over time", *scene_sections.timeline(scene))
    of_blast = unfinished.note(scene, "blast")
    of_body = unfinished.note(scene, "blast", "biomechanics")
    parts.section("Pressure in the air", *of_blast, *blast_sections.air(scene))
    people = blast_sections.people(scene)
    if people:
        parts.section("People in the air", *of_blast, *people)
    parts.section("Pressure on the skin", *of_blast,
                  *blast_sections.skin(scene))
    parts.section("Histories on the skin", *of_blast,
                  *blast_sections.histories(scene))
    # A part that was not asked for is not missing.
    has_body = scene.biomechanics.exists or facts.get(
        "question") in (None, "injury")
    if has_body:
        parts.section("Stress waves in the body", *of_body,
                      *body_sections.waves(scene))
        parts.section("Histories in the tissue", *of_body,
                      *body_sections.histories(scene))
    parts.section("Injury", *of_body, *injury_table.table(scene, judged))
    if paper.is_that_scene(scene):
        parts.section("Comparison with the published simulation",
                      *paper.section(scene))
    if has_body:
        parts.section("Energy of the body", *of_body,
                      *body_sections.energy(scene))
    parts.section("Conservation of the gas",
                  *blast_sections.conservation(scene))
    parts.section("Assumptions", *accuracy.plan(scene))
    parts.section("Accuracy", *accuracy.statement(scene, judged))
    if has_body:
        parts.section("The body's mesh", *body_sections.mesh(scene))
    parts.section("Cost", *accuracy.cost(scene))
    parts.section("How to reproduce", *accuracy.reproduce(scene))
    return parts.render(), summary.of(scene, judged, lead, parts)


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
