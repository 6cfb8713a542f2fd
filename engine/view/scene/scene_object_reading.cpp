#include "engine/view/scene/scene_object_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/place_reading.hpp"

namespace stepwire {
namespace {

using Keys = std::vector<std::string>;

const SceneKind* kind_of(const Node& node) {
  for (const SceneKind& kind : scene_kinds())
    if (node.find(kind.name)) return &kind;
  return nullptr;
}

bool is_hexadecimal(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
}

SceneColor named_color(const std::string& name) {
  return *std::ranges::find(scene_colors(), name, &SceneColor::name);
}

/// Reads one object; faults are gathered.
class ObjectReader {
 public:
  ObjectReader(const Entry& entry, const Names& names, std::vector<Formula>& formulas, Faults& faults)
      : node_(entry.value),
        subject_("scene." + entry.key),
        names_(names),
        formulas_(formulas),
        faults_(faults) {
    object_.name = entry.key;
  }

  std::optional<SceneObject> read() {
    if (!node_.is_map()) {
      fault(node_, "", "an object is a map: {ball: rig.position, color: blue}");
      return std::nullopt;
    }
    object_.kind = kind_of(node_);
    if (!object_.kind) {
      unknown_kind();
      return std::nullopt;
    }
    read_what_it_is(*node_.find(object_.kind->name));
    for (const Entry& entry : node_.entries)
      if (entry.key != object_.kind->name) read_key(entry);
    if (object_.colors.empty() || object_.colors.back().when)
      object_.colors.push_back({named_color(object_.kind->color), {}});
    check_needed();
    return std::move(object_);
  }

 private:
  void fault(const Node& node, const std::string& key, std::string message) {
    faults_.add(
        {{names_.file, node.mark}, subject_ + (key.empty() ? "" : "." + key), std::move(message), {}});
  }

  void unknown_kind() {
    Keys kinds;
    for (const SceneKind& kind : scene_kinds()) kinds.push_back(kind.name);
    for (const Entry& entry : node_.entries) {
      if (std::ranges::find(scene_object_keys(), entry.key, &SceneKey::name) != scene_object_keys().end())
        continue;
      return faults_.add(
          {{names_.file, entry.mark},
           subject_,
           fmt::format("there is no object '{}'{}", entry.key, nearest_or_all(entry.key, kinds, "there are")),
           {}});
    }
    fault(node_, "", fmt::format("an object says what it is: {}", fmt::join(kinds, ", ")));
  }

  void read_what_it_is(const Node& node) {
    if (object_.kind->name == "walls") return read_walls(node);
    if (object_.kind->name == "text") {
      object_.text = read_text(node, names_, subject_ + ".text", faults_);
      return;
    }
    const SceneKind& kind = *object_.kind;
    if (kind.most_points == 1) return read_point(node, kind.name);
    if (!node.is_list() || node.items.size() < kind.least_points || node.items.size() > kind.most_points)
      return fault(node, kind.name, fmt::format("'{}' is {}: [[0, 0], rig.position]", kind.name, kind.doc));
    for (const Node& item : node.items) read_point(item, kind.name);
  }

  void read_point(const Node& node, const std::string& key) {
    if (const auto point = read_plane_point(node, key)) object_.points.push_back(*point);
  }

  std::optional<std::array<FormulaIndex, 2>> read_plane_point(const Node& node, const std::string& key) {
    const std::size_t before = faults_.size();
    std::vector<Formula> place = read_place(node, names_, subject_ + "." + key, faults_);
    if (place.size() == 2) return std::array{add(std::move(place[0])), add(std::move(place[1]))};
    if (faults_.size() == before)
      fault(node, key,
            fmt::format("a point of a scene has two coordinates, [x, y], and this has {}", place.size()));
    return std::nullopt;
  }

  FormulaIndex add(Formula formula) {
    formulas_.push_back(std::move(formula));
    return formulas_.size() - 1;
  }

  std::optional<FormulaIndex> read_number(const Node& node, const std::string& key) {
    auto formula = read_length(node, names_, subject_ + "." + key, faults_);
    return formula ? std::optional(add(std::move(*formula))) : std::nullopt;
  }

  std::optional<FormulaIndex> read_condition(const Node& node, const std::string& key) {
    auto formula = read_formula(node, names_, subject_ + "." + key, faults_);
    return formula ? std::optional(add(std::move(*formula))) : std::nullopt;
  }

