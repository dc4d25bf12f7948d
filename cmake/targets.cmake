# What every target of ours shares, and the one function that makes a library of a folder.

# "voronaut/planners/..." is the same path in the tree and installed: here a link to the source root.
set(VORONAUT_INCLUDE_ROOT "${PROJECT_BINARY_DIR}/include")
file(MAKE_DIRECTORY "${VORONAUT_INCLUDE_ROOT}")
if(NOT EXISTS "${VORONAUT_INCLUDE_ROOT}/voronaut")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}" "${VORONAUT_INCLUDE_ROOT}/voronaut" SYMBOLIC)
endif()

# The same results from every compiler and instruction set: no fused multiply-add, no vectorised
# reduction order. The alignment limits keep our Eigen types binary compatible with the packaged
# libfcl at any -march; a mix aborts or misses collisions. Exported: a consumer needs them too.
add_library(voronaut_determinism INTERFACE)
add_library(voronaut::determinism ALIAS voronaut_determinism)
target_compile_features(voronaut_determinism INTERFACE cxx_std_20)
target_compile_options(voronaut_determinism INTERFACE -ffp-contract=off)
target_compile_definitions(voronaut_determinism INTERFACE
  EIGEN_DONT_VECTORIZE EIGEN_MAX_ALIGN_BYTES=16 EIGEN_MAX_STATIC_ALIGN_BYTES=16)

add_library(voronaut_build_options INTERFACE)
target_compile_options(voronaut_build_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wconversion
  -Wno-sign-conversion
  # gcc 12 sees copies in std::string's operator+ that are not there (PR 105329), the last two where
  # the header is precompiled.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds>
  $<$<BOOL:${VORONAUT_WARNINGS_AS_ERRORS}>:-Werror>)
if(VORONAUT_NAN_INITIALISED_EIGEN)
  target_compile_definitions(voronaut_build_options INTERFACE EIGEN_INITIALIZE_MATRICES_BY_NAN)
