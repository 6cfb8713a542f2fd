#include "engine/view/geometry/grid.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

namespace stepwire::geometry {

namespace {

struct Points {
  std::vector<double> x, y;
};

Points scattered(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  Points points;
  for (int i = 0; i < count; ++i) {
    points.x.push_back(anywhere(random));
    points.y.push_back(anywhere(random));
  }
  return points;
}

double area(const Points& points, const Corners& at) {
  return 0.5 * ((points.x[at[1]] - points.x[at[0]]) * (points.y[at[2]] - points.y[at[0]]) -
                (points.y[at[1]] - points.y[at[0]]) * (points.x[at[2]] - points.x[at[0]]));
}

/// The circle through the corners of a triangle, by its definition: equally far from all of them.
struct Circle {
  double x, y, radius;
};

Circle circle_through(const Points& p, const Corners& at) {
  const double ax = p.x[at[0]], ay = p.y[at[0]], bx = p.x[at[1]] - ax, by = p.y[at[1]] - ay;
  const double cx = p.x[at[2]] - ax, cy = p.y[at[2]] - ay, d = 2.0 * (bx * cy - by * cx);
  const double ux = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / d;
  const double uy = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / d;
  return {ax + ux, ay + uy, std::hypot(ux, uy)};
}

}  // namespace

TEST_CASE("no point lies inside of the circle of a triangle") {
  const Points points = scattered(150);
  for (const Corners& triangle : triangulate(points.x, points.y)) {
    const Circle circle = circle_through(points, triangle);
    for (std::size_t i = 0; i < points.x.size(); ++i)
      CHECK(std::hypot(points.x[i] - circle.x, points.y[i] - circle.y) > circle.radius * (1.0 - 1e-6) - 1e-8);
  }
}

TEST_CASE(
    "triangles run counterclockwise and cover a lattice once, though four of its points share a circle") {
  Points points;
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 30; ++column) {
      points.x.push_back(column);
      points.y.push_back(row);
    }
  double covered = 0.0;
  for (const Corners& triangle : triangulate(points.x, points.y)) {
    CHECK(area(points, triangle) > 0.0);
    covered += area(points, triangle);
  }
  CHECK(covered == Approx(29.0 * 19.0).epsilon(1e-9));
}

TEST_CASE("fewer than three points, and points in one line, have no triangles that cover anything") {
  CHECK(triangulate({0.0, 1.0}, {0.0, 1.0}).empty());
  Points line;
  for (int i = 0; i < 10; ++i) {
    line.x.push_back(i);
    line.y.push_back(2.0 * i);
  }
  for (const Corners& triangle : triangulate(line.x, line.y)) CHECK(std::abs(area(line, triangle)) < 1e-6);
}

TEST_CASE("no point is left out, and points that are the same are one") {
  Points points = scattered(200);
  std::set<std::size_t> corners;
  for (const Corners& triangle : triangulate(points.x, points.y))
    corners.insert(triangle.begin(), triangle.end());
  CHECK(corners.size() == 200);
  const std::size_t count = triangulate(points.x, points.y).size();
  points.x.push_back(points.x.front());
  points.y.push_back(points.y.front());
  CHECK(triangulate(points.x, points.y).size() == count);
}

}  // namespace stepwire::geometry
