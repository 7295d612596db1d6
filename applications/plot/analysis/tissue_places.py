# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Names of the places in the tissue where biomechanics took histories."""

import numpy as np

from plot.analysis import person, signals
from plot.readers import files, tables

SOFT, SKIN, SKELETON, BRAIN, CORD, FLUID, LUNG, HEART, LIVER = range(1, 10)
NAMES = {SOFT: "soft tissue", SKIN: "skin", SKELETON: "skeleton",
         BRAIN: "brain", CORD: "spinal cord", FLUID: "cerebrospinal fluid",
         LUNG: "lung", HEART: "heart", LIVER: "liver", 10: "water",
         11: "gelatin", 12: "polycarbonate"}
OTHER = "other tissue"
THIN = " †"  # of tissues in whose layers the elements leave holes
NEAR = 0.07  # m, from a named place of the skin
# Names of places in scene, those in a report, and their tissue.
GIVEN = {"coup": ("brain, coup", BRAIN),
         "contrecoup": ("brain, contrecoup", BRAIN),
         "brain": ("brain, inside", BRAIN), "skull": ("skull", SKELETON),
         "lung left": ("left lung", LUNG), "lung right": ("right lung", LUNG),
         "spinal cord": ("spinal cord", CORD)}


def names(scene):
    """Names of tissues by their numbers, with those that the user defined."""
    path = scene.anatomy.path("parts.csv")
    with files.reading(path):
        return NAMES | {int(row["tissue"]): row["tissue name"]
                        for row in files.read_rows(path)}


class Place:
    """One probe in the body."""

    def __init__(self, number, point, tissue, name):
        self.column = f"probe_{number}_"
        self.point, self.tissue, self.name = point, tissue, name
        self.remark = ""  # on what is there instead, or THIN

    def is_in(self, probes):
        """Whether probes.csv of a run has it."""
        return self.column + "pressure" in probes

    def pressure(self, probes):
        """Over time, of probes.csv of biomechanics [Pa]."""
        return tables.tissue_pressure(probes, self.column)

    def title(self):
        """The name, and what the mesh has there if it is something else."""
        return self.name + self.remark


def is_thin(scene, name):
    """Whether the elements leave holes in the layers of a tissue or a part, and
    so in what the run says of it; unknown of scenes before 0.2.0."""
    return bool(scene.biomechanics.found(
        "checks", "thin_" + name.replace(" ", "_")))


def holes(scene):
    """A sentence on the layers in which the elements leave holes; none on the
    spinal cord, which nothing is judged by."""
    found = [name.removeprefix("thin_").replace("_", " ")
             for name in scene.biomechanics.summary.get("checks") or {}
             if name.startswith("thin_") and name != "thin_spinal_cord"
             and is_thin(scene, name.removeprefix("thin_"))]
    return [f"The elements leave holes in {' and '.join(found)}: pressures and "
            "strains inside and the motion of the head are those of such a body; "
            "estimated errors do not include it (entry Scene/Element size)."] \
        if found else []


def thin_note(titles):
    """Explains the mark of titles that have it, or is empty."""
    return "" if not any(title.endswith(THIN) for title in titles) else (
        f"{THIN} The elements are too large for this tissue, which has holes "
        "or is in pieces: what happens there is of the mesh, not of a body.")


def find_places(scene):
    """The probes of biomechanics with names, marked where elements are too
    large for their tissues."""
    places, called = _named_places(scene), names(scene)
    for place in places:
        # The skull is a layer, but not the rest of the skeleton.
        if not place.remark and (
                is_thin(scene, called.get(place.tissue, ""))
                or place.name == "skull" and is_thin(scene, "skull")):
            place.remark = THIN
    return places


def brain_arrival(scene):
    """When the first wave reaches a probe in the brain [s]; None without one."""
    probes = scene.biomechanics.table("probes.csv")
    found = [] if probes is None else [
        signals.arrival(probes["time"], place.pressure(probes))
        for place in find_places(scene) if place.tissue == BRAIN]
    return min((time for time in found if time is not None), default=None)


def _named_places(scene):
    """With the names of scene.json; else the brain's nearest to the charge is
    "coup", its farthest "contrecoup"."""
    points = files.points_of(
        scene.biomechanics.parameters.get("Probes/Points"))
    if not len(points):
        return []
    given = [str(place.get("name"))
             for place in scene.list_of("tissue_places")]
    tissues, called = _tissues(scene, points), names(scene)
    if len(given) == len(points):
        return [_given_place(*known, called.get(known[-1], OTHER)) for known in
                zip(range(1, len(points) + 1), points, given, tissues)]
    places = [Place(number, point, tissue, called.get(tissue, "body"))
              for number, (point, tissue) in enumerate(zip(points, tissues), 1)]
    _name_brain(scene, places)
    known = scene.loads().places() if scene.loads() else {}
    of_person = person.axes(scene)
    left = np.eye(3)[1] if of_person is None else of_person[1]
    for place in places:
        if place.tissue == LUNG:
            place.name = ("left" if left @ place.point > 0. else "right") \
                + " lung"
        elif place.tissue in (SOFT, SKIN, SKELETON):
            _name_by_skin(place, known)
    for name in {place.name for place in places}:
        same = [place for place in places if place.name == name]
        for number, place in enumerate(same if len(same) > 1 else (), 1):
            place.name = f"{name} {number}"
    return places


def _given_place(number, point, name, found, called):
    """@p found is the tissue of the element there and what it is called:
    organs that are thinner than an element may have none."""
    title, tissue = GIVEN.get(name, (name, 0))
    place = Place(number, point, tissue, title)
    if 0 not in (found, tissue) and found != tissue:
        place.remark = f" (an element of {called})"
    return place


def _tissues(scene, points):
    """Tissue of the element with the nearest middle to each point."""
    best = np.full(len(points), np.inf)
    tissues = np.zeros(len(points), dtype=int)
    fields = scene.field_list()
    for piece in fields[0][1] if fields else ():
        mesh = scene.field([piece])[0]
        cells = mesh["connectivity"].reshape(-1, 8)
        # Elements are nearly cubes: two opposite corners give the middle.
        middles = 0.5 * (mesh["points"][cells[:, 0]]
                         + mesh["points"][cells[:, 6]])
        for i, point in enumerate(points):
            square = np.sum((middles - point) ** 2, axis=1)
            nearest = int(np.argmin(square))
            if square[nearest] < best[i]:
                best[i] = square[nearest]
                tissues[i] = mesh["tissue"][nearest]
    return tissues


def _name_brain(scene, places):
    brain = [place for place in places if place.tissue == BRAIN]
    charge = scene.charge_place()
    if len(brain) < 2 or charge is None:
        return
    middle = np.mean([place.point for place in brain], axis=0)
    way = charge - middle
    way[2] = 0.
    brain.sort(key=lambda place: -np.dot(place.point - middle, way))
    for place in brain:
        place.name = "brain, inside"
    brain[0].name, brain[-1].name = "brain, coup", "brain, contrecoup"


def _name_by_skin(place, known):
    """Soft tissue at the chest, skull at the forehead."""
    if not known:
        return
    name = min(known, key=lambda key: np.linalg.norm(known[key]
                                                     - place.point))
    if np.linalg.norm(known[name] - place.point) < NEAR:
        place.name = f"{NAMES[place.tissue]} at the {name}"


def named(places, end):
    """The place whose name ends like this, or None."""
    return next((place for place in places if place.name.endswith(end)), None)
