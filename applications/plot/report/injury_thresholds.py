# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Measures of injury: their names, thresholds with sources, and limitations."""

AXELSSON = ("H. Axelsson, J. T. Yelverton, J. Trauma 40 (1996) S31–S37")
BOWEN = ("I. G. Bowen, E. R. Fletcher, D. R. Richmond, DASA-2113 (1968), as "
         "in LLNL-TR-468242 (2011)")
TNO = "TNO, CPR 16E (1992); probit −12.6 + 1.524 ln p"
SKIN_LOAD = ("the source takes the load in the free field; that on the skin is "
             "reflected, so that this is an upper limit; the duration is that "
             "of the first positive phase there")
WARD = "C. Ward, M. Chan, A. Nahum, SAE 801304 (1980)"
ZHANG = ("L. Zhang, K. H. Yang, A. I. King, J. Biomech. Eng. 126 (2004) "
         "226–236")
SIMON = "E. G. Takhounts et al., Stapp Car Crash J. 47 (2003), 52 (2008)"
GOELLER = "J. Goeller et al., J. Neurotrauma 29 (2012) 1970–1981"
BRIC = "E. G. Takhounts et al., Stapp Car Crash J. 57 (2013) 243–266"
OTHER_MODELS = ("thresholds were found with other head models, and models "
                "differ")
WALL_LIMITS = ("model of one mass on a spring before one lung, for a man of "
               "70 kg, fitted to sheep; the injury bands of the source overlap "
               "and apply to the mean over four sides of the trunk")
WALL_BANDS = [(3.6, "trace to slight"), (4.3, "slight"),
              (7.5, "slight to moderate"), (9.8, "moderate"),
              (12.8, "extensive; lethality above 50 %")]
# Measures of how strong the load is. Their thresholds, found for other loads,
# give no verdict on injury.
EXPOSURES = frozenset({"injury_intracranial_pressure_peak"})
# By the names of biomechanics: title, an abbreviation in brackets at its end;
# thresholds in increasing order of severity, with their meanings; source;
# limitations. Of a measure that is worse when lower thresholds are negative.
KNOWN = {
    "injury_intracranial_pressure_peak": (
        "maximum brain pressure",
        [(173e3, "minor injury"), (235e3, "serious injury")], WARD,
        "the thresholds were found for blunt impacts of several milliseconds, "
        "and survived blasts exceed them: an exposure, no verdict; pressures "
        "are averaged over neighbouring elements"),
    "injury_intracranial_pressure_lowest": (
        "minimum brain pressure", [(-100e3, "fluid may cavitate")],
        GOELLER, "the model has no cavitation, so that tension continues "
        "where fluid would have ruptured; whether a brain cavitates is "
        "disputed"),
    "injury_cavitating_fraction": (
        "fraction of the brain ever below −100 kPa",
        [(0.072, "dilatation damage")], SIMON,
        "made for blunt impact; the duration is ignored"),
    "injury_cavitation_dose": (
        "mean time of the brain below −100 kPa", [],
        "no threshold is published", ""),
    "injury_pressure_roughness": (
        "oscillation of the brain pressure between neighbouring elements over "
        "its averages",
        [(1., "only averages over neighbours have a meaning")],
        "numerical check",
        "no injury, but the numerical error of the pressure of single "
        "elements"),
    "injury_strain_95": (
        "brain strain (95th percentile of the largest principal strain)",
        [(0.14, "mild injury in 25 % of cases"),
         (0.19, "mild injury in 50 % of cases"),
         (0.24, "mild injury in 80 % of cases")], ZHANG,
        OTHER_MODELS),
    "injury_csdm_15": (
        "fraction of the brain strained above 0.15 (CSDM15)",
        [(0.55, "diffuse axonal injury in 50 % of cases")], SIMON,
        OTHER_MODELS),
    "injury_csdm_25": (
        "fraction of the brain strained above 0.25 (CSDM25)",
        [(0.54, "diffuse axonal injury in 50 % of cases")], SIMON,
        OTHER_MODELS),
    "injury_hic15": (
        "head injury criterion over 15 ms (HIC15)",
        [(250., "limit of NATO AEP-55"), (700., "limit of road traffic")],
        "FMVSS 208; NATO AEP-55",
        "computed from the mean motion of the brain; made for blunt impact; "
        "no limit is agreed on for blast"),
    "injury_bric": (
        "brain injury criterion (BrIC)",
        [(0.5, "mild injury possible"), (1., "AIS 4 injury in 50 % of cases")],
        BRIC, "computed from the mean rotation of the brain; made for blunt "
        "impact; said to predict too many injuries; the head rotates on after "
        "the end of the run"),
    "injury_chest_wall_velocity": (
        "chest wall velocity, facet nearest to the chest", WALL_BANDS,
        AXELSSON, WALL_LIMITS),
    "injury_chest_wall_velocity_mesh": (
        "chest skin velocity in the mesh", [], "this mesh",
        "mean over 6 cm around the chest; published thresholds apply to the "
        "one-mass model, not to tissue; the mesh of the ribs is coarse"),
    "injury_lung_exposure": (
        "chest load over the 50 % lethality load",
        [(0.2, "threshold of lung injury"), (1., "50 % lethality")], BOWEN,
        SKIN_LOAD),
    "lung_exposure_back": (
        "back load over the 50 % lethality load",
        [(0.2, "threshold of lung injury"), (1., "50 % lethality")], BOWEN,
        SKIN_LOAD),
    "lung_exposure_air": (
        "free-field load over the 50 % lethality load",
        [(0.2, "threshold of lung injury"), (1., "50 % lethality")], BOWEN,
        "side-on plus dynamic pressure of the wave beside the body, as far "
        "from the charge; for a simple wave and a person who stands far from "
        "walls"),
    "lung_lethality": (
        "probability of death by lung injury",
        [(0.01, "possible"), (0.5, "likely"), (0.99, "nearly certain")],
        BOWEN, "of the free-field load; for 24 h without treatment, a simple "
        "wave and a person who stands far from walls"),
    "chest_wall_front": (
        "front chest wall velocity", WALL_BANDS, AXELSSON, WALL_LIMITS),
    "chest_wall_back": (
        "back chest wall velocity", WALL_BANDS, AXELSSON, WALL_LIMITS),
    "chest_wall_mean": (
        "mean chest wall velocity (front and back)", WALL_BANDS, AXELSSON,
        WALL_LIMITS + "; here the mean of front and back, since the arms cover "
        "the sides"),
    "ear_rupture": (
        "rupture probability of an eardrum",
        [(0.05, "rupture possible"), (0.5, "rupture likely"),
         (0.95, "rupture nearly certain")],
        TNO,
        "open ear without protection; depends on the peak alone, although "
        "longer waves injure more"),
}
KNOWN["lung_exposure"] = KNOWN["injury_lung_exposure"]


def is_probability(name):
    """Whether the value of a measure is a probability."""
    return name.startswith("ear_") or name == "lung_lethality"


def title(name):
    """What a measure is called in words."""
    if name in KNOWN:
        return KNOWN[name][0]
    return name.replace("injury_", "").replace("_", " ")
