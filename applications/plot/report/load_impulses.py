# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The impulse of the recorded loads, and what the elements get of it."""

import math

# Least difference of impulses that is told, as a part of the largest one.
NOTABLE = 0.02


def along(scene):
    """The recorded impulse of the whole body when it is largest and, along its
    direction, that on the elements [N s], or the sums of the magnitudes of both
    where pushes cancel; None without loads."""
    recorded, mapped = (scene.biomechanics.found(
        "checks", f"loads_largest_{name}_impulse")
                        for name in ("recorded", "mapped"))
    return (recorded, mapped or 0.) if recorded else None


def kind(scene):
    """Comparison by along(), in words: when, and along what."""
    return ("at the end in magnitudes, as pushes from opposite sides cancel", "") \
        if scene.biomechanics.found("checks", "loads_pushes_cancel") else \
        ("when it is largest", " along it")


def pushes_left(scene):
    """Rest of pushes that cancel, when it is largest, recorded and on the
    elements [N s]; None where they do not, or in scenes before 0.2.0."""
    found = [scene.biomechanics.found("checks", f"loads_largest_{name}_push")
             for name in ("recorded", "mapped")]
    return None if None in found else tuple(found)


def rest(scene):
    """Recorded impulse of the whole body at the end of the record and that on
    the elements, vectors [N s]; None where they are unknown or agree within
    NOTABLE of the largest one."""
    found = [[scene.biomechanics.found("checks", f"loads_{name}_impulse_{axis}")
              for axis in "xyz"] for name in ("recorded", "mapped")]
    largest = along(scene)
    if largest is None or None in found[0] + found[1] \
            or math.dist(*found) <= NOTABLE * largest[0]:
        return None
    return tuple(found)


def difference_of_motion(scene):
    """difference() of what moves the body as a whole; infinite where nothing
    was left of the recorded pushes."""
    if pushes_left(scene) is None:
        return difference(scene)
    recorded, mapped = pushes_left(scene)
    change = abs(mapped - recorded)
    return change / recorded if recorded else math.inf if change else 0.


def difference(scene):
    """By how much the impulse on the elements differs from the recorded one, as
    a part of that; 0 without loads. It is not 0 where the surfaces differ by
    too much for a correction, as those of the coarser run may as well: then
    the difference of both runs does not show it."""
    found = along(scene)
    return 0. if found is None else abs(found[1] / found[0] - 1.)
