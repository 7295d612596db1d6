# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Compares two runs of one head: plot.py methods FIRST SECOND [OUTPUT_FOLDER]

FIRST and SECOND are output folders of head_impact with layered heads, such as
one by Method = ale and one by Method = mpm. Writes OUTPUT_FOLDER/report.html,
one page that needs nothing besides itself, and its pictures as PNG files into
OUTPUT_FOLDER/pictures; without it into a folder beside SECOND,
"SECOND_against_" and the last name of FIRST. A folder that holds a run is not
written into. Prints their paths. Exit code 0, or 1 with one line for a folder
or file that is not what it should be.
"""

import os

from plot.readers.files import BrokenInput
from plot.readers.head_run import HeadRun
from plot.figures import style
from plot.report import methods_report, page


def main(first, second, output_folder=None):
    folder = output_folder or "_against_".join([
        os.path.normpath(second), os.path.basename(os.path.abspath(first))])
    runs = [HeadRun(name) for name in (first, second)]
    for run in runs:
        if not run.is_head():
            raise BrokenInput(f"{run.folder} holds no run of a layered head")
    if os.path.exists(os.path.join(folder, "summary.json")):
        raise BrokenInput(f"{folder} holds a run; name another folder")
    page.write_page(folder, methods_report.build(
        methods_report.Pair(*runs), style.pictures_folder(folder)))
