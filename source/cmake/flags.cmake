# Compiler flags. Debian's deal.II hands "-g -O2 -D_FORTIFY_SOURCE=2 ..." to
# its users; what stands here comes after that and wins.

option(CONTRECOUP_NATIVE
  "Use every instruction of this processor (OFF: a portable binary)" ON)
option(CONTRECOUP_SANITIZE
  "Build with the address and undefined-behaviour sanitizers" OFF)

# gcc 12 takes the undefined registers of its own AVX-512 intrinsics for
# uninitialised variables.
set(_common -Wall -Wextra -Wno-psabi -Wno-maybe-uninitialized
  -U_FORTIFY_SOURCE)
if(CONTRECOUP_NATIVE)
  list(APPEND _common -march=native)
endif()
if(CONTRECOUP_SANITIZE)
  list(APPEND _common -fsanitize=address,undefined -fno-sanitize-recover=all)
  add_link_options(-fsanitize=address,undefined)
endif()
set(CONTRECOUP_COMPILE_OPTIONS
  ${_common}
  $<$<CONFIG:Release>:-O3 -g0 -fno-math-errno -fno-trapping-math
    -fno-stack-protector>
  $<$<CONFIG:Debug>:-O1 -g>)
