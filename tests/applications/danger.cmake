# Scenes that must not be computed are refused before meshing; the rows are in
# danger.py.
foreach(_application blast anatomy scene biomechanics)
  set(_folder ${CMAKE_CURRENT_BINARY_DIR}/danger_${_application})
  file(MAKE_DIRECTORY ${_folder})
  _contrecoup_register_test(${_application}_danger TIMEOUT 900 LABELS refusal
    COMMAND ${CMAKE_COMMAND} -E chdir ${_folder}
      ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/danger.py
      ${_application} $<TARGET_FILE:${_application}> $<TARGET_FILE:blast>)
endforeach()
