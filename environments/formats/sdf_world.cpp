#include "voronaut/environments/formats/sdf_world.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/sdf_body.h"

namespace voronaut {
namespace {

const char* const kNestedInclude = "an included model in a model cannot be read";

// "model://ground_plane", or the end of a web address, in the <uri> of the <world>'s <include>.
void check_include(const XmlElement& include) {
  const auto uri = include.child("uri");
  const std::string address = uri ? uri->text() : "";
  std::string name = address.substr(address.find_last_of('/') + 1);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return c == ' ' ? '_' : static_cast<char>(std::tolower(c));
  });
  if (name != "sun" && name != "ground_plane")
    throw include.error("an included model cannot be read: " + in_quotes(address) +
                        " (allowed: sun, ground_plane)");
}

// What the <state> of a world says about one model, and those of a model about one of its own.
std::optional<XmlElement> named_child(const std::optional<XmlElement>& state, const char* kind,
                                      const std::string& name) {
  if (!state) return std::nullopt;
  for (const XmlElement& child : state->children(kind))
    if (child.attribute("name") == name) return child;
  return std::nullopt;
}

// A pose that a <state> gives is one in the world.
std::optional<SdfPose> state_pose(const std::optional<XmlElement>& state) {
  if (!state || !state->child("pose")) return std::nullopt;
  if (const std::string frame = pose_frame(*state); !frame.empty() && frame != "world")
    throw state->error("a pose relative to " + in_quotes(frame) + " cannot be read in a state");
  return read_pose(*state);
}

Eigen::Vector3d state_scale(const std::optional<XmlElement>& state) {
  const auto scale = state ? state->child("scale") : std::nullopt;
  if (!scale) return Eigen::Vector3d::Ones();
  const auto numbers = read_numbers(*scale, "scale", 3);
  return {numbers[0], numbers[1], numbers[2]};
}

class WorldReader {
 public:
  WorldReader(const XmlElement& world, const ForeignOptions& options)
      : element_(world), options_(options) {
    for (const XmlElement& state : world.children("state")) take_state(state);
  }

  ForeignWorld read() {
    for (const XmlElement& child : element_.children()) {
      if (child.name() == "population") throw child.error("a <population> cannot be read");
      if (child.name() == "include") check_include(child);
      if (child.name() == "model") add_world_model(child);
    }
    for (const XmlElement& model : inserted_) add_world_model(model);
    return std::move(read_);
  }

 private:
  void take_state(const XmlElement& state) {
    for (const XmlElement& model : state.children("model"))
      states_.insert_or_assign(model.attribute("name"), model);
    for (const XmlElement& insertions : state.children("insertions"))
      for (const XmlElement& model : insertions.children("model")) inserted_.push_back(model);
    for (const XmlElement& deletions : state.children("deletions"))
      for (const XmlElement& name : deletions.children("name")) deleted_.insert(name.text());
  }

  void add_world_model(const XmlElement& model) {
    const std::string name = model.attribute("name");
    if (deleted_.contains(name) || !has_body(model)) return;
    const auto found = states_.find(name);
    const auto state =
        found == states_.end() ? std::nullopt : std::optional<XmlElement>(found->second);
    const auto moved = state_pose(state);
    add_model(model, moved ? *moved : SdfFrames(element_).pose_of(model), state);
  }

  // Also says what cannot be read of it. The pose of a model without bodies need not be readable.
  static bool has_body(const XmlElement& model) {
    bool found = false;
    for (const XmlElement& include : model.children("include")) throw include.error(kNestedInclude);
    for (const XmlElement& link : model.children("link"))
      for (const XmlElement& collision : link.children("collision"))
        if (read_body(collision, Eigen::Vector3d::Ones())) found = true;
    for (const XmlElement& inner : model.children("model")) found = has_body(inner) || found;
    return found;
  }

  void add_model(const XmlElement& model, const SdfPose& T_world_model,
                 const std::optional<XmlElement>& state) {
    const SdfFrames frames(model);
    const Eigen::Vector3d scale = state_scale(state);
    const auto add_body = [&](const XmlElement& link, const XmlElement& collision) {
      const auto body = read_body(collision, scale);
      if (!body) return;
      const auto moved = state_pose(named_child(state, "link", link.attribute("name")));
      const std::string base = pose_frame(collision);
      const SdfPose T_world_base = !base.empty()
                                       ? T_world_model * frames.frame(base, collision)
                                       : (moved ? *moved : T_world_model * frames.pose_of(link));
      add_footprint(*body, T_world_base * read_pose(collision), options_, collision, read_);
    };
    for (const XmlElement& link : model.children("link"))
      for (const XmlElement& collision : link.children("collision")) add_body(link, collision);
    for (const XmlElement& inner : model.children("model")) {
      if (!has_body(inner)) continue;
      const auto inner_state = named_child(state, "model", inner.attribute("name"));
      const auto moved = state_pose(inner_state);
      add_model(inner, moved ? *moved : T_world_model * frames.pose_of(inner), inner_state);
    }
  }

  XmlElement element_;
  ForeignOptions options_;
  std::map<std::string, XmlElement> states_;  // of models by their names; the last one counts
  std::vector<XmlElement> inserted_;
  std::set<std::string> deleted_;
  ForeignWorld read_;
};

}  // namespace

ForeignWorld parse_sdf_world(std::string_view text, const std::string& file,
                             const ForeignOptions& options) {
  const XmlDocument document(text, file);
  const auto root = document.root();
  const auto worlds =
      root && root->name() == "sdf" ? root->children("world") : std::vector<XmlElement>{};
  if (worlds.empty()) throw ConfigError(file, 1, "", "no <world> in <sdf>");
  if (worlds.size() > 1) throw worlds[1].error("a second <world>; expected one");
  return WorldReader(worlds[0], options).read();
}

}  // namespace voronaut
