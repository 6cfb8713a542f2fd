#include "engine/view/plot/overlay.hpp"

#include <fmt/format.h>

#include <string>

#include "engine/analyse/query/number.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/view/plot/axis_checks.hpp"
#include "engine/view/plot/gather.hpp"
#include "engine/view/plot/panel_reading.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {
namespace {

void read_heads(const yaml::Node& node, Motion& motion, const query::NamesReading& read) {
  constexpr double most = 100.0;
  const auto heads = query::read_number(node, read.names, read.subject, read.faults);
  if (heads) motion.heads = heads->value;
  if (heads && !(motion.heads >= 0.0 && motion.heads <= most))
    read.fault(node.mark, yaml::fault_text("{} arrow heads are not allowed; 0 to {} are", heads->text, most));
}

/// Reads a coordinate of an overlay: an expression, in the unit of the panel's axis.
std::optional<query::Series> read_coordinate(const yaml::Node& node, const std::string& axis,
                                             const Panel& panel, const query::NamesReading& read) {
  auto formula = read.formula(node);
  const query::Series* drawn = panel.find(axis);
  if (!formula || !drawn) return std::nullopt;
  const auto &ours = formula->dimension, &theirs = drawn->formula.dimension;
  if (ours && theirs && *ours != *theirs)
    read.fault(node.mark,
               yaml::fault_text("'{}' is in {}, but '{}' in {}; both are drawn along {}", formula->text,
                                unit::si_name(*ours), drawn->formula.text, unit::si_name(*theirs), axis));
  else if (auto wrong = fault_along({*formula, {}, ours ? unit::si_name(*ours) : "", formula->text}, *drawn))
    read.fault(node.mark, std::move(*wrong));
  return query::Series{*formula, drawn->unit, drawn->unit_text, formula->text};
}

void read_motion(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  if (!read.check(node, motion_form())) return;
  const yaml::Node *x = node.find("x"), *y = node.find("y");
  if (!x || !y) return;
  auto across = read_coordinate(*x, "x", panel, yaml::below(read, "x"));
  auto up = read_coordinate(*y, "y", panel, yaml::below(read, "y"));
  if (!across || !up) return;
  Motion motion{std::move(*across), std::move(*up)};
  if (const yaml::Node* where = node.find("where")) motion.where = yaml::below(read, "where").formula(*where);
  if (const yaml::Node* heads = node.find("heads")) read_heads(*heads, motion, yaml::below(read, "heads"));
  if (const yaml::Node* color = node.find("color"))
    if (const auto index = yaml::below(read, "color").word(*color, *motion_form().find("color")))
      motion.color = motion_colors()[*index].doc;
  motion.recording =
      query::common_recording({&motion.x.formula, &motion.y.formula, motion.where ? &*motion.where : nullptr},
                              read.names, node, read.subject, read.faults);
  panel.motions.push_back(std::move(motion));
}

void read_place(const yaml::Node& node, const Panel& panel, const query::NamesReading& read, Rose& rose) {
  const auto number = [&](const yaml::Node& value, const std::string& axis, const std::string& key) {
    return read_axis_number(value, panel, axis, read.names, read.subject + "." + key, read.faults);
  };
  const yaml::Node& radius = *node.find("radius");
  rose.radius = number(radius, "x", "radius").value_or(1.0);
  if (!(rose.radius > 0.0)) yaml::below(read, "radius").fault(radius.mark, "the radius of a rose is above 0");
  const yaml::Node* at = node.find("at");
  const auto* place = at ? yaml::below(read, "at").pair(*at, *rose_form().find("at")) : nullptr;
  if (!place) return;
  const auto x = number((*place)[0], "x", "at"), y = number((*place)[1], "y", "at");
  if (x && y) rose.at = {*x, *y};
}

void read_rose(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  const std::size_t before = read.faults.size();
  if (!read.check(node, rose_form()) || read.faults.size() > before) return;
  auto x = read_coordinate(*node.find("x"), "x", panel, yaml::below(read, "x"));
  auto y = read_coordinate(*node.find("y"), "y", panel, yaml::below(read, "y"));
  auto angle = yaml::below(read, "angle").formula(*node.find("angle"));
  auto value = yaml::below(read, "value").series(*node.find("value"));
  if (!x || !y || !angle || !value) return;
  Rose rose{std::move(*x), std::move(*y), {*angle, unit::Unit{}, "", angle->text}, std::move(*value)};
  read_place(node, panel, read, rose);
  if (const yaml::Node* where = node.find("where")) rose.where = yaml::below(read, "where").formula(*where);
  if (const yaml::Node* name = node.find("name")) rose.name = yaml::below(read, "name").text(*name);
  rose.recording = query::common_recording({&rose.x.formula, &rose.y.formula, &rose.angle.formula,
                                            &rose.value.formula, rose.where ? &*rose.where : nullptr},
                                           read.names, node, read.subject, read.faults);
  panel.roses.push_back(std::move(rose));
}

/// Points of the plane under a key of the panel, and the name of one of them in messages.
struct Points {
  std::string one;
  std::vector<MarkedPoint>& found;
};

void read_point(const std::string& name, const yaml::Node& node, const Panel& panel,
                const query::NamesReading& read, Points& points) {
  if (!node.is_list() || node.items.size() != 2)
    return read.fault(
        node.mark,
        fmt::format("the {} '{}' lies at two numbers, its x and its y: [0 mm, 20 mm]", points.one, name));
  const auto x = read_axis_number(node.items[0], panel, "x", read.names, read.subject, read.faults);
  const auto y = read_axis_number(node.items[1], panel, "y", read.names, read.subject, read.faults);
  if (x && y) points.found.push_back({name, *x, *y});
}

/// True if a point, read as `mark`, is beyond a given range.
bool is_hidden(const MarkedPoint& mark, const Panel& panel) {
  const auto beyond = [](const AxisOptions& axis, double value) {
    return axis.range && (value < (*axis.range)[0] || value > (*axis.range)[1]);
  };
  return beyond(panel.x, mark.x) || beyond(panel.y, mark.y);
}

void check_points(const yaml::Node& node, const Panel& panel, const query::NamesReading& read,
                  const Points& points) {
  for (const MarkedPoint& mark : points.found) {
    if (!is_hidden(mark, panel)) continue;
    const yaml::Node* point = node.find(mark.name);
    read.fault(point ? point->mark : node.mark,
               fmt::format("the {} '{}' lies beyond the range of its axes", points.one, mark.name));
  }
}

/// Returns the dimension of what is drawn along an axis; std::nullopt if it is unknown.
std::optional<unit::Dimension> dimension_along(const std::string& axis, const Panel& panel) {
  const query::Series* drawn = panel.find(axis);
  if (!drawn) return std::nullopt;
  const bool has_unit = !drawn->unit_text.empty() && !drawn->formula.dimension;
  return has_unit ? drawn->unit.dimension : drawn->formula.dimension;
}

/// Returns the names of the panel's plane: x and y are its coordinates, even if columns of these names are
/// recorded.
query::SymbolTable plane_of(const query::SymbolTable& names, const Panel& panel) {
  query::SymbolTable plane = names;
  std::erase_if(plane.columns,
                [](const query::RecordedName& one) { return one.name == "x" || one.name == "y"; });
  plane.columns.insert(plane.columns.begin(),
                       {{"x", dimension_along("x", panel), {}}, {"y", dimension_along("y", panel), {}}});
  plane.signals.clear();
  plane.unknown = "is no coordinate of the plane, nor recorded";
  return plane;
}

/// Returns the recording with the columns of a formula and of the panel's `where`.
std::size_t recording_of(const query::Formula& formula, const Panel& panel, const yaml::Node& node,
                         const query::NamesReading& read) {
  return query::common_recording({panel.where ? &*panel.where : nullptr, &formula}, read.names, node,
                                 read.subject, read.faults);
}

const query::NamedOutline* find_outline(const yaml::Node& node, const query::NamesReading& read) {
  std::vector<std::string> names;
  for (const query::NamedOutline& named : read.names.outlines) {
    if (node.is_scalar() && named.name == node.text) return &named;
    names.push_back(named.name);
  }
  const yaml::Message choice =
      names.empty() ? "; this file has none" : yaml::nearest_or_all(node.text, names, "there are");
  read.fault(node.mark, fmt::format("'{}' is no block with a boundary, as a Region is", node.text) + choice);
  return nullptr;
}

}  // namespace

