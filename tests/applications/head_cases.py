# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Scenes of head_impact whose entries contradict one another or select nothing,
for input_cases.py: a name, the overrides of a shipped file, and what must be
said."""

HEAD = "head_impact/quickstart.prm"
SOD = "head_impact/verification/sod.prm"
SPHERE = "head_impact/verification/fluid_in_rigid_sphere.prm"
DAM = "head_impact/verification/dam_break.prm"
COLUMN = "head_impact/verification/water_hammer_mpm.prm"
LAYERS = ("brain", "CSF", "skull")
COARSE = {"Mesh/Cell size": "0.02", "MPM/Cell size": "0.012"}


def moving(axis, speed):
    """Overrides that give all layers this velocity along an axis."""
    return {f"Region {layer}/Velocity {axis}": speed for layer in LAYERS}


def refused_by_both():
    """Cases that neither moving meshes nor particles can compute."""
    yield ("velocity across a plane of symmetry", moving("x", "2.5"),
           "Velocity x is 2.5 m/s across the plane of symmetry normal to x")
    yield ("body force across a plane of symmetry", {"Body force/y": "-9.81"},
           "Body force/y is -9.81 m/s^2 across the plane of symmetry normal to "
           "y")
    yield ("no such plane of symmetry", {"Side plane z/Kind": "wall"},
           "Side plane z selects no side: Mesh/Symmetry planes does not name z")
    yield ("free plane of symmetry", {"Side plane x/Kind": "free"},
           "Side plane x: Mesh/Symmetry planes makes it a wall at rest")
    yield ("region in no place", {"Region drop/Where": "x > 2",
                                  "Region drop/Material": "tait",
                                  "Region drop/Density": "1000"},
           'Region drop/Where = "x > 2" selects no ')
    yield ("region below another", {"Region other/Layer": "brain",
                                    "Region other/Material": "tissue"},
           'Region brain/Layer = "brain" selects no ')
    yield ("layer without region", {"Region skull/Layer": "csf",
                                    "Region CSF/Layer": "csf"}, " is in none")
    yield ("unknown brain", {"Injury/Brain": "brian"},
           'Injury/Brain: there is no region "brian"; did you mean "brain"?')
    yield ("measures of the start alone", {"Injury/Every steps": "1000000"},
           "Injury/Every steps = 1000000 selects no step after the start")
    yield ("thresholds of the chest", {
        "Injury/Measure injury_lung_exposure/Thresholds": "0.5: harm"},
        "Injury/Measure injury_lung_exposure: this measure is not taken here; "
        "those are injury_bric")
    yield ("liquid brain", {"Injury/Brain": "CSF"},
           'Injury/Brain: region "CSF" is a fluid')
    yield ("probe outside", {"Probes/Points": "0, 0, 0.1"},
           "Probes/Points: (0, 0, 0.1) m is outside of the m")
    yield ("plane in the head", {"Plane wall/Point": "0, 0, -0.09"},
           "Plane wall: it cuts the body at the start, which reaches 0.001 m")
    yield ("plane behind", moving("z", "3"),
           'Plane wall/Normal = "0, 0, 1" selects no matter that could reach '
           "it: the body is 0 m away and does not come nearer")
    yield ("solid with the density of air", {"Region skull/Density": "1.2"},
           "Region skull: in a solid of Density = 1.2 kg/m^3 and these moduli")


def refused_by_one():
    """Cases that one method cannot compute."""
    yield (HEAD, "plane without a surface", {"Side surface/Kind": "wall"},
           'Plane wall/Point = "0, 0, -0.091" selects no free surface')
    yield (HEAD, "slip without smoothing", {"Region CSF/Interface": "slip",
                                            "Rezone/Kind": "none"},
           "Interface = slip needs Rezone/Kind = elastic")
    yield (SOD, "slip along nothing", {"Region gas/Interface": "slip",
                                       "Rezone/Kind": "elastic"},
           'Region gas/Interface = "slip" selects no face of a region')
    yield (SOD, "plane of symmetry of a box", {"Mesh/Symmetry planes": "x"},
           "Mesh/Symmetry planes is for Mesh/Kind = layered head or file")
    yield (SPHERE, "reference without probes", {"Probes/Points": ""},
           "compares pressures at Probes/Points, which is empty")
    particles = {"Method": "mpm"}
    yield (HEAD, "coupling of particles",
           dict(particles, **{"Coupling/Scheme": "loose"}),
           "Coupling/Scheme = loose needs Method = ale")
    yield (HEAD, "heat in particles",
           dict(particles, **{"Heat source/Power": "1"}),
           "Heat source/Power = 1 needs Method = ale")
    yield (HEAD, "friction of one field",
           dict(particles, **{"MPM/Friction": "0.3"}),
           "MPM/Friction = 0.3 acts between the fields of regions")
    yield (HEAD, "slip in one field",
           dict(particles, **{"MPM/Fields": "one",
                              "Region CSF/Interface": "slip"}),
           "MPM/Fields = one makes all regions stick")
    yield (COLUMN, "contact of one region", {"MPM/Fields": "contact"},
           "MPM/Fields = contact selects no interface")


def warned_of():
    """Cases computed with a warning, or a word in the plan."""
    for method in ("ale", "mpm"):
        yield (HEAD, f"{method}: thresholds of the user",
               dict(COARSE, **{
                   "Method": method,
                   "Injury/Measure injury_hic15/Thresholds": "300: harm"}),
               "injury_hic15 with 300: harm (the user's own)")
        yield (HEAD, f"{method}: contact after the end",
               {"Method": method, "Plane wall/Point": "0, 0, -0.121"},
               "WARNING: Plane wall: the body is 0.03 m away and comes nearer "
               "at 3 m/s, and reaches it at 0.01 s, after Time/End time = "
               "0.005 s")
        yield (HEAD, f"{method}: inclined wall",
               {"Method": method, "Plane wall/Normal": "1, 0, 1",
                "Plane wall/Point": "-0.0643468, 0, -0.0643468"},
               "WARNING: asymmetry: normals of walls across planes of symmetry "
               "is estimated at 0.707")
    yield (HEAD, "entry of another material",
           {"Region brain/Shear modulus": "2000"},
           "WARNING: Region brain/Shear modulus is set but not used: Region "
           "brain/Material is tissue, not viscoelastic")
    yield (DAM, "known front after the end", {"Time/End time": "0.1"},
           "WARNING: Reference/Front/Times goes on to 0.149 s, after Time/End "
           "time = 0.1 s: 4 of 6 positions are compared")


def files(cases, shipped, entry):
    """Each case with the content of its file."""
    for path, name, overrides, said in cases:
        lines = [entry(key, value) for key, value in overrides.items()]
        yield f"head: {name}", "head_impact", shipped(path, *lines), said


def refused(shipped, entry):
    """The cases that must be refused."""
    both = ((HEAD, f"{method}: {name}",
             dict(COARSE, Method=method, **overrides), said)
            for method in ("ale", "mpm")
            for name, overrides, said in refused_by_both())
    yield from files(both, shipped, entry)
    yield from files(refused_by_one(), shipped, entry)


def warned(shipped, entry):
    """The cases that must be accepted with a warning or a word."""
    yield from files(warned_of(), shipped, entry)
