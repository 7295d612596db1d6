# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The sections of the report on a head that hits a plane."""

import os
import re

import numpy as np

from plot.readers import files, stage
from plot.figures import head_figures
from plot.report import (accuracy, head_paper, injury_table, injury_thresholds,
                         page)

# Entries of the parameter file that say what a region is made of.
CONSTANTS = {
    "tait": (("Density", "kg/m^3"), ("Bulk modulus", "Pa"),
             ("Exponent", "-"), ("Least pressure", "Pa")),
    "elastic": (("Density", "kg/m^3"), ("Young modulus", "Pa"),
                ("Poisson ratio", "-"), ("Kinematics", "")),
    "viscoelastic": (("Density", "kg/m^3"), ("Bulk modulus", "Pa"),
                     ("Shear modulus", "Pa"),
                     ("Long-term shear modulus", "Pa"),
                     ("Relaxation time", "s"), ("Kinematics", "")),
    "tissue": (("Tissue", ""), ("Tissue set", ""), ("Kinematics", ""))}
ROUND_OFF = 1e-9  # of sums of energies, over the largest of them


def build(run, folder):
    """The page; its pictures are left in @p folder as well."""
    revision = run.summary.get("git_revision")
    parts = page.Page(
        "Impact of a head" if run.planes else "Motion of a head",
        f"Contrecoup {run.summary.get('version', '')}"
        + (f" ({revision})" if revision else "") + " · head_impact")
    judged = judge(run)
    parts.open_with(answer(run, judged), warnings({"": run}))
    for name, content in (
            ("The head and its wall", scene(run)), ("Cuts", cuts(run, folder)),
            ("Contact and rebound", run.planes and contact(run, folder)),
            ("Pressure and strain over time", histories(run, folder)),
            ("Energy", energy(run, folder)), ("Injury", injury(run, judged)),
            ("Against the paper",
             run.is_published() and head_paper.section(run)),
            ("Parameters and assumptions", assumptions(run)),
            ("Cost", [accuracy.cost_table(
                [accuracy.cost_row("head_impact", {}, run)])]),
            ("How to reproduce", reproduce(run))):
        if content:
            parts.section(name, *content)
    return parts.render()


def warnings(runs):
    """Warnings of runs, by their names; empty if there are none."""
    told = [(f"{name}: " if name else "") + text for name, run in runs.items()
            for text in run.summary.get("warnings") or []]
    return page.tag("div", page.tag("h3", "Warnings of the run" + (
        "s" if len(runs) > 1 else "")), page.bullets(told),
        kind="doubts") if told else ""


def _carriers(run):
    """Carriers of the values of a run."""
    return "particles" if run.has_particles() else "cells"


def _smoothing(run):
    """How pressures of particles differ from their own, in words."""
    smoothed = run.parameters.get("MPM/Smoothing", "none")
    return "" if not run.has_particles() or smoothed == "none" else (
        ", pressures as the grid averages them over particles nearby "
        f"(MPM/Smoothing = {smoothed})")


def figure(folder, name, drawn, description, caption):
    """A figure of the page, which is a file of the folder as well."""
    content = page.render(drawn, "png")
    path = os.path.join(folder, f"{name}.png")
    with open(path, "wb") as file:
        file.write(content)
    print(path)
    return page.figure(content, description, caption)


def _symmetry(run):
    """Computed part of the head, in words."""
    if run.wedge_axis != "none":
        return f"a wedge of the head about {run.wedge_axis}, one cell thick,"
    return ("the whole head", "half of the head", "a quarter of the head",
            "an eighth of the head")[len(run.mirrors)]


def probe_names(run):
    """Where the probes are, in millimetres."""
    return ["({})".format(", ".join(f"{1e3 * x + 0.:g}" for x in point)
                          .replace("-", "−")) + " mm"
            for point in files.points_of(run.parameters.get("Probes/Points"))]


def extreme(run, quantity, layer, take):
    """The extremum of a column and when it is reached."""
    return _at(run, run.column(quantity, layer), take)


