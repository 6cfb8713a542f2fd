#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A state space without damping swings as a cosine") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 2 s
solver: rk4
blocks:
  swing: {block: StateSpace, A: [[0, 1], [-9, 0]], B: [[0], [1]], C: [[1, 0]], u: 0, initial: [1, 0]}
record: [swing]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 50)
    CHECK(column(table, "swing")[k] == Approx(std::cos(3.0 * time[k])).margin(1e-10));
}

// Exact solution by the matrix exponential of the system joined with the generator of its inputs
// u = [1, sin t].
//   SciPy 1.10.1: Z = [[A, B, 0], [0 0 0 0 0], [0 0 0 0 1], [0 0 0 -1 0]]
//   z = expm(Z t) [0.2, -0.1, 1, 0, 1]. Outputs: y = C z[:2] + D z[2:4]
TEST_CASE("A state space with two inputs and three outputs agrees with its matrix exponential") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 3 s
solver: rk4
blocks:
  sine: {block: Sine, frequency: 0.15915494309189535}
  u: {block: Mux, u: [1, sine]}
  system:
    block: StateSpace
    A: [[0, 1], [-4, -0.5]]
    B: [[0, 1], [1, 0.5]]
    C: [[1, 0], [0, 1], [1, 1]]
    D: [[0, 0], [0.1, 0], [0, 2]]
    u: u
    initial: [0.2, -0.1]
record: [system]
)");
  const double at_1[] = {0.6139455369817242, -0.11134963125841119, 2.085537875339106};
  const double at_3[] = {-0.06417024299518564, -0.7757348489801887, -0.6576650758556399};
  for (int i = 0; i < 3; ++i) {
    const auto& y = column(table, "system." + std::to_string(i + 1));
    CHECK(y[1000] == Approx(at_1[i]).margin(1e-11));
    CHECK(y[3000] == Approx(at_3[i]).margin(1e-11));
  }
}

TEST_CASE("A state space passes a loop only without D") {
  const std::string head = "step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n";
  const std::string system = "  s: {block: StateSpace, A: [[-1]], B: [[1]], C: [[1]], u: s";
  CHECK(error_of(head + system + "}\nrecord: [s]\n").empty());
  CHECK(error_of(head + system + ", D: [[0]]}\nrecord: [s]\n").empty());
  CHECK_THAT(error_of(head + system + ", D: [[2]]}\n"), Catch::Contains("loop"));
}

TEST_CASE("A state space refuses matrices that do not fit each other") {
  const std::string head = "step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n";
  CHECK_THAT(error_of(head + "  s: {block: StateSpace, A: [[-1, 0], [0, 1]], B: [[1]], C: [[1, 0]], u: 1}\n"),
             Catch::Contains("'B'"));
  CHECK_THAT(error_of(head + "  s: {block: StateSpace, A: [[-1]], B: [[1]], C: [[1]], D: [[1, 2]], u: 1}\n"),
             Catch::Contains("'D'"));
}
