#include <fmt/format.h>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/panel_reading.hpp"

namespace stepwire {
namespace {

void fault(Faults& faults, const Names& names, Mark place, const std::string& subject,
           const std::string& message) {
  faults.add({{names.file, place}, subject, message, {}});
}

/// Points of the plane under a key of the panel, and what one of them is called in messages.
struct Points {
  std::string key, one;
  std::vector<MarkedPoint>& found;
};

void read_point(const std::string& name, const Node& node, const Panel& panel, const Names& names,
                Points& points, Faults& faults) {
  const std::string subject = "figure." + points.key;
  if (!node.is_list() || node.items.size() != 2)
    return fault(
        faults, names, node.mark, subject,
        fmt::format("the {} '{}' lies at two numbers, its x and its y: [0 mm, 20 mm]", points.one, name));
  const auto x = read_axis_number(node.items[0], panel, "x", names, subject, faults);
  const auto y = read_axis_number(node.items[1], panel, "y", names, subject, faults);
  if (x && y) points.found.push_back({name, *x, *y});
}

/// Is a point that was read as `mark` beyond a range that the file gives?
bool is_hidden(const MarkedPoint& mark, const Panel& panel) {
  const auto beyond = [](const AxisOptions& axis, double value) {
    return axis.range && (value < (*axis.range)[0] || value > (*axis.range)[1]);
  };
  return beyond(panel.x, mark.x) || beyond(panel.y, mark.y);
}

void check_points(const Node& node, const Panel& panel, const Names& names, const Points& points,
                  Faults& faults) {
  for (const MarkedPoint& mark : points.found) {
    if (!is_hidden(mark, panel)) continue;
    const Node* point = node.find(mark.name);
    fault(faults, names, point ? point->mark : node.mark, "figure." + points.key,
          fmt::format("the {} '{}' lies beyond the range of its axes", points.one, mark.name));
  }
}

}  // namespace

void read_marks(const Node& node, Panel& panel, const Names& names, Faults& faults) {
  if (!node.is_map() && (!node.is_list() || node.items.empty()))
    return fault(faults, names, node.mark, "figure.marks",
                 "marks are points with names, {A: [0 mm, 20 mm]}, or a list of points");
  Points marks{"marks", "mark", panel.marks};
  for (const Entry& entry : node.entries) read_point(entry.key, entry.value, panel, names, marks, faults);
  for (std::size_t i = 0; i < node.items.size(); ++i)
    read_point(std::to_string(i + 1), node.items[i], panel, names, marks, faults);
  check_points(node, panel, names, marks, faults);
}

void read_texts(const Node& node, Panel& panel, const Names& names, Faults& faults) {
  if (!node.is_map() || node.entries.empty())
    return fault(faults, names, node.mark, "figure.texts",
                 "texts stand about points: {authorized region: [0 mm, 200 mm]}");
  Points texts{"texts", "text", panel.texts};
  for (const Entry& entry : node.entries) read_point(entry.key, entry.value, panel, names, texts, faults);
  check_points(node, panel, names, texts, faults);
}

}  // namespace stepwire
