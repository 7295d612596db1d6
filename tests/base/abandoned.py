#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""One of two ranks fails while the other waits for it: abandoned.py COMMAND...

The command must end with exit code 3 and say why in one line."""

import subprocess
import sys

EXIT_CODE = 3
LINE = "error: the other waits for me"

run = subprocess.run(sys.argv[1:], stdin=subprocess.DEVNULL,
                     capture_output=True, text=True)
print(run.stdout + run.stderr)
said = (run.stdout + run.stderr).splitlines().count(LINE)
if run.returncode != EXIT_CODE or said != 1:
    print(f"exit code {run.returncode}, the line '{LINE}' {said} times")
    sys.exit(1)
