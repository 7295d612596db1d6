#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Every choice with which an entry is used exists.

used_with.py FOLDER_OF_PROGRAMS

Reads the conditions "Used with PATH = VALUE." from the text of
--print-parameters of each program: a path that is no entry, or a value that
its entry does not allow, would never be warned of. Each program has
conditions.
"""

import os
import re
import subprocess
import sys

CONDITION = re.compile(r"Used with ([^.=]+?) (=|not) ([^.]+)\.")


def entries_of(text):
    """Path and help text of all entries."""
    sections, comment, entries = [], "", {}
    for line in text.splitlines():
        words = line.strip()
        if words.startswith("# set "):  # the scene chooses
            words = words[2:]
        if words.startswith("#"):
            comment += " " + words[1:].strip()
            continue
        if words.startswith("subsection "):
            sections.append(words[len("subsection "):])
        elif words == "end":
            sections.pop()
        elif words.startswith("set "):
            name = words[len("set "):].split(" =")[0]
            entries["/".join([*sections, name])] = comment.strip()
        comment = ""
    return entries


def resolved(entries, path, name):
    """The entry of this name nearest around the one at path; None: none."""
    sections = path.split("/")[:-1]
    while True:
        found = "/".join([*sections, name])
        if found in entries:
            return found
        if not sections:
            return None
        sections.pop()


def allowed(comment):
    """The words that a selection allows; None: it is no selection."""
    match = re.search(r"Allowed: ([a-z0-9 ,.-]+)\.( Default:.*)?$", comment, re.I)
    if match is None or re.search(r"number|values|points|file", match[1]):
        return None
    return [word.strip() for word in match[1].split(",")]


def problems_of(program, text):
    entries = entries_of(text)
    count = 0
    for path, comment in entries.items():
        if "Used with" in comment and not CONDITION.search(comment):
            yield f"{program}: {path}: no condition is read from: {comment}"
        for names, _, values in CONDITION.findall(comment):
            count += 1
            found = [resolved(entries, path, name)
                     for name in names.split(" or ")]
            if not all(found):
                yield f"{program}: {path}: no entry {names}"
                continue
            words = [allowed(entries[name]) for name in found]
            for value in values.split(", "):
                if all(known is not None and value not in known
                       for known in words):
                    yield f"{program}: {path}: {names} cannot be {value}"
    if count == 0:
        yield f"{program}: no entry has a condition"


def main(folder):
    problems = []
    for program in ("anatomy", "biomechanics", "blast", "head_impact", "scene",
                    "study"):
        end = subprocess.run([os.path.join(folder, program),
                              "--print-parameters"],
                             stdout=subprocess.PIPE, check=True, text=True)
        problems += problems_of(program, end.stdout)
    print("\n".join(problems) or "all conditions name entries and their values")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
