# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A body from four sides whose surface is known by its facets alone: a centre,
a normal and an area each, and its outline by their corners."""

import functools
import itertools

import numpy as np
from PIL import Image, ImageDraw

from plot.readers.loads import mirror_planes

# Name of a view, axes of the person (front, left, up) to the right and up with
# signs, and the axis of depth with the sign that points to the eye.
VIEWS = [("front", (1, 1), (2, 1), (0, 1)), ("left", (0, -1), (2, 1), (1, 1)),
         ("back", (1, -1), (2, 1), (0, -1)),
         ("right", (0, 1), (2, 1), (1, -1))]
# Names of the sides of a body that has none of its own.
NAMELESS = ("from +x", "from +y", "from −x", "from −y")
GAP = 0.06  # between two views, over the height
# By which the load on another side exceeds that on the front, with face and
# chest, where it counts as larger.
MORE = 1.1
# Pixels in the width of the largest facet, at most: more show its edge alone.
FINEST = 40.
BARE = 0.75  # grey of skin without gas


@functools.lru_cache(maxsize=2)
def views_of(loads, folder, axes=NAMELESS):
    """Those of the body whose loads a run in @p folder recorded; None without
    any, or in two dimensions. @p axes: those of the person as rows of tuples;
    NAMELESS for a body without."""
    if loads is None or loads.is_flat or not len(loads.areas):
        return None
    return BodyViews(loads, mirror_planes(folder, loads.centroids), axes=axes)


class BodyViews:
    """The body from four sides, each with what facets its pixels show."""

    def __init__(self, loads, planes, pixels=560, axes=NAMELESS):
        centroids, normals, areas = loads.centroids, loads.normals, loads.areas
        vertices, outlines = loads.vertices, loads.outlines
        self.axes = np.eye(3) if axes is NAMELESS else np.array(axes)
        self._names = NAMELESS if axes is NAMELESS else tuple(
            view[0] for view in VIEWS)
        self.normals = normals @ self.axes.T  # of what was recorded
        facets = np.arange(len(areas))
        for axis, place in planes:
            facets = np.concatenate([facets, facets])
            outlines = outlines + [one + len(vertices) for one in outlines]
            centroids = _with_image(centroids, axis, place)
            normals = _with_image(normals, axis, 0.)
            vertices = _with_image(vertices, axis, place)
        centroids, normals = centroids @ self.axes.T, normals @ self.axes.T
        self.low, self.high = centroids.min(axis=0), centroids.max(axis=0)
        spacing = _spacings(centroids, areas[facets])
        self.pixel = max((self.high - self.low)[2] / pixels,
                         spacing.max() / FINEST)
        self.sides = [
            _Side(view, self.low, self.high, self.pixel,
                  (centroids, normals, spacing, facets),
                  (vertices @ self.axes.T, outlines)) for view in VIEWS]

    def names(self):
        return self._names

    def extent(self):
        """Width and height of the picture of all views [m]."""
        height = self.side_extent(0)[1]
        widths = [self.side_extent(side)[0] for side in range(len(VIEWS))]
        return sum(widths) + (len(widths) - 1) * self._gap(), height

    def side_extent(self, side):
        rows, columns = self.sides[side].shape
        return columns * self.pixel, rows * self.pixel

    def labels(self):
        """Names of the views, and where their middles are [m]."""
        begin = 0.
        for side, name in enumerate(self.names()):
            width = self.side_extent(side)[0]
            yield name, begin + 0.5 * width
            begin += width + self._gap()

    def paint(self, values, norm, colours):
        """Red, green, blue of all views; values by facet."""
        gap = np.ones((self.sides[0].shape[0], int(self._gap() / self.pixel), 3))
        parts = []
        for side in self.sides:
            parts += [side.paint(values, norm, colours), gap]
        return np.concatenate(parts[:-1], axis=1)

    def paint_side(self, side, values=None, norm=None, colours=None):
        """The body alone, in grey without values by facet."""
        return self.sides[side].paint(values, norm, colours)

    def means(self, values):
        """Means of values by facet that all views show."""
        means = np.concatenate([side.mean(values[side.facets]).ravel()
                                for side in self.sides])
        return means[np.isfinite(means)]

    def bare_part(self):
        """Largest part of the body in a view that is skin without gas."""
        return max(np.count_nonzero(side.bare)
                   / max(np.count_nonzero(side.silhouette), 1)
                   for side in self.sides)

    def loaded_sides(self, loads):
        """The side towards which the facets with the largest loads look, and
        the one of both next to it with the larger load, see MORE."""
        towards = [np.maximum(view[3][1] * self.normals[:, view[3][0]], 0.)
                   @ loads for view in VIEWS]
        towards[0] *= MORE
        first = int(np.argmax(towards))
        return first, max(((first + 1) % 4, (first + 3) % 4),
                          key=lambda side: towards[side])

    def spot(self, side, point, even_hidden=False):
        """Where a point of the surface is in a view [m]; None where it cannot
        be seen, unless hidden ones are wanted, too."""
        return self.sides[side].spot(self.axes @ point, even_hidden)

    def nearer_side(self, sides, point):
        """The one of these sides that has a point nearest to the eye."""
        place = self.axes @ point - 0.5 * (self.low + self.high)
        return max(sides, key=lambda side:
                   VIEWS[side][3][1] * place[VIEWS[side][3][0]])

    def _gap(self):
        return GAP * (self.high - self.low)[2]


def _with_image(points, axis, place):
    """Points and their mirror images at the plane at a place normal to an
    axis."""
    image = points.copy()
    image[:, axis] = 2. * place - points[:, axis]
    return np.concatenate([points, image])


def _spacings(centroids, areas):
    """Distance between facets around each [m]: cells of one size have facets
    of all sizes up to that of the cell's face."""
    size = 4. * np.sqrt(np.percentile(areas, 95))
    _, number = np.unique(np.floor((centroids - centroids.min(axis=0)) / size),
                          axis=0, return_inverse=True)
    number = number.ravel()
    largest = np.zeros(number.max() + 1)
    np.maximum.at(largest, number, areas)
    return np.sqrt(largest[number]) / 1.1


