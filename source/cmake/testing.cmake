# Functions that register tests with ctest. Usage is shown above each; the
# parameter-file tests call tests/applications/run_case.py.

find_package(GTest REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(CONTRECOUP_TEST_ENVIRONMENT
  OMPI_ALLOW_RUN_AS_ROOT=1
  OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_rmaps_base_oversubscribe=1
  OMPI_MCA_btl_vader_single_copy_mechanism=none
  OMPI_MCA_hwloc_base_binding_policy=none
  OMP_NUM_THREADS=1
  CONTRECOUP_CHECK_SECONDS=0
  PYTHONDONTWRITEBYTECODE=1)
# Open MPI leaks; and a library that asks for more memory than there is gets
# none, as without sanitizers. Runs take several times as long.
set(CONTRECOUP_TIMEOUT_FACTOR 1)
if(CONTRECOUP_SANITIZE)
  list(APPEND CONTRECOUP_TEST_ENVIRONMENT
    "ASAN_OPTIONS=detect_leaks=0:halt_on_error=1:allocator_may_return_null=1:\
suppressions=${PROJECT_SOURCE_DIR}/tests/sanitizer_suppressions.txt"
    UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1)
  set(CONTRECOUP_TIMEOUT_FACTOR 10)
endif()

# contrecoup_setup_test_target(<target>): contrecoup_setup_target, but tests take
# a third less to compile: what they measure is in the layers, optimised there.
function(contrecoup_setup_test_target target)
  contrecoup_setup_target(${target})
  target_compile_options(${target} PRIVATE
    $<$<CONFIG:Release>:-O1 -fno-unroll-loops -fno-unroll-all-loops>)
endfunction()

# The main function of all unit tests; compiled once.
add_library(contrecoup_test_main STATIC
  ${PROJECT_SOURCE_DIR}/tests/main.cc)
contrecoup_setup_test_target(contrecoup_test_main)
target_link_libraries(contrecoup_test_main contrecoup_base GTest::gtest)

# contrecoup_add_unit_test(<name> SOURCES <a.cc>... DEPENDS <layer>...
#   [MPI <n>] [LABELS <label>...] [TIMEOUT <seconds>])
#
# A GoogleTest executable and ctest <folder>_<name>, where <folder> is that of
# the calling CMakeLists.txt. With MPI <n> it runs a second time on n ranks,
# as <folder>_<name>_mpi_<n>. MPI is initialised before the first test.
function(contrecoup_add_unit_test name)
  cmake_parse_arguments(ARG "" "MPI;TIMEOUT" "SOURCES;DEPENDS;LABELS" ${ARGN})
  if(NOT ARG_SOURCES OR ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "contrecoup_add_unit_test(${name}): SOURCES is "
      "missing or these words are unknown: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  get_filename_component(_folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  set(_target ${_folder}_${name})
  add_executable(${_target} ${ARG_SOURCES})
  contrecoup_setup_test_target(${_target})
  target_link_libraries(${_target} contrecoup_test_main)
  foreach(_layer ${ARG_DEPENDS})
    target_link_libraries(${_target} contrecoup_${_layer})
  endforeach()

  _contrecoup_register_test(${_target} RANKS 1 TIMEOUT ${ARG_TIMEOUT}
    LABELS unit ${ARG_LABELS} COMMAND $<TARGET_FILE:${_target}>)
  if(ARG_MPI)
    _contrecoup_register_test(${_target}_mpi_${ARG_MPI} RANKS ${ARG_MPI}
      TIMEOUT ${ARG_TIMEOUT} LABELS unit ${ARG_LABELS}
      COMMAND ${DEAL_II_MPIEXEC} -np ${ARG_MPI} $<TARGET_FILE:${_target}>)
  endif()
endfunction()

# _contrecoup_register_test(<name> RANKS <n> [TIMEOUT <s>] LABELS ...
#   COMMAND ...): add_test with the environment and properties of all tests.
function(_contrecoup_register_test name)
  cmake_parse_arguments(ARG "" "RANKS;TIMEOUT" "LABELS;COMMAND" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  math(EXPR ARG_TIMEOUT "${CONTRECOUP_TIMEOUT_FACTOR} * ${ARG_TIMEOUT}")
  if(NOT ARG_RANKS)
    set(ARG_RANKS 1)
  endif()
  add_test(NAME ${name} COMMAND ${ARG_COMMAND}
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(${name} PROPERTIES
    ENVIRONMENT "${CONTRECOUP_TEST_ENVIRONMENT}"
    PROCESSORS ${ARG_RANKS}
    TIMEOUT ${ARG_TIMEOUT}
    LABELS "${ARG_LABELS}")
endfunction()

# contrecoup_add_application_test(<name> <kind> FILE <application>/<x>.prm
#   [SET "Section/Entry=value"...] [MPI <n>] [TIMEOUT <s>] [LABELS ...] ...)
#
# The ctest <application>_<name> runs a shipped parameter file (below
# parameter_files/) with overrides. What it proves depends on <kind>:
#   bounds        BOUNDS "errors.density_L1 < 1e-3" ...: of summary.json, with
#                 <, > or ==; [EXIT <code>...] [MESSAGE <text>] on the screen
#   regression    COMPARE <table>... TOLERANCE "-r 1e-8 -a 1e-6": numdiff with
#                 tests/applications/references/<application>_<name>/
#   ranks         COMPARE, TOLERANCE: one rank agrees with MPI <n> (default 2)
#   same          VARY "Section/Entry=true|false": both runs leave the same
#                 COMPARE tables and checkpoints, to the last bit; the first
#                 keeps the BOUNDS
#   convergence   VARY "Section/Entry=3|4|5" ERROR errors.x ORDER <number>
#   resume        COMPARE [STOP_AFTER <steps>]: stop and --resume equals
#                 straight through, to the last bit on one rank
#   sigterm       the same, stopped by SIGTERM, on several ranks by SIGUSR1; the
#                 run must last a second
#   check         --check accepts the file and writes nothing
#   forecast      --check predicts processor time, memory, output and steps (and
#                 COMPARE cells) within the factor TOLERANCE, and keeps that for
#                 the next time
#   presets       COMPARE <name>...: the presets beside FILE, the cheapest
#                 first, have the errors and relative costs that they state
#   pictures      COMPARE <png>...: the run draws these at its end
#   stem          BOUNDS "deviation < 1e-3": [m] of a Mach stem from smooth
#   wedge         BOUNDS "reflected < 20" "triple_point < 9" ANGLE <degrees>:
#                 angles of shocks at a wedge
#   reflection    BOUNDS "regular_up_to < 1.1" HEIGHT <m>: ground range [m] where
#                 regular reflection of a blast from that height ends
#   refusal       MESSAGE <text> [EXIT <code>] [OUTPUT <folder>] [CONTENT
#                 <lines appended to the file>] [ARGUMENTS ...]: bad input;
#                 @FOLDER@ in OUTPUT is a folder that has a file named a_file
#   failure       EXIT <code> MESSAGE <text>: a run that fails keeps its last
#                 checkpoint, fails again when resumed, and with ARGUMENTS ends
#   damaged_checkpoint, foreign_checkpoint (OTHER_FILE or ARGUMENTS): refused
#                 with MESSAGE
#   arrival       recorded loads begin with the wave and lose no impulse: BOUNDS
#                 of what arrival() in load_cases.py finds
#   gauge_order   VARY "Section/Entry=3|4|5" ERROR "<number> <s> <exact>|...":
#                 the largest means over so many seconds of gauges on the body
#                 converge; BOUNDS of what gauge_order() in load_cases.py finds
#   facet_loads   the samples in loads.h5 have the impulse of the run: BOUNDS of
#                 the summary and of what facet_loads() in load_cases.py finds
#   domain        Domain/Size = by time makes room enough for recorded loads:
#                 BOUNDS of what domain() in load_cases.py finds
#   disk          a full disk: exit code 3 with MESSAGE, checkpoint intact
#   main_job*     OTHER_FILE: the first lines in
#                 tests/applications/main_job_cases.py tell
#   study_*, scene_*  the first lines in tests/applications/study_cases.py and
#                 scene_cases.py tell
# No value may contain a semicolon.
function(contrecoup_add_application_test name kind)
  cmake_parse_arguments(ARG ""
    "FILE;OTHER_FILE;MPI;TIMEOUT;TOLERANCE;MESSAGE;OUTPUT;CONTENT;VARY;\
ERROR;ORDER;STOP_AFTER;HEIGHT;ANGLE"
    "SET;BOUNDS;COMPARE;EXIT;ARGUMENTS;LABELS" ${ARGN})
  if(NOT ARG_FILE OR ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "contrecoup_add_application_test(${name}): FILE is "
      "missing or these words are unknown: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  string(REGEX REPLACE "/.*" "" _application ${ARG_FILE})
  set(_test ${_application}_${name})
  set(_ranks 1)
  if(ARG_MPI)
    set(_ranks ${ARG_MPI})
  elseif(kind STREQUAL "ranks")
    set(_ranks 2)
  endif()
  set(_files ${PROJECT_SOURCE_DIR}/parameter_files)
  set(_options --name=${_test} --application=$<TARGET_FILE:${_application}>
    --file=${_files}/${ARG_FILE} --ranks=${_ranks}
    --mpiexec=${DEAL_II_MPIEXEC})
  if(kind STREQUAL "regression")
    list(APPEND _options --reference=${PROJECT_SOURCE_DIR}/tests/applications/references/${_test})
  endif()
  if(ARG_OTHER_FILE)
    list(APPEND _options --other-file=${_files}/${ARG_OTHER_FILE})
  endif()
  foreach(_key TOLERANCE MESSAGE OUTPUT CONTENT VARY ERROR ORDER
          STOP_AFTER HEIGHT ANGLE)
    if(DEFINED ARG_${_key})
      string(TOLOWER ${_key} _option)
      string(REPLACE "_" "-" _option ${_option})
      list(APPEND _options "--${_option}=${ARG_${_key}}")
    endif()
  endforeach()
  set(_option_BOUNDS bound)
  set(_option_ARGUMENTS argument)
  foreach(_key SET BOUNDS COMPARE EXIT ARGUMENTS)
    string(TOLOWER ${_key} _option)
    if(DEFINED _option_${_key})
      set(_option ${_option_${_key}})
    endif()
    foreach(_value IN LISTS ARG_${_key})
      list(APPEND _options "--${_option}=${_value}")
    endforeach()
  endforeach()
  _contrecoup_register_test(${_test} RANKS ${_ranks} TIMEOUT ${ARG_TIMEOUT}
    LABELS ${kind} ${ARG_LABELS}
    COMMAND ${Python3_EXECUTABLE}
      ${PROJECT_SOURCE_DIR}/tests/applications/run_case.py ${kind} ${_options})
endfunction()

# contrecoup_check_parameter_files(<application>): one test for each of its
# parameter files, <application>_check_<path>, that --check accepts it.
function(contrecoup_check_parameter_files application)
  set(_folder ${PROJECT_SOURCE_DIR}/parameter_files)
  file(GLOB_RECURSE _files CONFIGURE_DEPENDS RELATIVE ${_folder}
    ${_folder}/${application}/*.prm)
  foreach(_file ${_files})
    string(REGEX REPLACE "^${application}/(.*)\\.prm$" "\\1" _name ${_file})
    string(REPLACE "/" "_" _name ${_name})
    contrecoup_add_application_test(check_${_name} check FILE ${_file})
  endforeach()
endfunction()
