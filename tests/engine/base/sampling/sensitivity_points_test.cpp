#include "engine/base/sampling/sensitivity_points.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

namespace stepwire::sampling {

TEST_CASE("a sample of Saltelli is two points, and the first with each number of the second") {
  const Points points = points_of({Layout::saltelli, 8, 1}, 3);
  REQUIRE(points[0].size() == 40);
  for (std::size_t sample = 0; sample < 40; sample += 5)
    for (std::size_t d = 0; d < 3; ++d) {
      const double a = points[d][sample], b = points[d][sample + 1];
      CHECK(a != b);
      for (std::size_t k = 0; k < 3; ++k) CHECK(points[d][sample + 2 + k] == (k == d ? b : a));
    }
}

TEST_CASE("a way of Morris goes half of the cube along each dimension once") {
  const Points points = points_of({Layout::morris, 50, 1}, 4);
  REQUIRE(points[0].size() == 250);
  std::set<std::size_t> first;
  for (std::size_t way = 0; way < 250; way += 5) {
    std::set<std::size_t> changed;
    for (std::size_t i = way + 1; i < way + 5; ++i)
      for (std::size_t d = 0; d < 4; ++d)
        if (points[d][i] != points[d][i - 1]) {
          if (i == way + 1) first.insert(d);
          changed.insert(d);
          CHECK(std::abs(points[d][i] - points[d][i - 1]) == morris_step);
        }
    CHECK(changed.size() == 4);
  }
  CHECK(first.size() == 4);
  for (const auto& numbers : points)
    CHECK(std::set<double>(numbers.begin(), numbers.end()) == std::set<double>{0.125, 0.375, 0.625, 0.875});
}

TEST_CASE("fewer samples of a sensitivity are the first of more") {
  for (const Layout layout : {Layout::saltelli, Layout::morris}) {
    const Points few = points_of({layout, 5, 2}, 3), many = points_of({layout, 20, 2}, 3);
    for (std::size_t d = 0; d < 3; ++d) CHECK(std::equal(few[d].begin(), few[d].end(), many[d].begin()));
  }
}

}  // namespace stepwire::sampling
