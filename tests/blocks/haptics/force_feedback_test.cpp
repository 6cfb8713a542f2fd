#include "blocks/haptics/force_feedback.hpp"

#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Runs a ForceFeedback joint with a target force of -5 N; `hand` is the block of the measured force.
table::Table run_against(const std::string& hand, const std::string& parameters) {
  return run_text("step: 1 ms\nstop: 1 s\nblocks:\n  hand: {block: " + hand +
                  "}\n  joint: {block: ForceFeedback, wanted: -5 N, measured: hand, " + parameters +
                  "}\nrecord: [joint.y, joint.realisable, joint.integral]\n");
}

}  // namespace

TEST_CASE("A joint is asked for what is wanted, for kp times what the hand lacks, and for its integral") {
  const table::Table table = run_against("Constant, value: 4 N", "kp: 2, ki: 3 Hz");
  for (std::size_t k = 0; k < 1000; k += 100)
    CHECK(column(table, "joint.y")[k] == Approx(5.0 + 2.0 * 1.0 + 3.0 * 1.0 * static_cast<double>(k) * 1e-3));
  CHECK(column(table, "joint.realisable").back() == -5.0);
}

TEST_CASE("The integral keeps to its limit, and waits while more is asked for than the damper can give") {
  const table::Table held = run_against("Constant, value: 4 N", "kp: 0, ki: 30 Hz, integral_limit: 1.5 N");
  CHECK(column(held, "joint.y").back() == Approx(6.5));
  const table::Table stuck = run_against("Constant, value: 1 N", "kp: 0, ki: 30 Hz, limit: 6 N");
  CHECK(column(stuck, "joint.y").back() == 6.0);
  CHECK(column(stuck, "joint.integral").back() ==
        Approx(1.0).margin(30.0 * 4.0 * 1e-3));  // one sample beyond
  CHECK(column(stuck, "joint.realisable").back() == -5.0);
  const table::Table weak = run_against("Constant, value: 1 N", "limit: 3 N");
  CHECK(column(weak, "joint.realisable").back() == -3.0);
}

TEST_CASE("A hand that pushes where it is to be pushed is not resisted, and the integral starts anew") {
  const table::Table table = run_against("Step, time: 0.5 s, before: 4 N, after: -4 N", "kp: 1, ki: 30 Hz");
  CHECK(column(table, "joint.y")[499] > 6.0);
  CHECK(column(table, "joint.integral")[499] > 1.0);
  CHECK(column(table, "joint.y")[500] == 0.0);
  CHECK(column(table, "joint.realisable")[500] == 0.0);
  CHECK(column(table, "joint.integral").back() == 0.0);
}

TEST_CASE("Before the hand pushes, the wanted resistance waits for it as it is") {
  const table::Table table =
      run_against("Step, time: 0.5 s, before: 0.05 N, after: 4 N", "kp: 1, ki: 30 Hz, threshold: 0.1 N");
  CHECK(column(table, "joint.y")[499] == 5.0);
  CHECK(column(table, "joint.y")[500] == 6.0);
}

TEST_CASE("Where nothing is wanted, nothing is asked for") {
  const table::Table table = run_text(
      "step: 1 ms\nstop: 10 ms\nblocks:\n  joint: {block: ForceFeedback, wanted: 0 N, measured: 4 "
      "N}\nrecord: "
      "[joint.y, joint.integral]\n");
  CHECK(column(table, "joint.y").back() == 0.0);
  CHECK(column(table, "joint.integral").back() == 0.0);
}
