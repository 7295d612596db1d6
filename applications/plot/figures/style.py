# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The style of all pictures: fonts, colours, units."""

import os

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import FuncNorm, ListedColormap
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullLocator

matplotlib.use("Agg")

# Okabe and Ito (2008): told apart by people with any colour vision.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9",
           "#000000", "#F0E442"]
GREY = "#666666"
BODY = "#8a8a8a"  # where there is no gas

# Both are readable with any colour vision.
SEQUENTIAL = "magma"
DIVERGING = "RdBu_r"  # white where nothing happens

_PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1., ""), (1e-3, "m"),
             (1e-6, "µ"), (1e-9, "n")]
_PREFIXED_UNITS = {"s", "Pa", "J", "W", "m", "N", "Pa s", "Hz"}


def set_up():
    """Fonts, colours and axes of all figures from now on."""
    plt.rc("figure", dpi=150)
    plt.rc("figure.constrained_layout", use=True)
    plt.rc("savefig", dpi=150)
    plt.rc("font", family="DejaVu Sans", size=10)
    plt.rc("axes", titlesize=11, titlelocation="left", titleweight="bold",
           grid=True, axisbelow=True, prop_cycle=matplotlib.cycler(color=COLOURS))
    plt.rc("axes.spines", top=False, right=False)
    plt.rc("grid", color="#dddddd", linewidth=0.6)
    plt.rc("lines", linewidth=1.5)
    plt.rc("legend", frameon=False, fontsize=9)
    plt.rc("image", origin="lower")


def scale_unit(unit, largest):
    """Factor and unit in which numbers up to @p largest are easy to read:
    (1e-3, "kPa") for pascals of 1e5."""
    if unit == "-":
        return 1., ""
    for size, prefix in _PREFIXES if unit in _PREFIXED_UNITS else ():
        if largest >= size:
            return 1. / size, prefix + unit
    return 1., unit


def label(name, unit):
    """An axis label: name and unit."""
    name = name.replace("_", " ")
    unit = unit.replace("^2", "²").replace("^3", "³")
    return f"{name} [{unit}]" if unit else name


def say_nothing(axis, reason):
    """In the middle of an axis that has nothing to show, why."""
    axis.set(xticks=[], yticks=[])
    axis.text(0.5, 0.5, reason, transform=axis.transAxes, ha="center",
              va="center", fontsize=9)


def beyond(values, norm):
    """Which ends of a bar of colours are pointed, as values go beyond them."""
    low = np.nanmin(values) < norm.vmin
    high = np.nanmax(values) > norm.vmax
    return "both" if low and high else "min" if low else \
        "max" if high else "neither"


def about_zero(largest):
    """Square roots to both sides of zero, so that weak waves show as well."""
    return FuncNorm((lambda x: np.sign(x) * np.sqrt(np.abs(x)),
                     lambda x: np.sign(x) * x * x), -largest, largest)


def signed_scale(low, high):
    """Norm and colours of values about zero from @p low to @p high, as of
    about_zero(): the same size is as dark on both sides."""
    low, high = min(low, 0.), max(high, 0.)
    whole = about_zero(max(-low, high, 1e-9))
    if not high > low:
        return whole, plt.get_cmap(DIVERGING)
    part = about_zero(1.)
    part.vmin, part.vmax = low, high
    shades = np.linspace(*whole(np.array([low, high])), 256)
    return part, ListedColormap(plt.get_cmap(DIVERGING)(shades))


def label_decades(axis):
    """Marks a logarithmic axis with plain numbers."""
    axis.set_major_locator(LogLocator(subs=(1., 2., 5.)))
    axis.set_major_formatter(FormatStrFormatter("%g"))
    axis.set_minor_locator(NullLocator())


def pictures_folder(output_folder):
    """Where pictures of a run go; makes it."""
    folder = os.path.join(output_folder, "pictures")
    os.makedirs(folder, exist_ok=True)
    return folder


def draw_wave(axis, time, over, colour, linewidth):
    """A curve of overpressure, with the area to zero."""
    axis.axhline(0., color=GREY, linewidth=0.6)
    axis.fill_between(time, 0., over, color=colour, alpha=0.15, linewidth=0.)
    axis.plot(time, over, color=colour, linewidth=linewidth)


def colour_bar(figure, picture, words, **options):
    """A bar of colours without an outline, with a unit or other words."""
    bar = figure.colorbar(picture, **options)
    bar.set_label(words, fontsize=9)
    bar.outline.set_visible(False)
    return bar


def picture(output_folder, name):
    """Where a picture of a run goes; makes its folder."""
    return os.path.join(pictures_folder(output_folder), f"{name}.png")


def save(figure, path):
    """To a file, whose path is printed, or to a stream."""
    # Colour bars inside of axes are not seen by the constrained layout.
    figure.savefig(path, bbox_inches="tight")
    plt.close(figure)
    if isinstance(path, str):
        print(path)
