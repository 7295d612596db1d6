# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of one-dimensional runs over their axis, and of radial blasts."""

import matplotlib.pyplot as plt
import numpy as np

from plot.readers.profiles import QUANTITIES
from plot.figures import style

AROUND = 0.03  # of the shock's radius, to each side of it


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


def draw_radial(runs, path):
    """Several radial blasts next to one another."""
    figure, axes = plt.subplots(2, 2, figsize=(9.6, 6.4))
    for axis, (title, factor, unit) in zip(axes.flat, (
            ("density", 1., "kg/m^3"), ("velocity", 1e-3, "km/s"),
            ("pressure", 1e-6, "MPa"), ("pressure at the shock", 1e-6, "MPa"))):
        for run, colour in zip(runs, style.COLOURS):
            axis.plot(run.last.radius,
                      getattr(run.last, title.split()[0]) * factor,
                      color=colour, label=run.label, linewidth=1.2,
                      linestyle="-" if run.history else "--", markersize=3,
                      marker="o" if run.history and axis is axes[1, 1]
                      else None)
        axis.set(xlabel=style.label("radius", "m"),
                 ylabel=style.label(title, unit))
    axes[0, 0].set_yscale("log")
    style.label_decades(axes[0, 0].yaxis)
    places = [shock[1] for shock in (run.last.shock() for run in runs) if shock]
    if places:
        axes[1, 1].set_xlim(min(places) * (1. - AROUND),
                            max(places) * (1. + AROUND))
    axes[0, 1].legend(loc="upper left")
    style.save(figure, path)
