# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Maps of what a blast would do to people who stand in a plane of gauges: lines
of equal probability, and the limit of training."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm, Normalize
from matplotlib.patheffects import withStroke

from plot.figures import blast_maps, style

PSI = 6894.757  # Pa
PERCENT = {0.01: "1 %", 0.5: "50 %", 0.99: "99 %"}
# Title and named levels of each panel.
PANELS = {
    "eardrum_rupture": ("rupture of an eardrum", PERCENT),
    "lung_lethality": ("death by lung injury", PERCENT),
    "chest_wall_velocity": ("chest wall under side-on pressure",
                            {level: f"{level:g} m/s"
                             for level in (1., 2., 4., 8., 16.)}),
    "peak_overpressure": ("peak overpressure", {4. * PSI: "4 psi"})}
# Part of a map's sides within which no name of a level stands.
BORDER = 0.12
# Names of the fields that planes with injuries have, others do not.
INJURIES = ("eardrum_rupture", "lung_exposure", "lung_lethality",
            "chest_wall_velocity", "first_phase_fraction")
# Field that is 1 where the velocity of the chest wall is a lower limit; planes of
# before 0.2.0 have none.
LIMITS = "chest_wall_velocity_cut_off"


def are_in(maps):
    """Whether the planes of a group, by quantity, have injuries."""
    return all(name in maps for name in (*PANELS, *INJURIES))


def area_above(maps, name, level):
    """Area of the plane [m^2] where a quantity is known to exceed a level, by
    the gauges that do, each with the part of the plane that is nearest to it,
    and on the other side of planes of symmetry; in axisymmetric cells of the
    half plane."""
    return _area_where(maps[name], _above(maps, name, level))


def common_areas_above(maps, others, name, level):
    """Areas of two runs where a quantity exceeds a level, see area_above(), by
    the gauges of which both know it."""
    known = _known(maps, name) & _known(others, name)
    return [_area_where(maps[name], known & _above(one, name, level))
            for one in (maps, others)]


def area_unknown(maps, name):
    """Area of the plane [m^2] where a quantity is not known, see draw()."""
    return _area_where(maps[name], ~_known(maps, name))


def goes_beyond(maps, name, level):
    """Whether a quantity exceeds a level at a side of the plane that is no plane
    of symmetry: the area where it does is larger than that of the plane."""
    above = _above(maps, name, level)
    sides = {(0, 0): above[:, 0], (0, 1): above[:, -1],
             (1, 0): above[0], (1, 1): above[-1]}
    return any(side.any() for key, side in sides.items()
               if key not in maps[name].mirrored)


def area_of_limits(maps):
    """Area of the plane [m^2] where the velocity of the chest wall is a lower
    limit."""
    return _area_where(maps[LIMITS], np.nan_to_num(maps[LIMITS].values) > 0.5) \
        if LIMITS in maps else 0.


def area(maps):
    """Area of the plane [m^2]."""
    plane = next(iter(maps.values()))
    return _area_where(plane, np.ones_like(plane.values))


def _area_where(plane, chosen):
    # Of the parts nearest to each of the gauges, the first and last of which are
    # at the ends.
    widths = [np.full(points, (high - low) / max(points - 1, 1))
              for low, high, points in zip(plane.lower, plane.upper,
                                           plane.values.shape[::-1])]
    for along in widths:
        if len(along) > 1:
            along[[0, -1]] /= 2.
    x, y = widths
    return plane.copies * float(y @ np.asarray(chosen, float) @ x)


def at_distance(maps, name, charge, distance):
    """Least and largest known value of a quantity at the gauges that are within
    half their spacing of a distance from the charge; None where there is none."""
    plane = maps[name]
    axes = [np.linspace(low, high, points) for low, high, points in zip(
        plane.lower, plane.upper, plane.values.shape[::-1])]
    spacing = max((axis[1] - axis[0] for axis in axes if len(axis) > 1),
                  default=0.)
    places = dict(zip(plane.axes, np.meshgrid(*axes)))
    normal, = set("xyz") - set(plane.axes)
    away = np.sqrt(sum((places.get(axis, plane.place) - charge["xyz".index(axis)])
                       ** 2 for axis in [*plane.axes, normal]))
    values = plane.values[_known(maps, name)
                          & (np.abs(away - distance) <= 0.5 * spacing)]
    return (values.min(), values.max()) if len(values) else None


