# Writes OUTPUT, a header with version and git revision, when they changed.
# Called at build time with -D SOURCE=... -D VERSION=... -D OUTPUT=...

# Revision as git reports it, with "+" when files differ from it.
function(_ask_git revision)
  find_program(GIT git)
  if(NOT GIT OR NOT EXISTS ${SOURCE}/.git)
    return()
  endif()
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE _revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain
    --untracked-files=no
    OUTPUT_VARIABLE _changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(_revision AND _changes)
    string(APPEND _revision "+")
  endif()
  set(${revision} "${_revision}" PARENT_SCOPE)
endfunction()

# Without git: the revision that .git/HEAD names, with "?", since changes are
# not checked.
function(_read_head revision)
  if(NOT EXISTS ${SOURCE}/.git/HEAD)
    return()
  endif()
  file(READ ${SOURCE}/.git/HEAD _head)
  if(_head MATCHES "^ref: ([^\n]*)")
    set(_name "${CMAKE_MATCH_1}")
    set(_head "")
    if(EXISTS ${SOURCE}/.git/${_name})
      file(READ ${SOURCE}/.git/${_name} _head)
    elseif(EXISTS ${SOURCE}/.git/packed-refs)
      file(STRINGS ${SOURCE}/.git/packed-refs _lines)
      foreach(_line IN LISTS _lines)
        if(_line MATCHES "^([0-9a-f]+) (.*)$" AND CMAKE_MATCH_2 STREQUAL _name)
          set(_head "${CMAKE_MATCH_1}")
        endif()
      endforeach()
    endif()
  endif()
  string(STRIP "${_head}" _head)
  if(_head MATCHES "^[0-9a-f]+$")
    string(SUBSTRING "${CMAKE_MATCH_0}" 0 12 _head)
    set(${revision} "${_head}?" PARENT_SCOPE)
  endif()
endfunction()

set(_revision "")
_ask_git(_revision)
if(_revision STREQUAL "")
  _read_head(_revision)
endif()
if(_revision STREQUAL "")
  set(_revision "unknown")
endif()
set(_text "#define CONTRECOUP_VERSION \"${VERSION}\"
#define CONTRECOUP_REVISION \"${_revision}\"
")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} _old)
endif()
if(NOT "${_text}" STREQUAL "${_old}")
  file(WRITE ${OUTPUT} "${_text}")
endif()
