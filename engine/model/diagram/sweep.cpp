#include <algorithm>

#include "engine/model/diagram/sweep.hpp"

namespace stepwire::diagram {

double Sweep::count() const {
  if (axes.empty()) return 0.0;
  double grid = 1.0, pairs = 0.0;
  for (const Axis& axis : axes) {
    const auto values = static_cast<double>(axis.count());
    if (together || axis.sampled)
      pairs = std::max(pairs, values);
    else
      grid *= values;
  }
  const bool paired = together || std::ranges::any_of(axes, &Axis::sampled);
  return paired ? grid * pairs : grid;
}

std::vector<std::size_t> Sweep::indices(std::size_t point) const {
  std::vector<std::size_t> result(axes.size(), point);
  if (together) return result;
  const auto last = std::ranges::find_if(axes.rbegin(), axes.rend(), &Axis::sampled);
  std::size_t sample = 0;
  for (std::size_t axis = axes.size(); axis-- > 0;) {
    const bool counts = !axes[axis].sampled || &axes[axis] == &*last;
    const std::size_t index = counts ? point % axes[axis].count() : sample;
    if (counts) point /= axes[axis].count();
    if (axes[axis].sampled) sample = index;
    result[axis] = index;
  }
  return result;
}

}  // namespace stepwire::diagram
