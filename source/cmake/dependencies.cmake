# The deal.II features and the further libraries that Contrecoup needs.

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

# Assimp reads surfaces, predicates of CGAL check them.
find_library(CONTRECOUP_ASSIMP assimp)
find_path(CONTRECOUP_ASSIMP_HEADERS assimp/Importer.hpp)
find_path(CONTRECOUP_CGAL_HEADERS
  CGAL/Exact_predicates_inexact_constructions_kernel.h)
mark_as_advanced(CONTRECOUP_ASSIMP CONTRECOUP_ASSIMP_HEADERS
  CONTRECOUP_CGAL_HEADERS)
if(NOT CONTRECOUP_ASSIMP OR NOT CONTRECOUP_ASSIMP_HEADERS
   OR NOT CONTRECOUP_CGAL_HEADERS)
  message(FATAL_ERROR "Contrecoup needs Assimp and CGAL. "
    "On Debian: apt install libassimp-dev libcgal-dev")
endif()

# The library of NIfTI's authors reads medical images.
find_library(CONTRECOUP_NIFTI niftiio)
find_path(CONTRECOUP_NIFTI_HEADERS nifti/nifti1_io.h)
mark_as_advanced(CONTRECOUP_NIFTI CONTRECOUP_NIFTI_HEADERS)
if(NOT CONTRECOUP_NIFTI OR NOT CONTRECOUP_NIFTI_HEADERS)
  message(FATAL_ERROR "Contrecoup needs the NIfTI library. "
    "On Debian: apt install libnifti-dev")
endif()

# Adaptive meshes allocate aligned memory of changing sizes, and glibc up to
# 2.37 returns hardly any of it: the blast before a man held six times the
# memory in use. The address sanitizer has its own allocator.
find_library(CONTRECOUP_JEMALLOC jemalloc)
mark_as_advanced(CONTRECOUP_JEMALLOC)
if(CONTRECOUP_SANITIZE)
  set(CONTRECOUP_ALLOCATOR "")
elseif(CONTRECOUP_JEMALLOC)
  set(CONTRECOUP_ALLOCATOR "-Wl,--push-state,--no-as-needed"
    ${CONTRECOUP_JEMALLOC} "-Wl,--pop-state")
else()
  message(STATUS "jemalloc is not there; runs may take several times the "
    "memory. On Debian: apt install libjemalloc-dev")
  set(CONTRECOUP_ALLOCATOR "")
endif()

# Debian's interpreter has the packages that debian_packages.txt names.
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# The usual linker reads the symbols of the 200 libraries behind deal.II anew for
# each library and program: 41 s on Debian 13, where mold takes 1 s.
include(${CMAKE_CURRENT_LIST_DIR}/mold.cmake)
if(CONTRECOUP_MOLD)
  add_link_options(-fuse-ld=mold)
endif()
