#include "engine/figure/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stepwire {
namespace {

struct Point {
  double x = 0.0, y = 0.0;
};

/// Twice the area of a triangle, positive where it runs counterclockwise.
double area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Is d inside of the circle through a, b and c?
bool in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  return ax * (by * cc - bb * cy) - ay * (bx * cc - bb * cx) + aa * (bx * cy - by * cx) > 0.0;
}

/// Points are put in one after the other: the triangles whose circles hold the new point go, and the hole is
/// filled with triangles around it (Bowyer and Watson).
class Delaunay {
 public:
  explicit Delaunay(std::vector<Point> points) : points_(std::move(points)), count_(points_.size()) {
    constexpr double far = 30.0;  // the points lie in a square of 1
    for (const Point corner : {Point{-far, -far}, Point{far, -far}, Point{0.5, far}})
      points_.push_back(corner);
    triangles_.push_back({{count_, count_ + 1, count_ + 2}, {none, none, none}, false});
  }

  void put_in(std::size_t point) {
    const std::size_t start = around(point);
    if (start == none) return;
    gather_hole(start, point);
    if (is_seen_from(point)) fill(point);
  }

  std::vector<Corners> triangles() const {
    std::vector<Corners> result;
    for (const Triangle& triangle : triangles_) {
      const bool inner =
          std::all_of(triangle.corner.begin(), triangle.corner.end(), [&](auto i) { return i < count_; });
      if (!triangle.gone && inner) result.push_back(triangle.corner);
    }
    return result;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Triangle {
    Corners corner;
    Corners beside;  ///< beside[i] lies across from corner[i]
    bool gone = false;
  };

  /// A side of the hole: from, to, and the triangle beyond.
  struct Side {
    std::size_t from, to, beyond;
  };

  double area_with(const Triangle& triangle, std::size_t side, std::size_t point) const {
    return area(points_[triangle.corner[(side + 1) % 3]], points_[triangle.corner[(side + 2) % 3]],
                points_[point]);
  }

  /// Walks from the last triangle toward the point.
  std::size_t around(std::size_t point) const {
    std::size_t now = last_;
    for (std::size_t steps = 0; steps < triangles_.size(); ++steps) {
      std::size_t next = none;
      for (std::size_t side = 0; side < 3; ++side)
        if (area_with(triangles_[now], side, point) < 0.0) next = triangles_[now].beside[side];
      if (next == none) return now;
      now = next;
    }
    return none;
  }

  bool holds(std::size_t triangle, std::size_t point) const {
    const Corners& at = triangles_[triangle].corner;
    return in_circle(points_[at[0]], points_[at[1]], points_[at[2]], points_[point]);
  }

  void gather_hole(std::size_t start, std::size_t point) {
    hole_.assign(1, start);
    sides_.clear();
    for (std::size_t i = 0; i < hole_.size(); ++i) {
      const Triangle triangle = triangles_[hole_[i]];
      for (std::size_t side = 0; side < 3; ++side) {
        const std::size_t beyond = triangle.beside[side];
        if (beyond != none && std::find(hole_.begin(), hole_.end(), beyond) != hole_.end()) continue;
        if (beyond != none && holds(beyond, point))
          hole_.push_back(beyond);
        else
          sides_.push_back({triangle.corner[(side + 1) % 3], triangle.corner[(side + 2) % 3], beyond});
      }
    }
    // A side may have been looked at before the triangle beyond it was taken in.
    std::erase_if(sides_, [&](const Side& side) {
      return std::find(hole_.begin(), hole_.end(), side.beyond) != hole_.end();
    });
  }

  /// Else rounding has spoilt the hole, and the point is left out.
  bool is_seen_from(std::size_t point) const {
    return std::all_of(sides_.begin(), sides_.end(), [&](const Side& side) {
      return area(points_[side.from], points_[side.to], points_[point]) > 0.0;
    });
  }

  void fill(std::size_t point) {
    for (const std::size_t triangle : hole_) triangles_[triangle].gone = true;
    const std::size_t first = triangles_.size();
    for (const Side& side : sides_) {
      triangles_.push_back({{side.from, side.to, point}, {none, none, side.beyond}});
      tie(side, triangles_.size() - 1);
    }
    for (std::size_t i = 0; i < sides_.size(); ++i)
      for (std::size_t k = 0; k < sides_.size(); ++k) {
        if (sides_[k].from == sides_[i].to) triangles_[first + i].beside[0] = first + k;
        if (sides_[k].to == sides_[i].from) triangles_[first + i].beside[1] = first + k;
      }
    last_ = first;
  }

  void tie(const Side& side, std::size_t triangle) {
    if (side.beyond == none) return;
    Triangle& beyond = triangles_[side.beyond];
    for (std::size_t i = 0; i < 3; ++i)
      if (beyond.corner[(i + 1) % 3] == side.to && beyond.corner[(i + 2) % 3] == side.from)
        beyond.beside[i] = triangle;
  }

  std::vector<Point> points_;
  std::size_t count_, last_ = 0;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> hole_;
  std::vector<Side> sides_;
};

/// In a square of 1, and moved by less than anybody sees, so that no four lie on one circle.
std::vector<Point> scaled(const std::vector<double>& x, const std::vector<double>& y) {
  const auto [left, right] = std::minmax_element(x.begin(), x.end());
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  const double size = std::max({*right - *left, *high - *low, 1e-300});
  std::vector<Point> points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double n = static_cast<double>(i);
    points.push_back({(x[i] - *left) / size + 1e-7 * std::sin(12.9898 * n),
                      (y[i] - *low) / size + 1e-7 * std::cos(78.233 * n)});
  }
  return points;
}

/// Row by row to and fro, so that each point is near to the one before.
std::vector<std::size_t> to_and_fro(const std::vector<Point>& points) {
  const double rows = std::ceil(std::sqrt(static_cast<double>(points.size()) + 1.0));
  const auto row = [&](std::size_t i) { return static_cast<long>(points[i].y * rows); };
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (row(a) != row(b)) return row(a) < row(b);
    return row(a) % 2 == 0 ? points[a].x < points[b].x : points[a].x > points[b].x;
  });
  return order;
}

}  // namespace

std::vector<Corners> triangulate(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 3) return {};
  const std::vector<Point> points = scaled(x, y);
  Delaunay delaunay(points);
  for (const std::size_t point : to_and_fro(points)) delaunay.put_in(point);
  return delaunay.triangles();
}

}  // namespace stepwire
