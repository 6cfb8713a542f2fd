#include "engine/analyse/statistics/descriptive.hpp"

#include <catch2/catch.hpp>

namespace stepwire::statistics {

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

TEST_CASE("whiskers reach over all values, or to the last within one and a half boxes") {
  // The quartiles are 3 and 8, so that Tukey's whiskers end within -4.5 and 15.5.
  const std::vector<double> values{-6, 2, 3, 4, 5, 6, 7, 8, 15, 40};
  const BoxSummary range = box_summary(values), tukey = box_summary(values, Whiskers::tukey);
  CHECK(range.low_whisker == -6.0);
  CHECK(range.high_whisker == 40.0);
  CHECK(range.beyond.empty());
  CHECK(tukey.lower == 3.0);
  CHECK(tukey.upper == 8.0);
  CHECK(tukey.low_whisker == 2.0);
  CHECK(tukey.high_whisker == 15.0);
  CHECK(tukey.beyond == std::vector<double>{-6.0, 40.0});
}

TEST_CASE("a whisker without a value in reach ends at its box") {
  // Hazen's quartiles of 0, 0, 0, 10 are 0 and 5: all values within -7.5 and 12.5.
  CHECK(box_summary({0, 0, 0, 10}, Whiskers::tukey).high_whisker == 10.0);
  // Hazen's upper quartile of these eight values is between the sixth and the seventh, which are both 1.
  const BoxSummary box = box_summary({0, 0, 1, 1, 1, 1, 1, 100}, Whiskers::tukey);
  CHECK(box.upper == 1.0);
  CHECK(box.high_whisker == 1.0);
  CHECK(box.beyond == std::vector<double>{100.0});
}

}  // namespace stepwire::statistics
