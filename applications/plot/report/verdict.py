# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The verdict of a report in plain words: whether the person survives, and what
becomes of eardrums, lungs and brain, with the bounds of the numerics."""

import re

from plot.report import error_estimate, injury_table, page

# Words up to a probability, for the event itself.
LIFE = ((0.01, "survives"), (0.5, "may die of lung injury"),
        (0.99, "probably dies of lung injury"),
        (2., "almost certainly dies of lung injury"))
EARS = ((0.05, "stay intact"), (0.5, "may rupture"),
        (0.95, "probably rupture"), (2., "almost certainly rupture"))
NO_LEVEL = "none"
SOUND, POSSIBLE = "no lung injury", "lung injury possible"
SEVERE, UNJUDGED = "severe", "survival not judged"
UNSURE = "uncertain by the numerics"
CUT = "the run ends too early"


class Verdict:
    """Verdict on one part of the person: words, and a detail in brackets
    behind them. @p kind: good, mid, bad or none. @p entry decides; the words
    are of all @p entries."""

    def __init__(self, subject, words, kind, detail="", entry=None, entries=()):
        self.subject, self.words, self.kind = subject, words, kind
        self.detail, self.entry = detail, entry
        self.entries = entries or (() if entry is None else (entry,))
        self.is_complete = True  # else more is loaded than what was measured

    def label(self):
        """A few words next to a mark on a picture."""
        if self.entry is None or not self.entry.curve:
            return self.subject
        differ = self.subject == "eardrums" \
            and len({entry.shown() for entry in self.entries}) > 1
        return (f"{_side(self.entry)} eardrum" if differ else self.subject) \
            + f" {self.entry.shown()}"

    def is_certain(self):
        """Whether the estimated error leaves all that the words say as it is;
        None if that is unknown."""
        known = [entry.is_certain() for entry in self.entries]
        if not self.is_complete or not known:
            return None
        return False if False in known else None if None in known else True

    def __str__(self):
        return with_detail(self.words, self.detail)


def with_detail(words, detail):
    """Words with a detail in brackets, or, where these stand already, after a
    colon."""
    return words if not detail else f"{words}: {detail}" \
        if words.endswith(")") else f"{words} ({detail})"


def verdicts(scene, judged):
    """All that the scene allows, in the order of the sentence."""
    life = _life(scene, judged)
    lungs = _by_tables(scene, judged, _lungs(judged))
    if lungs and lungs.words == SOUND and injury_table.off_the_gauges(scene):
        lungs.kind, lungs.is_complete = "mid", False
        lungs.detail = "; ".join(filter(None, (
            lungs.detail, "at gauges that do not face the charge")))
    if life and lungs and life.words == UNJUDGED and lungs.words == SOUND:
        lungs.words, lungs.kind = SOUND + " so far", "none"
    return [found for found in (life, _ears(judged), lungs,
                                _held(scene) or _brain(judged)) if found]


def sentence(scene, found):
    """Verdicts as one sentence."""
    text = "; ".join(str(one) for one in found)
    having = [one.entry for one in found if one.entry is not None]
    unknown = [entry for entry in having if entry.error is None]
    if unknown:
        text += "; numerical error" + (
            "" if len(unknown) == len(having) else " of " + page.joined(
                entry.short_title() for entry in unknown)) \
            + f" unknown: {error_estimate.why_unknown(scene, unknown)}"
    return text[:1].upper() + text[1:] + "." if text else (
        "The injury is unknown: the scene has neither gauges at chest and ears "
        "nor measures of injury.")


def _word(words, entry, value):
    """Meaning of a probability: published words, or its side of thresholds of
    the user's own."""
    if entry.is_open:
        return " not judged"
    if entry.is_own:
        return " " + entry.compared(value)
    return " " + next(word for limit, word in words if value < limit)


def _by_the_numerics(entry):
    """The bounds of a probability in words; "" where they say no more."""
    if entry.error is None or entry.is_open:
        return ""
    bounds = entry.shown_bounds()
    return "" if bounds == entry.shown() else f", by the numerics {bounds}"


