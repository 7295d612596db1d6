# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws a run of head_impact: plot.py head OUTPUT_FOLDER

Writes of a layered head, or of a file with a brain or cerebrospinal fluid,
OUTPUT_FOLDER/report.html, one page that needs nothing besides itself, and its
pictures as PNG files into OUTPUT_FOLDER/pictures; of other runs the pictures of
plot.py run. Prints the answer of the report, indented by two spaces, and the
paths. Exit code 0, or 1 with one line for a folder or file that is not what it
should be.
"""

from plot.readers.head_run import HeadRun
from plot.figures import style
from plot.report import head_report, page
from plot.commands import run


def main(output_folder):
    head = HeadRun(output_folder)
    if not head.is_head():
        run.main(output_folder)
        return
    text = head_report.build(head, style.pictures_folder(output_folder))
    page.print_answer(text)
    page.write_page(output_folder, text)