def _close(picture, known, gaps):
    """Gives pixels in gaps the colour of one that is known next to them."""
    for _ in range(4):
        for step, axis in ((1, 0), (-1, 0), (1, 1), (-1, 1)):
            here = gaps & np.roll(known, step, axis)
            picture[here] = np.roll(picture, step, axis)[here]
            known, gaps = known | here, gaps & ~here


class _Side:
    """One view: which facets each pixel shows with what weight."""

    def __init__(self, view, low, high, pixel, patches, outline):
        centroids, normals, spacing, facets = patches
        _, self.right, self.up, self.depth = view
        self.low, self.high, self.pixel = low, high, pixel
        margin = np.max(spacing)
        # By which a place that is seen may lie behind the patches there [m].
        self.tolerance = max(0.02 * (high - low)[2], 0.5 * margin)
        self.origin = [
            -margin + (low[axis] if sign > 0 else -high[axis])
            for axis, sign in (self.right, self.up)]
        self.shape = tuple(
            int((high[axis] - low[axis] + 2. * margin) / pixel) + 1
            for axis in (self.up[0], self.right[0]))
        self.silhouette = self._fill(*outline)
        towards = self.depth[1] * normals[:, self.depth[0]]
        seen = towards > 0.
        self._spread(centroids[seen], normals[seen], spacing[seen],
                     facets[seen])
        vertices, outlines = outline
        hole = self.silhouette & (self.total.reshape(self.shape) == 0.) \
            & bool(outlines)
        near = [outlines[i] for i in np.flatnonzero(seen) if outlines]
        # Between patches; and where the eye would look into the body.
        self.gaps = hole & self._fill(vertices, near) & bool(near)
        self.bare = hole & ~self.gaps

    def _project(self, points):
        """Pixels, as rows and columns, and closeness to the eye [m]."""
        across = self.right[1] * points[:, self.right[0]] - self.origin[0]
        above = self.up[1] * points[:, self.up[0]] - self.origin[1]
        return ((above / self.pixel).astype(int),
                (across / self.pixel).astype(int),
                self.depth[1] * points[:, self.depth[0]])

    def _fill(self, vertices, outlines):
        """Which pixels the facets cover; all if their corners are unknown."""
        if not outlines:
            return np.ones(self.shape, bool)
        row, column, _ = self._project(vertices)
        image = Image.new("1", self.shape[::-1])
        canvas = ImageDraw.Draw(image)
        for corners in outlines:
            canvas.polygon(list(zip(column[corners].tolist(),
                                    row[corners].tolist())), 1, 1)
        return np.array(image)

    def _spread(self, centroids, normals, spacing, facets):
        """Lets every facet be a round patch with a soft edge, in its own plane
        and within the silhouette; of patches one behind the other the nearest
        shows."""
        first = np.cross(normals, np.eye(3)[np.abs(normals).argmin(axis=1)])
        first /= np.linalg.norm(first, axis=1)[:, None]
        second = np.cross(normals, first)
        reach = 0.9
        count = int(np.ceil(2. * reach * spacing.max(initial=0.)
                            / self.pixel)) + 2
        steps = np.linspace(-reach, reach, max(count, 3))
        found = []
        for s, t in itertools.product(steps, steps):
            if s * s + t * t > reach * reach:
                continue
            points = centroids + spacing[:, None] * (s * first + t * second)
            row, column, close = self._project(points)
            inside = ((row >= 0) & (row < self.shape[0]) & (column >= 0)
                      & (column < self.shape[1]))
            inside[inside] = self.silhouette[row[inside], column[inside]]
            found.append(((row * self.shape[1] + column)[inside], close[inside],
                          np.full(np.count_nonzero(inside),
                                  np.exp(-4. * (s * s + t * t))),
                          np.flatnonzero(inside)))
        pixels, closeness, weights, numbers = map(np.concatenate, zip(*found))
        nearest = np.full(self.shape[0] * self.shape[1], -np.inf)
        np.maximum.at(nearest, pixels, closeness)
        shown = closeness > nearest[pixels] - 1.2 * spacing[numbers]
        self.pixels, self.weights = pixels[shown], weights[shown]
        self.facets = facets[numbers[shown]]
        self.nearest = nearest.reshape(self.shape)
        self.total = np.bincount(self.pixels, self.weights, nearest.size)
        self.light = self._shade(normals, numbers[shown])

    def mean(self, values):
        """Weighted mean in each pixel of values by patch."""
        known = np.isfinite(values)
        sums, total = (np.bincount(self.pixels[known], weights[known],
                                   self.total.size)
                       for weights in (self.weights * values, self.weights))
        with np.errstate(invalid="ignore", divide="ignore"):
            return (sums / total).reshape(self.shape)

    def _shade(self, normals, numbers):
        """Brightness of a body that is lit from above and left of the eye."""
        lamp = np.zeros(3)
        for (axis, sign), size in ((self.depth, 0.8), (self.up, 0.45),
                                   (self.right, -0.4)):
            lamp[axis] = size * sign
        normal = np.stack([self.mean(normals[numbers, d]) for d in range(3)])
        with np.errstate(invalid="ignore"):
            normal /= np.linalg.norm(normal, axis=0)
        return 0.62 + 0.38 * np.clip(np.tensordot(lamp, normal, 1), 0., 1.)

    def paint(self, values, norm, colours):
        """Red, green, blue; grey without values, BARE of skin without gas,
        white next to the body."""
        picture = np.ones(self.shape + (3,))
        body = self.total.reshape(self.shape) > 0.
        grey = np.full(self.shape + (3,), 0.8)
        if values is not None:
            mean = self.mean(values[self.facets])
            known = np.isfinite(mean)
            grey[known] = colours(norm(mean[known]))[:, :3]
        picture[body] = (grey * self.light[:, :, None])[body]
        _close(picture, body, self.gaps)
        picture[self.bare] = BARE
        return picture

    def spot(self, point, even_hidden):
        row, column, close = (x[0] for x in self._project(point[None, :]))
        if even_hidden:
            row, column = np.clip((row, column), 0, np.array(self.shape) - 1)
        elif (not (0 <= row < self.shape[0] and 0 <= column < self.shape[1])
              or close < self.nearest[row, column] - self.tolerance):
            return None
        return (column + 0.5) * self.pixel, (row + 0.5) * self.pixel
