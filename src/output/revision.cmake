# cmake -D SOURCE=<repository> -D HEADER=<file to write> -P revision.cmake
# Writes the git revision of SOURCE as a C++ constant; touches HEADER only when it changed, so that nothing is rebuilt in vain.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(revision "unknown")
endif()
set(text "#pragma once\n\nnamespace talus::output {\ninline constexpr const char* revision = \"${revision}\";\n}\n")
if(EXISTS ${HEADER})
  file(READ ${HEADER} old)
endif()
if(NOT "${old}" STREQUAL "${text}")
  file(WRITE ${HEADER} "${text}")
endif()
