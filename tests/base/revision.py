#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A build says which revision it is of where git is not installed, too:
revision.py CMAKE SCRIPT"""

import os
import re
import subprocess
import sys
import tempfile

HASH = "0123456789abcdef0123456789abcdef01234567"
OTHER = "f" * 40
PACKED = (f"# pack-refs with: peeled fully-peeled sorted\n{OTHER} "
          f"refs/heads/main-2\n{HASH} refs/heads/main\n^{OTHER}\n"
          f"{OTHER} refs/remotes/origin/main\n")
# Files in .git, and the revision they mean.
CASES = (({}, "unknown"),
         ({"HEAD": "ref: refs/heads/main\n"}, "unknown"),
         ({"HEAD": "broken\n"}, "unknown"),
         ({"HEAD": HASH + "\n"}, "0123456789ab?"),
         ({"HEAD": "ref: refs/heads/a/b\n", "refs/heads/a/b": HASH + "\n",
           "packed-refs": PACKED}, "0123456789ab?"),
         ({"HEAD": "ref: refs/heads/main\n", "packed-refs": PACKED},
          "0123456789ab?"))


def revision(cmake, script, source, *more):
    output = os.path.join(source, "revision.h")
    subprocess.run([cmake, "-D", "SOURCE=" + source, "-D", "VERSION=1.2.3",
                    "-D", "OUTPUT=" + output, *more, "-P", script], check=True)
    with open(output, encoding="utf-8") as file:
        text = file.read()
    assert '#define CONTRECOUP_VERSION "1.2.3"\n' in text, text
    return re.search('#define CONTRECOUP_REVISION "(.*)"\n', text).group(1)


def main(cmake, script):
    for files, expected in CASES:
        with tempfile.TemporaryDirectory() as source:
            for name, text in files.items():
                path = os.path.join(source, ".git", name)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            # A git that is not there and one that refuses are the same.
            found = revision(cmake, script, source, "-D", "GIT=false")
            assert found == expected, f"{files}: {found}, not {expected}"


if __name__ == "__main__":
    main(*sys.argv[1:])
