# Installs the package built in BUILD_DIR into an empty PREFIX:
#   cmake -DBUILD_DIR=... -DPREFIX=... -P install.cmake

file(REMOVE_RECURSE "${PREFIX}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${PREFIX}"
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "The package does not install.")
endif()
if(EXISTS "${PREFIX}/include/CGAL/config.h")
  message(FATAL_ERROR "Headers of CGAL itself were installed.")
endif()
