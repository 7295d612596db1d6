# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Assumptions of a scene and whether they held, its accuracy, cost, and how to
reproduce it."""

import math
import os

from plot.readers import files
from plot.readers.scene import STAGES
from plot.report import error_estimate, load_impulses, page, reflections

ROUND_OFF = 1e-9  # of ratios
PLAN_WIDTHS = (10, 17, 19, 9, 9, 10, 7, 19)


def plan(scene):
    """The plan and its audit: scene.json's, and that of the blast."""
    parts = []
    audited = scene.list_of("audit")
    if audited:
        parts.append(page.table(
            ("item", "assumption", "quantity", "estimate before", "found after",
             "limit", "holds", "entry that changes it"),
            [_planned(row) for row in audited],
            "A dash stands for an unknown value or for no limit. Items without "
            "a limit are not judged, nor are those that were not found, unless "
            "the estimate breaks the limit.", widths=PLAN_WIDTHS))
    elif scene.list_of("plan"):
        parts.append(page.table(
            ("item", "assumption", "quantity", "estimate before",
             "entry that changes it"),
            [(_words(row.get("item", "")), row.get("decision", ""),
              row.get("quantity", ""), row.get("estimate", ""),
              page.tag("code", row.get("entry", "")))
             for row in scene.list_of("plan")]))
    told = {row.get("item") for row in audited}
    known = audit_table(scene.blast, told)
    if known:
        parts += [page.tag("h3", "Further assumptions of the blast"), known]
    return parts or [page.missing("plan and audit in scene.json and the "
                                  "blast's summary.json")]


def audit_table(stage, told=()):
    """Assumptions of a stage and whether they held, besides those of @p told;
    None without any."""
    rows = [_audit_row(name, entry) for name, entry in
            (stage.summary.get("assumptions") or {}).items()
            if isinstance(entry, dict) and name not in told]
    return page.table(
        ("item", "assumption", "quantity", "estimate", "measured", "limit",
         "holds", "entry that changes it"),
        rows, numbers=(3, 4), widths=PLAN_WIDTHS) if rows else None


def _planned(row):
    """A row of scene.json's audit; every entry is words already."""
    def word(key):
        text = str(row.get(key) or "–")
        return "–" if text == "unknown" else text

    limit = "–" if word("limit").endswith("unknown") else word("limit")
    return (_words(word("item")), word("decision"), word("quantity"),
            word("estimate"), word("found"), limit,
            _holds(None if limit == "–" else row.get("holds")),
            page.tag("code", word("entry")))


def _words(item):
    return item.replace("_", " ")


def _holds(value):
    if value is None:
        return page.tag("span", "not judged", kind="none")
    return page.tag("span", "yes" if value else "no",
                    kind="good" if value else "bad")


def _audit_row(name, entry):
    unit = entry.get("unit", "-")

    def shown(value, write=page.quantity):
        value = files.as_number(value)
        return "–" if value is None else write(value, unit)

    limit = "–"
    for key, word in (("at_most", "at most "), ("at_least", "at least ")):
        if files.as_number(entry.get(key)) is not None:
            limit = word + shown(entry[key], page.plain)
    measured = shown(entry.get("measured"))
    judged = None if limit == "–" else entry.get("holds")
    return (_words(name), entry.get("decision", ""),
            entry.get("quantity", ""), shown(entry.get("estimate")),
            measured, limit, _holds(judged),
            page.tag("code", str(entry.get("entry", ""))))


def statement(scene, judged):
    """Accuracy: numerical errors and differences to measurements."""
    parts = [page.paragraph(
        "Errors have three sources: the numerics (cells, elements, recording), "
        "the model (detonation, afterburn, tissue properties), and the "
        "thresholds, which were derived from other models and from animals. "
        "This section estimates the errors of the numerics.")]
    free = _free_air(scene)
    if free:
        parts += [page.tag("h3", "Against measurements "
                           + reflections.place_of_burst(scene)), free]
    parts += [page.tag("h3", "This scene with larger cells and elements"),
              error_estimate.section(scene, judged)]
    checks = _checks(scene)
    if checks:
        parts += [page.tag("h3", "Checks within this run"),
                  page.bullets(checks)]
    return parts