def _above(maps, name, level):
    """Gauges at which a quantity is known to exceed a level."""
    return _known(maps, name) & (np.nan_to_num(maps[name].values) > level)


def _known(maps, name):
    known = np.isfinite(maps[name].values)
    if "arrival" in maps:
        known &= maps["arrival"].values > 0.
    return known


def draw(maps, path, own=None):
    """A panel for each measure; grey where the blast has not arrived or the
    measure is not known; hatched where the velocity of the chest wall is a
    lower limit. @p own: named levels in place of those of PANELS, by
    measure."""
    figure, axes = blast_maps.four_panels(maps["peak_overpressure"])
    for axis, (name, (title, levels)) in zip(axes.flat, PANELS.items()):
        _draw_panel(axis, maps[name], _known(maps, name), title,
                    (own or {}).get(name, levels))
    if area_of_limits(maps) > 0.:
        blast_maps.hatch_limits(
            axes.flat[list(PANELS).index("chest_wall_velocity")], maps[LIMITS])
    style.save(figure, path)


def _draw_panel(axis, plane, known, title, levels):
    values = np.where(known, plane.values, np.nan)
    axis.set(facecolor="#cccccc", title=title)
    axis.grid(False)
    if not np.any(np.isfinite(values)):
        style.say_nothing(axis, "known nowhere")
        return
    high = float(np.nanpercentile(values, 99.))
    factor, unit = style.scale_unit(plane.unit, high)
    if plane.unit == "-":
        factor, unit, norm = 100., "%", Normalize(0., 100.)
    elif plane.quantity == "peak_overpressure" and high > 0.:
        norm = LogNorm(max(high / 200., 1e3) * factor,
                       max(high, 2e3) * factor)
    else:
        norm = Normalize(0., max(high, 1e-3) * factor)
    image = axis.imshow(values * factor, extent=plane.extent(), norm=norm,
                        cmap=style.SEQUENTIAL, interpolation="nearest")
    style.colour_bar(axis.figure, image, unit, ax=axis, pad=0.02, fraction=0.05,
                     extend=style.beyond(values * factor, norm))
    _draw_levels(axis, plane, values, levels)


def _draw_levels(axis, plane, values, levels):
    inside = [level for level in levels
              if np.nanmin(values) < level < np.nanmax(values)]
    if not inside or min(values.shape) < 2:
        return
    lines = axis.contour(plane.positions(), plane.positions(1), values, inside,
                         colors="white", linewidths=1.)
    _name_levels(axis, lines, levels)
    # A dark rim shows on any colour.
    plt.setp([*axis.collections, *lines.labelTexts],
             path_effects=[withStroke(linewidth=2., foreground="black")])


def _name_levels(axis, lines, levels):
    """Names each level once, where that is farthest from the names before, and
    not at the border of the map, which would cut the name; one whose line would
    lie among unknown gauges has none."""
    named = []
    left, right = axis.get_xlim()
    bottom, top = axis.get_ylim()
    for points in (max(parts, key=len, default=[]) for parts in lines.allsegs):
        if not len(points):
            continue
        # Not at the ends of the line, which are at those of the map.
        inner = points[len(points) // 5:-(len(points) // 5) or None]
        part = (inner - [left, bottom]) / [right - left, top - bottom]
        within = np.minimum(part, 1. - part).min(axis=1)
        inner = inner[within >= min(BORDER, within.max())]
        apart = [min((np.linalg.norm(point - other) for other in named),
                     default=-abs(i - len(inner) / 2.))
                 for i, point in enumerate(inner)]
        named.append(inner[int(np.argmax(apart))])
    axis.clabel(lines, fontsize=8, fmt=levels, manual=named)
    plt.setp(lines.labelTexts, clip_on=False)
