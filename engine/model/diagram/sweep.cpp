#include <algorithm>

#include "engine/model/diagram/sweep.hpp"

namespace stepwire::diagram {

namespace {

/// Is it an axis of the grid: alone, or the last of its group?
bool counts(const std::vector<Sweep::Axis>& axes, std::size_t axis) {
  const Sweep::Group group = axes[axis].group;
  const auto behind = axes.begin() + static_cast<std::ptrdiff_t>(axis) + 1;
  return group == Sweep::Group::none ||
         std::ranges::find(behind, axes.end(), group, &Sweep::Axis::group) == axes.end();
}

}  // namespace

double Sweep::count() const {
  if (axes.empty()) return 0.0;
  double count = together ? 0.0 : 1.0;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const auto values = static_cast<double>(axes[axis].count());
    if (together)
      count = std::max(count, values);
    else if (counts(axes, axis))
      count *= values;
  }
  return count;
}

std::vector<std::size_t> Sweep::indices(std::size_t point) const {
  std::vector<std::size_t> result(axes.size(), point);
  if (together) return result;
  std::size_t of_group[3] = {};
  for (std::size_t axis = axes.size(); axis-- > 0;) {
    std::size_t& index = of_group[static_cast<std::size_t>(axes[axis].group)];
    if (counts(axes, axis)) {
      index = point % axes[axis].count();
      point /= axes[axis].count();
    }
    result[axis] = index;
  }
  return result;
}

std::vector<std::string> Sweep::cases() const {
  std::vector<std::string> names;
  for (const Axis& axis : axes)
    for (std::size_t i = 0; axis.label && axis.of_cases() && i < axis.count(); ++i)
      names.push_back(axis.text(i));
  return names;
}

}  // namespace stepwire::diagram
