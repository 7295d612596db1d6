# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of one-dimensional runs over their axis."""

import matplotlib.pyplot as plt
import numpy as np

from plot.readers.profiles import QUANTITIES
from plot.figures import style


def draw_profiles(profiles, path):
    """One panel for each quantity, one line for each time."""
    names = [name for name in QUANTITIES if name in profiles[0].values]
    figure, axes = plt.subplots(len(names), 1, squeeze=False, sharex=True,
                                figsize=(7., 2. * len(names) + 0.6))
    colours = plt.get_cmap("viridis")(np.linspace(0., 0.85, len(profiles)))
    time_factor, time_unit = style.scale_unit("s", profiles[-1].time)
    for axis, name in zip(axes[:, 0], names):
        largest = max(np.max(np.abs(p.values[name])) for p in profiles)
        factor, unit = style.scale_unit(profiles[0].units[name], largest)
        for profile, colour in zip(profiles, colours):
            axis.plot(profile.x, profile.values[name] * factor, color=colour,
                      label=f"{profile.time * time_factor:.3g} {time_unit}")
        axis.set_ylabel(style.label(name, unit))
    axes[0, 0].legend(title="time")
    axes[-1, 0].set_xlabel(style.label("x", "m"))
    style.save(figure, path)
