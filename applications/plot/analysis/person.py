# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Who is in a scene, and which way the person faces, as scene.json has it."""

import re

import numpy as np

# By the side of the person that is turned to the charge: where the charge is.
WHERE = {"front": "in front of", "left side": "to the left of",
         "back": "behind", "right side": "to the right of",
         "head": "beyond the head of", "feet": "beyond the feet of"}


def part_at(gauge):
    """The part of the body that a gauge's name has as its last word: "ear" of
    "left ear", not of "rear"."""
    return re.split(r"[\W_]", gauge)[-1]


def axes(scene):
    """Where the person's front, left side and head point to, as rows; None of a
    body without sides of its own."""
    known = scene.facts.get("person") or {}
    found = [known.get(name) for name in ("forward", "left", "up")]
    return None if None in found else np.array(found)


def is_person(scene):
    """Whether the body is a whole person, who stands, sits or lies."""
    return "posture" in (scene.facts.get("person") or {})


def words(scene):
    """The person in words: "a standing person of 1.756 m and 78.5 kg"."""
    known = (scene.facts.get("person") or {}).get("description")
    return known or f"a body ({scene.facts.get('body') or 'unknown'})"


def place_of_charge(scene):
    """Where the charge is, seen from the person: "in front of", or "from" where
    that is unknown."""
    return WHERE.get(side_to_charge(scene), "from")


def side_to_charge(scene):
    """The side of the person that is turned to the charge; None of a body
    without sides of its own."""
    return (scene.facts.get("person") or {}).get("side_to_charge")


def plane_normal_to(scene, axis):
    """What anatomy calls the plane through the body that is normal to an axis
    of the scene: "sagittal" and the like; "" if it has no name."""
    known = axes(scene)
    if known is None:
        return ""
    along = np.abs(known[:, axis])
    return ("coronal", "sagittal", "transverse")[int(along.argmax())] \
        if along.max() > 0.99 else ""
