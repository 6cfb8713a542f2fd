#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A Bouc-Wen element with n = 1 loads along its exponential") {
  const table::Table table = run_text(R"(
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
  const table::Table table = run_text(R"(
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

TEST_CASE("A Bouc-Wen element given by its limit loads to that, whatever n is") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  exponential: {block: BoucWen, velocity: 0.5, A: 4, z_max: 2, ratio: 0.3}
  tangent:     {block: BoucWen, velocity: -2, A: 1, z_max: 0.5, ratio: -0.9, n: 2}
  settled:     {block: BoucWen, velocity: 50 mm/s, A: 30, z_max: 4 mm, n: 3.7}
record: [exponential, tangent, settled]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 50) {
    CHECK(column(table, "exponential")[k] == Approx(2.0 * (1.0 - std::exp(-time[k]))).margin(1e-10));
    CHECK(column(table, "tangent")[k] == Approx(-0.5 * std::tanh(4.0 * time[k])).margin(1e-10));
  }
  CHECK(column(table, "settled").back() == Approx(4e-3));
}

TEST_CASE("Limit and ratio of a Bouc-Wen element are another way to say beta and gamma") {
  // beta + gamma = A / z_max^n: 4/2 and 1/0.25
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  back_and_forth: {block: Sine, amplitude: 20, frequency: 2 Hz}
  one:  {block: BoucWen, velocity: back_and_forth, A: 4, beta: 3, gamma: -1}
  same: {block: BoucWen, velocity: back_and_forth, A: 4, z_max: 2, ratio: = -1/3}
  two:  {block: BoucWen, velocity: back_and_forth, A: 1, beta: 2.5, gamma: 1.5, n: 2}
  too:  {block: BoucWen, velocity: back_and_forth, A: 1, z_max: 0.5, ratio: 0.6, n: 2}
record: [one, same, two, too]
)");
  for (std::size_t k = 0; k < table.rows(); ++k) {
    CHECK(column(table, "same")[k] == Approx(column(table, "one")[k]).margin(1e-12));
    CHECK(column(table, "too")[k] == Approx(column(table, "two")[k]).margin(1e-12));
  }
}

TEST_CASE("A Bouc-Wen element takes parameters that make no passive element") {
  CHECK(error_of("step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  e: {block: BoucWen, velocity: 1, A: -1, "
                 "beta: 0.1, gamma: -3}\n")
            .empty());
}
