# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Compares the figures of a report.html with the files of its scene, to the
digits that are shown. The figures are worked out here again, from the
files alone."""

import math
import os
import re
import statistics

import h5py
import numpy as np
import report_reader
import second_waves
from case import read_columns, read_json, read_rows, read_text, require
from report_reader import require_same
from summaries import flaw_of, values_of

STAGES = ("anatomy", "blast", "biomechanics")
AT_TRUNK = " at the trunk"
COARSER = ("coarser_blast", "coarser_biomechanics")
# Rows of the injury table, by names of injury.csv.
TITLES = {
    "injury_intracranial_pressure_peak": "maximum brain pressure",
    "injury_intracranial_pressure_lowest": "minimum brain pressure",
    "injury_cavitating_fraction": "fraction of the brain ever below −100 kPa",
    "injury_cavitation_dose": "mean time of the brain below −100 kPa",
    "injury_strain_95":
        "brain strain (95th percentile of the largest principal strain)",
    "injury_csdm_15": "fraction of the brain strained above 0.15 (CSDM15)",
    "injury_csdm_25": "fraction of the brain strained above 0.25 (CSDM25)",
    "injury_hic15": "head injury criterion over 15 ms (HIC15)",
    "injury_bric": "brain injury criterion (BrIC)",
    "injury_chest_wall_velocity_mesh":
        "inward velocity of the chest's skin in the mesh"}
# Measures with thresholds that give no verdict.
EXPOSURES = ("maximum brain pressure",)
# Names of the measures of gauge_injury.csv and, of the first probe,
# probe_injury.csv in the report.
OF_SKIN = {("chest_wall_velocity", "chest"): "chest_wall_front",
           ("chest_wall_velocity", "back"): "chest_wall_back",
           ("chest_wall_velocity", "left upper arm"): "chest_wall_left",
           ("chest_wall_velocity", "right upper arm"): "chest_wall_right",
           ("chest_wall_velocity", "trunk"): "chest_wall_mean",
           ("lung_exposure", "chest"): "lung_exposure",
           ("lung_exposure", "back"): "lung_exposure_back",
           ("lung_exposure", "left upper arm"): "lung_exposure_left",
           ("lung_exposure", "right upper arm"): "lung_exposure_right",
           ("lung_exposure", "probe 1"): "lung_exposure_air",
           ("lung_lethality", "probe 1"): "lung_lethality"}
OF_AIR = ("lung_exposure_air", "lung_lethality")
SKIN_TITLES = {
    "chest_wall_front": "front chest wall velocity",
    "chest_wall_back": "back chest wall velocity",
    "chest_wall_left": "left chest wall velocity",
    "chest_wall_right": "right chest wall velocity",
    "chest_wall_mean": "mean chest wall velocity (over the trunk)",
    "lung_exposure": "chest load over the 50 % lethality load",
    "lung_exposure_back": "back load over the 50 % lethality load",
    "lung_exposure_left": "left side load over the 50 % lethality load",
    "lung_exposure_right": "right side load over the 50 % lethality load",
    "lung_exposure_air": "free-field load over the 50 % lethality load",
    "lung_lethality": "probability of death by lung injury",
    "ear_rupture": "rupture probability of an eardrum"}
WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight",
         "nine", "ten", "eleven", "twelve")
PRESSURES = ("injury_intracranial_pressure_peak",
             "injury_intracranial_pressure_lowest")
TENSIONS = ("injury_cavitating_fraction", "injury_cavitation_dose")
CHECKED = ("injury_pressure_roughness",
           *(f"injury_{name}_ais{degree}" for name in ("hic15", "bric")
             for degree in (2, 3, 4)))


class Files:
    """Files that the stages of a scene left."""

    def __init__(self, output):
        self.output = output
        self.scene = read_json(output, "scene.json")
        self.summary = {stage: read_json(output, stage, "summary.json")
                        for stage in STAGES}
        self.injury = {row["measure"]: float(row["value"]) for row in
                       read_rows(output, "biomechanics", "injury.csv")}
        self.units = {row["measure"]: row["unit"] for row in
                      read_rows(output, "biomechanics", "injury.csv")}
        self.places, self.skin = gauges_of(output, "blast")
        if not self.has_probe_at_body():
            for measure, place in list(self.skin):
                if place.startswith("probe "):
                    del self.skin[measure, place]
        arm = self.scene.get("person", {}).get("side_to_charge", "").replace(
            " side", " upper arm")
        self.side = max((side for side in ("chest", "back", arm)
                         if ("lung_exposure", side) in self.skin),
                        key=lambda side: self.skin["lung_exposure", side],
                        default="chest")
        self.air = dict(self.skin)
        self.trunk_is_far = self._is_trunk_far()
        self._lungs_by_the_skin(self.skin)
        self.gauges = {}
        if os.path.exists(os.path.join(output, "blast", "load_gauges.csv")):
            self.gauges = read_columns(output, "blast", "load_gauges.csv")

        # Values of the run with larger cells and elements, by the names of
        # expected_injuries().
        self.coarser = {row["measure"]: float(row["value"]) for row in
                        read_rows(output, COARSER[1], "injury.csv")}
        self.cut_alone = cut_names(output, *COARSER) - cut_names(
            output, "blast", "biomechanics")
        self.coarser_places, skin = gauges_of(output, COARSER[0])
        self._lungs_by_the_skin(skin)
        self.coarser.update({
            name: value
            for value, name in of_skin(skin, self.side).values()})

        self.least_phases = second_waves.of_skin(output, self.places,
                                                 self.coarser_places)
        self.fewer_waves = second_waves.of_fewer_waves(
            output, self.places, self.coarser_places)
        self.least_at_probe = second_waves.at_probe(output)

        paths = [os.path.join(output, stage, "summary.json")
                 for stage in COARSER]
        coarser = [read_json(path) if os.path.exists(path) else {}
                   for path in paths]
        self.coarser_results = values_of(coarser[0], "results")
        self.warnings = {text for told in (
            self.scene, *self.summary.values(), *coarser)
            for text in told.get("warnings", [])}

    def error_of_result(self, name):
        """Relative error of what the blast found at its first probe, None if
        that is unknown."""
        runs = [self.coarser_results, values_of(self.summary["blast"],
                                                "results")]
        values = [run.get("probe_1_" + name) for run in runs]
        return max(0.02, abs(values[0] / values[1] - 1.) / (2. ** 0.7 - 1.)) \
            if all(values) else None

    def entry(self, stage, name):
        """Value of an entry of a stage, whose name one section has."""
        found = re.search(rf"set {name} *= *(.*)",
                          read_text(self.output, stage, "parameters.prm"))
        return found[1] if found else ""

    def has_lower_limits(self):
        """Whether the end of the run cuts a measure with a threshold off."""
        return any(float(row.get("cut off [-]", 0.)) > 0.
                   and not row["threshold"].startswith("no threshold")
                   for row in read_rows(self.output, "biomechanics",
                                        "injury.csv"))

    def limit(self, stage, entry, usual):
        return float(self.entry(stage, entry) or usual)

    def has_probe_at_body(self):
        """Whether the first probe of the blast is that of the scene next to
        the body, and not one of the user's."""
        return self.scene.get("probe_beside_body") is not None

    def _is_trunk_far(self):
        """Whether chest, back and upper arms are farther from the charge than
        the nearest skin, by more than 15 %."""
        apart = [math.dist([float(x) for x in place.split(",")],
                           self.scene["charge_place"]) for place in re.findall(
            r"(?:chest|back|upper arm): ([^;]*)", self.entry("blast", "Gauges"))]
        return bool(apart) and min(apart) > 1.05 * self.scene["distance"]

    def compared(self):
        """Rows against the tables, without the lungs of a far trunk."""
        return [row for row in self.scene.get("table_comparison", [])
                if not (self.trunk_is_far and row["name"].startswith("lung_"))]

    def load_of_lungs(self):
        """Name and value of the load from which death by lung injury follows."""
        key = ("lung_exposure", self.side if self.trunk_is_far
               or not self.has_probe_at_body() else "probe 1")
        return OF_SKIN[key], self.skin[key]

    def least_part_of_load(self, name):
        """Part of a load on lungs that a second wave may leave."""
        phases = self.least_at_probe if name in OF_AIR else (
            self.least_phases.get(self.side) and (
                self.places[self.side]["positive phase"],
                self.least_phases[self.side]))
        if not phases or name not in (
                "lung_exposure_air", OF_SKIN.get(("lung_exposure", self.side))):
            return 1.
        return second_waves.part_of_load(
            *phases, float(self.entry("blast", "Body mass")))

    def _lungs_by_the_skin(self, skin):
        """Replaces the wave next to a person by the load on the trunk where
        that is far or no probe is next to the person."""
        is_person = "posture" in self.scene.get("person", {})
        if is_person and ("lung_exposure", self.side) in skin and (
                self.trunk_is_far or not self.has_probe_at_body()):
            skin.pop(("lung_exposure", "probe 1"), None)
            place = math.log(skin["lung_exposure", self.side]) / 0.1788
            skin["lung_lethality", "probe 1"] = 0.5 * math.erfc(
                -place / math.sqrt(2.))

    def has_same_phase(self, place):
        """Whether the positive phase at a gauge is complete in both runs, and of
        as many waves."""
        return place not in self.fewer_waves and not any(
            run.get(place, {}).get("cut off") for run in (
                self.places, self.coarser_places))

    def person(self):
        """Stature and mass in the description of the person, by their units."""
        text = self.scene.get("person", {}).get("description", "")
        return {unit: float(value) for value, unit
                in re.findall(r"([\d.]+) (m|kg)\b", text)}

    def peak(self, place):
        return self.places[place]["peak"]


