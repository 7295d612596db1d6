# Output of the programs about themselves, and the manual that is made of it.
if(TARGET manual)
  _contrecoup_register_test(manual
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/manual_test.py
      $<TARGET_FILE_DIR:blast> ${PROJECT_BINARY_DIR}/manual ${PROJECT_SOURCE_DIR})
endif()
