#include "engine/view/geometry/grid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace stepwire::geometry {

TEST_CASE("rows on a lattice keep its cells, and a missing one stays empty") {
  Curve points{{{0, 2, 0, 2, 0}, {0, 0, 1, 1, 2}, {1, 2, 3, 4, 5}}, 0};
  const Grid grid = make_grid(points, 100, 10.0);
  REQUIRE(grid.columns == 2);
  REQUIRE(grid.rows == 3);
  CHECK(grid.dx == 2.0);
  CHECK(grid.at(1, 1) == 4.0);
  CHECK(grid.at(0, 2) == 5.0);
  CHECK(std::isnan(grid.at(1, 2)));
}

TEST_CASE("gaps between scattered rows are filled and the outside stays empty") {
  // Rays over a disk of radius 1, 10 degrees apart, with the value x: linear between them it is x again.
  Curve points{{{}, {}, {}}, 0};
  for (int ray = 0; ray < 36; ++ray)
    for (int i = 0; i <= 200; ++i) {
      const double angle = 0.17453292519943295 * ray, radius = i / 200.0;
      points.columns[0].push_back(radius * std::cos(angle));
      points.columns[1].push_back(radius * std::sin(angle));
      points.columns[2].push_back(radius * std::cos(angle));
    }
  const Grid grid = make_grid(points, 100, 0.25);
  int inside = 0, wrong = 0, outside = 0;
  for (std::size_t row = 0; row < grid.rows; ++row)
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const double x = grid.x + static_cast<double>(column) * grid.dx,
                   y = grid.y + static_cast<double>(row) * grid.dy;
      const double value = grid.at(column, row);
      // Between the tips of two rays the rim is straight.
      if (std::hypot(x, y) < 0.98) {
        ++inside;
        if (!(std::abs(value - x) < 0.006)) ++wrong;
      }
      if (std::hypot(x, y) > 1.01 && !std::isnan(value)) ++outside;
    }
  CHECK(inside > 7400);
  CHECK(wrong == 0);
  CHECK(outside == 0);
}

TEST_CASE("a wide gap stays open") {
  Curve points{{{}, {}, {}}, 0};
  for (int i = 0; i <= 1000; ++i)
    for (const double y : {0.0, 0.013, 1.0}) {
      points.columns[0].push_back(0.0011 * i * (1.0 + 1e-3 * i));
      points.columns[1].push_back(y);
      points.columns[2].push_back(1.0);
    }
  const Grid grid = make_grid(points, 50, 0.2);
  CHECK(std::isnan(grid.at(25, 25)));
  CHECK_FALSE(std::isnan(grid.at(25, 0)));
}

TEST_CASE("the contour of a cone is one closed circle") {
  Grid grid{-1.0, -1.0, 0.02, 0.02, 101, 101, std::vector<double>(101 * 101)};
  for (std::size_t row = 0; row < 101; ++row)
    for (std::size_t column = 0; column < 101; ++column)
      grid.at(column, row) =
          std::hypot(-1.0 + 0.02 * static_cast<double>(column), -1.0 + 0.02 * static_cast<double>(row));
  const auto curves = contour(grid, 0.5);
  REQUIRE(curves.size() == 1);
  const Curve& circle = curves.front();
  CHECK(circle.columns[0].front() == circle.columns[0].back());
  for (std::size_t i = 0; i < circle.size(); ++i)
    CHECK(std::hypot(circle.columns[0][i], circle.columns[1][i]) == Approx(0.5).epsilon(1e-3));
}

TEST_CASE("a contour that leaves the grid is one open curve") {
  Grid grid{0.0, 0.0, 1.0, 1.0, 5, 4, {}};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 5; ++column) grid.values.push_back(column);
  const auto curves = contour(grid, 1.5);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].columns[0] == std::vector<double>{1.5, 1.5, 1.5, 1.5});
}

}  // namespace stepwire::geometry
