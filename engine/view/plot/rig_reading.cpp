#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/place_reading.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/plot/rig.hpp"

namespace stepwire {
namespace {

using Keys = std::vector<std::string>;

/// "anchors.1" of a block: a row of one of its parameters.
std::optional<RigPoint> row_of(const DiagramBlock& block, const std::string& rest) {
  const std::size_t dot = rest.find('.');
  const ParameterSpec* parameter = block.type().parameter(rest.substr(0, dot));
  if (!parameter || dot == std::string::npos) return std::nullopt;
  const Value value = parameter->get(block.block.get());
  const auto* rows = std::get_if<Eigen::MatrixXd>(&value.content);
  const long row = std::strtol(rest.c_str() + dot + 1, nullptr, 10);
  if (!rows || row < 1 || row > rows->rows() || rows->cols() > static_cast<Eigen::Index>(max_coordinates))
    return std::nullopt;
  RigPoint point;
  for (Eigen::Index i = 0; i < rows->cols(); ++i) point.emplace_back((*rows)(row - 1, i));
  return point;
}

/// Reads one rig; faults are gathered.
class RigReader {
 public:
  RigReader(const Node& node, const SymbolTable& names, Faults& faults)
      : node_(node), names_(names), faults_(faults) {}

  Rig read() {
    rig_.mark = node_.mark;
    if (const Node* points = node_.find("points")) read_points(*points);
    const Node* elements = node_.find("elements");
    if (!elements || !elements->is_list() || elements->items.empty())
      fault(elements ? elements->mark : node_.mark, "elements",
            "a plot 'rig' needs 'elements', a list such as [{damper: [anchor, pin]}, {ground: anchor}]");
    else
      for (const Node& element : elements->items) read_element(element);
    read_view();
    if (const Node* where = node_.find("where"))
      rig_.where = read_formula(*where, names_, "figure.where", faults_);
    rig_.recording = common_recording(formulas(), names_, node_, "figure", faults_);
    return std::move(rig_);
  }

 private:
  void fault(const Mark& mark, const std::string& key, std::string message) {
    faults_.add({{names_.file, mark}, "figure." + key, std::move(message), {}});
  }

  void read_view() {
    rig_.z_up = word("up", {"y", "z"}) == "z";
    rig_.schematic = word("schematic", {"false", "true"}) == "true";
    const Node* axes = node_.find("axes");
    if (!axes) return;
    Keys names;
    for (const Node& name : axes->items) names.push_back(name.text);
    if (names.size() < 2 || names.size() > max_coordinates)
      return fault(axes->mark, "axes", "axes are the names of two or three directions: [x, z]");
    rig_.axes = std::move(names);
  }

  /// One of some words, the first where the file has none.
  std::string word(const std::string& key, const Keys& words) {
    const Node* node = node_.find(key);
    if (!node) return words.front();
    if (std::find(words.begin(), words.end(), node->text) == words.end())
      fault(node->mark, key,
            fmt::format("'{}' is not allowed; it is one of {}", node->text, fmt::join(words, ", ")));
    return node->text;
  }

  void read_points(const Node& node) {
    if (!node.is_map()) return fault(node.mark, "points", "points are a map of name: place");
    for (const Entry& entry : node.entries)
      if (auto point = read_point(entry.value)) points_[entry.key] = std::move(*point);
  }

  /// A place: [x, y], the name of a recorded vector, or a row of a block's parameter.
  std::optional<RigPoint> read_point(const Node& node) {
    if (auto row = row_of_parameter(node.text)) return row;
    RigPoint point;
    for (Formula& coordinate : read_place(node, names_, "figure.points", faults_))
      point.emplace_back(std::move(coordinate));
    return point.empty() ? std::nullopt : std::optional(std::move(point));
  }

  std::optional<RigPoint> row_of_parameter(const std::string& text) const {
    if (!names_.diagram) return std::nullopt;
    for (const DiagramBlock& block : names_.diagram->diagram().blocks)
      if (text.starts_with(block.name + "."))
        if (auto row = row_of(block, text.substr(block.name.size() + 1))) return row;
    return std::nullopt;
  }

