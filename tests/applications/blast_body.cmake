# Rigid bodies in the gas.
set(_cylinder blast/verification/body_cylinder.prm)

# A shock in a closed box runs over a sphere: mass and energy are conserved.
contrecoup_add_application_test(body_closed bounds FILE ${_cylinder}
  SET "Output/Fields=false" "Domain/Initial refinement=2"
    "Boundaries/x low=wall" "Boundaries/x high=wall" "Boundaries/y high=wall"
  BOUNDS "status == finished" "conservation.mass_relative_change < 1e-12"
    "conservation.energy_relative_change < 1e-12")

# The loads on the facets equal the gas's loss and the content of loads.h5; each
# of two ranks has half of the whole cylinder.
set(_loads "Domain/Initial refinement=2" "Output/Fields=false"
  "Loads/Record=true" "Loads/Interval=0.005")
contrecoup_add_application_test(body_loads facet_loads FILE ${_cylinder}
  SET ${_loads}
  BOUNDS "status == finished" "checks.loads_impulse_difference < 6.1e-4"
    "checks.loads_force_difference < 3.1e-3"
    "checks.loads_sampled_peak_loss < 2.64e-4" "file_difference < 2.2e-10")
contrecoup_add_application_test(body_loads_on_2 facet_loads FILE ${_cylinder}
  MPI 2 SET ${_loads} "Domain/Coarse leaves=3, 4"
    "Domain/Lower corner=-1.5, -2" "Boundaries/y low=open"
  BOUNDS "status == finished" "checks.loads_impulse_difference < 7.1e-4"
    "checks.loads_force_difference < 3.7e-3"
    "checks.loads_sampled_peak_loss < 3.7e-3" "file_difference < 1e-9")

# Half a cylinder has the loads of the whole one, and half of its gas.
contrecoup_add_application_test(body_whole whole_body FILE ${_cylinder}
  SET ${_loads} BOUNDS "difference < 1.22e-4" "across == 0.0" "part == 0.5"
    "whole > 0.499999" "whole < 0.500001")

# With smaller leaves at the front than behind, mass, energy and loads are right
# as well, and the stagnation point gets the load that such leaves everywhere
# give.
set(_finer_front "Rigid body/Finer region front/Levels=1"
  "Rigid body/Finer region front/Shape=box"
  "Rigid body/Finer region front/Lower corner=-2, -2"
  "Rigid body/Finer region front/Upper corner=-0.1, 2")
contrecoup_add_application_test(body_levels bounds FILE ${_cylinder}
  SET "Output/Fields=false" "Domain/Initial refinement=2" ${_finer_front}
    "Boundaries/x low=wall" "Boundaries/x high=wall" "Boundaries/y high=wall"
  BOUNDS "status == finished" "conservation.mass_relative_change < 1e-12"
    "conservation.energy_relative_change < 1e-12")
contrecoup_add_application_test(body_levels_loads bounds FILE ${_cylinder}
  SET "Output/Fields=false" "Domain/Initial refinement=2" "Loads/Record=true"
    "Loads/Interval=0.005" ${_finer_front}
  BOUNDS "status == finished" "checks.loads_impulse_difference < 2.9e-4"
    "checks.loads_force_difference < 2.21e-3"
    "results.probe_1_peak_overpressure > 4.011"
    "results.probe_1_peak_overpressure < 4.085")
contrecoup_add_application_test(body_levels_resume resume FILE ${_cylinder}
  SET "Domain/Initial refinement=1" "Time/End time=0.8" ${_finer_front}
    "Loads/Record=true"
  COMPARE history.csv probes.csv STOP_AFTER 20)

# Leaves at the body are smaller than those of fronts, so that the mesh adapts after
# more steps than fronts alone would need; a stop comes in between.
set(_adaptive "Domain/Initial refinement=1" "Rigid body/Levels=2"
  "Adaptation/Active=true" "Adaptation/Interval=0" "Adaptation/Sensor=blast"
  "Adaptation/Buffer side=ahead" "Adaptation/Largest level=2"
  "Time/End time=0.5")
