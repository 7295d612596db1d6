# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""This run next to the tables of Kingery and Bulmash."""

from plot.readers import files
from plot.report import (error_estimate, injury_table, least_phases, page,
                         reflections)
from plot.report.injury_thresholds import KNOWN, probability

# Quantities of the comparison with the tables.
COMPARED = {"peak_overpressure": "peak overpressure",
            "impulse": "impulse", "duration": "duration",
            "arrival": "arrival",
            "reflected_overpressure": "reflected peak overpressure",
            "reflected_impulse": "reflected impulse",
            "lung_exposure": KNOWN["lung_exposure_air"][0],
            "lung_lethality": KNOWN["lung_lethality"][0],
            "eardrum_rupture": "rupture probability of an eardrum in the open"}
TITLES_IN_FILE = {
    f"{key}{suffix}": f"{before}{title}"
    for key, title in (("run", "this run"), ("tables", "tables"))
    for suffix, before in (("", ""), ("_error", "relative error of "),
                           ("_least", "least of "), ("_largest", "largest of "))
} | {"before_a_wall": "tables before a wall"}
PROBE = least_phases.PROBE  # where the run is compared with the tables
EAR = "nearer ear"
LUNGS = ("lung_exposure", "lung_lethality")
# Loads by which probabilities follow.
LOADS = {"lung_lethality": "lung_exposure", "eardrum_rupture": "peak_overpressure"}
CHANCES = tuple(LOADS)


def completed_rows(scene, judged):
    """Rows with the tables before a wall and with bounds of probabilities."""
    rows = []
    for row in rows_of(scene):
        name = str(row.get("name"))
        if name in (*CHANCES, *LUNGS):
            row = {"before_a_wall": scene.table_answer(name)[1], **row}
        if name == "lung_exposure":
            load = injury_table.find(judged, injury_table.SKIN_NAMES[
                name, injury_table.loaded_side(scene)] if row.get("place") ==
                                     "trunk" else "lung_exposure_air")
            row.setdefault("run_error", load and load.error)
            if load and load.least_part != 1.:
                row["run_least"], row["run_largest"] = load.sure_bounds()
        if name in CHANCES and row.get("place") != EAR:
            for key, ends in _bounds_of_chances(scene, judged, name).items():
                # A row of the tables alone has no value of this run to bound.
                if row.get(key) is not None:
                    row[f"{key}_least"], row[f"{key}_largest"] = ends
        rows.append(row)
    return rows


def compared(scene, judged=()):
    """Rows of this run next to the tables; of the tables alone where this run
    has no probe as far from the charge as the body, nor a gauge there."""
    rows, compared = [], scene.list_of("table_comparison")
    least = least_phases.at_probe(scene)
    for row in completed_rows(scene, judged):
        name, unit = str(row.get("name")), row.get("unit") or "-"
        is_chance = name in CHANCES
        columns = ("run", "tables") if compared else ("tables",)
        cells = [with_error(row.get(key), unit, is_chance,
                             row.get(f"{key}_error")) for key in columns]
        if compared and reflections.is_cut_off(scene, row):
            cells[0] = "≥ " + cells[0]
        if compared and least is not None and name == "duration":
            cells[0] += f", least {page.milliseconds(least)}"
        if compared and name == "lung_exposure" and row.get("run_least"):
            cells[0] += ", least " + page.number(row["run_least"])
        notes = {key: [page.interval(row[f"{key}_least"],
                                     row[f"{key}_largest"])]
                 for key in columns if is_chance and f"{key}_least" in row}
        wall = row.get("before_a_wall")
        if wall is not None:
            told = page.chance if is_chance else page.number
            notes.setdefault("tables", []).append(f"{told(wall)} before a wall")
        for k, (key, cell) in enumerate(zip(columns, cells)):
            others = [text for text in notes.get(key, []) if text != cell]
            cells[k] += f" ({'; '.join(others)})" if others else ""
        if row.get("differs"):
            cells[-1] = page.tag("span", cells[-1], kind="mid")
        rows.append((_title(row), *cells))
    return rows


def _bounds_of_chances(scene, judged, name):
    """Least and largest value of a probability by the errors of its load, of the
    "run" and the "tables"; of what is known."""
    death, peak = injury_table.find(judged, name), "probe_1_peak_overpressure"
    bounds = {"run": (death and death.bounds()) if name in LUNGS else _ends(
        name, scene.blast.found("results", peak),
        error_estimate.of_result(scene, peak))}
    for row in rows_of(scene):
        if row.get("name") == LOADS[name]:
            bounds["tables"] = _ends(name, *(files.as_number(
                row.get(key)) for key in ("tables", "tables_error")))
    return {key: found for key, found in bounds.items() if found}


