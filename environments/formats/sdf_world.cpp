#include "voronaut/environments/formats/sdf_world.h"

#include <cmath>
#include <optional>
#include <vector>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/xml_scanner.h"
#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

std::vector<double> numbers_of(const XmlScanner& xml, std::string_view what, std::size_t count) {
  std::vector<double> numbers;
  for (std::string_view rest = xml.text(); !rest.empty();) {
    const std::size_t begin = rest.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) break;
    rest.remove_prefix(begin);
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
    rest.remove_prefix(word.size());
    const auto value = parse_number(word);
    if (!value || std::abs(*value) > kFarthestCoordinate)
      throw xml.error(std::string(what) + ": expected a number, got " + in_quotes(word));
    numbers.push_back(*value);
  }
  if (numbers.size() != count)
    throw xml.error(std::string(what) + ": expected " + std::to_string(count) + " numbers, got " +
                    std::to_string(numbers.size()));
  return numbers;
}

double size_of(const XmlScanner& xml, double value) {
  if (value < kSmallestRadius || value > kLargestRadius)
    throw xml.error("expected a size from " + number_text(kSmallestRadius) + " to " +
                    number_text(kLargestRadius) + ", got " + number_text(value));
  return value;
}

// What has been read of the model that is open.
struct Model {
  Vec2 p = Vec2::Zero();
  Vec2 heading = Vec2::UnitX();
  std::optional<double> cylinder_radius_m;
  std::optional<Vec2> box_size_m;
};

void read_pose(const XmlScanner& xml, bool of_model, Model& model) {
  const auto pose = numbers_of(xml, "pose", 6);
  if (!of_model) {
    for (const double value : pose)
      if (value != 0) throw xml.error("a pose inside a model is not supported");
    return;
  }
  if (pose[3] != 0 || pose[4] != 0) throw xml.error("a tilted model is not supported");
  model.p = {pose[0], pose[1]};
  model.heading = unit_vector(pose[5]);
}

// An element that ends while its model is open; `path` leads to it from the model.
void read_element(const XmlScanner& xml, const std::string& path, Model& model) {
  if (path == "pose" || path == "link/pose" || path == "link/collision/pose")
    read_pose(xml, path == "pose", model);
  else if (path == "link/collision/geometry/cylinder/radius")
    model.cylinder_radius_m = size_of(xml, numbers_of(xml, "radius", 1)[0]);
  else if (path == "link/collision/geometry/box/size") {
    const auto size = numbers_of(xml, "size", 3);
    model.box_size_m = Vec2(size_of(xml, size[0]), size_of(xml, size[1]));
  }
}

void add_model(const Model& model, Shapes& shapes) {
  if (model.cylinder_radius_m) shapes.circles.push_back({model.p, *model.cylinder_radius_m});
  if (model.box_size_m)
    shapes.polygons.push_back(
        box(model.p, model.box_size_m->x(), model.box_size_m->y(), model.heading));
}

}  // namespace

ForeignWorld parse_sdf_world(std::string_view text, const std::string& file) {
  const std::string kModel = "sdf/world/model";
  XmlScanner xml(text, file);
  ForeignWorld world;
  Model model;
  bool found_world = false;
  while (xml.next()) {
    const std::string& path = xml.path();
    if (xml.starts()) {
      if (path == "sdf/world") found_world = true;
      if (path == kModel) model = {};
    } else if (path == kModel) {
      add_model(model, world.shapes);
    } else if (path.starts_with(kModel + "/")) {
      read_element(xml, path.substr(kModel.size() + 1), model);
    }
  }
  if (!found_world) throw xml.error("no <world> in <sdf>");
  return world;
}

}  // namespace voronaut
