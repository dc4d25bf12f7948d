#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/dodgedrone.h"
#include "voronaut/environments/formats/ir_sim.h"
#include "voronaut/environments/formats/movingai.h"
#include "voronaut/environments/formats/ompl_worlds.h"
#include "voronaut/environments/formats/pathbench.h"
#include "voronaut/environments/formats/png_image.h"
#include "voronaut/environments/formats/ros_map.h"
#include "voronaut/environments/formats/sdf_world.h"
#include "voronaut/environments/formats/wkt.h"
#include "voronaut/environments/scenario_files/scenario_reader.h"

// A libFuzzer target for each reader of foreign files: the environment variable VORONAUT_READER
// names it. Whatever the bytes are, a reader returns a world or throws ConfigError.
namespace voronaut {
namespace {

using Reader = void (*)(const std::string& text);

// Asks every value of a file for what it could be.
void visit(const ConfigNode& node) {
  const auto ask = [](const auto& question) {
    try {
      question();
    } catch (const ConfigError&) {
    }
  };
  ask([&] { node.number(-1, 1); });
  ask([&] { node.whole_number(-1, 1); });
  ask([&] { node.flag(); });
  ask([&] { node.text(); });
  ask([&] { node.choice({"circle", "square"}); });
  ask([&] { node.numbers(2, "[x, y]"); });
  ask([&] { node.allow_only({"circles", "boxes"}); });
  if (node.is_list())
    for (const ConfigNode& item : node.items()) visit(item);
  if (node.is_map())
    for (const std::string& key : node.keys()) visit(node.child(key));
}

const std::map<std::string, Reader> kReaders = {
    {"movingai_map",
     [](const std::string& text) {
       const BlockedCells cells = parse_movingai_map(text, "f");
       world_of(cells, {cells.columns(), cells.rows(), 0.25});
     }},
    {"movingai_scen",
     [](const std::string& text) {
       parse_movingai_scen(text, "f", {4, 3, 0.25}, "m.map");
     }},
    {"pgm", [](const std::string& text) { parse_pgm(text, "f"); }},
    {"png",
     [](const std::string& text) {
       parse_png(text, "f", text.size() % 2 == 0 ? PngAlpha::channel : PngAlpha::unknown);
     }},
    {"ros_map",
     [](const std::string& text) { read_ros_map_description(ConfigNode::parse(text, "f")); }},
    {"sdf", [](const std::string& text) { parse_sdf_world(text, "f", {}); }},
    {"pathbench", [](const std::string& text) { read_pathbench(ConfigNode::parse(text, "f"), 1); }},
    {"ir_sim", [](const std::string& text) { read_ir_sim(ConfigNode::parse(text, "f")); }},
    {"dodgedrone", [](const std::string& text) { parse_dodgedrone(text, "f", {}); }},
    {"ompl_circles", [](const std::string& text) { parse_ompl_circles(text, "f"); }},
    {"ompl_circle_queries", [](const std::string& text) { parse_ompl_circle_queries(text, "f"); }},
    {"ompl_env", [](const std::string& text) { parse_ompl_environment(text, "f", 1); }},
    {"wkt", [](const std::string& text) { wkt_of(parse_wkt_lines(text, "f")); }},
    {"config", [](const std::string& text) { visit(ConfigNode::parse(text, "f")); }},
    {"scenario", [](const std::string& text) { read_scenarios(ConfigNode::parse(text, "f"), {}); }},
    {"circles_csv", [](const std::string& text) { parse_circles_csv(text, "f"); }},
};

Reader chosen_reader() {
  const char* name = std::getenv("VORONAUT_READER");
  return kReaders.at(name == nullptr ? "" : name);
}

}  // namespace
}  // namespace voronaut

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const voronaut::Reader reader = voronaut::chosen_reader();
  try {
    reader(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const voronaut::ConfigError&) {
  }
  return 0;
}
