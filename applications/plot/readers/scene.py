# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Results of a scene in its output folder. Whatever is missing is None or
empty; what is there and cannot be read is a BrokenInput."""

import os

import numpy as np

from plot.readers import files, json_shape, loads, planes, vtk_file
from plot.readers.stage import Measure, Stage, is_cut, read_measures

STAGES = ("anatomy", "blast", "biomechanics")
COARSER = "coarser run of "
# Columns of gauge_measures.csv, without units.
GAUGE_MEASURES = ("arrival", "peak", "peak time", "impulse", "positive phase",
                  "cut off")


class Run:
    """Results of a blast and of the biomechanics after it."""

    def __init__(self, blast, biomechanics):
        self.blast, self.biomechanics = blast, biomechanics
        self._loads = None

    def loads(self):
        """loads.h5, or None."""
        path = self.blast.path("loads.h5")
        if self._loads is None and os.path.exists(path):
            with files.reading(path):
                self._loads = loads.Loads(path)
        return self._loads

    def gauge_measures(self):
        """GAUGE_MEASURES of the gauges on the skin that a blast has reached:
        numbers by gauge and name; {} without the file."""
        path, found = self.blast.path("gauge_measures.csv"), {}
        with files.reading(path):
            for row in files.read_rows(path):
                place = row.pop("place")
                known = {name.split(" [")[0]: float(value)
                         for name, value in row.items()}
                numbers = [known[name] for name in GAUGE_MEASURES]
                # "cut off" alone is known where no blast has arrived.
                if np.isnan(numbers[:-1]).all() and np.isfinite(numbers[-1]):
                    continue
                if not np.isfinite(numbers).all():
                    raise ValueError(f"{place}: no number")
                found[place] = known
        return found

    def gauge_planes(self):
        """Maps of the blast in planes of gauges: by plane, one Plane by
        quantity."""
        symmetry = loads.symmetry_planes(self.blast.folder)
        groups = {}
        for name, (plane, *_) in sorted(self._planes().items()):
            if name.startswith("gauges_plane_"):
                plane.mirror(symmetry)
                groups.setdefault(name[:-len(plane.quantity)],
                                  {})[plane.quantity] = plane
        return groups

    def pressure_planes(self):
        """Plane cuts of pressure by name."""
        return {name: cuts for name, cuts in self._planes().items()
                if cuts[0].quantity == "pressure"}

    def _planes(self):
        with files.reading(self.blast.path("fields")):
            return planes.open_planes(self.blast.folder)

    def gauge_injury(self):
        """Injuries by the loads at gauges: Measure by (measure, gauge)."""
        return _injury(self.blast.path("gauge_injury.csv"))

    def air_injury(self):
        """Injuries to a person at the probes in the air: Measure by (measure,
        probe)."""
        return _injury(self.blast.path("probe_injury.csv"))

    def measures(self):
        """Measures of injury by name."""
        return read_measures(self.biomechanics.path("injury.csv"))


def _injury(path):
    """Measure by (measure, place), {} without the file."""
    found = {}
    with files.reading(path):
        for row in files.read_rows(path):
            value = float(row["value"])
            if not np.isfinite(value):
                raise ValueError(f"{row['measure']}: no number")
            found[row["measure"], row["place"]] = Measure(
                row["measure"], value, row["unit"], limits=row["definition"],
                is_cut=is_cut(row))
    return found


class Scene(Run):
    """A scene with its stages."""

    def __init__(self, folder):
        self.folder = folder
        self.facts = files.read_json(os.path.join(folder, "scene.json"),
                                     json_shape.SCENE)
        self.anatomy, *stages = (self.stage(name) for name in STAGES)
        super().__init__(*stages)
        self.parameters = files.read_parameters(
            os.path.join(folder, "parameters.prm"))
        self.coarser = self._coarser_run()
        if not self.facts and not any(getattr(self, name).exists
                                      for name in STAGES):
            raise files.BrokenInput(
                f"{folder}: neither scene.json nor a stage's folder ("
                + ", ".join(STAGES) + ") is in it")

    def _coarser_run(self):
        """The Run with larger cells and elements, or None unless all its stages
        are finished."""
        stages = [stage for stage in self.list_of("stages")
                  if str(stage.get("name")).startswith("coarser_")]
        if not stages or any(stage.get("status") not in ("finished", "reused")
                             for stage in stages):
            return None
        return Run(*(self.stage(f"coarser_{name}") for name in STAGES[1:]))

    def stage(self, name):
        """The folder of a stage, which may not be there. That of a stage that
        scene.json does not list is of an earlier scene: none is left of it."""
        listed = {stage.get("name"): stage.get("folder") or name
                  for stage in self.list_of("stages")}
        is_left = listed and name not in listed
        return Stage(os.path.join(self.folder, listed.get(name) or name,
                                  *(["none"] if is_left else [])))

    def list_of(self, name):
        """A list of objects in scene.json, [] if missing."""
        return self.facts.get(name) or []

    def fact(self, name):
        """A number of scene.json, or None."""
        return files.as_number(self.facts.get(name))

    def table_answer(self, name, where="answer",
                     places=("in_the_open", "before_a_wall")):
        """Values of the tables for a person in the open and before a wall, of
        scene.json, for the nearest skin, at the "trunk" where the load on its
        skin tells of the lungs, or at the "ears"; None each where they have
        none."""
        known = (self.facts.get("tables") or {}).get(where) or {}
        return tuple(files.as_number((known.get(place) or {}).get(name))
                     for place in places)

    def warnings(self):
        """Warnings of all stages, each once, with the stages that had them;
        those of the coarser run alone last."""
        stages = [(name, getattr(self, name).summary) for name in STAGES]
        stages.append(("scene", self.facts))
        if self.coarser is not None:
            stages += [(COARSER + name, getattr(self.coarser, name).summary)
                       for name in STAGES[1:]]
        found = {}
        for name, content in stages:
            for text in content.get("warnings") or []:
                found.setdefault(text, []).append(name)
        return found

    def charge_place(self):
        place = self.facts.get("charge_place") \
            or self.blast.parameter("Charges/Charge 1/Center")
        return np.array(place, float) if place and len(place) == 3 else None

    def charge_mass(self):
        """[kg], or None."""
        return self._number("charge_mass", self.blast,
                            "Charges/Charge 1/Mass")

    def element_size(self):
        """[m], or None."""
        return self._number("element_size", self.biomechanics,
                            "Mesh/Element size")

    def has_own_mesh(self):
        """Whether the body consists of hexahedra of one's own."""
        return self.facts.get("body") == "mesh"

    def _number(self, name, stage, entry):
        """A number of scene.json; where that is missing, of the entries of a
        stage, for stages that were run one by one."""
        known = self.fact(name)
        return (stage.parameter(entry) or [None])[0] if known is None \
            else known

    def explosive(self):
        return self.facts.get("explosive") or self.blast.parameters.get(
            "Material/Explosive") or "explosive"

    def explosive_name(self):
        """As in texts; of files that do not have that, as in entries."""
        return self.facts.get("explosive_title") or self.explosive()

    def incident_peak(self, number):
        """Peak of the first wave at a probe [Pa]; of runs that do not tell it the
        largest peak; None where that is unknown, too."""
        first, largest = (
            self.blast.found("results", f"probe_{number}_{name}peak_overpressure")
            for name in ("first_", ""))
        return largest if first is None else first

    def asks_for_loads(self):
        """Whether the scene ends with the loads on the skin."""
        return self.facts.get("question") == "loads"

    def has_no_gauges(self):
        """Whether loads were recorded, but at no named place."""
        known = self.loads()
        return known is not None and not known.places()

    def mirror_factor(self):
        """How many times the recorded part of the body is the whole."""
        known = self.loads()
        return 1 if known is None else 2 ** len(loads.mirror_planes(
            self.blast.folder, known.centroids))

    def field_list(self):
        """Times and files of what biomechanics wrote; [] without."""
        return self.biomechanics.fields()

    def field(self, pieces):
        """Arrays of one output, of all its pieces."""
        parts = []
        for piece in pieces:
            with files.reading(piece):
                parts.append(vtk_file.read(piece))
        return parts
