# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The audit of a body's energy: what is missing, and what hourglass modes
store in its tissues."""

from plot.report import page

HOURGLASS = "hourglass_part"


class EnergyAudit:
    """Figures of the summary of biomechanics and their limits [-]."""

    def __init__(self, scene):
        body = scene.biomechanics
        self.residual = body.found("checks", "energy_residual")
        self.largest_residual, self.largest_hourglass = (
            (body.parameter(f"Energy audit/{entry}") or [usual])[0]
            for entry, usual in (("Largest residual", 0.01),
                                 ("Largest hourglass part", 0.1)))
        self.tissues = {
            name[len(HOURGLASS) + 1:].replace("_", " "):
            body.found("checks", name) or 0.
            for name in body.summary.get("checks") or {}
            if name.startswith(HOURGLASS + "_")}
        # That of a body is the largest of its tissues.
        of_all = body.found("checks", HOURGLASS)
        self.hourglass = None if of_all is None else max(
            [of_all, *self.tissues.values()])

    def is_known(self):
        return None not in (self.residual, self.hourglass)

    def missing(self):
        """The fraction of the energy that is missing, in words; the same at
        all places."""
        return page.percent(abs(self.residual), 3)

    def reservations(self):
        """Energies beyond their limits, in a sentence; [] if none are."""
        found = []
        if self.residual is not None \
                and abs(self.residual) > self.largest_residual:
            found.append(f"{self.missing()} of the body's energy is missing "
                         f"(limit {_limit(self.largest_residual)})")
        if (self.hourglass or 0.) > self.largest_hourglass:
            found.append(self._hourglass_words())
        return [page.joined(found) + "."] if found else []

    def _hourglass_words(self):
        tissues = page.joined(
            f"{page.percent(part, 3)} in {tissue}" for tissue, part in sorted(
                self.tissues.items(), key=lambda item: -item[1])
            if part > self.largest_hourglass)
        return (f"{page.percent(self.hourglass, 3)} of the largest internal "
                "energy of a tissue was stored in hourglass modes (limit "
                f"{_limit(self.largest_hourglass)})"
                + (f", {tissues}: stresses there are less certain"
                   if tissues else ""))

    def verdict(self):
        """Whether the audit holds, as a paragraph."""
        if not self.is_known():
            return page.missing("the audit in summary.json of biomechanics")
        holds = abs(self.residual) <= self.largest_residual \
            and self.hourglass <= self.largest_hourglass
        return page.paragraph(
            page.tag("span", "The audit of the body's energy "
                     + ("holds" if holds else "does not hold"),
                     kind="good" if holds else "bad"),
            f": {self.missing()} of the energy is missing (limit "
            f"{_limit(self.largest_residual)}), and "
            + self._hourglass_words() + ".")


def _limit(part):
    return page.plain(100. * part, "%")
