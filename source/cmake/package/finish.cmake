# Meets Debian's demands on files that other systems take as they are. CPack
# calls this between installation and packing, for all packages at once.
set(_root ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
set(_documents ${_root}/contrecoup/usr/share/doc/contrecoup)
configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright ${_documents}/copyright
  COPYONLY)
file(REMOVE ${_documents}/LICENSE)
file(RENAME ${_documents}/CHANGELOG.md ${_documents}/changelog)
string(TIMESTAMP _date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${_documents}/changelog.Debian "contrecoup \
(${CPACK_DEBIAN_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) \
unstable; urgency=medium

  * Its changes are in changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${_date}
")
file(GLOB_RECURSE _pages ${_root}/contrecoup/usr/share/man/*)
execute_process(COMMAND gzip -9n ${_pages} ${_documents}/changelog
  ${_documents}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
file(MAKE_DIRECTORY ${_root}/libcontrecoup-dev/usr/share/doc)
file(CREATE_LINK contrecoup
  ${_root}/libcontrecoup-dev/usr/share/doc/libcontrecoup-dev SYMBOLIC)
