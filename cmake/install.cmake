# The install tree, and the package that find_package(voronaut) reads from it.
include(CMakePackageConfigHelpers)

get_property(voronaut_libraries GLOBAL PROPERTY VORONAUT_LIBRARIES)
install(TARGETS voronaut_determinism ${voronaut_libraries}
  EXPORT voronaut-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
set_target_properties(voronaut_determinism PROPERTIES EXPORT_NAME determinism)
if(TARGET voronaut_cli)
  install(TARGETS voronaut_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

foreach(folder environments dynamics planners benchmarks reports)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/voronaut FILES_MATCHING PATTERN "*.h")
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/benchmarks/suites ${PROJECT_SOURCE_DIR}/benchmarks/scenarios
  DESTINATION ${CMAKE_INSTALL_DATADIR}/voronaut FILES_MATCHING PATTERN "*.yaml")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/benchmarks/schema
  DESTINATION ${CMAKE_INSTALL_DATADIR}/voronaut)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/benchmarks/examples
  DESTINATION ${CMAKE_INSTALL_DATADIR}/voronaut)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/voronaut)
file(WRITE ${PROJECT_BINARY_DIR}/voronautConfig.cmake
  "include(CMakeFindDependencyMacro)\n"
  "include(\${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)\n"
  "include(\${CMAKE_CURRENT_LIST_DIR}/voronaut-targets.cmake)\n")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/voronautConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/voronautConfig.cmake
  ${PROJECT_BINARY_DIR}/voronautConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/dependencies.cmake
  DESTINATION ${package_dir})
install(EXPORT voronaut-targets NAMESPACE voronaut:: DESTINATION ${package_dir})
