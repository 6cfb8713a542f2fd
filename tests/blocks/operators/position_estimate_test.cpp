#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

table::Table estimated(const std::string& keys, const std::string& stop = "1 s",
                       const std::string& more = "") {
  return run_text("step: 100 ms\nstop: " + stop + "\nblocks:\n" + more +
                  "  e: {block: PositionEstimate, every: 100 ms, " + keys + "}\nrecord: [e.y, e.variance]\n");
}

}  // namespace

TEST_CASE("Of a hand at rest precisions add up, and each channel counts by its own") {
  const table::Table run =
      estimated("model: [0 m, 0 m], measured: [[3 m, 1 m], [7 m, 2 m]], precision: [0.5, 2]");
  const auto &x = column(run, "e.y.1"), &y = column(run, "e.y.2"), &variance = column(run, "e.variance");
  for (std::size_t k = 0; k < x.size(); ++k) {
    REQUIRE(1.0 / variance[k] == Approx(2.5 * static_cast<double>(k + 1)).epsilon(1e-5));
    REQUIRE(x[k] == Approx((0.5 * 3.0 + 2.0 * 7.0) / 2.5).epsilon(1e-5));
    REQUIRE(y[k] == Approx((0.5 * 1.0 + 2.0 * 2.0) / 2.5).epsilon(1e-5));
  }
}

TEST_CASE("Without a measurement the estimate moves with the model") {
  const table::Table run = estimated("model: m, measured: [[3 m, 0 m]], precision: [p], doubt: 0.5", "1 s",
                                     "  r: {block: Ramp, slope: 2 m/s}\n  m: {block: Mux, u: [r, 0 m]}\n"
                                     "  p: {block: Step, time: 50 ms, before: 4, after: 0}\n");
  CHECK(column(run, "e.y.1").back() == Approx(5.0).epsilon(1e-5));
  CHECK(column(run, "e.variance").back() == Approx(0.25 + 10 * 0.25 * 0.04).epsilon(1e-5));
}

TEST_CASE("In motion its variance is the steady solution of the Riccati equation") {
  const table::Table run = estimated("model: m, measured: [m], precision: [3], doubt: 0.5", "20 s",
                                     "  r: {block: Ramp, slope: 2 m/s}\n  m: {block: Mux, u: [r, 0 m]}\n");
  const double q = 0.25 * 0.04, p = 3.0;  // P = (P + q)/(1 + p (P + q))
  CHECK(column(run, "e.variance").back() ==
        Approx(0.5 * (-q + std::sqrt(q * q + 4.0 * q / p))).epsilon(1e-9));
}

TEST_CASE("Each channel of a position has its own precision") {
  CHECK_THAT(
      error_of(
          "step: 1 s\nstop: 1 s\nrecord: [e.y]\nblocks:\n  e: {block: PositionEstimate, model: [0 m, 0 m], "
          "measured: [[3 m, 0 m], [4 m, 0 m]], precision: [1]}\n"),
      Catch::Contains("1 number for 2 channels"));
}
