# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Expected contents of the JSON files of a scene: which of what they hold
are numbers, words, lists and objects. A value that is missing or null is
unknown; one of another kind is an error of the file."""

import json
import math

NUMBER, WORDS, TRUTH = "a number", "words in quotes", "true or false"
POINT = [NUMBER, 3]
_ASSUMPTION = {"decision": WORDS, "quantity": WORDS, "unit": WORDS,
               "estimate": NUMBER, "measured": NUMBER, "at_most": NUMBER,
               "at_least": NUMBER, "holds": TRUTH, "entry": WORDS}
_VALUE = {"value": NUMBER, "unit": WORDS}
_ROW = {"item": WORDS, "decision": WORDS, "quantity": WORDS,
        "estimate": WORDS, "found": WORDS, "limit": WORDS, "holds": TRUTH,
        "entry": WORDS}
# A list is one of such things, with a number behind it of so many; "*" stands
# for any other name.
SCENE = {
    "application": WORDS, "format": NUMBER, "version": WORDS, "git_revision": WORDS,
    "title": WORDS, "question": WORDS, "accuracy": WORDS, "explosive": WORDS,
    "explosive_title": WORDS, "charge_mass": NUMBER, "charge_place": POINT,
    "probe_beside_body": POINT, "nearest_skin": POINT,
    "distance": NUMBER, "height": NUMBER, "distance_along_x": NUMBER,
    "person": {"description": WORDS, "length": NUMBER, "mass": NUMBER,
               "posture": WORDS, "forward": POINT, "left": POINT, "up": POINT,
               "side_to_charge": WORDS, "charge_azimuth": NUMBER,
               "charge_elevation": NUMBER},
    "tables": {"equivalence_of_pressure": NUMBER,
               "equivalence_of_impulse": NUMBER, "is_published": TRUTH,
               "source": WORDS, "burst": WORDS, "body_mass": NUMBER,
               "answer": {"arrival": NUMBER, "impulse": NUMBER,
                          "duration": NUMBER, "in_the_open": {"*": NUMBER},
                          "before_a_wall": {"*": NUMBER}},
               **{place: {"distance": NUMBER, "in_the_open": {"*": NUMBER},
                          "before_a_wall": {"*": NUMBER}}
                  for place in ("trunk", "ears")}},
    "table_comparison": [{"name": WORDS, "place": WORDS, "unit": WORDS,
                          "run": NUMBER, "run_error": NUMBER, "tables": NUMBER,
                          "tables_error": NUMBER, "differs": TRUTH,
                          "cut_off": TRUTH}],
    "reflections": [{"place": WORDS, "by": WORDS, "least_delay": NUMBER,
                     "largest_delay": NUMBER, "merges": TRUTH,
                     "peak_rise": NUMBER, "impulse_rise": NUMBER}],
    "changes": [{"entry": WORDS, "value": WORDS, "before": WORDS}],
    "warnings": [WORDS],
    "body": WORDS, "body_box": [POINT, 2],
    "domain": [POINT, 2], "symmetry": WORDS, "end_time": NUMBER,
    "cell_size_at_body": NUMBER, "element_size": NUMBER,
    "coarser_run": {"*": NUMBER},
    "tissue_places": [{"name": WORDS, "place": POINT}],
    "command": WORDS, "ranks": NUMBER,
    "stages": [{"name": WORDS, "status": WORDS, "folder": WORDS,
                "wall_seconds": NUMBER, "core_seconds": NUMBER,
                "peak_memory": NUMBER, "disk": NUMBER,
                "warnings": [WORDS], "hash": WORDS}],
    "plan": [_ROW], "audit": [_ROW], "remarks": [WORDS]}
SUMMARY = {
    "application": WORDS, "format": NUMBER, "version": WORDS, "git_revision": WORDS,
    "status": WORDS, "cells": NUMBER, "steps": NUMBER, "ranks": NUMBER,
    "nodes": NUMBER, "unknowns": NUMBER, "wall_seconds": NUMBER,
    "performance": {"*": NUMBER}, "conservation": {"*": NUMBER},
    "errors": {"*": NUMBER}, "results": {"*": _VALUE},
    "checks": {"*": _VALUE}, "assumptions": {"*": _ASSUMPTION},
    "organs": [{"name": WORDS, "volume": NUMBER, "reference_volume": NUMBER,
                "source": WORDS}],
    "interruptions": [{"step": NUMBER, "time": NUMBER}],
    "warnings": [WORDS]}


def _refuse_number(text):
    raise ValueError(f"{text} is not a number that JSON has")


def parse(text):
    """An object in JSON; NaN and infinity are none."""
    content = json.loads(text, parse_constant=_refuse_number)
    if not isinstance(content, dict):
        raise ValueError("not an object in braces")
    return content


def _name(shape):
    return "a list" if isinstance(shape, list) else "an object in braces"


def _is_scalar(value, shape):
    if shape == NUMBER:
        return isinstance(value, (int, float)) and not isinstance(
            value, bool) and math.isfinite(value)
    return isinstance(value, str if shape == WORDS else bool)


def check(value, shape, name=""):
    """Raises ValueError where @p value is not of that shape."""
    if value is None:
        return
    if isinstance(shape, (dict, list)):
        if not isinstance(value, type(shape)):
            raise ValueError(f'"{name}" must be {_name(shape)}')
    elif not _is_scalar(value, shape):
        raise ValueError(f'"{name}" must be {shape}')
    if isinstance(shape, list):
        if len(shape) == 2 and len(value) != shape[1]:
            raise ValueError(f'"{name}" must have {shape[1]} items')
        for number, item in enumerate(value):
            if item is None:
                raise ValueError(f'"{name}" has an item without a value')
            check(item, shape[0], f"{name}/{number}")
    elif isinstance(shape, dict):
        for key, item in value.items():
            wanted = shape.get(key, shape.get("*"))
            # A value that nobody here reads may be anything.
            if wanted is not None:
                check(item, wanted, f"{name}/{key}" if name else key)
