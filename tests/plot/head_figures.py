# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Compares the figures of the report on a head with the files of its run, to
the digits that are shown. The figures are worked out here again, from the
files alone, and each measure of injury from the history as well."""

import re

import numpy as np

import report_reader
from case import read_columns, read_json, read_rows, read_text, require
from report_figures import TITLES
from report_reader import require_same
from summaries import values_of

GRAVITY = 9.80665


class Files:
    """Files that a run left."""

    def __init__(self, output):
        self.output = output
        self.summary = read_json(output, "summary.json")
        self.found = (values_of(self.summary, "results")
                      | values_of(self.summary, "checks"))
        self.history = read_columns(output, "history.csv")
        self.probes = read_columns(output, "probes.csv")
        self.injury = {row["measure"]: float(row["value"]) for row in
                       read_rows(output, "injury.csv")}
        parameters = read_text(output, "parameters.prm")
        mesh = parameters[parameters.index("subsection Mesh"):]
        self.is_file = re.search(r"set Kind += (.*)", mesh)[1] == "file"
        self.criterion = head_injury_criterion(
            *gained_speed(self.history, "skull"), 0.015)


def crossing(time, values):
    """When values first rise from below zero to above, or None."""
    for i in range(len(values) - 1):
        if values[i] <= 0. < values[i + 1]:
            part = values[i] / (values[i] - values[i + 1])
            return time[i] + part * (time[i + 1] - time[i])
    return None


def filtered(time, values):
    """Times and values after the filter of SAE J211/1, appendix C, for channel
    frequency class 1000, at equal intervals; the record continues beyond its
    ends as its point reflection."""
    count = max(len(time), int(np.ceil((time[-1] - time[0]) / 1e-4)) + 1)
    times = np.linspace(time[0], time[-1], count)
    at = np.interp(times, time, values)
    reach = min(count - 1, int(np.ceil(0.01 / (times[1] - times[0]))))
    longer = np.concatenate((2. * at[0] - at[reach:0:-1], at,
                             2. * at[-1] - at[-2:-reach - 2:-1]))
    corner = np.tan(2.0775e3 * np.pi * (times[1] - times[0]))
    scale = 1. + np.sqrt(2.) * corner + corner ** 2
    for _ in range(2):
        out = np.full(len(longer), longer[0])
        for i, value in enumerate(longer):
            x = longer[max(i - 1, 0)], longer[max(i - 2, 0)]
            y = (out[i - 1], out[i - 2]) if i > 1 else (
                out[max(i - 1, 0)], longer[0])
            out[i] = (corner ** 2 * (value + 2. * x[0] + x[1])
                      + 2. * (1. - corner ** 2) * y[0]
                      - (1. - np.sqrt(2.) * corner + corner ** 2) * y[1]
                      ) / scale
        longer = out[::-1]
    return times, longer[reach:reach + count]


def gained_speed(history, tissue):
    """Times and the length of the path of the filtered velocity until each."""
    components = [filtered(history["time"], history[f"velocity_{axis}_{tissue}"])
                  for axis in "xyz"]
    gained = np.linalg.norm([np.diff(values) for _, values in components],
                            axis=0)
    return components[0][0], np.concatenate(([0.], np.cumsum(gained)))


def head_injury_criterion(time, speed, longest):
    """Criterion from the speed gained until each time: the largest over all
    pairs of times."""
    largest = 0.
    for i, begin in enumerate(time):
        for j in range(i + 1, len(time)):
            span = time[j] - begin
            if span <= longest:
                gained = speed[j] - speed[i]
                largest = max(largest, span * (gained / span
                                               / GRAVITY) ** 2.5)
    return largest


def check_report(page, files):
    """Every figure that the files have; the number of those compared."""
    checks = (check_headline, check_contact, check_extrema, check_probes,
              check_energy, check_injury, check_paper)
    return sum(check(page, files) for check in checks)


def check_headline(page, files):
    """Numbers of the answer."""
    history, number = files.history, report_reader.NUMBER
    wanted = [
        (rf"A head of ({number} \w*)", history["mass"][0]),
        (rf"plane at ({number} m/s)",
         -history["momentum_z"][0] / history["mass"][0]),
        (rf"The run ends after ({number} ms)", history["time"][-1]),
        (rf"pushes with ({number} \w+) at most",
         files.found["peak_contact_force"]),
        (rf"strained by less than ({number} %)",
         files.injury["injury_strain_95"])]
    if "injury_hic15" in files.injury:
        wanted.append((rf"HIC15 is (?:at least )?({number})", files.injury["injury_hic15"]))
    for layer, words in (("CSF", "The CSF's pressure in single cells"),
                         ("brain", "The brain's in single cells")):
        wanted += [
            (rf"{words} reaches from ({number} \w+)",
             min(history[f"least_pressure_{layer}"])),
            (rf"{words} reaches from [^.]*?(?:\.\d+[^.]*?)* to ({number} \w+)",
             max(history[f"largest_pressure_{layer}"]))]
    for pattern, value in wanted:
        match = re.search(pattern, page.answer)
        require(match, f"the answer does not say /{pattern}/: {page.answer}")
        require_same(match[1], value, f"the answer, /{pattern}/")
    return len(wanted)


def check_contact(page, files):
    """The table of the contact: of the whole head, from the summary, which is
    that of all steps."""
    rows = {row["what"]: row for row in
            page.table("Contact and rebound").records()}
    found, history = files.found, files.history
    count = 0
    require(("contact_cut_off" in found) == all(
        rows[name]["whole head"].startswith("≥") for name in rows
        if name.startswith(("largest", "impulse"))) == (
            rows["contact ends"]["when"] == "not until the end"),
            "lower limits of a contact that lasts")
    for name, value, when in (
            ("contact begins", None, found["contact_begin"]),
            ("largest contact force, mean over 50.0 µs",
             found["peak_contact_force"], found["peak_contact_force_time"]),
            ("largest contact force of a single step",
             found["peak_contact_force_of_step"],
             found["peak_contact_force_of_step_time"]),
            ("impulse of the contact force",
             found["contact_impulse"], None),
            ("velocity towards the plane at the start",
             -history["momentum_z"][0] / history["mass"][0], 0.),
            ("momentum along the normal changes its sign", None,
             crossing(history["time"], history["momentum_z"])),
            ("velocity from the plane at the end",
             history["momentum_z"][-1] / history["mass"][-1],
             history["time"][-1])):
        for cell, known in (("whole head", value), ("when", when)):
            if known is not None:
                require_same(rows[name][cell], known, f"{name}, {cell}")
                count += 1
    require(found["peak_contact_force"] < found["peak_contact_force_of_step"],
            "a mean of the force is above that of each step")
    require_same(rows["largest contact area"]["whole head"].replace(
        " cm²", "·10⁻⁴"), found["peak_contact_area"], "area")
    # Momentum changes by the impulse.
    change = history["momentum_z"][-1] - history["momentum_z"][0]
    require(abs(change / found["contact_impulse"] - 1.) < 1e-6,
            "the impulse is not the change of momentum")
    return count + 2


def check_extrema(page, files):
    """Extrema of the layers, of whole columns."""
    rows = page.table("Pressure and strain over time", column="layer").records()
    require(len(rows) >= 9, f"{len(rows)} extrema")
    for row in rows:
        quantity = "void_volume" if "void" in row["what"] \
            else row["what"].replace(" ", "_")
        column = files.history[f"{quantity}_{row['layer']}"]
        value = (min if quantity.startswith("least") else max)(column)
        when = files.history["time"][column.index(value)]
        shown = row["value"]
        if quantity == "void_volume":
            shown = shown.replace(" cm³", "·10⁻⁶")
        is_limit = "contact_cut_off" in files.found \
            or when >= files.history["time"][-1]
        require(shown.startswith(("≤ ", "≥ ")) == is_limit,
                f"{quantity} of {row['layer']}: {shown}")
        require_same(shown.lstrip("≤≥ "), value, f"{quantity} of {row['layer']}")
        require_same(row["when"], when, f"time of {quantity}")
    return 2 * len(rows)


def check_probes(page, files):
    rows = page.table("Pressure and strain over time",
                      column="probe").records()
    require(len(rows) == sum(name.startswith("pressure_")
                             for name in files.probes), "probes are missing")
    for number, row in enumerate(rows, 1):
        column = files.probes[f"pressure_{number}"]
        for name, value in (("highest", max(column)), ("lowest", min(column))):
            require_same(row[f"{name} pressure"], value, row["probe"])
            require_same(row[f"when it is {name}"],
                         files.probes["time"][column.index(value)],
                         row["probe"])
    return 4 * len(rows)


def check_energy(page, files):
    """The ledger at the start and at the end."""
    history = files.history
    names = {"kinetic": "kinetic_energy", "internal": "internal_energy",
             "work of planes and body forces": "external_work",
             "thereof planes, along their normals": "contact_work",
             "thereof friction": "friction_work", "missing": "energy_residual"}
    rows = page.table("Energy").records()
    require(len(rows) == 7, "energies are missing")
    work = history["external_work"][-1]
    parts = sum(history[names[row["energy of the whole head"]]][-1]
                for row in rows
                if row["energy of the whole head"].startswith("thereof"))
    require(abs(parts - work) < 1e-9 * abs(work), f"{parts} J of {work} J")
    for row in rows:
        name = row["energy of the whole head"]
        column = history[names[name]] if name in names else [
            sum(pair) for pair in zip(history["kinetic_energy"],
                                      history["internal_energy"])]
        for moment, index in (("at the start", 0), ("at the end", -1)):
            require_same(row[moment], column[index], name)
    return 2 * len(rows)


def check_injury(page, files):
    """The table holds what injury.csv does, and this is what the rows of the
    history have, which are of the same steps."""
    rows = {row["measure"]: row for row in page.table("Injury").records()}
    titles = dict(TITLES, injury_pressure_roughness=(
        "oscillation of the brain pressure between neighbours over its "
        "averages"))
    listed = {name: value for name, value in files.injury.items()
              if "_ais" not in name}
    require(sorted(rows) == sorted(titles[name] for name in listed),
            f"the injury table has {list(rows)}")
    for name, value in listed.items():
        shown = rows[titles[name]]["value and its estimated error"]
        require_same(shown.split("\n")[0], value, name)
    history = files.history
    # A skull without planes of symmetry turns about the head's centre, where
    # the criterion is computed; the history has the mean velocity alone.
    for name, value, bound in (
            ("injury_intracranial_pressure_peak",
             max(history["largest_pressure_brain"]), 1e-6),
            ("injury_intracranial_pressure_lowest",
             min(history["least_pressure_brain"]), 1e-6),
            ("injury_hic15", files.criterion,
             1e-3 if files.is_file else 1e-6)):
        require(abs(files.injury[name] / value - 1.) < bound,
                f"{name} is {files.injury[name]}, the history has {value}")
    # No principal strain is larger than the shear strain, but by what volumes
    # grow.
    strain = files.injury["injury_strain_95"]
    require(0. < strain < max(history["largest_shear_strain_brain"]),
            f"strain {strain}")
    return len(listed) + 4


def check_paper(page, files):
    """Statements against what was found: figures that the history has; the
    paper's head was no file."""
    if files.is_file:
        require(all(table.section != "Against the paper"
                    for table in page.tables), "the paper's section")
        return 0
    rows = {row["as published"]: row for row in
            page.table("Against the paper").records()}
    history = files.history
    flow = rows["“the flow speed in CSF is in the same level of initial impact "
                "speed”"]
    fastest = max(history["largest_speed_CSF"])
    require_same(flow["in this run"], fastest, "speed of the CSF")
    initial = -history["momentum_z"][0] / history["mass"][0]
    require((flow["verdict"] == "agrees")
            == (0.5 <= fastest / initial <= 2.), "verdict on the CSF's speed")
    end = history["time"][-1]
    late = [row for name, row in rows.items() if re.search(
        r"4\.36 ms|2\.18 ms|-236KPa|end of 5ms", name)]
    require(len(late) == 4, f"{len(late)} statements on later times")
    for row in late:
        if end < 0.92e-3:
            require(row["verdict"] == "open", str(row))
            require_same(row["in this run"], end, "end of the run")
    return 2 + len(late)
