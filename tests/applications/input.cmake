# Every entry that selects something refuses to select nothing.
_contrecoup_register_test(input_selections TIMEOUT 900 LABELS refusal
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/selections.py
    $<TARGET_FILE_DIR:blast>)
# Every choice with which an entry is used exists.
_contrecoup_register_test(input_used_with LABELS refusal
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/used_with.py
    $<TARGET_FILE_DIR:blast>)
# --check forecasts what the run needs, for cheap runs of each application.
_contrecoup_register_test(input_forecasts TIMEOUT 900
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tests/validation/forecasts.py
    ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/input_forecasts --cheap)
# Mistakes in parameter files and in the files that these name; all cases in one
# test.
_contrecoup_register_test(input_refusals TIMEOUT 900 LABELS refusal
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/input_cases.py
    $<TARGET_FILE_DIR:blast> ${PROJECT_SOURCE_DIR})
