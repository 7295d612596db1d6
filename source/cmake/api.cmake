# cmake --build build --target api: pages of the headers in build/api/html.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/api)
  set(DOXYGEN_STRIP_FROM_INC_PATH ${PROJECT_SOURCE_DIR}/include)
  set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
  set(DOXYGEN_QT_AUTOBRIEF YES)
  set(DOXYGEN_MULTILINE_CPP_IS_BRIEF YES)
  set(DOXYGEN_EXTRACT_ALL YES)
  set(DOXYGEN_SORT_MEMBER_DOCS NO)
  set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
  # A parameter whose name says it all needs no sentence.
  set(DOXYGEN_WARN_IF_INCOMPLETE_DOC NO)
  set(DOXYGEN_MACRO_EXPANSION YES)
  set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
  set(DOXYGEN_PREDEFINED "__attribute__(x)=")
  set(DOXYGEN_QUIET YES)
  set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/source/README.md)
  set(DOXYGEN_TOC_INCLUDE_HEADINGS 3)
  # Doxygen finds pictures by their names alone.
  set(DOXYGEN_IMAGE_PATH ${PROJECT_SOURCE_DIR}/parameter_files/blast/showcase)
  set(DOXYGEN_FILTER_PATTERNS "*.md=sed s:../parameter_files/blast/showcase/::")
  doxygen_add_docs(api ${PROJECT_SOURCE_DIR}/include
    ${PROJECT_SOURCE_DIR}/source/README.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md
    COMMENT "Pages of the headers, in build/api/html")
endif()

# cmake --build build --target house: its layers, drawn from the includes.
add_custom_target(house
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tests/checks/house.py
    ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/house.svg
  COMMENT "Layers and modules, in build/house.svg" USES_TERMINAL)