def check_report(output):
    """Every figure that the files have; the number of those compared."""
    files = Files(output)
    page = report_reader.read(os.path.join(output, "report.html"))
    checks = (check_facts, check_injury, check_headline, check_tables,
              check_gauges, check_events, check_summary_file, check_log,
              check_conservation, check_audit, check_free_air,
              check_differences, check_energy, check_mesh, check_cost)
    count = sum(check(page, files) for check in checks)
    print(f"{count} figures of the report are those of the files")
    return count


def check_facts(page, files):
    table = {row[0]: row[1] for row in page.table("The scene").rows}
    known = {"charge": "charge_mass", "distance to the body": "distance",
             "height above ground": "height", "end of the run": "end_time",
             "gas cells at the skin": "cell_size_at_body",
             "elements of the body": "element_size"}
    if files.scene.get("question") == "loads":
        del known["elements of the body"]
    for name, key in known.items():
        require_same(table[name], files.scene[key], name)
    return len(known)


def gauges_of(output, stage):
    """The measures of each gauge by name, and the injuries by measure and
    place; {} without gauges."""
    places, skin = {}, {}
    if os.path.exists(os.path.join(output, stage, "gauge_measures.csv")):
        for row in read_rows(output, stage, "gauge_measures.csv"):
            place = row.pop("place")
            places[place] = {key.split(" [")[0]: float(value)
                             for key, value in row.items()}
    for name in ("gauge_injury.csv", "probe_injury.csv"):
        if os.path.exists(os.path.join(output, stage, name)):
            for row in read_rows(output, stage, name):
                skin[row["measure"], row["place"]] = float(row["value"])
    return places, skin


def cut_names(output, blast, body):
    """Names of measures that the end of a run cuts off."""
    names = set()
    for stage, name in ((blast, "gauge_injury.csv"), (blast, "probe_injury.csv"),
                        (body, "injury.csv")):
        if os.path.exists(os.path.join(output, stage, name)):
            names |= {OF_SKIN.get((row["measure"], row.get("place")),
                                  row["measure"])
                      for row in read_rows(output, stage, name)
                      if float(row.get("cut off [-]", 0.)) > 0.}
    return names


def of_skin(skin, side):
    """By title: the value of an injury at the gauges, of chest and back at one
    side, or at the probe next to the body, and its name."""
    rows = {}
    for (measure, place), value in skin.items():
        if measure == "eardrum_rupture" and place.endswith("ear"):
            rows[f"rupture probability of the {place}drum"] = value, place
        name = OF_SKIN.get((measure, place))
        if name in OF_AIR and ("lung_exposure", "chest") not in skin:
            continue
        if name and place in (side, "trunk", "probe 1"):
            rows[SKIN_TITLES[name]] = value, name
    return rows


def expected_injuries(files):
    """By title: the value, and its name in Files.coarser."""
    rows = of_skin(files.skin, files.side)
    for name, value in files.injury.items():
        if name not in CHECKED:
            rows[TITLES[name]] = value, name
    return rows


