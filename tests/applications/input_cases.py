#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Input that users get wrong: input_cases.py PROGRAMS_FOLDER REPOSITORY

Each case below is a file of its own, and one start of an application with --check
takes all of its kind. What
is refused must be so with exit code 1 and one line on stderr that has the
message; what is accepted must say what the case expects on the screen. Nothing
may be written. One process for all, since each start costs little but a test
of each would cost more. Exit code 0: all as wanted; 1: not, with the cases.
"""

import os
import re
import shutil
import subprocess
import sys

import head_cases

FOLDER = "input_cases"
SCENE = "scene/quickstart.prm"
SOD = "blast/verification/sod.prm"
EARLY = "blast/extremes/hand_over_early.prm"
CONE = "blast/verification/cone.prm"
SPHERE = "blast/verification/body_sphere_axisymmetric.prm"
BURN = "blast/verification/tnt_detonation.prm"
HEAD = "head_impact/quickstart.prm"
BAR = "biomechanics/verification/bar_wave.prm"
MPM = "head_impact/verification/two_disks.prm"
ANATOMY = "anatomy/quickstart.prm"
HUMAN = "blast/quickstart_human.prm"
VORTEX = "blast/verification/mapped_vortex.prm"
REST = "blast/extremes/rest_100000_steps.prm"
# Where what is needed for a case lies, made by make_files().
MISSING = "no_such_file"
A_FOLDER = "a_folder"
DUMP = "dump.prm"
SHORT = "short"
# Two cubes that touch, or do not; with "flat_" before the name two squares.
TOUCHING = "touching.msh"
APART = "apart.msh"
OTHER = "other.prm"


def shipped(path, *lines):
    """A parameter file that includes a shipped one and adds lines."""
    return "\n".join([f"include @FILES@/{path}", *lines, ""]).encode()


def entry(path, value):
    """Lines that set "Section/Entry" to the value."""
    *sections, name = path.split("/")
    text = f"set {name} = {value}\n"
    for section in reversed(sections):
        text = f"subsection {section}\n{text}end\n"
    return text


# A charge besides that of a shipped file.
SECOND_CHARGE = (entry("Charges/Charge 2/Mass", "1"),
                 entry("Charges/Charge 2/Center", "1.6, 0, 2"))


def refused_files():
    """Parameter files that cannot be read."""
    plain = "subsection Charge\nset Mass = 1\nend\n"
    yield ("UTF-16", "scene", plain.encode("utf-16"),
           "it is not a text file: it is encoded as UTF-16")
    yield ("UTF-16 without a mark", "scene", plain.encode("utf-16-le"),
           "it is not a text file: its byte 2 is 0")
    yield ("HDF5", "scene", b"\x89HDF\r\n\x1a\n" + bytes(20),
           "it is not a text file: it is an HDF5 file")
    yield ("include of nothing", "scene", f"include {MISSING}\n".encode(),
           "there is no such file")
    yield ("include of a folder", "scene", f"include {A_FOLDER}\n".encode(),
           "it is a folder")
    yield ("unknown word", "scene",
           shipped(SCENE, entry("Charge/Explosive", "C44")),
           'did you mean "c-4"?')


def refused_entries():
    """Values out of range, and expressions that are no numbers."""
    for path, value in [("Scene/End time", "1e9"),
                        ("Scene/End time", "2"),
                        ("Charge/Mass", "1e300"),
                        ("Charge/Mass", "1.1e6"),
                        ("Charge/Distance", "1e9"),
                        ("Charge/Height", "1e9"),
                        ("Charge/Afterburn energy", "1e300"),
                        ("Scene/Element size", "1e300"),
                        ("Charge/Place", "1e7, 0, 1")]:
        yield (path, "scene", shipped(SCENE, entry(path, value)),
               f'entry "{path}" cannot be "{value}"')
    for path, value in [("Initial state/Riemann/Left density", "1e300"),
                        ("Initial state/Riemann/Left velocity", "1e300"),
                        ("Initial state/Riemann/Right pressure", "-1e300"),
                        ("Time/End time", "1e300"),
                        ("Time/Largest step", "1e300"),
                        ("Probes/Points", "1e300")]:
        yield (path, "blast", shipped(SOD, entry(path, value)),
               f'entry "{path}" cannot be "{value}"')
    yield ("charges of a first stage", "blast",
           shipped(HUMAN, *SECOND_CHARGE),
           "can only be computed with First stage/Kind = none")
    yield ("constant that is not finite", "blast",
           shipped(SOD, entry("Initial state/Kind", "expression"),
                   entry("Reference/Kind", "none"),
                   entry("Initial state/Expression/Density", "sqrt(-1)")),
           "Initial state/Expression: Density = \"sqrt(-1)\" is not a "
           "number")
    for value in ("sqrt(-1)", "1/t"):
        path = "Loads/Load end/Pressure"
        yield (f"load {value}", "biomechanics",
               shipped(BAR, entry("Loads/Load end/Where", "1"),
                       entry(path, value)),
               f'{path} = "{value}" is ')


def refused_tissues():
    """Tissues that nobody knows, or that contradict themselves; selections.py
    has those that select nothing."""
    for path, value, reason in [
            ("Mesh/Tissue", "bran", 'did you mean "brain"?'),
            ("Materials/Tissue foam/Density", "100",
             "and a new tissue needs Bulk modulus, Shear modulus (or Young's "
             "modulus and Poisson's ratio)"),
            ("Materials/Tissue brian/Density", "100",
             'did you mean "brain"? (known are soft tissue, skin'),
            ("Materials/Tissue skeleton/Relaxation time", "1",
             "has no effect, since nothing relaxes"),
            ("Materials/Tissue skeleton/Relaxing shear modulus", "1e3",
             "Relaxing shear modulus needs Relaxation time"),
            ("Materials/Tissue skeleton/Density", "heavy",
             'allowed: a number from 1e-06 to 1e+06, or "library"')]:
        yield (f"{path} = {value}", "biomechanics",
               shipped(BAR, entry(path, value)), reason)
    tissue = "Materials/Tissue skeleton/"
    yield ("two ways to moduli", "biomechanics",
           shipped(BAR, entry(tissue + "Young's modulus", "1e9"),
                   entry(tissue + "Shear modulus", "1e8")),
           "Young's modulus and Shear modulus contradict each other")


def refused_other_files():
    """Files of other kinds that an entry names."""
    reasons = [(MISSING, "there is no such file"), (A_FOLDER, "it is a folder")]
    for name, reason in reasons + [(OTHER, "it is no HDF5 file"),
                                   (SHORT, "it is empty")]:
        yield (f"{name} as loads", "biomechanics",
               shipped(BAR, entry("Loads/Recorded/File", name)), reason)
    for name, reason in reasons + [
            (OTHER, "its name must end as that of a surface"),
            ("other.stl", "cannot be read as STL"),
            ("short.stl", "cannot be read as STL"),
            ("other.ply", "cannot be read as PLY")]:
        yield (f"{name} as surface", "anatomy",
               shipped(ANATOMY, entry("Body/Kind", "surface"),
                       entry("Body/Surface/File", name)), reason)
    for name, reason in reasons + [(OTHER, "its header is none of NIfTI-1"),
                                   ("short.nii", "none of NIfTI-1")]:
        yield (f"{name} as image", "anatomy",
               shipped(ANATOMY, entry("Body/Kind", "image"),
                       entry("Body/Image/Labels", "1: brain"),
                       entry("Body/Image/File", name)), reason)
    for name, reason in reasons + [
            (OTHER, "its name must end as that of a mesh: .msh"),
            ("short.msh", "deal.II cannot read it as a mesh")]:
        yield (f"{name} as mesh", "blast",
               shipped(REST, entry("Domain/Mesh", "file"),
                       entry("Domain/Geometry", "plane"),
                       entry("Domain/Mesh file", name)), reason)
        yield (f"{name} as mesh of a solid", "biomechanics",
               shipped(BAR, entry("Mesh/Kind", "file"),
                       entry("Mesh/File", name)), reason)
        yield (f"{name} as mesh of a head", "head_impact",
               shipped(HEAD, entry("Mesh/Kind", "file"),
                       entry("Mesh/File", name)), reason)
    for name, reason in reasons + [(OTHER, "no profile"),
                                   ("short.csv", "has no line")]:
        yield (f"{name} as profile", "blast",
               shipped(SOD, entry("Reference/Kind", "none"),
                       entry("Initial state/Kind", "profile"),
                       entry("Initial state/Profile/File", name)), reason)
    for name, reason in reasons + [("short.csv", "at least 2 lines")]:
        yield (f"{name} as reference", "blast",
               shipped(SOD, entry("Reference/Kind", "table"),
                       entry("Reference/Table", name)), reason)


def refused_blasts():
    """Values that no explosive and no run of blast can have."""
    burn = entry("Charges/Afterburn/Kind", "miller")
    for explosive, energy, most in (
            ("tnt", "2", "0 for none, or a number from 1e+04 to 1.082e+07"),
            ("tnt", "2e9", "release at most 1.082e+07 J/kg"),
            ("anfo", "3.5e6", "burn in air; allowed: 0 for none")):
        yield (f"afterburn of {energy} J/kg", "blast",
               shipped(BURN, burn, entry("Material/Equation of state",
                                         "jwl in air"),
                       entry("Material/Explosive", explosive),
                       entry("Charges/Afterburn/Energy", energy)), most)
    yield ("hand-over after the end", "blast",
           shipped(EARLY, entry("First stage/Time", "1e-3")),
           "First stage/Time = 0.001 s is not before Time/End time = 3e-05 s")
    for application, path in (("blast", SOD), ("biomechanics", BAR),
                              ("head_impact", HEAD), ("head_impact", MPM)):
        yield (f"no time for {path}", application,
               shipped(path, entry("Time/End time", "0")),
               'entry "Time/End time" cannot be "0"')
    yield ("no time for a scene", "scene",
           shipped(SCENE, entry("Scene/End time", "0")),
           'entry "Scene/End time" cannot be "0"')


def refused_bodies():
    """Cases that biomechanics refuses only after its mesh is there."""
    pulse = "Loads/Load end/"
    yield ("charge in the body", "biomechanics",
           shipped(BAR, entry(pulse + "Kind", "kingery bulmash"),
                   entry(pulse + "Where", "1"),
                   entry(pulse + "Kingery Bulmash/Centre", "0.5, 0.01, 0.01")),
           "from the charge, which the tables do not cover")


def refused_gas_selections():
    """Entries of blast that select nothing, or something else than they say."""
    region = [entry("Reference/Kind", "none"),
              entry("Initial state/Kind", "regions")]
    for shape, places, what in [
            ("box", {"Lower corner": "2", "Upper corner": "3"}, "box at 2 to 3"),
            ("half space", {"Center": "-1"}, "half space at -1")]:
        yield (f"{shape} outside", "blast",
               shipped(SOD, *region, entry("Initial state/Region a/Shape", shape),
                       *(entry(f"Initial state/Region a/{name}", value)
                         for name, value in places.items())),
               f'Initial state/Region a = "{what}" selects no gas: the domain '
               'reaches from 0 to 1 m')
    yield ("fine box between centres", "blast",
           shipped(SPHERE, entry("Adaptation/Fine box levels", "1"),
                   entry("Adaptation/Fine box lower corner", "0.501, 0"),
                   entry("Adaptation/Fine box upper corner", "0.502, 1")),
           "selects no centre of a leaf")
    yield ("line in the body", "blast",
           shipped(SPHERE, entry("Probes/Lines", "0, 0 : 0.3, 0 : 4")),
           "selects no place in the gas")
    yield ("line that leaves the domain", "blast",
           shipped(SPHERE, entry("Probes/Lines", "0.6, 0 : 3, 0 : 4")),
           "outside of the domain")
    yield ("gauge far from the skin", "blast",
           shipped(SPHERE, entry("Loads/Gauges", "side: 0.9, 0")),
           '"side" is 0.4 m from the surface of the body')


def refused_scenes():
    """Entries that contradict other stages of a scene, and unknown ones."""
    end = entry("Scene/End time", "0.005")
    for path, value, message in [
            ("Biomechanics/Time/End time", "0.01",
             "Biomechanics/Time/End time = 0.01 s: the loads of the blast end "
             "at 0.005 s (Scene/End time)"),
            ("Blast/Time/End time", "0.002",
             "the loads of the blast end at 0.002 s (Blast/Time/End time)"),
            ("Blast/Time/End time", "0.0005",
             "Blast/Time/End time = 0.0005 s: the blast reaches the body at"),
            ("Blast/Domain/Dimension", "2", "needs Dimension = 3"),
            ("Blast/Domain/Upper corner", "2.56, 2.56, 1.28",
             "m it does not hold the body, which is from"),
            ("Blast/Domain/Upper corner", "1.28, 2.56, 2.56",
             "m it does not hold the charge, which is from"),
            ("Blast/Probes/Points", "0, 50, 1", "is outside of the domain"),
            ("Blast/Probes/Points", "0.5, -0.3, 1.2",
             "by symmetry 0.5, 0.3, 1.2 m has the same values"),
            ("Blast/Probes/Lines", "0.5, -0.3, 1.2 : 0.5, 0.3, 1.2 : 3",
             "by symmetry 0.5, 0.3, 1.2 m has the same values"),
            ("Blast/Probes/Points", "0, 0.01, 1.2", "is in the body"),
            ("Blast/Loads/Gauges", "nose: 1, 0, 1.6",
             '"nose" at 1, 0, 1.6 m is'),
            ("Biomechanics/Probes/Points", "1, 0, 1.6",
             "Biomechanics/Probes/Points: 1, 0, 1.6 m is"),
            ("Charge/Afterburn energy", "3.5",
             "0 for none, or a number from 1e+04 to"),
            ("Charge/Afterburn energy", "2",
             "0 for none, or a number from 1e+04 to 5.979e+06"),
            ("Charge/Afterburn energy", "5e7",
             "the products of C-4 release at most 5.979e+06 J/kg"),
            ("Tissues/Tissue brian/Density", "100",
             'Tissues/Tissue brian: no tissue of the library has this name; did '
             'you mean "brain"? (known are soft tissue, skin'),
            ("Tissues/Tissue brain/Shear modulus", "2000",
             "Tissues/Tissue brain: Relaxing shear modulus = 3.3e+04 Pa of the "
             "library exceeds"),
            ("Tissues/Tissue brain/Densty", "1050", 'did you mean "Density"?')]:
        yield (f"{path} = {value}", "scene",
               shipped(SCENE, end, entry(path, value)), message)
    at_time = entry("Blast/First stage/Hand over at", "time")
    for time in ("0.005", "0.02"):
        yield (f"hand-over at {time} s", "scene",
               shipped(SCENE, end, at_time,
                       entry("Blast/First stage/Time", time)),
               f"Blast/First stage/Time = {time} s is not before Scene/End "
               "time = 0.005 s")
    hic = "Injury/Measure injury_hic15/Thresholds"
    for path, value, message in [
            (hic, "300", '"300" must be a value and what it means'),
            (hic, "300: harm; 200: death", "in the order of increasing"),
            ("Injury/Measure injury_lung_exposure/Thresholds", "0.5: harm",
             "Injury/Measure injury_lung_exposure: this measure is not taken "
             "here; those are chest_wall_back")]:
        yield (f"{path} = {value}", "scene",
               shipped(SCENE, end, entry(path, value)), message)
    yield ("thresholds where nothing is measured", "biomechanics",
           shipped(BAR, entry(hic, "300: harm")),
           "is not taken here (Injury/Active = false); none is")
    yield ("thresholds of the head without a brain", "biomechanics",
           shipped(BAR, entry(hic, "300: harm"), entry("Mesh/Tissue", "lung"),
                   entry("Injury/Active", "true")),
           'Injury/Measure injury_hic15 = "300: harm (the user\'s own)" selects '
           "no element of brain")
    yield ("tissue of a shape that nobody knows", "scene",
           shipped(SCENE, end, entry("Body/Kind", "shape"),
                   entry("Body/Shape/Tissues", "cork")),
           'Body/Shape/Tissues: "cork" is no tissue; known are soft tissue')
    yield ("tissue of an image that nobody knows", "anatomy",
           shipped(ANATOMY, entry("Body/Kind", "image"),
                   entry("Body/Image/File", OTHER),
                   entry("Body/Image/Labels", "1: bran")),
           'row "1: bran": "bran" is no tissue; did you mean "brain"?')
    yield ("distance that no place has", "scene",
           shipped(SCENE, end, entry("Body/Shift", "0, 0, 5"),
                   entry("Charge/Height", "0.5")),
           "at Charge/Height = 0.5 m a charge is at least 4.502 "
           "m from the body; give that Distance, a Height from 5 to 6.756 m")
    yield ("coarser run of the coarsest cells", "scene",
           shipped(SCENE, end, entry("Scene/Error estimate", "true"),
                   entry("Scene/Cell size", "0.16")),
           "set Scene/Cell size to at most 0.08 m or Scene/Error estimate = "
           "false")
    custom = entry("Charge/Explosive", "custom")
    yield ("explosive without a sound speed", "scene",
           shipped(SCENE, custom,
                   entry("Charge/Custom explosive/B", "-9e9")),
           "Charge/Custom explosive: with B = -9e+09 Pa the sound speed is "
           "not real")


def accepted():
    """Input that is understood, and the words about it."""
    sod = "\n".join(["include @FILES@/" + SOD, ""])
    yield ("byte order mark", "blast",
           b"\xef\xbb\xbf" + sod.encode(), "The parameters are valid.")
    yield ("other case and words", "blast",
           shipped(SOD, entry("METHOD/limiter", "MinMod"),
                   entry("time/END TIME", "0.1"),
                   entry("output/checkpoint at the end", "Yes")),
           "to time 0.1 s")
    yield ("C-4 without its hyphen", "blast",
           shipped(CONE, entry("Material/Explosive", "C4")),
           "The parameters are valid.")
    yield ("an entry twice", "blast",
           shipped(SOD, "subsection Time", "set End time = 1",
                   "set end time = 0.1", "end"),
           'line 4: entry "Time/End time" was set in line 3 already; the later '
           'value, "0.1", counts')
    near = entry("Scene/End time", "0.005")
    yield ("a wall of the user", "scene",
           shipped(SCENE, near, entry("Blast/Boundaries/x low", "wall")),
           "side_x_low")
    yield ("a wall nearer than a cell", "scene",
           shipped(SCENE, near, entry("Blast/Boundaries/x low", "wall"),
                   entry("Blast/Domain/Lower corner", "-0.16, 0, 0")),
           "WARNING: side_x_low: distance of this side from the body is "
           "estimated at 0.015 m, allowed is at least ")
    yield ("a level of a stage", "scene",
           shipped(SCENE, near, entry("Blast/Adaptation/Largest level", "1")),
           "changed: Blast/Adaptation/Largest level = 1, otherwise ")
    yield ("charges without a first stage", "blast",
           shipped(HUMAN, *SECOND_CHARGE, entry("First stage/Kind", "none")),
           "The parameters are valid.")
    head = "scene/verification/head.prm"
    where = entry("Biomechanics/Supports/Support all/Where", "1")
    for name, said in (
            ("a support of a stage", "changed: Biomechanics/Supports/Support "
             "all/Where = 1, otherwise not set"),
            ("a support of the whole body", "WARNING: Biomechanics/Supports/"
             "Support all/Where selects all nodes of the body in x, y and z"),
            ("a body that is held", "held by Supports in biomechanics")):
        yield (name, "scene",
               shipped(head, entry("Scene/Forecast", "false"), where), said)
    yield ("a load of a stage", "scene",
           shipped(head, entry("Scene/Forecast", "false"),
                   entry("Biomechanics/Loads/Load b/Pressure", "1e6")),
           "changed: Biomechanics/Loads/Load b/Pressure = 1e6, otherwise "
           "not set")
    yield ("a support of all of the brain", "biomechanics",
           shipped("biomechanics/quickstart.prm",
                   entry("Supports/Support head/Where", "z > 1.4")),
           "WARNING: Supports/Support head/Where selects all nodes of brain "
           "in x, y and z")
    yield ("an explosive of the user", "scene",
           shipped(SCENE, near, entry("Charge/Explosive", "custom"),
                   entry("Charge/Custom explosive/Name", "my mix"),
                   entry("Charge/Custom explosive/Like", "c-4"),
                   entry("Charge/Custom explosive/Density", "1650")),
           "changed: Charge/Custom explosive/Density = 1650 kg/m^3, in the "
           "library 1601 kg/m^3")
    yield ("tissues of the user", "scene",
           shipped(SCENE, near, entry("Tissues/Tissue brain/Density", "1050")),
           "changed: Tissues/Tissue brain/Density = 1050 kg/m^3, in the library "
           "1000 kg/m^3")
    felt = "Tissues/Tissue felt/"
    yield ("a new tissue of the user", "scene",
           shipped(SCENE, near, entry("Body/Kind", "shape"),
                   entry("Body/Shift", "0, 0, 1"),
                   entry("Body/Shape/Shape", "sphere"),
                   entry("Body/Shape/Tissues", "felt"),
                   entry(felt + "Density", "300"),
                   entry(felt + "Bulk modulus", "1e6"),
                   entry(felt + "Shear modulus", "1e5")),
           "changed: Tissues/Tissue felt/Density = 300 kg/m^3, in the library "
           "none, a new tissue")
    yield ("thresholds of the user", "scene",
           shipped(SCENE, near, entry("Injury/Measure ear_rupture/Thresholds",
                                      "0.1: too many"),
                   entry("Injury/Measure ear_rupture/Source", "our ward")),
           "changed: Injury/Measure ear_rupture/Thresholds = 0.1: too many (the "
           "user's own: our ward), in the library 0.05: rupture possible")
    yield ("a small person who turns the right side to the charge", "scene",
           shipped(SCENE, near, entry("Body/Phantom/Stature", "1.62"),
                   entry("Body/Phantom/Mass", "58"),
                   entry("Body/Rotation", "0, 0, 90")),
           "and a standing person of 1.62 m and 58 kg")
    yield ("a cell size between two", "scene",
           shipped(SCENE, near, entry("Scene/Cell size", "0.03")),
           "Scene/Cell size = 0.03 m is an upper bound: cells are 160 mm over a "
           "power of two, 20 mm")
    yield ("cells that a short wave halves", "scene",
           shipped(SCENE, entry("Charge/Mass", "0.1"),
                   entry("Charge/Distance", "0.7")),
           "Scene/Cell size = 0.02 m is cheaper, with larger errors")
    yield ("no entry", "blast", b"# nothing\n", "sets no entry")
    yield ("late ignition", "blast",
           shipped(BURN, entry("Charges/Charge 1/Ignition times", "1")),
           "WARNING: Charges/Charge 1 burns from 1 s to")
    yield ("tables of another charge", "blast",
           shipped("blast/quickstart.prm", entry("Charges/Charge 1/Mass", "2")),
           "WARNING: Reference/Kingery Bulmash/Mass = 0.8535, but "
           "Charges/Charge 1 has 2 kg")
    yield ("tables of a charge elsewhere", "blast",
           shipped("blast/quickstart.prm",
                   entry("Reference/Kingery Bulmash/Center", "0, 0, 1")),
           "WARNING: Reference/Kingery Bulmash/Center = 0, 0, 1, but "
           "Charges/Charge 1 has its centre at 0, 0, 1.2 m")
    yield ("a charge beside a plane of symmetry", "blast",
           shipped("blast/quickstart.prm",
                   entry("Charges/Charge 1/Center", "0, 0.5, 1.2")),
           "WARNING: Charges/Charge 1 is 0.5 m away from the plane of symmetry "
           "y = 0 m: its mirror image is computed as well, 2 charges of 1.707 kg")
    for pressure, said in (("101.325", "101.325 Pa and 1.225 kg/m^3 are those "
                            "of air of 0.288 K"),
                           ("70e3", "70000 Pa, but the tables of Kingery and "
                            "Bulmash are for 101325 Pa")):
        yield ("air of " + pressure + " Pa", "blast",
               shipped("blast/quickstart.prm",
                       entry("Initial state/Background/Pressure", pressure)),
               "WARNING: Initial state/Background: " + said)
    yield ("an explosive of one's own like tnt", "scene",
           shipped(SCENE, near, entry("Charge/Explosive", "custom")),
           "WARNING: Charge/Custom explosive: no entry differs from TNT")
    yield ("a tissue changed in anatomy", "anatomy",
           shipped(ANATOMY, entry("Tissues/Tissue skeleton/Density", "1900")),
           "changed: skeleton with Density = 1900 kg/m^3 instead of 1300")
    yield ("a brain that moves against its head", "head_impact",
           shipped("head_impact/quickstart.prm",
                   entry("Mesh/Cell size", "0.01"),
                   entry("Region brain/Velocity z", "3")),
           "WARNING: Region CSF/Velocity: (0, 0, -3) m/s at the start, while "
           "region brain of the same head has (0, 0, 3) m/s")
    yield ("late size limit", "blast",
           shipped(SPHERE, entry("Adaptation/Limit a/From time", "2")),
           "s: the limit never holds")
    yield ("late hand-over", "scene",
           shipped(SCENE, near, entry("Blast/First stage/Hand over at", "time"),
                   entry("Blast/First stage/Time", "0.004")),
           "WARNING: first_stage: distance of the front at the hand-over is")
    yield ("wave after the end", "biomechanics",
           shipped(BAR, entry("Loads/Load end/Kind", "friedlander"),
                   entry("Loads/Load end/Friedlander/Speed", "4")),
           "after the end of the run at")
    yield ("late afterburn", "blast",
           shipped(BURN, entry("Charges/Afterburn/Kind", "constant"),
                   entry("Charges/Afterburn/Start time", "1"),
                   entry("Charges/Afterburn/End time", "2")),
           "nothing burns on")


def own_meshes():
    """Mesh files whose cells touch without common nodes, or not at all."""
    region = "Region all/"
    bodies = {
        "anatomy": {"Body/Kind": "mesh", "Body/Mesh/File": "@MESH@",
                    "Body/Mesh/Tissues": "1: brain"},
        "biomechanics": {"Mesh/Kind": "file", "Mesh/File": "@MESH@",
                         "Mesh/Tissues": "1: brain", "Time/End time": "1e-5"},
        "head_impact": {"Mesh/Kind": "file", "Mesh/File": "@MESH@",
                        region + "Layer": "any", region + "Material": "tissue",
                        region + "Tissue": "brain", "Time/End time": "1e-5"}}
    for name, said in (
            (TOUCHING, " coincident nodes merged"),
            (APART, ": the mesh is in 2 pieces that share no face; nothing "
                    "passes from one to the other")):
        yield (f"blast: {name}", "blast",
               shipped(VORTEX, entry("Domain/Mesh file", "flat_" + name)), said)
        for application, entries in bodies.items():
            yield (f"{application}: {name}", application, "".join(
                entry(path, value.replace("@MESH@", name))
                for path, value in entries.items()).encode(), said)


def thin_layers():
    """Layers thinner than an element, and what the program chose itself."""
    skin = entry("Body/Phantom/Skin thickness", "0.004")
    head = [entry("Body/Kind", "shape"),
            entry("Body/Shape/Shape", "layered head")]
    yield ("skin of a scene", "scene",
           shipped(SCENE, entry("Scene/End time", "0.005"), skin),
           "WARNING: skin, 4 mm (Body/Phantom/Skin thickness) is thinner than "
           "the elements of 10 mm, so that it has holes or no element; "
           "Scene/Element size of at most 2.3 mm closes the holes")
    yield ("layers of a scene", "scene",
           shipped(SCENE, entry("Scene/End time", "0.005"), *head,
                   entry("Body/Shift", "0, 0, 1"),
                   entry("Scene/Element size", "0.02")),
           "WARNING: layer 1: cerebrospinal fluid, 2.5 mm (Body/Shape/Layers), "
           "layer 2: skeleton, 6.5 mm")
    yield ("layers of anatomy", "anatomy",
           shipped(ANATOMY, *head, entry("Mesh/Element size", "0.02")),
           "WARNING: layer 1: cerebrospinal fluid, 2.5 mm (Body/Shape/Layers), "
           "layer 2: skeleton, 6.5 mm")
    may = ("WARNING: layer 1: cerebrospinal fluid, 3 mm (Body/Shape/Layers) is "
           "thinner than the diagonal of elements of 3 mm and may be in pieces; {} size of at "
           "most 1.7 mm closes it")
    alike = [*head, entry("Body/Shape/Layers", "0.003, 0.006, 0.005")]
    yield ("layer as thick as elements of a scene", "scene",
           shipped(SCENE, entry("Scene/End time", "0.005"), *alike,
                   entry("Body/Shift", "0, 0, 1"),
                   entry("Scene/Element size", "0.003")),
           may.format("Scene/Element"))
    yield ("layer as thick as elements of anatomy", "anatomy",
           shipped(ANATOMY, *alike, entry("Mesh/Element size", "0.003")),
           may.format("Mesh/Element"))
    yield ("skin of biomechanics", "biomechanics",
           shipped("biomechanics/quickstart.prm", skin),
           "WARNING: skin, 4 mm (Body/Phantom/Skin thickness) is thinner than "
           "the elements of 10 mm, so that it has holes or no element; "
           "Mesh/Element size of at most 2.3 mm closes the holes")
    yield ("usual layers of biomechanics", "biomechanics",
           shipped("biomechanics/quickstart.prm"),
           "  cerebrospinal fluid, 2.5 mm (Body/Phantom), skull, 6.5 mm "
           "(Body/Phantom) are thinner than the elements of 10 mm, so that they "
           "have holes or no element; spinal cord, 11 mm (Body/Phantom) is "
           "thinner than the diagonal of these and may be in pieces; "
           "Mesh/Element size of at most 1.4 mm closes the holes")


def bar_of_lung():
    """A body with a lung and nothing else."""
    return shipped(BAR, entry("Injury/Active", "true"),
                   entry("Injury/Chest", "0, 0, 0"), entry("Mesh/Tissue", "lung"))


def remarkable_bodies():
    """Without measures of the brain, and above the ground."""
    yield ("scene of a person in the air", "scene",
           shipped(SCENE, entry("Scene/End time", "0.005"),
                   entry("Body/Shift", "0, 0, 0.06")),
           "  the lowest skin is 6 cm above the ground: the wave runs beneath")
    yield ("scene without a brain", "scene",
           shipped(SCENE, entry("Scene/End time", "0.005"),
                   entry("Body/Kind", "shape"),
                   entry("Body/Shape/Shape", "box"),
                   entry("Body/Shift", "0, 0, 1")),
           "  the body has no brain: brain and head get no measures of injury")
    yield ("bar without a brain", "biomechanics",
           bar_of_lung(),
           "none: brain and head get no measures of injury")
    yield ("head without a brain", "head_impact",
           shipped(HEAD, entry("Injury/Brain", "")),
           "none: no region gets measures of its injury")


def light_persons(*more):
    """Persons of 50 kg, in tissue and in the gas."""
    light = (entry("Body/Phantom/Stature", "1.55"),
             entry("Body/Phantom/Mass", "50"))
    return (shipped("biomechanics/quickstart.prm", *light, *more,
                    entry("Probes/Points", ""),
                    entry("Mesh/Element size", "0.04")),
            shipped(HUMAN, entry("First stage/Kind", "none"), *light, *more))


def other_masses():
    """Lungs that are judged by another mass than that of the body, which is no
    phantom."""
    head = entry("Mesh/Region head/Where", "x > 1") \
        + entry("Mesh/Region head/Tissue", "brain")
    yield ("mass of a mesh", "biomechanics", bar_of_lung() + head.encode(),
           "WARNING: body_mass: relative difference of the body's mass is "
           "estimated at ")


def chosen_masses():
    """Masses that were chosen, or that say nothing of a person."""
    warning = "lungs are"
    for name, run in zip(("biomechanics", "blast"), light_persons()):
        yield f"mass of a phantom in {name}", name, run, warning
    yield "chosen mass", "biomechanics", light_persons(
        entry("Injury/Body mass", "60"))[0], warning
    yield "chosen mass in the gas", "blast", light_persons(
        entry("Loads/Body mass", "60"))[1], warning
    yield "mass of a body of lung", "biomechanics", bar_of_lung(), warning


def unused():
    """Entries that the other choices leave without effect."""
    not_used = " is set but not used: "
    for application, path, lines, said in (
            ("blast", SOD, {"Rigid body/Levels": "2"},
             "Rigid body/Levels" + not_used + "Rigid body/Kind is none"),
            ("blast", SOD, {"Probes/Injury": "true", "Probes/Points": ""},
             "Probes/Points and Probes/Lines and Probes/Gauge planes are empty"),
            ("biomechanics", BAR, {"Mesh/Element size": "0.02"},
             "Mesh/Element size" + not_used + "Mesh/Kind is box, not body"),
            ("biomechanics", BAR, {"Elements/Integration": "full",
                                   "Elements/Hourglass damping": "0.1"},
             "Elements/Hourglass damping" + not_used + "Elements/Integration is "
             "full, not one-point"),
            ("anatomy", ANATOMY, {"Body/Surface/Unit": "mm",
                                  "Body/Surface/Organs": "phantom"},
             "Body/Surface/Unit, Body/Surface/Organs are set but not used: "
             "Body/Kind is phantom, not surface"),
            ("head_impact", HEAD, {"MPM/Cell size": "0.006"},
             "MPM/Cell size" + not_used + "Method is ale, not mpm"),
            ("head_impact", MPM, {"Rezone/Interval": "1e-3"},
             "Rezone/Interval" + not_used + "Method is mpm, not ale"),
            ("blast", SOD, {"Loads/Gauge radius": "0.1"},
             "Loads/Gauge radius" + not_used + "Loads/Record is false"),
            ("blast", SOD, {"First stage/Cell size": "0.1"},
             "First stage/Cell size" + not_used + "First stage/Kind is none"),
            ("biomechanics", BAR, {"Loads/Recorded/Mirror": "y"},
             "Loads/Recorded/Mirror" + not_used
             + "Loads/Recorded/File is empty"),
            ("study", "study/quickstart.prm", {"Study/Samples": "4"},
             "Study/Samples" + not_used + "Study/Design is full grid, not "
             "latin hypercube"),
            ("scene", SCENE, {"Charge/Custom explosive/Density": "1500"},
             "Charge/Custom explosive/Density" + not_used
             + "Charge/Explosive is c-4, not custom"),
            ("scene", SCENE, {"Blast/First stage/Radius": "0.5"},
             "Blast/First stage/Radius" + not_used
             + "Blast/First stage/Hand over at is auto, not radius"),
            ("scene", SCENE, {"Scene/Question": "loads",
                              "Biomechanics/Ground/Active": "true"},
             "Biomechanics/Ground/Active" + not_used
             + "Scene/Question is loads, not injury")):
        near = [entry("Scene/End time", "0.005")] if path == SCENE else []
        yield (said, application,
               shipped(path, *near, *(entry(*one) for one in lines.items())),
               said)


def near_sides():
    """A domain with an open side from which the front returns."""
    yield ("reflection of a scene", "scene",
           shipped("scene/verification/head.prm",
                   entry("Blast/Domain/Lower corner", "-1.28, -0.64, 0"),
                   entry("Blast/Domain/Upper corner", "0.64, 0.64, 1.92"),
                   entry("Blast/Domain/Coarse leaves", "3, 2, 3")),
           "WARNING: reflection: from the charge by the open side x high back")
    yield ("open side that the front runs along", "scene",
           shipped(SCENE, entry("Blast/Domain/Lower corner", "-1.28, -0.9, 0"),
                   entry("Blast/Domain/Upper corner", "4.48, 0.9, 3.2")),
           "WARNING: grazed side: the front runs along the open side y high")
    street = [entry("Scene/End time", "0.006"),
              entry("Blast/Domain/Lower corner", "-1.28, -1.28, 0"),
              entry("Blast/Domain/Upper corner", "4.48, 1.28, 3.2"),
              entry("Blast/Probes/Gauge planes",
                    "2.8, -0.2, 1.5 : 4.4, 0.2, 1.5 : 9, 5")]
    yield ("reflection at a plane of gauges", "scene", shipped(SCENE, *street),
           "by the open side x high back to the probe at 4.4, 0, 1.5 m")
    yield ("reflection at a line of gauges alone", "blast",
           shipped("blast/verification/kingery_bulmash.prm",
                   entry("Time/End time", "0.012"),
                   entry("Probes/Points", ""),
                   entry("Probes/Lines", "0.5 : 3 : 6")),
           "first reflection from an open side at the probe at 3 m")
    yield ("gauges in coarse cells", "scene",
           shipped(SCENE, *street,
                   entry("Blast/Adaptation/Limit far away/Radius", "0.5")),
           "WARNING: gauge cells: cells of 80 mm at the probe at ")


def refused_studies():
    """Outputs that no run has."""
    sod = "study/quickstart.prm"
    for column, reason in (
            ("probes.csv:peak:probe_1_pressure", "has no output"),
            ("history.csv:peek:energy", 'did you mean "history.csv:peak:energy"'),
            ("gauge_measures.csv:chest:peak", "has no output"),
            ("gauges.csv:chest:peak", "has no output")):
        yield (column, "study", shipped(sod, entry("Study/Columns", column)),
               reason)


def warned_studies():
    """A study whose runs warn, that of the reference first."""
    yield ("warnings of the runs of a study", "study",
           shipped("study/quickstart.prm",
                   entry("Study/Parameter file",
                         "@FILES@/blast/verification/kingery_bulmash.prm"),
                   entry("Error/Kind", "reference run"),
                   entry("Error/Reference", "Domain/Coarse leaves=100"),
                   entry("Error/Name", "results.probe_1_impulse")),
           "WARNING: the reference run: air: excess pressure")


def refused_heads():
    """Scenes of head_impact that contradict themselves or select nothing."""
    return head_cases.refused(shipped, entry)


def warned_heads():
    """Scenes of head_impact that are computed with a warning."""
    return head_cases.warned(shipped, entry)


def write_mesh(name, gap, dimension):
    """A Gmsh file of two squares or cubes of 0.1 m with nodes of their own."""
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    if dimension == 3:
        corners = [(*corner, z) for z in (0, 1) for corner in corners]
    nodes = [[0.1 * x for x in corner] for corner in corners]
    nodes += [[x + 0.1 + gap, *rest] for x, *rest in nodes]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes",
             str(len(nodes))]
    for number, node in enumerate(nodes, 1):
        lines.append(" ".join(map(str, [number, *node, 0.][:4])))
    lines += ["$EndNodes", "$Elements", "2"]
    for cell in (0, 1):
        first = len(corners) * cell + 1
        lines.append(" ".join(map(str, [
            cell + 1, 2 * dimension - 1, 2, dimension - 2, 1,
            *range(first, first + len(corners))])))
    with open(os.path.join(FOLDER, name), "w", encoding="utf-8") as file:
        file.write("\n".join([*lines, "$EndElements", ""]))


def make_files():
    shutil.rmtree(FOLDER, ignore_errors=True)
    os.makedirs(os.path.join(FOLDER, A_FOLDER))
    for name in (SHORT, "short.stl", "short.nii", "short.msh", "short.csv"):
        open(os.path.join(FOLDER, name), "w").close()
    for name in (OTHER, "other.stl", "other.ply"):
        with open(os.path.join(FOLDER, name), "w") as file:
            file.write("set A = 1\n")
    for name, gap in ((TOUCHING, 0.), (APART, 0.05)):
        write_mesh("flat_" + name, gap, 2)
        write_mesh(name, gap, 3)


def run(program, arguments):
    """The application's answer; one that hangs is ended, with exit code -9."""
    command = [program, *arguments, "--check", "--output", "output",
               "--verbose"]
    environment = dict(os.environ, CONTRECOUP_CHECK_SECONDS="0")
    try:
        return subprocess.run(command, cwd=FOLDER, env=environment,
                              capture_output=True, text=True, errors="replace",
                              timeout=300)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(command, -9, "", "it hangs")