endif()
if(VORONAUT_SANITIZERS)
  target_compile_options(voronaut_build_options INTERFACE
    -fsanitize=${VORONAUT_SANITIZERS} -fno-omit-frame-pointer)
  target_link_options(voronaut_build_options INTERFACE -fsanitize=${VORONAUT_SANITIZERS})
  # Under a sanitizer Eigen aligns by itself, and OMPL frees vectors of ours as plain memory.
  target_compile_definitions(voronaut_determinism INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
if(VORONAUT_COVERAGE)
  target_compile_options(voronaut_build_options INTERFACE --coverage)
  target_link_options(voronaut_build_options INTERFACE --coverage)
endif()

# What nearly every source reads, parsed once for all targets that are compiled alike:
# voronaut_precompile(<target> <set>), the set made by voronaut_precompiled_set(<set> <headers>).
set(voronaut_precompiled_of_all
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <fstream> <limits> <map> <memory>
  <optional> <span> <sstream> <stdexcept> <string> <string_view> <utility> <vector> <Eigen/Core>)

function(voronaut_precompiled_set set)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBRARIES" ${ARGN})
  set(nothing "${PROJECT_BINARY_DIR}/precompiled/${set}.cpp")
  if(NOT EXISTS "${nothing}")
    file(WRITE "${nothing}" "// Compiled so that the headers are.\n")
  endif()
  add_library(voronaut_precompiled_${set} OBJECT "${nothing}")
  set_target_properties(voronaut_precompiled_${set} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(voronaut_precompiled_${set} PRIVATE
    voronaut_determinism voronaut_build_options Eigen3::Eigen ${ARG_LIBRARIES})
  target_precompile_headers(voronaut_precompiled_${set} PRIVATE
    ${voronaut_precompiled_of_all} ${ARG_HEADERS})
endfunction()

# One folder is one translation unit where nobody edits it all day: what its headers instantiate is
# compiled once. A source with options of its own stays alone.
function(voronaut_unite target)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    if(IS_ABSOLUTE ${source})  # written by the build
      continue()
    endif()
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "of_${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A source that is included looks to gcc like a header that others include too.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

function(voronaut_precompile target set)
  target_precompile_headers(${target} REUSE_FROM voronaut_precompiled_${set})
endfunction()

voronaut_precompiled_set(library)
voronaut_precompiled_set(planner HEADERS <ompl/base/Planner.h> LIBRARIES voronaut_ompl)
set_target_properties(voronaut_precompiled_library voronaut_precompiled_planner PROPERTIES
  POSITION_INDEPENDENT_CODE ON)
voronaut_precompiled_set(program HEADERS <ompl/base/Planner.h> LIBRARIES voronaut_ompl)

# What is run once (a command line is read, a page is written) is optimised less: it would cost the
# compiler more seconds than all its runs take.
function(voronaut_cold_objects name set sources libraries)
  add_library(${name} OBJECT ${sources})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_EXTENSIONS OFF)
  target_include_directories(${name} PRIVATE ${VORONAUT_INCLUDE_ROOT})
  target_link_libraries(${name} PRIVATE voronaut_determinism voronaut_build_options ${libraries})
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
  voronaut_precompile(${name} ${set})
  if(VORONAUT_UNITED)
    voronaut_unite(${name})
  endif()
endfunction()

# voronaut_library(<folder> SOURCES ... [COLD <sources>] PUBLIC <libs> PRIVATE <libs>
#                  [PRECOMPILED <set>]) -> voronaut::<folder>
function(voronaut_library name)
  cmake_parse_arguments(ARG "" "PRECOMPILED" "SOURCES;COLD;PUBLIC;PRIVATE" ${ARGN})
  if(NOT ARG_PRECOMPILED)
    set(ARG_PRECOMPILED library)
  endif()
  add_library(voronaut_${name} STATIC ${ARG_SOURCES})
  if(ARG_COLD)
    voronaut_cold_objects(voronaut_${name}_cold ${ARG_PRECOMPILED} "${ARG_COLD}"
      "${ARG_PUBLIC};${ARG_PRIVATE}")
    target_sources(voronaut_${name} PRIVATE $<TARGET_OBJECTS:voronaut_${name}_cold>)
  endif()
  add_library(voronaut::${name} ALIAS voronaut_${name})
  set_target_properties(voronaut_${name} PROPERTIES
    EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON CXX_EXTENSIONS OFF)
  target_include_directories(voronaut_${name} PUBLIC
    $<BUILD_INTERFACE:${VORONAUT_INCLUDE_ROOT}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(voronaut_${name}
    PUBLIC voronaut_determinism ${ARG_PUBLIC}
    PRIVATE $<BUILD_INTERFACE:voronaut_build_options> ${ARG_PRIVATE})
  voronaut_precompile(voronaut_${name} ${ARG_PRECOMPILED})
  if(VORONAUT_UNITED)
    voronaut_unite(voronaut_${name})
  endif()
  set_property(GLOBAL APPEND PROPERTY VORONAUT_LIBRARIES voronaut_${name})
endfunction()

# voronaut_test(<folder> SOURCES ... LIBRARIES ... [PRECOMPILED <set>]): one GoogleTest program per
# folder of tests/. The set planner_test is for those that link OMPL.
function(voronaut_test name)
  cmake_parse_arguments(ARG "" "PRECOMPILED" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name}_tests ${ARG_SOURCES})
  set_target_properties(${name}_tests PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(${name}_tests PRIVATE
    ${ARG_LIBRARIES} voronaut_determinism voronaut_build_options Eigen3::Eigen GTest::gmock_main)
  if(NOT TARGET voronaut_precompiled_test)
    set(gtest <gmock/gmock.h> <gtest/gtest.h>)
    voronaut_precompiled_set(test HEADERS ${gtest} LIBRARIES GTest::gmock_main)
    voronaut_precompiled_set(planner_test HEADERS <ompl/base/Planner.h> ${gtest}
      LIBRARIES voronaut_ompl GTest::gmock_main)
  endif()
  if(NOT ARG_PRECOMPILED)
    set(ARG_PRECOMPILED test)
  endif()
  voronaut_precompile(${name}_tests ${ARG_PRECOMPILED})
  target_compile_definitions(${name}_tests PRIVATE
    VORONAUT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" VORONAUT_BINARY_DIR="${PROJECT_BINARY_DIR}")
  gtest_discover_tests(${name}_tests TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 600)
endfunction()