def check_injury(page, files):
    """Each measure has a row, each row its value and error."""
    expected = expected_injuries(files)
    rows = [row for table in page.tables if table.section == "Injury"
            for row in table.records()]
    require(sorted(row["measure"] for row in rows) == sorted(expected),
            f"the injury table has {[row['measure'] for row in rows]}, the "
            f"files {list(expected)}")
    for row in rows:
        title = row["measure"]
        value, name = expected[title]
        lines = row["value and its estimated error"].split("\n")
        require_chance(lines[0], value, title)
        require_error(lines[1], title, name, value, files)
        if title in EXPOSURES:
            require(row["verdict"] == "exposure, no verdict", f"{row}")
        told = re.match(r"peak (.*?);", row["limitations"])
        if told:
            ear = title.split("the ")[1].replace("drum", "")
            require_same(told[1], files.places[ear]["peak"], ear)
    return 2 * len(rows)


def require_chance(text, value, what):
    """A value in words; of a probability, words for what is nearly 0 or 1."""
    if text.startswith("less than"):
        require(text.startswith("less than 0.1 %") and 0. <= value < 0.001,
                f"{what} is {value}, not {text}")
    elif text.startswith("more than"):
        require(text.startswith("more than 99 %") and 0.99 < value <= 1.,
                f"{what} is {value}, not {text}")
    else:
        require_same(text, value, what)


def require_error(text, title, name, value, files):
    """The error that a text has is that of the coarser run; a value of zero has
    that run's value."""
    other = files.coarser.get(name)
    if name in TENSIONS and value == 0. and _may_cavitate(files):
        require("unknown" in text, f"{title}: {text}")
        return
    if value == 0. and other is not None and name not in files.cut_alone:
        if other != 0.:
            require_chance(text.removeprefix("up to "), other, title)
        return require(other or text.endswith("in the coarser run, too"),
                       f"{title}: {text}")
    error, bounds = _error(name, value, files), _bounds(title, name, value,
                                                       files)
    if error is None:
        require("unknown" in text, f"{title}: {text}")
    elif text.startswith("by the numerics "):
        require_same(text.removeprefix("by the numerics "),
                     value * (1. - error) * files.least_part_of_load(name),
                     "least " + title)
    elif bounds and not text.startswith("±"):
        found = re.fullmatch(r"(\S+) to (\S+) %", text)
        if not found:
            for bound in bounds:
                require_chance(text, bound, title)
            return
        for shown, bound in zip(found.groups(), bounds):
            if shown not in ("0", "100"):
                require_same(shown + " %", bound, "bound of " + title)
            else:
                require(abs(bound - float(shown) / 100.) <= 0.005,
                        f"{title}: bound {bound}, not {shown}")
    elif text == "± more than 100 %":
        require(error > 1., f"{title}: error {error}")
    else:
        text, _, least = text.partition(", least ")
        require_same(text, error, "error of " + title)
        part = files.least_part_of_load(name)
        require(bool(least) == (part != 1.), f"{title}: {text}, {least}")
        if least:
            require_same(least, part * value * (1. - error), "least " + title)


def _may_cavitate(files):
    """Whether the error of the minimum pressure alone reaches -100 kPa."""
    lowest = files.injury[PRESSURES[1]]
    error = _error(PRESSURES[1], lowest, files)
    return error is not None and lowest > -1e5 > lowest * (1. + error)


def _bounds(title, name, value, files):
    """Ends of the error of a value between 0 and 1, by the curve of a
    probability; None for anything else."""
    error = _error(name, value, files)
    if error is None:
        return None
    if name.endswith("ear"):
        return _ends_of_chance("eardrum_rupture", files.peak(name), error)
    if name == "lung_lethality":
        of, load = files.load_of_lungs()
        return _ends_of_chance(name, load, error, files.least_part_of_load(of))
    if title.startswith("fraction "):
        return [min(max(value * (1. + sign * error), 0.), 1.)
                for sign in (-1., 1.)]
    return None


def _ends_of_chance(name, load, error, least_part=1.):
    """Ends of a probability by the ends of its load."""
    normal = statistics.NormalDist()
    logs = [math.log(factor * load) for factor in (
        least_part * max(1. - error, 1e-300), 1. + error)]
    return [normal.cdf(1.524 * one - 17.6 if name == "eardrum_rupture" else
                       one / 0.1788) for one in logs]


def _error(name, value, files):
    """Error by the coarser run: sizes differ by 2 and 5/3, errors are of order
    0.7 and at least 2 %; what depends on the chest's peak differs by at least
    as much as its error, what happens in the body by that of its impulse, a
    probability by the error of what it follows from."""
    if name not in files.coarser or value == 0. or name in files.cut_alone:
        return None
    if name.endswith("ear"):
        return _gauge_errors(files, "peak").get(name)
    if name == "lung_lethality":
        return _error(*files.load_of_lungs(), files)
    is_of_body = name in files.injury
    times = 1. / ((5. / 3. if is_of_body else 2.) ** 0.7 - 1.)
    error = max(0.02, times * abs(files.coarser[name] / value - 1.))
    if name.startswith(("chest_", "lung_")) and name not in OF_AIR:
        error = max(error, _gauge_errors(files, "peak").get(files.side, 0.))
    if is_of_body:
        error = max(error, _load_difference(files))
    if name in OF_AIR:
        error = max(error, files.error_of_result("peak_overpressure") or 0.)
    for group in (PRESSURES, TENSIONS):
        if name in group:
            error = max(0.02, _load_difference(files), *(
                times * abs(files.coarser[other] / files.injury[other] - 1.)
                for other in group
                if other in files.coarser and files.injury[other]))
    return error


def _load_difference(files):
    """Deviation of the impulse on the elements along the recorded one."""
    checks = values_of(files.summary["biomechanics"], "checks")
    recorded, mapped = ([checks.get(f"loads_{name}_impulse_{axis}", 0.)
                         for axis in "xyz"] for name in ("recorded", "mapped"))
    size = sum(value * value for value in recorded)
    return 0. if size == 0. else abs(
        sum(a * b for a, b in zip(recorded, mapped)) / size - 1.)


def check_differences(page, files):
    """Both runs and the errors that follow."""
    expected = expected_injuries(files)
    rows = page.table(
        "Accuracy", "This scene with larger cells and elements").records()
    for row in rows:
        value, name = expected[row["measure"]]
        require_chance(row["this run"], value, row["measure"])
        require_chance(row["coarser run"], files.coarser[name],
                       row["measure"])
        require_error(row["estimated error"], row["measure"], name, value,
                      files)
    return 3 * len(rows)


