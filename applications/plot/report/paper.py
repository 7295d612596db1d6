# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The published simulation of five pounds of C-4 before a man, statement by
statement, next to what a run of that scene finds: X. G. Tan, R. N. Saunders,
A. Bagchi, COUPLED PROBLEMS 2017, sections 3.2 and 3.3."""

import collections
from typing import NamedTuple

import numpy as np

from plot.analysis import (coup as coup_facts, person, signals,
                           tissue_places)
from plot.readers import files
from plot.report import blast_sections, body_sections, page

SOURCE = ("X. G. Tan, R. N. Saunders, A. Bagchi: Coupled modeling for "
          "investigation of blast induced traumatic brain injury, COUPLED "
          "PROBLEMS 2017")
HEAD = ("forehead", "vertex", "occiput", "eye", "temple", "ear")
CAVITATION = -1e5
CLOSE = 0.02  # of published values
AGREES, PARTLY, DIFFERS, OPEN = "agrees", "partly", "differs", "open"


class Statement(NamedTuple):
    """A statement of the paper, what was found, and why that differs if it
    does."""
    quote: str
    found: str
    verdict: str
    reason: str = ""


def verdict(agrees, in_part=False):
    return AGREES if agrees else PARTLY if in_part else DIFFERS


def is_that_scene(scene):
    """Whether a scene is the published one: charge, place, body and the way
    that it faces. A published value holds within 2 %."""
    entries = scene.parameters
    wanted = ((scene.charge_mass(), 2.268), (scene.fact("distance"), 2.337),
              (scene.fact("height"), 1.27))
    defaults = {"Body/Scale": 1., "Body/Phantom/Stature": 1.756,
                "Body/Phantom/Mass": 78.5, "Body/Phantom/Head scale": 1.}
    axes = person.axes(scene)
    return (scene.explosive().lower() in ("c-4", "c4")
            and scene.facts.get("body") == "phantom"
            and all(value is not None and abs(value / known - 1.) < CLOSE
                    for value, known in wanted)
            and all(abs(float(entries.get(name, known)) / known - 1.) < CLOSE
                    for name, known in defaults.items())
            and axes is not None and np.allclose(axes, np.eye(3))
            and np.allclose(files.points_of(entries.get(
                "Body/Shift", "0, 0, 0")), 0.))


def section(scene):
    """The table of all statements."""
    gauges = scene.blast.table("load_gauges.csv")
    probes = scene.biomechanics.table("probes.csv")
    statements = (_steps(scene) + _passage(scene) + _head(scene, gauges)
                  + _places(scene, gauges) if gauges else []) + (
        _body(scene, probes) + _brain(scene, probes) if probes else [])
    if not statements:
        return [page.missing("histories of blast and biomechanics")]
    return [
        page.paragraph(
            f"This is the scene of {SOURCE}; pressures at coup and contrecoup "
            f"are below {page.quantity(coup_facts.BANDWIDTH, 'Hz', 2)}, the "
            "other sections have them unfiltered. "
            f"{counted(statements, 'sections 3.2 and 3.3')}{_tissues(scene)}"),
        table(statements)]


def _tissues(scene):
    """A sentence on tissues that are not those of the publication's table 1."""
    name = scene.biomechanics.parameters.get("Materials/Set", "paper")
    return "" if name == "paper" else (
        f" Its tissues are those of the set “{name}”, not of table 1 there, "
        "a further reason for differences in the body.")


def counted(statements, where):
    """How many statements agree, in a sentence."""
    count = collections.Counter(entry.verdict for entry in statements)
    return (f"This run agrees with {count[AGREES]} of {len(statements)} "
            f"statements of its {where} and partly with {count[PARTLY]}; it "
            f"differs from {count[DIFFERS]}, and {count[OPEN]} cannot be "
            "judged from it. Findings are computed from the tables of this run.")