def _free_air(scene):
    rows = []
    for quantity, unit in (("peak_overpressure", "Pa"), ("impulse", "Pa s"),
                           ("arrival", "s"), ("duration", "s")):
        number = 1
        while scene.blast.found("results",
                                f"probe_{number}_{quantity}") is not None:
            stem = f"probe_{number}_"
            here = scene.incident_peak(number) \
                if quantity == "peak_overpressure" \
                else scene.blast.found("results", stem + quantity)
            known = scene.blast.found("results",
                                      stem + "reference_" + quantity)
            is_cut = quantity in reflections.OF_THE_PHASE \
                and bool(scene.blast.found("results", stem + "cut_off"))
            if known:
                rows.append((_probe_place(scene, number),
                             quantity.replace("_", " "),
                             page.limit(here, is_cut)
                             + page.quantity(here, unit),
                             page.quantity(known, unit),
                             "–" if is_cut
                             else page.percent(here / known - 1.)))
            number += 1
    if not rows:
        return None
    return page.table(
        ("probe", "quantity", "this run", "Kingery and Bulmash", "difference"),
        rows,
        f"The reference is a bare charge {reflections.place_of_burst(scene)} "
        "(C. N. Kingery, G. Bulmash, ARBRL-TR-02555, 1984). "
        + reflections.note(scene, "the first probe" if scene.blast.found(
            "results", "probe_2_arrival") is not None else "the probe")
        + (" ≥: a lower limit, since the run ends within the positive phase "
           "there; it has no difference." if any(
               row[2].startswith("≥") for row in rows) else ""),
        numbers=(2, 3, 4))


def _probe_place(scene, number):
    """Where a probe in the air is."""
    points = (scene.blast.parameters.get("Probes/Points") or "").split(";")
    charge = scene.charge_place()
    try:
        point = [float(x) for x in points[number - 1].split(",")]
    except (IndexError, ValueError):
        point = []
    if len(point) != 3 or charge is None:
        return f"probe {number}"
    away = math.dist(point, charge)
    place = page.point([round(x, 3) + 0. for x in point])
    return f"({place}) m, {page.quantity(away, 'm')} from the charge"


def _round_off(part):
    """A part in per cent, where no more than round-off may be left."""
    return "0" if abs(part) < 1e-9 else page.number(100. * part, 2)


def _checks(scene):
    found = scene.biomechanics.found
    items = []
    unmatched = found("checks", "loads_unmatched_facets")
    largest = found("checks", "loads_largest_distance")
    mean = found("checks", "loads_mean_distance")
    if None not in (unmatched, largest, mean):
        items.append(
            "Loads: facets of the body without a recorded facet: "
            f"{page.count(unmatched)}; the others are "
            f"{page.number(1e3 * mean)} mm from theirs on average, "
            f"{page.number(1e3 * largest)} mm at most.")
    impulses = load_impulses.along(scene)
    if impulses is not None:
        recorded, mapped = impulses
        change = mapped / recorded - 1.
        change = change if abs(change) > ROUND_OFF else 0.
        factor = found("checks", "loads_impulse_factor")
        mended = "" if factor is None else (
            ", after all pressures were multiplied by "
            f"{page.number(factor)} so that the impulses agree"
            if factor != 1. else "; pressures are as recorded" + (
                ", since the impulses differ by too much for one factor on all "
                "of them" if abs(change) >=
                load_impulses.largest_correction(scene) else ""))
        when, where = load_impulses.kind(scene)
        items.append(
            f"Impulse: {page.quantity(recorded, 'N s')} recorded on the whole "
            f"body {when}, {page.quantity(mapped, 'N s')}{where} "
            f"on the elements ({page.number(100. * change, 2)} %){mended}.")
        left = load_impulses.pushes_left(scene)
        if left is not None:
            items[-1] += (
                f" What cancels leaves {page.quantity(left[0], 'N s')} of the "
                "recorded one when that is largest, "
                f"{page.quantity(left[1], 'N s')} on the elements then.")
        rest = load_impulses.rest(scene)
        if rest is not None:
            told = ["(" + ", ".join(page.number(part) for part in one) + ") N s"
                    for one in rest]
            items[-1] += (f" At the end of the record its components are "
                          f"{told[0]} recorded and {told[1]} on the elements.")
    loss = scene.blast.found("checks", "loads_sampled_peak_loss")
    if loss is not None:
        items.append("Recording: samples miss at most "
                     f"{_round_off(loss)} % of the peak on a facet or gauge.")
    rough = scene.measures().get("injury_pressure_roughness")
    if rough is not None:
        items.append(
            "Brain pressure oscillates between neighbouring elements, by "
            f"{page.number(rough.value, 2)} times its averages over neighbours "
            "(root mean square). The oscillation is a numerical error; "
            "measures of injury therefore use the averages.")
    return items


