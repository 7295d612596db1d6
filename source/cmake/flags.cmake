# Compiler flags. Debian's deal.II hands "-g -O2 -D_FORTIFY_SOURCE=2 ..." to
# its users; what stands here comes after that and wins.

option(CONTRECOUP_NATIVE
  "Use every instruction of this processor (OFF: a portable binary)" ON)
option(CONTRECOUP_SANITIZE
  "Build with the address and undefined-behaviour sanitizers" OFF)

# OFF while one works on a test: a change then compiles its source alone.
option(CONTRECOUP_UNITY "Compile sources of tests several at once" ON)

# gcc 12 takes the undefined registers of its own AVX-512 intrinsics for
# uninitialised variables.
set(_common -Wall -Wextra -Wno-psabi -Wno-maybe-uninitialized
  -U_FORTIFY_SOURCE)
if(CONTRECOUP_NATIVE)
  list(APPEND _common -march=native)
endif()
# The sanitized build is made from Release, against deal.II's release library:
# Debug takes many times as long to compile and to run. Left out are the checks
# before each access by reference (null, alignment, object size, virtual
# tables): of them alone gcc took minutes for one kernel, and the address
# sanitizer stops at such accesses too, or the processor does, which wants
# lanes aligned. Left out too is poison on variables that went out of scope:
# with the thousands of temporaries of a kernel it took seven times as long to
# compile. Loops are not unrolled, for the same reason.
if(CONTRECOUP_SANITIZE)
  list(APPEND _common -fsanitize=address,undefined
    -fno-sanitize=null,alignment,object-size,vptr -fno-sanitize-recover=all
    -fno-sanitize-address-use-after-scope -fno-omit-frame-pointer
    -D_GLIBCXX_ASSERTIONS -fno-unroll-loops -fno-unroll-all-loops)
  add_link_options(-fsanitize=address,undefined)
  set(_release -O2 -g1)
else()
  set(_release -O3 -g0)
endif()
set(CONTRECOUP_COMPILE_OPTIONS
  ${_common}
  $<$<CONFIG:Release>:${_release} -fno-math-errno -fno-trapping-math
    -fno-stack-protector>
  $<$<CONFIG:Debug>:-O1 -g>)