def table(statements):
    """Each statement next to what was found."""
    kinds = {AGREES: "good", PARTLY: "mid", DIFFERS: "bad", OPEN: "note"}
    return page.table(
        ("as published", "in this run", "verdict",
         "likely reason of the difference"),
        [(f"“{entry.quote}”", entry.found,
          page.tag("span", entry.verdict, kind=kinds[entry.verdict]),
          "–" if entry.verdict == AGREES else entry.reason or "–")
         for entry in statements],
        widths=(27, 32, 9, 32))


def _steps(scene):
    """Step sizes of gas and solid."""
    found = []
    for stage, quote, published, why in (
            (scene.blast, "The time step size is about 0.1 micro-sec", 0.1e-6,
             "the blast's cells are larger, and only the smallest ones and the "
             "fastest waves set the step"),
            (scene.biomechanics, "The time step size is 0.08 micro-sec",
             0.08e-6, "the body's elements are cubes without slivers, and the "
             "step comes from the highest frequency of the whole body")):
        table = stage.table("history.csv")
        if table is None or "step" not in table or table["step"][-1] <= 0:
            continue
        begin = int(np.argmax(table["time"] > 0.5 * table["time"][-1]))
        steps = table["step"][-1] - table["step"][begin]
        if steps <= 0:
            continue
        size = (table["time"][-1] - table["time"][begin]) / steps
        found.append(Statement(
            quote, f"{page.quantity(size, 's')} in the second half of the "
            + ("blast" if stage is scene.blast else "body's motion"),
            verdict(0.5 < size / published < 2.), why))
    return found


def _passage(scene):
    """How long the blast loads the body."""
    force = blast_sections.resultant(scene)
    if force is None:
        return []
    time, values = force
    size = np.linalg.norm(values, axis=1)
    top = int(np.argmax(size))
    weak = np.flatnonzero(size[top:] < 0.1 * size[top])
    first, last = time[size > 0.1 * size[top]][[0, -1]]
    until = time[top + weak[0]] if weak.size else time[-1]
    held = last - first
    return [Statement(
        "It takes just a few milliseconds for the blast wave to pass through "
        "the human body … the resultant forces on the human body diminish "
        "rapidly",
        f"the resultant force, {page.quantity(float(size[top]), 'N')} at most,"
        f" falls below a tenth of that {page.milliseconds(until - first)} "
        "after its onset, and stays below from "
        f"{page.milliseconds(held)} after it on",
        verdict(held < 5e-3, until - first < 5e-3),
        "the negative phase and the wave from the ground load the body again")]


def _head(scene, gauges):
    """Phases and peaks at the head."""
    here = [name for name in gauges.others("time")
            if person.part_at(name) in HEAD and gauges[name].max() > 0.]
    if "forehead" not in here:
        return []
    peak = {name: float(gauges[name].max()) for name in here}
    larger = [name for name in here if peak[name] > peak["forehead"]]
    return [_phases(gauges["time"], gauges, here), Statement(
        "The reflected pressure peak at forehead is much higher than other "
        "locations",
        f"forehead {_kpa(peak['forehead'])}; " + ", ".join(
            f"{name} {_kpa(peak[name])}" for name in here
            if name != "forehead"), verdict(not larger, in_part=True),
        f"concave places, here {page.joined(larger)}, reflect the wave "
        "repeatedly; a smooth head has none"),
            *_rear(peak), *_incident(scene, peak), _ground(scene, gauges)]


def _kpa(value):
    return f"{page.number(1e-3 * value)} kPa"


def _phases(time, gauges, here):
    rises = [1e6 * signals.rise_time(time, gauges[name]) for name in here]
    lowest = [gauges[name].min() for name in here]
    both = sum(value < -2e3 for value in lowest)
    return Statement(
        "The calculated pressures on the head surface have a sharp rise and "
        "experience both positive and negative phases",
        f"rises of {page.number(min(rises), 2)} to "
        f"{page.number(max(rises), 2)} µs; pressure falls below the ambient "
        f"at {both} of {len(here)} places, to {_kpa(min(lowest))}",
        verdict(both == len(here), both))


def _first(names, part):
    """The first gauge at a part of the body, or None."""
    return next((name for name in names if person.part_at(name) == part), None)


