# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The impulse of the recorded loads, and what the elements get of it."""


def largest(scene):
    """Axis with the largest recorded impulse, that impulse and the one on the
    elements [N s]; None without loads."""
    found = {axis: [scene.biomechanics.found(
        "checks", f"loads_{name}_impulse_{axis}")
                    for name in ("recorded", "mapped")] for axis in "xyz"}
    known = {axis: pair for axis, pair in found.items()
             if pair[0] and pair[1] is not None}
    if not known:
        return None
    axis = max(known, key=lambda axis: abs(known[axis][0]))
    return axis, *known[axis]
