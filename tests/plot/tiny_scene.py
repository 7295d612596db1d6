# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Writes a tiny scene as its stages would leave it, for report_test.py."""

import json
import os

import numpy as np

import tiny_files

BEGIN = 1.8e-3  # s, arrival at the body
TIMES = np.linspace(0., 6e-3, 241)
GAUGES = {"forehead": (0.09, 0., 1.7, 5e5), "chest": (0.12, 0., 1.3, 9e5),
          "back": (-0.12, 0., 1.25, 2e5), "left ear": (0., 0.08, 1.65, 1.75e5)}
# Injuries of a man of 78.5 kg by blast from these pulses (tests/numerics has
# the chest's), by measure and place: value, unit.
HARM = {("chest_wall_velocity", "chest"): (10.842, "m/s"),
        ("chest_wall_velocity", "back"): (2.4220, "m/s"),
        ("chest_wall_velocity", "trunk"): (6.632, "m/s"),
        ("lung_exposure", "chest"): (0.26398, "-"),
        ("lung_exposure", "back"): (0.05866, "-"),
        ("eardrum_rupture", "left ear"): (0.78773, "-")}
PROBES = {"coup": (0.07, 0., 1.66), "contrecoup": (-0.07, 0., 1.66),
          "lung left": (0., 0.09, 1.28)}
# To a person at the probe in the air.
AIR_HARM = {("lung_exposure", "probe 1"): (0.4321, "-"),
            ("lung_lethality", "probe 1"): (1.35e-6, "-"),
            ("eardrum_rupture", "probe 1"): (0.925, "-")}
QUANTITIES = (["displacement_" + axis + " [m]" for axis in "xyz"]
              + ["velocity_" + axis + " [m/s]" for axis in "xyz"]
              + ["pressure [Pa]", "von_mises_stress [Pa]",
                 "principal_strain [-]"])
INJURY = {"injury_intracranial_pressure_peak": (1.0425e6, "Pa"),
          "injury_intracranial_pressure_lowest": (-8.1e5, "Pa"),
          "injury_strain_95": (0.0542, "-"), "injury_hic15": (931., "-"),
          "injury_hic15_ais2": (0.4403, "-"),
          "injury_pressure_roughness": (0.515, "-")}

# Rows of the audit as scene writes them; no limit judges the last one.
AUDIT = (
    ("rigid_body", "at rest", "displacement", "1 mm", "8.25 mm",
     "at most 20 mm", True, "Scene/Body"),
    ("afterburn", "3.5 of at most 7.3 MJ/kg, Miller's rate, by explosive",
     "energy of afterburn over that of detonation", "0.623", "0.623", "", None,
     "Charge/Afterburn energy"),
    ("afterburn_peak", "in the loads",
     "largest rise of the incident peak by afterburn", "0.284", "0.284", "",
     None, "Charge/Afterburn energy"),
    ("afterburn_impulse", "in the loads",
     "largest rise of the incident impulse by afterburn", "0.317", "0.317", "",
     None, "Charge/Afterburn energy"),
    ("resolution", "cells of 20 mm at the skin",
     "number of cells in the positive phase of the wave at the body", "11.9", "12.3",
     "at least 15", False, "Scene/Accuracy"),
    ("quiet_leaves", "not computed", "fraction of skipped updates", "unknown",
     "0.47", "", True, "Blast/Method/Skip quiet leaves"))


# Name, unit, this run, its error, the tables, their error, and whether both differ
# by more.
TABLES = (("peak_overpressure", "Pa", 267701.8, 0.043, 314415., 0.1, True),
          ("impulse", "Pa s", 150.4, 0.06, 221.7, 0.1, True),
          ("duration", "s", 2.31e-3, 0.021, 2.38e-3, 0.1, False),
          ("lung_lethality", "-", 1.35e-6, 0.3, 3.4e-7, 0.1, False))
EFFECT = {"overpressure": 314415., "eardrum_rupture": 0.948,
          "lung_exposure": 0.41, "lung_lethality": 3.4e-7}


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def with_unit(value, unit):
    return {"value": value, "unit": unit}


def write_table(path, columns):
    rows = [",".join(columns)]
    rows += [",".join(repr(float(value)) for value in row)
             for row in zip(*columns.values())]
    write(path, "\n".join(rows) + "\n")


