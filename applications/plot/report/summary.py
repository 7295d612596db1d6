# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A report for programs: report.json, whose schema is
applications/schemas/report.schema.json, and headline.txt, the verdict in a few
lines."""

import json
import math
import os
import re
import textwrap

from plot.readers import formats
from plot.report import comparison, injury_table

WIDTH = 78  # of the lines of headline.txt
# What is not known of a quantity beside that of the tables.
ROW = {**dict.fromkeys(comparison.TITLES_IN_FILE), "place": "probe 1",
       "cut_off": False, "differs": False}


def of(scene, judged, lead, page):
    """Contents of report.json."""
    facts = scene.facts
    return {
        "application": "scene", "format": formats.NUMBERS["report"],
        "version": facts.get("version", ""),
        "git_revision": facts.get("git_revision", ""), "title": page.title,
        "headline": lead.sentence, "scene": lead.opening,
        # Lines of a terminal, which breaks at spaces of all kinds; those of one
        # paragraph after the first indented.
        "text": [part for line in lead.lines() for part in textwrap.wrap(
            re.sub("[\u00a0\u202f]", " ", line), WIDTH, subsequent_indent="  ")],
        "verdicts": [_verdict(one) for one in lead.verdicts],
        "measures": [_measure(entry) for entry in judged],
        "tables": [{**ROW, **row} for row in lead.rows],
        "reservations": lead.reservations,
        "warnings": [{"text": text, "stages": stages}
                     for text, stages in lead.warnings.items()],
        "sources": list(dict.fromkeys(entry.source for entry in judged
                                      if entry.thresholds)),
        "figures": page.figures()}


def _number(value):
    return value if value is not None and math.isfinite(value) else None


def _bounds(bounds):
    low, high = bounds or (None, None)
    return {"least": _number(low), "largest": _number(high)}


def _verdict(one):
    entry = one.entry
    return {"subject": one.subject, "words": str(one), "severity": one.kind,
            "measure": entry and entry.name,
            "value": entry and _number(entry.value),
            **_bounds(entry and entry.sure_bounds()),
            "is_certain": one.is_certain()}


def _measure(entry):
    return {"name": entry.name, "title": entry.title,
            "value": _number(entry.value), "unit": entry.unit,
            "is_lower_limit": entry.is_cut,
            **_bounds(entry.sure_bounds()), "coarser": _number(entry.coarser),
            "tables": None if entry.tables is None else list(entry.tables),
            "thresholds": [{"value": limit, "meaning": meaning}
                           for limit, meaning in entry.thresholds],
            "verdict": entry.meaning() if entry.has_verdict else "",
            "severity":
            injury_table.severity(entry), "is_certain":
            entry.is_certain() if entry.has_verdict else None,
            "probabilities": [{"event": event, "value": value,
                               **_bounds(bounds and (
                                   bounds[0],
                                   None if entry.is_cut else bounds[1]))}
                              for event, value, bounds in entry.chances()],
            "source": entry.source, "is_own": entry.is_own,
            "limits": entry.limits}


def write(folder, content):
    """Writes report.json and headline.txt, and prints the lines of the latter,
    indented by two spaces."""
    for name, text in (
            ("report.json", json.dumps(content, indent=2, ensure_ascii=False)),
            ("headline.txt", "\n".join(content["text"]))):
        path = os.path.join(folder, name)
        with open(path + ".new", "w", encoding="utf-8") as file:
            file.write(text + "\n")
        os.replace(path + ".new", path)
    for line in content["text"]:
        print("  " + line)