def _at(run, column, take):
    index = int(take(column))
    return float(column[index]), float(run.history["time"][index])


def _reached(run, quantity, layer, take):
    """An extreme pressure and when it is reached, in words."""
    value, when = extreme(run, quantity, layer, take)
    return page.quantity(value, "Pa") + (
        " so far" if run.is_so_far(when) else "") \
        + f" ({page.milliseconds(when)})"


def largest_force(run):
    """The largest mean over 50 µs, of the whole head, and when: of all steps, or
    of the rows of the history where the summary has that of a step alone."""
    if run.contact("peak_contact_force_of_step") is not None:
        return (run.contact("peak_contact_force"),
                run.contact("peak_contact_force_time"))
    return _at(run, head_figures.smoothed(run, run.history["contact_force"]),
               np.argmax)


def answer(run, judged):
    """Events of the run, in a few plain sentences."""
    text = [f"A head of {page.quantity(run.history['mass'][0], 'kg')}"]
    if run.planes:
        text[0] += f" hits a rigid plane at {_impact_speed(run)}."
        rebound, end = run.rebound(), run.last_contact()
        force, when = largest_force(run)
        text.append(
            f"The plane pushes with {page.quantity(force, 'N')} at most"
            + (" so far" if run.is_cut_off() else "")
            + f" (mean over {page.quantity(head_figures.SPAN, 's')}), after "
            f"{page.milliseconds(when)}; " + (
                "the head does not rebound until the end of the run"
                if rebound is None else
                f"the head rebounds at {page.milliseconds(rebound)}")
            + (f" and has left the plane at {page.milliseconds(end)}."
               if end is not None else
               ", and touches the plane when the run ends."
               if run.is_cut_off() else "."))
    else:
        text[0] += " moves; there is no plane."
    for layer, name in (("csf", "The CSF's pressure"),
                        ("brain", "The brain's")):
        if run.region(layer):
            text.append(
                f"{name} in single {_carriers(run)} reaches from "
                f"{_reached(run, 'least_pressure', layer, np.argmin)} to "
                f"{_reached(run, 'largest_pressure', layer, np.argmax)}.")
    strain = injury_table.find(judged, "injury_strain_95")
    if strain is not None:
        text.append("95\u00a0% of the brain is strained by less than " + (
            f"{strain.shown(strain.value)}, which is {strain.compared()}"
            if strain.is_own and not strain.is_open else
            f"{page.number(100. * strain.value)}\u00a0%"
            + (f", which means: {strain.meaning()}" if strain.meaning()
               else "")) + (" up to the end of the run, where strains may still grow"
                            if strain.is_cut else "") + ".")
    hic = injury_table.find(judged, "injury_hic15")
    if hic is not None:
        text.append(f"HIC15 is {'at least ' if hic.is_cut else ''}"
                    f"{page.number(hic.value)}"
                    + ("." if hic.is_open else
                       f", {hic.reached()}." if hic.meaning() or hic.is_own
                       else ", below all limits."))
    beyond = [f"{entry.short_title()} ({entry.shown()}: {entry.meaning()})"
              for entry in judged if entry not in (strain, hic)
              and entry.has_verdict and entry.exceeded()]
    if beyond:
        text.append(f"Beyond thresholds: {page.joined(beyond)}.")
    end = float(run.history["time"][-1])
    text += injury_table.cut_off(judged, "Time/End time", end)
    return page.tag(
        "div", page.paragraph(" ".join(text)), page.paragraph(
            f"The run ends after {page.milliseconds(end)}. Largest and least "
            f"values are those of single {_carriers(run)}{_smoothing(run)}, of "
            f"all steps{_row_times(run)}; the error that the mesh makes has "
            "not been estimated."),
        kind="answer")


def _row_times(run):
    """That rows of history.csv have the extremes since the row before, in
    words."""
    every = (run.parameter("Output/History every steps") or [1.])[0]
    return f", told at the next row of history.csv, one of {every:g} steps" \
        if every > 1. else ""


