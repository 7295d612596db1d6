# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Measures of injury: their names, thresholds with sources, and limitations.
All of it is in injury_criteria.json, which the applications read as well; a run
may have thresholds of the user's own in place of the published ones."""

import json
import math
import pathlib
import re
from typing import NamedTuple

from plot.readers import files

SEA_LEVEL = 101325.  # Pa
HERE = pathlib.Path(__file__).absolute().parent
NAME = "injury_criteria.json"
# Next to this file where Contrecoup is installed, next to the code elsewhere.
DATA = HERE / NAME if (HERE / NAME).exists() else \
    HERE.parents[2] / "source" / "numerics" / "injury" / NAME


class Known(NamedTuple):
    """Known facts on a measure: title, an abbreviation in brackets at its end;
    thresholds in increasing order of severity, with their meanings; source;
    limitations. A measure that is worse when lower has negative thresholds."""
    title: str
    thresholds: list
    source: str
    limits: str
    # Measures of how strong the load is. Their thresholds, found for other
    # loads, give no verdict on injury.
    is_exposure: bool = False
    is_own: bool = False  # thresholds of the user


def _thresholds(measure):
    """Limits of increasing severity with their meanings. For levels that
    overlap, a limit is where one begins or ends, and its meaning names all
    that apply from there on."""
    if "levels" not in measure:
        return [tuple(threshold) for threshold in measure["thresholds"]]
    levels = [(meaning, begin, float("inf") if end is None else end)
              for meaning, begin, end in measure["levels"]]
    edges = sorted({edge for _, *ends in levels for edge in ends})
    found = [(edge, " or ".join(meaning for meaning, begin, end in levels
                                if begin <= edge < end)) for edge in edges]
    return [(edge, meaning) for edge, meaning in found if meaning]


_KNOWN = json.loads(DATA.read_text(encoding="utf-8"))
# By the names of biomechanics, and of the report for the loads.
KNOWN = {name: Known(measure["title"], _thresholds(measure),
                     _KNOWN["sources"][measure["source"]], measure["limits"],
                     measure.get("is_exposure", False))
         for name, measure in _KNOWN["measures"].items()}
# By measure: curves of probabilities, and of which event.
CURVES = {name: [(curve, _KNOWN["curves"][curve]["event"])
                 for curve in measure["curves"]]
          for name, measure in _KNOWN["measures"].items()
          if "curves" in measure}
# Names of these probabilities in biomechanics.
OF_CURVES = frozenset("injury_" + curve for rows in CURVES.values()
                      for curve, _ in rows)


def known_by(*parameters):
    """KNOWN, with the thresholds that entries "Injury/Measure NAME/..." of
    parameter files have in place of the published ones, as the C++ class
    OwnThresholds reads them."""
    found = dict(KNOWN)
    for entries in parameters:
        for entry, text in entries.items():
            match = re.fullmatch(r"Injury/Measure (.*)/Thresholds", entry)
            name = re.sub("[- ]", "_", match[1].lower()) if match else ""
            if name in KNOWN:
                source = entries.get(f"Injury/Measure {match[1]}/Source", "")
                found[name] = _with_own(KNOWN[name], text, source)
    return found


def of_run(scene):
    """The same of a scene."""
    return known_by(scene.parameters, scene.biomechanics.parameters)


def _with_own(published, text, source):
    """A measure with thresholds "value: meaning; ...", and where they are
    from."""
    words = [word.partition(":") for word in text.split(";") if word.strip()]
    try:
        thresholds = [(float(value), meaning.strip())
                      for value, _, meaning in words]
    except ValueError as error:
        raise files.BrokenInput(f"parameters.prm: Injury/Measure: {error}") \
            from error
    return published._replace(
        thresholds=thresholds,
        source="the user's own" + (f": {source}" if source else ""),
        limits="thresholds of the user's own; with those that are published: "
        + published.limits, is_exposure=False, is_own=True)


def probability(curve, value):
    """Probability of the event of a curve at a value of its measure, as the
    C++ class InjuryCurve has it."""
    known = _KNOWN["curves"][curve]
    if not value > 0.:
        return 0.
    if known["law"] == "weibull":
        return -math.expm1(-(value / known["scale"]) ** known["exponent"])
    place = known["intercept"] + known["slope"] * math.log(value) - 5. \
        if known["law"] == "probit" else \
        (math.log(value) - known["mean"]) / known["deviation"]
    below = 0.5 * math.erfc(-place / math.sqrt(2.))
    return max(below, probability(known["includes"], value)) \
        if "includes" in known else below


def median_lethal_load(phase, mass, ambient):
    """Load that half survive for a positive phase [s], a body mass [kg] and an
    ambient pressure [Pa], over that for an endless phase, as the C++ function
    lung_median_lethal_overpressure() has it."""
    known = _KNOWN["curves"]["lung_median_lethal_load"]
    scaled = 1e3 * phase * (70. / mass) ** (1. / 3.) * math.sqrt(
        ambient / SEA_LEVEL)
    return 1. + known["factor"] * scaled ** known["exponent"]


def title(name):
    """Name of a measure in words."""
    return KNOWN[name].title if name in KNOWN else \
        name.replace("injury_", "").replace("_", " ")
