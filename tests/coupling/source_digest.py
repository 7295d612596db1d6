#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Changes of sources change the digests of the applications that are made from
them, and of no others: source_digest.py CMAKE SOURCE_FOLDER"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

ALL = {"anatomy", "blast", "biomechanics"}
# A file that is changed, and the applications that are made from it.
CHANGES = (("source/gas/finite_volume/leaf_kernel.cc", {"blast"}),
           ("source/solid/motion/solid_operator.cc", {"biomechanics"}),
           ("include/contrecoup/numerics/scheme/riemann_flux.h",
            {"blast", "biomechanics"}),
           ("source/geometry/body/phantom_flesh.cc", ALL),
           ("include/contrecoup/base/lanes/lanes.h", ALL),
           ("source/coupling/application/domain_size.cc", {"blast"}),
           ("source/coupling/application/body_report.cc", {"anatomy"}),
           ("source/coupling/scene/scene_plan.cc", set()),
           ("source/study/study.cc", set()))


class Tree:
    """A copy of the sources, and the digests of its applications."""

    def __init__(self, cmake, source, folder):
        self.cmake, self.folder = cmake, folder
        self.output = os.path.join(folder, "digests.inc")
        for name in ("include", "source"):
            shutil.copytree(os.path.join(source, name),
                            os.path.join(folder, name))

    def digests(self):
        subprocess.run(
            [self.cmake, "-D", "SOURCE=" + self.folder, "-D",
             "OUTPUT=" + self.output, "-P", os.path.join(
                 self.folder, "source/coupling/task/source_digest.cmake")],
            check=True)
        with open(self.output, encoding="utf-8") as file:
            return dict(re.findall(r'{"(\w+)", "([0-9a-f]{40})"},', file.read()))


def main(cmake, source):
    with tempfile.TemporaryDirectory() as folder:
        tree = Tree(cmake, source, folder)
        before = tree.digests()
        assert before.keys() == ALL, before
        assert len(set(before.values())) == len(ALL), before
        written = os.stat(tree.output).st_mtime_ns
        assert tree.digests() == before, "digests of the same sources differ"
        assert os.stat(tree.output).st_mtime_ns == written, \
            "the same digests were written again"
        for name, expected in CHANGES:
            with open(os.path.join(folder, name), "a",
                      encoding="utf-8") as file:
                file.write("// Another line.\n")
            after = tree.digests()
            changed = {key for key in ALL if before[key] != after[key]}
            assert changed == expected, f"{name} changes {changed}"
            before = after


if __name__ == "__main__":
    main(*sys.argv[1:])
