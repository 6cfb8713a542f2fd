#include "engine/analyse/statistics/assumptions.hpp"

#include <catch2/catch.hpp>

#include "tests/engine/analyse/statistics/textbook.hpp"

// Numbers of shapiro.test of R 4.2.2.

namespace stepwire::statistics {

namespace {

void check(const std::vector<double>& values, double w, double p) {
  const auto found = shapiro_wilk(values);
  REQUIRE(found.has_value());
  INFO(values.size() << " values");
  CHECK(found->w == Approx(w).epsilon(1e-9));
  CHECK(found->p == Approx(p).epsilon(1e-8));
}

}  // namespace

TEST_CASE("normality is judged as R does, from three values on") {
  check({1, 2, 4}, 0.964285714285714, 0.636886845028963);
  check({1, 2, 4, 8}, 0.92020267879194, 0.53808377727497);
  check({2, 1, 4, 8, 3}, 0.903089932726152, 0.427198627769662);
  check({1, 1, 1, 1, 9}, 0.552181683086904, 0.000130978175851881);
  check({148, 154, 158, 160, 161, 162, 166, 170, 182, 195, 236}, 0.788814694835387, 0.00670381405650293);
  check(textbook::sleep().values, 0.946072762509969, 0.311375416723224);
  check(textbook::warps().values, 0.892510841036469, 0.000158076538298096);
}

TEST_CASE("normality does not depend on unit and origin") {
  const std::vector<double> values{2, 1, 4, 8, 3};
  std::vector<double> others;
  for (const double value : values) others.push_back(-3e-200 * value);
  CHECK(shapiro_wilk(others)->w == Approx(shapiro_wilk(values)->w).epsilon(1e-12));
}

TEST_CASE("normality of too few, too many or equal values is not judged") {
  CHECK_FALSE(shapiro_wilk({1, 2}).has_value());
  CHECK_FALSE(shapiro_wilk({0.1 + 0.2, 0.3, 0.3}).has_value());
  CHECK_FALSE(shapiro_wilk(std::vector<double>(5001, 1.0)).has_value());
}

}  // namespace stepwire::statistics
