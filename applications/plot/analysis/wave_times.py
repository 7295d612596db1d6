# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Which outputs of a run show waves: pictures of others would be blank."""

import numpy as np

from plot.readers import fields, tables

MOST_FIELDS, MOST_PLANES = 8, 6
# Parts of the largest absolute value below which a picture is pale, and of the
# undisturbed value below which nothing has happened.
SEEN, QUIET = 0.02, 1e-4


def _even(found, most):
    chosen = np.unique(np.linspace(0, len(found) - 1, most).round())
    return [found[int(number)] for number in chosen]


def denser(found, most, exponent):
    """Up to so many of these, each once, denser at the beginning."""
    if len(found) <= most:
        return found
    numbers = []
    for place in np.linspace(0., 1., most) ** exponent * (len(found) - 1):
        numbers.append(max(int(place), numbers[-1] + 1 if numbers else 0))
    return [found[number] for number in numbers if number < len(found)]


def of_body(outputs, history, probes):
    """Outputs of biomechanics, times and files, while waves are in the body:
    where its elastic energy in history.csv, which goes with the square of
    pressures, and the largest pressure in probes.csv are to be seen. A table
    that is None, or without such columns, says nothing."""
    begin, end = -np.inf, np.inf
    for table, ending, part in ((history, "stored_energy", SEEN ** 2),
                                (probes, "_pressure", SEEN)):
        names = [] if table is None else [
            name for name in table.names if name.endswith(ending)]
        size = np.max([np.abs(table[name]) for name in names], axis=0) \
            if names else np.zeros(1)
        seen = np.flatnonzero(size > part * size.max())
        if seen.size:
            begin = max(begin, table["time"][seen[0]])
            end = min(end, table["time"][seen[-1]])
    return [output for output in outputs if begin <= output[0] <= end] \
        or outputs[-1:]


def fields_to_draw(folder):
    """Up to MOST_FIELDS of those, evenly spread."""
    found = of_body(fields.list_fields(folder),
                    *(tables.open_table(folder, name)
                      for name in ("history.csv", "probes.csv")))
    return _even(found, MOST_FIELDS)


def background(planes):
    """The undisturbed value: the commonest one at the start."""
    values = planes[0].values[np.isfinite(planes[0].values)]
    found, counts = np.unique(values, return_counts=True)
    if counts.max() > 0.02 * values.size:
        return float(found[counts.argmax()])
    return float(np.median(values))


def of_planes(planes, part=0.):
    """Planes of a series from the first to the last that differ from the
    undisturbed value, by this part of the largest difference at least; all of
    them where none does."""
    quiet = background(planes)
    sizes = np.array([np.nanmax(np.abs(plane.values - quiet), initial=0.)
                      for plane in planes])
    seen = np.flatnonzero(sizes > max(part * sizes.max(), QUIET * abs(quiet)))
    return planes[seen[0]:seen[-1] + 1] if seen.size else planes


def planes_to_draw(planes):
    """Up to MOST_PLANES of those, evenly spread."""
    return _even(of_planes(planes), MOST_PLANES)
