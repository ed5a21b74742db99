# cpack -G DEB: four Debian packages, one an install component (cmake/Install.cmake).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lubjoint)
set(CPACK_PACKAGE_VENDOR lubjoint)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "lubjoint maintainers <lubjoint@localhost>" CACHE STRING
  "Who answers for the Debian packages: Name <address>")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_DEV_PACKAGE_NAME liblubjoint-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libboost-dev (>= 1.74)")
set(CPACK_DEBIAN_DEV_DESCRIPTION "Headers: force laws, joints and mechanisms as C++20 templates;
scenes as a static library; what CMake and pkg-config need to find them.")

if(TARGET lubjoint_scene)
  set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "libtomlplusplus-dev (>= 3.3)")
endif()

if(TARGET lubjoint_c)
  list(APPEND CPACK_COMPONENTS_ALL c)
  get_target_property(soversion lubjoint_c SOVERSION)
  set(CPACK_DEBIAN_C_PACKAGE_NAME liblubjoint-c${soversion})
  set(CPACK_DEBIAN_C_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_C_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_C_DESCRIPTION "Shared library with a plain C interface:
film forces, contact forces and moments over arrays.")
  string(APPEND CPACK_DEBIAN_DEV_PACKAGE_DEPENDS ", ${CPACK_DEBIAN_C_PACKAGE_NAME} (= ${PROJECT_VERSION})")
endif()

if(TARGET lubjoint_oracle_c)
  list(APPEND CPACK_COMPONENTS_ALL solvers)
  get_target_property(soversion lubjoint_oracle_c SOVERSION)
  set(CPACK_DEBIAN_SOLVERS_PACKAGE_NAME liblubjoint-solvers-c${soversion})
  set(CPACK_DEBIAN_SOLVERS_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_SOLVERS_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_SOLVERS_DESCRIPTION "Shared libraries with plain C interfaces:
solvers of Reynolds' equation, runs of scene files, verification of programs.")
  string(APPEND CPACK_DEBIAN_DEV_PACKAGE_DEPENDS ", ${CPACK_DEBIAN_SOLVERS_PACKAGE_NAME} (= ${PROJECT_VERSION})")
endif()

if(TARGET lubjoint_cli)
  list(APPEND CPACK_COMPONENTS_ALL tool)
  set(CPACK_DEBIAN_TOOL_PACKAGE_NAME lubjoint)
  set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_TOOL_PACKAGE_RECOMMENDS gnuplot-nox)
  set(CPACK_DEBIAN_TOOL_DESCRIPTION "The program: forces, trajectories, equilibria;
the paper's examples reproduced; a check of other implementations that names
their mistakes. With scenes and golden data.")
endif()
include(CPack)
