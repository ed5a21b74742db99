# cmake --install: what goes where. Components (cmake --install build --component NAME), also the Debian packages':
#   dev    headers, CMake package, pkg-config file, the static libraries (laws' facts, batch evaluation, scenes)
#   c      the shared library of the C interface
#   solvers  the shared libraries of the C interfaces of solvers, runs and verification
#   tool   the program and the data that it reads
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/lubjoint)

# One export a target: who wants the headers alone need not have toml++, who wants C need not have Eigen.
install(DIRECTORY lib/include/lubjoint DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev FILES_MATCHING PATTERN *.hpp)
install(TARGETS lubjoint EXPORT headers COMPONENT dev)
if(TARGET lubjoint_c)
  install(FILES lib/c/lubjoint.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
  install(TARGETS lubjoint_c EXPORT c
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT c NAMELINK_COMPONENT dev)
  # Relative, so that an unpacked package works anywhere.
  file(RELATIVE_PATH relative_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" relative_prefix ${relative_prefix})
  configure_file(cmake/lubjoint-c.pc.in ${PROJECT_BINARY_DIR}/lubjoint-c.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/lubjoint-c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endif()
if(TARGET lubjoint_oracle_c)
  foreach(part oracle simulate verify)
    get_target_property(folder lubjoint_${part}_c LUBJOINT_HEADER_FOLDER)
    install(FILES ${folder}/lubjoint_${part}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
    install(TARGETS lubjoint_${part}_c EXPORT c_solvers
      LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT solvers NAMELINK_COMPONENT dev)
  endforeach()
  install(EXPORT c_solvers NAMESPACE lubjoint:: FILE lubjoint-c_solvers.cmake DESTINATION ${package_folder} COMPONENT dev)
endif()
foreach(part law_facts batch scene)
  if(TARGET lubjoint_${part})
    install(TARGETS lubjoint_${part} EXPORT ${part} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
  endif()
endforeach()
if(TARGET lubjoint_scene)
  install(TARGETS lubjoint_multibody lubjoint_scene_reader lubjoint_scene_search lubjoint_space lubjoint_space_reader EXPORT scene
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
endif()
foreach(part headers law_facts batch c scene)
  if(part STREQUAL "headers" OR TARGET lubjoint_${part})
    install(EXPORT ${part} NAMESPACE lubjoint:: FILE lubjoint-${part}.cmake DESTINATION ${package_folder} COMPONENT dev)
  endif()
endforeach()
configure_package_config_file(cmake/lubjointConfig.cmake.in ${PROJECT_BINARY_DIR}/lubjointConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
# Before 1.0 the second number says what breaks.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lubjointConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lubjointConfig.cmake ${PROJECT_BINARY_DIR}/lubjointConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT dev)

if(TARGET lubjoint_cli)
  get_property(programs GLOBAL PROPERTY lubjoint_programs)
  install(TARGETS ${programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tool)
  # Beside the program, ../share/lubjoint: it looks there (oracle/files/data_folder.hpp).
  install(DIRECTORY data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/lubjoint COMPONENT tool PATTERN figures EXCLUDE)
  install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT tool)
endif()
