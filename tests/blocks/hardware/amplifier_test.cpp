#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("The current of an amplifier follows its command with a first-order lag") {
  const table::Table table = run_text(R"(
step: 0.001 ms
stop: 0.3 ms
solver: rk4
blocks:
  amplifier: {block: Amplifier, preset: amc-16a20ac, u: 0.3 A}
record: [amplifier]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); ++k)
    CHECK(column(table, "amplifier")[k] ==
          Approx(0.3 * (1.0 - std::exp(-2.0 * M_PI * 2500.0 * time[k]))).epsilon(1e-6));
}

TEST_CASE("An amplifier gives no more than its limit, and scales its command") {
  const auto last = [](const std::string& keys) {
    return column(run_text("step: 0.1 ms\nstop: 50 ms\nsolver: rk4\nblocks:\n  a: {block: Amplifier, " +
                           keys + "}\nrecord: [a]\n"),
                  "a")
        .back();
  };
  CHECK(last("u: 2 A, lower: 0 A, upper: 0.35 A") == Approx(0.35).epsilon(1e-12));
  CHECK(last("u: -2 A, lower: 0 A, upper: 0.35 A") == Approx(0.0).margin(1e-12));
  CHECK(last("u: 2 V, gain: 0.1 A/V") == Approx(0.2).epsilon(1e-12));
}

TEST_CASE("An amplifier with crossed limits is refused") {
  CHECK_THAT(
      error_of("step: 0.1 ms\nstop: 1 ms\nsolver: rk4\nblocks:\n  a: {block: Amplifier, u: 1 A, lower: 1 "
               "A, upper: 0 A}\n"),
      Catch::Contains("a.lower"));
}

TEST_CASE(
    "An inhibited amplifier lets its current decay by its lag, whatever is asked, and takes it up again") {
  const table::Table table = run_text(R"(
step: 0.01 ms
stop: 30 ms
solver: rk4
blocks:
  off:       {block: Pulse, amplitude: 1, delay: 10 ms, period: 1 s, width: 0.01, every: 0.01 ms}
  amplifier: {block: Amplifier, u: 5 V, gain: 0.1 A/V, inhibit: off, tau: 1 ms}
record: [amplifier]
)");
  const auto& current = column(table, "amplifier");
  CHECK(current[1000] == Approx(0.5).epsilon(1e-4));
  CHECK(current[1300] == Approx(0.5 * std::exp(-3.0)).epsilon(1e-3));
  CHECK(current[2000] < 1e-4);
  CHECK(current.back() == Approx(0.5).epsilon(1e-4));
}