contrecoup_add_application_test(body_adaptive ranks,resume FILE ${_cylinder}
  SET ${_adaptive} COMPARE history.csv probes.csv TOLERANCE 1e-10
  CORES 1 STOP_AFTER 100)

# Against two-shock theory, on a quarter of the cells a side.
contrecoup_add_application_test(body_wedge bounds
  FILE blast/verification/body_wedge.prm
  SET "Output/Fields=false" "Domain/Initial refinement=1"
  BOUNDS "results.probe_1_peak_overpressure > 12.783"
    "results.probe_1_peak_overpressure < 12.852" LABELS verification)

# A sphere in space with 8 cells in the radius: a third of the peak is missing,
# as stated in the file.
contrecoup_add_application_test(body_sphere bounds
  FILE blast/verification/body_sphere.prm
  SET "Output/Fields=false" "Domain/Initial refinement=1"
  BOUNDS "status == finished" "results.probe_1_peak_overpressure > 2.69"
    "results.probe_1_peak_overpressure < 2.73"
    "results.probe_2_peak_overpressure > 1.49"
    "results.probe_2_peak_overpressure < 1.51"
    "results.probe_3_peak_overpressure > 2.38"
    "results.probe_3_peak_overpressure < 2.43" LABELS verification)

# In smooth flow the pressure on an oblique wall is of second order; the mean is
# over less than a step.
contrecoup_add_application_test(body_smooth gauge_order
  FILE blast/verification/body_smooth.prm
  VARY "Domain/Initial refinement=1|2|3" ERROR "1 1e-4 0.071601"
  BOUNDS "order_1 > 2.06" "error_1 < 3.82e-3" LABELS verification)

# The pressure on the wall, as means over 0.04 s, converges at first order: in front
# of a cylinder and a sphere, with 64 to 256 and with 64 and 128 cells in the
# radius, next to and behind a cylinder, with 64 and 128, and next to a sphere, with
# 32 and 64. The peak in front stays an overshoot of less than 4 %.
contrecoup_add_application_test(body_cylinder_front gauge_order
  FILE blast/verification/body_cylinder_front.prm
  VARY "Domain/Initial refinement=2|3|4" ERROR "1 0.04 4.295"
  BOUNDS "order_1 > 1.02" "error_1 < 5.35e-3" "peak_1 > 4.4253" "peak_1 < 4.6"
  LABELS verification)
contrecoup_add_application_test(body_sphere_front gauge_order
  FILE blast/verification/body_sphere_front.prm
  VARY "Domain/Initial refinement=0|1" ERROR "1 0.04 4.184"
  BOUNDS "order_1 > 1.04" "error_1 < 0.023" LABELS verification)
# Behind a sphere, within 0.15 of the point where the shock is focused.
contrecoup_add_application_test(body_sphere_rear gauge_order
  FILE blast/verification/body_sphere.prm
  SET "Output/Fields=false" "Pictures/Planes=" "Loads/Record=true"
    "Loads/Largest loss of peaks=1" "Loads/Gauge radius=0.15"
  VARY "Domain/Initial refinement=1|2" ERROR "3 1e-4 2.327"
  BOUNDS "order_3 > 1.3" "error_3 < 0.0896" LABELS verification)
contrecoup_add_application_test(body_sphere_axisymmetric gauge_order
  FILE blast/verification/body_sphere_axisymmetric.prm
  VARY "Domain/Initial refinement=3|4" ERROR "2 0.04 1.578"
  BOUNDS "order_2 > 1.3" "error_2 < 0.0127" LABELS verification)