def pulse(time, peak, delay=0., part=1.):
    """A front that decays, and a weaker one 1.5 ms later."""
    values = np.zeros_like(time)
    for begin, size in ((BEGIN + delay, 1.), (BEGIN + delay + 1.5e-3, 0.25)):
        x = (time - begin) / 1e-3
        values += np.where(x >= 0., size * (1. - x) * np.exp(-x), 0.)
    return part * peak * values


def write_scene(folder):
    stages = [{"name": name, "status": "finished", "folder": name,
               "wall_seconds": 75., "core_seconds": 61.5,
               "peak_memory": 2.25 * 2**30, "disk": 5.5 * 2**20, "hash": "00"}
              for name in ("anatomy", "blast", "biomechanics",
                           "coarser_blast", "coarser_biomechanics")]
    write(os.path.join(folder, "scene.json"), json.dumps({
        "application": "scene", "version": "0.1.0", "git_revision": "abc123",
        "title": "A tiny <scene>", "question": "injury", "accuracy": "fast",
        "explosive": "c-4", "explosive_title": "C-4", "charge_mass": 2.268,
        "charge_place": [2.458, 0, 1.27], "probe_beside_body": None,
        "distance": 2.337, "height": 1.27,
        "body": "phantom", "symmetry": "none", "end_time": 6e-3,
        "cell_size_at_body": 0.02, "element_size": 0.01,
        "coarser_run": {"cell_ratio": 2., "element_ratio": 5. / 3.},
        "command": "scene tiny.prm --set \"Scene/Accuracy=fast\"", "ranks": 2,
        "stages": stages,
        "audit": [dict(zip(("item", "decision", "quantity", "estimate",
                            "found", "limit", "holds", "entry"), row))
                  for row in AUDIT],
        "person": {"description": "a standing person of 1.76 m and 78.5 kg",
                   "length": 1.76, "mass": 78.5, "posture": "standing",
                   "forward": [1, 0, 0], "left": [0, 1, 0], "up": [0, 0, 1],
                   "side_to_charge": "front"},
        "tables": {"equivalence_of_pressure": 1.37,
                   "equivalence_of_impulse": 1.19, "is_published": True,
                   "source": "TM 5-855-1 (1986)", "burst": "spherical",
                   "answer": {
                       "in_the_open": EFFECT, "before_a_wall": {
                           **EFFECT, "lung_lethality": 0.0421},
                       "along_body": {**EFFECT, "lung_exposure": 0.56,
                                      "lung_lethality": 6.3e-4}},
                   "trunk": None},
        "table_comparison": [{"place": "probe 1", **dict(zip((
            "name", "unit", "run", "run_error", "tables", "tables_error",
            "differs"), row))} for row in TABLES],
        "reflections": [
            {"place": place, "by": "ground", "least_delay": 1.1e-3,
             "largest_delay": 3.3e-3, "merges": False, "peak_rise": 0.41,
             "impulse_rise": 0.6} for place in ("probe 1", "nearest skin")],
        "changes": [{"entry": "Materials/Tissue skin/Density",
                     "value": "1200 kg/m^3", "before": "1100 kg/m^3"}],
        "warnings": ["no coarser run of the body"],
        "remarks": ["Organs are those of the phantom."]}))


def write_blast(folder):
    write(os.path.join(folder, "parameters.prm"),
          "subsection Boundaries\n  set x low = open\nend\n"
          "subsection Probes\n  set Points = 0.008, 2.337, 1.27\nend\n")
    write(os.path.join(folder, "log.txt"),
          "first stage ends at 0.0005 s with its front at 1.25 m\n")
    write(os.path.join(folder, "summary.json"), json.dumps({
        "application": "blast", "version": "0.1.0", "status": "finished",
        "cells": 100, "steps": 240, "conservation": {
            "mass_first": 186.07, "mass_last": 145.11,
            "mass_relative_change": -0.22005,
            "energy_first": 7.57e6, "energy_last": 6.02e6,
            "energy_relative_change": -0.20475},
        "results": {
            "probe_1_peak_overpressure": with_unit(267701.8, "Pa"),
            "probe_1_first_peak_overpressure": with_unit(267701.8, "Pa"),
            "probe_1_reference_peak_overpressure": with_unit(314415., "Pa"),
            "probe_1_impulse": with_unit(150.4, "Pa s"),
            "probe_1_reference_impulse": with_unit(221.7, "Pa s"),
            "probe_1_duration": with_unit(2.31e-3, "s"),
            "probe_1_reference_duration": with_unit(2.38e-3, "s"),
            "loads_impulse_x": with_unit(-118.4, "N s")},
        "checks": {"loads_impulse_difference": with_unit(5.52e-4, "-")},
        "assumptions": {
            "gravity": {"decision": "left out", "quantity": "its speed",
                        "unit": "-", "estimate": 2.9e-4, "measured": 3.3e-4,
                        "at_most": 0.05, "holds": True,
                        "entry": "Time/End time"}}}))
    steps = np.arange(len(TIMES))
    write_table(os.path.join(folder, "history.csv"), {
        "step": steps, "time [s]": TIMES, "mass [kg]": 186. - steps / 6.})
    write_gauges(folder, GAUGES)
    write_harm(folder)
    write_loads(os.path.join(folder, "loads.h5"))
    write_planes(folder, (1.5e-3, 2.5e-3))


