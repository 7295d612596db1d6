# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures and reports of what runs left in their output folders. A module
imports only itself and the modules above it in this list:

    readers     files of runs as objects; no pictures
    analysis    what histories and fields say: arrivals, peaks, paths
    figures     one module for each kind of picture
    report      sections and pages in HTML
    commands    one module for each command of plot.py
"""
