# The extremes: each run ends, and never with a NaN (which run_case.py looks for
# in all tables).
#
# blast_survives(<file> [<bounds>] [<overrides>...])
function(blast_survives file bounds)
  contrecoup_add_application_test(extreme_${file} bounds
    FILE blast/extremes/${file}.prm SET "Output/Fields=false" ${ARGN}
    BOUNDS "status == finished" ${bounds} LABELS extremes)
endfunction()

set(_closed "conservation.mass_relative_change < 1e-12"
  "conservation.energy_relative_change < 1e-12")

blast_survives(aspect_ratio_100 "errors.density_L1 < 5.9e-3")
blast_survives(cfl_beyond "errors.density_L1 < 0.15"
  MESSAGE "steps became unphysical and were halved")
blast_survives(cfl_tiny "errors.density_L1 < 2.4e-3;${_closed}")
blast_survives(contact_at_rest
  "errors.pressure_Linf < 1e-9;errors.velocity_Linf < 1e-11;${_closed}")
blast_survives(contact_at_speed "errors.density_L1 < 0.291")
blast_survives(jwl_above_reference "errors.density_L1 < 25.6;${_closed}")
blast_survives(jwl_below_reference "errors.density_L1 < 4.11e-6;${_closed}")
blast_survives(leblanc_100 "errors.density_L1 < 4.96e-3;${_closed}")
# Through the nozzle come 5 kg/m^3 * 371 m/s of mass and their kinetic energy for
# 2 ms, within 2 %: its edge is not one of cells.
blast_survives(mach_1000_jet "conservation.mass_relative_change > 0.727;\
conservation.mass_relative_change < 0.757;\
conservation.energy_relative_change > 40419;\
conservation.energy_relative_change < 42069")
blast_survives(mach_1000_piston "errors.density_L1 < 1.91e-2")
blast_survives(one_cell "${_closed}")
blast_survives(one_cell_periodic "errors.density_Linf < 1e-12;${_closed}")
blast_survives(ratio_1330_1e6 "errors.density_L1 < 2.1;${_closed}")
blast_survives(rest_100000_steps
  "errors.density_Linf < 1e-12;errors.velocity_Linf < 1e-12;${_closed}")
blast_survives(ten_levels "${_closed}")
blast_survives(vacuum "errors.density_L1 < 7.43e-3")
# One and a half cells along the radius of a charge in air of 1 Pa become void; steps of
# 7e-11 s would take hours.
contrecoup_add_application_test(void_cells bounds
  FILE blast/verification/kingery_bulmash.prm
  SET "Domain/Upper corner=32" "Reference/Kind=none" "Charges/Afterburn/Kind=none"
    "Charges/Charge 1/Mass=0.2" "Initial state/Background/Density=1.225e-5"
    "Initial state/Background/Pressure=1" EXIT 2
  MESSAGE "m/s: between the products of a charge and the thin air around it")

# Rigid bodies.
blast_survives(body_on_ground "${_closed};retries == 0")
foreach(_file cut_by_boundary thin_plate thin_shell needle gap
        one_voxel flawed_surface charge_5_cm on_axis)
  blast_survives(body_${_file} "${_closed}")
endforeach()
# Creases do not forbid a CFL number of 0.9: a cylinder on the ground, wedges, bodies
# with a gap of half a cell between them, and two boxes, one turned by 10 degrees, whose
# edge and side touch or are a thirtieth of a cell apart.
#
# blast_crease(<name> <file> <overrides>...)
function(blast_crease name file)
  contrecoup_add_application_test(crease_${name} bounds
    FILE blast/extremes/${file}.prm
    SET "Output/Fields=false" "Method/CFL number=0.9" ${ARGN}
    BOUNDS "status == finished" "retries == 0" ${_closed} LABELS extremes)
endfunction()

blast_crease(ground body_on_ground)
blast_crease(bodies body_gap "Domain/Initial refinement=1")
foreach(_file touching narrow_gap)
  blast_crease(bodies_${_file} body_gap "Domain/Initial refinement=1"
    "Body/Surface/File=${PROJECT_SOURCE_DIR}/parameter_files/blast/extremes/body_${_file}.stl")
