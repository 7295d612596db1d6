#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Lists bounds of tests of whole runs that are far from what the run had:

    tests/bound_margins.py [build/Testing/Temporary/LastTest.log] [FACTOR]

Each row has the bound over the number (of "> ..." the number over the bound),
the test and what it printed, those above FACTOR (default 1.1) alone, the
tightest first. Round-off, also of single precision, needs more room than a
tenth, for it differs from one processor to another.
"""

import re
import sys

LOG = "build/Testing/Temporary/LastTest.log"


def margin(number, relation, limit):
    """How many times the number, or its absolute value, may grow or shrink."""
    if relation == "<":
        return limit / abs(number) if number else float("inf")
    return number / limit if limit else float("inf")


def bounds(lines):
    """Margin, test and text of every bound in a log of ctest."""
    test = "?"
    for line in lines:
        begin = re.match(r"\d+/\d+ Testing: (\S+)", line)
        test = begin[1] if begin else test
        found = re.match(r"(\S.*) = (\S+), required ([<>]) (\S+)\s*$", line)
        if found:
            yield margin(float(found[2]), found[3], float(found[4])), test, \
                line.strip()


def main(arguments):
    path = arguments[0] if arguments else LOG
    factor = float(arguments[1]) if len(arguments) > 1 else 1.1
    with open(path, encoding="utf-8", errors="replace") as file:
        rows = sorted(row for row in bounds(file) if row[0] > factor)
    for ratio, test, text in rows:
        print(f"{ratio:<8.4g} {test}: {text}")
    print(f"{len(rows)} bounds have more room than {factor:g}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
