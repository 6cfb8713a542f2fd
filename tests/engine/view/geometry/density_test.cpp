#include "engine/view/geometry/density.hpp"

#include <catch2/catch.hpp>
#include <numeric>

namespace stepwire::geometry {

TEST_CASE("a curve counts once in each cell that it goes through") {
  const Curve level{{{0.0, 10.0}, {0.5, 0.5}}}, there_and_back{{{0.0, 10.0, 0.0}, {1.5, 1.5, 1.5}}},
      up{{{2.5, 2.5}, {0.0, 3.0}}};
  const Density density = density_of({level, level, there_and_back, up}, {0.0, 10.0}, {0.0, 3.0}, 10, 3);
  for (std::size_t column = 0; column < 10; ++column) {
    CHECK(density.counts[column] == (column == 2 ? 3.0 : 2.0));
    CHECK(density.counts[10 + column] == (column == 2 ? 2.0 : 1.0));
    CHECK(density.counts[20 + column] == (column == 2 ? 1.0 : 0.0));
  }
}

TEST_CASE("what lies outside of the cells counts in none") {
  const Density density = density_of({{{{-5.0, -1.0}, {0.5, 0.5}}}}, {0.0, 1.0}, {0.0, 1.0}, 4, 4);
  CHECK(std::accumulate(density.counts.begin(), density.counts.end(), 0.0) == 0.0);
}

}  // namespace stepwire::geometry
