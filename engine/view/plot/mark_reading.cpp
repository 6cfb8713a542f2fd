#include <fmt/format.h>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/panel_reading.hpp"

namespace stepwire::plot {
namespace {

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

}  // namespace

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

}  // namespace stepwire::plot
