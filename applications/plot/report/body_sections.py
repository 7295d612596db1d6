# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The inside of the body: stress waves, histories in the tissue, energy,
mesh."""

import os
import statistics

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from plot.readers import fields, files
from plot.analysis import person, signals, tissue_places, wave_times
from plot.figures import body_cuts, style
from plot.report import error_estimate, page
from plot.report.energy_audit import EnergyAudit

OFF = 1e-4  # of cuts from the plane of symmetry, where elements have faces [m]
HEAD_ALONE = 0.4  # m, least height of what is more than a head
# Extremes of each element over the run: fields, titles, units, and whether
# they have two signs.
PEAKS = (("highest_pressure", "maximum pressure", "Pa", True),
         ("lowest_pressure", "minimum pressure", "Pa", True),
         ("largest_von_mises_stress", "largest von Mises stress", "Pa", False),
         ("largest_principal_strain", "largest principal strain", "-", False))
# The first three are what the others add up to.
ENERGIES = (("external_work", "work of the loads"),
            ("interface_work", "work of sliding interfaces"),
            ("step_change_energy", "gained as the step size varies"),
            ("kinetic_energy", "kinetic energy"),
            ("stored_energy", "elastic energy"),
            ("relaxation_energy", "lost by relaxation"),
            ("bulk_viscosity_energy", "lost by bulk viscosity"),
            ("hourglass_energy", "hourglass energy"),
            ("hourglass_damping_energy", "lost by hourglass damping"),
            ("pressure_smoothing_energy", "in pressure smoothing"),
            ("contact_energy", "in the contact with the ground"),
            ("energy_residual", "missing energy"))


def waves(scene):
    """Pressure in the sagittal plane at several times."""
    outputs = wave_times.denser(
        wave_times.of_body(scene.field_list(),
                           scene.biomechanics.table("history.csv"),
                           scene.biomechanics.table("probes.csv")),
        wave_times.MOST_FIELDS, 1.5)
    if not outputs:
        return [page.missing("fields of biomechanics")]
    with files.reading(scene.biomechanics.path("fields")):
        frame = _frame(scene, outputs[0][1])
        place = frame.middle + frame.beside()
        is_head = frame.height < HEAD_ALONE
        panels = fields.cut_fields(outputs, frame.middle + OFF, frame.axes)
        whole = page.drawn(body_cuts.draw_pressures, panels, is_head)
        in_middle = _tissues_at(scene, outputs[0][1], frame.middle + OFF,
                                frame.axes)
        head = page.drawn(body_cuts.draw_pressures, panels, True) \
            if "brain" in in_middle and not is_head else None
        panels_beside = fields.cut_fields(outputs, place, frame.axes)
        beside = page.drawn(body_cuts.draw_pressures, panels_beside, is_head)
        tissues = _tissues_at(scene, outputs[0][1], place, frame.axes)
        stiff = " The stiff skeleton stands out." \
            if "skeleton" in in_middle else ""
    times = page.moments([time for time, _ in outputs])
    middle = _middle_plane(frame)
    upright = "" if frame.is_upright() else \
        " The body is drawn with the head up, its front to the right."
    parts = [
        page.figure(whole, "The body cut along its middle, coloured by the "
                    f"pressure in its tissues, {_span(panels)}, after "
                    f"{times}.",
                    f"Pressure in the {middle}, with one colour "
                    "scale for all times: red is compression, blue tension. "
                    "Colours follow the square root of the pressure."
                    + stiff + upright),
        page.figure(beside, f"The body cut {frame.beside():.2g} m beside its "
                    f"middle, coloured by the pressure, {_span(panels_beside)},"
                    f" after {times}.",
                    "Pressure in a parallel plane, "
                    f"{frame.place_in_words(frame.beside())}, "
                    f"through {tissues}, with one colour scale for all "
                    "times.")]
    if head is not None:
        top = _top(scene, frame)
        parts.append(page.figure(
            head, f"The {top} cut along its middle, coloured by the "
            f"pressure after {times}.",
            f"Pressure in the {top}, in the {middle}, with one colour scale "
            "for all times."))
    return parts + [page.paragraph(
        "Pressures are averages over neighbouring elements: in nearly "
        "incompressible tissue, the pressure of single elements oscillates "
        "from one to the next by numerical error.", kind="note"),
        *_peaks(scene, frame, "brain" in in_middle)]


def _frame(scene, pieces):
    """The Frame of the body that an output shows."""
    meshes = scene.field(pieces)
    return person.Frame(
        scene, np.concatenate([mesh["points"] for mesh in meshes]),
        np.concatenate([mesh["points"][mesh["connectivity"].reshape(-1, 8)[
            mesh["tissue"] == tissue_places.BRAIN]].reshape(-1, 3)
                        for mesh in meshes]))


def _middle_plane(frame):
    """The plane of the cuts, by its name in anatomy where it has one."""
    where = frame.place_in_words(0.)
    if not frame.is_person:
        return f"plane {where}"
    return "sagittal plane" + (f" ({where})" if where else "")


def _span(panels):
    """Least and largest pressure of cuts, in words."""
    values = np.concatenate([found for _, _, found in panels])
    return "from " + " to ".join(page.quantity(bound, "Pa", 2)
                                 for bound in signals.extremes(values))


def _tissues_at(scene, pieces, place, axes):
    """Tissues in a plane that cuts are parallel to, in words."""
    numbers = fields.cut_values(pieces, place, "tissue", axes)[1]
    names = tissue_places.names(scene)
    return page.joined(names.get(int(number), tissue_places.OTHER)
                       for number in np.unique(numbers))


def _top(scene, frame):
    """Drawn part of a body with a brain, in words."""
    if scene.facts.get("body") not in ("shape", "mesh"):
        return "head"
    return "top of the body" if frame.height > body_cuts.HEAD else "body"


def _peaks(scene, frame, has_head):
    """Extremes of each element over the run, if recorded, of the head where the
    cut has one."""
    pieces = scene.field_list()[-1][1]
    found = []
    for name, title, unit, is_signed in PEAKS:
        with files.reading(scene.biomechanics.path("fields")):
            cut = fields.cut_values(pieces, frame.middle + OFF, name,
                                    frame.axes)
        if cut is not None:
            found.append((title, unit, is_signed, *cut))
    if not found:
        return []
    averaged = scene.biomechanics.parameters.get("Peaks/Pressure") == "averaged"
    body = _top(scene, frame) if has_head else "body"
    return [page.figure(
        _draw_peaks(found, has_head),
        f"The {body} cut along its middle, coloured by "
        + ", ".join(title for title, *_ in found) + ".",
        f"Extremes of each element of the {body} over the whole run, in the "
        f"{_middle_plane(frame)}. Pressures are " + (
            "averages over neighbouring elements." if averaged else
            "those of single elements, which oscillate from one to the next "
            "by numerical error."))]


def _draw_peaks(found, head_only):
    across, (low, top) = body_cuts.limits([polygons for *_, polygons, _ in
                                           found], head_only)
    height = np.clip(1.9 * (top - low) / (across[1] - across[0]), 2.6, 5.2)
    figure, axes = plt.subplots(1, len(found), squeeze=False,
                                figsize=(2.5 * len(found), height))
    for axis, (title, unit, is_signed, polygons, values) in zip(axes.flat,
                                                                found):
        shown = values[polygons[:, :, 1].max(axis=1) > low]
        largest = float(np.percentile(np.abs(shown), 99.5)) or 1.
        factor, unit = style.scale_unit(unit, largest)
        norm = style.about_zero(largest * factor) if is_signed \
            else Normalize(0., largest * factor)
        axis.add_collection(PolyCollection(
            polygons, array=values * factor, norm=norm, edgecolors="face",
            cmap=style.DIVERGING if is_signed else style.SEQUENTIAL,
            linewidths=0.1))
        axis.set_aspect("equal")
        axis.set_xlim(across)
        axis.set_ylim(low, top)
        axis.set_axis_off()
        axis.set_title(title, fontsize=9)
        figure.colorbar(axis.collections[0], ax=axis, shrink=0.7,
                        extend=style.beyond(shown * factor, norm),
                        label=unit or None)
    return figure


def histories(scene):
    """Pressure and strain over time where probes are."""
    probes = scene.biomechanics.table("probes.csv")
    if not scene.biomechanics.parameters.get("Probes/Points"):
        return [page.paragraph(
            "There are no histories in tissues: no place was named (entry "
            "Biomechanics/Probes/Points).", kind="note")]
    if probes is None:
        return [page.missing("probes.csv of biomechanics")]
    places = tissue_places.find_places(scene)
    groups = [("In the brain", [place for place in places if place.tissue
                                == tissue_places.BRAIN]),
              ("Lungs", [place for place in places if place.tissue
                         == tissue_places.LUNG]),
              ("Elsewhere", [place for place in places if place.tissue not in
                             (tissue_places.BRAIN, tissue_places.LUNG)])]
    groups = [group for group in groups if group[1]]
    if not groups:
        return [page.missing("named probes in Probes/Points of biomechanics")]
    parts = []
    brain = [place for place in groups[0][1]
             if place.tissue == tissue_places.BRAIN]
    if brain:
        parts.append(page.figure(
            _draw_first(scene, probes, brain),
            "Curves of pressure over time, one for each of: "
            + "; ".join(place.title() for place in brain) + ".",
            "Brain pressure in the first 2.5 ms after the wave reaches the "
            "brain. At −100 kPa (dotted) fluid may cavitate; "
            + _cavitation(scene), "svg"))
    parts += [page.figure(
        _draw_histories(probes, groups),
        "Curves of pressure over the whole time at "
        f"{len(places)} places, charts for: "
        + ", ".join(title.lower() for title, _ in groups)
        + "; the extremes are in the table below.",
        "Pressure over time, averaged over the tissue around each place; "
        "compression is positive."
        + (" Coup and contrecoup are at the height of the middle of the brain, on "
           "the side of the charge and opposite, a few elements within its "
           "surface." if brain else ""), "svg")]
    return parts + [_table_of_extremes(scene, places, probes)]


def _table_of_extremes(scene, places, probes):
    """Extremes of pressure at the places with their errors, and what else is
    there."""
    coarser = scene.coarser and scene.coarser.biomechanics.table("probes.csv")
    extremes = [signals.extremes(place.pressure(probes)) for place in places]
    others = [(None, None) if coarser is None or not place.is_in(coarser)
              else signals.extremes(place.pressure(coarser)) for place in places]
    errors = [_errors(scene, *one) for one in zip(zip(*extremes), zip(*others))]
    shown, data = [], []
    for place, (lowest, highest), low_error, high_error in zip(
            places, extremes, *errors):
        shift = np.sqrt(sum(probes[f"{place.column}displacement_{axis}"] ** 2
                            for axis in "xyz"))
        falls, rises = signals.goes_on(place.pressure(probes))
        pressures = [page.limit(page.number(1e-3 * highest), rises),
                     page.limit(page.number(1e-3 * lowest), falls)]
        points = [page.point([round(x, digits) + 0. for x in place.point])
                  for digits in (2, 3)]
        end = [page.limit(page.number(scale * float(values.max())),
                          signals.goes_on(values)[1])
               for scale, values in (
                   (1e-3, probes[place.column + "von_mises_stress"]),
                   (100., probes[place.column + "principal_strain"]),
                   (1e3, shift))]
        shown.append((place.title(), points[0], *(
            page.Markup().join((value, page.Markup("<br>"),
                                page.tag("small", error)))
            for value, error in zip(pressures, (high_error, low_error))), *end))
        data.append((place.title(), points[1], pressures[0], high_error,
                     pressures[1], low_error, *end))
    rest = ("von Mises stress [kPa]", "largest strain [%]", "displacement [mm]")
    return page.table(
        ("place", "x, y, z [m]", "maximum pressure [kPa]",
         "minimum pressure [kPa]", *rest), shown,
        "Extremes over the run; ≥ and ≤: at its end, so that they may go on. "
        "Pressures are averaged over the elements of "
        "the same tissue around each place; stress and strain are of single "
        "elements. " + ("Errors are from the coarser run, each at least "
                        "the median over all places."
                        if coarser is not None else
                        "The numerical error is unknown.")
        + tissue_places.thin_note([place.title() for place in places]),
        numbers=range(1, 7), data=(
            ("place", "x, y, z [m]", "maximum pressure [kPa]",
             "error of the maximum", "minimum pressure [kPa]",
             "error of the minimum", *rest), data))


def _errors(scene, values, coarser):
    """Estimated errors of values at several places, each at least the median, as
    those of gauges; "unknown" where the coarser run has none."""
    found = [None if other is None else
             error_estimate.of(scene, "injury_", value, other)[0]
             for value, other in zip(values, coarser)]
    # Zero is the pressure before the wave arrives, and has no error.
    known = [one for one, value in zip(found, values)
             if one is not None and value]
    return ["–" if not value else "unknown" if one is None else
            page.error(max(one, statistics.median(known)))
            for one, value in zip(found, values)]


def _cavitation(scene):
    """Which tissues of the model cavitate."""
    tissues = scene.biomechanics.parameters.get(
        "Materials/Cavitating tissues")
    return "the model has no cavitation." if not tissues else (
        f"{tissues} cavitate in the model, below "
        + page.quantity((scene.biomechanics.parameter(
            "Materials/Least pressure") or [np.nan])[0], "Pa") + ".")


def _draw_first(scene, probes, places):
    """The first waves, before echoes of echoes."""
    time = probes["time"]
    begin = tissue_places.brain_arrival(scene) or 0.
    part = (time >= begin - 1e-4) & (time <= begin + signals.FIRST_WAVES)
    figure, axis = plt.subplots(figsize=(9., 3.3))
    for place in places:
        axis.plot(1e3 * time[part],
                  1e-3 * place.pressure(probes)[part],
                  label=place.title(), linewidth=1.2)
    axis.axhline(-100., color=style.GREY, linewidth=0.8, linestyle=":")
    axis.set_xlabel("time [ms]")
    axis.set_ylabel("pressure [kPa]")
    axis.legend(loc="upper left", bbox_to_anchor=(1., 1.))
    return figure


def _draw_histories(probes, groups):
    time = 1e3 * probes["time"]
    figure, axes = plt.subplots(len(groups), 1, sharex=True, squeeze=False,
                                figsize=(9., 2.5 * len(groups) + 0.6))
    size = [np.abs(place.pressure(probes))
            for _, places in groups for place in places]
    struck = np.max(size, axis=0) > 0.01 * np.max(size)
    begin = time[np.argmax(struck)]
    for axis, (title, places) in zip(axes.flat, groups):
        largest = max(np.abs(place.pressure(probes)).max()
                      for place in places)
        factor, unit = style.scale_unit("Pa", largest)
        for place in places:
            axis.plot(time, factor * place.pressure(probes),
                      linewidth=0.9, label=place.title())
        if places[0].tissue == tissue_places.BRAIN:
            axis.axhline(-1e5 * factor, color=style.GREY, linewidth=0.8,
                         linestyle=":")
        axis.set_title(title)
        axis.set_ylabel(f"pressure [{unit}]")
        axis.legend(loc="upper left", bbox_to_anchor=(1., 1.))
    axes[-1, 0].set_xlim(max(0., begin - 0.3), time[-1])
    axes[-1, 0].set_xlabel("time [ms]")
    return figure


def energy(scene):
    """Table and picture of the energy, and whether it keeps its limits."""
    history = scene.biomechanics.table("history.csv")
    if history is None or "external_work" not in history:
        return [page.missing("history.csv of biomechanics")]
    known = [(name, text) for name, text in ENERGIES if name in history]
    work = max(abs(float(history["external_work"][-1])), 1e-300)
    audit = EnergyAudit(scene)
    # The fraction of the missing energy is that of the audit above.
    rows = [(text, page.quantity(float(history[name][-1]), "J", 4),
             "–" if name == "energy_residual" and audit.is_known() else
             page.percent(float(history[name][-1]) / work, 3))
            for name, text in known]
    parts = [audit.verdict(),
             page.table(("energy at the end", "value",
                         "fraction of the work of the loads"), rows,
                        "The fraction of the energy that is missing stands "
                        "above: it is over the largest energy of the run.",
                        numbers=(1, 2)),
             page.figure(
                 _draw_energy(history, known),
                 "Two charts of energy over time: of the whole body by kind, "
                 "with the work of the loads, "
                 f"{page.quantity(work, 'J')} at the end, as the largest "
                 "curve; and of its internal energy by tissue.",
                 "Energy of the whole body by kind, and its internal energy "
                 "by tissue. The work and what is gained must be the sum of "
                 "all other energies; the missing energy is drawn as well.",
                 "svg")]
    return parts


def _draw_energy(history, known):
    time = 1e3 * history["time"]
    tissues = [name[len("internal_energy_"):] for name in history.names
               if name.startswith("internal_energy_")]
    figure, axes = plt.subplots(1, 2, figsize=(9.4, 3.7))
    for number, (name, text) in enumerate(known):
        axes[0].plot(time, history[name], label=text, color=style.COLOURS[
            number % 7], linestyle="--" if name == "energy_residual" else
                     "-" if number < 7 else ":")
    axes[0].set_title("whole body")
    for number, tissue in enumerate(tissues):
        axes[1].plot(time, history["internal_energy_" + tissue],
                     color=style.COLOURS[number % 7], label=tissue.replace(
                         "_", " "), linestyle="-" if number < 7 else "--")
    axes[1].set_title("internal energy by tissue")
    for axis in axes:
        axis.set_xlabel("time [ms]")
        axis.set_ylabel("energy [J]")
        if axis.lines:
            axis.legend(fontsize=8, loc="upper center", ncols=3,
                        bbox_to_anchor=(0.5, -0.17))
    return figure


def mesh(scene):
    """Volumes, masses and quality by tissue."""
    path = scene.anatomy.path("quality.csv")
    if not os.path.exists(path):
        return [page.missing("anatomy/quality.csv")]
    with files.reading(path), open(path, newline="",
                                   encoding="utf-8") as file:
        kinds = list(files.rows_of(file))
        kinds = [row for row in kinds if row["kind"] == "tissue"] or kinds
        rows = [(row["name"], page.count(int(row["elements"])),
                 page.number(1e3 * float(row["volume [m^3]"])),
                 page.number(float(row["mass [kg]"])),
                 page.number(float(row["smallest scaled Jacobian"]), 2),
                 page.number(1e6 * float(row["time step [s]"])),
                 page.count(int(row["connected components"])))
                for row in kinds]
    parts = []
    for name in ("cuts.png", "body.png"):
        picture = os.path.join(scene.anatomy.folder, "pictures", name)
        if os.path.exists(picture):
            with open(picture, "rb") as file:
                parts.append(page.figure(
                    file.read(), "Cuts through the body, coloured by tissue: "
                    + ", ".join(row[0] for row in rows) + ".",
                    "The mesh of the body in cuts, with one colour for each "
                    "tissue."))
            break
    parts.append(page.table(
        ("tissue", "elements", "volume [litre]", "mass [kg]",
         "smallest scaled Jacobian", "largest time step [µs]", "pieces"), rows,
        "Largest time step: the stability limit of the tissue alone. Pieces: "
        "parts that share no faces of elements; a thin layer has many where "
        "elements are too large for it.", numbers=range(1, 7)))
    return parts + organ_volumes(scene)


def organ_volumes(scene):
    """A table of organs' volumes in elements next to those that they should
    have, in a list; empty without such."""
    rows = []
    for organ in scene.anatomy.summary.get("organs") or []:
        volume, wanted = organ.get("volume"), organ.get("reference_volume")
        if volume is not None and wanted:
            rows.append((organ.get("name", ""), page.number(1e3 * volume),
                         page.number(1e3 * wanted),
                         page.percent(volume / wanted - 1.),
                         organ.get("source", "")))
    if not rows:
        return []
    return [page.table(
        ("organ", "elements [litre]", "reference [litre]", "difference",
         "reference"), rows,
        "Volumes of organs in the mesh, and those that they should have. "
        "Smaller elements bring them closer.", numbers=range(1, 4))]


def largest_displacement(scene):
    """Largest displacement of any node at the last output [m], its time, and
    the tissue of an element there; None without fields."""
    outputs = scene.field_list()
    if not outputs:
        return None
    largest, tissue = 0., 0
    for mesh_part in scene.field(outputs[-1][1]):
        shift = mesh_part["displacement"].reshape(-1, 3)
        size = np.sqrt((shift ** 2).sum(1))
        node = int(np.argmax(size))
        if size[node] > largest:
            largest = float(size[node])
            cell = int(np.argmax(mesh_part["connectivity"] == node)) // 8
            tissue = int(mesh_part["tissue"][cell])
    return largest, outputs[-1][0], tissue


def tissue_pressures(scene):
    """By tissue the 95th percentile of the size of the pressure [Pa] over its
    elements, largest over all outputs; without tissues for which the elements
    are too large."""
    found, called = {}, tissue_places.names(scene)
    for _, pieces in scene.field_list():
        values = {}
        for part in scene.field(pieces):
            for tissue in np.unique(part["tissue"]):
                values.setdefault(int(tissue), []).append(
                    np.abs(part["pressure"][part["tissue"] == tissue]))
        for tissue, lists in values.items():
            size = float(np.percentile(np.concatenate(lists), 95.))
            found[tissue] = max(found.get(tissue, 0.), size)
    return {tissue: size for tissue, size in found.items() if not
            tissue_places.is_thin(scene, called.get(tissue, ""))}