def _rear(peak):
    temple = _first(peak, "temple")
    if temple is None or "occiput" not in peak:
        return []
    behind, beside = peak["occiput"], peak[temple]
    ear = _first(peak, "ear")
    text = f"occiput {_kpa(behind)}, temple {_kpa(beside)}"
    if ear:
        text += f", ear {_kpa(peak[ear])}"
    return [Statement(
        "The calculated pressure at the rear portion of head surface is "
        "higher than the temple, because of the diffraction of the shock "
        "front", text, verdict(behind > beside, ear and behind > peak[ear]),
        "the published place of the temple is unknown: in front of the middle "
        "of the head the incident wave acts, behind it, as at the ear, the "
        "diffracted wave alone; diffracted waves from both sides meet at the "
        "rear")]


def _incident(scene, peak):
    temple = _first(peak, "temple")
    side_on = scene.incident_peak(1)
    known = scene.blast.found("results",
                              "probe_1_reference_peak_overpressure")
    if temple is None or side_on is None:
        return []
    return [Statement(
        "The peak pressure at the temple is similar to the incident peak "
        "pressure",
        f"temple {_kpa(peak[temple])}; incident {_kpa(side_on)}"
        + (f", Kingery and Bulmash {_kpa(known)}" if known else ""),
        verdict(abs(peak[temple] / (known or side_on) - 1.) < 0.25),
        "the skin is not parallel to the wave there, or cells are too coarse")]


def _ground(scene, gauges):
    """When the ground's reflection reaches the forehead."""
    time = gauges["time"]
    _, second = signals.find_peaks(time, gauges["forehead"])
    quote = "The ground reflection reaches the forehead at 4.8ms"
    if second is None:
        return Statement(quote, "no second front was found there", DIFFERS,
                         "cells are too coarse for it")
    moment, charge = float(time[second]), scene.charge_place()
    place = scene.loads() and scene.loads().places().get("forehead")
    path = "" if charge is None or place is None else "its path is " \
        f"{np.linalg.norm(charge * [1., 1., -1.] - place):.2f} m; "
    return Statement(
        quote, f"second front at {page.milliseconds(moment)}",
        verdict(abs(moment - 4.8e-3) < 0.3e-3),
        path + "it runs through air that the first front has heated and set in "
        "motion, and therefore faster than a wave in cold air, for which "
        "Kingery and Bulmash give 4.6 ms")


def _places(scene, gauges):
    """Order of arrival, concave places, the lower leg."""
    known = {name: measures for name, measures
             in scene.gauge_measures().items() if measures["peak"] > 0.}
    peak = {name: measures["peak"] for name, measures in known.items()}
    order = sorted(known, key=lambda name: known[name]["arrival"])
    chest_first = "chest" in order[:2]
    found = [Statement(
        "The blast pressure reaches the face and the chest first since they "
        "are closer to the explosive",
        "first " + ", ".join(
            f"{name} {page.milliseconds(known[name]['arrival'])}"
            for name in order[:4]),
        verdict(chest_first and {"forehead", "left eye"} & set(order[:5]),
                chest_first),
        "" if chest_first else "another part of the body is closer")]
    eye = _first(known, "eye")
    if eye and {"forehead", "throat", "chest"} <= peak.keys():
        higher = [peak[eye] > peak["forehead"], peak["throat"] > peak["chest"]]
        found.append(Statement(
            "reflects around concave regions (eye socket, lower neck, and "
            "groin)",
            f"eye {_kpa(peak[eye])} against forehead "
            f"{_kpa(peak['forehead'])}, throat {_kpa(peak['throat'])} against "
            f"chest {_kpa(peak['chest'])}",
            verdict(all(higher), any(higher)),
            "the concave place is shallow and farther from the charge"))
    shin = _first(known, "shin")
    if shin:
        found.append(_leg(gauges["time"], gauges, shin))
    return found