def _impact_speed(run):
    """Speed at the start, and the part of it towards the plane where that is
    less."""
    speed = np.linalg.norm(run.momentum()[0]) / run.history["mass"][0]
    normal = -run.normal_velocity()[0]
    return page.quantity(speed, "m/s") + (
        "" if normal > 0.999 * speed else
        f", of which {page.quantity(normal, 'm/s')} are towards the plane")


def scene(run):
    """Layers and plane."""
    rows = []
    for name in run.regions:
        material = run.parameters.get(f"Region {name}/Material", "")
        constants = []
        for entry, unit in CONSTANTS.get(material, (("Density", "kg/m^3"),)):
            value = run.parameters.get(f"Region {name}/{entry}")
            number = run.parameter(f"Region {name}/{entry}")
            if value:
                constants.append(f"{entry}: " + (
                    page.plain(number[0], unit).replace("^3", "³")
                    if number else value))
        rows.append((name, _thickness(run, name), material,
                     "; ".join(constants)))
    parts = [page.table(("layer", "size", "material", "constants"), rows,
                        widths=(12, 30, 14, 44)),
             page.paragraph(
                 f"{_symmetry(run).capitalize()} is computed"
                 + (": planes of symmetry, "
                    + ("lower sides of the mesh" if run.is_file() else
                       "through its centre") + ", are normal to "
                    + " and ".join("xyz"[axis] for axis in run.mirrors)
                    + ". Forces, areas, masses and energies are those of the "
                    "whole head; pictures show both sides."
                    if run.mirrors else "."))]
    for plane in run.planes:
        point, normal = (", ".join(map(page.number, vector))
                         for vector in (plane.point, plane.normal))
        parts.append(page.paragraph(
            f"Rigid plane “{plane.name}” through ({point}) m with normal "
            f"({normal}), " + (
                f"coefficient of friction {page.number(plane.friction)}."
                if plane.friction > 0. else "without friction.")))
    if len(run.planes) > 1:
        parts.append(page.paragraph(
            "Force, area and work are those of all planes together; velocities "
            f"are along the normal of “{run.planes[0].name}”."))
    return parts


def _thickness(run, name):
    """The size of a region's layer, or what it is of a file."""
    layer = run.layer_of[name]
    if run.is_file():
        known = run.parameters.get(f"Region {name}/Layer") or name
        return f"“{known}” of the file"
    if layer == "brain":
        axes = run.parameter("Mesh/Semi-axes") or []
        return f"semi-axes {', '.join(f'{1e3 * axis:g}' for axis in axes)} mm"
    for entry in ("CSF", "Skull", "Scalp"):
        thickness = run.parameter(f"Mesh/{entry} thickness")
        if entry.lower() == layer and thickness:
            cells = run.found("checks", f"cells_across_{layer}")
            return f"{1e3 * thickness[0]:g} mm thick" + (
                f", {float(f'{cells:.3g}'):g} cell{'s' * (cells != 1.)}"
                + (" of the grid" if run.has_particles() else "")
                + " across" if cells is not None else "")
    return "–"


