"""Tests of fields and lines of gauges; kinds of run_case.py."""

import contextlib
import os
import sys

import numpy

import samples
from case import Failed, Skipped, check_bound, require

LINE = os.path.join("fields", "gauges_line_1.csv")
# Columns of a line of gauges that runs have in common.
OF_WAVE = {"peak": "peak_overpressure [Pa]", "impulse": "impulse [Pa s]",
           "arrival": "arrival [s]"}
LETHALITY = "lung_lethality [-]"


def gauge_lines(case):
    """Runs with each --vary value record the same at the first line of gauges:
    bounds of the largest relative "peak", "impulse" and "arrival" differences,
    of the largest "rise" of the probability of death by lung injury from a gauge
    to the next one away from the charge, in any run, and of the number of gauges
    where that probability is "unknown"."""
    entry, values = case.options.vary.split("=", 1)
    lines = []
    for value in values.split("|"):
        output = case.folder(value)
        case.run(output, extra=["--set", f"{entry}={value}"])
        lines.append(samples.read(os.path.join(output, LINE)))
    found = {}
    for name, column in OF_WAVE.items():
        one, *others = (line[column] for line in lines)
        differences = numpy.max([abs(other / one - 1.) for other in others],
                                axis=0)
        at = differences.argmax()
        print(f"{name}: {differences[at]:.2%} at gauge {at + 1} of "
              f"{len(differences)}: {', '.join(f'{line[column][at]:.6g}' for line in lines)}")
        found[name] = float(differences[at])
    lethality = [line[LETHALITY] for line in lines]
    found["rise"] = float(max(0., *(numpy.nanmax(numpy.diff(values))
                                    for values in lethality)))
    found["unknown"] = int(sum(numpy.isnan(values).sum()
                               for values in lethality))
    for bound in case.options.bound:
        check_bound(found, bound)


def foreign_reader(case):
    """meshio reads each VTU file of the run, and finds the arrays, sizes and
    extremes in it that the tests' own reader finds."""
    try:
        import meshio
    except ImportError as reason:
        raise Skipped("there is no python3-meshio") from reason
    output = case.straight()
    paths = [os.path.join(here, name) for here, _, names in os.walk(output)
             for name in names if name.endswith(".vtu")]
    require(paths, f"{output} has no VTU file")
    for path in sorted(paths):
        try:
            with contextlib.redirect_stderr(sys.stdout):
                mesh = meshio.read(path)
        except (Exception, SystemExit) as reason:
            raise Failed(f"meshio cannot read {path}: {reason}") from reason
        arrays = {name: values for name, values in samples.read(path).items()
                  if isinstance(values, numpy.ndarray)}
        compare_fields(path, mesh, arrays)
    print(f"meshio {meshio.__version__} has read {len(paths)} files")


def compare_fields(path, mesh, arrays):
    """Fields that meshio found, against the arrays of the file."""
    cells = {name: numpy.concatenate(blocks)
             for name, blocks in mesh.cell_data.items()}
    fields = {**mesh.point_data, **cells}
    require(fields and fields.keys() <= arrays.keys(),
            f"{path}: meshio finds {sorted(fields)} of {sorted(arrays)}")
    require(3 * len(mesh.points) == arrays["points"].size,
            f"{path}: meshio finds {len(mesh.points)} points")
    for name, values in fields.items():
        own = arrays[name]
        require(values.size == own.size and numpy.array_equal(
            values.ravel(), own.ravel(), equal_nan=own.dtype.kind == "f"),
                f"{path}: meshio finds another {name}")


KINDS = {kind.__name__: kind for kind in (gauge_lines, foreign_reader)}
