# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""What all scripts in this folder do with their command line."""

import sys


def run(main, documentation):
    """The exit code of main(arguments), or with --help that of printing the
    script's @p documentation."""
    arguments = sys.argv[1:]
    if "--help" in arguments or "-h" in arguments:
        print(documentation.strip())
        return 0
    return main(arguments)