def run_each(program, names):
    """The answer to each of several files, of one start: what stands between
    their headings, and the lines of stderr that name them."""
    end = run(program, names)
    if len(names) == 1:
        return [end]
    answers = []
    for name in names:
        _, _, rest = end.stdout.partition(name + ":\n")
        said = re.split(r"^case_[0-9]+\.prm:\n", rest, flags=re.M)[0]
        lines = [line for line in end.stderr.splitlines() if name in line]
        answers.append(subprocess.CompletedProcess(
            end.args, 1 if lines else 0, said, "\n".join(lines)))
    others = [line for line in end.stderr.splitlines()
              if not any(name in line for name in names)]
    worst = max(answer.returncode for answer in answers)
    if others or end.returncode != worst:
        return [end] * len(names)
    return answers


def judge_refusal(end, message):
    """Flaw of an answer that should be a refusal."""
    lines = end.stderr.splitlines()
    if end.returncode != 1:
        return f"exit code {end.returncode}: {end.stderr}"
    if len(lines) != 1 or message not in lines[0]:
        return f"the message lacks '{message}': {end.stderr}"
    return ""


def judge_acceptance(end, text):
    if end.returncode != 0 or end.stderr:
        return f"exit code {end.returncode}: {end.stderr}"
    return "" if text in end.stdout else f"'{text}' is not said: {end.stdout}"


