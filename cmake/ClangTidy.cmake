# Target tidy: clang-tidy (.clang-tidy) over the sources of lib and oracle, in the presets that Clang compiles. An hour of
# processor time; run-clang-tidy takes all cores.
find_program(LUBJOINT_RUN_CLANG_TIDY NAMES run-clang-tidy run-clang-tidy-14)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_EXPORT_COMPILE_COMMANDS AND LUBJOINT_RUN_CLANG_TIDY)
  add_custom_target(tidy COMMAND ${LUBJOINT_RUN_CLANG_TIDY} -quiet -p ${PROJECT_BINARY_DIR}
    "^${PROJECT_SOURCE_DIR}/(lib|oracle)/" USES_TERMINAL VERBATIM)
endif()
