# Charges: the detonation against its exact solution, what the burn conserves,
# geometries, ranks, stops and extremes.
set(_folder blast/verification)
set(_closed "conservation.mass_relative_change < 1e-12"
  "conservation.energy_relative_change < 1e-12"
  "conservation.products_mass_relative_change < 1e-12")

# blast_burns(<name> <file> <bounds> [<overrides>...])
function(blast_burns name file bounds)
  contrecoup_add_application_test(${name} bounds FILE blast/${file}.prm
    SET "Output/Fields=false" ${ARGN} BOUNDS "status == finished" ${bounds}
    LABELS verification)
endfunction()

# The front is in time within 0.5 %, and after 0.28 m has the Chapman-Jouguet
# pressure within 3 % (plane; in a sphere, whose slope is infinite, it lacks more).
# Bounds: the errors when the tests were written and a tenth more.
set(_sphere "Domain/Geometry=spherical" "Charges/Charge 1/Shape=sphere"
  "Charges/Charge 1/Radius=0.304")
set(_detonation verification/tnt_detonation)
blast_burns(tnt_detonation ${_detonation} "errors.density_L1 < 3.25;\
errors.probe_4_arrival_relative < 2.2e-3;\
errors.probe_4_peak_overpressure_relative < 0.0131")
blast_burns(tnt_detonation_sphere ${_detonation} "errors.density_L1 < 5.4;\
errors.probe_4_arrival_relative < 2.2e-3;\
errors.probe_4_peak_overpressure_relative < 0.140" ${_sphere})
contrecoup_add_application_test(tnt_detonation_order convergence
  FILE blast/${_detonation}.prm SET "Output/Fields=false"
  VARY "Domain/Coarse leaves=38|76" ERROR errors.density_L1 ORDER 0.9
  LABELS verification)
contrecoup_add_application_test(tnt_detonation_sphere_order convergence
  FILE blast/${_detonation}.prm SET "Output/Fields=false" ${_sphere}
  VARY "Domain/Coarse leaves=38|76" ERROR errors.density_L1 ORDER 0.9
  LABELS verification)

# The slope behind a spherical front is infinite: order one half.
contrecoup_add_application_test(tnt_detonation_sphere_peak convergence
  FILE blast/${_detonation}.prm SET "Output/Fields=false" ${_sphere}
  VARY "Domain/Coarse leaves=38|76|152|304" ORDER 0.36
  ERROR errors.probe_4_peak_overpressure_relative LABELS verification)

# Against shells that move with the gas, in which products and air do not mix
# (tests/references/lagrangian_blast.py): most of the difference is the edge of the
# products, smeared over some cells. Peak and arrival at 0.25 m are 10.17 MPa and
# 0.0531 ms there. Bounds: what was found and a tenth more.
blast_burns(paper_1d verification/paper_1d "${_closed};\
errors.density_L1 < 0.375;errors.velocity_L1 < 33.5;errors.pressure_L1 < 1.207e5;\
results.probe_1_peak_overpressure > 9.04e6;\
results.probe_1_peak_overpressure < 10.17e6;\
results.probe_1_arrival > 5.31e-5;results.probe_1_arrival < 5.348e-5")
set(_no_table "Reference/Kind=none")
blast_burns(paper_1d_jwl verification/paper_1d
  "conservation.mass_relative_change < 1e-12;\
conservation.energy_relative_change < 1e-12" "Material/Equation of state=jwl"
  ${_no_table})

blast_burns(charge_cylindrical verification/paper_1d "${_closed}"
  "Domain/Geometry=cylindrical" "Charges/Charge 1/Shape=cylinder" ${_no_table})
blast_burns(charge_axisymmetric verification/charge_axisymmetric "${_closed}")

# A positive phase that the end of the run cuts off is marked, with a warning, and
# has no difference from the tables; that of the probe before is whole.
contrecoup_add_application_test(cut_off_phase bounds
  FILE blast/verification/kingery_bulmash.prm
  SET "Time/End time=2.5e-3" "Domain/Coarse leaves=100"
  BOUNDS "results.probe_4_cut_off == 1.0" "errors.probe_3_impulse_relative < 0.2"
    "errors.probe_4_arrival_relative < 0.02"
    "errors.probe_4_impulse_relative == None"
  MESSAGE "cut off in the positive phase: probe 4, ")