# No reflection from this smaller domain's sides reaches the body before the end,
# and only leaves at the body are as fine as 64 and 128 cells in the radius.
contrecoup_add_application_test(body_cylinder_wall gauge_order
  FILE blast/verification/body_cylinder.prm
  SET "Output/Fields=false" "Loads/Record=true" "Loads/Largest loss of peaks=1"
    "Time/End time=1.8" "Domain/Lower corner=-1.25, 0"
    "Domain/Upper corner=1.125, 1.25" "Domain/Coarse leaves=19, 10"
    "Rigid body/Levels=1"
  VARY "Domain/Initial refinement=0|1" ERROR "2 0.04 1.691|3 0.04 1.80"
  BOUNDS "order_2 > 2.9" "error_2 < 9.3e-4" "order_3 > 2" "error_3 < 6.06e-3"
  LABELS verification)

# In a steady wind the pressure on a cone is that of Taylor and Maccoll's
# equation (tests/references/taylor_maccoll.py 2 20).
contrecoup_add_application_test(body_cone gauge_order
  FILE blast/verification/body_cone.prm
  VARY "Domain/Initial refinement=0" ERROR "1 0.3 last 0.911527"
  BOUNDS "error_1 < 1.93e-3" LABELS verification)

# Angles on half of the cells a side: regular reflection, 19.79 degrees in
# two-shock theory; the triple point of a Mach reflection at a wedge of 30
# degrees, 8.50 in three-shock theory with a straight stem.
contrecoup_add_application_test(body_wedge_regular wedge
  FILE blast/verification/body_wedge.prm ANGLE 60
  SET "Output/Volume fields=false" "Domain/Initial refinement=2"
  BOUNDS "reflected > 19.58" "reflected < 20" LABELS verification)
contrecoup_add_application_test(body_wedge_mach wedge
  FILE blast/verification/body_wedge.prm ANGLE 30
  SET "Output/Volume fields=false" "Domain/Initial refinement=2"
    "Rigid body/Half space/Rotation=0, 0, -60" "Time/End time=0.45"
    "Probes/Points="
  BOUNDS "triple_point > 8.49" "triple_point < 8.673" LABELS verification)

contrecoup_add_application_test(body_gauges bounds FILE ${_cylinder}
  SET "Output/Fields=false" "Domain/Initial refinement=2" "Loads/Record=true"
    "Loads/Gauges=stagnation point: -0.5, 0" "Loads/Gauge radius=0.05"
  BOUNDS "results.loads_stagnation_point_peak > 3.84"
    "results.loads_stagnation_point_peak < 3.92"
    "results.loads_stagnation_point_arrival > 0.1955"
    "results.loads_stagnation_point_arrival < 0.1994")