def _leg(time, gauges, shin):
    first, second = signals.find_peaks(time, gauges[shin])
    both = second is not None
    values = gauges[shin]
    text = f"{shin}: first front {_kpa(values[first])}"
    if both:
        text += (f" at {page.milliseconds(time[first])}, second one "
                 f"{_kpa(values[second])} at {page.milliseconds(time[second])}")
    return Statement(
        "The high pressure on the lower leg was caused by the ground "
        "reflection", text, verdict(
            values[second] > values[first], in_part=True) if both else OPEN,
        "" if both else "only one front was found: a Mach stem, or cells too "
        "coarse to resolve both")


def _body(scene, probes):
    """Stress waves and motion of the whole body."""
    places = tissue_places.find_places(scene)
    found = _soft_and_stiff(scene) + _first_struck(places, probes)
    coup = tissue_places.named(places, ", coup")
    begin = None if coup is None else signals.arrival(
        probes["time"], coup.pressure(probes))
    if begin is not None:
        top = np.abs(coup.pressure(probes)[
            probes["time"] <= begin + signals.FIRST_WAVES]).argmax()
        shift = max(np.sqrt(sum(
            probes[f"{place.column}displacement_{axis}"][top] ** 2
            for axis in "xyz")) for place in places)
        found.append(Statement(
            "The high-amplitude stress wave propagated inside the human "
            "body prior to any visible displacement of human body",
            "the first waves at the coup are largest at "
            f"{page.milliseconds(float(probes['time'][top]))}; no probe has "
            f"moved by more than {page.quantity(float(shift), 'm')} then",
            verdict(shift < 5e-3)))
    shift = body_sections.largest_displacement(scene)
    if shift is not None:
        found.append(Statement(
            "the maximum displacement is a few centimeters, which justifies "
            "the one-way coupling strategy",
            f"{page.quantity(shift[0], 'm')} at most after "
            f"{page.milliseconds(shift[1])}, in "
            + tissue_places.names(scene).get(shift[2], tissue_places.OTHER),
            verdict(5e-3 <= shift[0] < 0.05, 1e-3 < shift[0] < 0.1),
            "the softest parts move most; the model has neither contact with "
            "the ground nor gravity"))
    return found


def _soft_and_stiff(scene):
    pressures = body_sections.tissue_pressures(scene)
    bone = pressures.get(tissue_places.SKELETON)
    lung = pressures.get(tissue_places.LUNG)
    if bone is None or lung is None:
        return []
    listed = sorted(pressures, key=pressures.get, reverse=True)
    return [Statement(
        "A stiff material like the skeleton has the higher pressure, while "
        "the pressure in a softer material like the lung is much lower",
        "95th percentile of the absolute pressure over the elements, largest "
        "of all output times: " + ", ".join(
            f"{tissue_places.NAMES.get(tissue, 'body')} "
            f"{page.quantity(pressures[tissue], 'Pa', 2)}"
            for tissue in listed),
        verdict(bone > 3. * lung and listed[0] == tissue_places.SKELETON,
                bone > lung),
        "" if listed[0] == tissue_places.SKELETON else
        f"{tissue_places.NAMES.get(listed[0])} is nearly incompressible and "
        "enclosed, so that its pressure persists")]


def _first_struck(places, probes):
    begins = {place.name: begin for place in places if (
        begin := signals.arrival(probes["time"], place.pressure(probes)))
        is not None}
    coup, contrecoup = (begins.get(f"brain, {name}")
                        for name in ("coup", "contrecoup"))
    if None in (coup, contrecoup):
        return []
    order = sorted(begins, key=begins.get)
    return [Statement(
        "the blast wave first reaches the chest and front lobe of the brain",
        ", ".join(f"{name} {page.milliseconds(begins[name])}"
                  for name in order),
        verdict(coup < contrecoup and "chest" in order[0], coup < contrecoup),
        "" if any("chest" in name for name in begins) or coup > contrecoup
        else "no probe is in the chest wall")]


