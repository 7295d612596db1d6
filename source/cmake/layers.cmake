# contrecoup_add_layer(<name> [DEPENDS <lower layer>...])
#
# One shared library per layer, contrecoup_<name>, in build/lib; a program need
# not be linked again where only the inside of a layer changes. The precompiled
# header is compiled once, by the lowest layer.
function(contrecoup_add_layer name)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
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
  # clang links the sanitizers' run-time to programs alone.
  if(NOT CONTRECOUP_SANITIZE)
    target_link_options(${target} PRIVATE -Wl,--no-undefined)
  endif()
  foreach(_lower ${ARG_DEPENDS})
    target_link_libraries(${target} contrecoup_${_lower})
  endforeach()
endfunction()

# contrecoup_add_module(<layer> <source>... [ALONE <source>...]): sources of a layer
# in their own folder. The compiler reads them as one, which halves its work;
# names in their unnamed namespaces must differ. It reads those after ALONE one by
# one: kernels, whose code must not depend on what else is there, and parts of one
# class template.
function(contrecoup_add_module layer)
  cmake_parse_arguments(ARG "" "" "ALONE" ${ARGN})
  set(_together ${ARG_UNPARSED_ARGUMENTS})
  list(TRANSFORM _together PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  list(TRANSFORM ARG_ALONE PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  target_sources(contrecoup_${layer} PRIVATE ${_together} ${ARG_ALONE})
  get_filename_component(_folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  set_source_files_properties(${_together} TARGET_DIRECTORY contrecoup_${layer}
    PROPERTIES UNITY_GROUP ${_folder})
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