# Samples begin when the shock, smeared by coarse cells, meets the cylinder, at
# 0.2 were it sharp: nothing is kept before but a first sample and one at rest,
# and impulses are exact. Loads, gauges and fields do not depend on ranks, and a
# run that is stopped before or after the arrival, ended by a signal or killed
# continues as if without interruption. In loads.h5 overpressures have single
# precision, with a last bit of 2^-23.
contrecoup_add_application_test(body_runs
  arrival,regression,ranks,resume,sigterm,parallel_resume,parallel_sigkill
  FILE ${_cylinder} SET "Domain/Initial refinement=1" "Time/End time=50"
    "Time/Largest number of steps=65" "Loads/Record=true"
    "Loads/Gauges=stagnation point: -0.5, 0"
    "Loads/Gauge radius=0.05" "Loads/Interval=0.005" "Pictures/Resolution=96"
  BOUNDS "first_sample > 0.0758" "first_sample < 0.101" "samples_at_rest < 3"
    "first_overpressure < 1e-3" "impulse_difference < 1e-9"
  COMPARE history.csv probes.csv load_gauges.csv gauge_measures.csv loads.h5
    fields/*.vti fields/*.vtp TOLERANCE 1e-10 "fields/*.vtp:*=2e-7"
    "loads.h5:overpressure=1.2e-7"
  STOP_AFTER 5 20 RANKS 2 7 3 CORES 1)

# The man before a blast, with cells of 80 mm near him until the front has passed him:
# the loads of these cells within 3 %. No reflection from the sides of this smaller
# domain reaches him. With a CFL number of 0.9 facets and gas agree a little less.
set(_human FILE blast/quickstart_human.prm SET "Rigid body/Levels=1"
  "Adaptation/Largest level=1" "Adaptation/Limit not at the body/Largest level=1"
  "Adaptation/Limit fireball/Largest level=0"
  "Adaptation/Limit far away/Largest level=0" "First stage/Cell size=0.04"
  "First stage/Levels=1" "First stage/Spherical cell size=0.004"
  "Domain/Lower corner=-0.64, 0, 0" "Domain/Upper corner=5.12, 2.56, 3.84"
  "Domain/Coarse leaves=9, 4, 6" "Output/Fields interval=0"
  "Time/End time=0.0032")
set(_human_loads
  "results.loads_chest_peak > 5.462e+05"
  "results.loads_chest_peak < 5.8e+05"
  "results.loads_forehead_peak > 5.365e+05"
  "results.loads_forehead_peak < 5.697e+05"
  "results.loads_left_temple_peak > 2.272e+05"
  "results.loads_left_temple_peak < 2.412e+05"
  "results.loads_chest_impulse > 329.4"
  "results.loads_chest_impulse < 349.8"
  "results.loads_forehead_impulse > 295.2"
  "results.loads_forehead_impulse < 313.4"
  "results.loads_left_temple_impulse > 127.2"
  "results.loads_left_temple_impulse < 135.1"
  "results.loads_occiput_arrival > 0.002067"
  "results.loads_occiput_arrival < 0.002195")
contrecoup_add_application_test(human bounds,pictures ${_human}
  "Method/CFL number=0.6"
  BOUNDS "status == finished" "checks.loads_impulse_difference < 2.74e-4"
    ${_human_loads}
  COMPARE body_pressure.png body_maps.png body_gauges.png
    plane_y_0_pressure.png)
contrecoup_add_application_test(human_long_steps bounds ${_human}
  BOUNDS "status == finished" "retries == 0"
    "checks.loads_impulse_difference < 4.83e-4" ${_human_loads} LABELS nightly)

contrecoup_add_refusal(refuses_gauges_outside ${_cylinder} "is outside of the domain"
  "Loads/Record=true" "Loads/Gauges=below: 0.1, -0.5")
contrecoup_add_refusal(refuses_body_in_one_dimension ${_sod}
  "Rigid body/Kind: bodies need" "Rigid body/Kind=half space")
contrecoup_add_refusal(refuses_body_with_profile blast/extremes/body_on_axis.prm
  "no rigid body have a profile" "Output/Profile file=profile.h5")
contrecoup_add_refusal(refuses_body_galerkin ${_cylinder}
  "Method/Scheme = finite volume" "Method/Scheme=discontinuous galerkin")
contrecoup_add_refusal(refuses_body_subcells ${_cylinder} "Method/Subcells of 4 or more"
  "Method/Subcells=2")
contrecoup_add_refusal(refuses_body_of_a_hair ${_cylinder}
  "Rigid body: no cell of the domain" "Body/Shape/Size=1e-6, 1"
  "Body/Shift=0.013, 0.017, 0" "Probes/Points=" "Loads/Gauges=")
contrecoup_add_refusal(refuses_body_everywhere ${_cylinder}
  "Rigid body: it fills the whole domain" "Body/Shape/Size=70, 1" "Probes/Points=")
contrecoup_add_refusal(refuses_loads_without_body ${_sod} "Loads/Record = true needs"
  "Loads/Record=true")
contrecoup_add_refusal(refuses_probe_in_body ${_cylinder} "is in the rigid body"
  "Probes/Points=0.1, 0.1")
contrecoup_add_refusal(refuses_body_odd_subcells ${_cylinder}
  "Levels above 0 need an even number" "Method/Subcells=5" "Rigid body/Levels=1")
contrecoup_add_refusal(refuses_body_region_in_one_direction ${_cylinder}
  "Rigid body/Finer region front: Lower corner and Upper corner need 2" ${_finer_front}
  "Rigid body/Finer region front/Lower corner=1")