def cost(scene):
    """A row for each stage."""
    rows = []
    listed = {stage.get("name"): stage for stage in scene.list_of("stages")}
    for name, stage in (("anatomy", scene.anatomy), ("blast", scene.blast),
                        ("biomechanics", scene.biomechanics)):
        told = listed.pop(name, {})
        if not told and not stage.exists:
            continue
        rows.append(cost_row(name, told, stage))
    rows += [cost_row(str(name), told, scene.stage(name))
             for name, told in listed.items()]
    if not rows:
        return [page.missing("stages in scene.json")]
    return [cost_table(rows)]


def cost_table(rows):
    """Table of cost_row()s."""
    return page.table(
        ("stage", "status", "wall time", "core time", "memory", "disk",
         "size"), rows, "Other work on the machine lengthens the wall time, "
        "and less so the core time.", numbers=(2, 3, 4, 5))


def cost_row(name, told, stage):
    """Costs of a stage."""
    summary = stage.summary if stage else {}
    spent = (summary.get("performance") or {}) | {
        "wall_seconds": summary.get("wall_seconds")}

    def value(key, other):
        known = files.as_number(told.get(key))
        return known if known is not None \
            else files.as_number(spent.get(other))

    disk = files.as_number(told.get("disk"))
    if disk is None and stage and stage.exists:
        disk = float(sum(os.path.getsize(os.path.join(here, file))
                         for here, _, names in os.walk(stage.folder)
                         for file in names))
    most = files.as_number(spent.get("largest_cells"))
    adapted = most is not None and most != summary.get("cells")
    sizes = [f"{page.count(most)} cells at most"] if adapted else []
    sizes += [f"{page.count(summary[key])} {word}" +
              (" at the end" if adapted and key != "steps" else "")
              for key, word in (("cells", "cells"), ("unknowns", "unknowns"),
                                ("steps", "steps"))
              if summary.get(key) is not None]
    status = str(told.get("status") or summary.get("status") or "–")
    return (name, status + _interruptions(summary),
            _duration(value("wall_seconds", "wall_seconds")),
            _duration(value("core_seconds", "core_seconds")),
            _bytes(value("peak_memory", "peak_memory_bytes")), _bytes(disk),
            ", ".join(sizes) or "–")


def _interruptions(summary):
    """Where the starts after the first one continued, after a status."""
    places = [f"step {page.count(one['step'])} "
              f"({page.quantity(one['time'], 's')})"
              for one in summary.get("interruptions") or []
              if {"step", "time"} <= one.keys()]
    return f", interrupted: went on from {page.joined(places)}" \
        if places else ""


def _duration(seconds):
    if seconds is None:
        return "–"
    minutes, rest = divmod(int(seconds + 0.5), 60)
    text = f"{minutes // 60} h {minutes % 60:02d} min"
    if minutes == 0:
        text = f"{page.number(seconds, 2)} s"
    elif minutes < 60:
        text = f"{minutes} min {rest:02d} s"
    return page.Rounded(text, seconds, "s")


def _bytes(count):
    if count is None:
        return "–"
    for size, unit in ((2**30, "GiB"), (2**20, "MiB"), (2**10, "KiB")):
        if count >= size:
            return page.Rounded(f"{page.number(count / size, 2)} {unit}",
                                int(count), "B")
    return page.Rounded(f"{int(count)} B", int(count), "B")


def reproduce(scene):
    """Command, version, and what the parameter file had."""
    facts = scene.facts
    command = facts.get("command")
    parts = []
    if command:
        ranks = facts.get("ranks") or 1
        if ranks > 1 and "mpirun" not in command:
            command = f"mpirun -np {ranks} {command}"
        parts += [page.tag("pre", command), page.paragraph(
            "What is finished in the folder is kept; --overwrite computes all "
            "anew, another folder after --output keeps both.", kind="note")]
    rows = []
    for name, stage in (("scene", None), ("anatomy", scene.anatomy),
                        ("blast", scene.blast),
                        ("biomechanics", scene.biomechanics)):
        known = facts if stage is None else stage.summary
        if known.get("version"):
            rows.append((name, known["version"],
                         page.tag("code", known.get("git_revision", "–")),
                         known.get("ranks", "–")))
    if rows:
        parts.append(page.table(("application", "version", "revision", "ranks"),
                                rows))
    for name, folder in [("", scene.folder)] + [
            (name, getattr(scene, name).folder) for name in STAGES]:
        path = os.path.join(folder, "parameters.prm")
        if os.path.exists(path):
            with files.reading(path), open(
                    path, encoding="utf-8") as file:
                text = file.read()
            parts.append(page.folded_file(
                os.path.join(name, "parameters.prm")
                + ": all entries as used", text))
    return parts or [page.missing("scene.json and the parameter files")]
