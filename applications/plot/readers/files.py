# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Tools of all readers: objects, rows and numbers, and the one line that names
a file which cannot be read."""

import contextlib
import csv
import os
import re
import zlib

import numpy as np

from plot.readers import formats, json_shape


class BrokenInput(Exception):
    """One line: which file, and what is wrong with it."""


@contextlib.contextmanager
def reading(path):
    """Turns whatever a reader throws into one line that names the file."""
    try:
        yield
    except (OSError, ValueError, KeyError, IndexError, TypeError, zlib.error,
            StopIteration, AttributeError, EOFError, csv.Error) as problem:
        words = " ".join(str(problem).split()) or type(problem).__name__
        raise BrokenInput(f"{path}: cannot be read: {words}") from problem


def read_json(path, shape):
    """An object of this shape, see json_shape; {} without a file. Its name is
    that of its format."""
    if not os.path.exists(path):
        return {}
    with reading(path), open(path, encoding="utf-8") as file:
        content = json_shape.parse(file.read())
        name = os.path.splitext(os.path.basename(path))[0]
        formats.require_readable(name, content.get("format"))
        json_shape.check(content, shape)
    return content


def read_text(path):
    with reading(path), open(path, encoding="utf-8") as file:
        return file.read()


def read_rows(path):
    """Its rows_of(), none without the file."""
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(rows_of(file))


def rows_of(file):
    """The rows of a CSV file with a header, by its names."""
    reader = csv.DictReader(file, strict=True)
    if not reader.fieldnames:
        raise ValueError("it is empty")
    for row in reader:
        if None in row or None in row.values():
            raise ValueError(f"line {reader.line_num} is not as long as the "
                             "header")
        yield row


def as_number(value):
    """A finite number, or None."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    return float(value) if np.isfinite(value) else None


def points_of(text):
    """Points "x, y, z; x, y, z" as rows."""
    return np.array([[float(x) for x in part.split(",")] for part in
                     (text or "").split(";") if part.strip()]).reshape(-1, 3)


def read_parameters(path):
    """All entries of a parameter file as "Section/Entry", none without the
    file."""
    entries, sections = {}, []
    if not os.path.exists(path):
        return entries
    with reading(path), open(path, encoding="utf-8") as file:
        for line in file:
            line = line.split("#")[0].strip()
            if line.startswith("subsection "):
                sections.append(line[len("subsection "):].strip())
            elif line == "end":
                sections.pop()
            elif match := re.fullmatch(r"set (.*?)\s*=\s*(.*)", line):
                entries["/".join(sections + [match[1]])] = match[2]
    return entries