def cuts(run, folder):
    """Pressure, shear strain and flow in the plane of the impact."""
    found = [run.cut(entry) for entry in run.picked()]
    if not found:
        return [page.missing("fields after the start; Output/Fields interval "
                             "says how often they are written")]
    through = "xyz"[run.cut_axes()[0]]
    times = page.moments([cut.time for cut in found])
    where = ("through the middle of the mesh" if run.is_file() else
             "through the head's centre") + f", normal to {through}"
    solids = [name for name in run.regions if run.is_solid(name)]
    hard = [name for name in solids if name != "brain"]
    parts = [figure(
        folder, "head_pressure", head_figures.draw_pressure(run, found),
        f"The head cut along its middle above the wall, coloured by the "
        f"pressure after {times}.",
        f"Pressure in a cut {where}, one scale for all times with square-root "
        "colours: red is compression, blue tension. The scale is that of brain "
        "and CSF" + (f", which the pressure of {page.joined(hard)} goes beyond"
                     if hard else "") + ". "
        + choice(run, [cut.time for cut in found]))]
    if solids:
        parts.append(figure(
            folder, "head_shear_strain", head_figures.draw_shear(run, found),
            "The head cut along its middle, coloured by the shear strain of "
            f"its solids after {times}.",
            f"Largest engineering shear strain of {page.joined(solids)} in the "
            "same cut, one scale for all times with square-root colours; the CSF "
            "bears no shear and is pale."))
    if run.region("csf"):
        flow = run.picked_flow(found)
        parts.append(figure(
            folder, "head_speed", head_figures.draw_speed(run, flow),
            "The ring of CSF in the head's cut, coloured by its speed with "
            "arrows along its velocity after "
            f"{page.moments([cut.time for cut in flow])}.",
            "Speed of the CSF with arrows" + (
                ", as it is (left) and less the skull's motion as a rigid body, "
                "translation and rotation (right), which shows how it flows "
                "around the brain. Arrows and colours have one scale on either "
                "side." if run.region("skull") else ".")))
    return parts


def choice(run, times):
    """Which outputs cuts show at times, as a sentence; "" where nothing is
    hit."""
    states, found = run.states(), run.outputs_of_states()
    others = [time for time in times if time not in found]
    told = [f"{page.milliseconds(time)} to " + page.joined(
        f"{name} ({page.milliseconds(states[name])})" for name in names)
            for time, names in sorted(found.items()) if names and time in times]
    if not told and not run.is_published():
        return ""
    return ("Times are those of the published pictures, as far as there are "
            "outputs" if run.is_published() else
            "Times are those of outputs that are the nearest to states of the "
            "impact from the first contact on: " + "; ".join(told)) + (
        "" if not others else f"; {page.moments(others)} "
        + ("are" if len(others) > 1 else "is") + " shown beside these"
        ) + "."


def contact(run, folder):
    """Force, area and momentum."""
    force, when = largest_force(run)
    velocity = run.normal_velocity()
    rebound, end = ("not until the end" if time is None else
                    page.milliseconds(time)
                    for time in (run.rebound(), run.last_contact()))
    rows = []
    limit = "≥ " if run.is_cut_off() else ""
    largest, at = (run.contact(f"peak_contact_force_of_step{part}")
                   for part in ("", "_time"))
    # Not all summaries have it.
    of_step = [] if largest is None else [
        ("largest contact force of a single step",
         limit + page.quantity(largest, "N"), page.milliseconds(at))]
    if run.contact("contact_begin") is not None:
        rows = [
            ("contact begins", "–",
             page.milliseconds(run.contact("contact_begin"))),
            ("largest contact force, mean over "
             + page.quantity(head_figures.SPAN, 's'),
             limit + page.quantity(force, "N"), page.milliseconds(when)),
            *of_step,
            ("largest contact area", limit + page.number(
                1e4 * run.contact("peak_contact_area")) + " cm²",
             "–"),
            ("impulse of the contact force", limit + page.quantity(
                run.contact("contact_impulse"), "N s"), "–")]
    rows += [
        ("velocity towards the plane at the start",
         page.quantity(-float(velocity[0]), "m/s"), page.milliseconds(0.)),
        ("momentum along the normal changes its sign", "–", rebound),
        ("contact ends", "–", end),
        ("velocity from the plane at the end",
         page.quantity(float(velocity[-1]), "m/s"),
         page.milliseconds(float(run.history["time"][-1])))]
    return [
        page.table(("what", "whole head", "when"), rows, numbers=(1, 2)),
        figure(folder, "contact", head_figures.draw_contact(run),
               "Two curves over time: the force between head and wall, and "
               "the area in contact.",
               "Contact force and area of the whole head, from history.csv. "
               "Nodes reach and leave the plane one by one, hence the steps "
               "of the area. Each gives up its momentum within a single step, "
               "whose force grows as steps get smaller; the head feels the "
               "mean."),
        figure(folder, "momentum", head_figures.draw_velocity(run),
               "Curves of mean velocity along the plane's normal over time, "
               "of the whole head and its solid layers.",
               "Momentum along the plane's normal over mass, of the whole "
               "head and of its solid layers: the head rebounds where it "
               "changes its sign.")]


