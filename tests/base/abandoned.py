#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Two of three ranks fail while the other waits for them: abandoned.py COMMAND...

The command must end with exit code 3 and say why in one line of one of them."""

import subprocess
import sys

EXIT_CODE = 3
LINES = ["error: rank 0 waits for rank 1", "error: rank 0 waits for rank 2"]

run = subprocess.run(sys.argv[1:], stdin=subprocess.DEVNULL,
                     capture_output=True, text=True)
print(run.stdout + run.stderr)
said = [line for line in (run.stdout + run.stderr).splitlines()
        if line.startswith("error: ")]
if run.returncode != EXIT_CODE or len(said) != 1 or said[0] not in LINES:
    print(f"exit code {run.returncode}, said {said}")
    sys.exit(1)
