# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Measures of injury: what each is called, its thresholds with their sources,
and what it does not say."""

AXELSSON = ("H. Axelsson, J. T. Yelverton, J. Trauma 40 (1996) S31–S37")
BOWEN = ("I. G. Bowen, E. R. Fletcher, D. R. Richmond, DASA-2113 (1968)")
RICHMOND = ("D. R. Richmond et al., Ann. Otol. Rhinol. Laryngol. 98 (1989) "
            "35–41")
WARD = "C. Ward, M. Chan, A. Nahum, SAE 801304 (1980)"
ZHANG = ("L. Zhang, K. H. Yang, A. I. King, J. Biomech. Eng. 126 (2004) "
         "226–236")
SIMON = "E. G. Takhounts et al., Stapp Car Crash J. 47 (2003), 52 (2008)"
GOELLER = "J. Goeller et al., J. Neurotrauma 29 (2012) 1970–1981"
BRIC = "E. G. Takhounts et al., Stapp Car Crash J. 57 (2013) 243–266"
OTHER_MODELS = ("thresholds were found with other models of the head, and "
                "models differ")
WALL_LIMITS = ("a mass on a spring before one lung, of a man of 70 kg, fitted "
               "to sheep; the bands of the source overlap and are meant for "
               "the mean over four sides of the trunk")
WALL_BANDS = [(3.6, "trace to slight"), (4.3, "slight"),
              (7.5, "slight to moderate"), (9.8, "moderate"),
              (12.8, "extensive; more than half die")]
# By the names of biomechanics: title, thresholds in increasing order of
# severity with what they mean, source, what the measure does not say. Of a
# measure that is worse when lower thresholds are negative.
KNOWN = {
    "injury_intracranial_pressure_peak": (
        "highest pressure in the brain",
        [(173e3, "minor injury"), (235e3, "serious injury")], WARD,
        "found for blunt impacts of milliseconds; the pressure of blasts that "
        "are survived exceeds it: an exposure, no verdict; averaged over "
        "neighbouring elements"),
    "injury_intracranial_pressure_lowest": (
        "lowest pressure in the brain", [(-100e3, "fluid may cavitate")],
        GOELLER, "the model does not cavitate, so that tension goes on where "
        "a real fluid would have broken; whether a brain does is disputed"),
    "injury_cavitating_fraction": (
        "part of the brain ever below −100 kPa",
        [(0.072, "dilatation damage")], SIMON,
        "made for impacts; says nothing of how long"),
    "injury_cavitation_dose": (
        "mean time below −100 kPa", [], "no threshold is published", ""),
    "injury_pressure_roughness": (
        "what alternates from element to element in the brain's pressure, "
        "over its averages",
        [(1., "only averages over neighbours mean anything")],
        "a check of this code on itself",
        "no injury: how much of the pressure of single elements is none"),
    "injury_strain_95": (
        "95th percentile of the largest principal strain of the brain",
        [(0.14, "a quarter have mild injury"),
         (0.19, "half have mild injury"), (0.24, "four fifths")], ZHANG,
        OTHER_MODELS),
    "injury_csdm_15": (
        "part of the brain strained by more than 0.15",
        [(0.55, "half have diffuse axonal injury")], SIMON, OTHER_MODELS),
    "injury_csdm_25": (
        "part of the brain strained by more than 0.25",
        [(0.54, "half have diffuse axonal injury")], SIMON, OTHER_MODELS),
    "injury_hic15": (
        "head injury criterion, 15 ms",
        [(250., "limit of NATO AEP-55"), (700., "limit of road traffic")],
        "FMVSS 208; NATO AEP-55",
        "of the mean motion of the brain; made for blunt impact, no limit is "
        "agreed on for blast"),
    "injury_bric": (
        "brain injury criterion", [(0.5, "mild injury possible"),
                                   (1., "half have injury of degree 4")],
        BRIC, "of the mean turning of the brain; made for blunt impact, said "
        "to predict too much; the head turns on after the end of the run"),
    "injury_chest_wall_velocity": (
        "chest wall velocity, facet nearest to the chest", WALL_BANDS,
        AXELSSON, WALL_LIMITS),
    "injury_chest_wall_velocity_mesh": (
        "velocity of the skin before the chest, in the mesh", [], "this mesh",
        "mean over 6 cm around the chest; thresholds are of the model of one "
        "mass, not of tissue; ribs are coarse"),
    "injury_lung_exposure": (
        "pressure on the chest over that which half survive",
        [(0.2, "lungs begin to be hurt"), (1., "half die")], BOWEN,
        "for a simple wave and a body before no wall; duration is that of "
        "the first positive phase on the chest"),
    "chest_wall_front": (
        "chest wall velocity, in front", WALL_BANDS, AXELSSON, WALL_LIMITS),
    "chest_wall_mean": (
        "chest wall velocity, mean of front and back", WALL_BANDS, AXELSSON,
        WALL_LIMITS + "; arms cover the sides, which are not in the mean"),
    "ear_rupture": (
        "probability that an eardrum ruptures",
        [(0.05, "possible"), (0.5, "likely"), (0.95, "nearly sure")],
        RICHMOND + "; probit −12.6 + 1.524 ln p",
        "open ear without protection; of the peak alone, while longer waves "
        "do more"),
}
KNOWN["lung_exposure"] = KNOWN["injury_lung_exposure"]


def title(name):
    """What a measure is called in words."""
    if name in KNOWN:
        return KNOWN[name][0]
    return name.replace("injury_", "").replace("_", " ")
