# The main job, from the charge to the report, in cells of 40 mm at the skin and
# until the wave has passed the front of the body.
set(_first_look "Scene/Accuracy=first look" "Scene/End time=0.0026"
  "Scene/Forecast=false")

contrecoup_add_application_test(main_job main_job FILE scene/quickstart.prm
  MPI 2 CORES 1 TIMEOUT 1800 SET ${_first_look})
# Small scenes: each quantity has one value in all that they leave and print.
set(_small FILE scene/quickstart.prm RANKS 2 TIMEOUT 900
  SET "Scene/Accuracy=first look" "Scene/Cell size=0.08" "Scene/Element size=0.02"
    "Scene/Forecast=false" "Blast/Output/Fields interval=1e-3"
    "Biomechanics/Output/Fields interval=1e-3" "Blast/Output/Pictures=false"
    "Anatomy/Output/Pictures=false")
contrecoup_add_application_test(one_number one_number ${_small}
  ARGUMENTS back_in_free_air own_explosive_before_a_child without_first_stage)
contrecoup_add_application_test(one_number_more one_number ${_small}
  ARGUMENTS front side_of_a_small_person from_the_left LABELS nightly)
# The report of the first one in a browser without a window.
_contrecoup_register_test(scene_main_job_page TIMEOUT 900 LABELS main_job
  COMMAND ${PROJECT_SOURCE_DIR}/tests/plot/page_checks.py
    scene_main_job/run/report.html)
set_tests_properties(scene_main_job PROPERTIES
  FIXTURES_SETUP main_job_report)
set_tests_properties(scene_main_job_page PROPERTIES
  FIXTURES_REQUIRED main_job_report)

# Fields are written at five times instead of 24 where the report of the main job
# has shown the others.
set(_few_fields "Blast/Output/Fields interval=5.2e-4"
  "Biomechanics/Output/Fields interval=5.2e-4")

# A woman of an STL file, on one rank: a second would idle during anatomy and
# report.
contrecoup_add_application_test(main_job_surface main_job_surface
  FILE scene/quickstart.prm OTHER_FILE anatomy/quickstart.prm
  TIMEOUT 1800 SET ${_first_look} ${_few_fields} "Body/Kind=surface"
  "Body/Surface/Organs=phantom")

# A head of medical images, which Debian's mricron-data ships. With elements of 6 mm one
# of the brain lies alone between bones, with twice the pressure of all others unless
# anatomy gives it to the fluid. The head has no gauges: bounds are within 3 % of the
# brain's values.
contrecoup_add_application_test(main_job_image main_job
  FILE scene/showcase/colin_head.prm TIMEOUT 1800
  NEEDS /usr/share/mricron/templates/ch2.nii.gz
  SET ${_first_look} ${_few_fields} "Scene/Element size=0.006"
    "Blast/Output/Volume fields=true"
  BOUNDS "results.injury_intracranial_pressure_peak > 718.6e3"
    "results.injury_intracranial_pressure_peak < 763.1e3"
    "results.injury_intracranial_pressure_lowest < 244.5e3"
    "results.injury_strain_95 > 0.01152" "results.injury_strain_95 < 0.01224"
    "results.injury_hic15 > 89.6" "results.injury_hic15 < 95.2" LABELS nightly)
