# Build settings that every target of the project shares.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

include(GNUInstallDirs)

# Warnings of our own code, and no contraction: golden data and tests compare bits.
add_library(lubjoint_build_flags INTERFACE)
target_compile_options(lubjoint_build_flags INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -ffp-contract=off
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 warns of its own std::string (bug 105329)
  # It collects its garbage from 1 GB on, not from 0.13: a tenth less time, and a fifth more memory.
  "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=1000000>"
  $<$<BOOL:${LUBJOINT_WERROR}>:-Werror>)

# lubjoint_library(NAME SOURCES...): a static library of the project, NAME reachable as lubjoint::NAME.
function(lubjoint_library name)
  add_library(lubjoint_${name} STATIC ${ARGN})
  add_library(lubjoint::${name} ALIAS lubjoint_${name})
  target_link_libraries(lubjoint_${name} PRIVATE $<BUILD_INTERFACE:lubjoint_build_flags>)
endfunction()

# lubjoint_lightly_optimised(TARGET): for what spends its time in other libraries, or hardly any. It takes a quarter less
# time to compile.
function(lubjoint_lightly_optimised target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# lubjoint_precompiled(TARGET HEADERS...): what nearly every source of the target reads, read once. The sources include
# it all the same: presets dev and clang build without.
function(lubjoint_precompiled target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    # GCC 12 warns of its own std::string (bug 105329) once it comes from a precompiled header.
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow)
  endif()
endfunction()

# lubjoint_reuses_precompiled(TARGET OTHER): the other target's, where both are compiled alike.
function(lubjoint_reuses_precompiled target other)
  target_precompile_headers(${target} REUSE_FROM ${other})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow)
  endif()
endfunction()

# lubjoint_in_groups(TARGET [SIZE]): its sources are compiled several at a time, 8 by default. What they share is
# instantiated once: half the time. Not where each source is to be complete in itself, as with no header precompiled, or
# lies on a fast path.
function(lubjoint_in_groups target)
  set(size 8)
  if(ARGC GREATER 1)
    set(size ${ARGV1})
  endif()
  if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
  endif()
endfunction()

# lubjoint_c_interface(PART FOLDER): the shared library lubjoint_PART_c, whose header FOLDER/lubjoint_PART.h is all that
# another project sees of it: lubjoint::c_PART. SOVERSION: raised when a function changes or goes.
function(lubjoint_c_interface part folder)
  add_library(lubjoint::c_${part} ALIAS lubjoint_${part}_c)
  set_target_properties(lubjoint_${part}_c PROPERTIES
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON EXPORT_NAME c_${part}
    VERSION ${PROJECT_VERSION} SOVERSION 0 LUBJOINT_HEADER_FOLDER ${folder})
  target_include_directories(lubjoint_${part}_c PUBLIC
    $<BUILD_INTERFACE:${folder}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()

# lubjoint_report(TARGET): lightly optimised, and with one precompiled header for all of them.
function(lubjoint_report target)
  lubjoint_lightly_optimised(${target})
  lubjoint_in_groups(${target})
  if(target STREQUAL lubjoint_plot)
    lubjoint_precompiled(${target} <Eigen/Dense> <fmt/format.h> <nlohmann/json.hpp>)
  else()
    lubjoint_reuses_precompiled(${target} lubjoint_plot)
  endif()
endfunction()

# lubjoint_source_hash(FUNCTION HEADER FILES...): makes FUNCTION.cpp in the build folder, whose function of that name,
# declared in HEADER, tells the version and a checksum of the files (relative to the project).
function(lubjoint_source_hash function header)
  list(JOIN ARGN "\n" list)
  set(list_file ${CMAKE_CURRENT_BINARY_DIR}/${function}.txt)
  file(CONFIGURE OUTPUT ${list_file} CONTENT "${list}\n")
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE dependencies)
  set(script ${PROJECT_SOURCE_DIR}/cmake/SourceHash.cmake)
  add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp
    COMMAND ${CMAKE_COMMAND} -DLIST=${list_file} -DROOT=${PROJECT_SOURCE_DIR} -DVERSION=${PROJECT_VERSION}
      -DFUNCTION=${function} -DHEADER=${header} -DOUTPUT=${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp -P ${script}
    DEPENDS ${dependencies} ${list_file} ${script}
    VERBATIM)
endfunction()

# Odeint 1.74 copies steppers whose work arrays are not yet filled, and GCC sees it in these sources.
function(lubjoint_copies_steppers)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -Wno-maybe-uninitialized -Wno-uninitialized)
  endif()
endfunction()
