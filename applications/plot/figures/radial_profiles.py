# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Pictures of several radial blasts next to one another."""

import matplotlib.pyplot as plt

from plot.figures import style

AROUND = 0.03  # of the shock's radius, to each side of it


def draw(runs, path):
    figure, axes = plt.subplots(2, 2, figsize=(9.6, 6.4))
    shocks = [shock for shock in (run.last.shock() for run in runs) if shock]
    for run, colour in zip(runs, style.COLOURS):
        last = run.last
        line = {"color": colour, "label": run.label, "linewidth": 1.2,
                "linestyle": "-" if run.history else "--"}
        axes[0, 0].plot(last.radius, last.density, **line)
        axes[0, 1].plot(last.radius, last.velocity * 1e-3, **line)
        axes[1, 0].plot(last.radius, last.pressure * 1e-6, **line)
        axes[1, 1].plot(last.radius, last.pressure * 1e-6, markersize=3,
                        marker="o" if run.history else None, **line)
    axes[0, 0].set_yscale("log")
    style.label_decades(axes[0, 0].yaxis)
    for axis, name, unit in zip(axes.flat, (
            "density", "velocity", "pressure", "pressure at the shock"),
            ("kg/m^3", "km/s", "MPa", "MPa")):
        axis.set_xlabel(style.label("radius", "m"))
        axis.set_ylabel(style.label(name, unit))
    if shocks:
        first = min(shock[1] for shock in shocks) * (1. - AROUND)
        last = max(shock[1] for shock in shocks) * (1. + AROUND)
        axes[1, 1].set_xlim(first, last)
    axes[0, 1].legend(loc="upper left")
    style.save(figure, path)
