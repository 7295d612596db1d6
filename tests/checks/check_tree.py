#!/usr/bin/env python3
"""Checks of the source tree: check_tree.py CHECK [ROOT [FOLDER...]].

CHECK is one of the functions listed in CHECKS below, or "quick" for all that take
no more than seconds. Each takes the root
folder of the repository, tidy also the folders that libraries have their
headers in, and returns a list of problems, one line each, that
start with file (and line). Exit code 0: none, 1: some, 77: skipped, which in CI
is 1.
"""

import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

# Layers that each layer may include besides itself. Applications and folders
# of tests that are not named after a layer may include everything.
BELOW = {"base": set()}
BELOW["materials"] = {"base"}
BELOW["geometry"] = {"base"}
BELOW["numerics"] = {"base", "materials"}
BELOW["io"] = {"base", "materials", "numerics", "geometry"}
for _solver in ("gas", "solid", "mpm"):
    BELOW[_solver] = BELOW["io"] | {"io"}
for _upper in ("ale", "coupling", "study"):
    BELOW[_upper] = BELOW["gas"] | {"gas", "solid", "mpm"}

def _modules():
    """The modules of each layer that has some, as CMake builds them, lowest
    first: each may include itself and those before. A module with a library of
    its own, which comes last there, is the lowest."""
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir,
                          os.pardir, "source")
    found = {}
    for layer in os.listdir(source):
        lists = os.path.join(source, layer, "CMakeLists.txt")
        if os.path.exists(lists):
            with open(lists, encoding="utf-8") as file:
                names = re.findall(r"MODULES\s([a-z_\s\"]*)", file.read())
            if names:
                found[layer] = " ".join(reversed(names)).replace("\"", "").split()
    return found


MODULES = _modules()

# Texts about the code; the first has the modules of its layers.
GUIDES = [os.path.join("source", "README.md"), "CONTRIBUTING.md"]

# Those of the Python package applications/plot.
PLOT_MODULES = ["readers", "analysis", "figures", "report", "commands"]

# Texts of the top level: five minutes each.
LONGEST_TEXTS = {"README.md": 200, "CONTRIBUTING.md": 150}
LARGEST_MEDIAN = 100  # of files of the library
# Lines that folders may have; a change that needs more says why.
MOST_LINES = {("include", "source"): 135_360, ("applications",): 13_240,
              ("tests",): 68_390}
LONGEST_HEADER = 250
LONGEST_SOURCE = 500
LONGEST_MAIN = 40
LONGEST_FUNCTION = 60

LICENCE = ["// SPDX-License-Identifier: LGPL-2.1-or-later",
           "// Copyright (C) 2026 by the Contrecoup authors"]

SKIPPED = 77


class Skip(Exception):
    """The check cannot be made on this machine; says why."""

    def fails(self):
        """Where a change is judged nothing may be left out unseen."""
        return bool(os.environ.get("CI"))


class OtherRelease(Skip):
    """The tool is there in another release, which lays out code otherwise;
    Debian 12 judges."""

    def fails(self):
        return False


def cpp_files(root, folders=("include", "source", "applications", "tests")):
    """Yields the paths below @p root of all .h and .cc files, sorted."""
    for folder in folders:
        for here, subfolders, names in os.walk(os.path.join(root, folder)):
            subfolders.sort()
            for name in sorted(names):
                if name.endswith((".h", ".cc")):
                    yield os.path.relpath(os.path.join(here, name), root)


def texts(root):
    """Yields the paths below @p root of all .md files, sorted; not those of
    builds and runs."""
    for here, folders, names in os.walk(root):
        folders[:] = sorted(
            name for name in folders if not name.startswith((".", "build"))
            and (name != "output" or here != root))
        for name in sorted(names):
            if name.endswith(".md"):
                yield os.path.relpath(os.path.join(here, name), root)


