# Debian packages: contrecoup with the programs, and libcontrecoup-dev for
# programs of one's own. applications/package makes them for any x86-64
# processor, of a build with CONTRECOUP_PACKAGE for each kind of processor;
# cpack in any other build makes them for the processor of that build.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME programs)

# The folder of the libraries, and those in which programs look for them.
set(CONTRECOUP_LIBRARY_FOLDER ${CMAKE_INSTALL_LIBDIR})
set(CONTRECOUP_LIBRARY_PATH ${CMAKE_INSTALL_LIBDIR})
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};contrecoup;ALL;/")
set(CPACK_DEBIAN_PACKAGE_VERSION ${PROJECT_VERSION}+${CONTRECOUP_PROCESSOR})
set(_built ${PROJECT_BINARY_DIR}/lib)
if(CONTRECOUP_PACKAGE)
  # The loader prefers libraries in glibc-hwcaps that the processor can run.
  # Those for any processor are in a folder of their own: programs that are
  # linked with them find no others there, whose lanes are wider.
  set(_home ${CMAKE_INSTALL_LIBDIR}/contrecoup)
  set(CONTRECOUP_LIBRARY_PATH ${_home} ${_home}/x86-64)
  set(CONTRECOUP_LIBRARY_FOLDER ${_home}/${CONTRECOUP_PROCESSOR})
  if(NOT CONTRECOUP_PROCESSOR STREQUAL "x86-64")
    set(CONTRECOUP_LIBRARY_FOLDER
      ${_home}/glibc-hwcaps/${CONTRECOUP_PROCESSOR})
  endif()
  set(CMAKE_INSTALL_RPATH_USE_LINK_PATH OFF)
  set(CPACK_COMPONENTS_LANES libraries development)
  foreach(_processor x86-64-v3 x86-64-v4)
    cmake_path(SET _tree NORMALIZE ${PROJECT_BINARY_DIR}/../${_processor})
    list(APPEND CPACK_INSTALL_CMAKE_PROJECTS ${_tree} contrecoup lanes /)
    list(APPEND _built ${_tree}/lib)
  endforeach()
  set(CPACK_DEBIAN_PACKAGE_VERSION ${PROJECT_VERSION})
endif()

# Whoever makes a Debian package has name and address in these variables.
set(_maintainer "$ENV{DEBFULLNAME}")
set(_address "$ENV{DEBEMAIL}")
if(NOT _maintainer OR NOT _address)
  set(_maintainer "The Contrecoup authors")
  set(_address contrecoup@contrecoup.invalid)
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_PACKAGE_CONTACT "${_maintainer} <${_address}>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "what a blast does to a human body")
set(CPACK_PACKAGE_DESCRIPTION_FILE
  ${PROJECT_SOURCE_DIR}/source/cmake/package/description.txt)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE
  OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS
  ${PROJECT_SOURCE_DIR}/source/cmake/package/finish.cmake)

set(CPACK_COMPONENTS_ALL programs libraries development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_PROGRAMS_GROUP contrecoup)
set(CPACK_COMPONENT_LIBRARIES_GROUP contrecoup)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP libcontrecoup-dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${_built})
set(CPACK_DEBIAN_CONTRECOUP_PACKAGE_NAME contrecoup)
set(CPACK_DEBIAN_CONTRECOUP_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CONTRECOUP_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CONTRECOUP_PACKAGE_DEPENDS
  "openmpi-bin, python3, python3-numpy, python3-matplotlib, python3-h5py")
set(CPACK_DEBIAN_CONTRECOUP_PACKAGE_RECOMMENDS "bash-completion, man-db")
set(CPACK_DEBIAN_CONTRECOUP_PACKAGE_SUGGESTS "libcontrecoup-dev, paraview")
set(CPACK_DEBIAN_CONTRECOUP_PACKAGE_CONTROL_EXTRA
  ${PROJECT_SOURCE_DIR}/source/cmake/package/postinst
  ${PROJECT_SOURCE_DIR}/source/cmake/package/prerm)
set(CPACK_DEBIAN_LIBCONTRECOUP-DEV_PACKAGE_NAME libcontrecoup-dev)
set(CPACK_DEBIAN_LIBCONTRECOUP-DEV_PACKAGE_SECTION libdevel)
set(_release ${CPACK_DEBIAN_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
set(CPACK_DEBIAN_LIBCONTRECOUP-DEV_PACKAGE_DEPENDS "contrecoup (= ${_release}), \
cmake, g++, libassimp-dev, libdeal.ii-dev, libjemalloc-dev, libnifti-dev, make, \
nlohmann-json3-dev, zlib1g-dev")
include(CPack)
