# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Makes the report of a scene: plot.py report SCENE_FOLDER

Writes SCENE_FOLDER/report.html, one page that needs nothing besides itself:
what the blast does to the person, with pictures, histories, the injury table,
audits, accuracy, cost and how to reproduce it. Beside it stand report.json, the
same for programs (schema in applications/schemas), and headline.txt, the verdict
in a few lines, which are printed as well. Each table has a link to a CSV
file, which is in the page as well, with units and all digits. What a stage did
not leave is said in one line where it would stand. Exit code 0, or 1 with one
line for a folder or file that is not what it should be.
"""

import os

from plot.readers.files import BrokenInput
from plot.readers.scene import Scene
from plot.report import page, scene_report, summary


def main(scene_folder):
    if not os.path.isdir(scene_folder):
        raise BrokenInput(f"{scene_folder}: is not a folder")
    text, content = scene_report.build(Scene(scene_folder))
    summary.write(scene_folder, content)
    page.write_page(scene_folder, text)
