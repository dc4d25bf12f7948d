# Floors and rooms of the house, held against the #include lines: cmake -DSOURCE_DIR=... -P layering.cmake
#
#   floor 3  benchmarks                      sees all
#   floor 2  planners                        sees what a sensor and a path are, nothing of the truth
#   floor 1  environments dynamics reports   never each other, but for what a path is
#
# A folder is a room. Directly in one of the five folders each file is a room of its own, its .h
# and .cpp together: what all of the folder stands on (dynamics/state.h) and its catalogue
# (dynamics/catalog.h) both live there. The includes between rooms form no circle, nor do the imports
# of the report's page, which has rooms of its own.

cmake_minimum_required(VERSION 3.22)

set(allowed_environments "environments/" "dynamics/path[.]h")
set(allowed_dynamics "dynamics/")
set(allowed_reports "reports/")
set(allowed_planners
  "planners/"
  "environments/shapes/(cell_grid|geometry|shapes|shape_index|convex_distance)[.]h"
  "environments/sensing/(scan|ray_caster)[.]h"
  "environments/config/nearest_name[.]h"
  "dynamics/(state|path|limits|footprint|stopping|speed_profile|heading|velocity_response|motion_response)[.]h")
set(allowed_benchmarks "benchmarks/" "planners/" "environments/" "dynamics/" "reports/")
# An engine is text: it sees no other room.
set(alone "benchmarks/engines")

# The room of a file that is given relative to the source root.
function(room_of path result)
  get_filename_component(folder "${path}" DIRECTORY)
  if(NOT folder MATCHES "/")
    string(REGEX REPLACE "[.][a-z]+$" "" folder "${path}")
  endif()
  set(${result} "${folder}" PARENT_SCOPE)
endfunction()

macro(remember name path)
  room_of("${name}" room)
  room_of("${path}" other)
  if(NOT other STREQUAL room)
    list(APPEND "sees_${room}" "${other}")
    list(APPEND "from_${room}_to_${other}" "${name} includes ${path}")
  endif()
endmacro()

set(broken "")
set(read 0)
set(rooms "")
foreach(folder environments dynamics reports planners benchmarks)
  file(GLOB_RECURSE sources "${SOURCE_DIR}/${folder}/*.h" "${SOURCE_DIR}/${folder}/*.cpp")
  # Examples are other people's programs: their own headers stand beside them.
  list(FILTER sources EXCLUDE REGEX "/benchmarks/examples/")
  foreach(source IN LISTS sources)
    math(EXPR read "${read} + 1")
    file(RELATIVE_PATH name "${SOURCE_DIR}" "${source}")
    room_of("${name}" room)
    list(APPEND rooms "${room}")
    file(STRINGS "${source}" includes REGEX "^#include \"")
    foreach(line IN LISTS includes)
      string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" path "${line}")
      set(fine FALSE)
      foreach(pattern IN LISTS allowed_${folder})
        if(path MATCHES "^voronaut/${pattern}")
          set(fine TRUE)
        endif()
      endforeach()
      if(room IN_LIST alone AND NOT path MATCHES "^voronaut/${room}/")
        set(fine FALSE)
      endif()
      if(NOT fine)
        list(APPEND broken "${name} includes ${path}")
      endif()
      string(REGEX REPLACE "^voronaut/" "" path "${path}")
      remember("${name}" "${path}")
    endforeach()
  endforeach()
endforeach()

file(GLOB_RECURSE sources "${SOURCE_DIR}/reports/web/*.ts")
foreach(source IN LISTS sources)
  math(EXPR read "${read} + 1")
  file(RELATIVE_PATH name "${SOURCE_DIR}" "${source}")
  get_filename_component(folder "${source}" DIRECTORY)
  room_of("${name}" room)
  list(APPEND rooms "${room}")
  file(STRINGS "${source}" imports REGEX "from \"[.]")
  foreach(line IN LISTS imports)
    string(REGEX REPLACE ".*from \"([^\"]*)\".*" "\\1" path "${line}")
    get_filename_component(path "${folder}/${path}.ts" ABSOLUTE)
    file(RELATIVE_PATH path "${SOURCE_DIR}" "${path}")
    remember("${name}" "${path}")
  endforeach()
endforeach()

if(read EQUAL 0)
  message(FATAL_ERROR "no sources found under ${SOURCE_DIR}")
endif()
if(broken)
  list(JOIN broken "\n  " text)
  message(FATAL_ERROR "includes that the floors do not allow:\n  ${text}")
endif()

# A room that sees none of those still there can leave, and so can one that none of them sees. Who
# stays stands in a circle, or between two.
list(REMOVE_DUPLICATES rooms)
set(staying "${rooms}")
set(left TRUE)
while(left)
  set(left FALSE)
  set(seen "")
  foreach(room IN LISTS staying)
    list(APPEND seen ${sees_${room}})
  endforeach()
  foreach(room IN LISTS staying)
    set(sees_staying FALSE)
    foreach(other IN LISTS "sees_${room}")
      if(other IN_LIST staying)
        set(sees_staying TRUE)
        break()
      endif()
    endforeach()
    if(NOT sees_staying OR NOT room IN_LIST seen)
      list(REMOVE_ITEM staying "${room}")
      set(left TRUE)
    endif()
  endforeach()
endwhile()
if(staying)
  set(text "")
  foreach(room IN LISTS staying)
    foreach(other IN LISTS staying)
      list(LENGTH "from_${room}_to_${other}" count)
      if(count)
        list(GET "from_${room}_to_${other}" 0 line)
        string(APPEND text "\n  ${room} includes ${other} ${count} times, as in: ${line}")
      endif()
    endforeach()
  endforeach()
  message(FATAL_ERROR "folders that include each other:${text}")
endif()
list(LENGTH rooms count)
message(STATUS "${read} files keep to their floors, ${count} rooms form no circle")