def disagrees(scene, judged):
    """Whether the tables have another verdict on life than the run at the same
    place, beyond its error."""
    entry = injury_table.find(judged, "lung_lethality")
    if entry is None:
        return False
    known = injury_table.lungs_of_tables(scene, entry.name)
    low, high = entry.bounds() or (entry.value, entry.value)
    high = 1. if entry.is_cut else high
    return None not in known and (high < known[0] or low > known[1]) and (
        _word(LIFE, entry, entry.value)
        != _word(LIFE, entry, min(max(entry.value, known[0]), known[1])))


def _life(scene, judged):
    entry = injury_table.find(judged, "lung_lethality")
    if entry is None:
        # The run may have less than the positive phase.
        return _not_judged(scene) if injury_table.lungs_by(scene) == "probe" \
            and scene.blast.found("results", "probe_1_cut_off") else None
    if entry.is_open:
        return _not_judged(scene)
    if disagrees(scene, judged):
        return Verdict("life", "survival is uncertain", "bad",
                       f"death by lung injury: {entry.shown()} by this run"
                       f"{_by_the_numerics(entry)}, {_death_by_tables(scene)} "
                       f"by the tables{injury_table.at_trunk(scene)}",
                       entry)
    words = _word(LIFE, entry, entry.value).strip()
    detail = f"{entry.shown()}{_by_the_numerics(entry)}"
    if entry.is_own:
        words = f"death by lung injury {words}"
    else:
        detail = f"death by lung injury: {detail}"
    kind = injury_table.severity(entry)
    wall = injury_table.find(judged, "chest_wall_mean")
    if words == LIFE[0][1] and (
            (entry.error is not None and entry.bounds()[1] >= LIFE[0][0])
            or (wall is not None and "lethality" in wall.meaning())):
        words, kind = "probably survives", "mid"
    if any(one.exceeded() for one in judged
           if one.name in injury_table.OF_THE_MOTION):
        words = words.replace("survives", "survives as far as lungs tell")
    return Verdict("life", words, kind, detail, entry)


def _not_judged(scene):
    """The verdict on life where the end of the run cuts the load off."""
    known = _death_by_tables(scene)
    return Verdict("life", UNJUDGED, "none",
                   "the run ends before the positive phase does"
                   + (known and "; death by lung injury by the tables"
                      f"{injury_table.at_trunk(scene)}: {known}"))


def _death_by_tables(scene):
    """The probability by the tables in words, "" where they have none."""
    low, high = injury_table.lungs_of_tables(scene, "lung_lethality")
    return "" if None in (low, high) else page.chance(low) if low == high \
        else page.interval(low, high)


def other_ears(judged):
    """The eardrum that is likeliest to rupture, where the tables have another
    verdict at its distance; else None."""
    worst = max((entry for entry in judged if entry.name.startswith("ear_")),
                default=None, key=lambda entry: entry.value)
    return None if worst is None or worst.other_by_tables() is None else worst


def _ears(judged):
    """One verdict, or one for each ear where these differ."""
    ears = [entry for entry in judged if entry.name.startswith("ear_")]
    if not ears:
        return None
    worst = max(ears, key=lambda entry: entry.value)
    kind = injury_table.severity(worst)
    by_run = "" if other_ears(ears) is None else " by this run"
    tables = f", {worst.shown_tables()}" if worst.tables else ""
    words = [_worse_word(entry) for entry in ears]
    whose = "rupture of " if worst.is_own else ""
    sides = [_side(entry) for entry in ears]
    figures = [entry.shown() + by_run + _by_the_numerics(entry)
               for entry in ears]
    if len(set(words)) > 1:
        return Verdict("eardrums", ", ".join(
            with_detail(f"{whose}{side} eardrum{_singular(word)}",
                        figure + tables)
            for side, word, figure in zip(sides, words, figures)),
            kind, "", worst, ears)
    if len(set(figures)) > 1:
        figures = ["; ".join(f"{side} {figure}" for side, figure
                             in zip(sides, figures))]
        tables = tables.replace(",", ";", 1)
    return Verdict("eardrums", f"{whose}eardrums{words[0]}", kind,
                   figures[0] + tables, worst, ears)


