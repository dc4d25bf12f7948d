# Third-party libraries, each behind one target with its headers as SYSTEM, so that our warnings
# speak of our code only. quickstart names the packages.

# Imported, so that the exported package names them only; this file is installed beside it and finds
# them again on the consumer's machine.
function(voronaut_system_library name)
  cmake_parse_arguments(ARG "" "" "INCLUDES;LIBRARIES" ${ARGN})
  if(TARGET ${name})
    return()
  endif()
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${name} SYSTEM INTERFACE ${ARG_INCLUDES})
  target_link_libraries(${name} INTERFACE ${ARG_LIBRARIES})
endfunction()

# voronaut_find(<target>): the package that brings this target. A component of the installed package
# finds what it links and nothing else.
macro(voronaut_find target)
  if("${target}" STREQUAL "Eigen3::Eigen")
    find_package(Eigen3 3.4 REQUIRED NO_MODULE)
  elseif("${target}" STREQUAL "voronaut_ompl")
    find_package(Boost 1.74 REQUIRED)
    find_package(ompl 1.5 REQUIRED)
    voronaut_system_library(voronaut_ompl
      INCLUDES ${OMPL_INCLUDE_DIRS} ${Boost_INCLUDE_DIRS} LIBRARIES ${OMPL_LIBRARIES} Boost::headers)
  elseif("${target}" STREQUAL "voronaut_fcl")
    find_path(VORONAUT_FCL_INCLUDE_DIR fcl/config.h REQUIRED)
    find_path(VORONAUT_CCD_INCLUDE_DIR ccd/ccd.h REQUIRED)
    find_library(VORONAUT_FCL_LIBRARY fcl REQUIRED)
    find_library(VORONAUT_CCD_LIBRARY ccd REQUIRED)
    voronaut_system_library(voronaut_fcl
      INCLUDES ${VORONAUT_FCL_INCLUDE_DIR} ${VORONAUT_CCD_INCLUDE_DIR}
      LIBRARIES ${VORONAUT_FCL_LIBRARY} ${VORONAUT_CCD_LIBRARY})
  elseif("${target}" STREQUAL "voronaut_sleef")
    find_path(VORONAUT_SLEEF_INCLUDE_DIR sleef.h REQUIRED)
    find_library(VORONAUT_SLEEF_LIBRARY sleef REQUIRED)
    voronaut_system_library(voronaut_sleef
      INCLUDES ${VORONAUT_SLEEF_INCLUDE_DIR} LIBRARIES ${VORONAUT_SLEEF_LIBRARY})
  elseif("${target}" STREQUAL "voronaut_tinyxml2")
    find_path(VORONAUT_TINYXML2_INCLUDE_DIR tinyxml2.h REQUIRED)
    find_library(VORONAUT_TINYXML2_LIBRARY tinyxml2 REQUIRED)
    voronaut_system_library(voronaut_tinyxml2
      INCLUDES ${VORONAUT_TINYXML2_INCLUDE_DIR} LIBRARIES ${VORONAUT_TINYXML2_LIBRARY})
  elseif("${target}" STREQUAL "Boost::headers")
    find_package(Boost 1.74 REQUIRED)
  elseif("${target}" STREQUAL "PNG::PNG")
    find_package(PNG REQUIRED)
  elseif("${target}" STREQUAL "ZLIB::ZLIB")
    find_package(ZLIB REQUIRED)
  elseif("${target}" STREQUAL "SQLite::SQLite3")
    find_package(SQLite3 REQUIRED)
  elseif("${target}" STREQUAL "OpenSSL::Crypto")
    find_package(OpenSSL REQUIRED COMPONENTS Crypto)
  elseif("${target}" STREQUAL "yaml-cpp")
    find_package(yaml-cpp REQUIRED)
  elseif("${target}" STREQUAL "nlohmann_json::nlohmann_json")
    find_package(nlohmann_json REQUIRED)
  elseif("${target}" STREQUAL "CLI11::CLI11")
    find_package(CLI11 REQUIRED)
  elseif("${target}" STREQUAL "voronaut_rsvg")
    # Optional: figures as PNG. Only its headers: it is loaded when the first one is drawn.
    find_package(PkgConfig QUIET)
    if(PKG_CONFIG_FOUND)
      pkg_check_modules(VORONAUT_RSVG QUIET "librsvg-2.0>=2.52" cairo-png)
    endif()
    voronaut_system_library(voronaut_rsvg
      INCLUDES ${VORONAUT_RSVG_INCLUDE_DIRS} LIBRARIES ${CMAKE_DL_LIBS})
  else()
    message(FATAL_ERROR "cmake/dependencies.cmake knows no package that brings '${target}'")
  endif()
endmacro()