def check_headline(page, files):
    """Every number of the answer and of what could change it is known, and none
    is left over."""
    text = re.sub(re.escape(files.scene["explosive_title"]), "", page.answer,
                  flags=re.I)
    text = re.sub(r"(combustion|values) of .*? \(Like\)", r"\1", text)
    number, rows = report_reader.NUMBER, expected_injuries(files)
    wanted = [
        (rf"({number} \w*) of  ?(?=,|detonates)", files.scene["charge_mass"]),
        (rf"detonates ({number} m) (?:in front|to|behind|from|beyond)",
         files.scene["distance"]),
        (rf", ({number} m) above the ground", files.scene["height"])]
    wanted += [(rf" ({number} {unit})(?: and|,|\.| high)", value) for unit, value
               in files.person().items()]
    chances = [value[0] for value in rows.values()
               if value[1].endswith("ear") or value[1] == "lung_lethality"]
    text = _without_tables(text, files)
    for warning in files.warnings:
        text = text.replace(warning, "…")
    text, count = _without_chances(text, chances, rows, files)
    text = _without_verdicts(page, text)
    text = re.sub(r"\b(?:HIC15|CSDM15|CSDM25)\b|in \d+ % of cases|AIS [234]|"
                  "AEP-55|over the 50 % lethality load|strain that 95 % of", "…",
                  text)
    wanted += _free_air(files) + _afterburn(files) + _loads(files)
    wanted += _energy(files) + _model_bias(files) + _wave_of_lungs(files)
    wanted += _jet(files)
    if "of the median lethal one" in text:
        loads = [(name == "lung_exposure_air", value) for value, name
                 in rows.values() if name.startswith("lung_exposure")]
        wanted.append((rf"({number}) of the median lethal one", max(loads)[1]))
    for row in files.scene["audit"]:
        found = row["found"] if row["found"] != "unknown" else \
            f"estimated at {row['estimate']}" + (
                "" if "not measured" in row["quantity"] else ", not measured")
        told = f" ({found}; limit: {row['limit']})"
        require((told in text) == (row["holds"] is False),
                f"the answer on {row}: {text}")
        text = text.replace(told, "")
    cut = re.search("The run ends too early, after .*?: (.*?) (?:are lower "
                    "limits|is a lower limit)", text)
    if cut:
        wanted.append((rf"The run ends too early, after ({number} ms)",
                       files.scene["end_time"]))
        text = text.replace(cut[1], "…")
    require(cut or not files.has_lower_limits(), f"no lower limits: {text}")
    for pattern, value in wanted:
        match = re.search(pattern, text, re.M)
        require(match, f"the answer does not say /{pattern}/: {text}")
        require_same(match[1], value, f"the answer, /{pattern}/")
        text = text[:match.start(1)] + "…" + text[match.end(1):]
    text = text.replace("50 % lethality load", "…")
    require(not re.search(r"\d", text), f"numbers of unknown source: {text}")
    return len(wanted) + count


# Loads by which probabilities follow.
LOADS_OF_CHANCES = {"lung_lethality": "lung_exposure",
                    "eardrum_rupture": "peak_overpressure"}
# Columns of gauge_measures.csv by names of table_comparison.
ON_SKIN = {"reflected_overpressure": "peak", "reflected_impulse": "impulse",
           "arrival": "arrival"}


def check_tables(page, files):
    """This run against the tables, as scene.json has it and the blast found
    it: the same value in all."""
    told = files.compared()
    if not told:
        return 0
    results = values_of(files.summary["blast"], "results")
    rows = page.table("").rows
    ears = [row for row in rows if "nearer ear" in row[0]]
    _check_ears(ears, files)
    rows = [row for row in rows if row not in ears]
    if files.trunk_is_far and told[0]["place"] == "probe 1":
        _check_trunk([row for row in rows if row[0].endswith(AT_TRUNK)], files)
        rows = [row for row in rows if not row[0].endswith(AT_TRUNK)]
    if told[0]["place"] == "probe 1":
        require(len(rows) == len(told), f"{rows} of {told}")
    for cells, row in zip(rows[-len(told):], told, strict=True):
        name, place = row["name"], row["place"]
        known = results.get("probe_1_" + name, files.air.get(
            (name, "probe 1"), row["run"])) if place == "probe 1" else \
            files.places[place][ON_SKIN[name]]
        require(abs(known / row["run"] - 1.) < 1e-9, f"{row}, {known}")
        for cell, key in zip(cells[1:], ("run", "tables")):
            if name in LOADS_OF_CHANCES:
                _check_ends(cell, name, key, files)
                cell = cell.partition(" (")[0]
            require_chance(cell.removeprefix("≥ "), row[key], name)
            error = row[key + "_error"]
            shown, _, least = cell.partition("±")[2].partition(", least ")
            known = key == "run" and files.least_at_probe and {
                "duration": files.least_at_probe[1], "lung_exposure":
                files.least_part_of_load("lung_exposure_air") * row["run"]
                * (1. - (error or 0.))}.get(name)
            require(bool(least) == bool(known), f"least of {cells}")
            if least:
                require_same(least, known, f"least {name}")
            if shown and "more than" not in shown:
                require_same(shown, error, f"error of {name}")
    return 4 * len(rows)


def _check_ends(cell, name, key, files):
    """Ends of a probability of the "run" or the "tables"."""
    known = {row["name"]: row for row in files.compared()}
    load = known.get(LOADS_OF_CHANCES[name], {})
    size, error, least = load.get(key), load.get(key + "_error"), 1.
    if key == "run" and name == "eardrum_rupture":
        results = values_of(files.summary["blast"], "results")
        size = results["probe_1_peak_overpressure"]
        error = files.error_of_result("peak_overpressure")
    elif key == "run":
        of, size = files.load_of_lungs()
        error, least = _error(of, size, files), files.least_part_of_load(of)
    told = re.search(r"\((\S+) to (\S+) %", cell)
    require(told or error is None or cell.startswith(("less", "more"))
            or cell.removesuffix(" %") in ("0", "100"),
            f"{name} without bounds: {cell}")
    require(not told or None not in (size, error), f"{name}: bounds of {cell}")
    for shown, end in zip(*(told.groups(), _ends_of_chance(
            name, size, error, least)) if told else ()):
        require(abs(float(shown) / 100. - end) <= 0.0051, f"{cell}: {end}")


