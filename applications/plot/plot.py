#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws what runs left in their output folders, and writes reports:

    plot.py COMMAND ARGUMENTS...
    plot.py COMMAND --help

Exit code 0, or 1 with one line on stderr that says what is wrong.
"""

import os
import sys

# The folder that the package is in takes the place of that of this script.
sys.path[0] = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))

from plot import command_line  # noqa: E402 (after the path of the package)

if __name__ == "__main__":
    sys.exit(command_line.run(sys.argv[1:], __doc__))
