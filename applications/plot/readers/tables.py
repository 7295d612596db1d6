# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Tables of a run: history.csv, probes.csv and others, with units."""

import csv
import os
import re

import numpy as np

from plot.readers import files, json_shape


class Table:
    """Columns by name, with units; the header reads 'name [unit],...'."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            header = next(csv.reader(file))
            self.values = np.loadtxt(file, delimiter=",", ndmin=2)
        matches = [re.fullmatch(r"\s*(.*?)\s*(?:\[(.*)\])?\s*", entry)
                   for entry in header]
        self.names = [match[1] for match in matches]
        self.units = [match[2] or "-" for match in matches]
        if self.values.shape[1] != len(header):
            raise ValueError(f"{path}: {len(header)} names for "
                             f"{self.values.shape[1]} columns")

    def __contains__(self, name):
        return name in self.names

    def __getitem__(self, name):
        return self.values[:, self.names.index(name)]

    def unit(self, name):
        return self.units[self.names.index(name)]

    def others(self, *names):
        return [name for name in self.names if name not in names]


def open_table(folder, name):
    """history.csv and the like; None if missing."""
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return None
    with files.reading(path):
        return Table(path)


def tissue_pressure(table, probe):
    """Pressure at a probe of biomechanics, as "probe_1_", averaged over the
    tissue around it; that of its element in runs without the average."""
    averaged = probe + "averaged_pressure"
    return table[averaged if averaged in table else probe + "pressure"]


def probe_pressures(folder, names):
    """Time [s], and tissue_pressure() [Pa] of as many probes by these names."""
    table = open_table(folder, "probes.csv")
    if table is None:
        raise files.BrokenInput(f"{folder} has no probes.csv")
    probes = [f"probe_{number}_" for number in range(1, len(names) + 1)]
    for probe in probes:
        if probe + "pressure" not in table:
            raise files.BrokenInput(
                f"{folder}/probes.csv has no {probe}pressure")
    return table["time"], {name: tissue_pressure(table, probe)
                           for name, probe in zip(names, probes)}


def open_references(folder):
    """Values of a run's reference at each probe, by the probe's name:
    quantities such as peak_overpressure and arrival."""
    path = os.path.join(folder, "summary.json")
    known = files.read_json(path, json_shape.SUMMARY).get("results", {})
    references = {}
    for name, entry in known.items():
        match = re.fullmatch(r"(probe_\d+)_reference_(\w+)", name)
        if match:
            references.setdefault(match[1], {})[match[2]] = entry["value"]
    return references
