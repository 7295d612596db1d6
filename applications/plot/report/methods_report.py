# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The report that puts two runs of one head next to one another."""

import matplotlib.pyplot as plt
import numpy as np

from plot.analysis import signals
from plot.figures import head_figures, style
from plot.report import accuracy, head_report, page

NAMES = {"ale": "ALE", "mpm": "MPM"}
RASTER = 160  # places along the longer side of difference fields
AGREEMENT = 0.1
# Pressures have either sign. Below this part of the largest one their
# differences are absolute, since ratios to numbers near zero say nothing.
NEAR_ZERO = 0.05
SAME_END = 1e-3  # relative difference of end times that are the same
SPAN = 5e-4  # of running means at probes, which leave no ringing [s]


class Pair:
    """The first run, which the second is compared with."""

    def __init__(self, first, second):
        self.runs = (first, second)
        names = [NAMES.get(run.parameters.get("Method", "ale"), "?")
                 for run in self.runs]
        self.names = names if names[0] != names[1] else [
            f"{name} {number}" for number, name in enumerate(names, 1)]

    def both_have(self, layer):
        return all(run.region(layer) for run in self.runs)


def build(pair, folder):
    """The page; its pictures are left in @p folder as well."""
    rows = quantities(pair)
    parts = page.Page("One head, two methods: " + " and ".join(pair.names),
                      " · ".join(run.folder for run in pair.runs))
    parts.open_with(answer(pair, rows), head_report.warnings(
        dict(zip(pair.names, pair.runs))))
    parts.section("Quantities", table(pair, rows))
    parts.section("Contact", *contact(pair, folder))
    parts.section("Pressures", *pressures(pair, folder))
    parts.section("Cuts", *cuts(pair, folder))
    parts.section("Energy and cost", *energy(pair))
    return parts.render()


def quantities(pair):
    """Names, units and the values of both runs; None where one has none."""
    rows = [("mass", "kg", [float(run.history["mass"][0]) for run in pair.runs])]
    if all(run.planes for run in pair.runs):
        until = " until the end of the run" if any(
            run.is_cut_off() for run in pair.runs) else ""
        rows += zip(
            ("largest contact force, mean over 50 µs", "largest contact area",
             f"contact impulse{until}", "momentum changes its sign",
             "contact ends"), ("N", "m^2", "N s", "s", "s"),
            zip(*map(_of_contact, pair.runs)))
    for layer in filter(pair.both_have, ("csf", "brain")):
        for quantity, take in (("least_pressure", np.argmin),
                               ("largest_pressure", np.argmax)):
            rows.append((f"{quantity.replace('_', ' ')} of {layer}", "Pa",
                         [head_report.extreme(run, quantity, layer, take)[0]
                          for run in pair.runs]))
    if pair.both_have("csf"):
        rows.append(("largest speed of csf", "m/s", [
            float(run.column("largest_speed", "csf").max())
            for run in pair.runs]))
    for number, name in enumerate(probe_names(pair), 1):
        for span in (0., SPAN):
            rows += [(
                f"{word} pressure at {name}" + (
                    f", mean over {page.quantity(span, 's')}" if span else ""),
                "Pa", [float(take(probe(run, number, span)))
                       for run in pair.runs])
                for word, take in (("least", np.min), ("largest", np.max))]
    return rows


def _of_contact(run):
    """Largest force and area, impulse, and times of rebound and end."""
    return (head_report.largest_force(run)[0],
            head_figures.smoothed(run, run.history["contact_area"]).max(),
            run.contact("contact_impulse"), run.rebound(), run.last_contact())


def probe(run, number, span):
    """Pressure at a probe, as running means over a span unless it is 0."""
    values = run.probes[f"pressure_{number}"]
    return signals.smooth(run.probes["time"], values, span)[1] if span \
        else values


def probe_names(pair):
    """Names of places that both runs follow; [] unless these are the same."""
    first, second = pair.runs
    return head_report.probe_names(first) if first.probes and second.probes \
        and first.parameters.get("Probes/Points", "") \
        == second.parameters.get("Probes/Points", "") else []


def largest_pressure(rows):
    """Largest magnitude of all pressures of the first run [Pa]."""
    return max((abs(values[0]) for _, unit, values in rows
                if unit == "Pa" and values[0] is not None), default=0.)


def difference(values, scale=0.):
    """Difference of the second from the first, over the first; None if
    unknown, or if the first is near zero compared with @p scale."""
    if None in values or not values[0] or abs(values[0]) < NEAR_ZERO * scale:
        return None
    return values[1] / values[0] - 1.