def _side(ear):
    """The side of an ear's measure: "left"."""
    return ear.name[len("ear_rupture_"):].split()[0]


def _worse_word(entry):
    """The worse answer of run and tables, which is named if it is theirs."""
    other = entry.other_by_tables()
    return _word(EARS, entry, entry.value) if other is None \
        or other <= entry.value else _word(EARS, entry, other) + " by the tables"


def _singular(word):
    """" stay intact" of one eardrum: " stays intact"."""
    return word if word.startswith((" may", " not", " above", " below")) \
        else re.sub("stay|rupture", r"\g<0>s", word, 1)


def _levels(entry, values):
    """Levels of lung injury that velocities have, from the first level of the
    smallest to the last one of the largest: "trace to moderate"."""
    meanings = [entry.meaning(value) or NO_LEVEL for value in values]
    words = [SEVERE if "lethality" in meaning else
             meaning.split(" or ")[end].split(" to ")[end]
             for meaning, end in zip(meanings, (0, -1))]
    return " to ".join(dict.fromkeys(words))


def _load(judged):
    """The load that tells whether lungs kill: in the open, else the reflected
    one on the skin; None of a body without lungs."""
    loads = [entry for entry in judged if entry.name.startswith("lung_exposure")]
    return max(loads, default=None, key=lambda entry: (
        entry.name == "lung_exposure_air", entry.value))


def _lungs(judged):
    entry = injury_table.find(judged, "chest_wall_mean")
    load = _load(judged)
    unsure = f", {UNSURE}" \
        if load is not None and load.is_certain() is False else ""
    if load is not None and load.exceeded() and not (
            entry is not None and entry.exceeded()):
        # The worse one of two measures counts.
        return Verdict("lungs", POSSIBLE, "mid",
                       f"load {load.shown()} of the median lethal one, "
                       f"{load.reached()}{unsure}", load)
    is_known = entry is not None and not entry.is_open
    if not is_known and load is not None and not load.is_open:
        return Verdict("lungs", SOUND, injury_table.severity(load),
                       f"by the load alone, {load.shown()} of the median "
                       "lethal one" + (f", {load.compared()}" if load.is_own
                                       else "") + unsure, load)
    if not is_known or (load is not None and load.is_open
                        and not entry.exceeded()):
        mesh = injury_table.find(judged, "injury_chest_wall_velocity_mesh")
        is_cut = entry is not None or load is not None
        return (is_cut or mesh) and Verdict(
            "lungs", "lungs not judged", "none",
            CUT if is_cut else "no gauge is at chest or back")
    if entry.is_own:
        return _own_lungs(entry)
    here = _levels(entry, (entry.value, entry.value))
    detail = ""
    if entry.error is not None:
        bounds = _levels(entry, entry.bounds())
        detail = "" if bounds == here else f"by the numerics {bounds}"
        if detail and bounds.startswith(NO_LEVEL) and load is not None \
                and load.exceeded() and not unsure:
            detail += f"; the load on the lung is {load.reached()}"
    words = SOUND if here == NO_LEVEL else f"lung injury {here}"
    if entry.is_cut and here != SEVERE:
        words += " or worse"
    kind, entries = injury_table.severity(entry), (entry,)
    if words == SOUND and unsure:
        # The load may be above its threshold, though the chest wall is below.
        kind, entries = "mid", (entry, load)
        bounds = " to ".join(map(load.shown, load.bounds()))
        detail = "; ".join(filter(None, (
            detail, f"{UNSURE}: load {bounds} of the median lethal one")))
    return Verdict("lungs", words, kind, detail, entry, entries)


def _own_lungs(entry):
    """The verdict by thresholds of the user's own for the velocity of the chest
    wall."""
    words = f"chest wall velocity {entry.shown()}, {entry.compared()}"
    detail = "" if entry.is_certain() in (True, None) else \
        "by the numerics " + " to ".join(map(entry.shown, entry.bounds()))
    if not entry.exceeded():
        words, detail = SOUND, ", ".join(filter(None, (words, detail)))
    return Verdict("lungs", words, injury_table.severity(entry), detail, entry)


