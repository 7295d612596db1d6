#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Writes tests/times.csv from what ctest --output-junit FILE found:

    tests/run --output-junit times.xml && tests/record_times.py build/times.xml

The table has the seconds of tests of half a second and more. From it ctest
takes which tests to start first, and the limits of time; no test passes or
fails by it. Tests that are not in the file keep the seconds that they had.
"""

import csv
import os
import re
import sys
import xml.etree.ElementTree

TABLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "times.csv")
SHORTEST = 0.5


def read_table():
    if not os.path.exists(TABLE):
        return {}
    with open(TABLE, newline="", encoding="utf-8") as file:
        return {row["test"]: float(row["seconds"])
                for row in csv.DictReader(file)}


def seconds_of(case):
    """Of processor time where the test says it, which does not depend on what
    else the machine does, else of the clock."""
    said = re.findall(r"^core seconds: ([0-9]+\.[0-9]+)$",
                      case.findtext("system-out") or "", re.MULTILINE)
    return float(said[-1]) if said else float(case.get("time"))


def main(arguments):
    if not arguments:
        print("usage: record_times.py JUNIT.xml...", file=sys.stderr)
        return 1
    times = read_table()
    for path in arguments:
        for case in xml.etree.ElementTree.parse(path).iter("testcase"):
            if case.get("status") == "run":
                times[case.get("name")] = seconds_of(case)
    rows = sorted((name, f"{seconds:.1f}") for name, seconds in times.items()
                  if seconds >= SHORTEST)
    with open(TABLE, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(("test", "seconds"))
        table.writerows(rows)
    total = sum(float(seconds) for _, seconds in rows)
    print(f"{len(rows)} tests, {total / 60.:.1f} minutes one after the other")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
