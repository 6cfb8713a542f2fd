#include "engine/view/plot/rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/base/text/count.hpp"
#include "engine/view/drawing/draw.hpp"

namespace stepwire::plot {

using yaml::form;

namespace {

constexpr std::size_t any_number = 1000;

std::size_t dimensions_of(const Rig& rig) {
  std::size_t most = 2;
  for (const RigElement& element : rig.elements)
    for (const RigPoint& point : element.points) most = std::max(most, point.size());
  return most;
}

json::Json element_json(const RigElement& element, json::Json points) {
  json::Json json = json::Json::object().set("kind", element.kind).set("points", std::move(points));
  if (!element.name.empty()) json.set("name", element.name);
  if (element.body) json.set("body", *element.body);
  if (element.offset != 0.0) json.set("offset", element.offset);
  if (!element.direction.empty()) json.set("direction", json::Json::list_of(element.direction));
  return json;
}

/// Returns a row of a block's parameter, by the text "anchors.1".
std::optional<RigPoint> row_of(const diagram::DiagramBlock& block, const std::string& rest) {
  const std::size_t dot = rest.find('.');
  const ParameterSpec* parameter = block.type().parameter(rest.substr(0, dot));
  if (!parameter || dot == std::string::npos) return std::nullopt;
  const Value value = parameter->get(block.block.get());
  const auto* rows = std::get_if<Eigen::MatrixXd>(&value.content);
  const long row = std::strtol(rest.c_str() + dot + 1, nullptr, 10);
  if (!rows || row < 1 || row > rows->rows() ||
      rows->cols() > static_cast<Eigen::Index>(query::max_coordinates))
    return std::nullopt;
  RigPoint point;
  for (Eigen::Index i = 0; i < rows->cols(); ++i) point.emplace_back((*rows)(row - 1, i));
  return point;
}

/// Context for reading elements, with the named points.
struct RigReading : query::NamesReading {
  RigReading(const query::NamesReading& read, const std::map<std::string, RigPoint>& named)
      : query::NamesReading(read), named(named) {}
  const std::map<std::string, RigPoint>& named;
};

using ElementTable = yaml::KeyTable<RigElement, RigReading>;
using RigTable = yaml::KeyTable<Rig, query::NamesReading>;

std::optional<RigPoint> row_of_parameter(const std::string& text, const query::SymbolTable& names) {
  if (!names.diagram) return std::nullopt;
  for (const diagram::DiagramBlock& block : names.diagram->diagram().blocks)
    if (text.starts_with(block.name + "."))
      if (auto row = row_of(block, text.substr(block.name.size() + 1))) return row;
  return std::nullopt;
}

/// Reads a point: [x, y], the name of a recorded vector, or a row of a block's parameter.
std::optional<RigPoint> read_point(const yaml::Node& node, const query::NamesReading& read) {
  if (auto row = row_of_parameter(node.text, read.names)) return row;
  RigPoint point;
  for (query::Formula& coordinate : query::read_place(node, read.names, read.subject, read.faults))
    point.emplace_back(std::move(coordinate));
  return point.empty() ? std::nullopt : std::optional(std::move(point));
}

yaml::Key place_form() {
  return form::either({form::signal(), form::list(form::expression(), 1, query::max_coordinates)});
}

void read_ends(const RigKind& kind, RigElement& element, const yaml::Node& node, const RigReading& read) {
  element.kind = kind.name;
  // Several items for a kind with one point are the coordinates of that point.
  const bool is_point = kind.max_points == 1 && node.items.size() > 1;
  for (const yaml::Node& item : is_point ? std::span(&node, 1) : node.as_list()) {
    const auto named = item.is_scalar() ? read.named.find(item.text) : read.named.end();
    if (named != read.named.end())
      element.points.push_back(named->second);
    else if (auto point = read_point(item, read))
      element.points.push_back(std::move(*point));
  }
  const std::size_t count = element.points.size();
  if (count < kind.min_points || count > kind.max_points)
    read.fault(node.mark, fmt::format("{} here; {}", text::there_are(count, "point"), kind.doc));
}

/// Reads an angle from x towards y, or components along the axes.
void read_direction(RigElement& element, const yaml::Node& node, const RigReading& read) {
  if (!node.is_list()) {
    const auto angle = read.number(node, form::computed("rad"));
    if (angle) element.direction = {std::cos(*angle), std::sin(*angle)};
    return;
  }
  for (const yaml::Node& item : node.items)
    if (const auto one = read.number(item, form::computed())) element.direction.push_back(*one);
  const bool any = std::ranges::any_of(element.direction, [](double one) { return one != 0.0; });
  if (!any || element.direction.size() < 2 || element.direction.size() > query::max_coordinates)
    read.fault(node.mark, "a direction is an angle such as 60 deg, or shares along the axes: [0, 0, 1]");
}

/// Returns all kinds of elements; mechanism.mjs draws them.
const std::vector<RigKind>& rig_kinds() {
  static const std::vector<RigKind> kinds{
      {"damper", "it takes two: where its housing is held, and the end of its rod"},
      {"motor", "a linear motor takes two: where its housing is held, and the end of its rod"},
      {"spring", "it takes two ends"},
      {"rod", "it takes two ends"},
      {"potentiometer",
       "a string potentiometer beside a link takes two: where it is held, and the end of its string"},
      {"lvdt", "beside a link, it takes two: where it is held, and the end of its core"},
      {"dashpot", "it takes two ends"},
      {"bouc_wen", "it takes two ends"},
      {"load_cell", "it takes the two ends of the link at whose second end it is"},
      {"arrow", "it takes two: its beginning and its tip"},
      {"force", "it takes the point at which it acts", 1, 1, true},
      {"motion", "it takes the point that goes to and fro", 1, 1, true},
      {"torque", "it takes the point about which it turns", 1, 1},
      {"axis", "it takes two ends"},
      {"dimension", "it takes the two points whose distance it shows"},
      {"ground", "it takes the joints that are at the ground", 1, any_number},
      {"universal", "it takes the universal joints that are at the ground", 1, any_number},
      {"pin", "it takes the joints that are drawn", 1, any_number},
      {"end_effector", "it takes one point", 1, 1},
      {"carriage", "it takes the point at which its damper ends", 1, 1},
      {"shaker", "it takes the point that it moves, along x or in its direction", 1, 1, true},
      {"rotary_damper", "it takes its centre", 1, 1},
      {"slide", "it takes the point that slides", 1, 1, true},
      {"box", "a body takes two opposite corners"},
      {"wall", "it takes two ends; what stands on it lies to the right of the way"},
      {"base", "it takes the corners of a plate, or two opposite ones", 2, any_number},
      {"workspace", "it takes two opposite corners, or the corners of a polygon", 2, any_number},
      {"path", "it takes one point, whose way is drawn", 1, 1},
  };
  return kinds;
}

std::vector<ElementTable::Row> element_rows() {
  std::vector<ElementTable::Row> rows;
  std::vector<std::string> directed;
  for (const RigKind& kind : rig_kinds()) {
    const yaml::Key points = form::either({place_form(), form::list(place_form())});
    rows.push_back(yaml::one_of("kind", ElementTable::Row{kind.name, kind.doc, points,
                                                          [&kind](RigElement& element, const yaml::Node& node,
                                                                  const RigReading& read) {
                                                            read_ends(kind, element, node, read);
                                                          }}));
    if (kind.directed) directed.push_back(kind.name);
  }
  rows.push_back(
      {"name", "text beside it; what follows '_' stands lower: F_e", form::text(), &RigElement::name});
  rows.push_back({"body", "length of the housing of a link", form::computed("m"), &RigElement::body});
  rows.push_back({"offset", "of a dimension, to the left of the way between its points", form::computed("m"),
                  &RigElement::offset});
  rows.push_back(yaml::beside(
      directed, ElementTable::Row{"direction", "an angle from x towards y, or shares along the axes",
                                  form::either({form::computed("rad"),
                                                form::list(form::computed(), 2, query::max_coordinates)}),
                                  read_direction}));
  return rows;
}

const ElementTable& element_table() {
  static const ElementTable table("an element", "{damper: [anchor, pin]}", element_rows());
  return table;
}

void read_points(Rig& rig, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_map()) return read.fault(node.mark, "points are a map of name: place");
  for (const yaml::Entry& entry : node.entries)
    if (auto point = read_point(entry.value, read)) rig.points[entry.key] = std::move(*point);
}

void read_elements(Rig& rig, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_list() || node.items.empty())
    return read.fault(node.mark, "elements are a list such as [{damper: [anchor, pin]}, {ground: anchor}]");
  for (const yaml::Node& item : node.items)
    element_table().read(item, rig.elements.emplace_back(), RigReading(read, rig.points));
}