def relative_differences(rows):
    """Relative differences of all rows, see difference()."""
    largest = largest_pressure(rows)
    return [difference(values, largest if unit == "Pa" else 0.)
            for _, unit, values in rows]


def quantity(value, unit):
    if unit == "s":
        return page.milliseconds(value)
    if unit == "m^2":
        return page.number(1e4 * value) + " cm²"
    return page.quantity(value, unit)


def shown_difference(values, unit, part):
    """In per cent, absolute where the relative difference is unknown, or a
    dash if a value is missing."""
    if part is not None:
        return f"{100. * part:+.1f} %"
    if None in values:
        return "–"
    change = values[1] - values[0]
    return ("+" if change > 0. else "") + quantity(change, unit)


def table(pair, rows):
    return page.table(("whole head", *pair.names, "difference"), [
        (name, *("–" if value is None else quantity(value, unit)
                 for value in values), shown_difference(values, unit, part))
        for (name, unit, values), part in zip(rows, relative_differences(rows))],
                      "Pressures are extrema over cells or particles, and over "
                      "rows of the history. Differences are relative to the "
                      f"first run; of pressures below {100. * NEAR_ZERO:.0f} % "
                      "of its largest one they are absolute.",
                      numbers=(1, 2, 3))


def answer(pair, rows):
    known = {name: part for (name, _, _), part in zip(
        rows, relative_differences(rows))
             if part is not None and name != "mass"}
    far = sorted((name for name, part in known.items()
                  if abs(part) > AGREEMENT), key=lambda name: -abs(known[name]))
    text = (f"{len(known) - len(far)} of {len(known)} quantities of "
            f"{pair.names[1]} are "
            f"within {100. * AGREEMENT:.0f} % of those of {pair.names[0]}.")
    if far:
        text += " Farthest: " + "; ".join(
            f"{name} {100. * known[name]:+.0f} %" for name in far[:3]) + "."
    seconds = [(run.summary.get("performance") or {}).get("core_seconds")
               for run in pair.runs]
    if None not in seconds and seconds[0] > 0.:
        text += (f" {pair.names[1]} took {page.number(seconds[1] / seconds[0])} "
                 f"times the processor time of {pair.names[0]}.")
    ends = [float(run.history["time"][-1]) for run in pair.runs]
    if abs(ends[1] / ends[0] - 1.) > SAME_END:
        text += (" The runs end at different times, after "
                 + " and ".join(map(page.milliseconds, ends))
                 + ": extremes, impulse and energies at the end are until "
                 "then.")
    return page.tag("div", page.paragraph(text), kind="answer")


def _histories(pair, panels):
    """A figure of panels side by side: title, unit, and for each run a curve
    of its history: time and values."""
    figure, axes = plt.subplots(1, len(panels), squeeze=False,
                                figsize=(4.7 * len(panels), 3.1))
    for axis, (title, unit, curves) in zip(axes[0], panels):
        largest = max(np.abs(values).max() for _, values in curves) or 1.
        factor, shown = style.scale_unit(unit, largest) if unit != "m^2" \
            else (1e4, "cm²")
        axis.axhline(0., color=style.GREY, linewidth=0.7)
        for name, (time, values), colour in zip(pair.names, curves,
                                                style.COLOURS):
            axis.plot(1e3 * time, factor * values, label=name, color=colour,
                      linewidth=1.)
        axis.set(title=title, ylabel=f"[{shown}]", xlabel="time [ms]")
        axis.legend()
    return figure


def contact(pair, folder):
    if not all(run.planes for run in pair.runs):
        return [page.missing("planes")]
    panels = [(f"contact {word}", unit, [
        (run.history["time"], head_figures.smoothed(
            run, run.history[f"contact_{word}"])) for run in pair.runs])
        for word, unit in (("force", "N"), ("area", "m^2"))]
    return [head_report.figure(
        folder, "contact_of_both", _histories(pair, panels),
        "Curves of contact force and area over time by both methods.",
        "Contact force and area of the whole head, means over 50 µs.")]


def pressures(pair, folder):
    parts = []
    for layer in filter(pair.both_have, ("csf", "brain")):
        panels = [(f"{word} pressure of {layer}", "Pa", [
            (run.history["time"], run.column(f"{word}_pressure", layer))
            for run in pair.runs]) for word in ("least", "largest")]
        parts.append(head_report.figure(
            folder, f"pressures_{layer}", _histories(pair, panels),
            f"Curves of the least and largest pressure of {layer} by both "
            "methods.", f"Least and largest pressure of {layer}."))
    panels = [(name, "Pa", [(run.probes["time"], probe(run, number, 0.))
                            for run in pair.runs])
              for number, name in enumerate(probe_names(pair), 1)]
    for begin in range(0, len(panels), 2):
        parts.append(head_report.figure(
            folder, f"probes_{begin // 2 + 1}",
            _histories(pair, panels[begin:begin + 2]),
            "Curves of pressure at probes by both methods.",
            "Pressure at probes."))
    return parts or [page.missing("a brain and its CSF in both runs")]


