# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Draws what the code sees of a shock and a body: plot.py walk OUTPUT_FOLDER

The folder is that of parameter_files/blast/showcase/walk.prm, or of a run like
it: blast in 2-D with finite volumes of an ideal gas, a shock along x, a body
whose loads are recorded, adaptation, and the fields of every step. Writes into
OUTPUT_FOLDER/pictures the figures of the chapter "A walk through the code" of
source/README.md: walk_step.png, walk_adaptation.png, walk_cut_cells.png and
walk_load.png.
"""

import numpy as np

from plot.readers import files, leaves
from plot.readers.loads import Loads
from plot.figures import style, walk

# The facet that is shown looks this way: against the shock, and up.
NORMAL = np.array([-0.8, 0.6])


class Line:
    """Effect of one step in the leaf with the strongest jump of the pressure
    along the upper side of the domain: n subcells of the leaf and two of each
    neighbour, of equal size. Nothing flows through the last face of the domain,
    so that sums of changes of the density are mass fluxes, means of the step
    [kg/(m^2 s)]."""

    def __init__(self, before, after):
        ends = before.corners[:, 1] + before.edges[:, 1]
        row = np.flatnonzero(np.isclose(ends, ends.max()))
        row = row[np.argsort(before.corners[row, 0])]
        self.n = before.n
        sizes = np.repeat(before.edges[row, 0] / self.n, self.n)
        x, pressure, density, later = (values[row, -1].ravel() for values in (
            before.centres()[..., 0], before.pressure, before.density,
            after.density))
        change = (later - density) * sizes / (after.time - before.time)
        flux = np.append(np.cumsum(change[::-1])[::-1], 0.)
        first = int(np.argmax(np.abs(np.diff(pressure)))) // self.n * self.n
        around = slice(first - 2, first + self.n + 2)
        self.edge = sizes[first]
        if len(sizes[around]) < self.n + 4 \
                or np.ptp(sizes[around]) > 1e-6 * self.edge:
            raise files.BrokenInput("the leaves at the shock differ in size")
        self.x, self.pressure = x[around], pressure[around]
        self.flux = flux[first:first + self.n + 1]
        self.change = change[first:first + self.n]


class Load:
    """The record of one facet, and the overpressure in its cell over time."""

    def __init__(self, states, loads):
        facet = int(np.argmax(loads.normals[:, :2] @ NORMAL))
        self.peak, self.arrival = (loads.measure(name)[facet]
                                   for name in ("peak", "arrival"))
        self.times = loads.times
        self.samples = loads.file["overpressure"][facet]
        self.ambient = float(loads.file.attrs["ambient_pressure_Pa"])
        self.begin = 0.8 * self.arrival
        # The centroid is the point of the surface nearest to the cell's centre.
        self.place = loads.centroids[facet, :2]
        along = loads.normals[facet, 1::-1] * np.array([-1., 1.])
        times, cell = [], []
        for state in states:
            edge = state.edges.min() / state.n
            offsets = state.centres() - self.place
            aside = np.where((np.linalg.norm(offsets, axis=-1) < edge)
                             & (state.open > 0.),
                             np.abs(offsets @ along), np.inf)
            at = np.unravel_index(np.argmin(aside), aside.shape)
            self.centre = state.centres()[at]
            times.append(state.time)
            cell.append(state.pressure[at] - self.ambient)
        self.cell_times, self.cell = np.array(times), np.array(cell)


def pick_adaptation(states):
    """The output after the adaptation that both halved and merged most leaves:
    the lesser of the two numbers counts."""
    counts = [min(map(len, walk.changed_leaves(*pair)))
              for pair in zip(states, states[1:])]
    if not any(counts):
        raise files.BrokenInput("no adaptation both halves and merges leaves; "
                                "are there fields of every step?")
    return 1 + int(np.argmax(counts))


def pick_step(states, time):
    """The first output after a time from which a step continues with the same
    leaves."""
    for number in range(len(states) - 1):
        if states[number].time >= time and \
                states[number].keys() == states[number + 1].keys():
            return number
    raise files.BrokenInput("the leaves change from each output to the next")


def main(output_folder):
    run = leaves.LeafRun(output_folder)
    states = run.states()
    with files.reading(run.path("loads.h5")):
        loads = Loads(run.path("loads.h5"))
        load = Load(states, loads)

    def path(name):
        return style.picture(output_folder, f"walk_{name}")

    number = pick_step(states, 0.5 * load.arrival)
    walk.draw_step(Line(states[number], states[number + 1]), path("step"))
    number = pick_adaptation(states)
    walk.draw_adaptation(states[number - 1], states[number],
                         path("adaptation"))
    edge = states[0].edges.min()
    near = tuple((place - edge, place + edge) for place in load.place)
    at_arrival = min(states, key=lambda state: abs(state.time - load.arrival))
    walk.draw_cut_cells(at_arrival, loads, near, path("cut_cells"))
    walk.draw_load(load, at_arrival, loads, near, path("load"))
