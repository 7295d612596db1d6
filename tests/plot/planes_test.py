#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Plane cuts are read with their places, units and times."""

import functools
import os
import sys
import tempfile
import unittest
import unittest.mock
import zlib

import numpy as np

import tiny_files

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "applications"))

from plot.analysis import person  # noqa: E402
from plot.figures import anatomy_mesh, style  # noqa: E402
from plot.readers import fields, planes, vtk_file  # noqa: E402


class OutsideTest(unittest.TestCase):
    """A body is seen from its own sides, and from axes if it has none."""

    SIZE = (0.2, 0.5, 1.7)  # from front to back, side to side, of height [m]

    def views(self, entries):
        """Titles, and widths in twentieths of the height, of a plate that a
        stage turned."""
        faces = []
        for axis in range(3):
            for side in (0., 1.):
                face = np.zeros((4, 3))
                face[:, axis] = side
                face[[1, 2], (axis + 1) % 3] = 1.
                face[[2, 3], (axis + 2) % 3] = 1.
                faces.append((face * self.SIZE, (2. * side - 1.)
                              * np.eye(3)[axis]))
        axes = person.turned_axes(entries)
        mesh = {"points": np.concatenate([face for face, _ in faces]) @ axes,
                "connectivity": np.arange(24),
                "normal": np.stack([normal for _, normal in faces]) @ axes}
        shown = []

        def keep(figure, _):
            shown.extend((panel.get_title(), panel.images[0].get_extent())
                         for panel in figure.axes)
            style.plt.close(figure)
        with unittest.mock.patch.object(style, "save", keep), \
                unittest.mock.patch.object(
                    anatomy_mesh, "render", functools.partial(
                        anatomy_mesh.render, pixels=20)):
            anatomy_mesh.draw_outside(mesh, "none",
                                      person.axes_by_entries(entries))
        return [(title, round(20. * (extent[1] - extent[0])
                              / (extent[3] - extent[2])))
                for title, extent in shown]

    def test_turned(self):
        wanted = [("front", 6), ("left side", 4), ("back", 6)]
        for angles in ("0, 0, 0", "0, -90, 0", "0, 0, 90", "90, 0, -90"):
            self.assertEqual(self.views({
                "Body/Kind": "phantom", "Body/Rotation": angles}), wanted)
        for nameless in ({"Body/Kind": "shape"}, {"Body/Kind": "surface"}):
            self.assertEqual(self.views(nameless), [
                ("from +x", 6), ("from +y", 4), ("from −x", 6)])


class PlanesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.values = np.arange(12.).reshape(3, 4)

    def write(self, name, time, axes="xz", **fields_of):
        tiny_files.write_plane(
            os.path.join(self.folder, "fields", name),
            fields_of or {"pressure": (self.values + time, "Pa"),
                          "density": (2. * self.values, "kg/m^3")},
            [0.5, -1.], [3.5, 1.], time, axes, -0.4)

    def test_series(self):
        """Outputs of a plane are one list for each quantity, by time."""
        for number, time in ((12, 3.), (2, 1.)):
            self.write(f"plane_y_0_{number:04d}.vti", time)
        found = planes.open_planes(self.folder)
        self.assertEqual(set(found), {"plane_y_0_pressure",
                                      "plane_y_0_density"})
        first, last = found["plane_y_0_pressure"]
        self.assertEqual((first.time, last.time), (1., 3.))
        self.assertEqual((first.unit, first.axes), ("Pa", ["x", "z"]))
        self.assertEqual(first.place, -0.4)
        self.assertEqual((first.lower, first.upper), ([0.5, -1.], [3.5, 1.]))
        np.testing.assert_array_equal(last.values, self.values + 3.)
        self.assertEqual(first.extent(), [0., 4., -1.5, 1.5])

    def test_maps(self):
        """Maps and planes of gauges stand alone; axes are as in the file."""
        peak = {"peak_overpressure": (self.values, "Pa")}
        self.write("plane_maps.vti", 1., "xy", **peak)
        self.write("gauges_plane_1.vti", 1., "yz", **peak)
        found = planes.open_planes(self.folder)
        self.assertEqual(set(found), {"plane_peak_overpressure",
                                      "gauges_plane_1_peak_overpressure"})
        self.assertEqual(found["plane_peak_overpressure"][0].axes, ["x", "y"])
        self.assertEqual(
            found["gauges_plane_1_peak_overpressure"][0].axes, ["y", "z"])

    def test_read(self):
        """Arrays are read with and without a unit, as text and as bytes."""
        path = os.path.join(self.folder, "arrays.vtp")
        arrays = [("points", np.arange(6.), 3, "m"),
                  ("part", np.arange(4, dtype=np.uint8), 1, "")]
        tiny_files.write(path, tiny_files.elements(arrays))
        found = vtk_file.read(path)
        np.testing.assert_array_equal(found["points"],
                                      np.arange(6.).reshape(2, 3))
        np.testing.assert_array_equal(found["part"], np.arange(4))
        block = zlib.compress(np.arange(6.).tobytes())
        with open(path, "wb") as file:
            file.write(
                b'<VTKFile header_type="UInt64">\n<DataArray type="Float64" '
                b'NumberOfComponents="3" Name="points" format="appended" '
                b'offset="0"/>\n<AppendedData encoding="raw">\n_'
                + np.array([1, 48, 0, len(block)], np.uint64).tobytes()
                + block + b"\n</AppendedData>\n</VTKFile>\n")
        np.testing.assert_array_equal(vtk_file.read(path)["points"],
                                      found["points"])

    def test_cut(self):
        """A plane cuts cells in polygons that fill its section, also where
        their edges are oblique to it."""
        x, y, z = (axis.ravel() for axis in np.meshgrid(
            *[np.arange(3.)] * 3, indexing="ij"))
        first = [9 * i + 3 * j + k for i in (0, 1) for j in (0, 1)
                 for k in (0, 1)]
        connectivity = np.array([[corner + step for step in (
            0, 9, 12, 3, 1, 10, 13, 4)] for corner in first])
        for angle in (0., 0.5):
            cosine, sine = np.cos(angle), np.sin(angle)
            points = np.stack([cosine * x - sine * y, sine * x + cosine * y,
                               z], axis=1)
            mesh = {"points": points, "connectivity": connectivity.ravel()}
            for normal, place, area in (
                    (1, 0.9, 2. * min(2. / cosine, 0.9 * (
                        1. / cosine / sine) if sine else 9.)), (2, 0.5, 4.)):
                shape, found = fields.cut(mesh, place, normal)
                u, v = shape[:, :, 0], shape[:, :, 1]
                areas = 0.5 * np.abs((u * np.roll(v, -1, 1)
                                      - np.roll(u, -1, 1) * v).sum(axis=1))
                self.assertAlmostEqual(areas.sum(), area, 6)
                self.assertEqual(len(shape), len(found))
                if normal == 2 or not angle:
                    self.assertEqual(len(found), 4)

    def test_collection(self):
        """Planes and skin of a collection are not taken for volumes."""
        with open(os.path.join(self.folder, "fields.pvd"), "w",
                  encoding="utf-8") as file:
            for part, name in enumerate(("gas_0000.vtu", "plane_0000.vti",
                                         "skin_0000.vtp")):
                file.write(f'<DataSet timestep="0.5" group="" part="{part}" '
                           f'name="it" file="fields/{name}"/>\n')
        self.assertEqual(fields.list_fields(self.folder), [
            (0.5, [os.path.join(self.folder, "fields/gas_0000.vtu")])])


if __name__ == "__main__":
    unittest.main()
