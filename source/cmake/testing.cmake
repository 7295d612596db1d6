# Functions that register tests with ctest. Usage is shown above each; the
# parameter-file tests call tests/applications/run_case.py.

find_package(GTest REQUIRED)

# Tests start in the order of the times that ctest itself keeps in the build folder;
# before the first run, in the order of their time limits.
if(EXISTS ${PROJECT_BINARY_DIR}/Testing/Temporary/CTestCostData.txt)
  set(CONTRECOUP_KNOWS_TIMES ON)
endif()

# Open MPI 5 has the names that begin with PRTE.
set(CONTRECOUP_TEST_ENVIRONMENT
  OMPI_ALLOW_RUN_AS_ROOT=1
  OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_rmaps_base_oversubscribe=1
  # All ranks are on this machine, whose network may change meanwhile. Components
  # for other networks, which Debian excludes, take a second to be opened.
  OMPI_MCA_btl=^tcp,uct,openib,ofi
  OMPI_MCA_pml=ob1
  OMPI_MCA_btl_vader_single_copy_mechanism=none
  OMPI_MCA_hwloc_base_binding_policy=none
  OMPI_MCA_ess_singleton_isolated=1
  OMPI_MCA_mpi_yield_when_idle=1
  PRTE_MCA_hwloc_default_binding_policy=none
  PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
  OMP_NUM_THREADS=1
  CONTRECOUP_CHECK_SECONDS=0
  PYTHONDONTWRITEBYTECODE=1)
# Open MPI leaks; and a library that asks for more memory than exists gets none,
# as without sanitizers. Runs take several times as long.
set(CONTRECOUP_TIMEOUT_FACTOR 1)
if(CONTRECOUP_SANITIZE)
  list(APPEND CONTRECOUP_TEST_ENVIRONMENT
    "ASAN_OPTIONS=detect_leaks=0:halt_on_error=1:allocator_may_return_null=1:\
suppressions=${PROJECT_SOURCE_DIR}/tests/sanitizer_suppressions.txt"
    UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1)
  set(CONTRECOUP_TIMEOUT_FACTOR 10)
endif()

# contrecoup_setup_test_target(<target>): contrecoup_setup_target, but tests
# compile in a third less time: the code that they measure is in the layers,
# optimised there.
function(contrecoup_setup_test_target target)
  contrecoup_setup_target(${target})
  target_compile_options(${target} PRIVATE
    $<$<CONFIG:Release>:${CONTRECOUP_COLD_OPTIONS}>)
endfunction()

# The main function of all unit tests; compiled once.
add_library(contrecoup_test_main STATIC
  ${PROJECT_SOURCE_DIR}/tests/main.cc
  ${PROJECT_SOURCE_DIR}/tests/source_filter.cc)
contrecoup_setup_test_target(contrecoup_test_main)
target_link_libraries(contrecoup_test_main contrecoup_base GTest::gtest)

