#!/usr/bin/env python3
"""Shows that each check of check_tree.py accepts a good tree and finds what
is wrong in a bad one."""

import os
import shutil
import subprocess
import tempfile
import unittest
import unittest.mock

import check_tree

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
TOP = "\n".join(check_tree.LICENCE) + "\n\n"

GOOD_HEADER = TOP + """#pragma once

namespace contrecoup
{
  /// Two.
  double
  two();
} // namespace contrecoup
"""

GOOD_SOURCE = TOP + """#include <contrecoup/base/lanes/lanes.h>
#include <contrecoup/materials/two.h>

namespace contrecoup
{
  double two()
  {
    return 2.;
  }
} // namespace contrecoup
"""


def function_of(lines):
    """A function whose body has @p lines lines with its braces."""
    return ("namespace contrecoup\n{\n  void count(int &i)\n  {\n"
            + "    ++i;\n" * (lines - 2) + "  }\n} // namespace contrecoup\n")


class TreeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        with open(os.path.join(REPOSITORY, ".clang-format")) as style:
            self.write(".clang-format", style.read())
        self.write("include/contrecoup/base/lanes/lanes.h", TOP + "#pragma once\n")
        self.write("include/contrecoup/materials/two.h", GOOD_HEADER)
        self.write("source/materials/two.cc", GOOD_SOURCE)
        self.write("applications/blast/main.cc", TOP + "int main()\n{}\n")
        self.write("CMakeLists.txt", "project(contrecoup VERSION 1.2.3)\n")
        self.write("CITATION.cff", "cff-version: 1.2.0\nversion: 1.2.3\n")
        self.write("CHANGELOG.md", "# Changelog\n\n## 1.2.3\n\n## 1.2.2\n")

    def write(self, path, text):
        path = os.path.join(self.root, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)

    def expect(self, check, *words):
        """@p check finds exactly one problem, which has these words."""
        problems = check_tree.CHECKS[check](self.root)
        self.assertEqual(len(problems), 1, problems)
        for word in words:
            self.assertIn(word, problems[0])

    def test_good_tree(self):
        for name in ("layers", "modules", "plot_modules", "lengths", "functions",
                     "mirror", "overloads", "licence", "parameters",
                     "guide", "links", "citation"):
            self.assertEqual(check_tree.CHECKS[name](self.root), [], name)

    def test_upward_include(self):
        self.write("source/materials/two.cc",
                   GOOD_SOURCE + "#  include <contrecoup/gas/state.h>\n")
        self.expect("layers", "two.cc:", "'gas'")

    def test_sideways_include(self):
        self.write("include/contrecoup/gas/state.h",
                   TOP + '#include "contrecoup/solid/state.h"\n')
        self.expect("layers", "state.h:4", "'solid'")

    def test_upward_include_in_a_test(self):
        self.write("tests/base/lanes.cc",
                   TOP + "#include <contrecoup/io/output/summary.h>\n")
        self.expect("layers", "tests/base/lanes.cc:4")

    def test_upward_include_of_a_module(self):
        self.write("include/contrecoup/gas/octree/mesh.h",
                   TOP + "#pragma once\n"
                   "#include <contrecoup/gas/octree/leaf.h>\n")
        self.assertEqual(check_tree.modules(self.root), [])
        self.write("source/gas/octree/mesh.cc",
                   TOP + "#include <contrecoup/gas/octree/mesh.h>\n"
                   "#include <contrecoup/gas/stage/stage.h>\n")
        self.expect("modules", "mesh.cc:5", "'octree'", "'stage'")

    def test_unknown_module(self):
        self.write("source/gas/attic/mesh.cc", GOOD_SOURCE)
        self.expect("modules", "'attic' is not a module of 'gas'")

    def test_file_outside_modules(self):
        self.write("source/gas/mesh.cc", GOOD_SOURCE)
        self.expect("modules", "'None' is not a module of 'gas'")

    def test_upward_import_in_python(self):
        self.write("applications/plot/figures/style.py",
                   "import os\nfrom plot.readers import files\n")
        self.assertEqual(check_tree.plot_modules(self.root), [])
        for line in ("from plot.report import page", "import plot.report.page",
                     "from plot import command_line"):
            self.write("applications/plot/figures/style.py",
                       "import os\n" + line + "\n")
            self.expect("plot_modules", "style.py:2", "'figures'", "import '")

    def test_unknown_module_in_python(self):
        self.write("applications/plot/attic/style.py", "import os\n")
        self.expect("plot_modules", "plot/attic: not a module")

    def test_unknown_layer(self):
        self.write("source/extra/two.cc", GOOD_SOURCE)
        self.expect("layers", "'extra' is not a layer")

    def test_long_header(self):
        self.write("include/contrecoup/base/long.h", "\n" * 251)
        self.expect("lengths", "251 lines, at most 250")

    def test_long_source(self):
        self.write("source/base/long.cc", "\n" * 501)
        self.expect("lengths", "501 lines, at most 500")

    def test_long_main(self):
        self.write("applications/blast/main.cc", "\n" * 41)
        self.expect("lengths", "41 lines, at most 40")

    def test_long_readme(self):
        self.write("README.md", "\n" * 200)
        self.write("tests/README.md", "\n" * 201)
        self.assertEqual(check_tree.lengths(self.root), [])
        self.write("README.md", "\n" * 201)
        self.expect("lengths", "README.md: 201 lines, at most 200")

    def test_large_tree(self):
        with unittest.mock.patch.dict(check_tree.MOST_LINES,
                                      {("include", "source"): 20}):
            self.expect("sizes", "include and source: 2", "at most 20")
        for name in "abcdef":
            self.write(f"source/base/{name}.cc", "\n" * 101)
        self.expect("sizes", "half of the files have more than 100 lines")

    def test_long_function(self):
        self.write("source/base/lanes.cc", function_of(60))
        self.assertEqual(check_tree.functions(self.root), [])
        self.write("source/base/lanes.cc", function_of(61))
        self.expect("functions", "lanes.cc:4", "61 lines")

    def test_source_without_header(self):
        self.write("source/materials/two_and_a_half.cc", GOOD_SOURCE)
        self.assertEqual(check_tree.mirror(self.root), [])
        self.write("source/materials/three.cc", GOOD_SOURCE)
        self.expect("mirror", "include/contrecoup/materials/three.h")

    def test_overloads_of_sources_read_as_one(self):
        hidden = TOP + ("namespace\n{\n  double number(const char *name)\n"
                        "  {\n    return *name;\n  }\n} // namespace\n")
        self.write("source/io/file/one.cc", hidden)
        self.write("source/io/file/two.cc", hidden.replace("char", "double"))
        self.write("source/io/CMakeLists.txt",
                   "contrecoup_add_layer(io\n  MODULES file\n  ALONE file/two.cc)\n")
        self.assertEqual(check_tree.overloads(self.root), [])
        self.write("source/io/CMakeLists.txt",
                   "contrecoup_add_layer(io\n  MODULES file)\n")
        self.expect("overloads", "two.cc: 'number'", "one.cc")

    def test_missing_licence(self):
        self.write("source/materials/two.cc", "int two();\n")
        self.expect("licence", "two.cc:1")

    def test_missing_pragma(self):
        self.write("include/contrecoup/materials/two.h", TOP)
        self.expect("licence", "#pragma once")

    def test_add_parameter(self):
        self.write("source/materials/two.cc",
                   GOOD_SOURCE + 'prm.add_parameter("Two", two);\n')
        self.expect("parameters", "two.cc:14")

    def test_guide(self):
        modules = "".join(
            f"| module of `{layer}` | holds |\n|---|---|\n"
            + "".join(f"| `{module}` | it |\n" for module in known) + "\n"
            for layer, known in {**check_tree.MODULES,
                                 "plot": check_tree.PLOT_MODULES}.items())
        good = modules + "`materials/two.cc`\n"
        self.write("CONTRIBUTING.md", "`materials/two.cc`\n")
        self.write("source/README.md", good)
        self.assertEqual(check_tree.guide(self.root), [])
        self.write("CONTRIBUTING.md", "\n`materials/three.h`\n")
        self.expect("guide", "CONTRIBUTING.md:2:", "no materials/three.h")
        self.write("CONTRIBUTING.md", "")
        self.write("source/README.md", good.replace("| `octree` | it |\n", ""))
        self.expect("guide", "'gas'", "octree")

    def test_links(self):
        """Links of texts in any folder, to files and headings, over line ends;
        not of code, other sites, builds and runs."""
        here = "# Two\n\n## What `two()` is, at 1.5\n\n## Two\n"
        self.write("source/README.md", here)
        good = ("[two](source/materials/two.cc), [a\nmodule](source/README.md"
                "#what-two-is-at-15), [again](source/README.md#two-1)\n"
                "[deal.II](https://www.dealii.org), [here](#links)\n"
                "`[a](b)`\n```\n# No\n[c](d)\n```\n# Links\n")
        self.write("README.md", good)
        for folder in ("build/three", "output/three", ".git"):
            self.write(folder + "/README.md", "[three](three.h)\n")
        self.assertEqual(check_tree.links(self.root), [])
        number = good.count("\n") + 1
        for link, word in (("two.png", "no two.png"),
                           ("source/three.md#two", "no source/three.md"),
                           ("source/README.md#three", "no heading #three"),
                           ("#no", "no heading #no")):
            self.write("README.md", good + f"![two]({link})\n")
            self.expect("links", f"README.md:{number}:", word)
        self.write("README.md", good)
        self.write("source/materials/README.md", "[up](README.md#two)\n")
        self.expect("links", "source/materials/README.md:1", "no heading")

    def test_citation_of_another_version(self):
        for text in ("version: 1.2.4\n", "cff-version: 1.2.3\n"):
            self.write("CITATION.cff", text)
            self.expect("citation", "CITATION.cff")
        self.write("CITATION.cff", "version: 1.2.3\n")
        for text in ("## 1.2.4\n\n## 1.2.3\n", "## Unreleased\n"):
            self.write("CHANGELOG.md", text)
            self.expect("citation", "CHANGELOG.md")

    def test_misspelled(self):
        if not shutil.which("codespell") and not os.environ.get("CI"):
            self.skipTest("no codespell")
        self.assertEqual(check_tree.spelling(self.root), [])
        self.write("README.md", "One\n\nThe resluts.\n")
        self.expect("spelling", "README.md:3", "resluts ==> results")

    def test_badly_formatted(self):
        try:
            name = check_tree.clang_tool("clang-format")
        except check_tree.Skip as reason:
            if reason.fails():
                raise
            self.skipTest(str(reason))
        for path in check_tree.cpp_files(self.root):
            subprocess.run([name, "-i", os.path.join(self.root, path)],
                           check=True)
        self.assertEqual(check_tree.formatting(self.root), [])
        self.write("include/contrecoup/materials/two.h",
                   TOP + "#pragma once\n\nint   two();\n")
        self.expect("formatting", "two.h:6")

    def test_findings_of_clang_tidy(self):
        """In a cheap source, and in a header of a low layer; not in a source
        that includes a large library."""
        try:
            check_tree.clang_tool("clang-tidy")
        except check_tree.Skip as reason:
            if reason.fails():
                raise
            self.skipTest(str(reason))
        with open(os.path.join(REPOSITORY, ".clang-tidy")) as settings:
            self.write(".clang-tidy", settings.read())
        self.assertEqual(check_tree.tidy(self.root), [])
        unused = "inline int one(int argument)\n{\n  return 1;\n}\n"
        self.write("source/materials/one.cc", TOP + "#include <vector>\n"
                   "#include <deal.II/base/point.h>\n" + unused)
        self.assertEqual(check_tree.tidy(self.root), [])
        self.write("source/materials/one.cc", TOP + "#include <vector>\n" + unused)
        self.expect("tidy", "source/materials/one.cc:5", "'argument' is unused")
        os.remove(os.path.join(self.root, "source/materials/one.cc"))
        self.write("include/contrecoup/base/lanes/lanes.h",
                   TOP + "#pragma once\n" + unused)
        self.expect("tidy", "include/contrecoup/base/lanes/lanes.h:5")


if __name__ == "__main__":
    unittest.main()
