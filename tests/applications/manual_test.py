# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Checks the output of the programs about themselves, and what is made of it.

Usage: manual_test.py FOLDER_OF_PROGRAMS FOLDER_OF_MANUAL REPOSITORY

--print-parameters=json says of each entry what the text says; the pages for man
are clean and name all options and entries; bash completes what it should.
"""

import json
import os
import re
import subprocess
import sys
import unittest

PROGRAMS = ("scene", "blast", "anatomy", "biomechanics", "head_impact", "study")
BINARIES, MANUAL, REPOSITORY = map(os.path.abspath, sys.argv[1:4])


def printed(program, *words):
    return subprocess.run([os.path.join(BINARIES, program), *words], check=True,
                          capture_output=True, text=True, timeout=120).stdout


def entries_of_text(text):
    """[(path, value, comment)] of an annotated parameter file. In scenes the
    entries of stages are comments."""
    entries, sections, comment = [], [], []
    for line in map(str.strip, text.splitlines()):
        if match := re.match(r"(?:# )?set (.*?) =(.*)", line):
            entries.append(("/".join(sections + [match[1]]), match[2].strip(),
                            " ".join(comment)))
        elif line.startswith("subsection "):
            sections.append(line[len("subsection "):])
        elif line == "end":
            sections.pop()
        elif line == "# The scene chooses what is not written here.":
            continue
        elif line.startswith("# "):
            comment.append(line[2:])
            continue
        comment = []
    return entries


def entries_of_json(tree, path=()):
    """The same of the tree in JSON: entries before sections."""
    found = []
    for name, node in tree.items():
        if "pattern_description" in node:
            allowed = node["allowed"]
            comment = node["documentation"] + (
                f" Allowed: {allowed}." if allowed else "") + (
                    f" Default: {node['default_value']}"
                    if node["value"] != node["default_value"] else "")
            found.append(("/".join(path + (name,)), node["value"],
                          " ".join(comment.split())))
    for name, node in tree.items():
        if "pattern_description" not in node:
            found += entries_of_json(node, path + (name,))
    return found


def nodes(tree):
    for node in tree.values():
        if "pattern_description" in node:
            yield node
        else:
            yield from nodes(node)


class Version(unittest.TestCase):
    def test_is_that_of_the_citation(self):
        with open(os.path.join(REPOSITORY, "CITATION.cff"),
                  encoding="utf-8") as file:
            version = re.search("^version: (.+)$", file.read(), re.M)[1]
        for program in PROGRAMS:
            self.assertRegex(printed(program, "--version"),
                             rf"^{program} {re.escape(version)} \(")


class Json(unittest.TestCase):
    def test_says_what_the_text_says(self):
        for program in PROGRAMS:
            words = ("--set", "Time/End time=0.25") \
                if program in ("blast", "head_impact") else ()
            with self.subTest(program):
                text = entries_of_text(
                    printed(program, "--print-parameters", *words))
                tree = json.loads(
                    printed(program, "--print-parameters=json", *words))
                self.assertGreater(len(text), 20)
                self.assertEqual(entries_of_json(tree), text)

    def test_has_units_ranges_and_choices_as_the_text_names_them(self):
        for program in PROGRAMS:
            tree = json.loads(printed(program, "--print-parameters=json"))
            for node in nodes(tree):
                if "unit" in node:
                    self.assertRegex(node["documentation"],
                                     r"\[" + re.escape(node["unit"]) + r"[],]")
                said = [float(number) for number in re.findall(
                    r"-?\d[\d.]*(?:e[+-]?\d+)?", node["allowed"])]
                for bound in node.get("range", []):
                    self.assertIn(bound, said + [None])
                for choice in node.get("choices", []):
                    self.assertIn(choice, node["allowed"])

    def test_of_a_section_is_part_of_the_whole(self):
        whole = json.loads(printed("blast", "--print-parameters=json"))
        part = json.loads(
            printed("blast", "--print-parameters=json", "Charges"))
        self.assertEqual(part["Charges"], whole["Charges"])
        self.assertNotIn("Output", part)

    def test_refuses_other_forms(self):
        end = subprocess.run(
            [os.path.join(BINARIES, "study"), "--print-parameters=xml"],
            capture_output=True, text=True, timeout=120)
        self.assertEqual((end.returncode, end.stdout), (1, ""))
        self.assertEqual(len(end.stderr.splitlines()), 1)
        self.assertIn("json", end.stderr)


class Pages(unittest.TestCase):
    def test_are_clean(self):
        for program in PROGRAMS:
            for page in (f"man1/{program}.1", f"man5/contrecoup-{program}.5"):
                end = subprocess.run(
                    ["mandoc", "-T", "lint", "-W", "warning", page],
                    cwd=MANUAL, capture_output=True, text=True, timeout=120)
                self.assertEqual(end.stdout + end.stderr, "")

    def text_of(self, page):
        text = subprocess.run(
            ["mandoc", "-T", "utf8", "-O", "width=1000", page], check=True,
            cwd=MANUAL, capture_output=True, text=True, timeout=120).stdout
        # Bold and italic letters are struck twice.
        return re.sub(".\b", "", text)

    def test_name_all_options_and_exit_codes(self):
        for program in PROGRAMS:
            text = self.text_of(f"man1/{program}.1")
            usage = printed(program, "--help")
            options = re.findall(r"^  (--[a-z-]+)", usage, re.M)
            self.assertGreater(len(options), 8)
            for option in options:
                self.assertRegex(text, rf"(?m)^ +{option}\b")
            codes = re.findall(r"\d+",
                               usage[usage.index("Exit codes"):].split("Runs")[0])
            status = text[text.index("EXIT STATUS"):]
            for code in codes:
                self.assertRegex(status, rf"\b{code}\b")

    def test_have_all_entries(self):
        for program in PROGRAMS:
            text = self.text_of(f"man5/contrecoup-{program}.5")
            said = " ".join(text.split())
            for path, _, comment in entries_of_json(
                    json.loads(printed(program, "--print-parameters=json"))):
                self.assertIn(" ".join(comment.split(" Allowed: ")[0].split()),
                              said, path)
                self.assertRegex(
                    text, rf"(?m)^ +{re.escape(path.split('/')[-1])}\b")


def complete(program, *words):
    """Completions by bash for the last of these words."""
    script = """source "$1"; shift