std::vector<geometry::Curve> overlay_rows(const std::optional<query::Formula>& where,
                                          const record::Recording& recording,
                                          const std::vector<const query::Series*>& channels) {
  Panel rows;
  rows.where = where;
  return gather(rows, recording, channels).curves;
}

const std::vector<yaml::Key::Word>& motion_colors() {
  static const std::vector<yaml::Key::Word> colors{// dark enough for a line
                                                   {"red", "#d11a1a"},
                                                   {"blue", "#0072B2"},
                                                   {"green", "#009E73"},
                                                   {"black", "#222222"}};
  return colors;
}

void read_motions(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  for (const yaml::Node& item : node.as_list()) read_motion(item, panel, read);
}

void read_roses(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  for (const yaml::Node& item : node.as_list()) read_rose(item, panel, read);
}

void read_marks(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  if (!node.is_map() && (!node.is_list() || node.items.empty()))
    return read.fault(node.mark, "marks are points with names, {A: [0 mm, 20 mm]}, or a list of points");
  Points marks{"mark", panel.marks};
  for (const yaml::Entry& entry : node.entries) read_point(entry.key, entry.value, panel, read, marks);
  for (std::size_t i = 0; i < node.items.size(); ++i)
    read_point(std::to_string(i + 1), node.items[i], panel, read, marks);
  check_points(node, panel, read, marks);
}

void read_texts(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark, "texts stand about points: {authorized region: [0 mm, 200 mm]}");
  Points texts{"text", panel.texts};
  for (const yaml::Entry& entry : node.entries) read_point(entry.key, entry.value, panel, read, texts);
  check_points(node, panel, read, texts);
}

void read_boundaries(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  const query::SymbolTable names = plane_of(read.names, panel);
  const query::NamesReading plane(read.subject, names, read.faults);
  for (const yaml::Node& item : node.as_list()) {
    auto formula = plane.formula(item);
    if (!formula) continue;
    formula->recording = recording_of(*formula, panel, item, plane);
    panel.boundaries.push_back(std::move(*formula));
  }
}

void read_note(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  auto series = read.series(node);
  if (!series) return;
  series->formula.recording = recording_of(series->formula, panel, node, read);
  panel.series["note"] = {std::move(*series)};
}

void read_regions(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  for (const yaml::Node& item : node.as_list()) {
    const query::NamedOutline* found = find_outline(item, read);
    if (!found) continue;
    const bool space = found->outline.space;
    if (space == panel.kind->plane)
      read.fault(item.mark,
                 fmt::format("'{}' lies in {}, and a plot '{}' shows {}", item.text,
                             space ? "space" : "the plane", panel.kind->name, space ? "the plane" : "space"));
    panel.regions.push_back(*found);
  }
}

}  // namespace stepwire::plot
