# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Measures of injury: their names, thresholds with sources, and limitations.
All of it is in injury_criteria.json, which the applications read as well."""

import json
import math
import os

HERE = os.path.dirname(os.path.abspath(__file__))
# Beside this file where Contrecoup is installed, beside the code elsewhere.
DATA = [path for path in (
    os.path.join(HERE, "injury_criteria.json"),
    os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(HERE))),
                 "source", "numerics", "injury", "injury_criteria.json"))
        if os.path.exists(path)]


def _read():
    with open(DATA[0], encoding="utf-8") as file:
        return json.load(file)


def _thresholds(measure):
    """Limits of increasing severity with their meanings. Of levels that
    overlap, a limit is where one begins or ends, and its meaning names all that
    apply from there on."""
    if "levels" not in measure:
        return [tuple(threshold) for threshold in measure["thresholds"]]
    levels = [(meaning, begin, float("inf") if end is None else end)
              for meaning, begin, end in measure["levels"]]
    edges = sorted({edge for _, *ends in levels for edge in ends})
    found = [(edge, " or ".join(meaning for meaning, begin, end in levels
                                if begin <= edge < end)) for edge in edges]
    return [(edge, meaning) for edge, meaning in found if meaning]


_KNOWN = _read()
# By the names of biomechanics, and of the report for the loads: title, an
# abbreviation in brackets at its end; thresholds in increasing order of
# severity, with their meanings; source; limitations. Of a measure that is worse
# when lower thresholds are negative.
KNOWN = {name: (measure["title"], _thresholds(measure),
                _KNOWN["sources"][measure["source"]], measure["limits"])
         for name, measure in _KNOWN["measures"].items()}
# Measures of how strong the load is. Their thresholds, found for other loads,
# give no verdict on injury.
EXPOSURES = frozenset(name for name, measure in _KNOWN["measures"].items()
                      if measure.get("is_exposure"))
# By measure: curves of probabilities, and of which event.
CURVES = {name: [(curve, _KNOWN["curves"][curve]["event"])
                 for curve in measure["curves"]]
          for name, measure in _KNOWN["measures"].items()
          if "curves" in measure}
# What biomechanics calls these probabilities.
OF_CURVES = frozenset("injury_" + curve for rows in CURVES.values()
                      for curve, _ in rows)


def probability(curve, value):
    """Of the event of a curve at a value of its measure, as the C++ class
    InjuryCurve has it."""
    known = _KNOWN["curves"][curve]
    if not value > 0.:
        return 0.
    if known["law"] == "weibull":
        return -math.expm1(-(value / known["scale"]) ** known["exponent"])
    place = known["intercept"] + known["slope"] * math.log(value) - 5. \
        if known["law"] == "probit" else \
        (math.log(value) - known["mean"]) / known["deviation"]
    return 0.5 * math.erfc(-place / math.sqrt(2.))


def title(name):
    """What a measure is called in words."""
    if name in KNOWN:
        return KNOWN[name][0]
    return name.replace("injury_", "").replace("_", " ")
