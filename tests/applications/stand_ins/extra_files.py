"""Files of the stand-in decay.py besides its history, like those of an
application, of which the judges of run_case.py know the answer. The entry
"Writes" names one of WRITERS, "Flaw" what is wrong with it."""

import csv
import os
import sys

import numpy

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..",
                             "..", "plot"))
import tiny_files  # noqa: E402


def write(output, entries):
    WRITERS[entries["Writes"]](output, entries)


def write_pictures(output, entries):
    """A diagram; flaws: blank, cut."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    folder = os.path.join(output, "pictures")
    os.makedirs(folder)
    path = os.path.join(folder, "history.png")
    if entries["Flaw"] == "blank":
        pyplot.imsave(path, numpy.ones((400, 600, 3)))
    else:
        figure, axes = pyplot.subplots()
        axes.plot([0., 1., 2.], [0., 1., 4.])
        figure.savefig(path)
    if entries["Flaw"] == "cut":
        os.truncate(path, os.path.getsize(path) // 2)
    print(f"pictures in {folder}")


def write_plane(output, values, lower, upper):
    tiny_files.write_plane(os.path.join(output, "fields", "plane_0000.vti"),
                           {"pressure": (values, "Pa")}, lower, upper,
                           axes="xy")


def grid(n, upper):
    axis = numpy.linspace(0., upper, n)
    return numpy.meshgrid(axis, axis)


def write_stem(output, entries):
    """A smooth Mach stem; flaw: kink."""
    x, y = grid(201, 1.)
    front = 0.6 - 0.5 * y ** 2
    if entries["Flaw"] == "kink":
        front += 0.03 * (y < 0.05)
    # A front three samples wide, so that its place is known to less than one.
    values = 10. + 95. * (1. - numpy.tanh((x - front) / 0.01))
    write_plane(output, values / 10., [0., 0.], [1., 1.])


def write_wedge(output, entries):
    """Regular reflection at a wedge of 60 degrees, the reflected shock at 20
    degrees; flaw: steep, 25 degrees."""
    x, y = grid(1001, 1.)
    angle = numpy.radians(60.)
    reflected = numpy.radians(25. if entries["Flaw"] == "steep" else 20.)
    shock = 0.4
    along = x * numpy.cos(angle) + y * numpy.sin(angle)
    above = y * numpy.cos(angle) - x * numpy.sin(angle)
    foot = shock / numpy.cos(angle)
    behind = (along < foot) & (above < (foot - along) * numpy.tan(reflected))
    values = numpy.where(x < shock, 2., 1.)
    values = numpy.where(behind, 4., values)
    write_plane(output, values, [0., 0.], [1., 1.])


def write_reflection(output, entries):
    """Probes on the ground below a blast from a height of 1 m whose front runs
    at 1000 m/s; behind it the sound is so fast that reflection is regular up
    to 1.2 m; flaw: far, up to 1.5 m."""
    limit = 1.5 if entries["Flaw"] == "far" else 1.2
    ranges = numpy.linspace(0.4, 2., 17)
    times = numpy.linspace(0., 3e-3, 3001)
    header, columns = ["time [s]"], [times]
    for number, x in enumerate(ranges, 1):
        distance = numpy.hypot(x, 1.)
        speed = 1000. * distance / x
        sound = speed / (1. + 0.2 * (limit - x))
        arrived = times >= distance / 1000.
        decay = numpy.exp(-(times - distance / 1000.) / 1e-3)
        pressure = numpy.where(arrived, 1e5 + 9e5 * decay, 1e5)
        header += [f"probe_{number}_{name} [-]" for name in
                   ("pressure", "density", "velocity_x")]
        columns += [pressure, numpy.full_like(times, 1.4e6 / sound ** 2),
                    numpy.zeros_like(times)]
    with open(os.path.join(output, "probes.csv"), "w", newline="",
              encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(header)
        table.writerows(numpy.array(columns).T.tolist())
    points = "; ".join(f"{x:.10g}, 0" for x in ranges)
    with open(os.path.join(output, "parameters.prm"), "w",
              encoding="utf-8") as file:
        file.write(f"subsection Probes\n  set Points = {points}\nend\n")


def write_gauges(output, entries):
    """A wave that arrives at a gauge at 0.5 s; its peak of 2 is too low by the
    step size. Flaws: early (samples of rest), leaky (impulse is lost), flat
    (the error does not depend on the step size)."""
    smallest = float(entries["Loads/Smallest overpressure"])
    size = 0.01 if entries["Flaw"] == "flat" else float(entries["Step size"])
    peak = 2. * (1. - size)
    times = numpy.arange(0.01, 1.005, 0.01)
    samples = numpy.where(times > 0.5, peak * (1.5 - times), 0.)
    samples[49] = 1e-3 * peak
    kept = samples > smallest * peak
    first = 0 if entries["Flaw"] == "early" else kept.argmax()
    # The first sample is the mean from the beginning on.
    begin = samples[:first + 1].sum() * 0.01 / times[first]
    if entries["Flaw"] == "leaky" and smallest > 1e-3:
        begin = 0.
    rows = [(times[first], begin), *zip(times[first + 1:],
                                        samples[first + 1:])]
    with open(os.path.join(output, "load_gauges.csv"), "w", newline="",
              encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["time [s]", "gauge_1 [Pa]"])
        table.writerows(rows)


def write_gauge_line(output, entries):
    """A line of gauges that a blast passes; flaws: other (with "Skip", its peaks
    are 10 % higher), deadly (farther away more people die)."""
    x = numpy.linspace(1., 5., 5)
    peak = 1e6 / x ** 2
    lethality = 1. / x
    if entries["Flaw"] == "other" and entries["Skip"] == "true":
        peak = 1.1 * peak
    if entries["Flaw"] == "deadly":
        lethality[3] = 0.9
    os.makedirs(os.path.join(output, "fields"))
    columns = {"x [m]": x, "peak_overpressure [Pa]": peak,
               "impulse [Pa s]": 100. / x, "arrival [s]": 1e-3 * x,
               "lung_lethality [-]": lethality}
    with open(os.path.join(output, "fields", "gauges_line_1.csv"), "w",
              newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(columns)
        table.writerows(numpy.array(list(columns.values())).T.tolist())


def write_vtu(output, entries):
    """Two tetrahedra; flaw: words, an array of texts."""
    text = tiny_files.elements([
        ("points", numpy.array([[0., 0., 0.], [1., 0., 0.], [0., 1., 0.],
                                [0., 0., 1.], [1., 1., 1.]]), 3, ""),
        ("connectivity", numpy.array([0, 1, 2, 3, 1, 2, 3, 4], "uint32"), 1, ""),
        ("offsets", numpy.array([4, 8], "uint32"), 1, ""),
        ("types", numpy.array([10, 10], "uint8"), 1, ""),
        ("pressure", numpy.arange(5.), 1, "Pa"),
        ("tissue", numpy.array([1, 2], "uint8"), 1, "")])
    lines = text.splitlines()
    sections = {"Points": lines[:1], "Cells": lines[1:4],
                "PointData": lines[4:5], "CellData": lines[5:]}
    if entries["Flaw"] == "words":
        sections["CellData"].append('<DataArray type="String" Name="names" '
                                    'format="ascii">97 0</DataArray>')
    body = "\n".join(f"<{name}>\n" + "\n".join(rows) + f"\n</{name}>"
                     for name, rows in sections.items())
    tiny_files.write(
        os.path.join(output, "fields", "mesh_0000.vtu"),
        '<UnstructuredGrid>\n<Piece NumberOfPoints="5" NumberOfCells="2">\n'
        + body + "\n</Piece>\n</UnstructuredGrid>\n")


WRITERS = {"line": write_gauge_line, "vtu": write_vtu,
           "pictures": write_pictures, "stem": write_stem,
           "wedge": write_wedge, "reflection": write_reflection,
           "gauges": write_gauges}
