# Debian packages of what is installed, by `cpack -G DEB` (cmake/release/packages.sh): signorini, the program with its scenes;
# signorini-dev, what plugins are built with; signorini-mpi, the companion of `reduce --mpi`, where it was built.
set(CPACK_COMPONENTS_ALL program development)
if(TARGET signorini-reduce-mpi)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
endif()
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME signorini)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME signorini-dev)
set(CPACK_DEBIAN_MPI_PACKAGE_NAME signorini-mpi)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  install(FILES cmake/release/copyright CHANGELOG.md COMPONENT ${component}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  if(NOT component STREQUAL program)
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "signorini (= ${PROJECT_VERSION})")
  endif()
endforeach()

set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_CONTACT "The signorini developers <signorini@localhost>")  # to be filled in: docs/releasing.md
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/release/debian_files.cmake)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS OFF)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "curl, gnuplot-nox, libopenblas0-serial")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "python3, signorini-dev")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "The program: methods behind one interface that compute periodic motions of
structures that meet a stop, a search for coexisting motions, frequency responses
with unstable parts, and a benchmark that judges every answer by an exact motion.")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "What a method outside the tree is built with: headers, static libraries and the
CMake package signorini.")
set(CPACK_DEBIAN_MPI_DESCRIPTION "The companion of \"signorini reduce --mpi\": the factors of a large structure are
shared between MPI processes, by MUMPS.")
# What cmake/signoriniConfig.cmake.in finds; Eigen's version is asked for exactly.
string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", cmake, pkgconf, libeigen3-dev, libfmt-dev, libsundials-dev, liblapack-dev, "
       "libblas-dev | libblas.so, libfftw3-dev, libtomlplusplus-dev, libsuitesparse-dev")
include(CPack)
