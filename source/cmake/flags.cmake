# Compiler flags. Debian's deal.II hands "-g -O2 -D_FORTIFY_SOURCE=2 ..." to its
# users; the flags here come later and override them.

set(CONTRECOUP_PROCESSOR native CACHE STRING
  "Processor to compile for, as -march names it; empty: any of its kind")
option(CONTRECOUP_PACKAGE
  "Build for a package of several processors, see package.cmake" OFF)
option(CONTRECOUP_SANITIZE
  "Build with the address and undefined-behaviour sanitizers" OFF)

# OFF for work on the code: a change then compiles only its source.
option(CONTRECOUP_UNITY "Compile the sources of a folder at once" ON)

# gcc 12 mistakes the undefined registers of its AVX-512 intrinsics for
# uninitialised variables. Debian's deal.II hands flags of gcc to clang, too.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(_false_alarms -Wno-maybe-uninitialized)
  if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    list(APPEND _false_alarms -Wno-uninitialized)
  endif()
else()
  set(_false_alarms -Wno-unknown-warning-option
    -Wno-ignored-optimization-argument)
endif()
set(_common -Wall -Wextra -Wno-psabi ${_false_alarms} -U_FORTIFY_SOURCE
  # Programs share the precompiled header of the libraries, and so their -fPIC.
  -fPIC -fno-semantic-interposition)
if(CONTRECOUP_PROCESSOR)
  list(APPEND _common -march=${CONTRECOUP_PROCESSOR})
endif()
# gcc 14 spends a third of its time on sources such as those of gas/adaptation to
# schedule instructions for the newest processors, and a tenth on the loops that
# Debian's deal.II has unrolled, which are of use in kernels alone.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  if(CONTRECOUP_PROCESSOR STREQUAL "native" AND
      NOT CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    list(APPEND _common -mtune=generic)
  endif()
  list(APPEND _common -fno-unroll-loops -fno-unroll-all-loops)
endif()
if(CONTRECOUP_PACKAGE)
  # Paths of this machine are of no use on others.
  list(APPEND _common -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)
endif()
# The sanitized build is made from Release, against deal.II's release library:
# Debug takes many times as long to compile and to run. The checks before each
# access by reference (null, alignment, object size, virtual tables) are off:
# they alone took gcc minutes for one kernel, and the address sanitizer, or the
# processor, which needs aligned lanes, stops at such accesses too. Poison on
# variables that went out of scope is off as well: with the thousands of
# temporaries of a kernel it made compiling seven times as long.
if(CONTRECOUP_SANITIZE)
  list(APPEND _common -fsanitize=address,undefined
    -fno-sanitize=null,alignment,object-size,vptr -fno-sanitize-recover=all
    -fno-sanitize-address-use-after-scope -fno-omit-frame-pointer
    -D_GLIBCXX_ASSERTIONS)
  add_link_options(-fsanitize=address,undefined)
  set(_release -O2 -g1)
else()
  set(_release -O2 -g0)
  set(CONTRECOUP_KERNEL_OPTIONS -O3)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND CONTRECOUP_KERNEL_OPTIONS -funroll-loops -funroll-all-loops)
  endif()
endif()
set(CONTRECOUP_COLD_OPTIONS -O1)
# gcc 14 takes the precompiled header, made with -O2, with this flag alone.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND
    CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13 AND
    CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  list(APPEND CONTRECOUP_COLD_OPTIONS -mvzeroupper)
endif()
set(CONTRECOUP_COMPILE_OPTIONS
  ${_common}
  $<$<CONFIG:Release>:${_release} -fno-math-errno -fno-trapping-math
    -fno-stack-protector>
  $<$<CONFIG:Debug>:-O1 -g>)