def _check_ears(rows, files):
    """The likelier rupture by the load on the skin, and by the tables at the
    distance of the nearer ear, which is farther than the nearest skin."""
    tables = files.scene["tables"].get("ears") or {}
    run = max((value for (name, place), value in files.skin.items()
               if name == "eardrum_rupture" and place.endswith("ear")),
              default=None)
    is_told = run is not None and tables.get(
        "distance", 0.) > 1.05 * files.scene["distance"]
    require(len(rows) == is_told, f"{rows}: {tables}")
    for _, shown, known in rows:
        require_chance(shown, run, "run at the nearer ear")
        for cell, place in zip(known.removesuffix(" before a wall)").split(" ("),
                               ("in_the_open", "before_a_wall")):
            require_chance(cell, tables[place]["eardrum_rupture"],
                           f"{place} at the nearer ear")


def _check_trunk(rows, files):
    """Lungs by the load on the skin of the trunk, and by the tables in the open
    and before a wall."""
    tables, load = files.scene["tables"]["trunk"], files.load_of_lungs()[1]
    for (_, run, known), name, value in zip(rows, (
            "lung_exposure", "lung_lethality"), (
                load, files.skin["lung_lethality", "probe 1"]), strict=True):
        require_chance(run.partition(" ±")[0], value, f"{name} at the trunk")
        for shown, place in zip(
                known.removesuffix(" before a wall)").split(" ("),
                ("in_the_open", "before_a_wall"), strict=True):
            require_chance(shown, tables[place][name], f"{name} at the trunk")


def _without_tables(text, files):
    """The answer without what it tells of the tables' probabilities, which are
    those of scene.json."""
    tables = files.scene.get("tables", {})
    answer = tables.get("answer")
    ears = tables.get("ears") or answer
    told = re.search(r"[,;] by the tables(?:, at the nearer ear's ([\d.]+ m),)? "
                     r"((?:less than |more than )?[\d.]+ %)"
                     r"(?: in the open, (.*? %) before a wall)?(?=\))", text)
    if told:
        if tables.get("ears"):
            require_same(told[1], ears["distance"], "distance of the ear")
        for shown, place in zip(told.groups()[1:], ("in_the_open",
                                                    "before_a_wall")):
            require_chance(shown or told[2], ears[place]["eardrum_rupture"],
                           "eardrums by the tables")
        text = text.replace(told[0], "")
    told = re.search(r"; death by lung injury by the tables(?: at the trunk's "
                     r"[\d.]+ m)?: ([^()]*?%)(?=\))", text)
    if told:
        require_chance(told[1], answer["in_the_open"]["lung_lethality"],
                       "death by the tables")
        text = text.replace(told[0], "")
    for row in files.scene.get("table_comparison", []):
        for match in re.findall(r"eardrum in the open is (.*?), where this "
                                r"run has (.*?)(?=\.\n)", text) * (row["name"]
                                               == "eardrum_rupture"):
            require_chance(match[0], row["tables"], row["name"])
            require_chance(match[1], row["run"], row["name"])
    possible = re.search(r"by the tables(?: at the trunk's [\d.]+ m)? lung "
                         r"injury possible, load ([\d.]+)"
                         "(?: (in the open|before a wall))?", text)
    if possible:
        at_trunk = tables.get("trunk") or {}
        [load] = [row["tables"] for row in files.scene["table_comparison"]
                  if row["name"] == "lung_exposure" and not possible[2]] or [
                      at_trunk[(possible[2] or "in the open").replace(" ", "_")][
                          "lung_exposure"]]
        require_same(possible[1], load, "load of the lungs by the tables")
        text = text.replace(possible[0], "…")
    text = re.sub(r"(?<=By the tables, ).*?(?=\.\n)", "…", text)
    return re.sub(r"(?<=by this run, )[^)]*(?= by the tables)|"
                  r"(?<=death with a probability of ).*?(?=, where)|"
                  r"(?<=where this run has ).*?(?=\. Trust)", "…", text)


def _without_chances(text, chances, rows, files):
    """The answer without its probabilities and their bounds, which are those of
    the table."""
    count = 0
    shown = re.compile(r"((?:less than |more than )?[\d.]+ %)(?: by this run)?"
                       r"(?:, by the numerics ([^);,]*%))?(?=[);, ])"
                       "(?! lethality load)")
    sentence, _, rest = text.partition("\n")
    for match in shown.finditer(sentence):
        fits = False
        for title, (value, name) in rows.items():
            if value not in chances:
                continue
            try:
                require_chance(match[1], value, title)
                if match[2]:
                    require_error(match[2], title, name, value, files)
                fits = True
            except AssertionError:
                continue
        require(fits, f"«{match[0]}» is no probability of {rows}")
        count += 1
    return shown.sub("…", sentence) + "\n" + rest, count


def _short(title):
    """An abbreviation in brackets at the end, or what is before brackets."""
    abbreviation = re.search(r"\(([A-Z]\w+)\)$", title)
    return abbreviation[1] if abbreviation else title.split(" (")[0]


def _without_verdicts(page, text):
    """The answer without its sentence on how many verdicts stand, counted in
    the table, and which do not."""
    rows = [row for table in page.tables if table.section == "Injury"
            for row in table.records()]
    sure = sum("does not change this" in row["verdict"] for row in rows)
    unsure = [_short(row["measure"]) for row in rows
              if "lies within the error" in row["verdict"]]
    if not sure and not unsure:
        return text
    unknown = [_short(row["measure"]) for row in rows
               if "unknown" in row["value and its estimated error"]
               and row["verdict"] not in ("exposure, no verdict", "no threshold")]
    count = WORDS[len(unsure)] if unsure else "none"
    told = f"could change {count} of " \
        f"{WORDS[sure + len(unsure) + len(unknown)]} verdicts"
    match = re.search(told + r"(?:: (.*?))?(?:; it is unknown of (.*?): .*)?\.\n",
                      text)
    require(match, f"the answer lacks «{told}»: {text}")
    for words, wanted in zip(match.groups(), (unsure, unknown)):
        named = re.split(", | and ", words) if words else []
        require(sorted(named) == sorted(wanted), f"{named} instead of {wanted}")
    return text.replace(match[0], "")


