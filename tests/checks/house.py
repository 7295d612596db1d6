#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws the layers of the library, their modules and what includes what:
house.py ROOT PICTURE. Prints the lines of each layer and module."""

import collections
import os
import re
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402 (after the choice of its backend)

import check_tree  # noqa: E402

# Rows of the drawing, lowest first.
FLOORS = [["base"], ["materials", "numerics", "geometry"], ["io"],
          ["gas", "solid", "mpm"], ["ale", "coupling", "study"]]
WIDTH, HEIGHT = 15., 2.2
INCLUDE = re.compile(r"\s*#\s*include\s*<contrecoup/(\w+)/")


def measure(root):
    """Lines by layer and module, and numbers of includes from one layer to
    another."""
    lines = collections.defaultdict(collections.Counter)
    includes = collections.Counter()
    for path in check_tree.cpp_files(root, ("include", "source")):
        layer = check_tree.layer_of(path)
        if layer is None:
            continue
        content = check_tree.lines_of(root, path)
        module = check_tree.module_of(path, layer) or ""
        lines[layer][module] += len(content)
        for found in filter(None, map(INCLUDE.match, content)):
            if found[1] != layer:
                includes[layer, found[1]] += 1
    return lines, includes


def places(lines):
    """Left end, floor and width of each layer; widths of a floor are as its
    lines, but wide enough for a name."""
    found = {}
    for floor, names in enumerate(FLOORS):
        sizes = [max(sum(lines[name].values()), 6500) for name in names]
        left = 0.
        for name, size in zip(names, sizes):
            width = WIDTH * size / sum(sizes)
            found[name] = left, floor, width
            left += width
    return found


def draw_layer(axis, name, place, modules):
    left, floor, width = place
    low = HEIGHT * floor
    axis.add_patch(plt.Rectangle((left + 0.06, low), width - 0.12, 1.5,
                                 facecolor="#eef3f8", edgecolor="#0072B2"))
    total = sum(modules.values())
    axis.text(left + 0.16, low + 1.32, f"{name}, {total:,} lines", fontsize=9,
              va="center", weight="bold")
    order = [module for module in check_tree.MODULES.get(name, [])
             if modules[module]]
    inner = left + 0.16
    for module in order:
        part = (width - 0.32) * modules[module] / max(total, 1)
        axis.add_patch(plt.Rectangle((inner, low + 0.08), part - 0.03, 1.06,
                                     facecolor="white", edgecolor="#999999",
                                     linewidth=0.5))
        axis.text(inner + 0.5 * part, low + 0.61, f"{module}\n{modules[module]:,}",
                  fontsize=6.5, ha="center", va="center", rotation=90)
        inner += part


def draw(lines, includes, picture):
    figure, axis = plt.subplots(figsize=(WIDTH, 0.75 * HEIGHT * len(FLOORS)))
    found = places(lines)
    for (upper, lower), count in includes.items():
        (left, floor, width), (other, below, span) = found[upper], found[lower]
        axis.annotate(
            "", (other + 0.5 * span, HEIGHT * below + 1.5),
            (left + 0.5 * width, HEIGHT * floor), zorder=0,
            arrowprops={"arrowstyle": "->", "color": "#D55E00", "alpha": 0.5,
                        "linewidth": min(0.3 + 0.02 * count, 6.)})
    for name, place in found.items():
        draw_layer(axis, name, place, lines[name])
    axis.set_xlim(0., WIDTH)
    axis.set_ylim(-0.1, HEIGHT * len(FLOORS))
    axis.set_axis_off()
    figure.savefig(picture, bbox_inches="tight")
    plt.close(figure)


def main(root, picture):
    lines, includes = measure(root)
    for floor in reversed(FLOORS):
        for name in floor:
            print(f"{name:10} {sum(lines[name].values()):6}  " + ", ".join(
                f"{module} {lines[name][module]}"
                for module in check_tree.MODULES.get(name, [])))
    print(f"all        {sum(sum(one.values()) for one in lines.values()):6}")
    draw(lines, includes, picture)
    print(f"drawn: {os.path.abspath(picture)}; arrows: includes, the thicker the "
          "more")


if __name__ == "__main__":
    main(*sys.argv[1:])
