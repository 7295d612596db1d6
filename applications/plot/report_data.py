# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""What a scene left on the disk. Whatever is missing is None or empty; what
is there and cannot be read is a BrokenInput."""

import contextlib
import csv
import os
import re
import zlib

import numpy as np

import body_views
import json_shape
import loads
import planes
import plot_solid
import tables
import vtk_file

STAGES = ("anatomy", "blast", "biomechanics")
# What blast finds of the loads on a place.
HARM = ("peak", "positive phase", "chest wall velocity", "lung exposure",
        "eardrum rupture")


class BrokenInput(Exception):
    """One line: which file, and what is wrong with it."""


@contextlib.contextmanager
def reading(path):
    """Turns whatever a reader throws into one line that names the file."""
    try:
        yield
    except (OSError, ValueError, KeyError, IndexError, TypeError, zlib.error,
            StopIteration, AttributeError, EOFError) as problem:
        words = " ".join(str(problem).split()) or type(problem).__name__
        raise BrokenInput(f"{path}: cannot be read: {words}") from problem


def read_json(path, shape):
    """An object of this shape, see json_shape; {} without a file."""
    if not os.path.exists(path):
        return {}
    with reading(path), open(path, encoding="utf-8") as file:
        content = json_shape.parse(file.read())
        json_shape.check(content, shape)
    return content


def rows_of(file):
    """The rows of a CSV file with a header, by its names."""
    reader = csv.DictReader(file)
    if not reader.fieldnames:
        raise ValueError("it is empty")
    for row in reader:
        if None in row or None in row.values():
            raise ValueError(f"line {reader.line_num} is not as long as the "
                             "header")
        yield row


def as_number(value):
    """A finite number, or None."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    return float(value) if np.isfinite(value) else None


class Measure:
    """One measure of injury as biomechanics reports it."""

    def __init__(self, name, value, unit, threshold="", limits=""):
        self.name, self.value, self.unit = name, value, unit
        self.threshold, self.limits = threshold, limits


class StageTable(tables.Table):
    """A table all of whose numbers are finite."""

    def __init__(self, path):
        super().__init__(path)
        self.path = path
        if not np.isfinite(self.values).all():
            raise ValueError("it has values that are no numbers")

    def __getitem__(self, name):
        if name not in self:
            raise BrokenInput(f'{self.path}: there is no column "{name}"')
        return super().__getitem__(name)


class Stage:
    """The folder of one stage."""

    def __init__(self, folder):
        self.folder = folder
        self.exists = os.path.isdir(folder)
        self.summary = read_json(self.path("summary.json"),
                                 json_shape.SUMMARY)
        self.parameters = {}
        if os.path.exists(self.path("parameters.prm")):
            with reading(self.path("parameters.prm")):
                self.parameters = body_views.read_parameters(
                    self.path("parameters.prm"))

    def path(self, name):
        return os.path.join(self.folder, name)

    def table(self, name):
        """history.csv and the like; None if missing or without rows."""
        if not os.path.exists(self.path(name)):
            return None
        with reading(self.path(name)):
            table = StageTable(self.path(name))
            return table if len(table.values) else None

    def found(self, group, name):
        """A number of the summary, or None."""
        return as_number((self.summary.get(group) or {}).get(name))

    def parameter(self, name):
        """Numbers of an entry; None if it is missing or other than that."""
        try:
            return [float(x) for x in self.parameters[name].split(",")]
        except (KeyError, ValueError):
            return None

    def log(self):
        if not os.path.exists(self.path("log.txt")):
            return ""
        with reading(self.path("log.txt")), open(
                self.path("log.txt"), encoding="utf-8") as file:
            return file.read()


