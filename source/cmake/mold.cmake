# Debian 13's deal.II asks for the linker mold but does not depend on its
# package: without it the usual linker is taken.
find_program(CONTRECOUP_MOLD mold)
mark_as_advanced(CONTRECOUP_MOLD)
if(NOT CONTRECOUP_MOLD)
  string(REPLACE "-fuse-ld=mold" "" DEAL_II_LINKER_FLAGS
    "${DEAL_II_LINKER_FLAGS}")
  if(TARGET dealii::dealii)
    get_target_property(_options dealii::dealii INTERFACE_LINK_OPTIONS)
    if(_options)
      list(REMOVE_ITEM _options -fuse-ld=mold)
      set_target_properties(dealii::dealii PROPERTIES
        INTERFACE_LINK_OPTIONS "${_options}")
    endif()
  endif()
endif()
