# The extremes: each run ends, and never with a number that is none (which
# run_case.py looks for in all tables).
#
# blast_survives(<file> [<bounds>] [<overrides>...])
function(blast_survives file bounds)
  contrecoup_add_application_test(extreme_${file} bounds
    FILE blast/extremes/${file}.prm SET "Output/Fields=false" ${ARGN}
    BOUNDS "status == finished" ${bounds} LABELS extremes TIMEOUT 300)
endfunction()

set(_closed "conservation.mass_relative_change < 1e-12"
  "conservation.energy_relative_change < 1e-12")

blast_survives(aspect_ratio_100 "errors.density_L1 < 5.9e-3")
blast_survives(cfl_beyond "errors.density_L1 < 0.15")
blast_survives(cfl_tiny "errors.density_L1 < 2.4e-3;${_closed}")
blast_survives(contact_at_rest
  "errors.pressure_Linf < 1e-9;errors.velocity_Linf < 1e-11;${_closed}")
blast_survives(contact_at_speed "errors.density_L1 < 0.3")
blast_survives(jwl_above_reference "errors.density_L1 < 26;${_closed}")
blast_survives(jwl_below_reference "errors.density_L1 < 4.2e-6;${_closed}")
blast_survives(leblanc_100 "errors.density_L1 < 5.0e-3;${_closed}")
blast_survives(mach_1000_jet "")
blast_survives(mach_1000_piston "errors.density_L1 < 2.0e-2")
blast_survives(one_cell "${_closed}")
blast_survives(one_cell_periodic "errors.density_Linf < 1e-12;${_closed}")
blast_survives(ratio_1330_1e6 "errors.density_L1 < 2.2;${_closed}")
blast_survives(rest_100000_steps
  "errors.density_Linf < 1e-12;errors.velocity_Linf < 1e-12;${_closed}")
blast_survives(ten_levels "${_closed}")
blast_survives(vacuum "errors.density_L1 < 7.5e-3")
