# Bad input gives one line and exit code 1, and writes nothing. The messages
# must name the entry and what is allowed or meant.
set(_sod blast/verification/sod.prm)

contrecoup_add_refusal(refuses_unknown_entry ${_sod} "did you mean \"Limiter\""
  "Method/Limitr=mc")
contrecoup_add_application_test(refuses_unknown_subsection refusal FILE ${_sod} CONTENT
  "subsection Methode\nset Limiter=mc\nend" MESSAGE "unknown subsection \"Methode\"")
contrecoup_add_refusal(refuses_unknown_value ${_sod} "did you mean \"minmod\""
  "Method/Limiter=minmood")
contrecoup_add_refusal(refuses_negative_density ${_sod} "Left density"
  "Initial state/Riemann/Left density=-1")
contrecoup_add_refusal(refuses_impossible_cfl ${_sod} "Method/CFL number"
  "Method/CFL number=-1")
contrecoup_add_refusal(refuses_not_a_number ${_sod} "Method/CFL number"
  "Method/CFL number=nan")
contrecoup_add_refusal(refuses_negative_end_time ${_sod} "Time/End time"
  "Time/End time=-1")
contrecoup_add_refusal(refuses_unknown_dimension ${_sod} "Domain/Dimension"
  "Domain/Dimension=4")
contrecoup_add_refusal(refuses_inconsistent_dimension ${_sod} "Domain/"
  "Domain/Dimension=3")
contrecoup_add_refusal(refuses_single_precision_1d ${_sod} "Method/Precision = single"
  "Method/Precision=single")
contrecoup_add_refusal(refuses_single_precision_mapped
  blast/verification/mapped_vortex.prm "Method/Precision = single"
  "Method/Precision=single")
contrecoup_add_refusal(refuses_empty_box ${_sod} "Domain/Upper corner"
  "Domain/Upper corner=-1")
contrecoup_add_refusal(refuses_huge_mesh ${_sod} "of memory"
  "Domain/Coarse leaves=1000000000")
contrecoup_add_refusal(refuses_huge_octree blast/showcase/hot_ball.prm "of memory"
  "Domain/Initial refinement=9")
contrecoup_add_refusal(refuses_injury_where_nobody_lives ${_sod}
  "people live at 45 to 115 kPa" "Probes/Injury=true" "Probes/Points=0.5")
contrecoup_add_refusal(refuses_probe_outside ${_sod} "Probes/Points" "Probes/Points=7")
contrecoup_add_refusal(refuses_missing_reference ${_sod} "Reference"
  "Initial state/Kind=uniform")
contrecoup_add_application_test(refuses_missing_file refusal FILE blast/no_such_file.prm
  MESSAGE "no_such_file.prm")
contrecoup_add_application_test(refuses_unfinished_file refusal FILE ${_sod} CONTENT
  "subsection Method\nset Limiter = mc" MESSAGE "subsection")
contrecoup_add_refusal(refuses_malformed_override ${_sod} "Section/Entry=value"
  "Method")
contrecoup_add_application_test(refuses_unknown_option refusal FILE ${_sod} ARGUMENTS
  --outptu x MESSAGE "did you mean \"--output\"")
contrecoup_add_application_test(refuses_unwritable_output refusal FILE ${_sod} OUTPUT
  "@FOLDER@/a_file/run" MESSAGE "output folder")
contrecoup_add_refusal(refuses_missing_mesh_file blast/extremes/rest_100000_steps.prm
  "there is no such file" "Domain/Mesh=file" "Domain/Geometry=plane"
  "Domain/Mesh file=no_such.msh")

contrecoup_add_application_test(refuses_truncated_checkpoint damaged_checkpoint
  FILE ${_sod} MESSAGE "bytes instead of")
contrecoup_add_application_test(refuses_other_scene foreign_checkpoint
  FILE ${_sod} MESSAGE "belongs to another scene"
  ARGUMENTS --set "Initial state/Riemann/Left pressure=2")
contrecoup_add_application_test(refuses_other_file foreign_checkpoint
  FILE ${_sod} OTHER_FILE blast/verification/toro_1.prm
  MESSAGE "belongs to another scene")
