# The deal.II features and the further libraries that Contrecoup is built on.

set(_missing "")
foreach(_feature MPI P4EST HDF5 TRILINOS MUPARSER ZLIB)
  if(NOT DEAL_II_WITH_${_feature})
    list(APPEND _missing ${_feature})
  endif()
endforeach()
if(_missing)
  list(JOIN _missing ", " _missing)
  message(FATAL_ERROR "This deal.II (${DEAL_II_PACKAGE_VERSION} in "
    "${deal.II_DIR}) was built without: ${_missing}. "
    "Contrecoup needs each of them.")
endif()

find_package(nlohmann_json 3 QUIET)
if(NOT nlohmann_json_FOUND)
  message(FATAL_ERROR "Contrecoup needs nlohmann-json 3. "
    "On Debian: apt install nlohmann-json3-dev")
endif()
