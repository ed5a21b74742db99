# cmake -DSOURCE=… -DOUTPUT=….cpp -P Revision.cmake: the revision of a checkout as a string, empty if it is none.
find_package(Git QUIET)
set(revision "")
if(Git_FOUND)
  execute_process(COMMAND "${GIT_EXECUTABLE}" rev-parse --show-toplevel WORKING_DIRECTORY "${SOURCE}"
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(top STREQUAL SOURCE)  # and not a checkout around an unpacked archive
    execute_process(COMMAND "${GIT_EXECUTABLE}" rev-parse --short=12 HEAD WORKING_DIRECTORY "${SOURCE}"
      OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
endif()
file(WRITE "${OUTPUT}" "// Made by cmake/Revision.cmake.
#include \"oracle/page/resources.hpp\"

namespace lubjoint::reports::page {

std::string_view revision() { return \"${revision}\"; }

}  // namespace lubjoint::reports::page
")