class Scene:
    """A scene with its stages."""

    def __init__(self, folder):
        self.folder = folder
        self.facts = read_json(os.path.join(folder, "scene.json"),
                               json_shape.SCENE)
        self.anatomy, self.blast, self.biomechanics = (
            Stage(os.path.join(folder, self._folder_of(name)))
            for name in STAGES)
        if not self.facts and not any(
                stage.exists for stage in
                (self.anatomy, self.blast, self.biomechanics)):
            raise BrokenInput(
                f"{folder}: neither scene.json nor a stage's folder ("
                + ", ".join(STAGES) + ") is in it")
        self._loads, self._fields, self._views = None, None, None

    def _folder_of(self, name):
        for stage in self.list_of("stages"):
            if stage.get("name") == name and stage.get("folder"):
                return stage["folder"]
        return name

    def list_of(self, name):
        """A list of objects in scene.json, [] if missing."""
        entries = self.facts.get(name) or []
        return [entry for entry in entries if isinstance(entry, dict)]

    def fact(self, name):
        """A number of scene.json, or None."""
        return as_number(self.facts.get(name))

    def charge_place(self):
        place = self.facts.get("charge_place")
        if isinstance(place, list) and len(place) == 3:
            return np.array(place, dtype=float)
        place = self.blast.parameter("Charges/Charge 1/Center")
        return np.array(place) if place and len(place) == 3 else None

    def charge_mass(self):
        """[kg], or None."""
        return self._number("charge_mass", self.blast,
                            "Charges/Charge 1/Mass")

    def cell_size(self):
        """Cells at the skin [m], or None."""
        return self.fact("cell_size_at_body")

    def element_size(self):
        """[m], or None."""
        return self._number("element_size", self.biomechanics,
                            "Mesh/Element size")

    def _number(self, name, stage, entry):
        """Of scene.json; of what a stage was given where that is missing, for
        stages that were run one by one."""
        known = self.fact(name)
        return (stage.parameter(entry) or [None])[0] if known is None \
            else known

    def explosive(self):
        return self.facts.get("explosive") or self.blast.parameters.get(
            "Material/Explosive") or "explosive"

    def loads(self):
        """loads.h5, or None."""
        path = self.blast.path("loads.h5")
        if self._loads is None and os.path.exists(path):
            with reading(path):
                self._loads = loads.Loads(path)
        return self._loads

    def has_no_gauges(self):
        """Whether loads were recorded, but at no named place."""
        known = self.loads()
        return known is not None and not known.places()

    def views(self):
        """The body from four sides, or None."""
        known = self.loads()
        if self._views is None and known is not None and not known.is_flat \
                and len(known.areas):
            self._views = body_views.BodyViews(
                known.centroids, known.normals, known.areas,
                body_views.mirror_planes(self.blast.folder, known.centroids))
        return self._views

    def mirror_factor(self):
        """How many times the recorded part of the body is the whole."""
        known = self.loads()
        if known is None:
            return 1
        return 2 ** len(body_views.mirror_planes(self.blast.folder,
                                                 known.centroids))

    def pressure_planes(self):
        """Plane cuts of pressure by name."""
        with reading(self.blast.path("fields")):
            found = planes.open_planes(self.blast.folder)
        return {name: cuts for name, cuts in found.items()
                if cuts[0].quantity == "pressure"}

    def field_list(self):
        """Times and files of what biomechanics wrote; [] without."""
        path = self.biomechanics.path("fields.pvd")
        if self._fields is None:
            self._fields = []
            if os.path.exists(path):
                with reading(path):
                    self._fields = plot_solid.list_fields(
                        self.biomechanics.folder)
        return self._fields

    def field(self, pieces):
        """Arrays of one output, of all its pieces."""
        parts = []
        for piece in pieces:
            with reading(piece):
                parts.append(vtk_file.read(piece))
        return parts

    def gauge_injury(self):
        """What loads on named places do to a person there: numbers by place
        and name, without units."""
        path = self.blast.path("gauge_injury.csv")
        if not os.path.exists(path):
            return {}
        with reading(path), open(path, newline="", encoding="utf-8") as file:
            found = {row.pop("place"): {
                name.split(" [")[0]: float(value)
                for name, value in row.items()}
                for row in rows_of(file)}
            for harm in found.values():
                for name in HARM:
                    if not np.isfinite(harm[name]):
                        raise ValueError(f"{name}: no number")
        return found

    def measures(self):
        """Measures of injury by name."""
        return read_measures(self.biomechanics.path("injury.csv"))


def read_measures(path):
    """Measures of an injury.csv by name; none without the file."""
    measures = {}
    if os.path.exists(path):
        with reading(path), open(path, newline="", encoding="utf-8") as file:
            for row in rows_of(file):
                measures[row["measure"]] = Measure(
                    row["measure"], float(row["value"]), row["unit"],
                    row["threshold"], row["limits"])
    return measures


def write_page(folder, text):
    """Writes report.html; the old one stays until the new one is whole.
    Returns its path."""
    path = os.path.join(folder, "report.html")
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".new", path)
    return path


def points_of(text):
    """Points "x, y, z; x, y, z" as rows."""
    rows = [[float(x) for x in part.split(",")]
            for part in re.split(r";", text or "") if part.strip()]
    return np.array(rows).reshape(-1, 3)
