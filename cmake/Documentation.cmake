# Target doc: the library's interface as HTML, in doc/html of the build folder. A name without a comment is an error.
find_package(Doxygen 1.9 QUIET)
set(doc_test "Documentation: every public name of the library has its comment")
if(DOXYGEN_FOUND)
  set(DOXYGEN_PROJECT_BRIEF ${PROJECT_DESCRIPTION})
  set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/doc)
  set(DOXYGEN_INPUT_FILTER "sh ${PROJECT_SOURCE_DIR}/cmake/doxygen_filter.sh")
  set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR}/lib/include ${PROJECT_SOURCE_DIR}/lib/c
    ${PROJECT_SOURCE_DIR}/oracle/c ${PROJECT_SOURCE_DIR}/oracle/verify/c)
  set(DOXYGEN_EXCLUDE_SYMBOLS "*::detail" "LUBJOINT_*_" LUBJOINT_API)
  set(DOXYGEN_PREDEFINED "LUBJOINT_API=" "LUBJOINT_ORACLE_API=" "LUBJOINT_SIMULATE_API=" "LUBJOINT_VERIFY_API=")
  set(DOXYGEN_MACRO_EXPANSION YES)
  set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
  set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
  set(DOXYGEN_DISTRIBUTE_GROUP_DOC YES)
  set(DOXYGEN_BUILTIN_STL_SUPPORT YES)
  set(DOXYGEN_HAVE_DOT NO)
  set(DOXYGEN_USE_MATHJAX NO)  # formulas are written in Unicode: they read alike here and in the source
  set(DOXYGEN_QUIET YES)
  set(DOXYGEN_WARN_IF_INCOMPLETE_DOC NO)
  set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
  doxygen_add_docs(doc ${PROJECT_SOURCE_DIR}/lib/include ${PROJECT_SOURCE_DIR}/lib/c/lubjoint.h
    ${PROJECT_SOURCE_DIR}/oracle/c/lubjoint_oracle.h ${PROJECT_SOURCE_DIR}/oracle/c/lubjoint_simulate.h
    ${PROJECT_SOURCE_DIR}/oracle/verify/c/lubjoint_verify.h
    COMMENT "Documentation of the library")
  set(doc_command Doxygen::doxygen ${CMAKE_CURRENT_BINARY_DIR}/Doxyfile.doc)
else()
  set(doc_command sh -c "echo 'skipped: doxygen is not installed'; exit 77")
endif()
if(LUBJOINT_TESTS)
  add_test(NAME ${doc_test} COMMAND ${doc_command})
  set_tests_properties(${doc_test} PROPERTIES SKIP_RETURN_CODE 77)
endif()
