# Floors of the house, held against the #include lines: cmake -DSOURCE_DIR=... -P layering.cmake
#
#   floor 3  benchmarks                      sees all
#   floor 2  planners                        sees what a sensor and a path are, nothing of the truth
#   floor 1  environments dynamics reports   never each other

set(allowed_environments "environments/")
set(allowed_dynamics "dynamics/")
set(allowed_reports "reports/")
set(allowed_planners
  "planners/"
  "environments/shapes/(geometry|shapes|shape_index)[.]h"
  "environments/sensing/(scan|ray_caster)[.]h"
  "environments/config/nearest_name[.]h"
  "dynamics/(state|path|limits|stopping|speed_profile|heading|velocity_response)[.]h")
set(allowed_benchmarks "benchmarks/" "planners/" "environments/" "dynamics/" "reports/")

set(broken "")
set(read 0)
foreach(folder environments dynamics reports planners benchmarks)
  file(GLOB_RECURSE sources "${SOURCE_DIR}/${folder}/*.h" "${SOURCE_DIR}/${folder}/*.cpp")
  # Examples are other people's programs: their own headers stand beside them.
  list(FILTER sources EXCLUDE REGEX "/benchmarks/examples/")
  foreach(source IN LISTS sources)
    math(EXPR read "${read} + 1")
    file(STRINGS "${source}" includes REGEX "^#include \"")
    foreach(line IN LISTS includes)
      string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" path "${line}")
      set(fine FALSE)
      foreach(pattern IN LISTS allowed_${folder})
        if(path MATCHES "^voronaut/${pattern}")
          set(fine TRUE)
        endif()
      endforeach()
      if(NOT fine)
        file(RELATIVE_PATH name "${SOURCE_DIR}" "${source}")
        list(APPEND broken "${name} includes ${path}")
      endif()
    endforeach()
  endforeach()
endforeach()

if(read EQUAL 0)
  message(FATAL_ERROR "no sources found under ${SOURCE_DIR}")
endif()
if(broken)
  list(JOIN broken "\n  " text)
  message(FATAL_ERROR "includes that the floors do not allow:\n  ${text}")
endif()
message(STATUS "${read} files keep to their floors")