def _free_air(files):
    """Differences to the tables that exceed the errors."""
    words = {"peak_overpressure": "the peak overpressure",
             "reflected_overpressure": "the reflected peak overpressure",
             "lung_exposure": "the free-field load …",
             "impulse": "the impulse", "duration": "the duration",
             "arrival": "the arrival"}
    return [(rf"{words[row['name']]} is ({report_reader.NUMBER} %) "
             + ("below" if row["run"] < row["tables"] else "above"),
             abs(row["run"] / row["tables"] - 1.))
            for row in files.compared() if row["differs"] and row["name"] in words]


def _wave_of_lungs(files):
    """What the wave by which lungs are judged is not, and what no gauge faces."""
    number, air = report_reader.NUMBER, files.air
    wanted, probe = [], "probe 1"
    if ("lung_exposure", probe) in files.skin:
        fraction = air.get(("first_phase_fraction", probe), 1.)
        if fraction <= 0.75:
            wanted.append((rf"first wave has ({number} %) of the", fraction))
        if ("lung_load_duration", probe) in air:
            wanted += [(rf"is judged over ({number} ms)",
                        air["lung_load_duration", probe]),
                       (rf"first phase of ({number} ms) it is",
                        values_of(files.summary["blast"],
                                  "results")["probe_1_duration"]),
                       (rf" instead of ({number})\.",
                        files.skin["lung_exposure", probe])]
    azimuth = files.scene.get("person", {}).get("charge_azimuth")
    if azimuth is not None and ("chest_wall_velocity", "trunk") in files.skin:
        off = abs((azimuth + 45.) % 90. - 45.)
        if off >= 25.:
            wanted.append((rf"The charge is ({number})° off the nearest", off))
    return wanted


def _jet(files):
    """Of a charge on the ground, where it is ahead of the tables at the body."""
    expected = (files.scene["tables"]["answer"] or {}).get("arrival")
    path = os.path.join(files.output, "blast", "loads.h5")
    if files.scene["tables"]["burst"] != "hemispherical" or expected is None \
            or not os.path.exists(path):
        return []
    with h5py.File(path, "r") as file:
        arrival = file["arrival"][:]
        first = int(np.nanargmin(np.where(arrival > 0., arrival, np.inf)))
        height = float(file["centroid"][first][2])
    number = report_reader.NUMBER
    return [] if arrival[first] > 0.85 * expected else [
        (rf"skin first after ({number} ms)", float(arrival[first])),
        (rf"…, ({number} m) above the ground, where the tables", height),
        (rf"tables have ({number} ms) for the nearest", expected)]


def _model_bias(files):
    """Known differences from the tables, without sign."""
    rows = {row["item"]: row for row in files.scene.get("plan", [])}
    values = [(name, float(rows[f"model_bias_{name}"]["estimate"]))
              for name in ("peak", "impulse", "duration")
              if rows.get(f"model_bias_{name}", {}).get(
                  "estimate", "unknown") != "unknown"]
    return [(rf"gives this .*?an? {name} ({report_reader.NUMBER} %) "
             + ("below" if value < 0. else "above"), abs(value))
            for name, value in values]


def _afterburn(files):
    """Energy of afterburn and its largest effects."""
    rows = {row["item"]: row for row in files.scene["audit"]}
    if "afterburn" not in rows:
        return []
    if all(rows[f"afterburn_{name}"]["estimate"] == "0"
           for name in ("peak", "impulse")):
        return []
    number, decision = report_reader.NUMBER, rows["afterburn"]["decision"]
    energies = re.findall(r"[\d.]+", decision.split(" MJ/kg")[0])
    wanted = [(rf"({number}) MJ/kg of afterburn", float(energies[0])),
              (rf"\(at most ({number}) MJ/kg is", float(energies[1]))] \
        if len(energies) == 2 else []
    for name in ("peak", "impulse"):
        rise = rows[f"afterburn_{name}"]["estimate"]
        if rise != "unknown":
            wanted.append((rf"the incident {name} by at most ({number} %)",
                           float(rise)))
    return wanted


def _loads(files):
    """Impulse on the elements that is not the recorded one."""
    known = values_of(files.summary["biomechanics"], "checks")
    part = known["loads_largest_mapped_impulse"] \
        / known["loads_largest_recorded_impulse"]
    return [(rf"The elements get ({report_reader.NUMBER} %) of", part)] \
        if abs(part - 1.) > 0.02 else []


def _energy(files):
    """Missing energy and hourglass energy of a tissue above their limits."""
    known = values_of(files.summary["biomechanics"], "checks")
    most = files.limit("biomechanics", "Largest hourglass part", 0.1)
    number, wanted = report_reader.NUMBER, []
    missing = abs(known.get("energy_residual", 0.))
    if missing > 0.01:
        wanted += [(rf"({number} %) of the body's energy is missing", missing),
                   (rf"energy is missing \(limit ({number} %)\)", 0.01)]
    tissues = {name: part for name, part in known.items() if part
               and name.startswith("hourglass_part_")}
    part = max([known.get("hourglass_part", 0.), *tissues.values()])
    if part > most:
        words = "of the largest internal energy of a tissue"
        wanted += [(rf"({number} %) {words}", part),
                   (rf"hourglass modes \(limit ({number} %)\)", most)]
        wanted += [(rf"({number} %) in " + name[len("hourglass_part_"):]
                    .replace("_", " "), part)
                   for name, part in tissues.items() if part > most]
    return wanted


def _with_unit(header, cell):
    """A number below "peak [kPa]" with its unit."""
    unit = re.search(r"\[(.*)\]", header)
    return f"{cell} {unit[1]}" if unit else cell


def check_gauges(page, files):
    """Peak, lowest value, arrival, impulse and duration of each place."""
    if not files.gauges:
        return 0
    count = 0
    rows = page.table("Histories on the skin", column="peak [kPa]").records()
    require([row["place"] for row in rows]
            == [name for name in files.places if files.peak(name) > 0.],
            "places on the skin are others")
    for row in rows:
        measures = files.places[row["place"]]
        lowest = min(value for time, value in zip(
            files.gauges["time"], files.gauges[row["place"]])
            if time >= measures["arrival"])
        known = {"peak [kPa]": measures["peak"],
                 "arrival [ms]": measures["arrival"],
                 "impulse [Pa s]": measures["impulse"],
                 "positive phase [ms]": measures["positive phase"]}
        if lowest < -1.:
            known["minimum [kPa]"] = lowest
        for header, value in known.items():
            require_same(_with_unit(header, row[header]), value,
                         f"{row['place']}, {header}")
        count += len(known)
    rows = page.table("Histories on the skin",
                      column="error of peak").records()
    return count + _check_gauge_errors(rows, files)


