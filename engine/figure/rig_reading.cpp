#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "engine/draw/draw.hpp"
#include "engine/figure/number.hpp"
#include "engine/figure/place_reading.hpp"
#include "engine/figure/rig.hpp"

namespace stepwire {
namespace {

using Keys = std::vector<std::string>;

constexpr std::size_t any_number = 1000;

/// "anchors.1" of a block: a row of one of its parameters.
std::optional<RigPoint> row_of(const DiagramBlock& block, const std::string& rest) {
  const std::size_t dot = rest.find('.');
  const ParameterSpec* parameter = block.type().parameter(rest.substr(0, dot));
  if (!parameter || dot == std::string::npos) return std::nullopt;
  const Value value = parameter->get(block.block.get());
  const auto* rows = std::get_if<Eigen::MatrixXd>(&value.content);
  const long row = std::strtol(rest.c_str() + dot + 1, nullptr, 10);
  if (!rows || row < 1 || row > rows->rows() || rows->cols() > static_cast<Eigen::Index>(most_coordinates))
    return std::nullopt;
  RigPoint point;
  for (Eigen::Index i = 0; i < rows->cols(); ++i) point.emplace_back((*rows)(row - 1, i));
  return point;
}

/// Reads one rig; faults are gathered.
class RigReader {
 public:
  RigReader(const Node& node, const Names& names, Faults& faults)
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
    if (const Node* where = node_.find("where"))
      rig_.where = read_formula(*where, names_, "figure.where", faults_);
    rig_.recording = common_recording(formulas(), names_, node_, "figure", faults_);
    return std::move(rig_);
  }

 private:
  void fault(const Mark& mark, const std::string& key, std::string message) {
    faults_.add({{names_.file, mark}, "figure." + key, std::move(message), {}});
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
    read_ends(*node.find(kind->name), element);
    if (element.points.size() < kind->least_points || element.points.size() > kind->most_points)
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

  void read_ends(const Node& node, RigElement& element) {
    const std::vector<Node> one{node};
    for (const Node& item : node.is_list() ? node.items : one) {
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
      else
        add_unknown_key(entry, {kind.name, "name", "body", "offset"}, "an element", names_, "figure.elements",
                        faults_);
    }
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
  const Names& names_;
  Faults& faults_;
  std::map<std::string, RigPoint> points_;
  Rig rig_;
};

}  // namespace

const std::vector<RigKind>& rig_kinds() {
  static const std::vector<RigKind> kinds{
      {"damper", "it takes two: where its housing is held, and the end of its rod"},
      {"motor", "a linear motor takes two: where its housing is held, and the end of its rod"},
      {"spring", "it takes two ends"},
      {"rod", "it takes two ends"},
      {"potentiometer",
       "a string potentiometer beside a link takes two: where it is held, and the end of its string"},
      {"lvdt", "beside a link, it takes two: where it is held, and the end of its core"},
      {"load_cell", "it takes the two ends of the link at whose second end it is"},
      {"arrow", "it takes two: its beginning and its tip"},
      {"dimension", "it takes the two points whose distance it shows"},
      {"ground", "it takes the joints that are at the ground", 1, any_number},
      {"pin", "it takes the joints that are drawn", 1, any_number},
      {"end_effector", "it takes one point", 1, 1},
      {"carriage", "it takes the point at which its damper ends", 1, 1},
      {"shaker", "it takes the point that it moves along x", 1, 1},
      {"rotary_damper", "it takes its centre", 1, 1},
      {"workspace", "it takes two opposite corners, or the corners of a polygon", 2, any_number},
      {"path", "it takes one point, whose way is drawn", 1, 1},
  };
  return kinds;
}

Rig read_rig(const Node& node, const Names& names, Faults& faults) {
  return RigReader(node, names, faults).read();
}

}  // namespace stepwire