def histories(run, folder):
    """Extrema of the layers, and probes."""
    parts = []
    if run.region("csf") or run.region("brain"):
        parts.append(figure(
            folder, "pressures", head_figures.draw_pressures(run),
            "Curves of the largest and the least pressure over time in CSF "
            "and brain.",
            f"Largest and least pressure of all {_carriers(run)} of CSF and "
            "brain over time, from history.csv."))
    parts.append(figure(
        folder, "shear_strain", head_figures.draw_strains(run),
        "Curves over time of the largest shear strain of each solid layer, "
        "and of the largest speed of the CSF.",
        "Largest shear strain of the solid layers, and largest speed of the "
        "CSF over time, from history.csv."))
    parts.append(_extrema(run))
    names = probe_names(run)
    if run.probes is None or not names:
        return parts
    rows = []
    for number, name in enumerate(names, 1):
        column = run.probes[f"pressure_{number}"]
        rows.append((name, *(text for index in (column.argmax(), column.argmin())
                             for text in (
            page.quantity(column[index], "Pa"),
            page.milliseconds(run.probes["time"][index])))))
    return parts + [
        figure(folder, "head_probes", head_figures.draw_probes(run, names),
               f"Curves of pressure over time in {len(names)} {_carriers(run)}.",
               f"Pressure in the {_carriers(run)} that were "
               + ("nearest to" if run.has_particles() else "at")
               + " these places at the start, in every step, from probes.csv."),
        page.table(("probe", "highest pressure", "when it is highest",
                    "lowest pressure", "when it is lowest"), rows,
                   numbers=(1, 2, 3, 4))]


def _extrema(run):
    """Each extremum of the layers with its time."""
    rows = []
    for name in run.regions:
        for quantity, take, unit in (
                ("least_pressure", np.argmin, "Pa"),
                ("largest_pressure", np.argmax, "Pa"),
                ("largest_shear_strain", np.argmax, "%"),
                ("largest_speed", np.argmax, "m/s"),
                ("void_volume", np.argmax, "m^3")):
            column = f"{quantity}_{name}"
            if column not in run.history:
                continue
            value, when = _at(run, run.history[column], take)
            shown = page.percent(value, 3) if unit == "%" else page.Rounded(
                page.number(1e6 * value) + " cm³", value, unit) \
                if unit == "m^3" else page.quantity(value, unit)
            if run.is_so_far(when):
                shown = page.limit(shown)
            rows.append((
                name, "largest void of the whole layer" if unit == "m^3"
                else quantity.replace("_", " "), shown,
                page.milliseconds(when)))
    return page.table(("layer", "what", "value", "when"), rows,
                      "≥ and ≤: not the extreme of the whole impact, as it is "
                      "at the end of the run or the contact lasts then."
                      if any(row[2].startswith(("≥", "≤")) for row in rows)
                      else "", numbers=(2, 3))


def work_label(run):
    """Sources of the external work of history.csv, in words."""
    return "work of planes" + (
        ", body forces and slipping interfaces" if "slip_work" in run.history
        else " and body forces")


def work_parts(run):
    """Names and columns of what the external work consists of, which is their
    sum; [] without planes and slip [J]."""
    history = run.history
    along = "thereof planes, along their normals"
    parts = [(label, history[name]) for name, label in (
        ("contact_work", along), ("friction_work", "thereof friction"),
        ("slip_work", "thereof slipping interfaces")) if name in history]
    work = history["external_work"]
    rest = work - sum(column for _, column in parts)
    if parts and np.abs(rest).max() > ROUND_OFF * np.abs(work).max():
        parts.insert(0, (
            "thereof body forces" if "contact_work" in history or
            not run.planes else along + (
                ", and body forces" if has_body_force(run) else ""), rest))
    return parts


