# Runs of the solid solver: errors against theory, ranks, resume, bad input.
set(_folder biomechanics/verification)

# biomechanics_verifies(<name> <file> <bounds> [<overrides>...])
function(biomechanics_verifies name file bounds)
  contrecoup_add_application_test(${name} bounds FILE ${_folder}/${file}.prm
    SET "Output/Fields=false" ${ARGN} BOUNDS "status == finished" ${bounds}
    LABELS verification TIMEOUT 300)
endfunction()

set(_exact "errors.displacement_maximum < 1e-12"
  "errors.normal_stress < 1e-12;errors.shear_stress < 1e-12"
  "assumptions.energy_residual < 1e-12")
foreach(_control none viscous stiffness "assumed strain")
  string(REPLACE " " "_" _name ${_control})
  biomechanics_verifies(patch_${_name} patch_test "${_exact}"
    "Elements/Hourglass control=${_control}")
endforeach()
biomechanics_verifies(plane_wave plane_wave
  "errors.displacement_L2 < 3e-4;assumptions.energy_residual < 1e-12")
biomechanics_verifies(plane_wave_single plane_wave
  "errors.displacement_L2 < 3e-4;assumptions.energy_residual < 1e-4"
  "Elements/Precision=single")
biomechanics_verifies(spherical_cavity spherical_cavity
  "errors.peak_displacement < 1e-2;assumptions.energy_residual < 1e-10"
  "Mesh/Refinements=4")

contrecoup_add_application_test(resume resume FILE ${_folder}/plane_wave.prm
  SET "Output/Fields=false" COMPARE history.csv probes.csv)
contrecoup_add_application_test(ranks ranks FILE ${_folder}/plane_wave.prm
  SET "Output/Fields=false" COMPARE history.csv
  TOLERANCE "-r 1e-9 -a 1e-16")
contrecoup_add_application_test(no_support refusal
  FILE ${_folder}/plane_wave.prm
  ARGUMENTS "--set" "Supports/Support top/Directions=up"
  MESSAGE "must be some of x, y, z")
contrecoup_add_application_test(energy_gate bounds
  FILE ${_folder}/plane_wave.prm
  SET "Output/Fields=false" "Energy audit/Largest residual=0"
  BOUNDS "status == failed" EXIT 2 MESSAGE "energy audit")
