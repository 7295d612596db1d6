#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws a run of head_impact: plot_head.py OUTPUT_FOLDER

Writes of a layered head, or of a file with a brain or cerebrospinal fluid,
OUTPUT_FOLDER/report.html, one page that needs nothing besides itself, and its
pictures as PNG files into OUTPUT_FOLDER/pictures; of other runs the pictures of
plot_run.py. Prints their paths. Exit code 0, or 1
with one line for a folder or file that is not what it should be.
"""

import os
import sys

import head_run
import look
import plot_run
import report_data
import report_head
import usage


def main(arguments):
    if len(arguments) != 1:
        print("usage: plot_head.py OUTPUT_FOLDER", file=sys.stderr)
        return 1
    folder = arguments[0]
    look.set_up()
    try:
        run = head_run.HeadRun(folder)
        if not run.is_head():
            return plot_run.main([folder])
        pictures = os.path.join(folder, "pictures")
        os.makedirs(pictures, exist_ok=True)
        text = report_head.build(run, pictures)
    except report_data.BrokenInput as problem:
        print(f"plot_head.py: {problem}", file=sys.stderr)
        return 1
    print(report_data.write_page(folder, text))
    return 0


if __name__ == "__main__":
    sys.exit(usage.run(main, __doc__))
