# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Output on disk of a run of head_impact with a head: its layers, the plane
that it hits, its histories, cuts through its fields."""

import re
from typing import NamedTuple

import numpy as np

from plot.readers import cuts, files, vtk_file
from plot.readers.stage import Stage

# The published impact of a head on a wall (X. G. Tan, R. N. Saunders, A. Bagchi,
# COUPLED PROBLEMS 2017, section 3.4): speed [m/s], times of its pictures [s], and,
# as the paper gives no sizes, those of the shipped scene of it [m].
PUBLISHED_SPEED = 3.
PUBLISHED_TIMES = (1e-4, 5e-4, 1e-3, 5e-3)
PUBLISHED_FLOW_TIMES = (1e-3, 5e-3)
PUBLISHED_SIZES = {"Semi-axes": 0.08, "CSF thickness": 0.004,
                   "Skull thickness": 0.007}
# States of an impact that its cuts show.
STATES = ("first contact", "largest force", "rebound", "end of contact")
FLOW_STATES = STATES[1::2]
LEAST_PANELS = 4
# Gap to a plane of symmetry, where cells have a face, over the head's size.
BESIDE = 1e-4
# Names of layers as tissues of a file.
LAYERS = {"cerebrospinal fluid": "csf", "skeleton": "skull"}


class Plane:
    """A rigid plane."""

    def __init__(self, stage, name):
        self.name = name
        point, normal = (stage.parameter(f"Plane {name}/{entry}") or []
                         for entry in ("Point", "Normal"))
        if not len(point) == len(normal) == 3:
            raise ValueError(f"Plane {name} has no point and normal")
        self.point = np.array(point)
        self.normal = normal / np.linalg.norm(normal)
        self.friction = (stage.parameter(f"Plane {name}/Friction") or [0.])[0]


class Cut(NamedTuple):
    """Cut of a plane through the cells at one time: polygons in the plane,
    cells that they belong to, and the fields in these cells; "carried" is the
    velocity that the skull has there as a rigid body."""
    time: float
    polygons: np.ndarray
    values: dict
    centres: dict


class HeadRun(Stage):
    """The folder of a run."""

    def _sections(self, pattern):
        """What such names of entries have at the place of a group."""
        matches = (re.fullmatch(pattern, name) for name in self.parameters)
        return [match[1] for match in matches if match]

    def __init__(self, folder):
        super().__init__(folder)
        self.history = self.table("history.csv")
        self.probes = self.table("probes.csv")
        self.regions = self._sections("Region (.*)/Layer")
        self.layer_of = {name: layer_named(
            self.parameters[f"Region {name}/Layer"], name)
                         for name in self.regions}
        with files.reading(self.path("parameters.prm")):
            self.planes = [Plane(self, name)
                           for name in self._sections("Plane (.*)/Normal")]
        self.wedge_axis = self.parameters.get("Mesh/Wedge axis", "none")
        self.mirrors = [axis for axis, name in enumerate("xyz") if name in
                        self.parameters.get("Mesh/Symmetry planes", "")
                        or self.wedge_axis not in ("none", name)]

    def is_head(self):
        """Whether there is anything that this can tell of: a layered head, or a
        file with a brain or CSF."""
        return self.history is not None and (self.is_layered() or (
            self.is_file() and any(self.region(layer)
                                   for layer in ("brain", "csf"))))

    def is_published(self):
        """Whether this is the published impact: brain, CSF and skull of the
        shipped sizes, straight against one plane, at the published speed."""
        if not (self.is_head() and self.is_layered() and len(self.planes) == 1
                and all(self.region(layer)
                        for layer in ("brain", "csf", "skull"))):
            return False
        speeds = (np.linalg.norm(self.momentum()[0] / self.history["mass"][0]),
                  -self.normal_velocity()[0])
        return all(abs(speed / PUBLISHED_SPEED - 1.) < 0.01
                   for speed in speeds) \
            and all(np.allclose(self.parameter(f"Mesh/{name}") or 0., size,
                                1e-3) for name, size in PUBLISHED_SIZES.items())

    def is_layered(self):
        return self.parameters.get("Mesh/Kind") == "layered head"

    def is_file(self):
        return self.parameters.get("Mesh/Kind") in ("file", "body")

    def region(self, layer):
        """The name of the region of a layer, "brain", "csf", "skull" or
        "scalp"; None if there is none."""
        return next((name for name, known in self.layer_of.items()
                     if known == layer), None)

    def is_solid(self, name):
        return f"largest_shear_strain_{name}" in self.history

    def column(self, quantity, layer):
        """A column of history.csv, or None."""
        name = f"{quantity}_{self.region(layer)}"
        return self.history[name] if name in self.history else None

    def momentum(self):
        """Of everything over time [kg m/s]."""
        return np.stack([self.history[f"momentum_{axis}"] for axis in "xyz"],
                        axis=1)

    def normal_velocity(self):
        """Mean velocity of everything away from the plane that is hit, the
        first one, over time [m/s]."""
        return self.momentum() @ self.planes[0].normal / self.history["mass"]

    def contact(self, name):
        """A result of the summary on the contact, of every step; None if
        nothing touched the planes, and for the end of a contact that lasts."""
        return self.found("results", name)

    def is_cut_off(self):
        """Whether the contact lasts when the run ends."""
        return self.contact("contact_begin") is not None \
            and self.last_contact() is None

    def last_contact(self):
        """When the planes last pushed; None if never, or at the end."""
        end = self.contact("contact_end")
        return end if end is not None and end < self.history["time"][-1] \
            else None

    def is_so_far(self, when):
        """Whether an extreme of that time may be exceeded after the run: it is
        at the end, or the contact lasts then."""
        return self.is_cut_off() or when >= self.history["time"][-1]

    def rebound(self):
        """When the momentum along the plane's normal changes its sign, straight
        between rows; None if it does not."""
        return first_crossing(self.history["time"], self.normal_velocity())

    def states(self):
        """Moments of the impact by STATES [s], without those that the run does
        not reach; {} without a contact."""
        if self.contact("contact_begin") is None:
            return {}
        times = (self.contact("contact_begin"),
                 self.contact("peak_contact_force_time"), self.rebound(),
                 self.last_contact())
        return {name: time for name, time in zip(STATES, times)
                if time is not None}

    def _later(self):
        """Outputs that show something, and when the impact ends."""
        later = [entry for entry in self.fields() if entry[0] > 0.]
        states = self.states()
        end = states.get(STATES[-1], max(later, default=(0.,))[0])
        if self.is_published():
            return later, end
        # Until the contact has begun there is nothing to be seen.
        return [entry for entry in later if entry[0] > states.get(STATES[0], 0.)
                ] or later[-1:], end

    def outputs_of_states(self):
        """Names of the states of the impact by the times of the outputs that are
        the nearest to them; of the published one no names, by the times of
        outputs at those of its pictures."""
        later, _ = self._later()
        if self.is_published():
            return {entry[0]: [] for time in PUBLISHED_TIMES for entry in later
                    if abs(entry[0] - time) <= 0.02 * time}
        found = {}
        for name, time in self.states().items() if later else ():
            found.setdefault(min((entry[0] for entry in later), key=lambda output:
                                 abs(output - time)), []).append(name)
        return found

    def picked(self):
        """The outputs to show: those of outputs_of_states(); where these are
        few, others far from them, of the contact first."""
        later, end = self._later()
        states = self.outputs_of_states()
        chosen = {entry[0]: entry for entry in later if entry[0] in states}
        for _ in range(LEAST_PANELS - len(chosen)):
            others = [entry for entry in later if entry[0] not in chosen]
            if others:
                entry = max(others, key=lambda entry: (
                    entry[0] <= end, min((abs(entry[0] - time) for time in
                                          chosen), default=entry[0])))
                chosen[entry[0]] = entry
        return [chosen[time] for time in sorted(chosen)]

    def picked_flow(self, cuts):
        """Those of the picked Cuts that show the flow of the CSF: of the
        published impact at times of its pictures, else of FLOW_STATES; the
        last two where there are none."""
        if self.is_published():
            return [cut for cut in cuts if any(
                abs(cut.time - time) <= 0.02 * time
                for time in PUBLISHED_FLOW_TIMES)] or cuts[-2:]
        wanted = {min((abs(cut.time - time), cut.time) for cut in cuts)[1]
                  for name, time in self.states().items()
                  if name in FLOW_STATES}
        return [cut for cut in cuts if cut.time in wanted] or cuts[-2:]

    def cut_axes(self):
        """The axis normal to the cut, and those to the right and up: the cut
        holds the plane's normal, and is a plane of symmetry if one is, or the
        middle of a wedge."""
        normal = np.abs(self.planes[0].normal) if self.planes else (0., 0., 1.)
        along = [axis for axis in (1, 0, 2) if normal[axis] < 0.5]
        through = next((axis for axis in along if axis in self.mirrors),
                       along[0])
        if self.wedge_axis != "none":
            through = ("xyz".index(self.wedge_axis) + 2) % 3
        right, up = (axis for axis in range(3) if axis != through)
        return through, right, up

    def has_particles(self):
        """Whether the fields are points, not cells."""
        return self.parameters.get("Method") == "mpm"

    def spacing(self):
        """Spacing of particles at the start [m]."""
        size = (self.parameter("MPM/Cell size") or [0.])[0]
        return size / max(self.parameter("MPM/Particles a cell") or [1.])

    def arrays(self, pieces):
        """Arrays of one output, of all its pieces: cells x corners x
        components; particles are cells of one corner."""
        read = vtk_file.read_points if self.has_particles() \
            else vtk_file.read_cells
        parts = []
        for piece in pieces:
            with files.reading(piece):
                parts.append(read(piece))
        found = {name: np.concatenate([part[name] for part in parts])
                 for name in parts[0]}
        if self.has_particles():
            found = {name: values[:, None] for name, values in found.items()}
        return found

    def middle(self, points):
        """Where cuts and mirrors are: a layered head's is at the origin; a file
        has planes of symmetry at its lower sides, and is cut in its middle."""
        result = np.zeros(3)
        if not self.is_file():
            return result
        low, high = points.min(axis=(0, 1)), points.max(axis=(0, 1))
        through = self.cut_axes()[0]
        result[through] = 0.5 * (low + high)[through]
        result[self.mirrors] = low[self.mirrors]
        return result

    def skull_velocity(self, arrays, places):
        """Velocity of the skull as a rigid body at some places; zero without a
        skull."""
        name = self.region("skull")
        part = np.round(arrays["region"][:, 0, 0]) == (
            self.regions.index(name) if name else np.nan)
        if not part.any():
            return np.zeros_like(places)
        points, velocities = (arrays[key][part].mean(axis=1)
                              for key in ("points", "velocity"))
        # Particles of one region have one mass.
        masses = np.ones(len(points)) if self.has_particles() else \
            arrays["density"][part].mean(axis=(1, 2)) \
            * cuts.volumes(arrays["points"][part])
        for axis in self.mirrors:
            sign = np.where(np.arange(3) == axis, -1., 1.)
            points = np.concatenate([points, points * sign])
            velocities = np.concatenate([velocities, velocities * sign])
            masses = np.concatenate([masses, masses])
        return rigid_velocity(points, velocities, masses, places)

    def cut(self, entry):
        """The Cut of an output, mirrored to the whole head."""
        time, pieces = entry
        arrays = self.arrays(pieces)
        arrays["points"] = arrays["points"] - self.middle(arrays["points"])
        through, right, up = self.cut_axes()
        if self.has_particles():
            polygons, owners = cuts.cut_particles(
                arrays["points"][:, 0], through, through in self.mirrors,
                self.spacing(), [right, up])
        else:
            # The middle of a wedge is within its cells.
            place = BESIDE * np.ptp(arrays["points"]) \
                if self.wedge_axis == "none" else 0.
            polygons, owners = cuts.cut_hexahedra(
                arrays["points"], through, place, (right, up))
        shown = np.unique(owners)
        values = {name: found[:, :, 0].mean(axis=1)[owners]
                  for name, found in arrays.items()
                  if name not in ("points", "velocity")}
        places = arrays["points"].mean(axis=1)
        vectors = {"velocity": arrays["velocity"].mean(axis=1),
                   "carried": self.skull_velocity(arrays, places)}
        centres = {"place": places[shown][:, [right, up]],
                   "region": arrays["region"][shown, 0, 0]}
        for name, vector in vectors.items():
            values[name] = vector[owners][:, [right, up]]
            centres[name] = vector[shown][:, [right, up]]
        parts = {"polygons": polygons}, values, centres
        for number, axis in enumerate((right, up)):
            if axis in self.mirrors:
                parts = [_mirrored(number, part) for part in parts]
        return Cut(time, parts[0]["polygons"], *parts[1:])


def rigid_velocity(points, velocities, masses, places):
    """Velocities at some places of the rigid body that moves as a deformable one
    does: with its mean velocity and the angular velocity of its angular momentum
    about its centre of mass, which are those of least squares."""
    centre, velocity = (np.average(values, axis=0, weights=masses)
                        for values in (points, velocities))
    away = points - centre
    inertia = (masses @ np.sum(away**2, axis=1)) * np.eye(3) \
        - (masses * away.T) @ away
    # Rotation of least norm, as points on one line have any about it.
    rotation = np.linalg.lstsq(
        inertia, masses @ np.cross(away, velocities), rcond=None)[0]
    return velocity + np.cross(rotation, places - centre)


def layer_named(layer, region):
    """The layer that a region's entry Layer names: tissues of a file by their
    names, numbers and nothing by the region's."""
    word = " ".join(layer.lower().replace("_", " ").split())
    if not word or word.isdigit():
        word = region.lower()
    return LAYERS.get(word, word)


def first_crossing(time, values):
    """When values first rise from below zero to above, or None."""
    after = np.flatnonzero((values[1:] > 0.) & (values[:-1] <= 0.))
    if not after.size:
        return None
    i = after[0]
    part = values[i] / (values[i] - values[i + 1])
    return float(time[i] + part * (time[i + 1] - time[i]))


def _mirrored(number, fields):
    """Fields by name and their images, in which the component of that @p number
    of vectors is opposite."""
    sign = np.where(np.arange(2) == number, -1., 1.)
    return {name: np.concatenate([found, found * sign if found.ndim > 1
                                  else found])
            for name, found in fields.items()}