def _brain(scene, probes):
    """The five facts of coup and contrecoup, in the first waves."""
    places = tissue_places.find_places(scene)
    near = tissue_places.named(places, ", coup")
    far = tissue_places.named(places, "contrecoup")
    if None in (near, far) or len(probes["time"]) < 2 \
            or probes["time"][-1] <= probes["time"][0]:
        return []
    # All five on the same histories, as by plot.py coup.
    time, found = coup_facts.filtered(probes["time"], {
        "coup": near.pressure(probes), "contrecoup": far.pressure(probes)})
    begin = signals.onset(time, found["coup"])
    if begin is None:
        return []
    part = (time >= begin - 1e-4) & (time <= begin + signals.FIRST_WAVES)
    time, coup, counter = (values[part] for values in (
        time, found["coup"], found["contrecoup"]))
    begins = [signals.onset(time, values) for values in (coup, counter)]
    if None in begins:
        return []
    size = max(np.abs(counter).max(), 1.)
    tops, dips = signals.extrema(time, counter, 0.15 * size)
    return [_delay(begins[1] - begins[0], near, far),
            _sign(time, counter, size, tops, dips), Statement(
                "the positive peak pressure in the contrecoup site was higher "
                "than the coup site",
                f"contrecoup {page.quantity(float(counter.max()), 'Pa')}, coup "
                f"{page.quantity(float(coup.max()), 'Pa')}",
                verdict(counter.max() > coup.max()),
                "the wave spreads while it passes the brain; a focus at the far "
                "side, as in an ellipsoid, is weak in a head of this shape"),
            *_peaks(tops, dips)]


def _delay(delay, near, far):
    way = float(np.linalg.norm(near.point - far.point))
    return Statement(
        "there was about a 0.1 millisecond time delay of pressure onset "
        "between coup and contrecoup sites",
        f"{page.milliseconds(delay, 2)} between first rises at the probes, which are "
        f"{way:.2f} m apart", verdict(0.05e-3 < delay < 0.2e-3),
        "waves travel around the brain through the skull, in which sound is "
        "faster; in the brain of table 1 it needs "
        f"{page.milliseconds(way / 1480., 2)} for this distance")


def _sign(time, counter, size, tops, dips):
    begin = int(np.argmax(np.abs(counter) > 0.1 * size))
    negative = counter[begin] < 0.
    turned = np.flatnonzero((counter[begin:] < 0.) != negative)
    swing = counter[begin:begin + turned[0]] if turned.size else counter[begin:]
    first = begin + np.abs(swing).argmax()
    # A swing before that may be too weak to stand out.
    weak = not negative and dips and (not tops or dips[0][0] < tops[0][0])
    return Statement(
        "the negative pressure occurred first in the contrecoup site",
        f"its first swing, {page.quantity(float(counter[first]), 'Pa', 2)} at "
        f"{page.milliseconds(float(time[first]))}, is "
        + ("negative" if negative else "positive")
        + (", but weak; the first that stands out, "
           f"{page.quantity(dips[0][1], 'Pa', 2)} at "
           f"{page.milliseconds(dips[0][0])}, is negative" if weak else ""),
        verdict(negative, weak),
        "compression arrives through neck and skull base before the skull moves "
        "away from the brain there")


def _peaks(tops, dips):
    highs = [value for _, value in tops if value > 0.][:6]
    falling = len(highs) >= 3 and all(
        after < before for before, after in zip(highs[:3], highs[1:3]))
    shown = ", ".join(_kpa(value) for value in highs) or "none"
    deep = [value for _, value in dips if value < CAVITATION]
    return [
        Statement(
            "at the contrecoup site three positive peaks are gradually "
            "weakening", f"positive peaks within 2.5 ms: {shown}",
            verdict(falling, len(highs) >= 3),
            "waves through neck and skull are superposed on the reflections "
            "within the head"),
        Statement(
            "three negative pressure dips occurred over the cavitation limit "
            "of -100kPa",
            f"{len(deep)} dips below −100 kPa within 2.5 ms"
            + (", the deepest " + _kpa(min(deep)) if deep else ""),
            verdict(len(deep) == 3, deep),
            "without cavitation in the model, nothing limits the tension"
            if len(deep) > 3 else "")]
