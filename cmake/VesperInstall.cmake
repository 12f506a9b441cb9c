# Installation: libraries, headers and the CMake package `find_package(vesper)`, which gives the targets
# vesper::renderer, vesper::catalog_tools and one for each floor (vesper::base, vesper::astro, ...). Programs install
# themselves.
include(CMakePackageConfigHelpers)

set(VESPER_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/vesper)

get_property(vesper_installed GLOBAL PROPERTY VESPER_INSTALLED_TARGETS)
install(TARGETS ${vesper_installed} EXPORT vesper-targets)
install(EXPORT vesper-targets NAMESPACE vesper:: DESTINATION ${VESPER_PACKAGE_DIR})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/vesper-config.cmake.in ${PROJECT_BINARY_DIR}/vesper-config.cmake
                              INSTALL_DESTINATION ${VESPER_PACKAGE_DIR})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/vesper-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/vesper-config.cmake ${PROJECT_BINARY_DIR}/vesper-config-version.cmake
              ${CMAKE_CURRENT_LIST_DIR}/VesperDependencies.cmake DESTINATION ${VESPER_PACKAGE_DIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
