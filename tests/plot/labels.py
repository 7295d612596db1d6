# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Flaws of the labels of figures: those that are too small on a page
and those that overlap."""

import contextlib
import itertools
import unittest.mock

from matplotlib.text import Text

LEAST_POINTS = 8.
PAGE = 1004. / 96.  # inches, width of a report in a wide window
# Part of the area of the smaller box, which is larger than its letters.
MOST_COMMON = 0.05


class Label:
    """A text as it was drawn."""

    def __init__(self, text, renderer):
        self.words, self.size = text.get_text(), text.get_size()
        # Without the arrow that an annotation may have.
        self.box = Text.get_window_extent(text, renderer)


@contextlib.contextmanager
def drawn():
    """Labels that are drawn in a context, as a list."""
    labels, draw = {}, Text.draw

    def note(text, renderer, *arguments, **options):
        draw(text, renderer, *arguments, **options)
        if text.get_visible() and text.get_text().strip():
            labels[id(text)] = Label(text, renderer)

    found = []
    with unittest.mock.patch.object(Text, "draw", note):
        yield found
    found += labels.values()


def faults(figure):
    """Faults of a figure, a line each."""
    with drawn() as labels:
        figure.canvas.draw()
    width = figure.get_tightbbox(figure.canvas.get_renderer()).width
    scale = min(1., PAGE / width)
    found = [f"«{label.words}» has {scale * label.size:.1f} points"
             for label in labels if scale * label.size < LEAST_POINTS - 0.01]
    for one, other in itertools.combinations(labels, 2):
        part = _common(one.box, other.box)
        if part > MOST_COMMON:
            found.append(f"«{one.words}» and «{other.words}» overlap by "
                         f"{part:.2f}")
    return found


def _common(one, other):
    """Area that two boxes share, of the smaller one."""
    sides = [min(one.x1, other.x1) - max(one.x0, other.x0),
             min(one.y1, other.y1) - max(one.y0, other.y0)]
    smaller = min(one.width * one.height, other.width * other.height)
    return max(sides[0], 0.) * max(sides[1], 0.) / smaller if smaller else 0.
