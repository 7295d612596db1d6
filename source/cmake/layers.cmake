# contrecoup_add_layer(<name> SOURCES ... [DEPENDS <lower layer>...])
#
# One shared library per layer, contrecoup_<name>, in build/lib; a program need
# not be linked again where only the inside of a layer changes. The precompiled
# header is compiled once, by the lowest layer.
function(contrecoup_add_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  set(target contrecoup_${name})
  add_library(${target} SHARED ${ARG_SOURCES})
  contrecoup_setup_target(${target})
  # Without the macro that CMake defines in each shared library: sources that
  # have another one could not take the precompiled header.
  set_target_properties(${target} PROPERTIES DEFINE_SYMBOL ""
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  # clang links the sanitizers' run-time to programs alone.
  if(NOT CONTRECOUP_SANITIZE)
    target_link_options(${target} PRIVATE -Wl,--no-undefined)
  endif()
  foreach(_lower ${ARG_DEPENDS})
    target_link_libraries(${target} contrecoup_${_lower})
  endforeach()
endfunction()

# contrecoup_add_room(<layer> <source>...): sources of a layer in their own
# folder.
function(contrecoup_add_room layer)
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  target_sources(contrecoup_${layer} PRIVATE ${ARGN})
endfunction()

# contrecoup_compile_together(<layer> <source>...): the compiler reads these
# sources as one, which compiles their common templates once (those of JSON take
# five seconds a source). Names in their unnamed namespaces must differ.
function(contrecoup_compile_together name)
  set_target_properties(contrecoup_${name} PROPERTIES
    UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP together)
endfunction()

# contrecoup_setup_target(<target>): includes, deal.II, flags, common header.
# Without MPI's old C++ interface, which every source would compile anew.
function(contrecoup_setup_target target)
  target_include_directories(${target} PRIVATE
    ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include)
  deal_ii_setup_target(${target})
  target_compile_definitions(${target} PRIVATE OMPI_SKIP_MPICXX)
  target_compile_options(${target} PRIVATE ${CONTRECOUP_COMPILE_OPTIONS})
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
