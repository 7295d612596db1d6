# cmake --install build --prefix DIR
include(CMakePackageConfigHelpers)
include(CheckCXXSymbolExists)

set(CONTRECOUP_LAYERS base materials numerics geometry io deal_ii gas further_schemes
  solid mpm ale coupling study)
set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/Contrecoup)
set(_targets ${_package})
if(CONTRECOUP_PACKAGE)
  string(APPEND _targets /${CONTRECOUP_PROCESSOR})
endif()

# contrecoup: all layers, as other programs link them. Those must have lanes of
# the library's width, which these flags give.
add_library(contrecoup INTERFACE)
foreach(_layer ${CONTRECOUP_LAYERS})
  target_link_libraries(contrecoup INTERFACE contrecoup_${_layer})
  set_target_properties(contrecoup_${_layer} PROPERTIES EXPORT_NAME ${_layer})
endforeach()
set(_lanes "")
if(CONTRECOUP_PROCESSOR)
  set(CMAKE_REQUIRED_FLAGS -march=${CONTRECOUP_PROCESSOR})
  set(_512 CONTRECOUP_AVX512_${CONTRECOUP_PROCESSOR})
  set(_256 CONTRECOUP_AVX_${CONTRECOUP_PROCESSOR})
  check_cxx_symbol_exists(__AVX512F__ cstddef ${_512})
  check_cxx_symbol_exists(__AVX__ cstddef ${_256})
  unset(CMAKE_REQUIRED_FLAGS)
  if(${_512})
    set(_lanes -mavx512f)
  elseif(${_256})
    set(_lanes -mavx)
  endif()
endif()
target_include_directories(contrecoup INTERFACE
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(contrecoup INTERFACE cxx_std_17)
target_compile_definitions(contrecoup INTERFACE OMPI_SKIP_MPICXX)
target_compile_options(contrecoup INTERFACE ${_lanes} -Wno-psabi)

list(TRANSFORM CONTRECOUP_LAYERS PREPEND contrecoup_ OUTPUT_VARIABLE _libraries)
install(TARGETS contrecoup ${_libraries} EXPORT ContrecoupTargets
  LIBRARY DESTINATION ${CONTRECOUP_LIBRARY_FOLDER}
    COMPONENT libraries NAMELINK_COMPONENT development)
install(EXPORT ContrecoupTargets NAMESPACE Contrecoup::
  DESTINATION ${_targets} COMPONENT development)
configure_package_config_file(source/cmake/ContrecoupConfig.cmake.in
  ${PROJECT_BINARY_DIR}/ContrecoupConfig.cmake INSTALL_DESTINATION ${_package})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/ContrecoupConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ContrecoupConfig.cmake
  ${PROJECT_BINARY_DIR}/ContrecoupConfigVersion.cmake
  source/cmake/mold.cmake DESTINATION ${_package} COMPONENT development)
install(DIRECTORY include/contrecoup ${PROJECT_BINARY_DIR}/include/contrecoup
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN "*.h")

install(TARGETS blast study anatomy biomechanics head_impact scene
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY applications/plot DESTINATION share/contrecoup
  USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
install(FILES source/numerics/injury/injury_criteria.json
  DESTINATION share/contrecoup/plot/report)
install(DIRECTORY applications/schemas parameter_files
  DESTINATION share/contrecoup)
install(FILES README.md LICENSE CHANGELOG.md DESTINATION share/doc/contrecoup)
install(DIRECTORY applications/example DESTINATION share/doc/contrecoup
  COMPONENT development)
