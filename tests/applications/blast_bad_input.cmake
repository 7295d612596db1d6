# Bad input gives one line and exit code 1, and writes nothing. The messages
# must name the entry and what is allowed or meant.
set(_sod blast/verification/sod.prm)

# blast_refuses(<name> <message> <arguments of contrecoup_add_application_test>)
function(blast_refuses name message)
  contrecoup_add_application_test(refuses_${name} refusal ${ARGN}
    MESSAGE "${message}")
endfunction()

blast_refuses(unknown_entry "did you mean \"Limiter\"" FILE ${_sod}
  SET "Method/Limitr=mc")
blast_refuses(unknown_subsection "unknown subsection \"Methode\"" FILE ${_sod}
  CONTENT "subsection Methode\nset Limiter=mc\nend")
blast_refuses(unknown_value "did you mean \"minmod\"" FILE ${_sod}
  SET "Method/Limiter=minmood")
blast_refuses(negative_density "Left density" FILE ${_sod}
  SET "Initial state/Riemann/Left density=-1")
blast_refuses(impossible_cfl "Method/CFL number" FILE ${_sod}
  SET "Method/CFL number=-1")
blast_refuses(not_a_number "Method/CFL number" FILE ${_sod}
  SET "Method/CFL number=nan")
blast_refuses(negative_end_time "Time/End time" FILE ${_sod}
  SET "Time/End time=-1")
blast_refuses(unknown_dimension "Domain/Dimension" FILE ${_sod}
  SET "Domain/Dimension=4")
blast_refuses(inconsistent_dimension "Domain/" FILE ${_sod}
  SET "Domain/Dimension=3")
blast_refuses(single_precision_1d "Method/Precision = single" FILE ${_sod}
  SET "Method/Precision=single")
blast_refuses(single_precision_mapped "Method/Precision = single"
  FILE blast/verification/mapped_vortex.prm SET "Method/Precision=single")
blast_refuses(empty_box "Domain/Upper corner" FILE ${_sod}
  SET "Domain/Upper corner=-1")
blast_refuses(huge_mesh "of memory" FILE ${_sod}
  SET "Domain/Coarse leaves=1000000000")
blast_refuses(huge_octree "of memory" FILE blast/showcase/hot_ball.prm
  SET "Domain/Initial refinement=9")
blast_refuses(injury_where_nobody_lives "people live at 45 to 115 kPa"
  FILE ${_sod} SET "Probes/Injury=true" "Probes/Points=0.5")
blast_refuses(probe_outside "Probes/Points" FILE ${_sod}
  SET "Probes/Points=7")
blast_refuses(missing_reference "Reference" FILE ${_sod}
  SET "Initial state/Kind=uniform")
blast_refuses(missing_file "no_such_file.prm" FILE blast/no_such_file.prm)
blast_refuses(unfinished_file "subsection" FILE ${_sod}
  CONTENT "subsection Method\nset Limiter = mc")
blast_refuses(malformed_override "Section/Entry=value" FILE ${_sod}
  SET "Method")
blast_refuses(unknown_option "did you mean \"--output\"" FILE ${_sod}
  ARGUMENTS --outptu x)
blast_refuses(unwritable_output "output folder" FILE ${_sod}
  OUTPUT "@FOLDER@/a_file/run")
blast_refuses(missing_mesh_file "there is no such file"
  FILE blast/extremes/rest_100000_steps.prm SET "Domain/Mesh=file"
  "Domain/Geometry=plane" "Domain/Mesh file=no_such.msh")

contrecoup_add_application_test(refuses_truncated_checkpoint damaged_checkpoint
  FILE ${_sod} MESSAGE "bytes instead of")
contrecoup_add_application_test(refuses_other_scene foreign_checkpoint
  FILE ${_sod} MESSAGE "belongs to another scene"
  ARGUMENTS --set "Initial state/Riemann/Left pressure=2")
contrecoup_add_application_test(refuses_other_file foreign_checkpoint
  FILE ${_sod} OTHER_FILE blast/verification/toro_1.prm
  MESSAGE "belongs to another scene")
