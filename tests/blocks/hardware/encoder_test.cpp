#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

const double of_a_count = 2.0 * M_PI / 4000.0;

/// Returns the counts of an encoder and the angle read from them, for a shaft that turns at a constant speed.
table::Table turning(const std::string& speed, const std::string& from, const std::string& encoder,
                     const std::string& reading = "") {
  return run_text("step: 1 ms\nstop: 2 s\nblocks:\n  shaft: {block: Ramp, slope: " + speed +
                  ", initial: " + from + "}\n  encoder: {block: QuadratureEncoder, angle: shaft" + encoder +
                  "}\n  angle: {block: EncoderToAngle, counts: encoder" +
                  (reading.empty() ? encoder : reading) +
                  "}\nrecord: [shaft, encoder, angle.angle, angle.fault]\n");
}

/// A counter that shows 0 and 5 in turns, then these counts.
table::Table counted(const std::string& counts, const std::string& keys) {
  return run_text(
      "step: 1 ms\nstop: 30 ms\nblocks:\n  start: {block: Pulse, amplitude: 5, period: 4 ms, width: 0.5}\n"
      "  jump: {block: Pulse, amplitude: 1, delay: 10 ms, period: 1 s, width: 0.01}\n"
      "  counts: {block: Switch, control: jump, then: " +
      counts + ", else: start}\n  angle: {block: EncoderToAngle, counts: counts" + keys +
      "}\nrecord: [counts, angle.angle, angle.fault]\n");
}

}  // namespace

TEST_CASE("An encoder shows whole counts, 4000 for a revolution") {
  const table::Table table = turning("3.14159265358979 rad/s", "0 rad", ", preset: thesis-3.2");
  CHECK(column(table, "encoder").back() == 4000.0);
  CHECK(column(table, "encoder")[1000] == 2000.0);
  for (double counts : column(table, "encoder")) REQUIRE(counts == std::floor(counts));
}

TEST_CASE("An encoder turned below 0 goes on from the other end of its counter") {
  const table::Table table = turning("-1 rad/s", "0 rad", "");
  CHECK(column(table, "encoder").back() == std::exp2(24) - std::floor(2.0 / of_a_count + 0.5));
}

TEST_CASE("The angle of an encoder is within half a count, also over the wraps of a counter of 8 bits") {
  for (const std::string speed : {"40 rad/s", "-40 rad/s"}) {
    const table::Table table = turning(speed, "0.1 rad", ", bits: 8");
    double worst = 0.0, highest = 0.0;
    for (std::size_t k = 0; k < column(table, "time").size(); ++k) {
      worst = std::max(worst, std::abs(column(table, "angle.angle")[k] - column(table, "shaft")[k]));
      highest = std::max(highest, column(table, "encoder")[k]);
      REQUIRE(column(table, "angle.fault")[k] == 0.0);
    }
    CHECK(highest == 255.0);
    CHECK(worst <= 0.5 * of_a_count * (1.0 + 1e-9));
    CHECK(worst > 0.45 * of_a_count);
  }
}

TEST_CASE("A jump of the counts above what a tick may bring is a fault, and the angle stays where it was") {
  // 9 counts a tick are allowed; the counter jumps by 40 for 10 ms and comes back
  const table::Table table = counted("40", ", largest_step: 9");
  for (std::size_t k = 0; k < 31; ++k) {
    const bool jumps = column(table, "counts")[k] == 40.0;
    CHECK(column(table, "angle.fault")[k] == (jumps ? 1.0 : 0.0));
    CHECK(column(table, "angle.angle")[k] <= 5.0 * of_a_count * (1.0 + 1e-12));
  }
  CHECK(column(table, "angle.fault")[15] == 1.0);
  CHECK(column(table, "angle.angle").back() ==
        Approx(column(table, "counts").back() * of_a_count).margin(1e-15));
}

TEST_CASE(
    "Half a turn of the counter may be gone either way: it is a fault; what the counter lacks is one, too") {
  CHECK(column(counted("132", ", bits: 8"), "angle.fault")[15] == 0.0);  // 127 above 5
  CHECK(column(counted("133", ", bits: 8"), "angle.fault")[15] == 1.0);  // 128 above 5
  CHECK(column(counted("256", ", bits: 8"), "angle.fault")[15] == 1.0);
  CHECK(column(counted("-1", ", bits: 8"), "angle.fault")[15] == 1.0);
}
