#include "engine/simulate/run/executor.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Commands of 0.4 and 0.2 A, with a fault from 100 to 200 ms.
table::Table faulty(const std::string& keys, const std::string& more = "") {
  return run_text(
      "step: 1 ms\nstop: 600 ms\nblocks:\n  fault: {block: Pulse, amplitude: 1, delay: 100 ms, period: 10 s, "
      "width: 0.01}\n" +
      more + "  lock: {block: Interlock, u: [0.4 A, 0.2 A], faults: [0, fault], causes: [speed, force]" +
      keys + "}\nrecord: [lock.y, lock.cause]\n");
}

std::string pressed(const std::string& name, const std::string& from, const std::string& width) {
  return "  " + name + ": {block: Pulse, amplitude: 1, delay: " + from + ", period: 10 s, width: " + width +
         "}\n";
}

std::size_t first_output(const plan::Plan& plan, const std::string& name) {
  for (std::size_t b = 0; b < plan.blocks.size(); ++b)
    if (plan.diagram.blocks[b].name == name) return plan.blocks[b].outputs[0].offset;
  throw std::logic_error("there is no block " + name);
}

}  // namespace

TEST_CASE("An interlock lets commands through unchanged as long as nothing is wrong, after its ramp") {
  const table::Table table = faulty(", ramp: 50 ms");
  for (std::size_t k = 0; k < 100; ++k) {
    const double share = std::min(1.0, static_cast<double>(k) / 50.0);
    CHECK(column(table, "lock.y.1")[k] == Approx(0.4 * share).margin(1e-12));
    CHECK(column(table, "lock.y.2")[k] == Approx(0.2 * share).margin(1e-12));
    CHECK(column(table, "lock.cause")[k] == 0.0);
  }
}

TEST_CASE("The commands are 0 from the tick of the fault on, and stay 0 when it is over") {
  const table::Table table = faulty(", ramp: 0 s");
  CHECK(column(table, "lock.y.1")[99] == 0.4);
  for (std::size_t k = 100; k <= 600; ++k) {
    REQUIRE(column(table, "lock.y.1")[k] == 0.0);
    REQUIRE(column(table, "lock.y.2")[k] == 0.0);
    REQUIRE(column(table, "lock.cause")[k] == 3.0);
  }
}

TEST_CASE("A reset brings the commands back by the ramp, once the fault is over") {
  const table::Table late = faulty(", ramp: 100 ms, reset: button", pressed("button", "300 ms", "0.001"));
  CHECK(column(late, "lock.y.1")[299] == 0.0);
  for (std::size_t k = 300; k < 400; ++k) {
    const double share = static_cast<double>(k - 300) / 100.0;
    CHECK(column(late, "lock.y.1")[k] == Approx(0.4 * share).margin(1e-9));
  }
  CHECK(column(late, "lock.y.1").back() == 0.4);
  const table::Table early = faulty(", ramp: 0 s, reset: button", pressed("button", "150 ms", "0.001"));
  CHECK(column(early, "lock.y.1").back() == 0.0);
}

TEST_CASE("A reset that is held all the time hides no fault") {
  const table::Table table = faulty(", ramp: 0 s, reset: 1");
  CHECK(column(table, "lock.y.1")[99] == 0.4);
  CHECK(column(table, "lock.y.1")[100] == 0.0);
  CHECK(column(table, "lock.y.1").back() == 0.0);
}

TEST_CASE(
    "Letting go of the dead-man switch cuts the commands off at once; pressing it brings them back by the "
    "ramp") {
  const table::Table table = run_text(
      "step: 1 ms\nstop: 300 ms\nblocks:\n  hand: {block: Pulse, amplitude: -1, bias: 1, delay: 100 ms, "
      "period: 10 s, "
      "width: 0.01}\n  lock: {block: Interlock, u: 0.4 A, faults: [0], dead_man: hand, ramp: 50 ms}\nrecord: "
      "[lock.y, lock.cause]\n");
  const auto& y = column(table, "lock.y");
  CHECK(y[99] == 0.4);
  for (std::size_t k = 100; k <= 200; ++k) REQUIRE(y[k] == 0.0);
  CHECK(y[225] == Approx(0.2));
  CHECK(y.back() == 0.4);
  CHECK(column(table, "lock.cause").back() == 0.0);
}

TEST_CASE("Of several faults the first one is named, of those at one tick the first in the list") {
  const auto cause = [](const std::string& a, const std::string& b) {
    return column(
               run_text(
                   "step: 1 ms\nstop: 20 ms\nblocks:\n  a: {block: Step, time: " + a +
                   ", after: 1}\n  b: {block: Step, time: " + b +
                   ", after: 1}\n  lock: {block: Interlock, u: 1, faults: [a, b]}\nrecord: [lock.cause]\n"),
               "lock.cause")
        .back();
  };
  CHECK(cause("5 ms", "6 ms") == 2.0);
  CHECK(cause("6 ms", "5 ms") == 3.0);
  CHECK(cause("5 ms", "5 ms") == 2.0);
}

TEST_CASE("A number that is none cuts the commands off at the very tick that shows it, before the run ends") {
  for (const std::string what : {"u: asked, measured: [5 mm]", "u: [0.4 A, 0.2 A], measured: [5 mm, bad]"}) {
    const plan::Plan plan = plan_text(
        "step: 1 ms\nstop: 20 ms\nblocks:\n  clock: {block: Clock}\n  bad: {block: Expression, u: clock, "
        "expression: sqrt(0.0095 - u1)}\n  asked: {block: Mux, u: [0.4, bad]}\n  lock: {block: Interlock, "
        "ramp: 0 s, faults: [0], " +
        what + "}\nrecord: [lock.y, lock.cause]\n");
    run::Executor simulation(plan);
    const double* current = simulation.values() + first_output(plan, "lock");
    while (simulation.healthy()) {
      simulation.evaluate();
      if (simulation.healthy()) REQUIRE(current[0] == 0.4);
      if (simulation.healthy()) simulation.advance();
    }
    CHECK(simulation.tick() == 10);
    CHECK(current[0] == 0.0);
    CHECK(current[1] == 0.0);
  }
}

TEST_CASE("With stop the run ends with the name of the cause, and without it a notice tells it") {
  const std::string message = error_of(
      "step: 1 ms\nstop: 1 s\nblocks:\n  fault: {block: Step, time: 0.25 s, after: 1}\n  lock: {block: "
      "Interlock, u: 1, "
      "faults: [0, fault], causes: [speed, excessive force], stop: true}\n");
  CHECK_THAT(message, Catch::Contains("lock") && Catch::Contains("excessive force (cause 3)") &&
                          Catch::Contains("0.25 s") && Catch::Contains("the run ends here"));
}

TEST_CASE("An interlock with too few names is refused") {
  CHECK_THAT(
      error_of(
          "step: 1 ms\nstop: 1 s\nblocks:\n  lock: {block: Interlock, u: 1, faults: [0, 0], causes: [a]}\n"),
      Catch::Contains("lock.causes") && Catch::Contains("there is 1 name for 2 faults"));
}
