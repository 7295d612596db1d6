# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Results of a run in its output folder. Whatever is missing is None or empty;
what is there and cannot be read is a BrokenInput."""

import dataclasses
import os

import numpy as np

from plot.readers import fields, files, json_shape, tables


@dataclasses.dataclass
class Measure:
    """One measure of injury as biomechanics reports it."""
    name: str
    value: float
    unit: str
    threshold: str = ""
    limits: str = ""
    is_cut: bool = False  # a lower limit: the run ends too early


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
        self.parameters = files.read_parameters(self.path("parameters.prm"))

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

    def fields(self):
        """Times and files of the outputs; [] without."""
        path = self.path("fields.pvd")
        with files.reading(path):
            return fields.list_fields(self.folder) if os.path.exists(path) else []

    def log(self):
        path = self.path("log.txt")
        return files.read_text(path) if os.path.exists(path) else ""


def read_measures(path):
    """Measures of an injury.csv by name; none without the file."""
    with files.reading(path):
        return {row["measure"]: Measure(
            row["measure"], float(row["value"]), row["unit"],
            row["threshold"], row["limits"], is_cut(row))
                for row in files.read_rows(path)}
