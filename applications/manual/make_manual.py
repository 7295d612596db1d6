#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Makes the manual of the programs from what they print themselves.

Usage: make_manual.py FOLDER_OF_PROGRAMS OUTPUT

Of each program in programs.json, --help and --print-parameters=json become
OUTPUT/man1/PROGRAM.1, OUTPUT/man5/contrecoup-PROGRAM.5 and the completion of
bash, OUTPUT/completions/PROGRAM.
"""

import datetime
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import textwrap

import jinja2

HERE = pathlib.Path(__file__).absolute().parent


def roff(text, width=78):
    """Lines of plain text for man: letters that it reads as commands are not."""
    text = text.replace("\\", "\\e")
    return "\n".join("\\&" + line if line[:1] in ".'" else line
                     for line in textwrap.wrap(text, width,
                                               break_on_hyphens=False))


def literal(text):
    """Text to be typed as it stands: its hyphens are minus signs."""
    return roff(text, 10000).replace("-", "\\-").replace('"', "\\(dq")


def printed(program, *words):
    return subprocess.run([program, *words], check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def date_of_changes():
    """Date of the newest section of the changelog, as YYYY-MM-DD."""
    changes = (HERE.parents[1] / "CHANGELOG.md").read_text(encoding="utf-8")
    words = re.search(r"^### .*\((.+)\)$", changes, re.M)[1]
    return datetime.datetime.strptime(words, "%B %d, %Y").date().isoformat()


def options_of(help_text):
    """Options and what --help says of each: [(name, argument, text)]."""
    options = []
    for line in help_text.splitlines():
        match = re.match(r"  (--\S+)(?: (\S+))?(?:  +(.*))?$", line)
        if match:
            options.append([match[1], match[2] or "", match[3] or ""])
        elif re.match(" {22}", line) and options:
            options[-1][2] = (options[-1][2] + " " + line.strip()).strip()
    return options


def sections_of(tree, path=()):
    """Sections with their entries, in order: [(path, [(name, entry)])]."""
    entries = [(name, item) for name, item in tree.items()
               if "pattern_description" in item]
    found = [("/".join(path), entries)] if entries else []
    for name, item in tree.items():
        if "pattern_description" not in item:
            found += sections_of(item, path + (name,))
    return found


def facts_of(program, folder, about):
    """Facts on a program for the templates."""
    path = os.path.join(folder, program)
    help_text = printed(path, "--help")
    sections = sections_of(json.loads(printed(path, "--print-parameters=json")))
    return {"program": program, "about": about,
            "purpose": help_text.splitlines()[0].split(": ", 1)[1],
            "version": printed(path, "--version").split()[1],
            "date": date_of_changes(), "options": options_of(help_text), "sections": sections}


def completed_entries(sections):
    """Path of each entry, and the values that may stand behind it."""
    return [(section + "/" + name if section else name,
             "|".join(entry.get("choices") or [entry["default_value"]]))
            for section, entries in sections for name, entry in entries]


def main(folder, output):
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), trim_blocks=True,
        lstrip_blocks=True, keep_trailing_newline=True,
        # Bash has ${#...}.
        comment_start_string="<#", comment_end_string="#>",
        undefined=jinja2.StrictUndefined)
    environment.filters.update(roff=roff, literal=literal, quoted=shlex.quote,
                               completed=completed_entries)
    programs = json.loads((HERE / "programs.json").read_text(encoding="utf-8"))
    for program, about in programs.items():
        facts = facts_of(program, folder, about)
        others = [name for name in programs if name != program]
        for template, target in [
                ("program.1", f"man1/{program}.1"),
                ("parameters.5", f"man5/contrecoup-{program}.5"),
                ("completion.bash", f"completions/{program}")]:
            path = pathlib.Path(output, target)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(environment.get_template(template + ".j2").render(
                facts, others=others), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
