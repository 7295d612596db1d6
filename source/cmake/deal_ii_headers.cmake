# Features of deal.II that the compiler sees. Debian's deal.II is built with the
# automatic differentiation of ADOL-C and Sacado and the vectors of Trilinos and
# PETSc: even its header of numbers includes them, which costs more than a second
# of compiling for each source file, and Contrecoup does not use them. A copy of
# deal.II's list of features without these comes before the installed one.
#
# This is safe because no class that Contrecoup uses has other data members or
# virtual functions without them (deal.II 9.4). Other releases keep the
# installed list.
set(_config ${PROJECT_BINARY_DIR}/include/deal.II/base/config.h)
find_file(CONTRECOUP_DEAL_II_CONFIG deal.II/base/config.h
  PATHS ${DEAL_II_INCLUDE_DIRS} NO_DEFAULT_PATH)
mark_as_advanced(CONTRECOUP_DEAL_II_CONFIG)
if(CONTRECOUP_DEAL_II_CONFIG AND DEAL_II_PACKAGE_VERSION MATCHES "^9\\.4\\.")
  file(READ ${CONTRECOUP_DEAL_II_CONFIG} _text)
  string(REGEX REPLACE
    "#define (DEAL_II_(WITH_(ADOLC|PETSC|SLEPC|TRILINOS)|TRILINOS_WITH_[A-Z]+))\n"
    "/* #undef \\1 */\n" _text "${_text}")
  file(GENERATE OUTPUT ${_config} CONTENT "#pragma GCC system_header\n${_text}")
else()
  file(REMOVE ${_config})
endif()
