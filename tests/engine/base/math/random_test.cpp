#include "engine/base/math/normal_quantile.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace stepwire {

TEST_CASE("random bits are those of SplitMix64") {
  // The published sequence for seed 1234567.
  REQUIRE(random_bits(1234567, 0) == 6457827717110365317u);
  REQUIRE(random_bits(1234567, 1) == 3203168211198807973u);
  REQUIRE(random_bits(1234567, 4) == 16408922859458223821u);
}

TEST_CASE("the unit interval has no ends") {
  REQUIRE(to_unit_interval(0) > 0.0);
  REQUIRE(to_unit_interval(~std::uint64_t{0}) < 1.0);
}

TEST_CASE("the portable logarithm is the logarithm") {
  for (double x : {1e-300, 1e-15, 0.3, 0.7, 0.9999999, 1.0, 2.0, 1e10})
    REQUIRE(portable_log(x) == Approx(std::log(x)).epsilon(1e-15).margin(1e-16));
}

TEST_CASE("the normal quantile undoes the normal distribution") {
  for (double p : {1e-15, 1e-10, 1e-5, 0.01, 0.07, 0.08, 0.3, 0.5, 0.6, 0.93, 0.999}) {
    const double z = normal_quantile(p);
    REQUIRE(0.5 * std::erfc(-z / std::sqrt(2.0)) == Approx(p).epsilon(1e-13));
  }
}

}  // namespace stepwire
