# Writes OUTPUT, a header with a digest of the sources of each application, when
# one of them changed. Called at build time with -D SOURCE=... -D OUTPUT=...
#
# The sources of an application are those of the layer coupling that the header
# include/contrecoup/coupling/application/NAME_application.h leads to, by its includes,
# those of the sources that mirror it (x.cc, x_<topic>.cc), and so on; and all
# sources of the lower layers that these include, where headers do not lead to
# everything that is linked.

cmake_minimum_required(VERSION 3.25)

# headers_of(<file> <variable>): headers of the project that a file includes, as
# LAYER/NAME.h.
function(headers_of file result)
  file(STRINGS ${SOURCE}/${file} _lines REGEX "^#include <contrecoup/")
  list(TRANSFORM _lines REPLACE ".*<contrecoup/(.*)>.*" "\\1")
  set(${result} "${_lines}" PARENT_SCOPE)
endfunction()

# collect(<application> <variable>): all its sources.
function(collect application result)
  set(_waiting coupling/application/${application}_application.h)
  set(_files "")
  set(_layers "")
  while(_waiting)
    list(POP_FRONT _waiting _header)
    if(NOT _header MATCHES "^coupling/(.*)\\.h$")
      # A layer comes with the first of its headers.
      string(REGEX REPLACE "/.*" "" _layer ${_header})
      if(_layer IN_LIST _layers)
        continue()
      endif()
      list(APPEND _layers ${_layer})
      file(GLOB_RECURSE _found RELATIVE ${SOURCE}
        ${SOURCE}/include/contrecoup/${_layer}/*.h ${SOURCE}/source/${_layer}/*.cc)
    elseif(include/contrecoup/${_header} IN_LIST _files)
      continue()
    else()
      set(_stem ${SOURCE}/source/coupling/${CMAKE_MATCH_1})
      file(GLOB _found RELATIVE ${SOURCE}
        ${SOURCE}/include/contrecoup/${_header} ${_stem}.cc ${_stem}_*.cc)
    endif()
    list(APPEND _files ${_found})
    foreach(_file ${_found})
      headers_of(${_file} _more)
      list(APPEND _waiting ${_more})
    endforeach()
  endwhile()
  list(SORT _files)
  list(REMOVE_DUPLICATES _files)
  set(${result} "${_files}" PARENT_SCOPE)
endfunction()

set(_text "")
foreach(_name anatomy blast biomechanics)
  collect(${_name} _files)
  set(_sums "")
  foreach(_file ${_files})
    file(SHA1 ${SOURCE}/${_file} _sum)
    string(APPEND _sums "${_file} ${_sum}\n")
  endforeach()
  string(SHA1 _sum "${_sums}")
  string(APPEND _text "{\"${_name}\", \"${_sum}\"},\n")
endforeach()
# Unchanged when the digest is the same.
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${_text}" @ONLY)