# Ignited at the rim, the detonation runs inwards and is far stronger in the
# middle.
blast_burns(extreme_implosion verification/paper_1d "${_closed}"
  "Charges/Charge 1/Ignition points=0.05" ${_no_table})

# The cone and the spherical run, whose errors test paper_1d bounds, differ by 0.34 %
# of the mean density. Peak and arrival at 0.25 m once more against 10.17 MPa and
# 0.0531 ms of the shells that move with the gas.
blast_burns(cone verification/cone "errors.density_L1 < 0.0106;${_closed};\
results.probe_1_peak_overpressure > 9.22e6;\
results.probe_1_peak_overpressure < 10.17e6;\
results.probe_1_arrival > 5.31e-5;results.probe_1_arrival < 5.334e-5")

# The model's bias by scenes (source/coupling/application/model_bias.cc) is that of runs,
# within 0.01.
blast_burns(bias_tnt verification/explosive_bias
  "errors.probe_3_peak_overpressure_relative < 0.056;\
errors.probe_3_impulse_relative > 0.068;errors.probe_3_impulse_relative < 0.088;\
errors.probe_4_impulse_relative > 0.115;errors.probe_4_impulse_relative < 0.135"
  "Domain/Upper corner=4.8" "Domain/Coarse leaves=300" "Time/End time=9e-3"
  "Probes/Points=1@SEMICOLON@ 1.5@SEMICOLON@ 2@SEMICOLON@ 3")
blast_burns(bias_composition_b verification/explosive_bias
  "errors.probe_3_peak_overpressure_relative < 0.075;\
errors.probe_3_impulse_relative > -0.167;errors.probe_3_impulse_relative < 0.167;\
errors.probe_4_impulse_relative > -0.122;errors.probe_4_impulse_relative < 0.122"
  "Domain/Upper corner=4.8" "Domain/Coarse leaves=300" "Time/End time=9e-3"
  "Probes/Points=1@SEMICOLON@ 1.5@SEMICOLON@ 2@SEMICOLON@ 3"
  "Material/Explosive=composition b" "Charges/Afterburn/Energy=1.9678e6"
  "Reference/Kingery Bulmash/TNT equivalence of pressure=1.1528"
  "Reference/Kingery Bulmash/TNT equivalence of impulse=1.1528")

# Kingery and Bulmash at 0.5, 1 and 2 m; at 1 and 2 m 15 % in peak and impulse and
# 5 % in arrival were asked for. Bounds: the differences when the test was written
# and a tenth more.
blast_burns(kingery_bulmash verification/kingery_bulmash
  "errors.probe_2_peak_overpressure_relative < 0.144;\
errors.probe_2_impulse_relative < 0.11;\
errors.probe_2_arrival_relative < 5.28e-3;\
errors.probe_3_peak_overpressure_relative < 0.0288;\
errors.probe_3_impulse_relative < 0.031;\
errors.probe_3_arrival_relative < 0.0325;\
errors.probe_4_peak_overpressure_relative < 0.0596;\
errors.probe_4_impulse_relative < 0.0924;\
errors.probe_4_arrival_relative < 3.4e-4")
# The same without afterburn, and with Dobratz' constants.
blast_burns(kingery_bulmash_no_afterburn verification/kingery_bulmash
  "errors.probe_2_peak_overpressure_relative < 0.245;\
errors.probe_2_impulse_relative < 0.0879;\
errors.probe_2_arrival_relative < 0.034;\
errors.probe_3_peak_overpressure_relative < 0.166;\
errors.probe_3_impulse_relative < 0.393;\
errors.probe_3_arrival_relative < 0.0372;\
errors.probe_4_peak_overpressure_relative < 0.235;\
errors.probe_4_impulse_relative < 0.29;\
errors.probe_4_arrival_relative < 0.0742"
  "Charges/Afterburn/Kind=none")
