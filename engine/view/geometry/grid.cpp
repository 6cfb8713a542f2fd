#include "engine/view/geometry/grid.hpp"

#include <algorithm>
#include <array>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace stepwire::geometry {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using IntegerPoint = boost::polygon::point_data<std::int32_t>;

/// Scales coordinates to integers, for which the predicates of the library are exact.
std::vector<IntegerPoint> scaled(const std::vector<double>& x, const std::vector<double>& y) {
  constexpr double most = 1 << 30;
  const Extent across = extent_of(x), up = extent_of(y);
  const double scale = most / std::max({across.width(), up.width(), 1e-300});
  const auto whole = [&](double value, double low) {
    return static_cast<std::int32_t>(std::lround((value - low) * scale));
  };
  std::vector<IntegerPoint> points;
  for (std::size_t i = 0; i < x.size(); ++i)
    points.emplace_back(whole(x[i], across.low), whole(y[i], up.low));
  return points;
}

/// Returns the points whose cells meet at a vertex of the diagram, counterclockwise: three, or more on one
/// circle.
std::vector<std::size_t> points_around(const Diagram::vertex_type& corner) {
  std::vector<std::size_t> points;
  const auto* edge = corner.incident_edge();
  do {
    points.push_back(edge->cell()->source_index());
    edge = edge->rot_next();
  } while (edge != corner.incident_edge());
  return points;
}

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();  // value far from all points

/// Equally spaced values of one axis.
struct Axis {
  double first = 0.0, step = 1.0;
  std::size_t count = 1;

  std::size_t index(double value) const {
    const double i = std::round((value - first) / step);
    return static_cast<std::size_t>(std::clamp(i, 0.0, static_cast<double>(count - 1)));
  }
};

/// Returns the equally spaced values that contain all numbers; std::nullopt if there are no such values or
/// too many.
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

/// Averages the points of each cell and moves them to its centre.
Curve one_for_each_cell(const Curve& points, const Axis& x, const Axis& y) {
  std::vector<std::array<double, 4>> sums(x.count * y.count);
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& cell = sums[y.index(points.columns[1][i]) * x.count + x.index(points.columns[0][i])];
    for (std::size_t k = 0; k < 3; ++k) cell[k] += points.columns[k][i];
    cell[3] += 1.0;
  }
  Curve result{std::vector<std::vector<double>>(3), 0};
  for (const auto& cell : sums)
    for (std::size_t k = 0; k < 3 && cell[3] > 0.0; ++k) result.columns[k].push_back(cell[k] / cell[3]);
  return result;
}

/// Plane through the values at three points.
class Facet {
 public:
  Facet(const Curve& points, const Corners& corners) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) at_[i][k] = points.columns[k][corners[i]];
  }

  double longest_edge() const {
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = at_[i], &b = at_[(i + 1) % 3];
      longest = std::max(longest, std::hypot(b[0] - a[0], b[1] - a[1]));
    }
    return longest;
  }

  /// Sets the cells whose centres are inside the triangle.
  void paint(Grid& grid) const {
    const auto [first, last] = cells(0, grid.x, grid.dx, grid.columns);
    const auto [low, high] = cells(1, grid.y, grid.dy, grid.rows);
    for (std::size_t row = low; row < high; ++row)
      for (std::size_t column = first; column < last; ++column) {
        const double value = value_at(grid.x + static_cast<double>(column) * grid.dx,
                                      grid.y + static_cast<double>(row) * grid.dy);
        if (!std::isnan(value)) grid.at(column, row) = value;
      }
  }

 private:
  /// Returns the range of cells along an axis that it may cover, [first, end).
  std::pair<std::size_t, std::size_t> cells(std::size_t axis, double start, double step,
                                            std::size_t count) const {
    const auto [low, high] = std::minmax({at_[0][axis], at_[1][axis], at_[2][axis]});
    const auto cell = [&](double value) {
      return static_cast<std::size_t>(std::clamp((value - start) / step, 0.0, static_cast<double>(count)));
    };
    return {cell(low), std::min(cell(high) + 1, count)};
  }

  double part(std::size_t i, double x, double y) const {
    const auto &a = at_[(i + 1) % 3], &b = at_[(i + 2) % 3];
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
  }

  double value_at(double x, double y) const {
    const double whole = part(0, at_[0][0], at_[0][1]);
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = part(i, x, y) / whole;
      if (!(share >= -1e-9)) return nothing;
      sum += share * at_[i][2];
    }
    return sum;
  }

  std::array<std::array<double, 3>, 3> at_;
};

/// Interpolates linearly between measured points that are not farther apart than the gap.
void fill_gaps(const Curve& points, double gap, Grid& grid) {
  const double widest = std::max(gap, 2.0 * std::hypot(grid.dx, grid.dy));
  for (const Corners& corners : triangulate(points.columns[0], points.columns[1])) {
    const Facet facet(points, corners);
    if (facet.longest_edge() <= widest) facet.paint(grid);
  }
}

/// Axis of a window: cells not larger than those of the grid, and for each the cell of the grid at its
/// centre, if any.
struct WindowAxis {
  Axis axis;
  std::vector<std::optional<std::size_t>> from;

