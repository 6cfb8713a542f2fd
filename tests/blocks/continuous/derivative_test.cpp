#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("The derivative of a ramp comes in with the filter's time constant") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  ramp: {block: Ramp, slope: 5 mm/s}
  v: {block: Derivative, tau: 50 ms, u: ramp}
record: [v]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 10)
    CHECK(column(table, "v")[k] == Approx(5e-3 * (1.0 - std::exp(-time[k] / 0.05))).margin(1e-10));
  CHECK(table.find("v")->unit == "m/s");
}

TEST_CASE("The derivative of a sine has the gain and phase of s / (tau s + 1)") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  u: {block: Sine, frequency: 5}
  v: {block: Derivative, tau: 10 ms, u: u}
record: [v]
)");
  const std::complex<double> s(0.0, 10.0 * std::acos(-1.0));
  const std::complex<double> h = s / (0.01 * s + 1.0);
  for (std::size_t k = 500; k <= 1000; k += 10)
    CHECK(column(table, "v")[k] ==
          Approx(std::imag(h * std::exp(s * (1e-3 * static_cast<double>(k))))).margin(1e-4));
}

TEST_CASE("A settled derivative starts without a peak, wherever the input starts") {
  const std::string diagram = R"(
step: 1 ms
stop: 500 ms
solver: rk4
blocks:
  ramp: {block: Ramp, slope: 2, initial: 7}
  v: {block: Derivative, tau: 20 ms, u: ramp)";
  const table::Table peak = run_text(diagram + "}\nrecord: [v]\n");
  CHECK(column(peak, "v")[0] == Approx(350.0));
  const table::Table settled = run_text(diagram + ", settled: true}\nrecord: [v]\n");
  const auto& time = column(settled, "time");
  for (std::size_t k = 0; k < time.size(); ++k)
    CHECK(column(settled, "v")[k] == Approx(2.0 * (1.0 - std::exp(-time[k] / 0.02))).margin(1e-5));
}
