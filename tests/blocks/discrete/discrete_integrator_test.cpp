#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// The input is 4 t, the period 0.1 s.
std::vector<double> sums(const std::string& method) {
  return column(run_text(R"(
step: 100 ms
stop: 2 s
blocks:
  u: {block: Ramp, slope: 4}
  sum: {block: DiscreteIntegrator, u: u, gain: 0.5, initial: 3, method: )" +
                         method + "}\nrecord: [sum]\n"),
                "sum");
}

}  // namespace

TEST_CASE("The three sums of a ramp are those of their definitions") {
  const auto forward = sums("forward_euler"), backward = sums("backward_euler"),
             trapezoidal = sums("trapezoidal");
  for (std::size_t k = 0; k < forward.size(); ++k) {
    const double n = static_cast<double>(k);  // T = 0.1, gain u[k] = 0.2 k
    CHECK(forward[k] == Approx(3.0 + 0.02 * n * (n - 1.0) / 2.0).margin(1e-12));
    CHECK(backward[k] == Approx(3.0 + 0.02 * n * (n + 1.0) / 2.0).margin(1e-12));
    CHECK(trapezoidal[k] == Approx(3.0 + 0.01 * n * n).margin(1e-12));  // the parabola itself
  }
}

TEST_CASE("Only the forward sum cuts a loop") {
  const std::string loop =
      "step: 1 s\nstop: 5 s\nblocks:\n  x: {block: DiscreteIntegrator, u: x, initial: 1, method: ";
  CHECK(column(run_text(loop + "forward_euler}\nrecord: [x]\n"), "x") ==
        std::vector<double>{1, 2, 4, 8, 16, 32});
  CHECK_THAT(error_of(loop + "backward_euler}\n"), Catch::Contains("loop"));
  CHECK_THAT(error_of(loop + "trapezoidal}\n"), Catch::Contains("loop"));
}

TEST_CASE("Each sum stops at its limits and leaves them at once") {
  for (const std::string method : {"forward_euler", "backward_euler", "trapezoidal"}) {
    INFO(method);
    const table::Table table = run_text(R"(
step: 100 ms
stop: 3 s
blocks:
  u: {block: Step, time: 1.95, before: 1, after: -1}
  sum: {block: DiscreteIntegrator, u: u, lower: -0.2, upper: 1, method: )" +
                                        method + "}\nrecord: [sum]\n");
    const auto& sum = column(table, "sum");
    CHECK(sum[5] == Approx(0.5).margin(0.1));
    CHECK(sum[19] == 1.0);
    CHECK(sum[25] == Approx(1.0 - 0.5).margin(0.1 + 1e-12));
    for (double value : sum) CHECK((value <= 1.0 && value >= -0.2));
  }
}
