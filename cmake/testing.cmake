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
  PYTHONDONTWRITEBYTECODE=1)

# The main function of all unit tests; compiled once.
add_library(contrecoup_test_main STATIC
  ${PROJECT_SOURCE_DIR}/tests/main.cc)
contrecoup_setup_target(contrecoup_test_main)
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
  contrecoup_setup_target(${_target})
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
