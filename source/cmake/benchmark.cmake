# contrecoup_add_benchmark(<name> SOURCES <a.cc>... DEPENDS <layer>...)
#
# A program build/bin/benchmark_<name> that prints rows "name,value,unit" on
# stdout. "cmake --build build --target benchmark" runs them all, one after
# the other, and writes build/benchmark.csv and build/benchmark.md.
function(contrecoup_add_benchmark name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  set(_target benchmark_${name})
  add_executable(${_target} EXCLUDE_FROM_ALL ${ARG_SOURCES})
  contrecoup_setup_target(${_target})
  set_target_properties(${_target} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  foreach(_layer ${ARG_DEPENDS})
    target_link_libraries(${_target} contrecoup_${_layer})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY CONTRECOUP_BENCHMARKS ${_target})
endfunction()

# Called once, after the last contrecoup_add_benchmark.
function(contrecoup_add_benchmark_target)
  get_property(_targets GLOBAL PROPERTY CONTRECOUP_BENCHMARKS)
  set(_programs "")
  foreach(_target ${_targets})
    list(APPEND _programs $<TARGET_FILE:${_target}>)
  endforeach()
  # Accuracy of the times that --check predicts.
  list(APPEND _programs
    "${PROJECT_SOURCE_DIR}/tests/benchmark/check_times.py ${PROJECT_BINARY_DIR}/bin")
  add_custom_target(benchmark
    COMMAND ${Python3_EXECUTABLE}
      ${PROJECT_SOURCE_DIR}/tests/benchmark/run_benchmarks.py
      ${PROJECT_BINARY_DIR}/benchmark.csv ${_programs}
    DEPENDS ${_targets} blast scene
    USES_TERMINAL VERBATIM)
endfunction()
