# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Polygons in which planes cut hexahedra and particles."""

import numpy as np

# Six tetrahedra around a diagonal of a hexahedron, whose corners are numbered
# as binary digits of z, y, x, which is how fields have them.
TETRAHEDRA = np.array([(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7),
                       (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)])


def cut_particles(points, axis, is_mirror, spacing, shown):
    """Squares around the layer of particles next to a plane through the origin
    normal to @p axis, and their numbers."""
    distance = points[:, axis] if is_mirror else \
        np.abs(points[:, axis] - 0.25 * spacing)
    owners = np.flatnonzero(distance < spacing * (1. if is_mirror else 0.5))
    square = 0.53 * spacing * np.array([(-1., -1.), (1., -1.), (1., 1.),
                                        (-1., 1.)])
    return points[owners][:, None][:, :, shown] + square, owners


def cut_hexahedra(corners, axis, place, shown):
    """Quadrangles, triangles with their last corner twice, in which a plane
    normal to @p axis cuts hexahedra, and the hexahedra that they belong to;
    @p corners are hexahedra x 8 x 3, in the order of the files, @p shown the
    two axes that are kept."""
    distance = corners[:, :, axis] - place
    near = np.flatnonzero((distance.min(axis=1) <= 0.)
                          & (distance.max(axis=1) > 0.))
    points = corners[near][:, TETRAHEDRA].reshape(-1, 4, 3)
    side = distance[near][:, TETRAHEDRA].reshape(-1, 4)
    owners = np.repeat(near, len(TETRAHEDRA))
    # Corners behind the plane first.
    order = np.argsort(side > 0., axis=1, kind="stable")
    side = np.take_along_axis(side, order, axis=1)
    points = np.take_along_axis(points, order[:, :, None], axis=1)
    count = (side > 0.).sum(axis=1)
    found, owned = [], []
    for number, edges in ((1, ((0, 3), (1, 3), (2, 3), (2, 3))),
                          (2, ((0, 2), (0, 3), (1, 3), (1, 2))),
                          (3, ((0, 1), (0, 2), (0, 3), (0, 3)))):
        here = count == number
        ends = []
        for a, b in edges:
            part = side[here, a] / (side[here, a] - side[here, b])
            ends.append(points[here, a]
                        + part[:, None] * (points[here, b] - points[here, a]))
        found.append(np.stack(ends, axis=1)[:, :, list(shown)])
        owned.append(owners[here])
    return np.concatenate(found), np.concatenate(owned)


def volumes(corners):
    """Volumes of hexahedra."""
    points = corners[:, TETRAHEDRA]
    first, second, third = (points[:, :, i] - points[:, :, 0]
                            for i in range(1, 4))
    return np.abs(np.sum(np.cross(first, second) * third, axis=2)
                  ).sum(axis=1) / 6.
