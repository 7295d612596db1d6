#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Runs benchmark programs and collects what they measure.

run_benchmarks.py CSV PROGRAM... : each program, with arguments after blanks,
prints rows 'name,value,unit' on stdout. CSV gets all of them; a Markdown table
next to it has them as well and is printed.
"""

import csv
import math
import os
import subprocess
import sys


def measure(program):
    """The rows of one program: (name, value, unit)."""
    words = program.split(" ") if not os.path.exists(program) else [program]
    print(f"running {os.path.basename(words[0])} ...", flush=True)
    run = subprocess.run(words, check=True, stdin=subprocess.DEVNULL,
                         stdout=subprocess.PIPE, text=True)
    rows = []
    for line in run.stdout.splitlines():
        row = [entry.strip() for entry in line.split(",")]
        if len(row) != 3 or not math.isfinite(float(row[1])):
            raise ValueError(f"{program} printed '{line}' instead of "
                             "'name,value,unit'")
        rows.append(row)
    return rows


def to_markdown(rows):
    lines = ["| benchmark | value | unit |", "|---|---:|---|"]
    lines += [f"| {name} | {float(value):.4g} | {unit} |"
              for name, value, unit in rows]
    return "\n".join(lines) + "\n"


def main(arguments):
    if len(arguments) < 2:
        print("usage: run_benchmarks.py CSV PROGRAM...", file=sys.stderr)
        return 1
    path, programs = arguments[0], arguments[1:]
    rows = [row for program in programs for row in measure(program)]
    with open(path, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows(
            [("name", "value", "unit"), *rows])
    table = to_markdown(rows)
    with open(os.path.splitext(path)[0] + ".md", "w",
              encoding="utf-8") as file:
        file.write(table)
    print(table + f"\nwritten to {path} and beside it as Markdown")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
