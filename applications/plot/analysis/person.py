# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Who is in a scene, and which way the person faces, as scene.json has it."""

import re

import numpy as np

from plot.readers import files

# By the side of the person that is turned to the charge: where the charge is.
WHERE = {"front": "in front of", "left side": "to the left of",
         "back": "behind", "right side": "to the right of",
         "head": "beyond the head of", "feet": "beyond the feet of"}
# Bodies that face +x before Body/Rotation.
WITH_SIDES = ("phantom", "image", "surface")
# The parasagittal plane: so far from the middle [m], but at most such a part of
# the body's half width, which matters for a head alone.
BESIDE = 0.0801
MOST_BESIDE = 0.4


def part_at(gauge):
    """The part of the body that a gauge's name has as its last word: "ear" of
    "left ear", not of "rear"."""
    return re.split(r"[\W_]", gauge)[-1]


def axes(scene):
    """Where the person's front, left side and head point to, as rows; None of a
    body without sides of its own. For stages that were run one by one they are
    by their entries."""
    known = scene.facts.get("person") or {}
    entries = scene.biomechanics.parameters
    if not scene.facts and entries.get("Mesh/Kind") == "body":
        return axes_by_entries(entries)
    found = [known.get(name) for name in ("forward", "left", "up")]
    return None if None in found else np.array(found)


def axes_by_entries(entries):
    """The same by the entries of a stage that has a body; None of one without
    sides that are known."""
    kind = entries.get("Body/Kind")
    has_sides = kind in WITH_SIDES and (
        kind != "surface" or
        entries.get("Body/Surface/Organs", "none") != "none")
    return turned_axes(entries) if has_sides else None


def turned_axes(entries):
    """Where front, left side and top of a body point to by the entry
    Body/Rotation of a stage, as rows."""
    angles = files.points_of(entries.get("Body/Rotation"))
    axes_found = np.eye(3)
    for axis, angle in enumerate(np.radians(angles[0]) if len(angles) else ()):
        turned = np.ix_(*[[(axis + 1) % 3, (axis + 2) % 3]] * 2)
        turn = np.eye(3)
        turn[turned] = [[np.cos(angle), -np.sin(angle)],
                        [np.sin(angle), np.cos(angle)]]
        axes_found = axes_found @ turn.T
    # Quarters of a turn are exact.
    return np.where(np.abs(axes_found) < 1e-12, 0., axes_found)


def is_person(scene):
    """Whether the body is a whole person, who stands, sits or lies."""
    return "posture" in (scene.facts.get("person") or {})


def words(scene):
    """The person in words: "a standing person of 1.756 m and 78.5 kg"."""
    return (scene.facts.get("person") or {}).get("description") \
        or f"a body ({scene.facts.get('body') or 'unknown'})"


def place_of_charge(scene):
    """Where the charge is, seen from the person: "in front of", or "from" where
    that is unknown."""
    return WHERE.get(side_to_charge(scene), "from")


def azimuth_of_charge(scene):
    """The direction of the charge in words, "28 degrees to the left of where
    the person faces"; "" where it is straight ahead, behind or to a side or, so
    that such an angle says nothing, along the body's long axis."""
    angle = _angle(scene, "azimuth")
    if side_to_charge(scene) in ("head", "feet") or angle % 90 == 0:
        return ""
    return (f"{_degrees(angle)} to the {'left' if angle > 0 else 'right'} of "
            "where the person faces")


def elevation_of_charge(scene):
    """The same along the body's long axis; "" where it is level with the middle
    of the body."""
    angle = _angle(scene, "elevation")
    is_lying = (scene.facts.get("person") or {}).get("posture") == "lying"
    side = f"towards the {'head' if angle > 0 else 'feet'} from" if is_lying \
        else "above" if angle > 0 else "below"
    return f"{_degrees(angle)} {side} the middle of the body" if angle else ""


def _angle(scene, name):
    return round((scene.facts.get("person") or {}).get("charge_" + name) or 0.)


def _degrees(angle):
    return f"{abs(angle)} degree" + "s" * (abs(angle) != 1)


def side_to_charge(scene):
    """The side of the person that is turned to the charge; None of a body
    without sides of its own."""
    return (scene.facts.get("person") or {}).get("side_to_charge")


class Frame:
    """The axes of the body itself, front, left and up as rows, and the plane that
    cuts are parallel to: the sagittal one through a person's brain, y = 0 of a
    body without sides of its own."""

    def __init__(self, scene, points, brain):
        """@p brain: those of the points that are corners of its elements."""
        known = axes(scene)
        self.is_person = known is not None
        self.axes = known if self.is_person else np.eye(3)
        own = points @ self.axes.T
        self.height = np.ptp(own[:, 2])
        left = own[:, 1]
        self.half_width = 0.5 * np.ptp(left)
        if self.is_person:
            left = brain @ self.axes[1] if len(brain) else left
        elif left.min() <= 0. < left.max():
            left = np.zeros(1)
        self.middle = 0.5 * float(left.min() + left.max())
        if abs(self.middle) < 1e-3 * self.half_width:
            self.middle = 0.

    def beside(self):
        """How far the parasagittal plane is from the middle [m]."""
        return min(BESIDE, MOST_BESIDE * self.half_width)

    def is_upright(self):
        return self.axes[2, 2] > 0.99

    def place_in_words(self, beside):
        """Where the plane is so far [m] to the left of the middle: "y = 0", or
        "0.08 m to the left"; "" of the middle of a body that is turned by other
        than quarters."""
        along = np.abs(self.axes[1])
        axis = int(along.argmax())
        if along[axis] < 0.9999:
            return f"{beside:.2g} m to the left" if beside else ""
        place = np.sign(self.axes[1, axis]) * (self.middle + beside)
        return f"{'xyz'[axis]} = {place + 0.:.2g}".replace("-", "−") \
            + " m" * bool(place)
