# Compiles a program behind headers, without warnings but for those of the headers of others:
#   cmake -DCOMPILER=... -DINCLUDE=<directory> -DSYSTEM_INCLUDES=<directory>|... -DHEADERS=<file>|... -DPROGRAM=<file>
#     -P compile.cmake

set(command "${COMPILER}" -std=c++17 -Wall -Wextra -Werror -fsyntax-only "-I${INCLUDE}")
string(REPLACE "|" ";" SYSTEM_INCLUDES "${SYSTEM_INCLUDES}")
foreach(directory IN LISTS SYSTEM_INCLUDES)
  if(directory AND NOT directory STREQUAL "/usr/include")
    list(APPEND command "-isystem${directory}")
  endif()
endforeach()

string(REPLACE "|" ";" HEADERS "${HEADERS}")
foreach(header IN LISTS HEADERS)
  list(APPEND command -include "${header}")
endforeach()

execute_process(COMMAND ${command} "${PROGRAM}"
  RESULT_VARIABLE status ERROR_VARIABLE errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "It does not compile:\n${errors}")
endif()