def judge_silence(end, text):
    if end.returncode != 0 or end.stderr:
        return f"exit code {end.returncode}: {end.stderr}"
    return f"'{text}' is said: {end.stdout}" if text in end.stdout else ""


def judge_full_output(program):
    """Flaw of the answer of a program whose output has no room."""
    with open("/dev/full", "w", encoding="utf-8") as full:
        end = subprocess.run([program, "--print-parameters"], stdout=full,
                             stderr=subprocess.PIPE, text=True, timeout=300)
    said = end.stderr.splitlines()
    return "" if end.returncode == 3 and len(said) == 1 and \
        "the standard output" in said[0] else \
        f"exit code {end.returncode}: {end.stderr}"


def judge_dump(program):
    """Flaw of the check of a file that holds all entries as
    --print-parameters prints them: it says what that of an empty file says."""
    def words(content):
        with open(os.path.join(FOLDER, DUMP), "wb") as file:
            file.write(content)
        end = run(program, [DUMP])
        said = "\n".join(line for line in (end.stdout + end.stderr).splitlines()
                         if "sets no entry" not in line)
        # Times and memory are measured.
        return end.returncode, re.sub(
            r"[0-9.e+-]+ (s|ms|min|KiB|MiB|GiB)\b *", "", said)

    printed = subprocess.run([program, "--print-parameters"], check=True,
                             capture_output=True, timeout=300).stdout
    try:
        dumped, empty = words(printed), words(b"")
    finally:
        os.remove(os.path.join(FOLDER, DUMP))
    return "" if dumped == empty else f"{dumped} instead of {empty}"


