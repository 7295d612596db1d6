# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Loads on a rigid body: loads.h5."""

import os

import numpy as np

from plot.readers import files, formats


class Loads:
    """The facets of a body and what the blast did to each."""

    def __init__(self, path):
        import h5py  # which runs without a body do not need
        self.file = h5py.File(path, "r")
        if "format" in self.file.attrs:
            formats.require_readable("loads", int(
                self.file.attrs["format"].decode().split()[-1]))
        self.is_flat = self.file.attrs["units"].decode().startswith("m, m,")
        self.centroids, self.normals, self.areas, self.times = (
            self.file[name][:] for name in ("centroid", "normal", "area", "time"))
        self._check()
        self.vertices, self.outlines = self._corners()

    def _check(self):
        """Raises ValueError where data sets are missing or do not fit."""
        facets, times = len(self.areas), len(self.times)
        directions = self.centroids.shape[-1]
        wanted = {"centroid": (facets, directions),
                  "normal": (facets, directions), "area": (facets,),
                  "time": (times,), "overpressure": (facets, times),
                  "peak": (facets,), "arrival": (facets,),
                  "impulse": (facets,)}
        for name, shape in wanted.items():
            data = self.file.get(name)
            if data is None or data.shape != shape or data.dtype.kind != "f":
                raise ValueError(f'the data set "{name}" is missing or not '
                                 f"of {' x '.join(map(str, shape))} numbers")

    def _corners(self):
        """Vertices of facets in space [m], and those of each facet in order;
        none of either in files without. Raises ValueError for others."""
        if self.is_flat or "vertex" not in self.file:
            return np.zeros((0, 3)), []
        vertices, mixed = self.file["vertex"][:], self.file["connectivity"][:]
        outlines, begin = [], 0
        while begin + 2 <= len(mixed):
            end = begin + 2 + max(int(mixed[begin + 1]), 1)
            outlines.append(mixed[begin + 2:end])
            begin = end
        if begin != len(mixed) or len(outlines) != len(self.areas) or (
                outlines and not 0 <= mixed.min() <= max(
                    map(np.max, outlines)) < len(vertices)):
            raise ValueError("the corners of facets are not what they should be")
        return vertices, outlines

    def __contains__(self, name):
        return name in self.file

    def arrived(self):
        """Whether the blast reaches each facet."""
        return self.file["arrival"][:] > 0.

    def measure(self, name):
        """Values of all facets, not a number where the blast does not arrive;
        files of before have zeros there."""
        return np.where(self.arrived(), self.file[name][:], np.nan)

    def largest(self, name):
        """Value of a measure; 0 where the blast arrives nowhere."""
        return float(self.file[name][:].max(
            initial=0., where=self.arrived()))

    def cut_off(self):
        """Whether the record ends before the positive phase of each facet does;
        unknown of files without durations."""
        if "duration" not in self or not len(self.times):
            return np.zeros(len(self.areas), dtype=bool)
        ends = self.file["arrival"][:] + self.file["duration"][:]
        return self.arrived() & (ends >= (1. - 1e-9) * self.times[-1])

    def is_cut_off(self, name):
        """Whether the record cuts the phase where a measure is largest."""
        return len(self.areas) > 0 and bool(self.cut_off()[
            np.argmax(np.nan_to_num(self.measure(name)))])

    def first_arrival(self):
        """First arrival of the blast at any facet [s], or None."""
        times = self.file["arrival"][self.arrived()]
        return float(times.min()) if times.size else None

    def overpressure(self, time):
        """Sample that a time is in, for all facets."""
        return self.file["overpressure"][:, min(
            np.searchsorted(self.times, time), len(self.times) - 1)]

    def places(self):
        """Names and places of the gauges."""
        entries = self.file.attrs.get("gauges", b"").decode().split("; ")
        return {name: np.array([float(x) for x in numbers.split(",")])
                for name, numbers in (entry.split(":")
                                      for entry in filter(None, entries))}


def symmetry_planes(folder):
    """Planes of symmetry of a run: axis and place."""
    entries = files.read_parameters(os.path.join(folder, "parameters.prm"))
    return [(axis, float(entries[f"Domain/{corner}"].split(",")[axis]))
            for axis, name in enumerate("xyz")
            for side, corner in (("low", "Lower corner"),
                                 ("high", "Upper corner"))
            if entries.get(f"Boundaries/{name} {side}") == "symmetry"]


def mirror_planes(folder, centroids):
    """Planes of symmetry that cut the body of a run: axis and place."""
    size = np.ptp(centroids, axis=0).max()
    # The facets next to the plane are about half of their width away.
    near = max(0.02, 1. / np.sqrt(len(centroids))) * size
    return [(axis, place) for axis, place in symmetry_planes(folder)
            if np.abs(centroids[:, axis] - place).min() < near]
