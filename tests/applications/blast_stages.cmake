# Blasts that begin in fewer dimensions: conservation by the hand-over, in the
# extremes, on two ranks, and when a run is stopped before or after it.
set(_closed "conservation.mass_relative_change < 1e-12"
  "conservation.energy_relative_change < 1e-12"
  "conservation.products_mass_relative_change < 1e-12")
set(_walls "Boundaries/x high=wall" "Boundaries/y high=wall"
  "Boundaries/z high=wall")

foreach(_file hand_over_cells_times_1000 hand_over_early hand_over_late)
  contrecoup_add_application_test(extreme_${_file} bounds
    FILE blast/extremes/${_file}.prm SET ${_walls}
    BOUNDS "status == finished" ${_closed} LABELS extremes)
endforeach()

# A quick version of the free-air blast: the mesh adapts while a first stage
# of 5 mm is handed over.
set(_free_air FILE blast/verification/hand_over.prm)
set(_quick "First stage/Cell size=0.005" "First stage/Radius=0.6"
  "Adaptation/Largest level=2" "Adaptation/Interval=2" "Output/Fields=false"
  "Output/History every steps=1")
foreach(_ranks 1 2)
  contrecoup_add_application_test(hand_over_conserves_on_${_ranks} bounds
    ${_free_air} MPI ${_ranks} SET ${_quick} ${_walls}
    "Charges/Afterburn/Kind=none" "Time/End time=0.0004"
    BOUNDS "status == finished" ${_closed}
    "checks.hand_over_radius > 0.59")
endforeach()
contrecoup_add_application_test(first_stage_alone bounds ${_free_air}
  SET ${_quick} "Time/End time=1e-5"
  BOUNDS "status == finished" MESSAGE "ends in its first stage")
contrecoup_add_application_test(stages_runs ranks,resume ${_free_air}
  SET ${_quick} "Time/Largest number of steps=230" CORES 1
  STOP_AFTER 40 210
  COMPARE history.csv probes.csv TOLERANCE 1e-9 "momentum*=1e-6 absolute"
  "probe_*_velocity*=1e-6 absolute")

# The run in 1-D that the one in 3-D is compared with: peak 862 kPa, 4.2 % below the 900
# of another method (tests/references/lagrangian_blast.py 0.001 0.0009 3.5e6 1.4 1).
contrecoup_add_application_test(hand_over_in_1d bounds
  FILE blast/verification/kingery_bulmash.prm
  SET "Output/Fields=false" "Domain/Coarse leaves=400" "Method/CFL number=0.8"
    "Time/End time=0.0006"
  BOUNDS "status == finished" "errors.probe_2_peak_overpressure_relative < 0.1"
    "results.probe_3_peak_overpressure > 861.8e3"
    "results.probe_3_peak_overpressure < 862.8e3"
    "results.probe_3_arrival > 5.405e-4"
    "results.probe_3_arrival < 5.412e-4" LABELS verification)

# Cells of 2.5 mm at the gauges, and of 40 mm in the region that does not affect them
# in time: the peak of that run in 1-D within 3 % along the edge (2.74 %) and within
# 1.5 % in the side's middle and along the diagonal (1.36 and 1.41 %): these and a
# tenth more or less; of the 900 kPa of the other method they lack 6.9, 5.5 and 5.6 %.
# Then the differences from Kingery and Bulmash's measurements.
set(_bounds "checks.hand_over_radius > 0.93")
foreach(_bound "1;836.4e3;840.7e3;5.408e-4;5.412e-4;9.9e-3;3.12e-2"
        "2;849.1e3;851.4e3;5.398e-4;5.402e-4;2.56e-2;3.33e-2"
        "3;848.7e3;851e3;5.398e-4;5.402e-4;2.5e-2;3.31e-2")
  list(POP_FRONT _bound _probe _lowest _highest _first _last _peak _arrival)
  list(APPEND _bounds
    "results.probe_${_probe}_peak_overpressure > ${_lowest}"
    "results.probe_${_probe}_peak_overpressure < ${_highest}"
    "results.probe_${_probe}_arrival > ${_first}"
    "results.probe_${_probe}_arrival < ${_last}"
    "errors.probe_${_probe}_peak_overpressure_relative < ${_peak}"
    "errors.probe_${_probe}_arrival_relative < ${_arrival}")
endforeach()
contrecoup_add_application_test(hand_over_peak bounds ${_free_air}
  SET "Output/Fields=false" "Adaptation/Largest level=5"
  "Adaptation/Limit far/Largest level=1" "Time/End time=0.00057"
  BOUNDS "status == finished" ${_bounds} LABELS verification)

set(_outside_5 "Adaptation/Limit farther/Shape=outside of ball"
  "Adaptation/Limit farther/Center=0, 0" "Adaptation/Limit farther/Radius=5"
  "Adaptation/Limit farther/Largest level=3")
# A line of gauges from 0.3 to 10 m, with and without a first stage that reaches to
# 2 m, in cells of 5 mm to there, of 10 mm to 5 m and of 20 mm beyond: peaks differ by
# 3.2 %, impulses and arrivals by 1.5 %. Nearer to the charge, of ten cells in radius,
# it is cells along a radius and across it that differ, by up to 11 %.
contrecoup_add_application_test(gauge_lines gauge_lines TIMEOUT 1200
  FILE blast/showcase/people.prm VARY "First stage/Kind=none|spherical"
  SET "Charges/Charge 1/Mass=1" "Boundaries/y low=symmetry"
    "Domain/Upper corner=10.24, 10.24" "Domain/Coarse leaves=8, 8"
    "Adaptation/Limit far/Radius=2.2" ${_outside_5}
    "Adaptation/Limit beyond/Largest level=5"
    "First stage/Cell size=0.005" "First stage/Hand over at=radius"
    "First stage/Radius=2" "Probes/Points=" "Probes/Gauge planes="
    "Probes/Lines=0.3, 0 : 10, 0 : 195" "Output/Pictures=false"
    "Output/Fields interval=1" "Time/End time=0.03"
  BOUNDS "peak < 0.05" "impulse < 0.05" "arrival < 0.05" "rise < 1e-9"
    "unknown == 0" LABELS nightly)

# The showcase in single precision, with cells of 37 mm at fronts: the cost of
# its mesh does not grow, and single precision conserves as it did, with half as
# much again for rounding: sums of rounded numbers scatter from one processor to
# another.
contrecoup_add_application_test(c4_above_ground bounds
  FILE blast/showcase/c4_above_ground.prm SET "Output/Fields=false"
  "First stage/Cell size=0.005" "Domain/Coarse leaves=5, 5, 7"
  "Adaptation/Largest level=1" "Adaptation/Limit fireball/Largest level=0"
  "Time/End time=0.0009" BOUNDS "status == finished"
  "performance.updates < 1.08e8"
  "conservation.mass_relative_change < 1.3e-6"
  "conservation.energy_relative_change < 1e-6"
  "results.probe_4_peak_overpressure > 3.51e6")
