# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""What reflects the blast wave to the probe beside the body."""

import math


def reflectors(scene):
    """Words for what adds reflections to the positive phase at the first probe:
    the ground, unless its reflection must come later, and the body."""
    return "the body" if _ground_is_late(scene) else "ground and body"


def _ground_is_late(scene):
    """Whether the ground's reflection arrives after the positive phase, even
    with the mean speed of the direct wave, which is faster than any later
    part of its path."""
    charge, probe = scene.charge_place(), scene.probe_place(1)
    arrival, duration = (scene.blast.found("results", "probe_1_" + name)
                         for name in ("arrival", "duration"))
    if charge is None or probe is None or not arrival or not duration:
        return False
    direct = math.dist(charge, probe)
    mirrored = math.hypot(*(charge - probe)[:2], charge[2] + probe[2])
    return arrival * mirrored / max(direct, 1e-300) > arrival + duration
