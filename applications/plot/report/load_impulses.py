# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The impulse of the recorded loads, and what the elements get of it."""

import math
import operator

LARGEST_CORRECTION = 0.1  # of Loads/Recorded/Keep impulse


def along(scene):
    """The recorded impulse of the whole body and, along its direction, that on
    the elements [N s]; None without loads."""
    recorded, mapped = ([scene.biomechanics.found(
        "checks", f"loads_{name}_impulse_{axis}") or 0. for axis in "xyz"]
                        for name in ("recorded", "mapped"))
    size = math.hypot(*recorded)
    return (size, sum(map(operator.mul, recorded, mapped)) / size) \
        if size else None