blast_burns(kingery_bulmash_dobratz verification/kingery_bulmash
  "errors.probe_2_peak_overpressure_relative < 0.0595;\
errors.probe_2_impulse_relative < 0.103;\
errors.probe_2_arrival_relative < 0.0266;\
errors.probe_3_peak_overpressure_relative < 0.1;\
errors.probe_3_impulse_relative < 0.00983;\
errors.probe_3_arrival_relative < 0.0683;\
errors.probe_4_peak_overpressure_relative < 0.0244;\
errors.probe_4_impulse_relative < 0.0517;\
errors.probe_4_arrival_relative < 0.0229"
  "Material/Explosive=tnt dobratz"
  "Charges/Afterburn/Energy=3e6")
blast_burns(kingery_bulmash_dobratz_no_afterburn verification/kingery_bulmash
  "errors.probe_2_peak_overpressure_relative < 0.143;\
errors.probe_2_impulse_relative < 0.0402;\
errors.probe_2_arrival_relative < 0.00627;\
errors.probe_3_peak_overpressure_relative < 0.0508;\
errors.probe_3_impulse_relative < 0.338;\
errors.probe_3_arrival_relative < 0.0204;\
errors.probe_4_peak_overpressure_relative < 0.161;\
errors.probe_4_impulse_relative < 0.235;\
errors.probe_4_arrival_relative < 0.0302"
  "Material/Explosive=tnt dobratz"
  "Charges/Afterburn/Kind=none")
# 5 lb of C-4 at 2.337 m, a prediction: nothing was fitted to it. The tables are
# entered by its TNT equivalence. The errors when the test was written, -5.5, 1.9
# and -3.7 %, and a tenth more.
set(_c4 "Material/Explosive=c-4" "Charges/Charge 1/Mass=2.26796"
  "Probes/Points=2.337" "Domain/Upper corner=4" "Domain/Coarse leaves=250"
  "Time/End time=6e-3" "Reference/Kingery Bulmash/Mass=2.26796")
blast_burns(c4_prediction verification/kingery_bulmash
  "errors.probe_1_peak_overpressure_relative < 0.0602;\
errors.probe_1_impulse_relative < 0.0210;\
errors.probe_1_arrival_relative < 0.0402"
  ${_c4})
blast_burns(c4_no_afterburn verification/kingery_bulmash
  "errors.probe_1_peak_overpressure_relative < 0.204;\
errors.probe_1_impulse_relative < 0.262;\
errors.probe_1_arrival_relative < 0.0201"
  ${_c4} "Charges/Afterburn/Kind=none")
contrecoup_add_application_test(resume_afterburn resume
  FILE blast/verification/kingery_bulmash.prm SET "Output/Fields=false"
  "Domain/Upper corner=0.8" "Domain/Coarse leaves=25"
  "Probes/Points=0.25" "Time/Largest number of steps=200"
  COMPARE history.csv probes.csv STOP_AFTER 130)
blast_burns(extreme_afterburn_past_fuel extremes/afterburn_past_fuel
  "conservation.mass_relative_change < 1e-12;\
conservation.energy_before_afterburn_relative_change < 1e-12;\
conservation.products_mass_relative_change < 1e-12")

foreach(_file charge_1_mg charge_1000_kg charge_cut stand_off_10_mm stand_off_50_m)
  blast_burns(extreme_${_file} extremes/${_file} "${_closed}")
endforeach()
# Their charges are burned after 13 and 40 microseconds; the detonation has then met
# the ground, and the blast of one charge the other, in cells of 6.7 mm.
blast_burns(extreme_charge_on_ground extremes/charge_on_ground "${_closed}"
  "Time/End time=3e-5")
blast_burns(extreme_two_charges extremes/two_charges "${_closed}"
  "Domain/Coarse leaves=6, 3, 3" "Time/End time=6e-5")

set(_on_ground FILE blast/extremes/charge_on_ground.prm)
set(_short "Time/Largest number of steps=24" "Output/History every steps=1"
  "Output/Fields=false")
contrecoup_add_application_test(charge_runs ranks,resume ${_on_ground}
  SET ${_short} COMPARE history.csv TOLERANCE 1e-9 "momentum*=1e-9 absolute"
  CORES 1 STOP_AFTER 11)
contrecoup_add_application_test(charge_conserves_on_2 bounds ${_on_ground}
  MPI 2 SET ${_short} BOUNDS ${_closed})
