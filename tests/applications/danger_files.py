# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Files that the tests of danger.py need, written where they run: surfaces in
millimetres, and loads that blast records on a ball and on a wedge."""

import os
import subprocess

FILES = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__)))), "parameter_files")
BALL = "ball.prm"
WEDGE = "wedge.prm"
LOADS = "loads.prm"
PRESET = """
subsection Biomechanics
  subsection Elements
    set Kinematics = neo-hookean
  end
end
"""

BLAST = """
subsection Domain
  set Dimension     = 3
  set Lower corner  = -0.32, {low}, -0.32
  set Upper corner  = 0.32, 0.32, 0.32
  set Coarse leaves = 4, {leaves}, 4
end
subsection Boundaries
  set y low = symmetry
end
subsection Rigid body
  set Kind = body
end
subsection Loads
  set Record = true
end
subsection Initial state
  set Kind = regions
  subsection Background
    set Density  = 1.2
    set Pressure = 1e5
  end
  subsection Region blast
    set Shape    = sphere
    set Center   = -0.3, 0, 0
    set Radius   = 0.12
    set Density  = 12
    set Pressure = 3e6
  end
end
subsection Time
  set End time = 3e-4
end
"""

BIOMECHANICS = """
subsection Mesh
  set Kind         = body
  set Element size = 0.02
end
subsection Loads
  subsection Recorded
    set File = {loads}
  end
end
subsection Time
  set End time = 1e-5
end
"""

BODIES = {BALL: """
subsection Body
  set Kind = shape
  subsection Shape
    set Shape = sphere
    set Size  = 0.1
  end
end
""", WEDGE: """
subsection Body
  set Kind = surface
  subsection Surface
    set File = wedge.stl
  end
end
"""}


def write_stl(path, corners, triangles):
    """An ASCII STL; normals are left to the reader."""
    with open(path, "w") as file:
        file.write("solid made\n")
        for triangle in triangles:
            file.write("facet normal 0 0 0\nouter loop\n")
            for corner in triangle:
                file.write("vertex {} {} {}\n".format(*corners[corner]))
            file.write("endloop\nendfacet\n")
        file.write("endsolid made\n")


def write_box(path, size):
    """A box of this size around 0."""
    corners = [[(0.5 if index >> d & 1 else -0.5) * size[d] for d in range(3)]
               for index in range(8)]
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3),
             (0, 2, 3, 1), (4, 5, 7, 6)]
    write_stl(path, corners, [part for a, b, c, d in quads
                              for part in ((a, b, c), (a, c, d))])


def write_wedge(path):
    """A prism with an edge at its front, x > 0, and a flat back."""
    corners = [(x, y, z) for z in (-0.1, 0.1)
               for x, y in ((0.15, 0.), (-0.1, 0.1), (-0.1, -0.1))]
    write_stl(path, corners, [
        (0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4),
        (2, 0, 3), (2, 3, 5)])


def write_text(path, text):
    with open(path, "w") as file:
        file.write(text)


def record(blast, name, output, low=-0.32, leaves=4):
    """Loads on the body of a file."""
    path = output + "_blast.prm"
    write_text(path, BLAST.format(low=low, leaves=leaves) + BODIES[name])
    subprocess.run([blast, path, "--output", output, "--overwrite"],
                   check=True, stdout=subprocess.DEVNULL)
    return os.path.abspath(os.path.join(output, "loads.h5"))


def write(application, blast):
    """Writes what this application needs; returns names of places and their
    paths."""
    write_box("man.stl", (500., 300., 1756.))
    write_box("head.stl", (150., 180., 220.))
    places = {"MAN": os.path.abspath("man.stl"),
              "HEAD": os.path.abspath("head.stl")}
    if application == "scene":
        write_text("preset.prm", PRESET)
        write_text(LOADS, f"include {FILES}/scene/verification/head.prm\n"
                   "include preset.prm\nsubsection Scene\n"
                   "  set Question = loads\nend\n")
    if application != "biomechanics":
        return places
    write_wedge("wedge.stl")
    for name in (BALL, WEDGE):
        loads = record(blast, name, "recorded_" + name[:-4])
        write_text(name, BIOMECHANICS.format(loads=loads) + BODIES[name])
    places["HALF"] = record(blast, BALL, "recorded_half", low=0., leaves=2)
    return places
