# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Results of a run in its output folder. Whatever is missing is None or empty;
what is there and cannot be read is a BrokenInput."""

import os

import numpy as np

from plot.readers import files, json_shape, tables


class Measure:
    """One measure of injury as biomechanics reports it."""

    def __init__(self, name, value, unit, threshold="", limits="",
                 is_cut=False):
        self.name, self.value, self.unit = name, value, unit
        self.threshold, self.limits = threshold, limits
        # A lower limit: the run ends too early.
        self.is_cut = is_cut


def is_cut(row):
    """Whether a row of a table of measures is a lower limit; of tables before
    0.2.0 that is unknown."""
    return float(row.get("cut off [-]", 0.)) > 0.


class StageTable(tables.Table):
    """A table all of whose numbers are finite."""

    def __init__(self, path):
        super().__init__(path)
        self.path = path
        if not np.isfinite(self.values).all():
            raise ValueError("it has values that are no numbers")

    def __getitem__(self, name):
        if name not in self:
            raise files.BrokenInput(f'{self.path}: there is no column "{name}"')
        return super().__getitem__(name)


class Stage:
    """The folder of one stage."""

    def __init__(self, folder):
        self.folder = folder
        self.exists = os.path.isdir(folder)
        self.summary = files.read_json(self.path("summary.json"),
                                       json_shape.SUMMARY)
        self.parameters = read_entries(self.path("parameters.prm"))

    def path(self, name):
        return os.path.join(self.folder, name)

    def table(self, name):
        """history.csv and the like; None if missing or without rows."""
        if not os.path.exists(self.path(name)):
            return None
        with files.reading(self.path(name)):
            table = StageTable(self.path(name))
            return table if len(table.values) else None

    def found(self, group, name):
        """A number of the summary, or None; of "results" and "checks" the
        value without its unit."""
        entry = (self.summary.get(group) or {}).get(name)
        if isinstance(entry, dict):
            entry = entry.get("value")
        return files.as_number(entry)

    def parameter(self, name):
        """Numbers of an entry; None if it is missing or other than that."""
        try:
            return [float(x) for x in self.parameters[name].split(",")]
        except (KeyError, ValueError):
            return None

    def log(self):
        if not os.path.exists(self.path("log.txt")):
            return ""
        with files.reading(self.path("log.txt")), open(
                self.path("log.txt"), encoding="utf-8") as file:
            return file.read()


def read_entries(path):
    """Entries of a parameter file by name, none without the file."""
    if not os.path.exists(path):
        return {}
    with files.reading(path):
        return files.read_parameters(path)


def read_measures(path):
    """Measures of an injury.csv by name; none without the file."""
    measures = {}
    if os.path.exists(path):
        with files.reading(path), open(path, newline="",
                                       encoding="utf-8") as file:
            for row in files.rows_of(file):
                measures[row["measure"]] = Measure(
                    row["measure"], float(row["value"]), row["unit"],
                    row["threshold"], row["limits"], is_cut(row))
    return measures