void read_axes(Rig& rig, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_list() || node.items.size() < 2 || node.items.size() > query::max_coordinates)
    return read.fault(node.mark, "axes are the names of two or three directions: [x, z]");
  rig.axes.clear();
  for (const yaml::Node& name : node.items) rig.axes.push_back(read.text(name));
}

const RigTable& rig_table() {
  static const RigTable table(
      "a rig", "{elements: [{damper: [anchor, pin]}, {ground: anchor}]}",
      {{"points",
        "places with names; a place is a recorded vector, a row of a block's parameter "
        "(rig.linkage.anchors.1), "
        "or [x, y]",
        form::names(place_form()), read_points},
       yaml::needed(RigTable::Row{"elements", "what is drawn: the kind of an element with its points",
                                  form::list(element_table().form, 1), read_elements}),
       {"axes", "names of the axes that are drawn, [x, z] of a view from the side",
        form::list(form::text(), 2, query::max_coordinates), read_axes},
       {"up", "the axis that points upwards in space", form::word({"y", "z"}), &Rig::z_up},
       {"schematic", "without axes and scale", form::truth(), &Rig::schematic},
       {"where", "the first row for which this is true is drawn; without it the first of all",
        form::expression(), &Rig::where}});
  return table;
}

std::vector<const query::Formula*> formulas_of(const Rig& rig) {
  std::vector<const query::Formula*> found;
  if (rig.where) found.push_back(&*rig.where);
  for (const RigElement& element : rig.elements)
    for (const RigPoint& point : element.points)
      for (const auto& coordinate : point)
        if (const auto* formula = std::get_if<query::Formula>(&coordinate)) found.push_back(formula);
  return found;
}

}  // namespace

json::Json rig_json(
    const Rig& rig,
    const std::function<json::Json(const RigElement& element, std::size_t dimensions)>& points) {
  const std::size_t dimensions = dimensions_of(rig);
  json::Json elements = json::Json::list();
  for (const RigElement& element : rig.elements)
    elements.push(element_json(element, points(element, dimensions)));
  json::Json json = json::Json::object().set("title", rig.title).set("dimensions", dimensions);
  json.set("axes", json::Json::list_of(rig.axes));
  if (rig.z_up) json.set("up", "z");
  if (rig.schematic) json.set("schematic", true);
  return json.set("elements", std::move(elements));
}

const yaml::Key& rig_form() {
  return rig_table().form;
}

Rig read_rig(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  Rig rig;
  rig.mark = node.mark;
  const query::NamesReading read("figure", names, faults);
  yaml::set_keys(node, rig_table().rows, rig, read);
  rig.recording = query::common_recording(formulas_of(rig), names, node, "figure", faults);
  return rig;
}

}  // namespace stepwire::plot
