# The public headers: what a user of a library includes, named here, and whatever those include in
# turn, so that an installed header always finds what it needs. All others may change any day.
#
# voronaut_public_headers(<source root> <result>): paths relative to the root, sorted.
cmake_policy(VERSION 3.22)

set(voronaut_entry_headers
  # scan_types, environments
  environments/random.h
  environments/scenario_files/scenario_reader.h
  environments/sensing/carmen_log.h
  environments/sensing/range_finder.h
  environments/sensing/ray_caster.h
  environments/shortest_path/shortest_path.h
  environments/world.h
  # dynamics
  dynamics/catalog.h
  dynamics/path.h
  dynamics/speed_profile.h
  dynamics/stopping.h
  dynamics/velocity_response.h
  # mapping
  planners/mapping/free_space/free_space.h
  planners/mapping/obstacle_base.h
  planners/mapping/virtual_obstacles.h
  # voronoi
  planners/voronoi/voronoi_router.h
  # planners: every planner, the problem it solves, and all of navigation
  planners/catalog/catalog.h
  planners/catalog/parameter_declaration.h
  planners/catalog/planner_insight.h
  planners/catalog/plugin.h
  planners/potential_field/potential_field.h
  planners/problem/belief_validity_checker.h
  planners/problem/fcl_validity_checker.h
  planners/problem/path_conversion.h
  planners/problem/problem.h
  planners/problem/solution_path.h
  planners/problem/swept_disc_motion_validator.h
  planners/reactive_voronoi/reactive_voronoi.h
  planners/voronoi/voronoi_roadmap.h
  planners/navigation/*.h
  # reports
  reports/export/mcap_log.h
  reports/export/ompl_log.h
  reports/export/planner_arena.h
  reports/figures/figure_file.h
  reports/page/html_report.h
  reports/page/mapping_report.h
  reports/run_record.h
  reports/store/store.h
  reports/summary/comparison.h
  reports/summary/summary.h
  reports/summary/summary_text.h
  reports/trace/trace_json.h
  # benchmarks
  benchmarks/cli/run_cli.h
  benchmarks/runner/run_trial.h
  benchmarks/runner/runner.h
  benchmarks/static_planning/static_problem.h
  benchmarks/suite/suite_trials.h)

function(voronaut_public_headers root result)
  set(open "")
  foreach(entry IN LISTS voronaut_entry_headers)
    file(GLOB found RELATIVE "${root}" "${root}/${entry}")
    if(NOT found)
      message(FATAL_ERROR "cmake/public_headers.cmake names ${entry}, which is not there")
    endif()
    list(APPEND open ${found})
  endforeach()
  set(public "")
  while(open)
    list(POP_FRONT open header)
    if(header IN_LIST public)
      continue()
    endif()
    list(APPEND public "${header}")
    file(STRINGS "${root}/${header}" includes REGEX "^#include \"voronaut/")
    foreach(line IN LISTS includes)
      string(REGEX REPLACE "^#include \"voronaut/([^\"]*)\".*" "\\1" other "${line}")
      list(APPEND open "${other}")
    endforeach()
  endwhile()
  list(SORT public)
  set(${result} "${public}" PARENT_SCOPE)
endfunction()
