# Installation of the libraries, of the kernel's headers, and of the package file that find_package(Plumbline) reads.
# Movable: no file of it knows where it was built or installed.
include(CMakePackageConfigHelpers)

# Fixed-size Eigen types cross the border between kernel and plug-in. Their alignment must not depend on the
# instruction set that either side was compiled for.
target_compile_definitions(plumbline_kernel PUBLIC EIGEN_MAX_ALIGN_BYTES=32)

set_target_properties(plumbline_kernel plumbline_reference PROPERTIES INSTALL_RPATH "$ORIGIN")

install(TARGETS plumbline_kernel EXPORT PlumblineTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumbline)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/kernel ${PROJECT_BINARY_DIR}/generated/kernel DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumbline
  FILES_MATCHING PATTERN *.hpp)
install(TARGETS plumbline_reference LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_SKIP)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Plumbline)
install(EXPORT PlumblineTargets NAMESPACE Plumbline:: DESTINATION ${package})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/PlumblineConfig.cmake.in
  ${PROJECT_BINARY_DIR}/PlumblineConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/PlumblineConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/PlumblineConfig.cmake ${PROJECT_BINARY_DIR}/PlumblineConfigVersion.cmake
  DESTINATION ${package})
