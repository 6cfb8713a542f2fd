#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Returns the learnt load for a force in a motion along x.
table::Table learnt(const std::string& force, const std::string& velocity, const std::string& keys,
                    const std::string& stop) {
  return run_text("step: 10 ms\nstop: " + stop + "\nblocks:\n" + force + velocity +
                  "  v: {block: Mux, u: [vx, 0 m/s]}\n  f: {block: Mux, u: [fx, 0 N]}\n"
                  "  l: {block: LoadAdaptation, force: f, velocity: v, every: 10 ms" +
                  keys + "}\nrecord: [l.y, l.learned, l.fast, l.slow, l.felt]\n");
}

const std::string four = "  fx: {block: Constant, value: 4 N}\n";
const std::string moving = "  vx: {block: Constant, value: 10 mm/s}\n";

}  // namespace

TEST_CASE("Of a lasting load b T/(1 + b T) is carried, with the gains of both states in b T") {
  const table::Table run = learnt(four, moving, "", "300 s");
  const double gain = 0.35 * 1.14 + 0.033 * 75.0;
  CHECK(column(run, "l.y.1").back() == Approx(4.0 * gain / (1.0 + gain)).epsilon(1e-3));
  CHECK(column(run, "l.y.2").back() == Approx(0.0).margin(1e-12));
}

TEST_CASE("Learning follows both differential equations") {
  const table::Table run = learnt(four, moving, "", "5 s");
  double fast = 0.0, slow = 0.0;
  for (int k = 0; k < 5000; ++k) {  // in steps of 1 ms
    const double wrong = 4.0 - fast - slow;
    fast += 1e-3 * (0.35 * wrong - fast / 1.14);
    slow += 1e-3 * (0.033 * wrong - slow / 75.0);
  }
  CHECK(column(run, "l.fast").back() == Approx(fast).epsilon(0.01));
  CHECK(column(run, "l.slow").back() == Approx(slow).epsilon(0.01));
}

TEST_CASE(
    "What the trials before have left is there at once, and rests when the hand rests, but for forgetting") {
  const table::Table run =
      learnt(four, "  vx: {block: Constant, value: 0 m/s}\n", ", initial_fast: 1, initial_slow: 2", "10 s");
  CHECK(column(run, "l.learned").front() == 3.0);
  CHECK(column(run, "l.y.1").back() == 0.0);
  CHECK(column(run, "l.fast").back() == Approx(std::exp(-10.0 / 1.14)).epsilon(0.06));
  CHECK(column(run, "l.slow").back() == Approx(2.0 * std::exp(-10.0 / 75.0)).epsilon(1e-3));
}

TEST_CASE("A load that is no longer felt is no longer pushed against a few reflexes later") {
  const table::Table run =
      learnt("  fx: {block: Step, time: 60 s, before: 4 N, after: 0 N}\n", moving, "", "60.5 s");
  const auto& push = column(run, "l.y.1");
  CHECK(push[5999] > 2.0);
  CHECK(push[6020] < 0.03 * push[5999]);  // after four times the reflex
  CHECK(column(run, "l.fast").back() < 0.02);
}

TEST_CASE("The force is never more than its share of what is felt, nor than the strength") {
  const std::string left = ", initial_slow: 30, onset: 10 ms";
  CHECK(column(learnt(four, moving, left + ", most: 0.9", "1 s"), "l.y.1").back() == Approx(3.6));
  CHECK(column(learnt("  fx: {block: Constant, value: 40 N}\n", moving, left + ", strength: 5 N", "1 s"),
               "l.y.1")
            .back() == Approx(5.0));
}

TEST_CASE("The force turns about with the motion within its onset") {
  const table::Table run =
      learnt("  fx: {block: Step, time: 30 s, before: 4 N, after: -4 N}\n",
             "  vx: {block: Step, time: 30 s, before: 10 mm/s, after: -10 mm/s}\n", "", "32 s");
  const auto& push = column(run, "l.y.1");
  CHECK(push[2999] > 1.0);
  CHECK(push.back() < -1.0);
  CHECK(column(run, "l.felt").back() == Approx(4.0));
}
