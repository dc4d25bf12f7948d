#include "voronaut/environments/formats/sdf_world.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/xml_scanner.h"
#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

// What a simulator leaves of a tilt when it saves a world: 0.1 mm in 1 m of height.
constexpr double kUpright_rad = 1e-4;

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

// Where an element stands in its parent. Only an obstacle's pose must be one that can be read.
struct Pose {
  Vec2 p = Vec2::Zero();
  Vec2 heading = Vec2::UnitX();
  std::optional<ConfigError> unreadable;

  Pose of(const Pose& inner) const {
    return {p + turned(inner.p, heading), turned(inner.heading, heading),
            unreadable ? unreadable : inner.unreadable};
  }
};

// `parent` is the frame in which the element stands if the pose names none.
Pose read_pose(const XmlScanner& xml, std::string_view parent) {
  Pose pose;
  for (const char* name : {"relative_to", "frame"}) {  // its name since SDF 1.7, and before
    const auto frame = xml.attribute(name);
    if (frame && !frame->empty() && *frame != parent)
      pose.unreadable = xml.error("a pose relative to " + in_quotes(*frame) + " cannot be read");
  }
  const auto numbers = numbers_of(xml, "pose", 6);
  const auto unit = xml.attribute("degrees");
  const double radians = unit == "true" || unit == "1" ? std::numbers::pi / 180 : 1;
  if (std::abs(numbers[3]) * radians > kUpright_rad ||
      std::abs(numbers[4]) * radians > kUpright_rad)
    pose.unreadable = xml.error("a tilted obstacle cannot be read");
  pose.p = {numbers[0], numbers[1]};
  pose.heading = unit_vector(numbers[5] * radians);
  return pose;
}

struct Collision {
  Pose in_link;
  std::string kind;  // of its geometry; empty: none
  std::optional<double> radius_m;
  std::optional<Vec2> box_size_m;
};

struct Link {
  Pose in_model;
  std::vector<Collision> collisions;
};

struct Model {
  Pose in_world;
  std::vector<Link> links;
};

void check_kind(const XmlScanner& xml, const std::string& kind) {
  constexpr std::array kKinds = {"cylinder", "box", "sphere", "plane", "empty"};
  if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end())
    throw xml.error("a collision of <" + kind +
                    "> cannot be read (allowed: cylinder, box, sphere, plane)");
}

// An element that starts while its model is open; `path` leads to it from the model.
void start_element(const XmlScanner& xml, const std::string& path, Model& model) {
  constexpr std::string_view kGeometry = "link/collision/geometry/";
  if (path == "model" || path == "include") throw xml.error("a model in a model cannot be read");
  if (path == "link") model.links.emplace_back();
  if (path == "link/collision") model.links.back().collisions.emplace_back();
  if (path.starts_with(kGeometry) && path.find('/', kGeometry.size()) == std::string::npos) {
    const std::string kind = path.substr(kGeometry.size());
    check_kind(xml, kind);
    model.links.back().collisions.back().kind = kind;
  }
}

void end_collision(const XmlScanner& xml, const Collision& collision) {
  const bool round = collision.kind == "cylinder" || collision.kind == "sphere";
  if ((round && !collision.radius_m) || (collision.kind == "box" && !collision.box_size_m))
    throw xml.error("a <" + collision.kind + "> without its " + (round ? "radius" : "size"));
}

// An element that ends while its model is open.
void end_element(const XmlScanner& xml, const std::string& path, Model& model) {
  if (path == "pose") model.in_world = read_pose(xml, "world");
  if (!path.starts_with("link/")) return;
  Link& link = model.links.back();
  if (path == "link/pose") link.in_model = read_pose(xml, "__model__");
  if (path != "link/collision" && !path.starts_with("link/collision/")) return;
  Collision& collision = link.collisions.back();
  if (path == "link/collision") end_collision(xml, collision);
  if (path == "link/collision/pose") collision.in_link = read_pose(xml, "");
  if (path == "link/collision/geometry/cylinder/radius" ||
      path == "link/collision/geometry/sphere/radius")
    collision.radius_m = size_of(xml, numbers_of(xml, "radius", 1)[0]);
  if (path == "link/collision/geometry/box/size") {
    const auto size = numbers_of(xml, "size", 3);
    collision.box_size_m = Vec2(size_of(xml, size[0]), size_of(xml, size[1]));
  }
  if (path == "link/collision/geometry/plane/normal") {
    const auto normal = numbers_of(xml, "normal", 3);
    if (std::abs(normal[0]) + std::abs(normal[1]) > kUpright_rad * std::abs(normal[2]))
      throw xml.error("a plane that is not level cannot be read");
  }
}

void add_model(const Model& model, Shapes& shapes) {
  for (const Link& link : model.links) {
    for (const Collision& collision : link.collisions) {
      if (collision.kind.empty() || collision.kind == "empty") continue;
      const Pose at = model.in_world.of(link.in_model).of(collision.in_link);
      if (at.unreadable) throw ConfigError(*at.unreadable);
      if (collision.radius_m) shapes.circles.push_back({at.p, *collision.radius_m});
      if (collision.box_size_m)
        shapes.polygons.push_back(
            box(at.p, collision.box_size_m->x(), collision.box_size_m->y(), at.heading));
    }
  }
}

// The end of an <uri> of the <world>'s <include>: "model://ground_plane", or of a web address.
void check_include(const XmlScanner& xml, const std::string& uri) {
  std::string name = uri.substr(uri.find_last_of('/') + 1);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return c == ' ' ? '_' : static_cast<char>(std::tolower(c));
  });
  if (name != "sun" && name != "ground_plane")
    throw xml.error("an included model cannot be read: " + in_quotes(uri) +
                    " (allowed: sun, ground_plane)");
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

// What has been read of the <world>.
class WorldReader {
 public:
  // For each start and end of an element.
  void take(const XmlScanner& xml) {
    constexpr std::string_view kInModel = "sdf/world/model/";
    const std::string& path = xml.path();
    if (path.starts_with(kInModel)) {
      const std::string in_model = path.substr(kInModel.size());
      xml.starts() ? start_element(xml, in_model, model_) : end_element(xml, in_model, model_);
    } else if (xml.starts()) {
      start(xml, path);
    } else {
      end(xml, path);
    }
  }

  bool found_world() const { return found_world_; }
  const Shapes& shapes() const { return shapes_; }

 private:
  void start(const XmlScanner& xml, const std::string& path) {
    if (path == "sdf/world" && found_world_) throw xml.error("a second <world>; expected one");
    if (path == "sdf/world") found_world_ = true;
    if (path == "sdf/world/population") throw xml.error("a <population> cannot be read");
    if (path == "sdf/world/include") uri_.clear();
    if (path == "sdf/world/model") model_ = {};
  }

  void end(const XmlScanner& xml, const std::string& path) {
    if (path == "sdf/world/model") add_model(model_, shapes_);
    if (path == "sdf/world/include/uri") uri_ = trimmed(xml.text());
    if (path == "sdf/world/include") check_include(xml, uri_);
  }

  bool found_world_ = false;
  Model model_;      // that is open
  std::string uri_;  // of the <include> that is open
  Shapes shapes_;
};

}  // namespace

ForeignWorld parse_sdf_world(std::string_view text, const std::string& file) {
  XmlScanner xml(text, file);
  WorldReader reader;
  while (xml.next()) reader.take(xml);
  if (!reader.found_world()) throw xml.error("no <world> in <sdf>");
  ForeignWorld world;
  world.shapes = reader.shapes();
  return world;
}

}  // namespace voronaut