# contrecoup_add_unit_test(<name> SOURCES <a.cc>... [DEPENDS <layer>...]
#   [TOGETHER <word>] [MPI <n>] [LABELS <label>...] [TIMEOUT <seconds>])
#
# The ctest <folder>_<name> runs the GoogleTests of these sources, where <folder>
# is that of the calling CMakeLists.txt, and its layer what they need unless they
# DEPEND on others. All of a folder are one program,
# <folder>_tests: each program takes 2 s to link. With MPI <n> they run a second
# time on n ranks, as <folder>_<name>_mpi_<n>. MPI is initialised before the
# first test. The compiler gets all sources of a folder with the same word of
# TOGETHER at once, which halves its work; names in their unnamed namespaces must
# differ.
function(contrecoup_add_unit_test name)
  cmake_parse_arguments(ARG "" "MPI;TIMEOUT;TOGETHER" "SOURCES;DEPENDS;LABELS" ${ARGN})
  if(NOT ARG_SOURCES OR ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "contrecoup_add_unit_test(${name}): SOURCES is "
      "missing or these words are unknown: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  get_filename_component(_folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  if(NOT ARG_DEPENDS)
    set(ARG_DEPENDS ${_folder})
  endif()
  set(_test ${_folder}_${name})
  set(_program ${_folder}_tests)
  if(NOT TARGET ${_program})
    add_executable(${_program})
    contrecoup_setup_test_target(${_program})
    set_target_properties(${_program} PROPERTIES
      UNITY_BUILD ${CONTRECOUP_UNITY} UNITY_BUILD_MODE GROUP)
    target_link_libraries(${_program} contrecoup_test_main)
    add_dependencies(${_program} contrecoup_further_schemes)
    target_include_directories(${_program} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
  target_sources(${_program} PRIVATE ${ARG_SOURCES})
  if(ARG_TOGETHER)
    set_source_files_properties(${ARG_SOURCES} PROPERTIES
      UNITY_GROUP ${ARG_TOGETHER})
  endif()
  foreach(_layer ${ARG_DEPENDS})
    target_link_libraries(${_program} contrecoup_${_layer})
  endforeach()

  list(TRANSFORM ARG_SOURCES REPLACE ".*/" "")
  list(JOIN ARG_SOURCES "," _sources)
  set(_command $<TARGET_FILE:${_program}> --sources=${_sources})
  _contrecoup_register_test(${_test} RANKS 1 TIMEOUT ${ARG_TIMEOUT}
    LABELS unit ${ARG_LABELS} COMMAND ${_command})
  if(ARG_MPI)
    _contrecoup_register_test(${_test}_mpi_${ARG_MPI} RANKS ${ARG_MPI}
      TIMEOUT ${ARG_TIMEOUT} LABELS unit ${ARG_LABELS}
      COMMAND ${DEAL_II_MPIEXEC} -np ${ARG_MPI} ${_command})
  endif()
endfunction()

# _contrecoup_register_test(<name> RANKS <n> [TIMEOUT <s>] LABELS ...
#   COMMAND ...): add_test with the environment and properties of all tests.
#
# The time limit ends tests that hang. Give those a longer one that take long:
# from nothing they start first. Those with the label nightly run with
# ctest -C Nightly alone, as tests/nightly does.
function(_contrecoup_register_test name)
  cmake_parse_arguments(ARG "" "RANKS;TIMEOUT" "LABELS;COMMAND" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 600)
  endif()
  math(EXPR ARG_TIMEOUT "${CONTRECOUP_TIMEOUT_FACTOR} * ${ARG_TIMEOUT}")
  if(NOT ARG_RANKS)
    set(ARG_RANKS 1)
  endif()
  set(_configurations "")
  if(nightly IN_LIST ARG_LABELS)
    set(_configurations CONFIGURATIONS Nightly)
  endif()
  add_test(NAME ${name} COMMAND ${ARG_COMMAND} ${_configurations}
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(${name} PROPERTIES
    ENVIRONMENT "${CONTRECOUP_TEST_ENVIRONMENT}"
    PROCESSORS ${ARG_RANKS}
    TIMEOUT ${ARG_TIMEOUT}
    SKIP_RETURN_CODE 77
    LABELS "${ARG_LABELS}")
  if(NOT CONTRECOUP_KNOWS_TIMES)
    set_tests_properties(${name} PROPERTIES COST ${ARG_TIMEOUT})
  endif()
endfunction()

# contrecoup_add_application_test(<name> <kind>[,<kind>...]
#   FILE <application>/<x>.prm [SET "Section/Entry=value"...] [MPI <n>]
#   [RANKS <n>...] [CORES <n>] [NEEDS <file>] [TIMEOUT <s>] [LABELS ...] ...)
#
# The ctest <application>_<name> runs a shipped parameter file (below
# parameter_files/) with overrides, on MPI ranks; without a file that it NEEDS
# it is skipped, and fails in CI (CI is set in the environment). Several kinds
# share the runs that they have in common. It keeps as many CORES busy as it has
# ranks at most, unless told that it mostly waits or runs on fewer. The proof
# depends on <kind>:
#   bounds        BOUNDS "errors.density_L1 < 1e-3" ...: of summary.json, with
#                 <, > or ==; "history.x" is the last value of that column of
#                 history.csv, "probes.x" of probes.csv;
#                 [EXIT <code>...] [MESSAGE <text>] on the screen, with
#                 [ARGUMENTS ...] then
#   regression    COMPARE <file>... TOLERANCE "1e-8" "momentum*=1e-9 absolute":
#                 tables (.csv) and samples of planes, skins, loads and meshes
#                 (.vti, .vtp, .h5, .vtu) agree with those in
#                 tests/applications/references/<application>_<name>/; a
#                 tolerance is a part of the largest value of a column or
#                 field, or absolute, see tests/applications/cases/samples.py
#   ranks         COMPARE, TOLERANCE: one rank agrees with each of RANKS
#                 (default 2)
#   same          VARY "Section/Entry=true|false": both runs leave the same
#                 COMPARE tables and checkpoints, to the last bit; the first
#                 keeps the BOUNDS
#   convergence   VARY "Section/Entry=3|4|5" ERROR errors.x ORDER <number>
#   resume        COMPARE [STOP_AFTER <steps>...]: stop and --resume equals
#                 straight through, to the last bit, and repeats no step
#   sigterm, sigkill  the same, stopped by SIGTERM or killed once there is a
#                 checkpoint, which are the first STOP_AFTER steps apart; the run must
#                 have Time/Largest number of steps or last a second
#   parallel_resume, parallel_sigterm, parallel_sigkill  the same on the last of
#                 RANKS, which agrees with straight through on as many within
#                 TOLERANCE; mpirun gets SIGUSR1
#   check_files   --check accepts all files of FILE's folder, with a plan, and
#                 writes nothing; "NEEDS <x.prm>=<file>" leaves one out that
#                 cannot be checked without a file
#   presets       COMPARE <name>...: the presets next to FILE, the cheapest
#                 first, have the errors and relative updates that they state
#   pictures      COMPARE <png>...: the run draws these at its end, and they
#                 are not of one colour
#   foreign_reader  meshio reads the VTU files of the run as the tests do
#   gauge_lines   VARY "Section/Entry=a|b": the first lines of gauges of the runs:
#                 BOUNDS of what gauge_lines() in field_cases.py finds
#   stem          BOUNDS "deviation < 1e-3": [m] of a Mach stem from smooth
#   wedge         BOUNDS "reflected < 20" "triple_point < 9" ANGLE <degrees>:
#                 angles of shocks at a wedge
#   reflection    BOUNDS "regular_up_to < 1.1" HEIGHT <m>: ground range [m] where
#                 regular reflection of a blast from that height ends
#   refusal       MESSAGE <text> [EXIT <code>] [OUTPUT <folder>] [CONTENT
#                 <lines appended to the file>] [ARGUMENTS ...]: bad input;
#                 @FOLDER@ in OUTPUT is a folder that has a file named a_file.
#                 All of an application are one ctest, <application>_refusals;
#                 CONTRECOUP_ONLY=<name> in the environment makes it try one
#   failure       EXIT <code> MESSAGE <text>: a run that fails keeps its last
#                 checkpoint, fails again when resumed, and with ARGUMENTS ends
#   damaged_checkpoint, foreign_checkpoint (OTHER_FILE or ARGUMENTS): refused
#                 with MESSAGE
#   arrival       recorded loads begin with the wave and lose no impulse: BOUNDS
#                 of what arrival() in load_cases.py finds
#   gauge_order   VARY "Section/Entry=3|4|5" ERROR "<number> <s> [last] <exact>|...":
#                 the largest (or last) means over so many seconds of gauges on the body
#                 converge; BOUNDS of what gauge_order() in load_cases.py finds
#   facet_loads   the samples in loads.h5 have the impulse of the run: BOUNDS of
#                 the summary and of what facet_loads() in load_cases.py finds
#   whole_body    a body that y = 0 halves gets the impulse of the whole one:
#                 BOUNDS of what whole_body() in load_cases.py finds
#   domain        Domain/Size = by time makes room enough for recorded loads:
#                 BOUNDS of what domain() in load_cases.py finds
#   disk, quota   a full disk, a limit to the size of files, when a run that was
#                 stopped after STOP_AFTER steps is resumed: exit code 3 with the
#                 reason, checkpoint intact; then resumed where there is room
#   parallel_disk  the same on the last of RANKS
#   disk_anew     both for a run without steps, on 1 and each of RANKS, which then
#                 leaves the COMPARE files
#   other_build   a checkpoint of another build is resumed with a word, or refused
#   one_number    ARGUMENTS <scene>...; the first lines in number_cases.py tell
#   main_job*     OTHER_FILE: the first lines in
#                 tests/applications/cases/main_job_cases.py tell
#   study_*, scene_*, folder_*  the first lines in study_cases.py, scene_cases.py
#                 and folder_cases.py of tests/applications/cases tell
# No value may contain a semicolon; in SET, @SEMICOLON@ stands for one.
function(contrecoup_add_application_test name kind)
  cmake_parse_arguments(ARG ""
    "FILE;OTHER_FILE;MPI;CORES;TIMEOUT;MESSAGE;OUTPUT;CONTENT;VARY;\
ERROR;ORDER;HEIGHT;ANGLE"
    "SET;BOUNDS;COMPARE;EXIT;ARGUMENTS;LABELS;RANKS;NEEDS;TOLERANCE;STOP_AFTER" ${ARGN})
  if(NOT ARG_FILE OR ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "contrecoup_add_application_test(${name}): FILE is "
      "missing or these words are unknown: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  string(REGEX REPLACE "/.*" "" _application ${ARG_FILE})
  set(_test ${_application}_${name})
  if(NOT ARG_MPI)
    set(ARG_MPI 1)
  endif()
  if(NOT ARG_RANKS AND kind MATCHES "ranks|parallel")
    set(ARG_RANKS 2)
  endif()
  set(_ranks ${ARG_MPI} ${ARG_RANKS})
  list(SORT _ranks COMPARE NATURAL ORDER DESCENDING)
  list(GET _ranks 0 _ranks)
  if(ARG_CORES)
    set(_ranks ${ARG_CORES})
  endif()
  set(_files ${PROJECT_SOURCE_DIR}/parameter_files)
  set(_options --name=${_test} --application=$<TARGET_FILE:${_application}>
    --file=${_files}/${ARG_FILE} --mpi=${ARG_MPI}
    --mpiexec=${DEAL_II_MPIEXEC})
  if(kind MATCHES "regression")
    list(APPEND _options --reference=${PROJECT_SOURCE_DIR}/tests/applications/references/${_test})
  endif()
  if(ARG_OTHER_FILE)
    list(APPEND _options --other-file=${_files}/${ARG_OTHER_FILE})
  endif()
  foreach(_key MESSAGE OUTPUT CONTENT VARY ERROR ORDER HEIGHT ANGLE)
    if(DEFINED ARG_${_key})
      string(TOLOWER ${_key} _option)
      list(APPEND _options "--${_option}=${ARG_${_key}}")
    endif()
  endforeach()
  set(_option_BOUNDS bound)
  set(_option_ARGUMENTS argument)
  foreach(_key SET BOUNDS COMPARE EXIT ARGUMENTS RANKS NEEDS TOLERANCE
          STOP_AFTER)
    string(TOLOWER ${_key} _option)
    string(REPLACE "_" "-" _option ${_option})
    if(DEFINED _option_${_key})
      set(_option ${_option_${_key}})
    endif()
    foreach(_value IN LISTS ARG_${_key})
      list(APPEND _options "--${_option}=${_value}")
    endforeach()
  endforeach()
  if(kind STREQUAL "refusal")
    _contrecoup_add_refusal(${_application} "${_options}")
    return()
  endif()
  string(REPLACE "," ";" _labels ${kind})
  _contrecoup_register_test(${_test} RANKS ${_ranks} TIMEOUT ${ARG_TIMEOUT}
    LABELS ${_labels} ${ARG_LABELS}
    COMMAND ${Python3_EXECUTABLE}
      ${PROJECT_SOURCE_DIR}/tests/applications/run_case.py ${kind} ${_options})
endfunction()

# contrecoup_add_refusal(<name> <file> <message> <entries to set>...): a test of the
# kind refusal.
function(contrecoup_add_refusal name file message)
  contrecoup_add_application_test(${name} refusal FILE ${file}
    MESSAGE "${message}" SET ${ARGN})
endfunction()

# Puts the words of one refusal, as a list of JSON, where the following function
# finds them.
function(_contrecoup_add_refusal application words)
  string(REPLACE "\\" "\\\\" words "${words}")
  string(REPLACE "\"" "\\\"" words "${words}")
  string(REPLACE "\n" "\\n" words "${words}")
  list(JOIN words "\", \"" words)
  set_property(GLOBAL APPEND PROPERTY CONTRECOUP_REFUSALS_${application}
    "[\"${words}\"]")
endfunction()

# contrecoup_add_refusals(<application>): the test <application>_refusals, that it
# refuses all bad input that tests of the kind refusal named before.
function(contrecoup_add_refusals application)
  get_property(_refusals GLOBAL PROPERTY CONTRECOUP_REFUSALS_${application})
  list(JOIN _refusals ",\n" _refusals)
  set(_table ${CMAKE_CURRENT_BINARY_DIR}/${application}_refusals.json)
  file(GENERATE OUTPUT ${_table} CONTENT "[${_refusals}]\n")
  contrecoup_add_application_test(refusals refusals FILE ${application}/quickstart.prm
    ARGUMENTS ${_table} TIMEOUT 1200)
endfunction()

# contrecoup_check_parameter_files(<application> [NEEDS ...]): the test
# <application>_check_files, that --check accepts each of its parameter files.
function(contrecoup_check_parameter_files application)
  contrecoup_add_application_test(check_files check_files
    FILE ${application}/quickstart.prm TIMEOUT 900 ${ARGN})
endfunction()
