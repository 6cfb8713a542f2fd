#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/blocks/haptics/region_rig.hpp"

using namespace stepwire;

namespace {

using Point = std::vector<double>;

constexpr double promised = 1e-9;  // [m]
constexpr double mm = 1e-3;

Edge circle_edge(Point centre, double radius) {
  return {[=](double t) {
    const double angle = 2.0 * std::numbers::pi * t;
    return Point{centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
  }};
}

Edge line_edge(Point a, Point b) {
  return {[=](double t) { return Point{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}; }};
}

double distance_to_line(Point a, Point b, Point p) {
  const double ux = b[0] - a[0], uy = b[1] - a[1];
  const double t = std::clamp(((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / (ux * ux + uy * uy), 0.0, 1.0);
  return std::hypot(p[0] - a[0] - t * ux, p[1] - a[1] - t * uy);
}

double distance_to_path(const std::vector<Point>& path, Point p) {
  double best = 1e9;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    best = std::min(best, distance_to_line(path[i], path[i + 1], p));
  return best;
}

std::string text_of(const std::vector<Point>& points) {
  std::string text;
  for (const Point& point : points)
    text += (text.empty() ? "[[" : ", [") + std::to_string(point[0] / mm) + " mm, " +
            std::to_string(point[1] / mm) + " mm]";
  return text + "]";
}

/// Positions all over a square, the same ones each time.
std::vector<Point> positions(double half_width, int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-half_width, half_width);
  std::vector<Point> all;
  for (int i = 0; i < count; ++i) all.push_back({anywhere(random), anywhere(random)});
  return all;
}

/// Distance, its sign, the nearest point and the direction against brute force.
void check_all(const std::string& shape, const std::vector<Edge>& edges,
               const std::function<bool(Point)>& inside, const std::vector<Point>& tried) {
  RegionRig region(shape);
  for (const Point& p : tried) {
    INFO(shape << " at " << p[0] / mm << ", " << p[1] / mm);
    const Answer answer = region.at(p);
    const double wanted = brute_force(edges, p);
    CHECK(std::abs(std::abs(answer.distance) - wanted) < promised);
    if (wanted > promised) CHECK((answer.distance < 0.0) == inside(p));
    CHECK(std::hypot(answer.direction[0], answer.direction[1]) == Approx(1.0).margin(1e-12));
    for (int i = 0; i < 2; ++i)
      CHECK(std::abs(p[i] - answer.distance * answer.direction[i] - answer.nearest[i]) < promised);
  }
}

}  // namespace

TEST_CASE("The distance from a circle and an annulus is that from brute force") {
  check_all(
      "{center: [3 mm, -2 mm], radius: 8 mm}", {circle_edge({3 * mm, -2 * mm}, 8 * mm)},
      [](Point p) { return std::hypot(p[0] - 3 * mm, p[1] + 2 * mm) < 8 * mm; }, positions(20 * mm, 40));
  check_all(
      "{center: [0 mm, 0 mm], radius: 10 mm, inner_radius: 4 mm}",
      {circle_edge({0, 0}, 10 * mm), circle_edge({0, 0}, 4 * mm)},
      [](Point p) { return std::hypot(p[0], p[1]) < 10 * mm && std::hypot(p[0], p[1]) > 4 * mm; },
      positions(14 * mm, 40));
}

TEST_CASE("The distance from a polygon with a notch is that from brute force, whichever way it is given") {
  std::vector<Point> corners{
      {-9 * mm, -7 * mm}, {9 * mm, -7 * mm}, {9 * mm, 8 * mm}, {0, -5 * mm}, {-9 * mm, 8 * mm}};
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edges.push_back(line_edge(corners[i], corners[(i + 1) % corners.size()]));
  const auto inside = [](Point p) {
    return std::abs(p[0]) < 9 * mm && p[1] > -7 * mm && p[1] < -5 * mm + std::abs(p[0]) * 13.0 / 9.0;
  };
  check_all("{polygon: " + text_of(corners) + "}", edges, inside, positions(15 * mm, 60));
  std::reverse(corners.begin(), corners.end());
  check_all("{polygon: " + text_of(corners) + "}", edges, inside, positions(15 * mm, 20));
}

TEST_CASE("The distance from a corridor with bends of either sense is that from brute force") {
  const std::vector<Point> path{
      {-12 * mm, -9 * mm}, {-3 * mm, 6 * mm}, {2 * mm, -4 * mm}, {4 * mm, -4 * mm}, {11 * mm, 7 * mm}};
  const double h = 1.7 * mm;
  const auto on_edge = [=](const Point& q) { return distance_to_path(path, q) > h - 1e-12; };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < path.size(); ++i) {
    edges.push_back(circle_edge(path[i], h));
    if (i + 1 == path.size()) break;
    const Point a = path[i], b = path[i + 1];
    const double whole = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double nx = -(b[1] - a[1]) / whole * h, ny = (b[0] - a[0]) / whole * h;
    edges.push_back(line_edge({a[0] + nx, a[1] + ny}, {b[0] + nx, b[1] + ny}));
    edges.push_back(line_edge({a[0] - nx, a[1] - ny}, {b[0] - nx, b[1] - ny}));
  }
  for (Edge& edge : edges) edge.kept = on_edge;
  const std::string shape = "{corridor: " + text_of(path) + ", half_width: 1.7 mm}";
  check_all(
      shape, edges, [=](Point p) { return distance_to_path(path, p) < h; }, positions(15 * mm, 60));
  std::vector<Point> close;  // within the corridor, also where its inner bends are nearest
  for (const Point& p : path)
    for (const Point& d : positions(1.6 * mm, 8)) close.push_back({p[0] + d[0], p[1] + d[1]});
  check_all(
      shape, edges, [=](Point p) { return distance_to_path(path, p) < h; }, close);
}

TEST_CASE("The distance from boundaries that are functions of y is that from brute force") {
  const auto right = [](double y) {
    return (5 * std::sin(2 * std::numbers::pi * (y / mm - 180) / 40) + 6) * mm;
  };
  const auto left = [](double y) { return (-8 + 0.01 * (y / mm - 200) * (y / mm - 200)) * mm; };
  const auto curve = [](auto f) {
    return Edge{[f](double t) { return Point{f((180 + 40 * t) * mm), (180 + 40 * t) * mm}; }};
  };
  std::vector<Edge> edges{curve(left), curve(right)};
  for (const double y : {180 * mm, 220 * mm}) edges.push_back(line_edge({left(y), y}, {right(y), y}));
  std::vector<Point> tried = positions(25 * mm, 80);
  for (Point& p : tried) p[1] += 200 * mm;
  check_all(
      "{left: \"-8 mm + (y - 200 mm)^2/(100 mm)\", right: \"6 mm + 5 mm*sin(2*pi*(y - 180 mm)/(40 mm))\", y: "
      "[180 mm, 220 mm]}",
      edges,
      [&](Point p) { return p[1] > 180 * mm && p[1] < 220 * mm && p[0] > left(p[1]) && p[0] < right(p[1]); },
      tried);
}

TEST_CASE("Near the centres of curvature of a boundary the nearest point is still the nearest") {
  // Beside the axis of a parabola many of its points are almost equally near.
  const Edge parabola{[](double t) {
    const double y = (-20 + 40 * t) * mm;
    return Point{y * y / 0.02, y};
  }};
  std::vector<Point> tried;
  for (int i = 0; i < 40; ++i) tried.push_back({(9.9 + 0.01 * i) * mm, (i % 5 - 2) * 1e-6});
  std::vector<Edge> edges{parabola};
  RegionRig region("{left: \"y^2/(20 mm)\", y: [-20 mm, 20 mm]}");
  for (const Point& p : tried) {
    INFO(p[0] << " " << p[1]);
    CHECK(std::abs(-region.at(p).distance - brute_force(edges, p)) < promised);
  }
}

TEST_CASE("A union has neither the edges of its members that lie inside of it nor those that they share") {
  const std::string shape =
      "{union: [{polygon: [[-9 mm, -4 mm], [0 mm, -4 mm], [0 mm, 4 mm], [-9 mm, 4 mm]]}, "
      "{polygon: [[0 mm, -4 mm], [9 mm, -4 mm], [9 mm, 4 mm], [0 mm, 4 mm]]}, "
      "{center: [0 mm, 3 mm], radius: 5 mm}]}";
  const Edge circle = circle_edge({0, 3 * mm}, 5 * mm);
  std::vector<Edge> edges{line_edge({-9 * mm, -4 * mm}, {9 * mm, -4 * mm}),
                          line_edge({9 * mm, -4 * mm}, {9 * mm, 4 * mm}),
                          line_edge({9 * mm, 4 * mm}, {-9 * mm, 4 * mm}),
                          line_edge({-9 * mm, 4 * mm}, {-9 * mm, -4 * mm}), circle};
  edges[2].kept = [](const Point& q) { return std::hypot(q[0], q[1] - 3 * mm) >= 5 * mm; };
  edges[4].kept = [](const Point& q) { return q[1] >= 4 * mm; };
  const auto inside = [](Point p) {
    return (std::abs(p[0]) < 9 * mm && std::abs(p[1]) < 4 * mm) || std::hypot(p[0], p[1] - 3 * mm) < 5 * mm;
  };
  std::vector<Point> tried = positions(14 * mm, 80);
  tried.push_back({0, 0});
  tried.push_back({0, 1 * mm});
  // The search of brute force ends just beside the ends of a kept part, so the corners are added as edges.
  const double corner = std::sqrt(25.0 - 1.0) * mm;
  for (const double x : {-corner, corner}) edges.push_back(line_edge({x, 4 * mm}, {x, 4 * mm}));
  check_all(shape, edges, inside, tried);
}

TEST_CASE("A closed spline through points of a circle lies beside it, with its hole") {
  std::vector<Point> points;
  for (int i = 0; i < 36; ++i) {
    const double angle = 2 * std::numbers::pi * i / 36;
    points.push_back({10 * mm * std::cos(angle), 10 * mm * std::sin(angle)});
  }
  RegionRig region("{spline: " + text_of(points) + ", half_width: 1 mm, closed: true}");
  for (const Point& p : positions(14 * mm, 60)) {
    // The spline leaves the circle by (pi/36)^4/24 of its radius at most; the points have six digits.
    const double wanted = std::abs(std::hypot(p[0], p[1]) - 10 * mm) - 1 * mm;
    if (std::hypot(p[0], p[1]) > 1 * mm) CHECK(region.at(p).distance == Approx(wanted).margin(3e-8));
  }
  CHECK(region.at({0, 0}).distance == Approx(9 * mm).margin(3e-8));
}

TEST_CASE("A spline is smooth through its points and straight at its ends") {
  // The natural cubic through (0,0), (1,1), (2,0) over equal lengths has x = s and a known middle of a half.
  RegionRig region("{spline: [[0 mm, 0 mm], [10 mm, 10 mm], [20 mm, 0 mm]], half_width: 0.1 mm}");
  CHECK(region.at({10 * mm, 10 * mm}).distance == Approx(-0.1 * mm).margin(promised));
  CHECK(region.at({5 * mm, 6.875 * mm}).distance == Approx(-0.1 * mm).margin(promised));
  CHECK(region.at({15 * mm, 6.875 * mm}).distance == Approx(-0.1 * mm).margin(promised));
}

TEST_CASE("A side that is left out is not there") {
  RegionRig region("{right: \"-10 mm + 0.5*(y - 180 mm)\", y: [0 mm, 400 mm]}");
  const double slope = std::hypot(1.0, 0.5);
  CHECK(region.at({3 * mm, 200 * mm}).distance == Approx(3 * mm / slope).margin(promised));
  CHECK(region.at({-50 * mm, 200 * mm}).distance == Approx(-50 * mm / slope).margin(promised));
  CHECK(region.at({-5.0, 200 * mm}).distance == Approx(-0.2).margin(promised));  // 200 mm from both ends of y
  CHECK(region.at({-5.0, 0.5}).distance == Approx(0.1).margin(promised));
}

TEST_CASE("Spheres, shells and straight corridors in space have their distances") {
  RegionRig sphere("{center: [0, 0, 0], radius: 8 mm}");
  const Answer answer = sphere.at({3 * mm, 4 * mm, 12 * mm});
  CHECK(answer.distance == Approx(5 * mm).margin(1e-15));
  CHECK(answer.nearest[2] == Approx(12.0 / 13.0 * 8 * mm).margin(1e-15));
  CHECK(answer.direction[0] == Approx(3.0 / 13.0).margin(1e-15));
  RegionRig shell("{center: [0, 0, 0], radius: 8 mm, inner_radius: 2 mm}");
  CHECK(shell.at({1 * mm, 0, 0}).distance == Approx(1 * mm));
  CHECK(shell.at({1 * mm, 0, 0}).direction == Point{-1, 0, 0});
  CHECK(shell.at({0, 4 * mm, 0}).distance == Approx(-2 * mm));
  RegionRig both(
      "{union: [{center: [0, 0, 0], radius: 2 mm}, {corridor: [[5 mm, 0, 0], [5 mm, 9 mm, 0]], half_width: 1 "
      "mm}]}");
  CHECK(both.at({5 * mm, 4 * mm, 3 * mm}).distance == Approx(2 * mm));
  CHECK(both.at({3 * mm, 0, 0}).distance == Approx(1 * mm));
  CHECK(both.at({5 * mm, 10.5 * mm, 0}).direction[1] == Approx(1.0));
}

TEST_CASE("Ties are decided as documented") {
  RegionRig circle("{center: [1 mm, 2 mm], radius: 8 mm}");
  CHECK(circle.at({1 * mm, 2 * mm}).distance == Approx(-8 * mm));
  CHECK(circle.at({1 * mm, 2 * mm}).direction[0] == Approx(1.0));
  RegionRig sphere("{center: [0, 0, 0], radius: 8 mm}");
  CHECK(sphere.at({0, 0, 0}).direction == Point{1, 0, 0});
  RegionRig square("{polygon: [[-1, -1], [1, -1], [1, 1], [-1, 1]]}");
  CHECK(square.at({0, 0}).nearest == Point{0, -1});
  CHECK(square.at({0.5, 0.5}).nearest == Point{1, 0.5});
  CHECK(square.at({1.0, 0.2}).distance == Approx(0.0).margin(1e-15));
  CHECK(square.at({1.0, 0.2}).direction == Point{1, 0});
  CHECK(square.at({2.0, 2.0}).nearest == Point{1, 1});
  CHECK(square.at({2.0, 2.0}).distance == Approx(std::sqrt(2.0)));
}

TEST_CASE("Outside of a sharp corner is outside, on either side of it") {
  RegionRig wedge("{polygon: [[0, 0], [-1, 0.1], [-1, -0.1]]}");
  for (const double y : {-0.3, -0.05, -0.001, 0.0, 0.001, 0.05, 0.3})
    CHECK(wedge.at({0.1, y}).distance > 0.0);
  RegionRig notch("{polygon: [[0, 0], [1, 0.1], [1, 1], [-1, 1], [-1, -1], [1, -1], [1, -0.1]]}");
  for (const double y : {-0.3, -0.05, 0.0, 0.05, 0.3}) CHECK(notch.at({-0.1, y}).distance < 0.0);
}
