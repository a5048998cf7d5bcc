# Compiles edits.cpp as it is, which must succeed, and with -DEDIT, when each line that is marked must be refused:
#   cmake -DCOMPILER=... -DINCLUDES=<directory>|... -P compile.cmake

set(file "${CMAKE_CURRENT_LIST_DIR}/edits.cpp")
set(message "The connectivity of a CGAL::Compact_surface_mesh is fixed. Edit a CGAL::Surface_mesh, and construct")

set(command "${COMPILER}" -std=c++17 -fsyntax-only)
string(REPLACE "|" ";" INCLUDES "${INCLUDES}")
foreach(directory IN LISTS INCLUDES)
  if(directory)
    list(APPEND command -I "${directory}")
  endif()
endforeach()

execute_process(COMMAND ${command} "${file}"
  RESULT_VARIABLE status ERROR_VARIABLE errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "Without edits it does not compile:\n${errors}")
endif()

execute_process(COMMAND ${command} -DEDIT "${file}"
  RESULT_VARIABLE status ERROR_VARIABLE errors)
if(status EQUAL 0)
  message(FATAL_ERROR "Edits compile.")
endif()
string(FIND "${errors}" "${message}" found)
if(found EQUAL -1)
  message(FATAL_ERROR "The message is missing:\n${errors}")
endif()

file(STRINGS "${file}" lines)
set(number 0)
set(number_of_refusals 0)
foreach(line IN LISTS lines)
  math(EXPR number "${number} + 1")
  if(line MATCHES "// refused$")
    math(EXPR number_of_refusals "${number_of_refusals} + 1")
    if(NOT errors MATCHES "edits.cpp:${number}:")
      message(FATAL_ERROR "It compiles: ${line}")
    endif()
  endif()
endforeach()
string(REGEX MATCHALL "static assertion failed|static_assert failed" assertions "${errors}")
list(LENGTH assertions number_of_assertions)
if(number_of_refusals LESS 20 OR NOT number_of_assertions EQUAL number_of_refusals)
  message(FATAL_ERROR "${number_of_refusals} lines, ${number_of_assertions} messages:\n${errors}")
endif()
