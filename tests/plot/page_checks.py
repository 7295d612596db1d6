#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Checks a report in a browser, on screens and on paper:
page_checks.py REPORT.html prints what is wrong with it."""

import os
import re
import shutil
import subprocess
import sys

import browser

WIDTHS = (1200, 920, 800, 400)
# Part of a page's height above its lowest mark; the last may end anywhere.
LEAST_FILL = 0.5
LEAST_MEAN_FILL = 0.75

# Part of its size in points, below which a picture's labels of 10 points are
# smaller than 8.
LEAST_SIZE = 0.8

# Elements that stick out of the window, or whose content sticks out of them.
# Cut or scrolled content counts as well: it cannot be read at once.
TOO_WIDE = """
[...document.querySelectorAll("body, body *")].filter(element => {
  const box = element.getBoundingClientRect();
  return box.width > 0 && (box.right > innerWidth + 0.5 || box.left < -0.5
    || (element.scrollWidth > element.clientWidth + 1
        && getComputedStyle(element).display !== "inline"));
}).map(element => element.tagName.toLowerCase()
  + (element.className ? "." + element.className : "") + " «"
  + element.textContent.trim().slice(0, 40) + "»")
"""
# Pictures that were touched show themselves in their own size and scroll.
TOUCH = """
document.querySelectorAll(".picture input").forEach(box => box.click())
"""
# Displayed width over the width in points of each picture; those in dots have
# 150 an inch, as those of plot.report.page.
SIZES = """
[...document.images].filter(image => image.naturalWidth > 1).map(image =>
  image.getBoundingClientRect().width / (image.naturalWidth
    * (image.src.startsWith("data:image/svg") ? 1 : 96 / 150)))
"""
PICTURES = """
[...document.images].map(image => ({
  width: image.complete ? image.naturalWidth : 0,
  alt: image.getAttribute("alt"),
  caption: image.closest("figure")?.querySelector("figcaption")
    ?.textContent}))
"""


def find_faults(window, page, folder):
    """Opens a report in a browser; a list of what is wrong with it, one line
    each. The PDF is left in @p folder as report.pdf."""
    faults = []
    for width in WIDTHS:
        told, wanted = window.open(page, width)
        faults += [f"console at {width}: {text}" for text in told]
        faults += [f"asks for {url[:80]}" for url in wanted]
        faults += _width_faults(window, width)
        # Folded tables must fit as well.
        window.evaluate("document.querySelectorAll('details').forEach("
                        "part => { part.open = true; })")
        faults += _width_faults(window, width)
        window.evaluate(TOUCH)
        faults += [f"picture {number} is {size:.2f} of its size in a window of "
                   f"{width}" for number, size in
                   enumerate(window.evaluate(SIZES), 1) if size < LEAST_SIZE]
    faults += _picture_faults(window)
    window.open(page, WIDTHS[0])
    folded = window.evaluate(
        "[...document.querySelectorAll('details.table td')]"
        ".map(cell => cell.textContent)")
    paper = os.path.join(folder, "report.pdf")
    window.print_to(paper)
    return list(dict.fromkeys(faults)) + paper_faults(paper, folded)


def _width_faults(window, width):
    inner = window.evaluate("innerWidth")
    if inner != width:
        return [f"the window is {inner} wide instead of {width}"]
    across = window.evaluate("document.documentElement.scrollWidth")
    faults = [f"the page is {across} wide in a window of {width}"] \
        if across > width else []
    return faults + [f"too wide in a window of {width}: {text}"
                     for text in window.evaluate(TOO_WIDE)]


def _picture_faults(window):
    faults = []
    pictures = window.evaluate(PICTURES)
    if not pictures:
        faults.append("no picture is in it")
    for number, picture in enumerate(pictures, 1):
        name = f"picture {number}"
        if not picture["width"]:
            faults.append(f"{name} is not loaded")
        alternative = _plain(picture["alt"])
        if len(alternative) < 20:
            faults.append(f"{name} has no alternative text")
        elif alternative in _plain(picture["caption"]):
            faults.append(f"{name} has its caption as alternative text")
    return faults


def _plain(text):
    return " ".join((text or "").split())


def fills(paper):
    """Part of the height of each page of a PDF above its lowest mark."""
    run = subprocess.run(["pdftoppm", "-r", "24", "-gray", paper],
                         capture_output=True, check=True)
    found, rest = [], run.stdout
    while rest:
        match = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", rest)
        width, height = int(match[1]), int(match[2])
        pixels = rest[match.end():match.end() + width * height]
        rest = rest[match.end() + width * height:]
        rows = [row for row in range(height)
                if min(pixels[row * width:(row + 1) * width]) < 230]
        found.append((max(rows) + 1) / height if rows else 0.)
    return found


def paper_faults(paper, folded=()):
    """Flaws of a PDF: pages, and texts of @p folded that are not on it."""
    found = fills(paper)
    print(f"{len(found)} pages, filled to "
          + ", ".join(f"{fill:.2f}" for fill in found))
    faults = [f"page {number} of {len(found)} ends at {fill:.2f} of its "
              "height" for number, fill in enumerate(found[:-1], 1)
              if fill < LEAST_FILL]
    if len(found) > 2:
        mean = sum(found[:-1]) / (len(found) - 1)
        if mean < LEAST_MEAN_FILL:
            faults.append(f"pages end at {mean:.2f} of their height on "
                          "average")
    text = subprocess.run(["pdftotext", "-layout", paper, "-"], text=True,
                          capture_output=True, check=True).stdout
    words = set(text.split())
    for cell in folded:
        lost = [word for word in cell.split() if word not in words]
        if lost:
            faults.append(f"folded away on paper: «{cell[:40]}»")
    return faults


def leave_without_programs():
    """Ends the test where a program is missing: as skipped, where CI is set
    as failed."""
    missing = [] if browser.find_browser() else ["chromium"]
    missing += [name for name in ("pdftoppm", "pdftotext")
                if shutil.which(name) is None]
    if not missing:
        return
    words = ", ".join(missing) + " missing: the report was not opened in a " \
        "browser (packages chromium and poppler-utils)"
    if os.environ.get("CI"):
        sys.exit("FAILED: " + words)
    print("SKIPPED: " + words, file=sys.stderr)
    sys.exit(77)


def main(arguments):
    leave_without_programs()
    page, = arguments
    with browser.Browser(browser.find_browser()) as window:
        faults = find_faults(window, page, os.path.dirname(page))
    print("\n".join(faults) or "no faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
