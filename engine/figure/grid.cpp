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

/// Which cells are known, with an empty margin around the grid.
class Mask {
 public:
  Mask(const Grid& grid, long margin)
      : margin_(margin),
        columns_(static_cast<long>(grid.columns) + 2 * margin),
        rows_(static_cast<long>(grid.rows) + 2 * margin),
        cells_(static_cast<std::size_t>(columns_ * rows_), false) {
    for (std::size_t row = 0; row < grid.rows; ++row)
      for (std::size_t column = 0; column < grid.columns; ++column)
        cells_[index(column, row)] = !std::isnan(grid.at(column, row));
  }

  bool at(std::size_t column, std::size_t row) const { return cells_[index(column, row)]; }

  /// Gives all cells within a disk around a cell that is `value` this value.
  void grow(bool value) {
    const std::vector<bool> before = cells_;
    for (long row = margin_ / 2; row < rows_ - margin_ / 2; ++row)
      for (long column = margin_ / 2; column < columns_ - margin_ / 2; ++column)
        if (before[static_cast<std::size_t>(row * columns_ + column)] == value) spread(column, row, value);
  }

 private:
  void spread(long column, long row, bool value) {
    const long reach = margin_ / 2;
    for (long dy = -reach; dy <= reach; ++dy)
      for (long dx = -reach; dx <= reach; ++dx)
        if (dx * dx + dy * dy <= reach * reach)
          cells_[static_cast<std::size_t>((row + dy) * columns_ + column + dx)] = value;
  }

  std::size_t index(std::size_t column, std::size_t row) const {
    return static_cast<std::size_t>((static_cast<long>(row) + margin_) * columns_ +
                                    static_cast<long>(column) + margin_);
  }

  long margin_, columns_, rows_;
  std::vector<bool> cells_;
};

/// Sum over known neighbours and their weight.
struct Neighbours {
  double sum = 0.0, weight = 0.0;
};

Neighbours neighbours(const Grid& grid, std::size_t column, std::size_t row) {
  Neighbours found;
  const auto add = [&](std::size_t c, std::size_t r) {
    const double value = grid.at(c, r);
    if (std::isnan(value)) return;
    found.sum += value;
    found.weight += 1.0;
  };
  if (column > 0) add(column - 1, row);
  if (column + 1 < grid.columns) add(column + 1, row);
  if (row > 0) add(column, row - 1);
  if (row + 1 < grid.rows) add(column, row + 1);
  return found;
}

/// Fills cells from their neighbours and smooths them until they lie as a stretched skin between the measured
/// ones.
void fill(Grid& grid, const std::vector<std::size_t>& cells) {
  constexpr int sweeps = 150;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const std::size_t cell : cells) {
      const Neighbours found = neighbours(grid, cell % grid.columns, cell / grid.columns);
      if (found.weight > 0.0) grid.values[cell] = found.sum / found.weight;
    }
}

/// Closes gaps that a disk of this radius, in cells, cannot enter from outside of the measured points.
void close_gaps(Grid& grid, long reach) {
  if (reach < 1) return;
  Mask mask(grid, 2 * reach);
  mask.grow(true);
  mask.grow(false);
  std::vector<std::size_t> cells;
  for (std::size_t row = 0; row < grid.rows; ++row)
    for (std::size_t column = 0; column < grid.columns; ++column)
      if (mask.at(column, row) && std::isnan(grid.at(column, row)))
        cells.push_back(row * grid.columns + column);
  fill(grid, cells);
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
  const double reach = std::ceil(0.5 * gap / std::min(grid.dx, grid.dy));
  close_gaps(grid, static_cast<long>(std::clamp(reach, 0.0, 0.5 * static_cast<double>(cells))));
  return grid;
}

}  // namespace stepwire
