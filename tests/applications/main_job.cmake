# The main job, from the charge to the report, in cells of 40 mm at the skin and
# until the wave has passed the front of the body.
set(_first_look "Scene/Accuracy=first look" "Scene/End time=0.0026"
  "Scene/Forecast=false")

contrecoup_add_application_test(main_job main_job FILE scene/quickstart.prm
  MPI 2 TIMEOUT 1800 SET ${_first_look})
# Its report in a browser without a window.
_contrecoup_register_test(scene_main_job_page TIMEOUT 900 LABELS main_job
  COMMAND ${PROJECT_SOURCE_DIR}/tests/plot/page_checks.py
    scene_main_job/run/report.html)
set_tests_properties(scene_main_job PROPERTIES
  FIXTURES_SETUP main_job_report)
set_tests_properties(scene_main_job_page PROPERTIES
  FIXTURES_REQUIRED main_job_report)

# A woman of an STL file.
contrecoup_add_application_test(main_job_surface main_job_surface
  FILE scene/quickstart.prm OTHER_FILE anatomy/quickstart.prm
  MPI 2 TIMEOUT 1800 SET ${_first_look} "Body/Kind=surface"
  "Body/Surface/Organs=phantom")
