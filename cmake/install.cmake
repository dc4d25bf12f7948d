# The install tree: the program with its suites (component runtime), and headers, libraries and the
# package that find_package(voronaut) reads (component development).
include(CMakePackageConfigHelpers)

install(TARGETS voronaut_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/benchmarks/suites ${PROJECT_SOURCE_DIR}/benchmarks/scenarios
  DESTINATION ${CMAKE_INSTALL_DATADIR}/voronaut COMPONENT runtime FILES_MATCHING PATTERN "*.yaml")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/benchmarks/schema
  DESTINATION ${CMAKE_INSTALL_DATADIR}/voronaut COMPONENT runtime)

# Completion in shells, printed by the program when it was built (benchmarks/CMakeLists.txt).
set(completions ${PROJECT_BINARY_DIR}/completions)
install(FILES ${completions}/bash/voronaut
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT runtime)
install(FILES ${completions}/zsh/_voronaut
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT runtime)
install(FILES ${completions}/fish/voronaut.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT runtime)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/benchmarks/examples
  DESTINATION ${CMAKE_INSTALL_DATADIR}/voronaut COMPONENT development)

# Looked for when it is installed: which headers are public follows from what the sources include.
install(CODE "
  include(\"${PROJECT_SOURCE_DIR}/cmake/public_headers.cmake\")
  voronaut_public_headers(\"${PROJECT_SOURCE_DIR}\" headers)
  foreach(header IN LISTS headers)
    get_filename_component(folder \"\${header}\" DIRECTORY)
    file(INSTALL TYPE FILE FILES \"${PROJECT_SOURCE_DIR}/\${header}\"
      DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/voronaut/\${folder}\")
  endforeach()" COMPONENT development)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/voronaut)
function(voronaut_export target component)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component})
  install(TARGETS ${target} EXPORT voronaut-${component}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT voronaut-${component}-targets NAMESPACE voronaut:: DESTINATION ${package_dir}
    COMPONENT development)
endfunction()

# A component is a library; it requires those of ours that it links, and finds the others.
voronaut_export(voronaut_determinism determinism)
get_property(libraries GLOBAL PROPERTY VORONAUT_LIBRARIES)
string(REGEX REPLACE "voronaut_" "" components "${libraries}")
set(voronaut_component_lists "set(voronaut_components ${components})\n")
foreach(library IN LISTS libraries)
  string(REGEX REPLACE "^voronaut_" "" component "${library}")
  voronaut_export(${library} ${component})
  get_target_property(linked ${library} INTERFACE_LINK_LIBRARIES)
  set(requires "")
  set(finds "")
  foreach(other IN LISTS linked)
    string(REGEX REPLACE "^\\$<LINK_ONLY:([^<>]*)>$" "\\1" other "${other}")
    if(other IN_LIST libraries)
      string(REGEX REPLACE "^voronaut_" "" other "${other}")
      list(APPEND requires ${other})
    elseif(NOT other STREQUAL "voronaut_determinism" AND NOT other MATCHES "[$]<" AND TARGET ${other})
      list(APPEND finds ${other})
    endif()
  endforeach()
  string(APPEND voronaut_component_lists
    "set(voronaut_${component}_requires ${requires})\nset(voronaut_${component}_finds ${finds})\n")
endforeach()
string(REPLACE ";" " " voronaut_component_lists "${voronaut_component_lists}")

configure_file(${PROJECT_SOURCE_DIR}/cmake/voronautConfig.cmake.in
  ${PROJECT_BINARY_DIR}/voronautConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/voronautConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/voronautConfig.cmake
  ${PROJECT_BINARY_DIR}/voronautConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/dependencies.cmake
  DESTINATION ${package_dir} COMPONENT development)
