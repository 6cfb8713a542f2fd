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
  for (const char* begins : {", settled: false", ", initial: 0", ", settled: true, initial: 0"})
    CHECK(column(run_text(diagram + begins + "}\nrecord: [v]\n"), "v")[0] == Approx(350.0));
  CHECK(column(run_text(diagram + ", initial: 6.5}\nrecord: [v]\n"), "v")[0] == Approx(25.0));
  const table::Table settled = run_text(diagram + "}\nrecord: [v]\n");
  const auto& time = column(settled, "time");
  for (std::size_t k = 0; k < time.size(); ++k)
    CHECK(column(settled, "v")[k] == Approx(2.0 * (1.0 - std::exp(-time[k] / 0.02))).margin(1e-5));
}

TEST_CASE("Of a constant a derivative is 0 from the first instant on, and of a later jump it is a pulse") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  u: {block: Step, time: 0.5 s, before: 5, after: 7}
  v: {block: Derivative, tau: 20 ms, u: u}
record: [v]
)");
  const auto &time = column(table, "time"), &v = column(table, "v");
  for (std::size_t k = 0; k < 500; ++k) CHECK(v[k] == 0.0);
  for (std::size_t k = 500; k < v.size(); ++k)
    CHECK(v[k] == Approx(100.0 * std::exp(-(time[k] - 0.5) / 0.02)).margin(1e-5));
}

TEST_CASE("A reset lets a derivative begin at 0, unless a value for its filter is given") {
  const auto run = [](const std::string& keys) {
    return column(run_text(R"(
step: 1 ms
stop: 400 ms
solver: rk4
blocks:
  ramp: {block: Ramp, slope: 2, initial: 7}
  on: {block: Step, time: 200 ms}
  v: {block: Derivative, tau: 20 ms, u: ramp, reset: on)" +
                           keys + "}\nrecord: [v]\n"),
                  "v");
  };
  const auto free = run(""), valued = run(", value: 7"), given = run(", initial: 7");
  for (std::size_t k = 200; k < free.size(); ++k) {
    const double since = 1e-3 * static_cast<double>(k - 200), fades = std::exp(-since / 0.02);
    CHECK(free[k] == Approx(2.0 * (1.0 - fades)).margin(1e-5));
    CHECK(valued[k] == Approx(2.0 + 18.0 * fades).margin(1e-4));  // from (7.4 - 7) / 20 ms on
    CHECK(given[k] == Approx(valued[k]));
  }
}

TEST_CASE("A condition that puts states back lets a derivative begin at 0 again") {
  const auto v = column(run_text(R"(
step: 1 ms
stop: 400 ms
solver: rk4
blocks:
  ramp: {block: Ramp, slope: 2, initial: 7}
  v: {block: Derivative, tau: 20 ms, u: ramp, enable: {when: time > 0.2 s, states: reset}}
record: [v]
)"),
                        "v");
  for (std::size_t k = 201; k < v.size(); ++k)
    CHECK(v[k] == Approx(2.0 * (1.0 - std::exp(-1e-3 * static_cast<double>(k - 201) / 0.02))).margin(1e-5));
}