def judge_estimate(program, files):
    """Flaw of --estimate: it lacks a warning of --check about entries, or
    tells of lungs of who stands in the open a wrong number of times."""
    path = os.path.join(files, SCENE)
    for entries, said in (
            (["Charge/Distance=0.3"], 1), (["Charge/Distance=0.3",
                                            "Charge/Height=0.1"], 2),
            (["Body/Shape/Shape=box"], "WARNING: Body/Shape/Shape is set but not "
             "used: Body/Kind is phantom, not shape"),
            (["Charge/Place=-2, 0, 1", "Charge/Distance=3"],
             "WARNING: Charge/Distance is set but not used")):
        words = [word for text in entries for word in ("--set", text)]
        end = subprocess.run([program, path, "--estimate", *words], text=True,
                             capture_output=True, timeout=300, cwd=FOLDER)
        flaw = judge_acceptance(end, said if isinstance(said, str) else "")
        told = len(re.findall("in the open has the lung|incident wave there "
                              "loads the lung", end.stdout))
        if not flaw and isinstance(said, int) and told != said:
            flaw = f"lungs are told {told} times: {end.stdout}"
        if flaw:
            return flaw
    return ""


def judge_forecast(program, files):
    """Trial runs of a scene are made with Scene/Forecast = true alone."""
    path = os.path.join(files, "scene/verification/head.prm")
    shutil.rmtree("no_cache", ignore_errors=True)  # of an earlier run
    environment = dict(os.environ, CONTRECOUP_CHECK_SECONDS="0.1",
                       XDG_CACHE_HOME=os.path.abspath("no_cache"))
    for wanted in ("true", "false"):
        end = subprocess.run(
            [program, path, "--check", "--verbose", "--set",
             "Scene/Question=loads", "--set", "Scene/Error estimate=false",
             "--set", "Scene/Cell size=0.04", "--set",
             f"Scene/Forecast={wanted}"], env=environment, text=True,
            capture_output=True, timeout=300, cwd=FOLDER)
        found = "Calibrating by trial runs" in end.stdout
        if end.returncode != 0 or found != (wanted == "true"):
            return f"Forecast = {wanted}: {end.stdout}{end.stderr}"
    return ""


