# What `cmake --install` puts beside the program: scenes, headers, libraries and the CMake package that plugins are
# built with.
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/signorini)
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/signorini)

install(DIRECTORY problems/catalogue problems/families problems/populations problems/published problems/suites
        DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini/problems)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini)
install(FILES docs/skill/SKILL.md DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini)
install(DIRECTORY problems methods DESTINATION ${headers} COMPONENT development FILES_MATCHING PATTERN "*.hpp"
        PATTERN catalogue EXCLUDE PATTERN families EXCLUDE PATTERN populations EXCLUDE PATTERN published EXCLUDE
        PATTERN suites EXCLUDE)
install(FILES ${interface_version} DESTINATION ${headers}/methods/plugin COMPONENT development)

install(TARGETS signorini_build signorini_problems signorini_numerics signorini_methods EXPORT signorini
        COMPONENT development)
install(EXPORT signorini NAMESPACE signorini:: FILE signoriniTargets.cmake DESTINATION ${package}
        COMPONENT development)

configure_package_config_file(cmake/signoriniConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/signoriniConfig.cmake
                              INSTALL_DESTINATION ${package})
# Before version 1.0 any minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/signoriniConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/signoriniConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/signoriniConfigVersion.cmake
              cmake/FindSuiteSparse.cmake cmake/SignoriniPlugin.cmake
        DESTINATION ${package} COMPONENT development)