def write_gauges(folder, gauges, slowness=0.):
    """Histories and measures of gauges; those behind begin later by
    @p slowness [s/m]."""
    write_measures(folder, gauges, slowness=slowness)
    write_table(os.path.join(folder, "load_gauges.csv"), {
        "time [s]": TIMES, **{
            f"{name} [Pa]": pulse(TIMES, peak, max(0., -slowness * x))
            for name, (x, _, _, peak) in gauges.items()}})


def write_planes(folder, times):
    for number, time in enumerate(times):
        write_plane(os.path.join(folder, "fields",
                                 f"plane_y_0_{number:04d}.vti"), time)


def write_measures(folder, gauges, factor=1., slowness=0.):
    """Writes findings of blast at the gauges, with peaks times a factor."""
    begin = {name: BEGIN + max(0., -slowness * x)
             for name, (x, *_) in gauges.items()}
    write(os.path.join(folder, "gauge_measures.csv"),
          "place,arrival [s],peak [Pa],peak time [s],impulse [Pa s],positive "
          "phase [s],cut off [-]\n" + "".join(
              f"{name},{begin[name]!r},{factor * peak!r},{begin[name]!r},"
              f"{0.38e-3 * peak!r},0.001,0\n"
              for name, (*_, peak) in gauges.items()))


def write_harm(folder, factor=1.):
    """HARM and AIR_HARM times a factor."""
    for name, harm in (("gauge_injury.csv", HARM),
                       ("probe_injury.csv", AIR_HARM)):
        write(os.path.join(folder, name),
              "measure,place,value,unit,definition\n" + "".join(
                  f'{measure},{place},{factor * value!r},{unit},"by a model of it"\n'
                  for (measure, place), (value, unit) in harm.items()))


def write_loads(path, gauges=GAUGES):
    import h5py
    heights, angles = np.meshgrid(np.linspace(0.05, 1.7, 12),
                                  np.arange(12) * np.pi / 6., indexing="ij")
    normals = np.stack([np.cos(angles).ravel(), np.sin(angles).ravel(),
                        np.zeros(angles.size)], axis=1)
    centroids = 0.12 * normals
    centroids[:, 2] = heights.ravel()
    peaks = 1e5 * (2. + normals[:, 0])
    arrivals = BEGIN + 1e-4 * (1. - normals[:, 0])
    with h5py.File(path, "w") as file:
        file["centroid"], file["normal"] = centroids, normals
        file["area"] = np.full(len(peaks), 0.009)
        file["time"] = TIMES
        file["peak"], file["arrival"] = peaks, arrivals
        file["impulse"] = peaks * 4e-4
        file["overpressure"] = np.stack([
            pulse(TIMES, peak, begin - BEGIN) for peak, begin
            in zip(peaks, arrivals)]).astype(np.float32)
        file.attrs["units"] = np.bytes_("m, m^2, s, Pa, Pa s")
        file.attrs["gauges"] = np.bytes_("; ".join(
            f"{name}: {x}, {y}, {z}" for name, (x, y, z, _)
            in gauges.items()))


def write_plane(path, time):
    x, z = np.meshgrid(np.linspace(-1., 3., 60), np.linspace(0.02, 2., 30))
    distance = np.hypot(x - 2.458, z - 1.27)
    front = 2.337 * time / BEGIN
    pressure = 101325. + 1e5 * np.where(distance < front,
                                        np.exp(distance - front), 0.)
    tiny_files.write_plane(path, {"pressure": (pressure, "Pa"),
                                  "density": (1e-5 * pressure, "kg/m^3")},
                           [-1., 0.02], [3., 2.], time)