def main(programs, repository):
    make_files()
    before = sorted(os.listdir(FOLDER))
    files = os.path.join(repository, "parameter_files")
    count, problems = 0, []

    def judge(name, end, verdict):
        nonlocal count
        count += 1
        if sorted(os.listdir(FOLDER)) != before:
            verdict = f"wrote {sorted(os.listdir(FOLDER))}"
        if verdict:
            problems.append(f"{name}: {verdict}")

    for cases, verdict_of in [(refused_files, judge_refusal),
                              (refused_entries, judge_refusal),
                              (refused_other_files, judge_refusal),
                              (refused_tissues, judge_refusal),
                              (refused_blasts, judge_refusal),
                              (refused_bodies, judge_refusal),
                              (refused_gas_selections, judge_refusal),
                              (refused_scenes, judge_refusal),
                              (refused_studies, judge_refusal),
                              (refused_heads, judge_refusal),
                              (accepted, judge_acceptance),
                              (unused, judge_acceptance),
                              (near_sides, judge_acceptance),
                              (warned_studies, judge_acceptance),
                              (thin_layers, judge_acceptance),
                              (remarkable_bodies, judge_acceptance),
                              (other_masses, judge_acceptance),
                              (chosen_masses, judge_silence),
                              (own_meshes, judge_acceptance),
                              (warned_heads, judge_acceptance)]:
        of_application = {}
        for case in cases():
            of_application.setdefault(case[1], []).append(case)
        for application, group in of_application.items():
            names = [f"case_{number:03d}.prm" for number in range(len(group))]
            for name, (_, _, content, _) in zip(names, group):
                with open(os.path.join(FOLDER, name), "wb") as file:
                    file.write(content.replace(b"@FILES@", files.encode()))
            ends = run_each(os.path.join(programs, application), names)
            for name in names:
                os.remove(os.path.join(FOLDER, name))
            for (name, _, _, text), end in zip(group, ends):
                judge(name, end, verdict_of(end, text))
    for name, reason in [(MISSING, "there is no such file"),
                         (A_FOLDER, "it is a folder")]:
        end = run(os.path.join(programs, "scene"), [name])
        judge(name, end, judge_refusal(
            end, f'cannot read the parameter file "{name}": {reason}'))
    for case, judge_scene in (("trial runs", judge_forecast),
                              ("--estimate", judge_estimate)):
        judge(case, None, judge_scene(os.path.join(programs, "scene"), files))
    for application in ("blast", "anatomy", "biomechanics", "head_impact",
                        "scene", "study"):
        program = os.path.join(programs, application)
        for case, verdict in (("> /dev/full", judge_full_output(program)),
                              ("with all entries", judge_dump(program))):
            judge(f"{application} {case}", None, verdict)
    print("\n".join(problems) or f"all {count} cases are as wanted")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