def other_lungs(scene, judged):
    """The load that tells whether lungs are injured, one of the tables at the
    same distance and its place in words, where only one of both is above the
    first threshold and makes the verdict another one: the nearest of the tables,
    or one of those that are all beyond the bounds of the run; else None."""
    lungs = _lungs(judged)
    if lungs is None or lungs.words not in (SOUND, POSSIBLE):
        return None
    load = _load(judged) if injury_table.lungs_by(scene) == "skin" else \
        injury_table.find(judged, "lung_exposure_air")
    known = injury_table.lungs_of_tables(scene, "lung_exposure")
    if None in (load, *known):
        return None
    low, high = load.bounds() or 2 * (load.value,)
    asked = {min(max(load.value, known[0]), known[1]): ""}
    if high < known[0] or low > known[1]:
        asked.update(zip(known, ("", "") if known[0] == known[1] else
                         (" in the open", " before a wall")))
    return next(((load, value, place) for value, place in asked.items()
                 if bool(load.exceeded(value)) != bool(load.exceeded())), None)


def _by_tables(scene, judged, lungs):
    """The verdict on lungs, with that of the tables where it is another one."""
    found = other_lungs(scene, judged)
    if found is None:
        return lungs
    told = POSSIBLE if lungs.words == SOUND else SOUND
    return Verdict(lungs.subject, lungs.words, "mid", "; ".join(filter(
        None, (lungs.detail, f"by the tables{injury_table.at_trunk(scene)} {told}, load "
               f"{page.number(found[1])}{found[2]}"))), lungs.entry,
        lungs.entries)


def _held(scene):
    """The verdict on a brain whose nodes are all held."""
    if not scene.biomechanics.found("checks", "brain_is_held"):
        return None
    return Verdict("brain", "brain: not judged, since it is held by "
                   "Biomechanics/Supports", "none")


def _brain(judged):
    """Verdict on strain, tension and motion that exceed a threshold."""
    measures = [entry for entry in judged if entry.name.startswith("injury_")
                and not entry.name.startswith("injury_lung")]
    entries = [entry for entry in measures if entry.has_verdict]
    cut = [entry.short_title() for entry in measures
           if entry.is_open and entry.thresholds]
    if not entries:
        return Verdict("brain", "brain not judged", "none", CUT) if cut else None
    above = [entry for entry in entries if entry.exceeded()]
    unsure = [entry for entry in entries if entry.is_certain() is False]
    if not above:
        beyond = page.joined(entry.short_title() for entry in measures
                             if entry.exceeded())
        details = (unsure and f"{UNSURE}: " + page.joined(
            entry.short_title() for entry in unsure),
                   cut and f"{page.joined(cut)} not judged, as {CUT}")
        return Verdict("brain", "brain: below all thresholds"
                       + (" so far" if cut else "")
                       + (f" but that of an exposure, {beyond}" if beyond
                          else ""),
                       "mid" if beyond else "none" if cut else "good",
                       "; ".join(filter(None, details)), entries[0], entries)
    words = [_reached(entry) for entry in above if entry not in unsure]
    if unsure:
        words.append(page.joined(_reached(entry) for entry in unsure)
                     + f" ({'each ' if len(unsure) > 1 else ''}{UNSURE})")
    return Verdict("brain", "brain: " + ", ".join(words), "mid", "", above[0],
                   above + unsure)


def _reached(entry):
    """Result of a measure of the brain, in words."""
    if not entry.exceeded():
        return f"{entry.short_title()} below its threshold" + (
            "s" if len(entry.thresholds) > 1 else "")
    if entry.name == "injury_intracranial_pressure_lowest" \
            and not entry.is_own:
        return entry.meaning()
    value = f" of {entry.shown()}" if entry.is_own else ""
    return f"{entry.short_title()}{value} {entry.reached()}"
