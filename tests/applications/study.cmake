# Studies of tiny runs of blast.
set(_study study/quickstart.prm)

# Results: the table's best and the orders follow from errors that the tests of
# blast keep; here they must appear.
contrecoup_add_application_test(quickstart study_run FILE ${_study}
  BOUNDS "outcomes.stable == 8" "status == finished"
    "orders.finite volume > 0.746" "orders.finite volume < 0.902"
  COMPARE work_precision.png)

# Every way in which a run can end; a study survives them all.
contrecoup_add_application_test(failures study_failures FILE ${_study})

# Stopped by signals, and killed: finished runs are not repeated.
contrecoup_add_application_test(sigterm study_sigterm FILE ${_study})
contrecoup_add_application_test(sigkill study_sigkill FILE ${_study})
contrecoup_add_application_test(storage study_storage FILE ${_study})
contrecoup_add_application_test(quota study_quota FILE ${_study} RANKS 3)

# Files of other kinds.
contrecoup_add_application_test(any_file study_any_file FILE ${_study} TIMEOUT 900
  OTHER_FILE blast/verification)

# A series of scenes over distance, in cells of 80 mm and elements of 30 mm.
contrecoup_add_application_test(distance study_distance FILE study/distance.prm
  RANKS 2
  SET "Study/Settings=Scene/Accuracy=first look@SEMICOLON@ \
Scene/Cell size=0.08@SEMICOLON@ Scene/Element size=0.03@SEMICOLON@ \
Scene/Error estimate=false@SEMICOLON@ Scene/Report=false@SEMICOLON@ \
Scene/Forecast=false@SEMICOLON@ Anatomy/Output/Pictures=false@SEMICOLON@ \
Blast/Output/Fields=false@SEMICOLON@ Blast/Output/Pictures=false@SEMICOLON@ \
Biomechanics/Output/Fields=false"
    "Vary distance/Values=1 | 0.0045@SEMICOLON@ 1.6 | 0.0045@SEMICOLON@ 3.2 | 0.0065"
    "Vary distance/Labels=1 m@SEMICOLON@ 1.6 m@SEMICOLON@ 3.2 m")

# study_refuses(<name> <message> <arguments>)
function(study_refuses name message)
  contrecoup_add_application_test(refuses_${name} refusal ${ARGN}
    FILE ${_study} MESSAGE "${message}")
endfunction()

study_refuses(unknown_application "did you mean \"blast\""
  SET "Study/Application=blastt")
study_refuses(missing_file "Study/Parameter file"
  SET "Study/Parameter file=no_such.prm")
study_refuses(unknown_entry "Vary leaves: blast: unknown entry \"Coarse leafs\" in"
  SET "Vary leaves/Entry=Domain/Coarse leafs")
study_refuses(impossible_value "Time/End time"
  SET "Vary leaves/Entry=Time/End time" "Vary leaves/Values=-1")
study_refuses(unknown_setting "Study/Settings: blast: unknown entry"
  SET "Study/Settings=Method/Limitr=mc")
study_refuses(setting_without_effect
  "\"Domain/Coarse leaves\" has no effect, since \"Vary leaves\" sets it"
  SET "Study/Settings=Domain/Coarse leaves=10" ARGUMENTS --check)
study_refuses(setting_of_the_reference "stands in Error/Reference"
  SET "Study/Settings=Domain/Coarse leaves=10" "Error/Kind=reference run"
  "Error/Reference=Domain/Coarse leaves=20" ARGUMENTS --check)
study_refuses(first_run "the run (finite volume, 10): blast: "
  SET "Study/Settings=Initial state/Kind=uniform" ARGUMENTS --check)
# Outputs that no run can have, before anything runs.
study_refuses(unknown_column "did you mean \"results.peak\"?"
  SET "Study/Columns=resluts.peak" ARGUMENTS --check)
study_refuses(unknown_table "did you mean \"history.csv:last:mass\"?"
  SET "Study/Columns=histories.csv:last:mass")
study_refuses(unknown_error "Error/Kind = none makes tables"
  SET "Error/Kind=known value" "Error/Name=eror.density_L1" ARGUMENTS --check)
study_refuses(missing_reference "\"no_such\" holds no finished run"
  SET "Error/Kind=reference run" "Error/Reference folder=no_such")
study_refuses(repeated_value "Values: \"20\" is there twice"
  SET "Vary leaves/Values=10@SEMICOLON@ 20@SEMICOLON@ 20")
study_refuses(ragged_table "parts between"
  SET "Vary scheme/Values=finite volume | 1")
study_refuses(unwritable_output "output folder" OUTPUT "@FOLDER@/a_file/run")