  void read_walls(const Node& node) {
    Keys known;
    const Outline* outline = nullptr;
    for (const NamedOutline& named : names_.outlines) {
      known.push_back(named.name);
      if (node.is_scalar() && named.name == node.text) outline = &named.outline;
    }
    if (!outline)
      return fault(node, "walls",
                   fmt::format("'{}' is no block with a boundary, as a Region is{}", node.text,
                               known.empty() ? "; this file has none"
                                             : nearest_or_all(node.text, known, "there are")));
    if (outline->space)
      return fault(node, "walls", fmt::format("'{}' lies in space, and a scene in the plane", node.text));
    for (const Outline::Line& line : outline->lines) {
      SceneWall& wall = object_.walls.emplace_back(SceneWall{{}, !line.endless});
      for (const Outline::Point& point : line.points) wall.points.push_back({point[0], point[1]});
    }
  }

  void read_key(const Entry& entry) {
    const std::string& key = entry.key;
    Keys known{object_.kind->name, "color", "when"};
    known.insert(known.end(), object_.kind->keys.begin(), object_.kind->keys.end());
    if (std::ranges::find(known, key) == known.end())
      return add_unknown_key(entry, known, fmt::format("an object '{}'", object_.kind->name), names_,
                             subject_, faults_);
    const Node& value = entry.value;
    if (key == "color") read_colors(value);
    if (key == "when") object_.when = read_condition(value, key);
    if (key == "radius") object_.radius = read_number(value, key);
    if (key == "width") object_.width = read_number(value, key);
    if (key == "size") object_.size = read_number(value, key);
    if (key == "at") read_point(value, key);
    if (key == "crossed") object_.crossed = color(value.text, value.mark, {}, key);
    if (key == "distance") object_.distance = read_number(value, key);
    if (key == "nearest") object_.nearest = read_plane_point(value, key);
  }

  std::optional<SceneColor> color(const std::string& text, Mark mark, const Keys& other,
                                  const std::string& key) {
    return read_scene_color(text, mark, other, names_, subject_ + "." + key, faults_);
  }

  void read_colors(const Node& node) {
    if (node.is_scalar()) {
      if (const auto one = color(node.text, node.mark, {}, "color")) object_.colors.push_back({*one, {}});
      return;
    }
    if (!node.is_map())
      return fault(node, "color",
                   "is a colour, or colours by condition: {red: map.distance > 0, else: blue}");
    for (const Entry& entry : node.entries) {
      if (entry.key == "else") continue;
      const auto one = color(entry.key, entry.mark, {"else"}, "color");
      const auto when = read_condition(entry.value, "color");
      if (one && when) object_.colors.push_back({*one, when});
    }
    if (const Node* otherwise = node.find("else"))
      if (const auto one = color(otherwise->text, otherwise->mark, {}, "color"))
        object_.colors.push_back({*one, {}});
  }

  void check_needed() {
    const std::string& kind = object_.kind->name;
    if (kind == "circle" && !node_.find("radius"))
      fault(node_, "", "a circle needs a radius: {circle: [$x, $y], radius: 20 mm}");
    if (kind == "text" && !node_.find("at"))
      fault(node_, "", "a text needs a place: {text: \"Follow the line\", at: [0 mm, 20 mm]}");
    if (!object_.crossed || object_.walls.empty()) return;
    // What a Region says of itself, unless the file says otherwise.
    Node own = *node_.find("walls");
    const std::string block = own.text;
    own.text = block + ".distance";
    if (!node_.find("distance")) object_.distance = read_number(own, "crossed");
    own.text = block + ".nearest";
    if (!node_.find("nearest") && object_.walls.size() > 1)
      object_.nearest = read_plane_point(own, "crossed");
  }

  const Node& node_;
  std::string subject_;
  const Names& names_;
  std::vector<Formula>& formulas_;
  Faults& faults_;
  SceneObject object_;
};

}  // namespace

std::optional<SceneObject> read_scene_object(const Entry& entry, const Names& names,
                                             std::vector<Formula>& formulas, Faults& faults) {
  return ObjectReader(entry, names, formulas, faults).read();
}

std::optional<SceneColor> read_scene_color(const std::string& text, Mark mark,
                                           const std::vector<std::string>& other, const Names& names,
                                           const std::string& subject, Faults& faults) {
  if (is_hexadecimal(text)) return SceneColor{"", text};
  Keys known;
  for (const SceneColor& color : scene_colors()) {
    if (color.name == text) return color;
    known.push_back(color.name);
  }
  known.insert(known.end(), other.begin(), other.end());
  faults.add({{names.file, mark},
              subject,
              fmt::format("there is no colour '{}'{}, or a colour as \"#rrggbb\"", text,
                          nearest_or_all(text, known, "there are")),
              {}});
  return std::nullopt;
}

}  // namespace stepwire