def has_body_force(run):
    return any((run.parameter(f"Body force/{axis}") or [np.nan])[0] != 0.
               for axis in "xyz")


def ledger(run):
    """Names and columns of the energies of the whole head [J]."""
    history = run.history
    found = [("kinetic", history["kinetic_energy"]),
             ("internal", history["internal_energy"]),
             ("both", history["kinetic_energy"] + history["internal_energy"]),
             (work_label(run), history["external_work"])]
    return found + work_parts(run) + [
        (label, history[name]) for name, label in (
            ("interface_work", "made up between fluid and solid"),
            ("stored_energy", "stored energy"),
            ("transfer_loss", "transfer loss"),
            ("contact_loss", "contact loss")) if name in history] + [
        ("missing", history["energy_residual"])]


def false_energies(run):
    """Energies that the numerics of particles add or take, in a sentence."""
    history = run.history
    largest = np.maximum(history["kinetic_energy"],
                         np.abs(history["internal_energy"])).max()
    if not largest > 0.:
        return ""
    given = (history["stored_energy"] - history["internal_energy"]).max()
    words = [f"{page.percent(given / largest, 2)} were given back by the matter "
             "beyond what it had stored"] if given > 0. else []
    if "friction_work" in history and not has_body_force(run):
        work = np.abs(history["external_work"] - history["friction_work"]).max()
        if work > 0.:
            words.append(f"{page.percent(work / largest, 2)} are work of planes "
                         "at rest other than by friction")
    return ("Of the largest energy, " + page.joined(words) + ", at most, which "
            "are errors of the numerics that smaller cells of the grid reduce."
            ) if words else ""


def energy(run, folder):
    """The ledger as a table and a picture."""
    known, moments = ledger(run), {"at the start": 0}
    if run.planes and run.rebound() is not None:
        moments["at the rebound"] = np.searchsorted(run.history["time"],
                                                    run.rebound())
    moments["at the end"] = -1
    rows = [(name, *(page.quantity(float(column[index]), "J", 4)
                     for index in moments.values())) for name, column in known]
    residual = run.found("checks", "energy_residual")
    parts = [] if residual is None else [page.paragraph(
        "What is missing in the ledger is "
        + (f"{page.number(abs(residual), 2)} of the energy" if residual
           else "nothing") + ": the sum of kinetic and internal energy "
        f"changes by the {work_label(run)}"
        + (" and what is made up between fluid and solid"
           if "interface_work" in run.history else "")
        + (", less transfer loss and contact loss" if run.has_particles()
           else "") + ", to round-off. "
        + ("Internal energy is the work that stresses did on the matter, "
           "stored energy what the matter can give back of it. Transfer loss "
           "is kinetic energy that is lost between particles and grid, contact "
           "loss that where velocity fields meet. " + false_energies(run)
           if run.has_particles() else
           "Energy of hourglass control and artificial viscosity is "
           "internal."))]
    return parts + [
        page.table(("energy of the whole head", *moments), rows,
                   numbers=range(1, 1 + len(moments))),
        figure(folder, "energy", head_figures.draw_energy(run, known),
               "Curves of kinetic and internal energy, their sum, and the "
               "work of planes over time.",
               "Energy of the whole head over time, from history.csv.")]


def judge(run):
    """Measures of injury.csv next to their thresholds."""
    all_known = injury_thresholds.known_by(run.parameters)
    return [injury_table.Judged(
        name, measure.value, measure.unit,
        # Thresholds found for blunt impacts are no mere exposure here.
        injury_table.of_file(name, measure, all_known)._replace(
            is_exposure=False), None, "", is_cut=measure.is_cut)
            for name, measure in measures(run).items()
            if name not in injury_thresholds.OF_CURVES]


def measures(run):
    """Contents of injury.csv."""
    return stage.read_measures(run.path("injury.csv"))


