#include "blocks/records/band_limited.hpp"

#include <catch2/catch.hpp>

using namespace stepwire;

TEST_CASE("a band-limited periodic signal is met between its samples") {
  for (int samples : {1, 2, 7, 8, 750, 1021}) {
    const int lines = (samples - 1) / 2;
    const auto signal = [&](double turns) {
      double sum = 0.3 + (samples % 2 == 0 ? 0.5 * std::cos(M_PI * samples * turns) : 0.0);
      for (int line = 1; line <= lines; line += lines > 40 ? 37 : 1)
        sum += std::cos(2.0 * M_PI * std::fmod(line * turns, 1.0) + line);
      return sum;
    };
    std::vector<double> values;
    for (int n = 0; n < samples; ++n) values.push_back(signal(static_cast<double>(n) / samples));
    const BandLimited limited = BandLimited::through({1, samples, Numbers(values)});
    for (double turns = 0.0; turns < 1.0; turns += 0.00618)
      REQUIRE(limited(0, turns) == Approx(signal(turns)).margin(1e-11));
  }
}

TEST_CASE("a band-limited signal repeats in both directions and runs through its samples") {
  std::vector<double> values;
  for (int n = 0; n < 50; ++n) values.push_back(std::fmod(n * n * 0.37, 2.0) - 1.0);
  const BandLimited limited = BandLimited::through({1, 50, Numbers(values)});
  for (int n = 0; n < 50; ++n)
    REQUIRE(limited(0, n / 50.0) == Approx(values[static_cast<std::size_t>(n)]).margin(1e-13));
  REQUIRE(limited(0, -0.3) == Approx(limited(0, 0.7)).margin(1e-13));
  REQUIRE(limited(0, 12.7) == Approx(limited(0, 0.7)).margin(1e-12));
  REQUIRE(limited(0, -1e-20) == Approx(values[0]).margin(1e-13));
}