def lines_of(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read().splitlines()


def layer_of(path):
    """The layer that a file belongs to, or None above all layers."""
    parts = path.split(os.sep)
    if parts[0] == "include" and len(parts) > 3:
        return parts[2]
    if parts[0] == "source" and len(parts) > 2:
        return parts[1]
    if parts[0] == "tests" and len(parts) > 2 and parts[1] in BELOW:
        return parts[1]
    return None


def layers(root):
    """Layers include only downwards."""
    include = re.compile(r'\s*#\s*include\s*[<"]contrecoup/(\w+)/')
    problems = []
    for path in cpp_files(root):
        layer = layer_of(path)
        if layer is None:
            continue
        if layer not in BELOW:
            problems.append(f"{path}: '{layer}' is not a layer, known are: "
                            + ", ".join(BELOW))
            continue
        for number, line in enumerate(lines_of(root, path), 1):
            match = include.match(line)
            if match and match[1] not in BELOW[layer] | {layer}:
                problems.append(f"{path}:{number}: layer '{layer}' may not "
                                f"include layer '{match[1]}'")
    return problems


def module_of(path, layer):
    """The module of its layer that a file belongs to, or None."""
    folders = path.split(os.sep)[:-1]
    here = folders.index(layer) + 1
    return folders[here] if here < len(folders) else None


def modules(root):
    """Modules include only downwards."""
    include = re.compile(r"\s*#\s*include\s*<contrecoup/(\w+)/(\w+)/")
    problems = []
    for path in cpp_files(root, ("include", "source")):
        layer = layer_of(path)
        if layer not in MODULES:
            continue
        order = MODULES[layer]
        module = module_of(path, layer)
        if module not in order:
            problems.append(f"{path}: '{module}' is not a module of '{layer}', "
                            "known are: " + ", ".join(order))
            continue
        for number, line in enumerate(lines_of(root, path), 1):
            match = include.match(line)
            if match and match[1] == layer and (
                    match[2] not in order[:order.index(module) + 1]):
                problems.append(f"{path}:{number}: module '{module}' may not "
                                f"include module '{match[2]}'")
    return problems


def plot_modules(root):
    """Modules of the Python package import only downwards."""
    package = os.path.join("applications", "plot")
    problems = []
    for here, folders, names in os.walk(os.path.join(root, package)):
        folders[:] = sorted(set(folders) - {"__pycache__"})
        module = os.path.relpath(here, os.path.join(root, package))
        if module == "." or not any(name.endswith(".py") for name in names):
            continue
        if module not in PLOT_MODULES:
            problems.append(f"{package}/{module}: not a module, known are: "
                            + ", ".join(PLOT_MODULES))
            continue
        below = PLOT_MODULES[:PLOT_MODULES.index(module) + 1]
        for name in sorted(names):
            path = os.path.join(package, module, name)
            if not name.endswith(".py"):
                continue
            for number, line in enumerate(lines_of(root, path), 1):
                match = re.match(r"\s*(?:from|import) plot\b\.?(\w*)", line)
                if match and match[1] not in below:
                    problems.append(f"{path}:{number}: module '{module}' may not "
                                    f"import '{match[1] or 'plot'}'")
    return problems


def lengths(root):
    """No file is longer than one reader holds."""
    problems = []
    limited = [path for path in texts(root) if path in LONGEST_TEXTS]
    for path in [*cpp_files(root), *limited]:
        if path in LONGEST_TEXTS:
            limit = LONGEST_TEXTS[path]
        elif path.endswith(".h"):
            limit = LONGEST_HEADER
        elif os.path.basename(path) == "main.cc":
            limit = LONGEST_MAIN
        else:
            limit = LONGEST_SOURCE
        count = len(lines_of(root, path))
        if count > limit:
            problems.append(f"{path}: {count} lines, at most {limit}")
    return problems


def sizes(root):
    """The tree grows by decision alone."""
    problems = []
    for folders, most in MOST_LINES.items():
        counts = [len(lines_of(root, os.path.relpath(os.path.join(here, name),
                                                     root)))
                  for folder in folders
                  for here, _, names in os.walk(os.path.join(root, folder))
                  for name in names
                  if name.endswith((".h", ".cc", ".py", ".cmake"))]
        if sum(counts) > most:
            problems.append(f"{' and '.join(folders)}: {sum(counts)} lines, at "
                            f"most {most}")
        if "source" in folders and counts \
                and statistics.median(counts) > LARGEST_MEDIAN:
            problems.append("include and source: half of the files have more "
                            f"than {LARGEST_MEDIAN} lines")
    return problems


def functions(root):
    """No function is longer than one screen (clang-format's layout)."""
    opens_scope = re.compile(
        r"\s*(template|namespace|class|struct|union|enum|extern)\b")
    problems = []
    for path in cpp_files(root):
        lines = lines_of(root, path)
        number = 0
        while number < len(lines):
            brace = re.fullmatch(r"( *)\{", lines[number])
            if not brace:
                number += 1
                continue
            head = number - 1
            while head > 0 and lines[head - 1].strip() and not re.search(
                    r"[;{}:]\s*(//.*)?$", lines[head - 1]):
                head -= 1
            text = [line for line in lines[head:number]
                    if not line.lstrip().startswith(("//", "#", "*", "/*"))]
            is_scope = bool(text) and bool(opens_scope.match(text[-1]))
            if is_scope or not any("(" in line for line in text):
                number += 1
                continue
            last = number + 1
            while last < len(lines) and not lines[last].startswith(
                    brace[1] + "}"):
                last += 1
            length = last - number + 1
            if length > LONGEST_FUNCTION:
                problems.append(f"{path}:{number + 1}: function of {length} "
                                f"lines, at most {LONGEST_FUNCTION}")
            number = last + 1
    return problems


def mirror(root):
    """source/x/y.cc mirrors include/contrecoup/x/y.h. A long source may be
    split into y_<topic>.cc."""
    problems = []
    for path in cpp_files(root, ("source",)):
        layer = layer_of(path)
        if layer is None or not path.endswith(".cc"):
            continue
        folder = os.path.join(root, "include", "contrecoup", layer)
        inner = os.path.relpath(path, os.path.join("source", layer))
        words = inner[:-len(".cc")].split("_")
        names = ["_".join(words[:n]) for n in range(len(words), 0, -1)]
        if not any(os.path.exists(os.path.join(folder, name + ".h"))
                   for name in names):
            problems.append(f"{path}: no header include/contrecoup/{layer}/"
                            f"{names[0]}.h")
    return problems


def unnamed_functions(lines):
    """Names of the functions in a source's unnamed namespaces."""
    names, inside = set(), False
    for line in lines:
        if line == "namespace":
            inside = True
        elif line == "} // namespace":
            inside = False
        match = re.match(r"  (?:[\w:<>,*&]+ +)*[*&]*(\w+)\(", line)
        if inside and match and not line.endswith(";"):
            names.add(match[1])
    return names


def overloads(root):
    """Sources of a folder, which the compiler reads as one, hide no overloads from
    each other: the order of the sources would decide which one is called."""
    problems = []
    for layer in sorted(os.listdir(os.path.join(root, "source"))):
        lists = os.path.join("source", layer, "CMakeLists.txt")
        if not os.path.exists(os.path.join(root, lists)):
            continue
        call = re.search(r"ALONE\s([^)]*)\)", "\n".join(lines_of(root, lists)))
        alone = call[1].split() if call else []
        for folder, _, names in os.walk(os.path.join(root, "source", layer)):
            here = os.path.relpath(folder, root)
            module = os.path.relpath(here, os.path.join("source", layer))
            first = {}
            for name in sorted(names):
                path = os.path.normpath(os.path.join(module, name))
                if not name.endswith(".cc") or {module, path} & set(alone):
                    continue
                path = os.path.join(here, name)
                for function in sorted(unnamed_functions(lines_of(root, path))):
                    if function in first:
                        problems.append(
                            f"{path}: '{function}' is in the unnamed namespace "
                            f"of {first[function]}, too")
                    first.setdefault(function, path)
    return problems


def licence(root):
    """Each file names its licence; each header is included once."""
    problems = []
    for path in cpp_files(root):
        lines = lines_of(root, path)
        if lines[:2] != LICENCE:
            problems.append(f"{path}:1: must begin with the two lines "
                            + " / ".join(LICENCE))
        if path.endswith(".h") and "#pragma once" not in lines:
            problems.append(f"{path}: #pragma once is missing")
    return problems


def parameters(root):
    """ParameterHandler::add_parameter rounds defaults to six digits in
    deal.II 9.4, which ruins constants of equations of state."""
    return [f"{path}:{number}: use declare_entry instead of add_parameter"
            for path in cpp_files(root, ("include", "source", "applications"))
            for number, line in enumerate(lines_of(root, path), 1)
            if re.search(r"\badd_parameter\s*\(", line)]


def guide(root):
    """Guides name files that exist, source/README.md the modules in their order."""
    if not all(os.path.exists(os.path.join(root, path)) for path in GUIDES):
        return []
    problems = [problem for path in GUIDES
                for problem in missing_files(root, path)]
    tables, table = {}, None
    for line in lines_of(root, GUIDES[0]):
        if head := re.match(r"\| module of `(\w+)` \|", line):
            table = tables[head[1]] = []
        elif not line.startswith("|"):
            table = None
        elif table is not None:
            table += re.findall(r"`(\w+)`", line.split("|")[1])
    for layer, known in {**MODULES, "plot": PLOT_MODULES}.items():
        if tables.get(layer) != known:
            problems.append(f"{GUIDES[0]}: the modules of '{layer}' are "
                            + ", ".join(known))
    return problems


def missing_files(root, path):
    """Files that a guide names and that do not exist."""
    places = ("", "source", os.path.join("include", "contrecoup"))
    return [f"{path}:{number}: there is no {name}"
            for number, line in enumerate(lines_of(root, path), 1)
            for name in re.findall(
                r"`((?:\w+/)+\w+\.(?:h|cc|py|prm|md|toml|csv))`", line)
            if not any(os.path.exists(os.path.join(root, place, name))
                       for place in places)]


def prose(root, path):
    """The lines of a text, empty where they are code."""
    found, in_code = [], False
    for line in lines_of(root, path):
        fence = line.lstrip().startswith("```")
        in_code ^= fence
        found.append("" if fence or in_code else line)
    return found


def anchors(root, path):
    """Anchors that links to places in a text may name: its headings, in lower
    case, with hyphens for blanks and without other signs."""
    found = set()
    for line in prose(root, path):
        if heading := re.match(r"#{1,6} +(.*)", line):
            name = re.sub(r"[^\w\- ]", "", heading[1].strip().lower())
            name, count = name.replace(" ", "-"), 1
            first = name
            while name in found:
                name, count = f"{first}-{count}", count + 1
            found.add(name)
    return found


def links(root):
    """All targets of links in texts exist: files, pictures and headings."""
    problems = []
    for path in texts(root):
        text = "\n".join(re.sub(r"`[^`]*`", "", line)
                         for line in prose(root, path))
        for link in re.finditer(r"\]\(([^)\s]+)\)", text):
            if re.match(r"\w+:", link[1]):
                continue
            name, _, anchor = link[1].partition("#")
            target = os.path.normpath(os.path.join(
                os.path.dirname(path), name)) if name else path
            number = text.count("\n", 0, link.start()) + 1
            if not os.path.exists(os.path.join(root, target)):
                problems.append(f"{path}:{number}: there is no {target}")
            elif anchor and anchor not in anchors(root, target):
                problems.append(f"{path}:{number}: {target} has no heading "
                                f"#{anchor}")
    return problems


def citation(root):
    """CITATION.cff and the newest section of CHANGELOG.md have the version of
    the build."""
    files = (("CMakeLists.txt", r"project\(\w+ VERSION ([\d.]+)"),
             ("CITATION.cff", r"version: ([\d.]+)"),
             ("CHANGELOG.md", r"## (\d[\d.]*)"))
    found = []
    for path, pattern in files:
        lines = lines_of(root, path) if os.path.exists(
            os.path.join(root, path)) else []
        found += [match[1] for line in lines
                  if (match := re.match(pattern, line))][:1]
    if len(found) == 3 and len(set(found)) == 1:
        return []
    return ["CITATION.cff and CHANGELOG.md: their version must be that of "
            "CMakeLists.txt; found: " + (", ".join(found) or "none")]


def clang_tool(tool):
    """The name of a tool of LLVM 14."""
    error = Skip
    for name in (tool + "-14", tool):
        if shutil.which(name):
            error = OtherRelease
            version = subprocess.run([name, "--version"], check=True,
                                     capture_output=True, text=True).stdout
            if " 14." in version:
                return name
    raise error(f"{tool} 14 is not installed (Debian 12: apt install {tool})")


def formatting(root):
    """Every file is as clang-format 14 leaves it."""
    name = clang_tool("clang-format")
    style = "file:" + os.path.join(os.path.abspath(root), ".clang-format")
    # One start for all of them: it takes longer than most files.
    run = subprocess.run(
        [name, "--style=" + style, "--dry-run", *cpp_files(root)], cwd=root,
        check=True, capture_output=True, text=True)
    first = {}
    for path, line in re.findall(r"^(\S+?):(\d+):\d+: warning", run.stderr,
                                 re.M):
        first.setdefault(path, line)
    return [f"{path}:{line}: not formatted; run {name} -i {path}"
            for path, line in sorted(first.items())]


def is_cheap(root, path, known):
    """Whether a file includes, by itself or by headers of the tree, no library
    whose headers are in a folder of their own; @p known keeps answers by path.
    Headers that the build makes are not in the tree."""
    if path not in known:
        known[path] = True  # for headers that include each other
        known[path] = os.path.exists(os.path.join(root, path)) and all(
            is_cheap(root, os.path.join("include", name), known)
            if name.startswith("contrecoup/") else
            "/" not in name.replace("sys/", "")
            for line in lines_of(root, path)
            for name in re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)', line))
    return known[path]


def run_clang_tidy(root, files, folders):
    """Its findings in @p files and the headers that they include; @p folders
    are those of libraries' headers."""
    run = subprocess.run(
        [clang_tool("clang-tidy"), "--quiet", "--config-file="
         + os.path.join(os.path.abspath(root), ".clang-tidy"), *files, "--",
         "-std=c++17", "-Iinclude",
         # Paths that the build defines.
         '-DCONTRECOUP_SOURCE_PLOT=""', '-DCONTRECOUP_INSTALLED_PLOT=""', *(
             f"-isystem{path}" for path in folders
             # Else the compiler's own headers do not find those of C.
             if os.path.realpath(path) != "/usr/include")],
        cwd=root, capture_output=True, text=True)
    found = re.findall(r"^(\S+?):(\d+):\d+: (?:error|warning): (.*)$",
                       run.stdout, re.M)
    if run.returncode != 0 and not found:
        raise RuntimeError(run.stdout + run.stderr)
    # Other findings in code that does not compile mean nothing.
    found = [finding for finding in found if "clang-diagnostic-error"
             in finding[2]] or found
    return {f"{os.path.relpath(os.path.join(root, path), root)}:{line}: {text}"
            for path, line, text in found}


def tidy(root, *folders):
    """clang-tidy 14 finds nothing in the headers of the lowest layers, nor in
    the sources that include neither deal.II nor Boost: these take a second each,
    the others five to twenty, nearly all for headers of these libraries."""
    known = {}
    cheap = [path for path in cpp_files(root, ("source",))
             if path.endswith(".cc") and is_cheap(root, path, known)]
    problems = run_clang_tidy(root, cheap, folders)
    headers = [os.path.relpath(path, "include")
               for path in cpp_files(root, ("include",))
               if layer_of(path) in ("base", "materials", "numerics")]
    with tempfile.NamedTemporaryFile("w", suffix=".cc") as file:
        file.write("".join(f"#include <{path}>\n" for path in headers))
        file.flush()
        problems |= run_clang_tidy(root, [file.name], folders)
    return sorted(problems)


def spelling(root):
    """codespell finds no misspelled word; .codespellrc has the exceptions."""
    if not shutil.which("codespell"):
        raise Skip("codespell is not installed (Debian: apt install codespell)")
    run = subprocess.run(["codespell", "--disable-colors", "."], cwd=root,
                         capture_output=True, text=True)
    return [line.removeprefix("./") for line in run.stdout.splitlines()
            if "==>" in line]


def mutations(root):
    """The faults of tests/mutations fit the sources."""
    run = subprocess.run(
        [sys.executable, os.path.join(root, "tests/mutations/run.py"),
         "--check"], check=False, text=True, stdout=subprocess.PIPE)
    return run.stdout.splitlines()[:-1]


CHECKS = {check.__name__: check for check in
          (layers, modules, plot_modules, lengths, sizes, functions, mirror,
           overloads, licence, parameters, guide, links, citation, spelling,
           formatting, mutations, tidy)}


def run_check(name, root, folders):
    """Prints what a check finds, and returns the exit code."""
    try:
        problems = CHECKS[name](root, *folders)
    except Skip as reason:
        print(f"skipped: {reason}")
        return 1 if reason.fails() else SKIPPED
    for problem in problems:
        print(problem)
    print(f"{name}: {len(problems)} problem(s)")
    return 1 if problems else 0


def main(arguments):
    if not arguments or arguments[0] not in (*CHECKS, "quick"):
        print("usage: check_tree.py CHECK [ROOT [FOLDER...]]; CHECK is one of: "
              + ", ".join((*CHECKS, "quick")), file=sys.stderr)
        return 2
    root = arguments[1] if len(arguments) > 1 else "."
    if not any(True for _ in cpp_files(root)):
        print(f"no .h or .cc files below {root}", file=sys.stderr)
        return 2
    names = arguments[:1]
    if names == ["quick"]:
        names = [name for name in CHECKS if name != "tidy"]
    codes = [run_check(name, root, arguments[2:]) for name in names]
    return 1 if 1 in codes else max(codes)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
