# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The published impact of a simplified head on a rigid wall, statement by
statement, next to what a run finds: X. G. Tan, R. N. Saunders, A. Bagchi,
COUPLED PROBLEMS 2017, section 3.4."""

import numpy as np

from plot.figures import head_figures
from plot.report import page, paper
from plot.report.paper import (AGREES, DIFFERS, OPEN, PARTLY, Statement,
                               verdict)

CLOSE = 0.1    # what agrees may differ by
SIMILAR = 2.   # what agrees in part may differ by this factor
NO_SIZES = ("the paper gives neither size, thickness, mass nor stiffness of "
            "its head, on which this depends")


def section(run):
    """The table of all statements."""
    statements = (_set_up(run) + _rebound(run) + _pressure(run) + _shear(run)
                  + _flow(run))
    return [
        page.paragraph(
            "Section 3.4 of " + paper.SOURCE + ", lets a simplified "
            "head hit a rigid wall. The paper gives no dimensions of its head, "
            "no masses and no constants of its skull: what depends on these "
            "cannot agree but by a choice of them, and this section is no "
            "verification. " + paper.counted(statements, "section 3.4")
            + f" Numbers agree within {100. * CLOSE:.0f} %, in part within "
            f"a factor of {SIMILAR:.0f}."),
        paper.table(statements)]


def _judge(found, published):
    ratio = np.nan if found is None else found / published
    return verdict(abs(ratio - 1.) <= CLOSE, 1. / SIMILAR <= ratio <= SIMILAR)


def _ends_before(run, time):
    return run.history["time"][-1] < 0.999 * time


def _too_short(quote, run):
    return Statement(quote, "the run ends after "
                     f"{page.milliseconds(run.history['time'][-1])}", OPEN)


def _set_up(run):
    speed = -float(run.normal_velocity()[0])
    found = [Statement(
        "initial velocity of 3m/s … colliding with a rigid wall",
        f"{page.quantity(speed, 'm/s')} towards the plane", _judge(speed, 3.),
        "the run is of another impact")]
    interval = run.parameter("Rezone/Interval")
    if run.parameters.get("Rezone/Kind") == "none" or not interval:
        return found
    return found + [Statement(
        "the time interval for remeshing and advection is 20 micro-sec",
        f"every {page.quantity(interval[0], 's')}", _judge(interval[0], 2e-5),
        "another interval was asked for")]


def _rebound(run):
    quote = "At 4.36 ms, the head starts to rebound"
    rebound = run.rebound()
    if rebound is None and _ends_before(run, 4.36e-3):
        return [_too_short(quote, run)]
    judged, reason = _judge(rebound, 4.36e-3), NO_SIZES
    end = run.last_contact()
    found = "the head does not rebound" if rebound is None else \
        f"its momentum changes sign at {page.milliseconds(rebound)}"
    if end is not None:
        found += f", and it has left the wall at {page.milliseconds(end)}"
        if judged != AGREES and _judge(end, 4.36e-3) == AGREES:
            judged, reason = PARTLY, (
                "it agrees if the paper means that the head leaves the wall; "
                "it does not say by what it tells a rebound")
    return [Statement(quote, found, judged, reason)]


def _pressure(run):
    time = run.history["time"]
    csf = run.column("least_pressure", "csf")
    both = np.minimum(csf, run.column("least_pressure", "brain"))
    low = int(np.argmin(csf))
    quote = "the maximum negative pressure in CSF is -236KPa"
    if _ends_before(run, 0.92e-3):
        found = [_too_short(quote, run)]
    else:
        found = [
            Statement(quote, page.quantity(csf[low], "Pa"),
                      _judge(csf[low], -236e3), NO_SIZES),
            Statement("and occurs at 0.92 ms",
                      f"at {page.milliseconds(time[low])}",
                      _judge(time[low], 0.92e-3), NO_SIZES)]
    quote = ("After 2.18 ms, the pressure in the brain and CSF stays in "
             "positive because of the compressed intracranial volume")
    if _ends_before(run, 2.18e-3):
        return found + [_too_short(quote, run)]
    negative = np.flatnonzero(both < 0.)
    if not negative.size or negative[-1] < len(time) - 1:
        since = float(time[negative[-1] + 1]) if negative.size else 0.
        return found + [Statement(
            quote, f"from {page.milliseconds(since)} on",
            verdict(since <= 2.18e-3 * (1. + CLOSE), in_part=True), NO_SIZES)]
    return found + [Statement(
        quote, f"still {page.quantity(float(both[-1]), 'Pa')} somewhere at the "
        "end", DIFFERS, "a head that has left the wall oscillates; "
        + NO_SIZES)]


def _shear(run):
    late, early = (run.history["time"][np.argmax(run.column(name, "brain"))]
                   for name in ("largest_shear_strain", "largest_pressure"))
    found = [Statement(
        "Compared to the pressure, the shear strains … are developed at the "
        "later time", "in the brain the largest shear strain is reached at "
        f"{page.milliseconds(late)}, the largest pressure at "
        f"{page.milliseconds(early)}", verdict(late > early),
        "see the histories")]
    places = interface_strains(run)
    if places is None:
        return found
    beside, within, is_beside = places
    return found + [Statement(
        "The maximum shear occurs at the CFS-skull and CSF-brain interfaces",
        "when shear is largest among the outputs, the mean shear strain is "
        f"{page.number(100. * beside)} % in the brain's cells at the CSF, "
        f"{page.number(100. * within)} % in all others; the brain's largest "
        f"one is {'at' if is_beside else 'not at'} the CSF",
        verdict(is_beside and beside > within, is_beside or beside > within),
        "" if is_beside else "brain and CSF share nodes here, and the contact "
        "bends the skull into the brain")]


def interface_strains(run):
    """Mean shear strain in the brain's cells at the CSF, that in all others,
    and whether the largest is at the CSF, of the output with the largest one;
    None without outputs."""
    largest = None
    for entry in run.picked():
        cells = run.arrays(entry[1])
        values = {name: cells[name][:, 0, 0]
                  for name in ("region", "shear_strain")}
        brain = head_figures.of_layers(run, values, ("brain",))
        strain = values["shear_strain"][brain]
        if largest is None or strain.max() > largest[0]:
            fluid = cells["points"][head_figures.of_layers(
                run, values, ("csf",))]
            shared = (_near if run.has_particles() else _nodes_shared)(
                cells["points"][brain], fluid, run.spacing())
            largest = strain.max(), strain, shared
    if largest is None or largest[2].all() or not largest[2].any():
        return None
    _, strain, shared = largest
    return (float(strain[shared].mean()), float(strain[~shared].mean()),
            bool(shared[np.argmax(strain)]))


def _near(points, others, spacing):
    """Whether particles have one of others in a box of two spacings around, or
    in one of those next to it."""
    def boxes(places):
        return np.floor(places.reshape(-1, 3) / (2. * spacing)).astype(int)

    steps = np.stack(np.meshgrid(*[(-1, 0, 1)] * 3), axis=-1).reshape(-1, 3)
    known = {tuple(box) for step in steps
             for box in np.unique(boxes(others), axis=0) + step}
    return np.array([tuple(box) in known for box in boxes(points)])


def _nodes_shared(cells, others, _):
    """Whether cells have a corner in common with others: where it is, to the
    last bit, as each cell writes its own corners."""
    known = {corner.tobytes() for corner in others.reshape(-1, 3)}
    return np.array([corner.tobytes() in known for corner in
                     cells.reshape(-1, 3)]).reshape(-1, 8).any(axis=1)


def _flow(run):
    speed = run.column("largest_speed", "csf").max()
    ratio = speed / abs(run.normal_velocity()[0])
    found = [Statement(
        "the flow speed in CSF is in the same level of initial impact speed",
        f"at most {page.quantity(speed, 'm/s')}, "
        f"{page.number(ratio)} of the initial speed",
        verdict(0.5 <= ratio <= 2.), NO_SIZES)]
    quote = "At the end of 5ms, the CSF flows upward"
    if _ends_before(run, 5e-3) or not run.picked():
        return found + [_too_short(quote, run)]
    # The mean of cells, as many as they are, in the last output.
    cells = run.arrays(run.fields()[-1][1])
    part = head_figures.of_layers(run, {"region": cells["region"][:, 0, 0]},
                                  ("csf",))
    mean = cells["velocity"][part].mean(axis=(0, 1))
    mean[run.mirrors] = 0.
    velocity = float(mean @ run.planes[0].normal)
    return found + [Statement(
        quote, f"its mean velocity is {page.quantity(abs(velocity), 'm/s')} "
        + ("away from the wall" if velocity > 0. else "towards the wall"),
        verdict(velocity > 0.), NO_SIZES)]
