# Mistakes in parameter files and in the files that these name; all cases in one
# test.
_contrecoup_register_test(input_refusals TIMEOUT 900 LABELS refusal
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/input_cases.py
    $<TARGET_FILE_DIR:blast> ${PROJECT_SOURCE_DIR})
