# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Expected contents of the JSON files of a scene: which of what they hold
are numbers, words, lists and objects. A value that is missing or null is
unknown; one of another kind is an error of the file."""

import json
import math

NUMBER, WORDS, TRUTH = "a number", "words in quotes", "true or false"
POINT = [NUMBER, 3]


def _all(kind, names):
    return dict.fromkeys(names.split(), kind)


_ASSUMPTION = {**_all(WORDS, "decision quantity unit entry"),
               **_all(NUMBER, "estimate measured at_most at_least"),
               "holds": TRUTH}
_VALUE = {"value": NUMBER, "unit": WORDS}
_ROW = {**_all(WORDS, "item decision quantity estimate found limit entry"),
        "holds": TRUTH}
# By tables for the open, before a wall and for who lies along the blast.
_ANSWER = _all({"*": NUMBER}, "in_the_open before_a_wall along_body")
# A list is one of such things, with a number behind it of so many; "*" stands
# for any other name.
SCENE = {
    **_all(WORDS, "application version git_revision title question accuracy "
           "explosive explosive_title body symmetry command"),
    **_all(NUMBER, "format charge_mass distance height distance_along_x end_time "
           "cell_size_at_body element_size ranks"),
    **_all(POINT, "charge_place probe_beside_body nearest_skin"),
    "person": {**_all(WORDS, "description posture side_to_charge"),
               **_all(NUMBER, "length mass charge_azimuth charge_elevation"),
               **_all(POINT, "forward left up")},
    "tables": {**_all(WORDS, "source burst"), "is_published": TRUTH,
               **_all(NUMBER, "equivalence_of_pressure equivalence_of_impulse "
                      "body_mass"),
               "answer": {**_all(NUMBER, "arrival impulse duration"), **_ANSWER},
               **_all({"distance": NUMBER, **_ANSWER}, "trunk ears")},
    "table_comparison": [{**_all(WORDS, "name place unit"),
                          **_all(NUMBER, "run run_error tables tables_error"),
                          **_all(TRUTH, "differs cut_off")}],
    "reflections": [{**_all(WORDS, "place by"), "merges": TRUTH,
                     **_all(NUMBER, "least_delay largest_delay peak_rise "
                            "impulse_rise")}],
    "changes": [_all(WORDS, "entry value before")], "warnings": [WORDS],
    "body_box": [POINT, 2], "domain": [POINT, 2], "coarser_run": {"*": NUMBER},
    "tissue_places": [{"name": WORDS, "place": POINT}],
    "stages": [{**_all(WORDS, "name status folder hash"),
                **_all(NUMBER, "wall_seconds core_seconds peak_memory disk"),
                "warnings": [WORDS]}],
    "plan": [_ROW], "audit": [_ROW], "remarks": [WORDS]}
SUMMARY = {
    **_all(WORDS, "application version git_revision status"),
    **_all(NUMBER, "format cells steps ranks nodes unknowns wall_seconds"),
    **_all({"*": NUMBER}, "performance conservation errors"),
    **_all({"*": _VALUE}, "results checks"), "assumptions": {"*": _ASSUMPTION},
    "organs": [{**_all(WORDS, "name source"),
                **_all(NUMBER, "volume reference_volume")}],
    "interruptions": [_all(NUMBER, "step time")], "warnings": [WORDS]}


def _refuse_number(text):
    raise ValueError(f"{text} is not a number that JSON has")


def parse(text):
    """An object in JSON; NaN and infinity are none."""
    content = json.loads(text, parse_constant=_refuse_number)
    if not isinstance(content, dict):
        raise ValueError("not an object in braces")
    return content


def _is_scalar(value, shape):
    if shape == NUMBER:
        return isinstance(value, (int, float)) and not isinstance(
            value, bool) and math.isfinite(value)
    return isinstance(value, str if shape == WORDS else bool)


def check(value, shape, name=""):
    """Raises ValueError where @p value is not of that shape."""
    if value is None:
        return
    kinds = {list: "a list", dict: "an object in braces"}
    if not (isinstance(value, type(shape)) if type(shape) in kinds
            else _is_scalar(value, shape)):
        raise ValueError(f'"{name}" must be {kinds.get(type(shape), shape)}')
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
