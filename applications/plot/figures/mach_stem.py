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
    count = bool(path) + bool(reflection)
    figure, axes = plt.subplots(1, count, squeeze=False,
                                figsize=(5.5 * count, 3.6))
    if path:
        axis = axes[0, 0]
        axis.plot(path.ranges, path.heights, "o", markersize=3,
                  label="triple point")
        heights = np.linspace(0., path.heights[path.early].max(), 50)
        axis.plot(np.polyval(path.parabola, heights), heights, color=style.GREY,
                  label=f"parabola, from {path.parabola[-1]:.3f} m on")
        axis.set(ylabel=style.label("height", "m"), ylim=(0., None),
                 title=f"path of the triple point, charge at {height:g} m")
        axis.legend()
    if reflection:
        axis = axes[0, -1]
        axis.plot(*reflection, "o-", markersize=3)
        axis.axhline(1., color=style.GREY)
        if limit:
            axis.axvline(limit, color=style.GREY, linestyle="--")
            axis.set_title(f"regular up to {limit:.3f} m")
        axis.set_ylabel("Mach number behind the reflection")
    for axis in axes[0]:
        axis.set_xlabel(style.label("ground range", "m"))
    style.save(figure, picture)
