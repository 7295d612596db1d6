# Writes OUTPUT, a header with version and git revision, when they changed.
# Called at build time with -D SOURCE=... -D VERSION=... -D OUTPUT=...
find_program(GIT git)
set(_revision "")
if(GIT AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE _revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain
    --untracked-files=no
    OUTPUT_VARIABLE _changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(_revision STREQUAL "")
  set(_revision "unknown")
elseif(_changes)
  string(APPEND _revision "+")
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