def write_biomechanics(folder):
    write_probes(folder, PROBES)
    write(os.path.join(folder, "summary.json"), json.dumps({
        "application": "biomechanics", "version": "0.1.0",
        "status": "finished", "cells": 64, "steps": 240,
        "checks": {
            "energy_residual": with_unit(3.5e-6, "-"),
            "hourglass_part": with_unit(0.077, "-"),
            "loads_impulse_factor": with_unit(0.984, "-"),
            "loads_recorded_impulse_x": with_unit(-118.4, "N s"),
            "loads_mapped_impulse_x": with_unit(-118.3, "N s"),
            "loads_largest_recorded_impulse": with_unit(118.4, "N s"),
            "loads_largest_mapped_impulse": with_unit(118.3, "N s")}}))
    write_history(folder, ("brain",))
    write(os.path.join(folder, "injury.csv"),
          "measure,value,unit,threshold,limits\n" + "".join(
              f'{name},{value!r},{unit},"",""\n'
              for name, (value, unit) in INJURY.items()))
    write_fields(folder)


def write_history(folder, tissues):
    """Energies, the internal one by tissue."""
    work = 200. * (1. - np.exp(-np.maximum(TIMES - BEGIN, 0.) / 1e-3))
    write_table(os.path.join(folder, "history.csv"), {
        "step": np.arange(len(TIMES)), "time [s]": TIMES,
        "external_work [J]": work, "kinetic_energy [J]": 0.7 * work,
        "stored_energy [J]": 0.3 * work, "energy_residual [J]": 0. * work,
        "step_change_energy [J]": 0.01 * work,
        "pressure_smoothing_energy [J]": 0.01 * work,
        **{f"internal_energy_{tissue.replace(' ', '_')} [J]":
           0.1 * work / number for number, tissue in enumerate(tissues, 1)}})


def write_probes(folder, probes):
    """Their places in the parameter file, and their histories."""
    write(os.path.join(folder, "parameters.prm"),
          "subsection Probes\n  set Points = " + "; ".join(
              ", ".join(str(x) for x in place) for place in probes.values())
          + "\nend\nsubsection Loads\n  subsection Recorded\n    "
          "set Mirror = y\n  end\nend\n")
    columns = {"time [s]": TIMES}
    for number in range(1, len(probes) + 1):
        values = pulse(TIMES, 6e5 / number, 1e-4 * number)
        for quantity in QUANTITIES:
            scale = 1. if "[Pa]" in quantity else 1e-8
            columns[f"probe_{number}_{quantity}"] = scale * values
    write_table(os.path.join(folder, "probes.csv"), columns)


def write_fields(folder, times=(0., 2e-3, 4e-3)):
    listed = []
    for number, time in enumerate(times):
        name = f"fields/solid_{number:04d}.vtu"
        write_mesh(os.path.join(folder, name), 1e6 * time)
        listed.append(f'<DataSet timestep="{time}" group="" part="0" '
                      f'file="{name}"/>')
    write(os.path.join(folder, "fields.pvd"), "\n".join(listed))


