#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A sensor that shows a ramp until 200 ms and then the same for ever.
std::vector<double> stuck(const std::string& moving, const std::string& keys = "") {
  return column(
      run_text(
          "step: 1 ms\nstop: 1 s\nblocks:\n  way: {block: Ramp, slope: 10 mm/s}\n  read: {block: Saturation, "
          "u: way, upper: 2 mm}\n" +
          moving + "  stuck: {block: StuckDetector, u: read, moving: moving, time: 100 ms" + keys +
          "}\nrecord: [stuck]\n"),
      "stuck");
}

std::size_t first(const std::vector<double>& truth) {
  std::size_t k = 0;
  while (k < truth.size() && truth[k] == 0.0) ++k;
  return k;
}

const std::string always = "  moving: {block: Constant, value: 1}\n";

}  // namespace

TEST_CASE("A sensor that no longer changes while it should is stuck once the time is over, not before") {
  const std::vector<double> truth = stuck(always);
  CHECK(first(truth) == 301);
  CHECK(truth.back() == 1.0);
}

TEST_CASE("A sensor that rests with what it measures is not stuck") {
  CHECK(first(stuck("  moving: {block: Constant, value: 0}\n")) == 1001);
  // moved for 80 ms of every 100 ms: never for the whole time
  CHECK(first(stuck("  moving: {block: Pulse, amplitude: 1, period: 100 ms, width: 0.8}\n")) == 1001);
  // it should move from 500 ms on
  CHECK(first(stuck("  moving: {block: Step, time: 500 ms, after: 1}\n")) == 601);
}

TEST_CASE("A change within the tolerance is none") {
  // 10 mm/s need 150 ms for 1.5 mm
  CHECK(first(stuck(always, ", tolerance: 1.5 mm")) == 101);
  CHECK(first(stuck(always, ", tolerance: 0.5 mm")) > 200);
}

TEST_CASE("A sensor of several numbers is stuck only when none of them changes") {
  const auto of = [](const std::string& second) {
    return first(column(
        run_text("step: 1 ms\nstop: 1 s\nblocks:\n  way: {block: Ramp, slope: [10 mm/s, " + second +
                 "]}\n  stuck: {block: StuckDetector, u: way, moving: 1, time: 100 ms}\nrecord: [stuck]\n"),
        "stuck"));
  };
  CHECK(of("0 mm/s") == 1001);
}