compopt() { :; }
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
_contrecoup_$1
((${#COMPREPLY[@]})) && printf '%s\\n' "${COMPREPLY[@]}"
exit 0"""
    end = subprocess.run(
        ["bash", "-c", script, "bash",
         os.path.join(MANUAL, "completions", program), program, *words],
        cwd=os.path.join(REPOSITORY, "parameter_files", "blast"),
        capture_output=True, text=True, timeout=120)
    if end.returncode or end.stderr:
        raise AssertionError(end.stderr)
    return end.stdout.splitlines()


class Completion(unittest.TestCase):
    def test_options(self):
        for program in PROGRAMS:
            offered = complete(program, "--")
            self.assertEqual(
                set(re.findall(r"^  (--[a-z-]+)", printed(program, "--help"),
                               re.M)) | {"--print-parameters=json"},
                set(offered))
        self.assertEqual(complete("blast", "--ov"), ["--overwrite"])

    def test_parameter_files_and_folders(self):
        offered = complete("blast", "")
        self.assertIn("quickstart.prm", offered)
        self.assertIn("showcase", offered)
        self.assertNotIn("README.md", offered)
        self.assertEqual(complete("blast", "quickstart_"),
                         ["quickstart_human.prm"])

    def test_folders_behind_output(self):
        self.assertEqual(complete("blast", "--output", "show"), ["showcase"])
        self.assertEqual(complete("blast", "--output", "=", "show"),
                         ["showcase"])

    def test_entries(self):
        for quote in ('"', "'"):
            self.assertEqual(complete("blast", "--set", quote + "Time/End"),
                             ["Time/End time=", "Time/End time=1"])
        for typed in ("Time/End", "Time/End\\ t"):
            self.assertEqual(complete("blast", "--set", typed),
                             [r"Time/End\ time=", r"Time/End\ time=1"])
        whole = complete("scene", "--set", '"Charge/')
        self.assertIn("Charge/Mass=", whole)
        self.assertTrue(all(word.startswith("Charge/") for word in whole))

    def test_values(self):
        self.assertEqual(sorted(complete("blast", "--set", '"Domain/Mesh=')),
                         ["Domain/Mesh=" + kind
                          for kind in ("box", "cone", "file", "generator")])
        # As bash splits words: at each =.
        self.assertEqual(complete("blast", "--set", "Domain/Mesh", "=", "co"),
                         ["cone"])
        self.assertEqual(
            complete("blast", "--set", "=", "Domain/Mesh", "=", "co"), ["cone"])
        self.assertEqual(complete("blast", "--set", '"Time/End time='),
                         ["Time/End time=1"])

    def test_names_of_ones_own(self):
        self.assertEqual(
            complete("scene", "--set", '"Tissues/Tissue gel/Dens'),
            ["Tissues/Tissue gel/Density=",
             "Tissues/Tissue gel/Density=library"])

    def test_sections(self):
        self.assertIn("Charges", complete("blast", "--print-parameters", "Ch"))
        self.assertIn(
            "Charges",
            complete("blast", "--print-parameters", "=", "json", "Ch"))

    def test_is_for_the_program(self):
        for program in PROGRAMS:
            with open(os.path.join(MANUAL, "completions", program),
                      encoding="utf-8") as file:
                self.assertIn(f"complete -F _contrecoup_{program} {program}\n",
                              file.read())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
