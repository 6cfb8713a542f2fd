#include "engine/statistics/quartiles.hpp"

#include <catch2/catch.hpp>

using namespace stepwire;

TEST_CASE("the quartiles of 1 to 10 after Hazen are 3, 5.5 and 8") {
  const BoxSummary box = box_summary({10, 9, 8, 7, 6, 5, 4, 3, 2, 1});
  CHECK(box.min == 1.0);
  CHECK(box.lower == 3.0);
  CHECK(box.median == 5.5);
  CHECK(box.upper == 8.0);
  CHECK(box.max == 10.0);
  CHECK(box.mean == 5.5);
}

TEST_CASE("quantiles beyond the first and last half step are the ends") {
  const std::vector<double> sorted{2.0, 4.0, 6.0};
  CHECK(hazen_quantile(sorted, 0.0) == 2.0);
  CHECK(hazen_quantile(sorted, 0.1) == 2.0);
  CHECK(hazen_quantile(sorted, 1.0) == 6.0);
}

TEST_CASE("one value is its own box") {
  const BoxSummary box = box_summary({3.5});
  CHECK(box.lower == 3.5);
  CHECK(box.median == 3.5);
  CHECK(box.upper == 3.5);
}