endforeach()
foreach(_angle 5 15 30 60)
  math(EXPR _normal "90 - ${_angle}")
  blast_crease(wedge_${_angle} body_on_ground "Rigid body/Kind=half space"
    "Rigid body/Half space/Shift=0.5, 0, 0"
    "Rigid body/Half space/Rotation=0, 0, -${_normal}")
endforeach()
blast_survives(body_charge_50_m
  "checks.loads_impulse_difference < 5e-4;\
results.probe_2_peak_overpressure > 1e4"
  "Time/End time=0.1205")

# The same in single precision and three dimensions: totals to its round-off (1.2e-7
# at most, which scatters from one processor to another),
# and rest at rest.
#
# blast_survives_in_single(<file> [<bounds>] [<overrides>...])
function(blast_survives_in_single file bounds)
  contrecoup_add_application_test(extreme_single_${file} bounds
    FILE blast/extremes/${file}.prm
    SET "Output/Fields=false" "Method/Precision=single" ${ARGN}
    BOUNDS "status == finished" ${bounds} LABELS extremes)
endfunction()

set(_gas "conservation.mass_relative_change < 2e-7"
  "conservation.energy_relative_change < 2e-7")
set(_round_off ${_gas} "conservation.products_mass_relative_change < 2e-7")
foreach(_file charge_1_mg charge_cut hand_over_cells_times_1000 hand_over_early)
  blast_survives_in_single(${_file} "${_round_off}")
endforeach()
# Here products are a millionth of the gas.
blast_survives_in_single(hand_over_late
  "${_gas};conservation.products_mass_relative_change < 1.4e-6")
blast_survives_in_single(charge_1000_kg "${_round_off}"
  "Domain/Dimension=3" "Domain/Geometry=plane" "Domain/Lower corner=0,0,0"
  "Domain/Upper corner=4,4,4" "Domain/Coarse leaves=5,5,5"
  "Boundaries/x high=wall" "Boundaries/y low=symmetry"
  "Boundaries/z low=symmetry" "Time/End time=8e-4")
# Six cells are in each edge of the nozzle instead of 6.4: the inflow is 0.0326
# and 1812.6 times the initial content.
blast_survives_in_single(mach_1000_jet
  "conservation.mass_relative_change > 0.0323;\
conservation.mass_relative_change < 0.0329;\
conservation.energy_relative_change > 1803;\
conservation.energy_relative_change < 1822" "Domain/Dimension=3"
  "Domain/Lower corner=0,0,0" "Domain/Upper corner=1,0.5,0.5"
  "Domain/Coarse leaves=2,1,1" "Boundaries/z low=symmetry"
  "Boundaries/z high=open" "Adaptation/Largest level=3" "Pictures/Planes="
  "Initial state/Region nozzle/Lower corner=-1,-0.05,-0.05"
  "Initial state/Region nozzle/Upper corner=1e-6,0.05,0.05"
  "Initial state/Region nozzle/Velocity=371,0,0" "Time/End time=0.001")
blast_survives_in_single(rest_100000_steps "errors.density_Linf < 2.6e-8;\
errors.velocity_Linf < 1e-12;errors.pressure_Linf < 1e-9"
  "Domain/Dimension=3" "Domain/Geometry=plane" "Domain/Lower corner=0,0,0"
  "Domain/Upper corner=1,1,1" "Domain/Coarse leaves=1,1,1" "Method/Subcells=4"
  "Time/Largest number of steps=10000")
blast_survives_in_single(ten_levels "conservation.mass_relative_change < 1e-12;\
conservation.energy_relative_change < 1e-11" "Domain/Dimension=3"
  "Domain/Lower corner=0,0,0" "Domain/Upper corner=100,100,100"
  "Domain/Coarse leaves=1,1,1" "Method/Subcells=4"
  "Time/Largest number of steps=200")
