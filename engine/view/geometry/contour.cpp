#include <cmath>
#include <map>
#include <utility>

#include "engine/view/geometry/grid.hpp"

namespace stepwire::geometry {
namespace {

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

std::vector<Curve> contour(const Grid& grid, double level) {
  return Tracer(grid, level).trace();
}

}  // namespace stepwire::geometry
