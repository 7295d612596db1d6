# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A picture of the path of the triple point, and of Mach numbers behind the
reflected wave."""

import matplotlib.pyplot as plt
import numpy as np

from plot.figures import style


def draw(path, reflection, limit, height, picture):
    """A panel for the Path of the triple point and one for the Mach numbers,
    each if there is one; reflection is regular up to @p limit [m] or None."""
    panels = []
    if path:
        panels.append(lambda axis: _draw_path(axis, path, height))
    if reflection:
        panels.append(lambda axis: _draw_mach(axis, *reflection, limit))
    figure, axes = plt.subplots(1, len(panels), squeeze=False,
                                figsize=(5.5 * len(panels), 3.6))
    for axis, draw_panel in zip(axes[0], panels):
        draw_panel(axis)
    style.save(figure, picture)


def _draw_mach(axis, ranges, mach, transition):
    axis.plot(ranges, mach, "o-", markersize=3)
    axis.axhline(1., color=style.GREY)
    if transition:
        axis.axvline(transition, color=style.GREY, linestyle="--")
        axis.set_title(f"regular up to {transition:.3f} m")
    axis.set_xlabel(style.label("ground range", "m"))
    axis.set_ylabel("Mach number behind the reflection")


def _draw_path(axis, path, height):
    axis.plot(path.ranges, path.heights, "o", markersize=3,
              label="triple point")
    heights = np.linspace(0., path.heights[path.early].max(), 50)
    axis.plot(np.polyval(path.parabola, heights), heights, color=style.GREY,
              label=f"parabola, from {path.parabola[-1]:.3f} m on")
    axis.set_xlabel(style.label("ground range", "m"))
    axis.set_ylabel(style.label("height", "m"))
    axis.set_title(f"path of the triple point, charge at {height:g} m")
    axis.set_ylim(bottom=0.)
    axis.legend()