  void read_element(const Node& node) {
    if (!node.is_map()) return fault(node.mark, "elements", "an element is a map: {damper: [anchor, pin]}");
    const RigKind* kind = nullptr;
    for (const RigKind& known : rig_kinds())
      if (node.find(known.name)) kind = &known;
    if (!kind) return unknown_kind(node);
    RigElement element;
    element.kind = kind->name;
    read_ends(*node.find(kind->name), *kind, element);
    if (element.points.size() < kind->min_points || element.points.size() > kind->max_points)
      fault(node.mark, "elements",
            fmt::format("'{}' has {} points here; {}", kind->name, element.points.size(), kind->doc));
    read_details(node, *kind, element);
    rig_.elements.push_back(std::move(element));
  }

  void unknown_kind(const Node& node) {
    Keys kinds;
    for (const RigKind& known : rig_kinds()) kinds.push_back(known.name);
    const std::string word = node.entries.empty() ? "" : node.entries.front().key;
    fault(node.mark, "elements",
          fmt::format("there is no element '{}'{}", word, nearest_or_all(word, kinds, "there are")));
  }

  void read_ends(const Node& node, const RigKind& kind, RigElement& element) {
    // Several things in the list of a kind that takes one point are its coordinates.
    const bool is_point = kind.max_points == 1 && node.items.size() > 1;
    for (const Node& item : is_point ? std::span(&node, 1) : node.as_list()) {
      const auto named = item.is_scalar() ? points_.find(item.text) : points_.end();
      if (named != points_.end())
        element.points.push_back(named->second);
      else if (auto point = read_point(item))
        element.points.push_back(std::move(*point));
    }
  }

  void read_details(const Node& node, const RigKind& kind, RigElement& element) {
    for (const Entry& entry : node.entries) {
      if (entry.key == kind.name) continue;
      if (entry.key == "name")
        element.name = read_text(entry.value, names_, "figure.name", faults_);
      else if (entry.key == "body")
        element.body = length(entry.value, "body");
      else if (entry.key == "offset")
        element.offset = length(entry.value, "offset").value_or(0.0);
      else if (entry.key == "direction" && kind.directed)
        element.direction = direction(entry.value);
      else
        add_unknown_key(entry, keys_of(kind), "an element", names_, "figure.elements", faults_);
    }
  }

  static Keys keys_of(const RigKind& kind) {
    Keys keys{kind.name, "name", "body", "offset"};
    if (kind.directed) keys.push_back("direction");
    return keys;
  }

  /// An angle from x towards y, or shares along the axes.
  std::vector<double> direction(const Node& node) {
    std::vector<double> along;
    for (const Node& item : node.items)
      if (const auto share = read_number(item, names_, "figure.direction", faults_))
        along.push_back(share->value);
    if (!node.is_list()) {
      const auto angle = read_number(node, names_, "figure.direction", faults_);
      if (!angle) return {};
      check_dimension(*angle, Dimension{}, "an angle", node, names_, "figure.direction", faults_);
      return {std::cos(angle->value), std::sin(angle->value)};
    }
    const bool any = std::any_of(along.begin(), along.end(), [](double share) { return share != 0.0; });
    if (!any || along.size() < 2 || along.size() > max_coordinates)
      fault(node.mark, "direction",
            "a direction is an angle such as 60 deg, or shares along the axes: [0, 0, 1]");
    return along;
  }

  std::optional<double> length(const Node& node, const std::string& key) {
    const auto number = read_number(node, names_, "figure." + key, faults_);
    if (!number) return std::nullopt;
    check_dimension(*number, length_dimension, "a length", node, names_, "figure." + key, faults_);
    return number->value;
  }

  std::vector<const Formula*> formulas() const {
    std::vector<const Formula*> found;
    if (rig_.where) found.push_back(&*rig_.where);
    for (const RigElement& element : rig_.elements)
      for (const RigPoint& point : element.points)
        for (const auto& coordinate : point)
          if (const auto* formula = std::get_if<Formula>(&coordinate)) found.push_back(formula);
    return found;
  }

  const Node& node_;
  const SymbolTable& names_;
  Faults& faults_;
  std::map<std::string, RigPoint> points_;
  Rig rig_;
};

}  // namespace

Rig read_rig(const Node& node, const SymbolTable& names, Faults& faults) {
  return RigReader(node, names, faults).read();
}

}  // namespace stepwire