def _ends(curve, load, error):
    """Probabilities by both ends of a load; None if its error is unknown."""
    return None if None in (load, error) else tuple(
        probability(curve, load * (1. + sign * error)) for sign in (-1., 1.))


def _title(row):
    """Quantity of a row, and its place unless that is the one of the table."""
    name, place = str(row.get("name")), row.get("place") or PROBE
    if name == "lung_exposure" and place != PROBE:
        return f"load over the 50\u00a0% lethality load at the {place}"
    if place == EAR:
        return "rupture probability of an eardrum at the nearer ear (this run: " \
            "by the load on its skin)"
    return COMPARED.get(name, name.replace("_", " ")) \
        + ("" if place == PROBE else f" at the {place}")


def file_of(rows):
    """The same with all digits."""
    return (("quantity", "unit", *TITLES_IN_FILE.values(), "differs"),
            [(_title(row), row.get("unit"),
              *("" if value is None else page.Rounded("", value) for value in (
                  files.as_number(row.get(key)) for key in TITLES_IN_FILE)),
              "yes" if row.get("differs") else "no") for row in rows])


def rows_of(scene):
    """Rows of table_comparison, with lungs at the trunk and eardrums at the
    nearer ear where these are farther from the charge; where no probe has the
    wave, after the answer of the tables."""
    rows = scene.list_of("table_comparison")
    if not rows or gauge(scene):
        rows = _answer_rows(scene) + rows
    elif injury_table.is_trunk_far(scene):
        rows = [row for row in rows
                if not str(row.get("name")).startswith("lung_")] \
            + _trunk_rows(scene)
    return [*rows, *_ear_rows(scene)]


def _ear_rows(scene):
    """A row as those of table_comparison, of the eardrum that is likelier to
    rupture and of the tables at the nearer ear, where that is farther from the
    charge than the nearest skin."""
    there = ((scene.facts.get("tables") or {}).get("ears") or {}).get("distance")
    if there is None or there <= injury_table.FARTHER_TRUNK * (
            scene.fact("distance") or there):
        return []
    run = max((found.value for (name, _), found in scene.gauge_injury().items()
               if name == "eardrum_rupture"), default=None)
    known, wall = scene.table_answer("eardrum_rupture", "ears")
    return [] if None in (run, known) else [
        {"name": "eardrum_rupture", "place": EAR, "unit": "-", "run": run,
         "tables": known, "before_a_wall": wall}]


def _trunk_rows(scene):
    """Rows as those of table_comparison, of the lungs by the load on the skin of
    the trunk and by the tables at its distance."""
    load = scene.gauge_injury().get(
        ("lung_exposure", injury_table.loaded_side(scene)))
    run = None if load is None or load.is_cut else load.value
    rows = []
    for name, value in (("lung_exposure", run), (
            "lung_lethality", None if run is None else
            probability("lung_lethality", run))):
        known, wall = scene.table_answer(name, "trunk")
        rows.append({"name": name, "place": "trunk", "unit": "-", "run": value,
                     "tables": known, "before_a_wall": wall})
    return [row for row in rows if row["tables"] is not None]


def gauge(scene):
    """The gauge whose load is compared with the tables; "" if a probe's wave
    is."""
    places = {row.get("place") or PROBE
              for row in scene.list_of("table_comparison")}
    return "".join(places - {PROBE})


def _answer_rows(scene):
    """Rows as those of table_comparison, with the answer of the tables; lungs at
    the trunk where its skin tells of them."""
    answer = (scene.facts.get("tables") or {}).get("answer") or {}
    in_the_open = answer.get("in_the_open") or {}
    known = {"peak_overpressure": (in_the_open.get("overpressure"), "Pa"),
             "impulse": (answer.get("impulse"), "Pa s"),
             "duration": (answer.get("duration"), "s"),
             "arrival": (answer.get("arrival"), "s")}
    rows = [{"name": name, "tables": value, "unit": unit}
            for name, (value, unit) in known.items()]
    if injury_table.lungs_by(scene) == "skin":
        rows += _trunk_rows(scene)
    else:
        for name in LUNGS:
            value, wall = scene.table_answer(name)
            rows.append({"name": name, "tables": value, "before_a_wall": wall,
                         "unit": "-"})
    rows.append({"name": "eardrum_rupture", "unit": "-",
                 "tables": in_the_open.get("eardrum_rupture")})
    return [row for row in rows if row["tables"] is not None]


def with_error(value, unit, is_chance, error):
    value = files.as_number(value)
    if value is None:
        return "–"
    if is_chance:
        return page.chance(value)
    return page.quantity(value, unit) + (
        "" if error is None else f" {page.error(error)}")
