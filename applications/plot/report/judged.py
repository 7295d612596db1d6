# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""A measure of injury with its error, its thresholds and the tables."""

import math
import re

from plot.report import injury_thresholds, page


class Judged:
    """A measure next to its thresholds. Its error is relative; that of a
    probability is of the measure @p of which follows it by a @p curve. One that
    the end of the run cuts off is a lower limit of its magnitude. Finer cells
    may leave a @p least_part of one that goes by the positive phase. Values of
    the tables in the open and before a wall, if they are known and beyond all
    bounds, are in `tables`."""

    def __init__(self, name, value, unit, known, error, error_of,
                 coarser=None, curve="", of=None, is_cut=False, least_part=1.,
                 is_coarser_cut=False):
        self.name, self.value, self.unit = name, value, unit
        self.title, self.thresholds = known.title, known.thresholds
        self.source, self.limits = known.source, known.limits
        self.is_own = known.is_own
        self.coarser, self.error, self.error_of = coarser, error, error_of
        self.curve, self.of, self.is_cut = curve, of, is_cut
        self.is_coarser_cut = is_coarser_cut
        self.least_part, self.tables = least_part, None
        self.tables_place = ""  # at what distance, in words
        self.is_fraction = bool(curve) or self.title.startswith("fraction ")
        # A lower limit that exceeds no threshold yet says nothing.
        self.is_open = is_cut and not self.exceeded()
        self.has_verdict = bool(self.thresholds) and not known.is_exposure \
            and not self.is_open

    def short_title(self):
        """The abbreviation, or the title without its brackets."""
        match = re.search(r"\(([A-Z]\w+)\)$", self.title)
        return match[1] if match else self.title.partition(" (")[0]

    def bounds(self, curve=""):
        """Least and largest value by the numerics, of the probability of a
        curve by this measure; None if no error is known."""
        if self.error is None:
            return None
        value = self.value if self.of is None else self.of
        # The value of the coarser run lies farther off than zero.
        spread = abs(value) * self.error if value else abs(self.coarser or 0.)
        ends = [self.least_part * (value - spread), value + spread]
        if curve or self.curve:
            found = [injury_thresholds.probability(curve or self.curve, end)
                     for end in ends]
            # That of a wave that is not simple is the one of an endless phase.
            return min(found), max([*found, *([] if curve else [self.value])])
        # No measure changes its sign: all begin at zero.
        low, high = (0. if self.value >= 0. else -math.inf,
                     0. if self.value < 0. else
                     1. if self.is_fraction else math.inf)
        return tuple(sorted(min(max(end, low), high) for end in ends))

    def sure_bounds(self):
        """The same, None for an unknown one; a lower limit has none on the side
        on which the value may continue."""
        low, high = self.bounds() or (None, None)
        if self.is_cut:
            return (low, None) if self.value >= 0. else (None, high)
        return low, high

    def chances(self):
        """Events by this measure, their probabilities and the bounds of
        these."""
        for curve, event in injury_thresholds.CURVES.get(self.name, ()):
            yield (event, injury_thresholds.probability(curve, self.value),
                   self.bounds(curve))

    def shown(self, value=None, is_limit=False):
        """The value of this run, or another one, which may be a lower limit, in
        words."""
        is_limit = is_limit or (value is None and self.is_cut)
        limits = () if value is not None else [
            limit for limit, _ in self.thresholds]
        value = self.value if value is None else value
        if self.is_fraction:
            return page.least_chance(value) if is_limit \
                else page.chance(value, limits)
        return page.limit(page.quantity(
            value, self.unit, page.digits_beside(limits, value, 3)), is_limit)

    def shown_bounds(self):
        """bounds() of a probability or fraction in words."""
        return page.interval(*self.bounds(),
                             [limit for limit, _ in self.thresholds])

    def shown_coarser(self):
        """The value of the coarser run in words, a dash if unknown."""
        return "–" if self.coarser is None else self.shown(
            self.coarser, self.is_coarser_cut)

    def shown_limit(self, limit):
        """A threshold in words."""
        return page.plain(100. * limit, "%") if self.is_fraction \
            else page.plain(limit, self.unit)

    def shown_error(self):
        """The numerical error in words: of what lies between 0 and 1 the
        bounds, of anything else the error of the value; "" if unknown."""
        if self.error is None:
            return ""
        if not self.value and not self.coarser:
            return f"{self.shown_coarser()} in the coarser run, too"
        if not self.value and self.of is None:
            return f"up to {self.shown(self.bounds()[1])}"
        least = min(self.bounds(), key=abs)
        if self.is_cut and abs(least) > page.NO_CHANCE * self.is_fraction:
            return f"by the numerics {self.shown(least, is_limit=True)}"
        return self.shown_bounds() if self.is_fraction and not self.is_cut \
            else page.error(self.error) + (
                "" if self.least_part == 1. else
                f", least {self.shown(self.bounds()[0])}")

    def exceeded(self, value=None):
        """Number of thresholds that a value, or this one's, exceeds."""
        value = self.value if value is None else value
        return sum(value < limit if limit < 0. else value > limit
                   for limit, _ in self.thresholds)

    def meaning(self, value=None):
        """Meaning of the worst exceeded threshold, "" below all."""
        count = self.exceeded(value)
        return self.thresholds[count - 1][1] if count else ""

    def compared(self, value=None):
        """Side of the user's own threshold on which a value, or this one's,
        is: of the worst exceeded one, or the first."""
        count = self.exceeded(value)
        limit, meaning = self.thresholds[max(count, 1) - 1]
        side = "above" if (count > 0) != (limit < 0.) else "below"
        return f"{side} {self.shown_limit(limit)} ({meaning})"

    def reached(self):
        """The worst exceeded threshold after the name of the measure."""
        meaning = self.meaning()
        return self.compared() if self.is_own else f"above the {meaning}" \
            if meaning.startswith(("limit", "threshold")) \
            else f"as for {meaning}"

    def other_by_tables(self):
        """The nearest value of the tables if it is another verdict, else
        None."""
        if self.tables is None or not self.has_verdict:
            return None
        nearest = min(max(self.value, self.tables[0]), self.tables[1])
        return None if self.exceeded(nearest) == self.exceeded() else nearest

    def shown_tables(self):
        """Values of the tables, in words; "" where they are unknown."""
        if self.tables is None:
            return ""
        low, high = map(self.shown, self.tables)
        place = f", {self.tables_place}," if self.tables_place else ""
        return f"by the tables{place} " + (
            low if low == high else f"{low} in the open, {high} before a wall")

    def is_certain(self):
        """Whether the estimated error leaves the verdict as it is; None if no
        error is known."""
        if self.error is None:
            return None
        bounds = self.bounds()
        if self.is_cut:
            bounds = [min(bounds, key=abs)]
        return all(self.exceeded(bound) == self.exceeded()
                   for bound in bounds)