def _gauge_errors(files, name):
    """Errors by place, of order 0.7; at least their median and 2 %."""
    factor = 1. / (2. ** 0.7 - 1.)
    coarser = {place: measures[name] for place, measures
               in files.coarser_places.items() if not math.isnan(measures[name])
               and (name == "peak" or files.has_same_phase(place))}
    errors = {place: factor * abs(coarser[place] / measures[name] - 1.)
              for place, measures in files.places.items()
              if measures[name] > 0. and place in coarser}
    least = max(0.02, statistics.median(errors.values())) if errors else 0.
    return {place: max(error, least) for place, error in errors.items()}


def _check_gauge_errors(rows, files):
    count = 0
    for header, name in (("error of peak", "peak"),
                         ("error of impulse", "impulse"),
                         ("error of positive phase",
                          "positive phase")):
        errors = _gauge_errors(files, name)
        for row in rows:
            told, error = row[header], errors.get(row["place"])
            if error is None or error > 1.:
                require(told == ("unknown" if error is None
                                 else "± more than 100 %"), f"{row}")
            else:
                require_same(told.lstrip("± "), error, f"{row}")
            count += 1
    for row in rows:
        told, least = row["least positive phase"], files.least_phases.get(
            row["place"])
        require((told == "–") == (least is None), f"{row}, {least}")
        if least is not None:
            require_same(told, least, f"{row}")
            count += 1
    return count


def check_events(page, files):
    """Several sections of the report say the same of a place."""
    if not files.gauges:
        return 0
    events = page.table("Events over time").records()
    tissues = {row["place"]: row for row in page.table(
        "Histories in the tissue").records()}
    count = 0
    for row in events:
        place = row["event"].partition(":")[0]
        if place in files.places:
            told = re.fullmatch("peak (.*), impulse (.*)", row["values"])
            measures = files.places[place]
            for shown, name in zip((row["time"], *told.groups()),
                                   ("arrival", "peak", "impulse")):
                require_same(shown, measures[name], f"{place}, {name}")
        elif place in tissues:
            told = re.search("; (.*) to (.*) over the whole run",
                             row["values"])
            for shown, name in zip(told.groups(), ("minimum", "maximum")):
                value, half = report_reader.quantity(_with_unit(
                    "[kPa]", tissues[place][f"{name} pressure [kPa]"]
                    .partition("\n")[0]))  # its error is below
                other, more = report_reader.quantity(shown)
                require(abs(other - value) <= half + more,
                        f"{place}: {shown}, {tissues[place]}")
        else:
            continue
        count += 3
    return count


def check_summary_file(page, files):
    """report.json has the values of the files, the sentence and the
    reservations of the page, and the screen's lines are headline.txt."""
    found = read_json(files.output, "report.json")
    flaw = flaw_of(os.path.join(files.output, "report.json"))
    require(not flaw, f"report.json: {flaw}")
    expected = {title: value for title, (value, _)
                in expected_injuries(files).items()}
    told = {entry["title"]: entry["value"] for entry in found["measures"]}
    require(told == expected, f"report.json has {told}, the files {expected}")
    for entry in found["measures"] + found["verdicts"]:
        known = [entry[name] for name in ("least", "value", "largest")
                 if entry[name] is not None]
        require(known == sorted(known), f"bounds of {entry}")
        require(entry["largest"] is None or not entry.get("is_lower_limit")
                or entry["value"] < 0., f"upper bound of {entry}")
    for text in [found["headline"], found["scene"], *found["reservations"],
                 *(entry["text"] for entry in found["warnings"])]:
        require(text.replace("\u00a0", " ") in page.answer,
                f"the page does not say «{text}»")
    require(read_text(files.output, "headline.txt").splitlines()
            == found["text"], "headline.txt")
    require(files.warnings == {entry["text"] for entry in found["warnings"]},
            f"report.json has other warnings than {files.warnings}")
    return len(told) + len(found["warnings"])


def check_log(_, files):
    """Figures of the screen are those of the files: the body's energy, and what
    is missing of it."""
    path = os.path.join(files.output, "biomechanics", "log.txt")
    if not os.path.exists(path):
        return 0
    told = re.findall(r"energy: (\S+) J kinetic, (\S+) J internal, work of "
                      r"loads (\S+) J, missing (\S+) %", read_text(path))
    last = read_rows(files.output, "biomechanics", "history.csv")[-1]
    known = [float(last["kinetic_energy [J]"]), None,
             float(last["external_work [J]"]),
             100. * abs(values_of(files.summary["biomechanics"],
                                  "checks")["energy_residual"])]
    for shown, value in zip(told[-1], known):
        require(value is None or abs(float(shown) - value)
                <= 5e-3 * abs(value), f"the log has {told[-1]}, not {known}")
    return 3


def check_conservation(page, files):
    known, count = files.summary["blast"]["conservation"], 0
    table = page.table("Conservation of the gas", column="at the start")
    for row in table.records():
        name = row["total in the domain"].replace(" ", "_")
        for header, end in (("at the start", "_first"), ("at the end", "_last"),
                            ("change", "_relative_change")):
            require_same(row[header], known[name + end], name + end)
            count += 1
    require(count >= 6, "no gas is conserved")
    known = values_of(files.summary["blast"], "checks")
    rows = page.table("Conservation of the gas",
                      column="check of the loads").rows
    for row, key in zip(rows, (key for key in (
            "loads_impulse_difference", "loads_force_difference",
            "loads_sampled_peak_loss") if key in known), strict=True):
        require_same(row[1], known[key], key)
    return count + len(rows)


def check_audit(page, files):
    """Estimates and measurements of what was taken for granted."""
    known = files.summary["blast"]["assumptions"]
    section, count = "Assumptions", 0
    rows = page.table(section).records()
    for row, told in zip(rows, files.scene["audit"], strict=True):
        for header, key in (("estimate before", "estimate"),
                            ("found after", "found"), ("limit", "limit")):
            require(row[header] == ("–" if told[key] == "unknown"
                                    else told[key] or "–"), f"{row}, {told}")
            count += 1
        require(row["holds"] == {None: "not judged", True: "yes", False: "no"}[
            told["holds"] if told["limit"] else None], f"{row}, {told}")
    # Items that the table of the scene lacks have one of their own.
    told = {row["item"].replace(" ", "_") for row in rows}
    if not told.issuperset(known):
        rows += page.table(section,
                           "Further assumptions of the blast").records()
    by_name = {row["item"].replace(" ", "_"): row for row in rows}
    for name, entry in known.items():
        row = by_name[name]
        for shown, key in ((row.get("estimate", row.get("estimate before")),
                            "estimate"),
                           (row.get("measured", row.get("found after")),
                            "measured")):
            if shown == "–":
                require(entry.get(key) is None, f"{row}, {entry}")
            else:
                # The tables of a scene write 1e-05 instead of 1·10⁻⁵.
                require_same(_with_power(shown), entry[key], name)
                count += 1
    return count


