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
    parts, audited = [], scene.list_of("audit")
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
    if known := audit_table(scene.blast, {row.get("item") for row in audited}):
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
    words, kind = ("not judged", "none") if value is None else \
        ("yes", "good") if value else ("no", "bad")
    return page.tag("span", words, kind=kind)


def _audit_row(name, entry):
    unit = entry.get("unit", "-")

    def shown(value, write=page.quantity):
        value = files.as_number(value)
        return "–" if value is None else write(value, unit)

    limit = "–"
    for key in ("at_most", "at_least"):
        if files.as_number(entry.get(key)) is not None:
            limit = f"{_words(key)} {shown(entry[key], page.plain)}"
    return (_words(name), entry.get("decision", ""), entry.get("quantity", ""),
            shown(entry.get("estimate")), shown(entry.get("measured")), limit,
            _holds(None if limit == "–" else entry.get("holds")),
            page.tag("code", str(entry.get("entry", ""))))


def statement(scene, judged):
    """Accuracy: numerical errors and differences to measurements."""
    parts = [page.paragraph(
        "Errors have three sources: the numerics (cells, elements, recording), "
        "the model (detonation, afterburn, tissue properties), and the "
        "thresholds, which were derived from other models and from animals. "
        "This section estimates the errors of the numerics.")]
    if free := _free_air(scene):
        parts += [page.tag("h3", "Against measurements "
                           + reflections.place_of_burst(scene)), free]
    parts += [page.tag("h3", "This scene with larger cells and elements"),
              error_estimate.section(scene, judged)]
    if checks := _checks(scene):
        parts += [page.tag("h3", "Checks within this run"),
                  page.bullets(checks)]
    return parts


def _free_air(scene):
    def found(number, name):
        return scene.blast.found("results", f"probe_{number}_{name}")

    rows = []
    for quantity, unit in (("peak_overpressure", "Pa"), ("impulse", "Pa s"),
                           ("arrival", "s"), ("duration", "s")):
        number = 1
        while (here := found(number, quantity)) is not None:
            if quantity == "peak_overpressure":
                here = scene.incident_peak(number)
            known = found(number, f"reference_{quantity}")
            is_cut = quantity in reflections.OF_THE_PHASE \
                and bool(found(number, "cut_off"))
            if known:
                rows.append((_probe_place(scene, number),
                             quantity.replace("_", " "),
                             page.limit(page.quantity(here, unit), is_cut),
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
        + reflections.note(scene, "the probe" if found(2, "arrival") is None
                           else "the first probe")
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
    return (f"({page.point([round(x, 3) + 0. for x in point])}) m, "
            f"{page.quantity(math.dist(point, charge), 'm')} from the charge")


def _checks(scene):
    items = []
    unmatched, largest, mean, factor = (
        scene.biomechanics.found("checks", f"loads_{name}") for name in (
            "unmatched_facets", "largest_distance", "mean_distance",
            "impulse_factor"))
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
        largest_correction, *_ = scene.biomechanics.parameter(
            "Loads/Recorded/Largest correction") or [0.1]
        mended = "" if factor is None else (
            ", after all pressures were multiplied by "
            f"{page.number(factor)} so that the impulses agree"
            if factor != 1. else "; pressures are as recorded" + (
                ", since the impulses differ by too much for one factor on all "
                "of them" if abs(change) >= largest_correction else ""))
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
        shown = "0" if abs(loss) < ROUND_OFF else page.number(100. * loss, 2)
        items.append(f"Recording: samples miss at most {shown} % of the peak on a "
                     "facet or gauge.")
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
    listed = {stage.get("name"): stage for stage in scene.list_of("stages")}
    rows = [cost_row(str(name), listed.get(name, {}), scene.stage(name))
            for name in dict.fromkeys((*STAGES, *listed))
            if listed.get(name) or scene.stage(name).exists]
    return [cost_table(rows) if rows else page.missing("stages in scene.json")]


def cost_table(rows):
    """Table of cost_row()s."""
    return page.table(
        ("stage", "status", "wall time", "core time", "memory", "disk",
         "size"), rows, "Other work on the machine lengthens the wall time, "
        "and less so the core time.", numbers=(2, 3, 4, 5))


def cost_row(name, told, stage):
    """Costs of a stage."""
    summary = stage.summary
    spent = (summary.get("performance") or {}) | {
        "wall_seconds": summary.get("wall_seconds")}
    wall, cores, memory = (
        files.as_number(spent.get(other)) if told.get(key) is None
        else files.as_number(told[key])
        for key, other in (("wall_seconds",) * 2, ("core_seconds",) * 2,
                           ("peak_memory", "peak_memory_bytes")))
    disk = files.as_number(told.get("disk"))
    if disk is None and stage.exists:
        disk = float(sum(os.path.getsize(os.path.join(here, file))
                         for here, _, names in os.walk(stage.folder)
                         for file in names))
    most = files.as_number(spent.get("largest_cells"))
    adapted = most is not None and most != summary.get("cells")
    sizes = [f"{page.count(most)} cells at most"] if adapted else []
    sizes += [f"{page.count(summary[word])} {word}" +
              (" at the end" if adapted and word != "steps" else "")
              for word in ("cells", "unknowns", "steps")
              if summary.get(word) is not None]
    return (name, str(told.get("status") or summary.get("status") or "–")
            + _interruptions(summary), _duration(wall), _duration(cores),
            _bytes(memory), _bytes(disk), ", ".join(sizes) or "–")


def _interruptions(summary):
    """Where the starts after the first one continued, after a status."""
    places = [f"step {page.count(one['step'])} ({page.quantity(one['time'], 's')})"
              for one in summary.get("interruptions") or []
              if {"step", "time"} <= one.keys()]
    return f", interrupted: went on from {page.joined(places)}" \
        if places else ""


def _duration(seconds):
    if seconds is None:
        return "–"
    minutes, rest = divmod(int(seconds + 0.5), 60)
    text = f"{page.number(seconds, 2)} s" if minutes == 0 else \
        f"{minutes} min {rest:02d} s" if minutes < 60 else \
        f"{minutes // 60} h {minutes % 60:02d} min"
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
    stages = [(name, getattr(scene, name)) for name in STAGES]
    rows = [(name, known["version"],
             page.tag("code", known.get("git_revision", "–")),
             known.get("ranks", "–"))
            for name, known in [("scene", facts)] + [
                (name, stage.summary) for name, stage in stages]
            if known.get("version")]
    if rows:
        parts.append(page.table(("application", "version", "revision", "ranks"),
                                rows))
    for name, stage in [("", scene)] + stages:
        path = os.path.join(stage.folder, "parameters.prm")
        if os.path.exists(path):
            parts.append(page.folded_file(
                os.path.join(name, "parameters.prm") + ": all entries as used",
                files.read_text(path)))
    return parts or [page.missing("scene.json and the parameter files")]
