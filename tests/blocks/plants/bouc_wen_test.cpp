#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A Bouc-Wen element with n = 1 loads along its exponential") {
  const Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  element: {block: BoucWen, velocity: 0.5, A: 4, beta: 1.5, gamma: 0.5}
record: [element]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 50)
    CHECK(column(table, "element")[k] == Approx(2.0 * (1.0 - std::exp(-2.0 * 0.5 * time[k]))).margin(1e-10));
}

TEST_CASE("A Bouc-Wen element with n = 2 loads along a hyperbolic tangent") {
  const Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  element: {block: BoucWen, velocity: -2, A: 1, beta: 3, gamma: 1, n: 2}
record: [element]
)");
  const auto& time = column(table, "time");  // dz/dx = 1 - 4 z^2
  for (std::size_t k = 0; k < time.size(); k += 50)
    CHECK(column(table, "element")[k] == Approx(-0.5 * std::tanh(2.0 * 2.0 * time[k])).margin(1e-10));
}

TEST_CASE("A Bouc-Wen element takes parameters that make no passive element") {
  CHECK(error_of("step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  e: {block: BoucWen, velocity: 1, A: -1, "
                 "beta: 0.1, gamma: -3}\n")
            .empty());
}