def _with_power(text):
    return re.sub(r"(\d)e([+-]?)0*(\d+)", lambda match: match[1] + "·10"
                  + ("⁻" if match[2] == "-" else "")
                  + match[3].translate(report_reader.SUPERSCRIPTS), text)


def check_free_air(page, files):
    known = values_of(files.summary["blast"], "results")
    if "probe_1_reference_peak_overpressure" not in known:
        return 0
    table = page.table("Accuracy", "Against measurements in free air")
    for row in table.records():
        name = row["quantity"].replace(" ", "_")
        first = "first_" if name == "peak_overpressure" else ""
        found, reference = (known["probe_1_" + part + name]
                            for part in (first, "reference_"))
        is_limit = row["this run"].startswith("≥ ")
        require_same(row["this run"].removeprefix("≥ "), found, name)
        require_same(row["Kingery and Bulmash"], reference, name)
        require(is_limit == (row["difference"] == "–") == (
            name in ("impulse", "duration")
            and known.get("probe_1_cut_off", 0.) > 0.), f"{row}")
        if not is_limit:
            require_same(row["difference"], found / reference - 1., name)
    return 3 * len(table.rows)


def check_energy(page, files):
    """Energies at the end, and the sentence on their audit."""
    last = read_rows(files.output, "biomechanics", "history.csv")[-1]
    last = {name.split(" [")[0]: float(value)
            for name, value in last.items()}
    names = {"work of the loads": "external_work",
             "work of sliding interfaces": "interface_work",
             "gained as the step size varies": "step_change_energy",
             "kinetic energy": "kinetic_energy",
             "elastic energy": "stored_energy",
             "lost by relaxation": "relaxation_energy",
             "lost by bulk viscosity": "bulk_viscosity_energy",
             "hourglass energy": "hourglass_energy",
             "lost by hourglass damping": "hourglass_damping_energy",
             "in pressure smoothing": "pressure_smoothing_energy",
             "in the contact with the ground": "contact_energy",
             "missing energy": "energy_residual"}
    rows = page.table("Energy of the body").records()
    require(len(rows) >= 5, "energies are missing")
    balance = rounding = 0.
    for row in rows:
        name = row["energy at the end"]
        require_same(row["value"], last[names[name]], name)
        value, half = report_reader.quantity(row["value"])
        is_supply = name.startswith(("work ", "gained ", "missing "))
        balance += -value if is_supply else value
        rounding += half
        if name != "missing energy":
            require_same(row["fraction of the work of the loads"],
                         last[names[name]] / abs(last["external_work"]), name)
    require(abs(balance) <= rounding, f"{balance} J are in no row of {rows}")
    told = next(text for section, text in page.paragraphs
                if section == "Energy of the body" and "The audit" in text)
    known = values_of(files.summary["biomechanics"], "checks")
    parts = re.search(r": (.*?%) of the energy .*\), and (.*?%) of the", told)
    require_same(parts[1], abs(known["energy_residual"]), "energy missing")
    require_same(parts[2], max(
        value for name, value in known.items() if value is not None
        and re.match("hourglass_part(_|$)", name)), "hourglass energy")
    return 2 * len(rows) + 2


def check_mesh(page, files):
    known = {row["name"]: row for row in
             read_rows(files.output, "anatomy", "quality.csv")
             if row["kind"] == "tissue"}
    rows = page.table("The body's mesh").records()
    require([row["tissue"] for row in rows] == list(known),
            "the report has other tissues")
    for row in rows:
        quality = known[row["tissue"]]
        litre = quantity_in(row["volume [litre]"], 1e-3)
        for header, shown, column in (
                ("elements", row["elements"], "elements"),
                ("volume", litre, "volume [m^3]"),
                ("mass", row["mass [kg]"], "mass [kg]"),
                ("time step", row["largest time step [µs]"] + " µs",
                 "time step [s]"),
                ("pieces", row["pieces"], "connected components")):
            require_same(shown, float(quality[column]),
                         f"{row['tissue']}, {header}")
    return 5 * len(rows)


def quantity_in(cell, scale):
    """The cell of a column in other units, as a number with a power of ten."""
    require("·10" not in cell and scale == 1e-3, f"cannot scale {cell}")
    return cell + "·10⁻³"


def check_cost(page, files):
    """Status, time, memory and sizes of each stage."""
    rows = page.table("Cost").records()
    require([row["stage"] for row in rows] == list(STAGES + COARSER),
            "the cost of some stages is missing")
    for row, told in zip(rows, files.scene["stages"]):
        name = row["stage"]
        require(row["status"] == told["status"], f"{name} is {row['status']}")
        for header, key in (("wall time", "wall_seconds"),
                            ("core time", "core_seconds")):
            _require_duration(row[header], told[key], f"{header} of {name}")
        require_same(row["memory"], told["peak_memory"], f"memory of {name}")
        require_same(row["disk"], told["disk"], f"disk of {name}")
        path = os.path.join(files.output, name, "summary.json")
        summary = read_json(path) if os.path.exists(path) else {}
        most = summary.get("performance", {}).get("largest_cells")
        for count, word, at_most in re.findall(
                r"([\d\u202f]+) (\w+)( at most)?", row["size"]):
            known = most if at_most else summary[word]
            require(int(count.replace("\u202f", "")) == known,
                    f"{name} has {known} {word}{at_most}, not {count}")
    return 4 * len(rows)


def _require_duration(shown, seconds, what):
    match = re.fullmatch(r"(?:(\d+) h )?(\d+) min(?: (\d+) s)?", shown)
    if not match:
        return require_same(shown, seconds, what)
    hours, minutes, rest = (int(part or 0) for part in match.groups())
    found = 3600 * hours + 60 * minutes + rest
    require(found <= seconds + 0.5 < found + (60 if hours else 1),
            f"{what}: {shown} for {seconds} s")
    return None
