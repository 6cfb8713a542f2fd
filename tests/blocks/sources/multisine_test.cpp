#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Amplitude of a line of whole periods in a record of one second at 1 kHz (its last row is the next period's
/// first).
double line(const std::vector<double>& y, int hertz) {
  std::complex<double> sum;
  for (std::size_t i = 0; i < 1000; ++i)
    sum += y[i] * std::polar(1.0, -2.0 * M_PI * hertz * static_cast<double>(i) / 1000.0);
  return 2.0 * std::abs(sum) / 1000.0;
}

std::vector<double> multisine(const std::string& keys) {
  const table::Table run =
      run_text("step: 1 ms\nstop: 1 s\nblocks:\n  y: {block: Multisine, " + keys + "}\nrecord: [y]\n");
  return column(run, "y");
}

double peak(const std::vector<double>& y) {
  double most = 0.0;
  for (double v : y) most = std::max(most, std::abs(v));
  return most;
}

}  // namespace

TEST_CASE("a multisine has the lines that are asked for and no other") {
  const auto y = multisine("period: 1 s, lowest: 3 Hz, highest: 9 Hz, lines: odd, amplitude: [1, 2, 3, 4]");
  for (int hertz = 1; hertz < 50; ++hertz) {
    const double expected = hertz == 3 ? 1 : hertz == 5 ? 2 : hertz == 7 ? 3 : hertz == 9 ? 4 : 0;
    REQUIRE(line(y, hertz) == Approx(expected).margin(1e-12));
  }
  REQUIRE(y.front() == Approx(y.back()).margin(1e-12));
}

TEST_CASE("a multisine has the rms that is asked for") {
  const auto y = multisine("lowest: 1 Hz, highest: 100 Hz, rms: 0.5, phase: random, seed: 3");
  double squares = 0.0;
  for (std::size_t i = 0; i < 1000; ++i) squares += y[i] * y[i] / 1000.0;
  REQUIRE(std::sqrt(squares) == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("Schroeder's phases keep the crest factor below 2 where equal phases reach sqrt(2 K)") {
  // A flat spectrum of 100 lines; Schroeder reports crest factors near 1.7 for such phases.
  const std::string lines = "lowest: 1 Hz, highest: 100 Hz, rms: 1";
  REQUIRE(peak(multisine(lines)) < 2.0);
  REQUIRE(peak(multisine(lines + ", phase: zero")) == Approx(std::sqrt(200.0)));
}

TEST_CASE("a multisine of given lines is their sum") {
  const auto y = multisine("frequencies: [1.5 Hz, 40 Hz], amplitude: [2, 0.5], phases: [0, 90 deg]");
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double t = static_cast<double>(i) * 1e-3;
    REQUIRE(y[i] == Approx(2.0 * std::cos(3.0 * M_PI * t) - 0.5 * std::sin(80.0 * M_PI * t)).margin(1e-12));
  }
}

TEST_CASE("a multisine without a line is refused with what would help") {
  const std::string frame = "step: 1 ms\nstop: 1 s\nrecord: [y]\nblocks:\n  y: ";
  REQUIRE_THAT(error_of(frame + "{block: Multisine, period: 0.1 s, lowest: 11 Hz, highest: 19 Hz}\n"),
               Catch::Contains("y.period") && Catch::Contains("lengthen"));
  REQUIRE_THAT(error_of(frame + "{block: Multisine, period: 1e300 s, lowest: 1e299 Hz, highest: 1e300 Hz}\n"),
               Catch::Contains("y.period") && Catch::Contains("shorten"));
  REQUIRE_THAT(error_of(frame + "{block: Multisine, amplitude: [1, 2]}\n"),
               Catch::Contains("2 values for 10 lines"));
}
