#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/environments/scenario_files/scenario_reader.h"

namespace voronaut {
namespace {

const std::string kBroken = std::string(VORONAUT_SOURCE_DIR) + "/tests/environments/broken/";

// The error as a user sees it who stands in the folder of the broken files.
std::string error_of(const std::string& file, const DataLocation& data = {}) {
  try {
    for (const ScenarioSpec& spec : read_scenarios(ConfigNode::read_file(kBroken + file), data))
      spec.instantiate(1);
  } catch (const ConfigError& error) {
    std::string text = error.what();
    for (auto at = text.find(kBroken); at != std::string::npos; at = text.find(kBroken))
      text.erase(at, kBroken.size());
    return text;
  }
  return "no error";
}

const std::map<std::string, std::string> kMessages = {
    {"bad_name.yaml",
     "bad_name.yaml:1: key 'name': expected a name of letters, digits and _-.+, at most 200, got "
     "'a/b'"},
    {"binary.yaml", "binary.yaml:1: not a text file (byte 0)"},
    {"bounds_inside_out.yaml",
     "bounds_inside_out.yaml:2: key 'bounds': expected [[xmin, ymin], [xmax, ymax]] with xmin < "
     "xmax and ymin < ymax"},
    {"bounds_too_wide.yaml",
     "bounds_too_wide.yaml:2: key 'bounds': expected bounds up to 20000 m each way, got 8 x 20004 "
     "m"},
    {"bow_tie.yaml",
     "bow_tie.yaml:4: key 'world.polygons[1]': has invalid self-intersections. A self-intersection "
     "point was found at (4, 2)"},
    {"box_inside_out.yaml",
     "box_inside_out.yaml:1: key 'world.boxes[0]': expected [xmin, ymin, xmax, ymax] with xmin < "
     "xmax and ymin < ymax"},
    {"circle_of_two.yaml",
     "circle_of_two.yaml:1: key 'world.circles[0]': expected [x, y, r], got a list of 2"},
    {"circles_not_nested.yaml",
     "circles_not_nested.yaml:1: key 'world.circles[0]': expected [x, y, r], got '4'"},
    {"csv_bad_number.yaml",
     "bad_number.csv:2: column 'y': expected a number from -100000 to 100000, got '2m'"},
    {"csv_empty.yaml", "empty.csv:1: the file is empty"},
    {"csv_missing_column.yaml", "missing_column.csv:1: column 'r' is missing; the header is 'x,y'"},
    {"csv_nan.yaml", "nan.csv:2: column 'x': expected a number from -100000 to 100000, got 'nan'"},
    {"csv_negative_radius.yaml",
     "negative_radius.csv:4: column 'r': expected a number from 0.001 to 1000, got '-0.5'"},
    {"csv_no_header.yaml", "no_header.csv:1: column 'x' is missing; the header is '1,2,0.5'"},
    {"csv_short_row.yaml", "short_row.csv:3: expected 3 fields, got 2"},
    {"dataset_limit.yaml",
     "dataset_limit.yaml:2: key 'limit': expected a whole number from 1 to 1000000, got '0'"},
    {"dataset_pick.yaml",
     "dataset_pick.yaml:1: key 'dataset': 'barn' lies in the data folder, which is not known: give "
     "--data DIR or set VORONAUT_DATA"},
    {"duplicate_key.yaml", "duplicate_key.yaml:5: key 'start': given twice (first in line 3)"},
    {"empty.yaml", "empty.yaml:1: the file is empty"},
    {"file_of_file.yaml",
     "file_of_file.yaml:1: key 'file': a scenario file cannot name another one"},
    {"flat_polygon.yaml",
     "flat_polygon.yaml:1: key 'world.polygons[0]': has spikes. A spike point was found with apex "
     "at (3, 3)"},
    {"generator_crossing.yaml",
     "generator_crossing.yaml:1: key 'generator.crossing': expected one of corners, sides, got "
     "'corner' (did you mean 'corners'?)"},
    {"generator_crowded.yaml",
     "generator_crowded.yaml:1: key 'generator': no 'forest' world in 2 draws from seed 1: 2 could "
     "not be placed, 0 have no path for a disc of radius 0.42 m"},
    {"generator_fraction.yaml",
     "generator_fraction.yaml:1: key 'generator.cells': expected a whole number from 2 to 100, got "
     "'8.5'"},
    {"generator_hopeless.yaml",
     "generator_hopeless.yaml:1: key 'generator': no 'walls' world in 3 draws from seed 1: 0 could "
     "not be placed, 3 have no path for a disc of radius 0.42 m"},
    {"generator_min_above_max.yaml",
     "generator_min_above_max.yaml:4: key 'generator.radius_max_m': radius_min_m (0.9) is above "
     "radius_max_m (0.6)"},
    {"generator_misspelt.yaml",
     "generator_misspelt.yaml:3: key 'generator.densty_per_m2': unknown key (allowed: name, "
     "density_per_m2, side_m, radius_min_m, radius_max_m, gap_min_m, outside_m, margin_m, "
     "crossing, admission_clearance_m, draws_max; did you mean 'density_per_m2'?)"},
    {"generator_range.yaml",
     "generator_range.yaml:1: key 'generator.density_per_m2': expected a number from 0 to 1, got "
     "'7'"},
    {"generator_with_start.yaml",
     "generator_with_start.yaml:2: key 'start': unknown key (allowed: generator, "
     "start_heading_rad, name, group, start_height_m, cruise_height_m, goal_tolerance_m, "
     "barn_length_m)"},
    {"goal_in_box.yaml", "goal_in_box.yaml:4: key 'goal': (8, 0) lies inside an obstacle"},
    {"goal_out_of_bounds.yaml",
     "goal_out_of_bounds.yaml:4: key 'goal': (8, 4.5) lies outside the bounds (-2, -4) to (10, 4)"},
    {"huge_coordinate.yaml",
     "huge_coordinate.yaml:1: key 'world.circles[0][0]': expected a number from -100000 to 100000, "
     "got '1e300'"},
    {"infinite_bounds.yaml",
     "infinite_bounds.yaml:2: key 'bounds[0][0]': expected a number from -100000 to 100000, got "
     "'-.inf'"},
    {"missing_bounds.yaml", "missing_bounds.yaml:1: key 'bounds': missing"},
    {"missing_csv.yaml", "missing_csv.yaml:1: key 'world_file': no file 'nowhere.csv'"},
    {"missing_start.yaml", "missing_start.yaml:1: key 'start': missing"},
    {"misspelt_key.yaml",
     "misspelt_key.yaml:5: key 'cruise_hieght_m': unknown key (allowed: world, bounds, start, "
     "goal, start_heading_rad, name, group, start_height_m, cruise_height_m, goal_tolerance_m, "
     "barn_length_m; did "
     "you mean 'cruise_height_m'?)"},
    {"misspelt_source.yaml",
     "misspelt_source.yaml:1: key 'wrold': unknown key (allowed: file, world, world_file, "
     "generator, dataset; did you mean 'world'?)"},
    {"nameless_generator.yaml", "nameless_generator.yaml:1: key 'generator.name': missing"},
    {"nan_start.yaml",
     "nan_start.yaml:3: key 'start[0]': expected a number from -100000 to 100000, got '.nan'"},
    {"negative_height.yaml",
     "negative_height.yaml:5: key 'start_height_m': expected a number from 0 to 100, got '-1'"},
    {"negative_radius.yaml",
     "negative_radius.yaml:4: key 'world.circles[1][2]': expected a number from 0.001 to 1000, got "
     "'-0.5'"},
    {"no_source.yaml",
     "no_source.yaml:1: expected one of the keys file, world, world_file, generator, dataset"},
    {"not_a_map.yaml", "not_a_map.yaml:1: expected a map of keys, got a list of 2"},
    {"not_yaml.yaml", "not_yaml.yaml:1: not valid YAML: end of sequence flow not found"},
    {"only_comment.yaml", "only_comment.yaml:1: the file is empty"},
    {"point_segment.yaml",
     "point_segment.yaml:1: key 'world.segments[0]': both ends are the same point"},
    {"quoted_number.yaml",
     "quoted_number.yaml:5: key 'cruise_height_m': expected a number from 0 to 100, got the text "
     "'1'"},
    {"second_document.yaml", "second_document.yaml:6: a second document; expected one"},
    {"start_in_obstacle.yaml",
     "start_in_obstacle.yaml:3: key 'start': (0, 0) lies inside an obstacle"},
    {"tab.yaml", "tab.yaml:2: not valid YAML: illegal block entry"},
    {"text_height.yaml",
     "text_height.yaml:5: key 'cruise_height_m': expected a number from 0 to 100, got 'high'"},
    {"three_numbers.yaml", "three_numbers.yaml:3: key 'start': expected [x, y], got a list of 3"},
    {"two_sources.yaml", "two_sources.yaml:2: key 'generator': cannot stand beside 'world'"},
    {"two_vertices.yaml",
     "two_vertices.yaml:1: key 'world.polygons[0]': has fewer than 3 vertices"},
    {"unit_forgotten.yaml",
     "unit_forgotten.yaml:5: key 'cruise_height': unknown key (allowed: world, bounds, start, "
     "goal, start_heading_rad, name, group, start_height_m, cruise_height_m, goal_tolerance_m, "
     "barn_length_m; did "
     "you mean 'cruise_height_m'?)"},
    {"unknown_dataset.yaml",
     "unknown_dataset.yaml:1: key 'dataset': expected one of barn, dodgedrone, movingai, mrpb, got "
     "'bern' (did you "
     "mean 'barn'?)"},
    {"unknown_generator.yaml",
     "unknown_generator.yaml:1: key 'generator.name': expected one of forest, paper_scene, "
     "goal_side, grid, walls, u_trap, bug_trap, spiral, rooms, maze, braided_maze, narrow_gaps, "
     "thin_posts, enclosed_goal, got 'forrest' (did you mean 'forest'?)"},
    {"unknown_shape.yaml",
     "unknown_shape.yaml:2: key 'world.circels': unknown key (allowed: circles, boxes, polygons, "
     "segments, wkt; did you mean 'circles'?)"},
    {"wrong_type_start.yaml", "wrong_type_start.yaml:3: key 'start': expected [x, y], got 'here'"},
    {"world_file_bad_cell.yaml",
     "files/bad_cell.map:6: column 2: expected one of .GS@OTW, got 'x'"},
    {"world_file_bad_pixel.yaml",
     "files/short_pgm.yaml:1: key 'image': files/short.pgm:3: expected 4 bytes of pixels, got 3"},
    {"world_file_bad_query.yaml",
     "files/bad_query.scen:2: goal x: expected a whole number from 0 to 2, got '3'"},
    {"world_file_format.yaml",
     "world_file_format.yaml:2: key 'format': expected one of movingai, ros_map, sdf, pathbench, "
     "ir_sim, dodgedrone, ompl_circles, ompl_env, wkt, circles_csv, got 'moving_ai' (did you mean "
     "'movingai'?)"},
    {"world_file_no_query.yaml",
     "world_file_no_query.yaml:2: key 'queries.pick[0]': no query '7' among the 1 of the file"},
    {"world_file_no_start.yaml", "world_file_no_start.yaml:1: key 'start': missing"},
    {"world_file_option.yaml",
     "world_file_option.yaml:2: key 'unknown': unknown key (allowed: world_file, format, bounds, "
     "start, goal, queries, start_heading_rad, cell_size_m, name, group, start_height_m, "
     "cruise_height_m, goal_tolerance_m, barn_length_m)"},
    {"world_file_start_and_queries.yaml",
     "world_file_start_and_queries.yaml:3: key 'start': cannot stand beside 'queries'"},
    {"world_file_unrecognised.yaml",
     "files/unknown.txt:1: not recognised as one of the formats movingai, ros_map, sdf, pathbench, "
     "ir_sim, dodgedrone, ompl_circles, ompl_env, wkt, circles_csv; name its format"},
    {"zero_radius.yaml",
     "zero_radius.yaml:1: key 'world.circles[0][2]': expected a number from 0.001 to 1000, got "
     "'0'"},
};

TEST(BrokenScenarios, AreRefusedWithOneExactLine) {
  for (const auto& [file, message] : kMessages) {
    const std::string error = error_of(file);
    EXPECT_EQ(error, message);
    EXPECT_EQ(error.find('\n'), std::string::npos) << file;
  }
}

TEST(BrokenScenarios, AreAllInTheTable) {
  for (const auto& entry : std::filesystem::directory_iterator(kBroken))
    if (entry.path().extension() == ".yaml") {
      EXPECT_EQ(kMessages.count(entry.path().filename().string()), 1U) << entry.path();
    }
}

}  // namespace
}  // namespace voronaut
