# contrecoup_add_layer(<name> [COLD] [DEPENDS <lower layer>...]
#   [MODULES <folders>...] [ALONE <folder or source>...])
#
# One shared library per layer, contrecoup_<name>, in build/lib; a program need
# not be linked again where only the inside of a layer changes. The precompiled
# header is compiled once, by the lowest layer. The sources are those in the folders
# of the modules, lowest first, or else those beside the CMakeLists.txt. The compiler
# reads the sources of a folder as one, and those of "several folders" too: reading the
# precompiled header takes it some seconds each time. Names in their unnamed namespaces
# must differ. It reads those of ALONE one by one: kernels, whose code must
# not depend on what else is there, and parts of one class template; they
# alone are optimised by -O3. A layer that is COLD takes no part in steps, and has the
# least optimisation, for a fifth less time to compile.
function(contrecoup_add_layer name)
  cmake_parse_arguments(ARG "COLD" "" "DEPENDS;MODULES;ALONE" ${ARGN})
  set(target contrecoup_${name})
  add_library(${target} SHARED)
  contrecoup_setup_target(${target})
  # Without the macro that CMake defines in each shared library: sources that
  # have another one could not take the precompiled header.
  set_target_properties(${target} PROPERTIES DEFINE_SYMBOL ""
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    UNITY_BUILD ${CONTRECOUP_UNITY} UNITY_BUILD_MODE GROUP)
  if(ARG_COLD)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${CONTRECOUP_COLD_OPTIONS}>)
  endif()
  # clang links the sanitizers' run-time to programs alone.
  if(NOT CONTRECOUP_SANITIZE)
    target_link_options(${target} PRIVATE -Wl,--no-undefined)
  endif()
  foreach(_lower ${ARG_DEPENDS})
    target_link_libraries(${target} contrecoup_${_lower})
  endforeach()
  if(NOT ARG_MODULES)
    set(ARG_MODULES .)
  endif()
  foreach(_folders ${ARG_MODULES})
    string(REPLACE " " "_" _group "${_folders}")
    separate_arguments(_folders)
    foreach(_folder ${_folders})
      contrecoup_add_sources(${target} ${_folder} ${_group} "${ARG_ALONE}")
    endforeach()
  endforeach()
endfunction()

# contrecoup_add_sources(<target> <folder> <name of those that are read as one>
#   <list of what is compiled alone>)
function(contrecoup_add_sources target folder group alone)
  file(GLOB _sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cc)
  target_sources(${target} PRIVATE ${_sources})
  list(TRANSFORM alone PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  foreach(_source ${_sources})
    if(_source IN_LIST alone OR ${CMAKE_CURRENT_SOURCE_DIR}/${folder} IN_LIST alone)
      list(REMOVE_ITEM _sources ${_source})
      set_property(SOURCE ${_source} TARGET_DIRECTORY ${target}
        APPEND PROPERTY COMPILE_OPTIONS
        "$<$<CONFIG:Release>:${CONTRECOUP_KERNEL_OPTIONS}>")
    endif()
  endforeach()
  if(NOT _sources)
    return()
  endif()
  set_source_files_properties(${_sources} TARGET_DIRECTORY ${target}
    PROPERTIES UNITY_GROUP ${group})
endfunction()

# contrecoup_setup_target(<target>): includes, deal.II, flags, common header.
# Without MPI's old C++ interface, which every source would compile again.
function(contrecoup_setup_target target)
  target_include_directories(${target} PRIVATE
    ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include)
  deal_ii_setup_target(${target})
  target_compile_definitions(${target} PRIVATE OMPI_SKIP_MPICXX)
  target_compile_options(${target} PRIVATE ${CONTRECOUP_COMPILE_OPTIONS}
    # gcc takes a source that a unity file includes for a header.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  if(target STREQUAL "contrecoup_base")
    target_precompile_headers(${target} PRIVATE
      ${PROJECT_SOURCE_DIR}/include/contrecoup/base/system/precompiled.h)
  else()
    target_precompile_headers(${target} REUSE_FROM contrecoup_base)
  endif()
endfunction()

# contrecoup_add_application(<name>): build/bin/<name> from
# applications/<name>/main.cc, linked with the named layers.
function(contrecoup_add_application name)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
  add_executable(${name} ${CMAKE_CURRENT_SOURCE_DIR}/${name}/main.cc)
  contrecoup_setup_target(${name})
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  foreach(_layer ${ARG_DEPENDS})
    target_link_libraries(${name} contrecoup_${_layer})
  endforeach()
endfunction()
