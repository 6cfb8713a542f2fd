#include <fmt/format.h>

#include "engine/figure/number.hpp"
#include "engine/figure/panel_reading.hpp"

namespace stepwire {
namespace {

const std::string subject = "figure.marks";

void fault(Faults& faults, const Names& names, Mark place, const std::string& message) {
  faults.add({{names.file, place}, subject, message, {}});
}

void read_mark(const std::string& name, const Node& node, Panel& panel, const Names& names, Faults& faults) {
  if (!node.is_list() || node.items.size() != 2)
    return fault(faults, names, node.mark,
                 fmt::format("the mark '{}' lies at two numbers, its x and its y: [0 mm, 20 mm]", name));
  const auto x = read_axis_number(node.items[0], panel, "x", names, subject, faults);
  const auto y = read_axis_number(node.items[1], panel, "y", names, subject, faults);
  if (x && y) panel.marks.push_back({name, *x, *y});
}

/// Is a point that was read as `mark` beyond a range that the file gives?
bool is_hidden(const MarkedPoint& mark, const Panel& panel) {
  const auto beyond = [&](const std::string& range, double value) {
    const auto given = panel.ranges.find(range);
    return given != panel.ranges.end() && (value < given->second[0] || value > given->second[1]);
  };
  return beyond("x_range", mark.x) || beyond("y_range", mark.y);
}

}  // namespace

void read_marks(const Node& node, Panel& panel, const Names& names, Faults& faults) {
  if (!node.is_map() && (!node.is_list() || node.items.empty()))
    return fault(faults, names, node.mark,
                 "marks are points with names, {A: [0 mm, 20 mm]}, or a list of points");
  for (const Entry& entry : node.entries) read_mark(entry.key, entry.value, panel, names, faults);
  for (std::size_t i = 0; i < node.items.size(); ++i)
    read_mark(std::to_string(i + 1), node.items[i], panel, names, faults);
}

void check_marks(const Node& node, const Panel& panel, const Names& names, Faults& faults) {
  for (const MarkedPoint& mark : panel.marks) {
    if (!is_hidden(mark, panel)) continue;
    const Node* point = node.find(mark.name);
    fault(faults, names, point ? point->mark : node.mark,
          fmt::format("the mark '{}' lies beyond the range of its axes", mark.name));
  }
}

}  // namespace stepwire
