#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "tests/support/run_text.hpp"

using namespace stepwire;

/// Noel and Schoukens, "Hysteretic benchmark with a dynamic nonlinearity" (data 10.4121/12967592): its
/// parameters and its test multisine, noiseless, compared in the second period.
TEST_CASE("A Bouc-Wen element in an oscillator gives the response of the hysteretic benchmark") {
  if (!std::getenv("STEPWIRE_DATA")) {
    WARN("skipped: STEPWIRE_DATA names no data folder");
    return;
  }
  const table::Table table = run_text(R"(
step: = 1/15000
stop: = 16383/750
solver: rk4
blocks:
  u:     {block: FromFile, file: data/bouc_wen_benchmark/uval_multisine.mat, column: uval_multisine, unit: N,
          sample_time: = 1/750, interpolation: band_limited}
  y:     {block: FromFile, file: data/bouc_wen_benchmark/yval_multisine.mat, column: yval_multisine, unit: m,
          sample_time: = 1/750, after_end: repeat, interpolation: hold, every: = 1/750}
  body:  {block: Mass, mass: 2 kg, force: net}
  net:   {block: Sum, signs: "+---", u: [u, damping, spring, hysteresis]}
  damping:    {block: Gain, gain: 10 N s/m, u: body.velocity}
  spring:     {block: Gain, gain: 5e4 N/m, u: body.position}
  hysteresis: {block: BoucWen, A: 5e4 N/m, beta: 800 1/m, gamma: -1100 1/m, n: 1, velocity: body.velocity}
record: {every: = 1/750, signals: [body.position, y]}
)");
  const auto &model = column(table, "body.position"), &published = column(table, "y");
  double square = 0.0;
  for (std::size_t k = 8192; k < 16384; ++k) square += std::pow(model.at(k) - published.at(k), 2);
  CHECK(std::sqrt(square / 8192) < 1e-6);  // the response itself has 6.6e-4 m rms
}
