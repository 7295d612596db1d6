# manual: pages for man and completion for bash, made of what the programs print
# (Debian: apt install python3-jinja2). Built with everything else; installed to
# share/man and share/bash-completion.

execute_process(
  COMMAND ${Python3_EXECUTABLE} -c "import jinja2"
  RESULT_VARIABLE _without_jinja OUTPUT_QUIET ERROR_QUIET)
if(_without_jinja)
  message(STATUS "No manual: python3-jinja2 is missing")
  return()
endif()

set(_manual ${PROJECT_SOURCE_DIR}/applications/manual)
set(_output ${PROJECT_BINARY_DIR}/manual)
set(_programs scene blast anatomy biomechanics head_impact study)
# Entries are in the libraries, and a program is not linked again with these.
set(_libraries "")
foreach(_layer base materials numerics geometry io deal_ii gas solid mpm ale
    coupling study)
  list(APPEND _libraries $<TARGET_FILE:contrecoup_${_layer}>)
endforeach()
file(GLOB _templates CONFIGURE_DEPENDS ${_manual}/*)
add_custom_command(
  OUTPUT ${_output}/made
  COMMAND ${CMAKE_COMMAND} -E env OMPI_ALLOW_RUN_AS_ROOT=1
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 PYTHONDONTWRITEBYTECODE=1
    ASAN_OPTIONS=detect_leaks=0
    ${Python3_EXECUTABLE} ${_manual}/make_manual.py
    $<TARGET_FILE_DIR:scene> ${_output}
  COMMAND ${CMAKE_COMMAND} -E touch ${_output}/made
  DEPENDS ${_programs} ${_libraries} ${_templates} ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  COMMENT "Manual" VERBATIM)
add_custom_target(manual ALL DEPENDS ${_output}/made)

install(DIRECTORY ${_output}/man1 ${_output}/man5 DESTINATION share/man)
install(DIRECTORY ${_output}/completions DESTINATION share/bash-completion)
