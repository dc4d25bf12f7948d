# Debian packages: cpack -G DEB in the build folder writes voronaut (the program) and
# libvoronaut-dev (headers, static libraries, examples).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME voronaut)
set(CPACK_PACKAGE_CONTACT "The Voronaut authors <voronaut@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME voronaut)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "${PROJECT_DESCRIPTION}")
# Which packages hold the libraries that the program links is dpkg-shlibdeps' knowledge.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
if(VORONAUT_RSVG_FOUND)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "librsvg2-2")  # loaded, not linked
endif()

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libvoronaut-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${PROJECT_DESCRIPTION}: headers and libraries")
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libompl-dev, libfcl-dev, libccd-dev, libeigen3-dev, libboost-dev, libboost-filesystem-dev, "
  "libboost-serialization-dev, libboost-system-dev, libsleef-dev, libsqlite3-dev, zlib1g-dev, "
  "libssl-dev, libyaml-cpp-dev, librsvg2-dev")
include(CPack)
