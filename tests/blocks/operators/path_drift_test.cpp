#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

double after(const std::string& speed, const std::string& stop) {
  const table::Table run =
      run_text("step: 10 ms\nstop: " + stop + "\nblocks:\n  x: {block: Ramp, slope: " + speed +
               "}\n  p: {block: Mux, u: [x, 0 m]}\n  d: {block: PathDrift, position: p, "
               "place: [30 mm, -40 mm], path: 2 m, every: 10 ms}\nrecord: [d]\n");
  CHECK(column(run, "d.2").back() == Approx(-4.0 / 3.0 * column(run, "d.1").back()));
  return column(run, "d.1").back();
}

}  // namespace

TEST_CASE("The drift goes toward its place by the way that was gone") {
  CHECK(after("0.1 m/s", "10 s") == Approx(30e-3 * (1.0 - std::exp(-0.5))).epsilon(2e-3));
}

TEST_CASE("Twice the speed drifts as far on the same way") {
  CHECK(after("0.2 m/s", "5 s") == Approx(after("0.1 m/s", "10 s")).epsilon(2e-3));
}

TEST_CASE("At rest nothing drifts") {
  CHECK(after("0 m/s", "100 s") == 0.0);
}