def injury(run, judged):
    """The injury table."""
    if not judged:
        return [page.missing(
            "injury.csv: no solid region is what Injury/Brain or Injury/Skull "
            "name, or the run was not finished")]
    every = (run.parameter("Injury/Every steps") or [1.])[0]
    # Those of particles are averages where the grid smooths them.
    averaged = ", pressures averaged over neighbouring ones," if run.parameters.get(
        "Injury/Pressure") == "averaged" and (
        not run.has_particles() or _smoothing(run)) else ""
    told = (f"Of the brain's {_carriers(run)}{averaged} and the skull's "
            "mean motion, " + (f"in one of {every:g} steps, " if every > 1.
                               else "") + "from injury.csv.")
    if run.mirrors:
        told += (f" What is computed, {_symmetry(run).rstrip(',')}, has the "
                 "measures of the whole head: parts of the brain are the same "
                 "on all sides of a plane of symmetry, the skull moves along "
                 "it and turns about its normal, with two planes not at all.")
    if run.has_particles():
        told += (" Next to a wall that the head touches, pressures by particles "
                 "alternate from cell to cell: those of thin layers are to be "
                 "read as means over two cells.")
    return [injury_table.table_of(judged), page.paragraph(
        told + " Thresholds are given as they are commonly cited.",
        kind="note")]


def assumptions(run):
    """The plan and its audit, and the numbers of the run."""
    rows = mesh_settings(run)
    rows.append(("rows of history.csv", page.count(len(run.history["time"]))))
    rows += [(f"least pressure of {name}",
              run.parameters.get(f"Region {name}/Least pressure", "none"))
             for name in run.regions
             if run.parameters.get(f"Region {name}/Material") == "tait"]
    for name in run.summary.get("checks") or {}:
        value = run.found("checks", name)
        if value is not None:
            rows.append((re.sub(r"\bcsf\b", "CSF", name.replace("_", " ")),
                         f"{float(f'{value:.3g}'):g}"
                         if name.startswith("cells_across") else
                         page.number(value)))
    return [
        *filter(None, [accuracy.audit_table(run)]),
        page.table(("what", "value"), rows, numbers=(1,)), page.paragraph(
            "The head has neither neck nor membranes nor vessels, its layers "
            + ("slip along each other without parting" if slips(run) else
               "are bonded") + ", planes are rigid, and nothing breaks, however "
            "large its strain: beyond that of the first fracture, forces and "
            "accelerations are those of an unbroken skull.")]


def mesh_settings(run):
    """How the head is discretised."""
    if run.has_particles():
        return [("particles in all", page.count(run.summary.get("cells") or 0)),
                ("cell size of the grid",
                 page.quantity((run.parameter("MPM/Cell size") or [0.])[0],
                               "m"))] + [
            (name.lower(), run.parameters.get(f"MPM/{name}", "–"))
            for name in ("Basis", "Transfer", "Update", "Series order",
                         "Smoothing", "Fields")]
    return [
        ("cells in all", page.count(run.summary.get("cells") or 0)),
        ("file", os.path.basename(run.parameters.get("Mesh/File", "–")))
        if run.is_file() else (
            "cell size at the brain's surface, about",
            page.quantity((run.parameter("Mesh/Cell size") or [0.])[0], "m")),
        ("smoothing of the fluid's mesh",
         run.parameters.get("Rezone/Kind", "–")),
        ("its interval", page.quantity(
            (run.parameter("Rezone/Interval") or [np.nan])[0], "s"))]


def slips(run):
    """Whether layers slip along each other."""
    fields = run.parameters.get("MPM/Fields", "") if run.has_particles() \
        else "by interface"
    return fields == "slip" or fields == "by interface" and any(
        run.parameters.get(f"Region {name}/Interface") == "slip"
        for name in run.regions)


def reproduce(run):
    """The parameter file as used."""
    tables = [name for name in ("history.csv", "probes.csv", "injury.csv")
              if os.path.exists(run.path(name))]
    return [page.paragraph(
        f"Ranks: {run.summary.get('ranks', '–')}. Tables next to this page: "
        f"{', '.join(tables)}; pictures in the folder pictures."),
            page.folded_file("parameters.prm: every entry as used",
                             files.read_text(run.path("parameters.prm")))]
