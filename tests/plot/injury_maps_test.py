#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Maps of injuries in planes of gauges: what is drawn, and what is hidden."""

import os
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

import tiny_files
import tiny_scene

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.dirname(os.path.abspath(__file__)))), "applications"))

from plot.figures import blast_maps, injury_maps, style  # noqa: E402
from plot.readers import planes  # noqa: E402
from plot.readers.scene import Scene  # noqa: E402
from plot.report import blast_sections, injury_table  # noqa: E402

# 5 by 3 gauges, 0.5 m apart: measures fall along x; the wave is not simple at
# the first, and has not reached the last.
ALONG = np.array([1., 0.99, 0.6, 0.1, 0.])


def fields():
    def grid(values):
        return np.tile(np.asarray(values, float), (3, 1))
    return {"peak_overpressure": (grid(2e5 * ALONG), "Pa"),
            "impulse": (grid(100. * ALONG), "Pa s"),
            "arrival": (grid([1e-3, 2e-3, 3e-3, 4e-3, 0.]), "s"),
            "duration": (grid(2e-3 * np.ones(5)), "s"),
            "eardrum_rupture": (grid(ALONG), "-"),
            "lung_exposure": (grid(2. * ALONG), "-"),
            "lung_lethality": (
                grid([np.nan, *(0.98 * ALONG[1:])]), "-"),
            "chest_wall_velocity": (grid([np.nan, 9., 5., 1., 0.]), "m/s"),
            "first_phase_fraction": (grid([0.6, 1., 1., 1., 1.]), "-")}


class InjuryMapsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, found, folder=None):
        tiny_files.write_plane(
            os.path.join(folder or self.folder, "fields",
                         "gauges_plane_1.vti"), found, [0., 0.], [2., 1.], 5e-3)

    def maps(self, found):
        self.write(found)
        return blast_maps.take_maps(planes.open_planes(self.folder))

    def test_limits_of_areas(self):
        """By the coarser run; within the plane, and not below nothing."""
        tiny_scene.write_all(self.folder)
        self.write(fields(), os.path.join(self.folder, "blast"))
        people = blast_sections.people

        def told():
            return "".join(map(str, people(Scene(self.folder))))
        self.assertIn("error of these areas is unknown.", told())
        self.assertIn("as if nobody but the meshed person were there, who "
                      "reflects the wave and shields from it", told())
        with unittest.mock.patch.object(Scene, "loads", lambda _: None):
            self.assertIn("as if nobody were there: ", told())
        coarser = fields()
        coarser["eardrum_rupture"][0][:, 2] = 0.
        coarser["lung_lethality"][0][:] = 0.
        self.write(coarser, os.path.join(self.folder, "coarser_blast"))
        self.assertIn("eardrums would rupture on at least 1.25 m² (it continues "
                      "beyond the plane, by the numerics at least 0.449 m², "
                      "unknown on a further 0.250 m²)", told())
        self.assertIn("people would die on at least 1.00 m² (it continues beyond "
                      "the plane, by the numerics at least 0 m², unknown on a "
                      "further 0.500 m²)", told())
        self.assertIn("4 psi are exceeded on at least 1.25 m² (it continues beyond "
                      "the plane, by the numerics at least 1.23 m², unknown on a "
                      "further 0.250 m²)", told())
        # Places that one of both does not know are no difference between them.
        coarser["lung_lethality"][0][:, 1:3] = np.nan
        self.write(coarser, os.path.join(self.folder, "coarser_blast"))
        self.assertIn("people would die on at least 1.00 m² (it continues beyond "
                      "the plane, error unknown: the coarser run knows other "
                      "places, unknown", told())

    def test_map_beside_a_verdict_by_the_skin(self):
        """Both are told where the verdict has another load than the map."""
        tiny_scene.write_all(self.folder)
        self.write(fields(), os.path.join(self.folder, "blast"))
        scene = Scene(self.folder)
        plane = next(iter(scene.gauge_planes().values()))["impulse"]
        centre = np.array([0. if axis in plane.axes else plane.place
                           for axis in "xyz"])
        for basis, told in (("skin", ", 1.00\u00a0m, deaths by lung injury in the map "
                             "are 59\u00a0% to 97\u00a0%: of the wave in the open."),
                            ("probe", None)):
            with unittest.mock.patch.object(
                    injury_table, "lungs_by", lambda _: basis), \
                    unittest.mock.patch.object(
                        Scene, "charge_place", lambda _: centre), \
                    unittest.mock.patch.dict(scene.facts, {
                        "distance": 1., "tables": {}}):
                page = "".join(map(str, blast_sections.people(scene)))
            self.assertEqual("The verdict on the person is by" in page, bool(told))
            self.assertIn(told or "", page)

    def test_areas_within_the_plane(self):
        """What ends before each side that is no plane of symmetry."""
        maps = self.maps(fields())["gauges_plane_1"]
        plane = maps["eardrum_rupture"]
        plane.values = np.zeros_like(plane.values)
        self.assertFalse(injury_maps.goes_beyond(maps, "eardrum_rupture", 0.5))
        plane.values[0, 1] = 1.
        self.assertTrue(injury_maps.goes_beyond(maps, "eardrum_rupture", 0.5))
        plane.mirror([("xyz".index(plane.axes[1]), plane.lower[1])])
        self.assertFalse(injury_maps.goes_beyond(maps, "eardrum_rupture", 0.5))

    def test_groups(self):
        """Injuries, where there are any, stand next to maps of the blast."""
        groups = self.maps(fields())
        self.assertEqual(set(groups["gauges_plane_1"]), set(fields()))
        self.assertTrue(injury_maps.are_in(groups["gauges_plane_1"]))
        plain = {name: values for name, values in fields().items()
                 if name in blast_maps.QUANTITIES}
        self.assertFalse(
            injury_maps.are_in(self.maps(plain)["gauges_plane_1"]))

    def test_area(self):
        """Each gauge stands for what is nearer to it than to others."""
        maps = self.maps(fields())["gauges_plane_1"]
        self.assertAlmostEqual(
            injury_maps.area_above(maps, "eardrum_rupture", 0.5),
            2.5 * 0.5 * 1.)
        self.assertAlmostEqual(
            injury_maps.area_above(maps, "chest_wall_velocity", 6.), 0.5)
        self.assertAlmostEqual(injury_maps.area(maps), 2.)

    def test_area_beside_a_plane_of_symmetry(self):
        """It counts on both sides, where the plane ends at it."""
        plane = next(iter(self.maps(fields())["gauges_plane_1"].values()))
        for planes_of_symmetry, copies in (
                ([], 1), ([(2, 0.)], 2), ([(2, 0.1), (1, 0.)], 1),
                ([(0, 2.), (2, 0.)], 4)):
            plane.copies = 1
            plane.mirror(planes_of_symmetry)
            self.assertEqual(plane.copies, copies, planes_of_symmetry)
        self.assertAlmostEqual(injury_maps.area({"any": plane}), 8.)
        tiny_scene.write_all(self.folder)
        self.write(fields(), os.path.join(self.folder, "blast"))
        with open(os.path.join(self.folder, "blast", "parameters.prm"), "a",
                  encoding="utf-8") as file:
            file.write("subsection Boundaries\n  set z low = symmetry\nend\n"
                       "subsection Domain\n  set Lower corner = -1, -1, 0\n"
                       "end\n")
        told = "".join(map(str, blast_sections.people(Scene(self.folder))))
        self.assertIn("in the plane y = 0 m of gauges (4.00 m² with its mirror "
                      "image), as if", told)
        self.assertIn("4 psi are exceeded on at least 2.50 m² (it continues "
                      "beyond the plane, unknown on a further 0.500 "
                      "m²). ", told)

    def test_area_unknown(self):
        """Neither where the blast has not arrived is anything known, nor of
        lungs where the wave is not simple."""
        found = fields()
        found["arrival"][0][:, 4] = np.nan
        found["eardrum_rupture"][0][:, 4] = np.nan
        maps = self.maps(found)["gauges_plane_1"]
        self.assertAlmostEqual(
            injury_maps.area_unknown(maps, "eardrum_rupture"), 0.25)
        self.assertAlmostEqual(
            injury_maps.area_unknown(maps, "lung_lethality"), 0.5)

    def drawn(self, found, own=None):
        style.set_up()
        figures = []
        with unittest.mock.patch.object(
                style, "save", lambda figure, _: figures.append(figure)):
            injury_maps.draw(self.maps(found)["gauges_plane_1"], None, own)
        self.addCleanup(style.plt.close, figures[0])
        axes = [axis for axis in figures[0].axes if axis.images]
        return {axis.get_title(loc="left"): axis for axis in axes}

    def test_hides_what_is_not_known(self):
        panels = self.drawn(fields())
        self.assertEqual(list(panels),
                         [title for title, _ in injury_maps.PANELS.values()])

        def shown(title):
            values = np.ma.filled(panels[title].images[0].get_array(), np.nan)
            return np.isfinite(values[0]).tolist()

        self.assertEqual(shown("rupture of an eardrum"), [True] * 4 + [False])
        self.assertEqual(shown("death by lung injury"),
                         [False] + [True] * 3 + [False])
        self.assertEqual(shown("chest wall under side-on pressure"),
                         [False] + [True] * 3 + [False])

    def test_names_levels(self):
        """Lines of 1, 50 and 99 %, and of 4 psi."""
        panels = self.drawn(fields())
        words = {title: {text.get_text() for text in axis.texts}
                 for title, axis in panels.items()}
        self.assertLessEqual(words["death by lung injury"],
                             {"1 %", "50 %", "99 %"})
        self.assertIn("50 %", words["death by lung injury"])
        self.assertEqual(words["peak overpressure"], {"4 psi"})
        panels = self.drawn(fields(), {"lung_lethality": {0.4: "too many"}})
        words = panels["death by lung injury"].texts
        self.assertEqual([text.get_text() for text in words], ["too many"])

    def test_levels_without_a_line(self):
        """A level between known gauges that are not side by side has a line
        nowhere, and no name."""
        found = fields()
        for name, (_, unit) in found.items():
            found[name] = np.ones((3, 5)), unit
        values = np.full((3, 5), np.nan)
        values[:, :2], values[:, 3:] = (0., 0.4), (0.6, 1.)
        found["lung_lethality"] = values, "-"
        panels = self.drawn(found, {"lung_lethality": {
            0.2: "some", 0.5: "half", 0.8: "most"}})
        self.assertEqual({text.get_text() for text in
                          panels["death by lung injury"].texts},
                         {"some", "most"})

    def test_names_of_levels_are_apart(self):
        """Also of lines that are close together."""
        found = fields()
        x, y = np.meshgrid(np.linspace(-3., 3., 40), np.linspace(0., 3., 20))
        for name, (values, unit) in found.items():
            found[name] = np.ones_like(x), unit
        found["lung_lethality"] = 1. / (1. + np.hypot(x, y)**12), "-"
        axis = self.drawn(found)["death by lung injury"]
        axis.figure.canvas.draw()
        boxes = [text.get_window_extent() for text in axis.texts]
        self.assertEqual(len(boxes), 3)
        for i, box in enumerate(boxes):
            for other in boxes[:i]:
                self.assertFalse(box.overlaps(other))

    def test_names_within_the_map(self):
        """The border cuts none off, where the line has places farther in."""
        found = fields()
        x, y = np.meshgrid(np.linspace(-3., 3., 40), np.linspace(0., 3., 20))
        for name, (values, unit) in found.items():
            found[name] = np.ones_like(x), unit
        # Most of the line goes along the border.
        found["lung_lethality"] = np.where(
            x - 2.9 + 4. * np.clip(y - 2.1, 0., 0.3) > 0., 0.8, 0.2), "-"
        axis = self.drawn(found)["death by lung injury"]
        axis.figure.canvas.draw()
        name, = axis.texts
        box, around = name.get_window_extent(), axis.get_window_extent()
        self.assertEqual(name.get_text(), "50 %")
        self.assertLess(box.x1, around.x1)
        self.assertGreater(box.y0, around.y0)

    def test_lower_limits(self):
        """Are hatched, and told with their area; other fields are as before."""
        found = fields()
        title = "chest wall under side-on pressure"
        self.assertFalse(any(one.get_hatch() for one in
                             self.drawn(found)[title].collections))
        found[injury_maps.LIMITS] = np.tile([np.nan, 0., 0., 1., 1.], (3, 1)), "-"
        self.assertEqual(set(self.maps(found)["gauges_plane_1"]), set(found))
        hatched = [one for one in self.drawn(found)[title].collections
                   if one.get_hatch()]
        self.assertEqual(len(hatched), 1)
        self.assertEqual(hatched[0].get_array().count(), 6)
        tiny_scene.write_all(self.folder)
        self.write(found, os.path.join(self.folder, "blast"))
        text = "".join(map(str, blast_sections.people(Scene(self.folder))))
        self.assertIn("It is a lower limit (≥, hatched) on 0.750 m²", text)

    def test_report(self):
        """The section is there where it was asked for."""
        tiny_scene.write_all(self.folder)
        self.assertEqual(blast_sections.people(Scene(self.folder)), [])
        self.write(fields(), os.path.join(self.folder, "blast"))
        tiny_scene.write(os.path.join(self.folder, "blast", "parameters.prm"),
                         "subsection Loads\n  set Body mass = 125\nend\n")
        text = "".join(map(str, blast_sections.people(Scene(self.folder))))
        self.assertIn("half of the eardrums would rupture on at least 1.25 m² "
                      "(it continues beyond the plane, unknown "
                      "on a further 0.250 m²)", text)
        self.assertIn("9 August 2024", text)
        self.assertIn("Lungs of people of 125\u00a0kg by side-on", text)
        tiny_scene.write(
            os.path.join(self.folder, "parameters.prm"),
            "subsection Injury\n  subsection Measure ear_rupture\n"
            "    set Thresholds = 0.3: too loud\n  end\nend\n")
        text = "".join(map(str, blast_sections.people(Scene(self.folder))))
        self.assertIn("rupture of an eardrum above 30\u00a0% (too loud) on at "
                      "least 1.25 m²",
                      text)
        self.assertNotIn("half of the eardrums", text)
        self.assertIn("half of the people would die on", text)
        self.assertIn("thresholds of the user&#39;s own for rupture", text)

    def test_reflections_by_open_sides(self):
        """Are told with place and time, also where they do not reach the
        body."""
        tiny_scene.write_all(self.folder)
        self.write(fields(), os.path.join(self.folder, "blast"))
        row = {"item": "reflection", "quantity": "first reflection from an open "
               "side at the probe at 3.5, 3, 1.2 m", "estimate": "0.0084 s",
               "found": "0.0091 s", "limit": "at least 0.0095 s"}

        def told(**change):
            scene = Scene(self.folder)
            scene.facts.update(audit=[row | change], reflection_at_body=1.)
            return "".join(map(str, blast_sections.people(scene)))
        words = "first to the one at 3.5, 3, 1.2 m at "
        self.assertIn(words + "0.0091 s: figures of the maps may", told(holds=False))
        self.assertIn(words + "an estimated 0.0084 s: figures",
                      told(holds=False, found="unknown"))
        self.assertNotIn("Open sides of the domain", told(holds=True))


if __name__ == "__main__":
    unittest.main()
