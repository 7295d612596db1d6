#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Compares two runs of one head: plot_methods.py FIRST SECOND [OUTPUT_FOLDER]

FIRST and SECOND are output folders of head_impact with layered heads, such as
one by Method = ale and one by Method = mpm. Writes OUTPUT_FOLDER/report.html,
one page that needs nothing besides itself, and its pictures as PNG files into
OUTPUT_FOLDER/pictures; without it into a folder beside SECOND, "SECOND_against_"
and the last name of FIRST. A folder that holds a run is not written into. Prints
their paths. Exit code 0, or 1 with one line for a folder or file that is
not what it should be.
"""

import os
import sys

import head_run
import look
import report_data
import report_methods
import usage


def main(arguments):
    if len(arguments) not in (2, 3):
        print("usage: plot_methods.py FIRST SECOND [OUTPUT_FOLDER]",
              file=sys.stderr)
        return 1
    folder = arguments[2] if len(arguments) == 3 \
        else "_against_".join([os.path.normpath(arguments[1]), os.path.basename(
            os.path.abspath(arguments[0]))])
    look.set_up()
    try:
        runs = [head_run.HeadRun(name) for name in arguments[:2]]
        for run, name in zip(runs, arguments):
            if not run.is_head():
                print(f"plot_methods.py: {name} holds no run of a layered head",
                      file=sys.stderr)
                return 1
        if os.path.exists(os.path.join(folder, "summary.json")):
            print(f"plot_methods.py: {folder} holds a run; name another folder",
                  file=sys.stderr)
            return 1
        pictures = os.path.join(folder, "pictures")
        os.makedirs(pictures, exist_ok=True)
        text = report_methods.build(report_methods.Pair(*runs), pictures)
    except report_data.BrokenInput as problem:
        print(f"plot_methods.py: {problem}", file=sys.stderr)
        return 1
    print(report_data.write_page(folder, text))
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
