#include "engine/analyse/statistics/assumptions.hpp"

#include <catch2/catch.hpp>

#include "engine/analyse/statistics/distributions.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"

// Numbers of R 4.2.2.

namespace stepwire::statistics {

namespace {

std::vector<std::vector<double>> groups() {
  std::vector<std::vector<double>> result;
  for (const Cell& cell : cells(textbook::warps(), {"wool", "tension"})) result.push_back(cell.values);
  return result;
}

}  // namespace

TEST_CASE("the variances of warpbreaks are compared as R does") {
  // g <- with(warpbreaks, interaction(wool, tension))
  // z <- abs(warpbreaks$breaks - ave(warpbreaks$breaks, g, FUN=median)); anova(lm(z~g)); then with FUN=mean
  const VarianceTest by_median = *variance_test(groups());
  CHECK(by_median.f == Approx(2.89098).margin(5.1e-6));
  CHECK(by_median.p == Approx(0.023218).margin(5.1e-7));
  CHECK(by_median.above == 5.0);
  CHECK(by_median.below == 48.0);
  const VarianceTest by_mean = *variance_test(groups(), Middle::mean);
  CHECK(by_mean.f == Approx(5.14829).margin(5.1e-6));
  CHECK(by_mean.p == Approx(0.00073513).margin(5.1e-9));
}

TEST_CASE("groups too small for a variance are left out") {
  CHECK_FALSE(variance_test({{1.0}, {2.0}, {3.0, 4.0}}).has_value());
  CHECK_FALSE(variance_test({{1.0, 1.0}, {2.0, 2.0}}).has_value());
  auto with_one_more = groups();
  with_one_more.push_back({5.0});
  CHECK(variance_test(with_one_more)->f == variance_test(groups())->f);
}

TEST_CASE("tails of F and chi-squared agree with R") {
  // pf(c(3.5,0.2,60), c(2,3.7,1), c(9,20.5,8), lower.tail=FALSE); pchisq(c(3,30), c(2,5.5), lower.tail=FALSE)
  CHECK(fisher_tail(3.5, 2, 9) == Approx(7.50846862792969e-02).epsilon(1e-12));
  CHECK(fisher_tail(0.2, 3.7, 20.5) == Approx(9.25682583495046e-01).epsilon(1e-12));
  CHECK(fisher_tail(60, 1, 8) == Approx(5.50450716471096e-05).epsilon(1e-12));
  CHECK(chi_squared_tail(3, 2) == Approx(2.23130160148430e-01).epsilon(1e-12));
  CHECK(chi_squared_tail(30, 5.5) == Approx(2.44068001451617e-05).epsilon(1e-12));
}

}  // namespace stepwire::statistics
