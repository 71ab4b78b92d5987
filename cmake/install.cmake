# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Installs the program, the library, its headers, and a CMake package:
#
#   find_package(Waker REQUIRED)        # before project(), as with deal.II
#   deal_ii_initialize_cached_variables()
#   project(my_soil CXX)
#   add_executable(my_soil main.cc)
#   deal_ii_setup_target(my_soil)       # deal.II's include paths are private
#   target_link_libraries(my_soil Waker::waker)

include(CMakePackageConfigHelpers)

set(WAKER_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Waker)

install(TARGETS waker RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS waker_library EXPORT WakerTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT WakerTargets NAMESPACE Waker:: DESTINATION ${WAKER_CONFIG_DIR})

install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/waker
                  ${CMAKE_BINARY_DIR}/include/waker
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h")

configure_package_config_file(
  ${CMAKE_SOURCE_DIR}/cmake/WakerConfig.cmake.in
  ${CMAKE_BINARY_DIR}/WakerConfig.cmake
  INSTALL_DESTINATION ${WAKER_CONFIG_DIR})
write_basic_package_version_file(
  ${CMAKE_BINARY_DIR}/WakerConfigVersion.cmake
  VERSION ${PROJECT_VERSION}
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/WakerConfig.cmake
              ${CMAKE_BINARY_DIR}/WakerConfigVersion.cmake
        DESTINATION ${WAKER_CONFIG_DIR})
