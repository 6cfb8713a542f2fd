#include "engine/figure/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/figure/script.hpp"

namespace stepwire {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Equally spaced values of one axis.
struct Axis {
  double first = 0.0, step = 1.0;
  std::size_t count = 1;

  std::size_t index(double value) const {
    const double i = std::round((value - first) / step);
    return static_cast<std::size_t>(std::clamp(i, 0.0, static_cast<double>(count - 1)));
  }
};

/// The few equally spaced values on which all numbers lie, if there are such.
std::optional<Axis> lattice(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double width = values.back() - values.front();
  const auto same = [&](double a, double b) { return b - a <= 1e-6 * width; };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  if (values.size() < 2 || values.size() > 400) return std::nullopt;
  const double step = width / static_cast<double>(values.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i] - values.front() - static_cast<double>(i) * step) > 0.01 * step)
      return std::nullopt;
  return Axis{values.front(), step, values.size()};
}

Axis cut(const std::vector<double>& values, double step) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto count = static_cast<std::size_t>(std::floor((*high - *low) / step)) + 1;
  const double middle = 0.5 * (*low + *high);
  return {middle - 0.5 * step * static_cast<double>(count - 1), step, count};
}

Grid average(const Curve& points, const Axis& x, const Axis& y) {
  Grid grid{x.first, y.first, x.step, y.step, x.count, y.count, {}};
  grid.values.assign(x.count * y.count, 0.0);
  std::vector<double> counts(grid.values.size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t cell = y.index(points.columns[1][i]) * x.count + x.index(points.columns[0][i]);
    grid.values[cell] += points.columns[2][i];
    counts[cell] += 1.0;
  }
  for (std::size_t cell = 0; cell < counts.size(); ++cell)
    grid.values[cell] = counts[cell] > 0.0 ? grid.values[cell] / counts[cell] : nothing;
  return grid;
}

using Mask = std::vector<bool>;

/// One pass of a square or cross over a mask: grows what is `value` by one cell. Outside of the grid is
/// false.
Mask grown(const Grid& grid, const Mask& mask, bool value, bool square) {
  Mask result = mask;
  const auto columns = static_cast<long>(grid.columns), rows = static_cast<long>(grid.rows);
  for (long row = 0; row < rows; ++row)
    for (long column = 0; column < columns; ++column)
      for (long dy = -1; dy <= 1; ++dy)
        for (long dx = -1; dx <= 1; ++dx) {
          if (!square && dx != 0 && dy != 0) continue;
          const long r = row + dy, c = column + dx;
          const bool inside = r >= 0 && c >= 0 && r < rows && c < columns;
          // Beyond the edge nothing grows and nothing shrinks: measured cells may lie on it.
          if (inside && mask[static_cast<std::size_t>(r * columns + c)] == value)
            result[static_cast<std::size_t>(row * columns + column)] = value;
        }
  return result;
}

/// Fills unknown cells of `wanted` with the mean of their known neighbours, ring by ring.
void fill(Grid& grid, const Mask& wanted) {
  const auto columns = static_cast<long>(grid.columns), rows = static_cast<long>(grid.rows);
  for (bool changed = true; changed;) {
    changed = false;
    const std::vector<double> before = grid.values;
    for (long row = 0; row < rows; ++row)
      for (long column = 0; column < columns; ++column) {
        const auto cell = static_cast<std::size_t>(row * columns + column);
        if (!wanted[cell] || !std::isnan(before[cell])) continue;
        double sum = 0.0, weight = 0.0;
        for (long r = std::max(0L, row - 1); r <= std::min(rows - 1, row + 1); ++r)
          for (long c = std::max(0L, column - 1); c <= std::min(columns - 1, column + 1); ++c) {
            const double value = before[static_cast<std::size_t>(r * columns + c)];
            if (std::isnan(value)) continue;
            const double share = r == row || c == column ? 2.0 : 1.0;
            sum += share * value;
            weight += share;
          }
        if (weight == 0.0) continue;
        grid.values[cell] = sum / weight;
        changed = true;
      }
  }
}

/// Closes gaps: cells that lie between known ones, at most `reach` cells from them (grown, then shrunk as
/// far).
void close_gaps(Grid& grid, int reach) {
  Mask known(grid.values.size());
  for (std::size_t i = 0; i < known.size(); ++i) known[i] = !std::isnan(grid.values[i]);
  for (int i = 0; i < reach; ++i) known = grown(grid, known, true, i % 2 == 0);
  for (int i = 0; i < reach; ++i) known = grown(grid, known, false, i % 2 == 0);
  fill(grid, known);
}

}  // namespace

Grid make_grid(const Curve& points, std::size_t cells, double gap) {
  const auto x = lattice(points.columns[0]), y = lattice(points.columns[1]);
  if (x && y && 2 * points.size() >= x->count * y->count) return average(points, *x, *y);
  Extent across, up;
  for (const double value : points.columns[0]) across.add(value);
  for (const double value : points.columns[1]) up.add(value);
  const auto step = [&](const Extent& extent) {
    const double width = extent.high - extent.low;
    return width > 0.0 ? width / static_cast<double>(cells) : 1.0;
  };
  Grid grid = average(points, cut(points.columns[0], step(across)), cut(points.columns[1], step(up)));
  const int reach = static_cast<int>(std::ceil(0.5 * gap / std::min(grid.dx, grid.dy)));
  close_gaps(grid, std::clamp(reach, 0, static_cast<int>(cells)));
  return grid;
}

}  // namespace stepwire