def cuts(pair, folder):
    """Pressure by both methods at the same times, and the difference."""
    chosen = [(a, b) for a in pair.runs[0].picked()
              for b in pair.runs[1].fields()
              if abs(a[0] - b[0]) <= 0.01 * a[0]]
    if not chosen:
        return [page.missing("fields of both runs at the same times")]
    found = [[run.cut(entry) for run, entry in zip(pair.runs, entries)]
             for entries in chosen]
    return [head_report.figure(
        folder, "pressure_of_both", _draw_cuts(pair, found),
        "Rows of cuts through the head, coloured by pressure: by the first "
        "method, the second, and their difference.",
        "Pressure in a cut through the head's centre: "
        f"{pair.names[0]}, {pair.names[1]}, and the second less the first in "
        "brain and CSF; one scale, that of brain and CSF. "
        + head_report.choice(pair.runs[0],
                             [entries[0][0] for entries in chosen]))]


def _inside(run, cut):
    return head_figures.of_layers(run, cut.values, ("brain", "csf"))


def _draw_cuts(pair, found):
    largest = max(np.percentile(np.abs(
        cut.values["pressure"][_inside(run, cut)]), 99.5)
        for cuts_of_time in found
        for run, cut in zip(pair.runs, cuts_of_time)) or 1.
    factor, unit = style.scale_unit("Pa", largest)
    norm = style.about_zero(largest * factor)
    figure, axes = plt.subplots(3, len(found), squeeze=False,
                                figsize=(2.5 * len(found) + 0.9, 8.2))
    drawn = []
    for number, cuts_of_time in enumerate(found):
        for axis, cut in zip(axes[:, number], cuts_of_time):
            drawn.append(cut.values["pressure"] * factor)
            shown = head_figures.add_polygons(
                axis, cut, slice(None), drawn[-1], cmap=style.DIVERGING, norm=norm)
        values, extent = _rasters(pair, cuts_of_time)
        difference = factor * (values[1] - values[0])
        drawn.append(difference.ravel())
        axes[2, number].imshow(difference, origin="lower", extent=extent,
                               cmap=style.DIVERGING, norm=norm)
        for axis, title in zip(axes[:, number], (*pair.names, "difference")):
            axis.set(aspect="equal", xlim=extent[:2], ylim=extent[2:])
            axis.set_axis_off()
            axis.set_title(f"{title}, {1e3 * cuts_of_time[0].time:.3g} ms",
                           fontsize=9)
    figure.colorbar(shown, ax=axes, shrink=0.6, pad=0.02,
                    extend=style.beyond(np.concatenate(drawn), norm),
                    label=f"pressure [{unit}]")
    return figure


def _rasters(pair, cuts_of_time):
    """Pressure of brain and CSF of both runs on one raster, NaN elsewhere, and
    its extent."""
    low, high = (take(cuts_of_time[0].polygons, axis=(0, 1))
                 for take in (np.min, np.max))
    size = (high - low).max() / RASTER
    n = np.ceil((high - low) / size).astype(int)
    values = []
    for run, cut in zip(pair.runs, cuts_of_time):
        part = _inside(run, cut)
        image = np.full((n[1], n[0]), np.nan)
        # Places in the box around each polygon, which are small and convex.
        for polygon, value in zip(cut.polygons[part],
                                  cut.values["pressure"][part]):
            first = np.floor((polygon.min(axis=0) - low) / size).astype(int)
            last = np.ceil((polygon.max(axis=0) - low) / size).astype(int)
            first, last = np.maximum(first, 0), np.minimum(last, n)
            image[first[1]:last[1], first[0]:last[0]] = value
        values.append(image)
    return values, (low[0], high[0], low[1], high[1])


def energy(pair):
    first, second = (dict(head_report.ledger(run)) for run in pair.runs)
    rows = [(name, *(page.quantity(float(ledger[name][-1]), "J", 4)
                     if name in ledger else "–" for ledger in (first, second)))
            for name in first | second]
    return [
        page.table(("energy of the whole head at the end", *pair.names), rows,
                   numbers=(1, 2)),
        accuracy.cost_table([
            accuracy.cost_row(name, {}, run)
            for name, run in zip(pair.names, pair.runs)])]