def write_mesh(path, scale, stature=1.7, tissue=None, axes=np.eye(3)):
    """A column of cubes with brain and lung, or of one tissue; @p axes: where
    its front, left side and top point to, as rows."""
    x, y, z = np.meshgrid(np.linspace(-0.1, 0.1, 5),
                          np.linspace(-0.1, 0.1, 5),
                          np.linspace(0., stature, 18),
                          indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    shape = (5, 5, 18)
    i, j, k = (part.ravel() for part in np.meshgrid(
        range(4), range(4), range(17), indexing="ij"))
    cells = np.stack([np.ravel_multi_index((i + a, j + b, k + c), shape)
                      for a, b, c in ((0, 0, 0), (1, 0, 0), (1, 1, 0),
                                      (0, 1, 0), (0, 0, 1), (1, 0, 1),
                                      (1, 1, 1), (0, 1, 1))], axis=1)
    height = points[cells].mean(axis=1)[:, 2]
    tissue = np.where(height > 1.5, 4, np.where(height > 1., 7, 3)) \
        if tissue is None else np.full(height.shape, tissue)
    arrays = [("points", (points @ axes).astype(np.float32), 3, "m"),
              ("connectivity", cells.astype(np.uint32), 1, ""),
              ("displacement", np.full(points.shape, 1e-6 * scale,
                                       np.float32), 3, "m"),
              ("tissue", tissue.astype(np.uint8), 1, ""),
              ("pressure", (scale * height).astype(np.float32), 1, "Pa")]
    arrays += [(name, (1e-6 * scale * height).astype(np.float32), 1, "-")
               for name in ("highest_pressure", "largest_principal_strain")]
    tiny_files.write(path, tiny_files.elements(arrays))


def write_anatomy(folder):
    write(os.path.join(folder, "quality.csv"),
          "kind,name,tissue,elements,volume [m^3],mass [kg],"
          "smallest scaled Jacobian,mean scaled Jacobian,shortest edge [m],"
          "longest edge [m],time step [s],connected components\n"
          "tissue,brain,brain,1444,0.001444,1.5,1,1,0.01,0.01,3.9e-06,1\n")
    write(os.path.join(folder, "summary.json"), json.dumps({
        "application": "anatomy", "format": 1, "organs": [
            {"name": "brain", "volume": 0.001444, "reference_volume": 0.0016,
             "source": "the image"}]}))


def write_all(folder):
    write_scene(folder)
    write_blast(os.path.join(folder, "blast"))
    write_biomechanics(os.path.join(folder, "biomechanics"))
    write_anatomy(os.path.join(folder, "anatomy"))
    write_coarser(folder)


# As many places as a scene with the phantom has, some of them close together.
CROWD = {"forehead": (0.09, 0., 1.7, 5e5), "eye": (0.09, 0.03, 1.66, 6.2e5),
         "vertex": (0., 0., 1.72, 2.4e5), "temple": (0.04, 0.07, 1.67, 2.9e5),
         "left ear": (0., 0.08, 1.65, 1.75e5),
         "occiput": (-0.09, 0., 1.66, 3.1e5), "chest": (0.12, 0., 1.3, 9e5),
         "left side": (0., 0.12, 1.25, 2.6e5), "back": (-0.12, 0., 1.25, 2e5),
         "abdomen": (0.12, 0., 1.1, 8.2e5), "thigh": (0.12, 0.05, 0.7, 6e5),
         "shin": (0.12, 0.05, 0.3, 4.1e5), "calf": (-0.12, 0.05, 0.3, 1.1e5)}
CROWDED_PROBES = {
    "coup": (0.07, 0., 1.66), "contrecoup": (-0.07, 0., 1.66),
    "brain": (0., 0.02, 1.62), "skull": (0.09, 0., 1.66),
    "spinal cord": (-0.04, 0., 1.52), "lung left": (0., 0.08, 1.28),
    "lung right": (0., -0.08, 1.28), "heart": (0.03, 0.02, 1.22),
    "liver": (0.03, -0.05, 1.1)}


def crowd(folder):
    """As many places and times in a scene as in one with the phantom."""
    blast = os.path.join(folder, "blast")
    write_gauges(blast, CROWD, 3e-3)
    write_loads(os.path.join(blast, "loads.h5"), CROWD)
    write_planes(blast, np.linspace(1e-3, 4e-3, 9))
    write(os.path.join(blast, "log.txt"), "".join(
        f"first stage ends at {time} s with its front at {front} m\n"
        for time, front in ((0.00041, 1.24), (0.00045, 1.31),
                            (0.00168, 2.19))))
    solid = os.path.join(folder, "biomechanics")
    write_fields(solid, np.linspace(1.5e-3, 5e-3, 12))
    write_probes(solid, CROWDED_PROBES)
    write_history(solid, ("soft tissue", "skin", "skeleton", "brain",
                          "spinal cord", "cerebrospinal fluid", "lung",
                          "heart", "liver"))
    path = os.path.join(folder, "scene.json")
    with open(path, encoding="utf-8") as file:
        facts = json.load(file)
    facts["tissue_places"] = [{"name": name, "place": place} for name, place
                              in CROWDED_PROBES.items()]
    write(path, json.dumps(facts))


# The coarser run's values over those of the scene.
COARSER = {"injury_intracranial_pressure_peak": 0.9, "injury_strain_95": 0.5}


def write_coarser(folder):
    """Writes the report's input of the run with larger cells and elements."""
    blast = os.path.join(folder, "coarser_blast")
    write_measures(blast, GAUGES, 0.8)
    write_harm(blast, 0.9)
    write(os.path.join(folder, "coarser_biomechanics", "injury.csv"),
          "measure,value,unit,threshold,limits\n" + "".join(
              f"{name},{COARSER.get(name, 1.) * value!r},{unit},none,none\n"
              for name, (value, unit) in INJURY.items()))
