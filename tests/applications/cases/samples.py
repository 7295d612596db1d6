"""The numbers in the files of runs: reading, comparing, and a few samples that
stand for a large file.

A tolerance is "1e-8", of the largest absolute value of a column or field, or
"PATTERN=1e-8" for those whose name matches, or "PATTERN=1e-9 absolute" where
the exact value is zero; of several the last one that matches counts. Patterns
are of "COLUMN" or "FILE:COLUMN", with * and ?.
"""

import csv
import fnmatch
import io
import os
import re
import sys

import numpy

APPLICATIONS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..",
                            "..", "..", "applications")

# Samples of a large array that a reference keeps.
N_SAMPLES = 24
HEADER = ["array", "size", "missing", "smallest", "largest", "mean", "square"]


def read(path):
    """All arrays of a table (.csv), load file (.h5), plane (.vti), skin (.vtp)
    or mesh (.vtu), by name."""
    if path.endswith(".h5"):
        return read_hdf5(path)
    if path.endswith((".vtu", ".vti", ".vtp")):
        sys.path.append(APPLICATIONS)
        from plot.readers import vtk_file
        return vtk_file.read(path)
    with open(path, newline="", encoding="utf-8") as file:
        return read_table(file.read())


def read_table(text):
    """Columns of a table by name; a table whose rows have names gives a number
    by the names of its row and column. Columns of words are lists."""
    header, *rows = csv.reader(io.StringIO(text))
    columns = {}
    if header[1:] == ["n_masters", "masters and weights"]:
        # Hanging nodes: of each as many values as it has masters.
        rows = [[row[0], row[1], value] for row in rows for value in row[2:]]
    for name, *words in zip(header, *rows):
        try:
            columns[name] = numpy.array([float(word) for word in words])
        except ValueError:
            columns[name] = words
    first = columns.get(header[0])
    if rows and isinstance(first, list) and len(set(first)) == len(first):
        return {f"{row} {name}": column[number:number + 1]
                for name, column in columns.items()
                for number, row in enumerate(first)}
    return columns


def read_hdf5(path):
    import h5py
    found = {}
    with h5py.File(path, "r") as file:
        def visit(name, item):
            if isinstance(item, h5py.Dataset) and item.dtype.kind in "fiu":
                found[name] = item[...]
        file.visititems(visit)
    return found


def flaw(values, may_miss):
    """Flaw of the numbers of an array; empty if there is none."""
    if isinstance(values, list):
        return ""
    if values.size == 0:
        return "is empty"
    if numpy.isinf(values).any():
        return "is infinite"
    missing = numpy.isnan(values)
    if missing.all() or (missing.any() and not may_miss):
        return f"has {missing.sum()} of {values.size} that are no numbers"
    return ""


def are_equal(one, two):
    """Whether two files hold the same arrays."""
    return one.keys() == two.keys() and all(
        numpy.array_equal(values, two[name], equal_nan=values.dtype.kind == "f")
        for name, values in one.items())


def tolerance_of(tolerances, file, column):
    """(number, whether it is absolute) of the last entry that matches."""
    plain = re.sub(r" \[[^]]*\]$", "", column)
    found = None
    for entry in tolerances:
        pattern, equals, number = entry.rpartition("=")
        if not equals or fnmatch.fnmatchcase(plain, pattern) or \
                fnmatch.fnmatchcase(f"{file}:{plain}", pattern):
            found = number.split()
    if found is None or found[1:] not in ([], ["absolute"]):
        raise ValueError(f"no tolerance for {file}:{plain} in {tolerances}")
    return float(found[0]), len(found) > 1


def compare(tolerances, file, one, two):
    """The largest difference over its tolerance, and what is beyond."""
    if one.keys() != two.keys():
        return numpy.inf, ["other columns: "
                           + ", ".join(sorted(one.keys() ^ two.keys()))]
    worst, reasons = 0., []
    for name, expected in one.items():
        found = two[name]
        if isinstance(expected, list) or isinstance(found, list):
            if list(expected) != list(found):
                reasons.append(f"{name}: other words")
            continue
        if expected.shape != found.shape:
            reasons.append(f"{name}: {found.shape} values instead of "
                           f"{expected.shape}")
            continue
        if (numpy.isnan(expected) != numpy.isnan(found)).any():
            reasons.append(f"{name}: numbers are missing in other places")
            continue
        there = ~numpy.isnan(expected)
        expected, found = (values[there].astype(float)
                           for values in (expected, found))
        if expected.size == 0:
            continue
        number, absolute = tolerance_of(tolerances, file, name)
        allowed = number * (1. if absolute else numpy.abs(expected).max())
        differences = numpy.abs(found - expected)
        at = differences.argmax()
        if differences[at] > allowed:
            reasons.append(
                f"{name}: {found[at]:.12g} instead of {expected[at]:.12g} at "
                f"{at}, allowed is {allowed:.3g}")
        if differences[at] > 0.:
            worst = max(worst, differences[at] / allowed if allowed > 0.
                        else numpy.inf)
    return (numpy.inf if reasons and worst <= 1. else worst), reasons


def summarise(arrays):
    """A short table that stands for a file: of each array the size, how many
    numbers are missing, extremes, mean, mean square and evenly spread
    samples."""
    rows = [HEADER + [f"sample {i}" for i in range(N_SAMPLES)]]
    for name, values in sorted(arrays.items()):
        if isinstance(values, list) or values.dtype.kind not in "fiu":
            continue
        flat = values.astype(float).ravel()
        there = flat[~numpy.isnan(flat)]
        picks = numpy.linspace(0, there.size - 1, N_SAMPLES).round()
        numbers = [there.min(), there.max(), there.mean(),
                   numpy.sqrt(numpy.mean(there ** 2))] if there.size else [0.] * 4
        numbers += [there[int(pick)] if there.size else 0. for pick in picks]
        rows.append([name, flat.size, flat.size - there.size]
                    + [f"{number:.12g}" for number in numbers])
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def compare_summaries(tolerances, file, expected, found):
    """compare() of two tables of summarise()."""
    one, two = ({row[0]: numpy.array(list(map(float, row[1:])))
                 for row in list(csv.reader(io.StringIO(text)))[1:]}
                for text in (expected, found))
    for name in one.keys() & two.keys():
        for column, title in ((0, "size"), (1, "missing numbers")):
            if one[name][column] != two[name][column]:
                return numpy.inf, [f"{name}: {title} {two[name][column]:.0f} "
                                   f"instead of {one[name][column]:.0f}"]
    return compare(tolerances, file,
                   {name: values[2:] for name, values in one.items()},
                   {name: values[2:] for name, values in two.items()})
