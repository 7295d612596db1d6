#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Every script in applications/plot answers --help with what it is for."""

import ast
import os
import subprocess
import sys

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                      "..", "..", "applications", "plot")


def main():
    scripts = sorted(name for name in os.listdir(FOLDER)
                     if name.endswith(".py")
                     and os.access(os.path.join(FOLDER, name), os.X_OK))
    if len(scripts) < 9:
        sys.exit(f"only {len(scripts)} scripts in {FOLDER}")
    problems = []
    for name in scripts:
        path = os.path.join(FOLDER, name)
        with open(path, encoding="utf-8") as file:
            expected = ast.get_docstring(ast.parse(file.read()), clean=False)
        for word in ("--help", "-h"):
            run = subprocess.run([path, word], capture_output=True, text=True)
            if (run.returncode != 0 or run.stderr
                    or run.stdout.strip() != expected.strip()
                    or name not in run.stdout):
                problems.append(f"{name} {word}: exit code {run.returncode}, "
                                f"{run.stderr or run.stdout}")
    print("\n".join(problems) or f"{len(scripts)} scripts answer")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
