# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The report on a scene: all its sections, in order."""

from plot.report import (accuracy, blast_sections, body_sections, headline,
                         injury_table, page, paper, scene_sections, summary,
                         unfinished)


def build(scene):
    """The page, and what report.json holds."""
    facts = scene.facts
    parts = page.Page(
        str(facts.get("title") or "Report of a blast on a body"),
        "Contrecoup" + "".join(words.format(facts[key]) for key, words in (
            ("version", " {}"), ("git_revision", " ({})"),
            ("question", " · question: {}"), ("accuracy", " · accuracy: {}"))
                               if facts.get(key)))
    judged = injury_table.judge(scene)
    lead = headline.Lead(scene, judged)
    parts.open_with(lead.answer(), page.tag(
        "div", blast_sections.verdict_figure(scene, lead.verdicts),
        page.tag("div", lead.tables(), lead.doubts()), kind="first"))
    of_blast = unfinished.note(scene, "blast")
    of_body = unfinished.note(scene, "blast", "biomechanics")
    people = blast_sections.people(scene)
    # A part that was not asked for is not missing.
    has_body = scene.biomechanics.exists or facts.get(
        "question") in (None, "injury")
    for name, content in (
            ("The scene", scene_sections.section(scene)),
            ("Events over time", scene_sections.timeline(scene)),
            ("Pressure in the air", of_blast + blast_sections.air(scene)),
            ("People in the air", people and of_blast + people),
            ("Pressure on the skin", of_blast + blast_sections.skin(scene)),
            ("Histories on the skin", of_blast + blast_sections.histories(scene)),
            ("Stress waves in the body",
             has_body and of_body + body_sections.waves(scene)),
            ("Histories in the tissue",
             has_body and of_body + body_sections.histories(scene)),
            ("Injury", of_body + injury_table.table(scene, judged)),
            ("Comparison with the published simulation",
             paper.is_that_scene(scene) and paper.section(scene)),
            ("Energy of the body",
             has_body and of_body + body_sections.energy(scene)),
            ("Conservation of the gas", blast_sections.conservation(scene)),
            ("Assumptions", accuracy.plan(scene)),
            ("Accuracy", accuracy.statement(scene, judged)),
            ("The body's mesh", has_body and body_sections.mesh(scene)),
            ("Cost", accuracy.cost(scene)),
            ("How to reproduce", accuracy.reproduce(scene))):
        if content:
            parts.section(name, *content)
    return parts.render(), summary.of(scene, judged, lead, parts)
