# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The motion of a body as a whole."""

import numpy as np


class RigidMotion:
    """Translation and rotation of a deformable body: its mean velocity, and the
    angular velocity of its angular momentum about its centre of mass, which are
    those of least squares."""

    def __init__(self, places, velocities, masses):
        self.centre = np.average(places, axis=0, weights=masses)
        self.velocity = np.average(velocities, axis=0, weights=masses)
        away = places - self.centre
        inertia = (masses @ np.sum(away**2, axis=1)) * np.eye(3) \
            - (masses * away.T) @ away
        # Rotation of least norm, as points on one line have any about it.
        self.rotation = np.linalg.lstsq(
            inertia, masses @ np.cross(away, velocities), rcond=None)[0]

    def velocity_at(self, places):
        """Velocities of the rigid body at some places."""
        return self.velocity + np.cross(self.rotation, places - self.centre)