  WindowAxis(double first, double step, std::size_t count, const Extent& window) {
    constexpr double fine = 200.0;
    const double width = window.high - window.low;
    const double cells = std::ceil(std::max(width / step, fine));
    axis = {window.low + 0.5 * width / cells, width / cells, static_cast<std::size_t>(cells)};
    for (std::size_t i = 0; i < axis.count; ++i) {
      const double cell = std::round((axis.first + static_cast<double>(i) * axis.step - first) / step);
      const bool inside = cell >= 0.0 && cell < static_cast<double>(count);
      from.push_back(inside ? std::optional(static_cast<std::size_t>(cell)) : std::nullopt);
    }
  }
};

/// True if cells reach beyond a window.
bool reaches_beyond(double first, double step, std::size_t count, const Extent& window) {
  const double low = first - 0.5 * step, high = low + static_cast<double>(count) * step, slack = 1e-6 * step;
  return low < window.low - slack || high > window.high + slack;
}

struct Point {
  double x = 0.0, y = 0.0;
};

/// Edge between two neighbouring centres: the lower left one, and whether it is vertical.
using Edge = std::pair<std::size_t, bool>;

/// Traces contours by marching squares: each square of four centres contributes one or two segments, which
/// are linked at the edges that they cross.
class Tracer {
 public:
  Tracer(const Grid& grid, double level) : grid_(grid), level_(level) {}

  std::vector<Curve> trace() {
    for (std::size_t row = 0; row + 1 < grid_.rows; ++row)
      for (std::size_t column = 0; column + 1 < grid_.columns; ++column) cross(column, row);
    std::vector<Curve> curves;
    // Open curves first, from their ends; the remaining ones are closed.
    for (const bool open : {true, false})
      for (const auto& [edge, next] : links_)
        if (!next.empty() && (!open || next.size() == 1)) curves.push_back(follow(edge));
    return curves;
  }

 private:
  std::size_t cell(std::size_t column, std::size_t row) const { return row * grid_.columns + column; }

  bool above(std::size_t cell) const { return grid_.values[cell] >= level_; }

  void cross(std::size_t column, std::size_t row) {
    const std::size_t a = cell(column, row), b = a + 1, d = a + grid_.columns, c = d + 1;
    for (const std::size_t corner : {a, b, c, d})
      if (std::isnan(grid_.values[corner])) return;
    std::vector<Edge> crossed;
    if (above(a) != above(b)) crossed.push_back({a, false});
    if (above(b) != above(c)) crossed.push_back({b, true});
    if (above(c) != above(d)) crossed.push_back({d, false});
    if (above(d) != above(a)) crossed.push_back({a, true});
    // A saddle has four crossings; its first corner decides how they are paired.
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) link(crossed[i], crossed[i + 1]);
  }

  void link(const Edge& from, const Edge& to) {
    links_[from].push_back(to);
    links_[to].push_back(from);
  }

  Point point(const Edge& edge) const {
    const std::size_t first = edge.first, second = first + (edge.second ? grid_.columns : 1);
    const double part = (level_ - grid_.values[first]) / (grid_.values[second] - grid_.values[first]);
    const double column = static_cast<double>(first % grid_.columns) + (edge.second ? 0.0 : part);
    const double row = static_cast<double>(first / grid_.columns) + (edge.second ? part : 0.0);
    return {grid_.x + column * grid_.dx, grid_.y + row * grid_.dy};
  }

  void unlink(const Edge& from, const Edge& to) {
    auto& list = links_[from];
    for (auto i = list.begin(); i != list.end(); ++i)
      if (*i == to) {
        list.erase(i);
        return;
      }
  }

  Curve follow(Edge edge) {
    Curve curve{{{}, {}}, 0};
    while (true) {
      const Point here = point(edge);
      curve.columns[0].push_back(here.x);
      curve.columns[1].push_back(here.y);
      if (links_[edge].empty()) return curve;
      const Edge next = links_[edge].front();
      unlink(edge, next);
      unlink(next, edge);
      edge = next;
    }
  }

  const Grid& grid_;
  double level_;
  std::map<Edge, std::vector<Edge>> links_;
};

}  // namespace

std::vector<Corners> triangulate(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 3) return {};
  const std::vector<IntegerPoint> points = scaled(x, y);
  Diagram cells;
  boost::polygon::construct_voronoi(points.begin(), points.end(), &cells);
  std::vector<Corners> triangles;
  for (const auto& corner : cells.vertices()) {
    const std::vector<std::size_t> around = points_around(corner);
    for (std::size_t i = 2; i < around.size(); ++i)
      triangles.push_back({around[0], around[i - 1], around[i]});
  }
  return triangles;
}

Grid within(const Grid& grid, const Extent& across, const Extent& up) {
  if (!reaches_beyond(grid.x, grid.dx, grid.columns, across) &&
      !reaches_beyond(grid.y, grid.dy, grid.rows, up))
    return grid;
  const WindowAxis x(grid.x, grid.dx, grid.columns, across), y(grid.y, grid.dy, grid.rows, up);
  Grid seen{x.axis.first, y.axis.first, x.axis.step, y.axis.step, x.axis.count, y.axis.count, {}};
  for (const auto& row : y.from)
    for (const auto& column : x.from) seen.values.push_back(row && column ? grid.at(*column, *row) : nothing);
  return seen;
}

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
  const Axis columns = cut(points.columns[0], step(across)), rows = cut(points.columns[1], step(up));
  Grid grid = average(points, columns, rows);
  fill_gaps(one_for_each_cell(points, columns, rows), gap, grid);
  return grid;
}

std::vector<Curve> contour(const Grid& grid, double level) {
  return Tracer(grid, level).trace();
}

}  // namespace stepwire::geometry
