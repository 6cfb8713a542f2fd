// Places in the workspace of numbers that need not be copied.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::plan {

namespace {

std::size_t offset(const Plan& plan, const std::string& block) {
  const auto& blocks = plan.diagram.blocks;
  const auto found = std::find_if(blocks.begin(), blocks.end(),
                                  [&](const diagram::DiagramBlock& one) { return one.name == block; });
  return plan.blocks[static_cast<std::size_t>(found - blocks.begin())].outputs.front().offset;
}

bool is_slope(const Plan& plan, const std::string& block) {
  return offset(plan, block) >= plan.layout.derivatives &&
         offset(plan, block) < plan.layout.derivatives + plan.layout.state_count;
}

}  // namespace

TEST_CASE("what an integrator integrates is written right where its slope is read") {
  const Plan plan = plan_text(
      "solver: rk4\nblocks:\n  back: {block: Gain, gain: -1, u: x}\n  x: {block: Integrator, u: back, "
      "initial: 1}\n");
  CHECK(is_slope(plan, "back"));
  CHECK(plan.derivatives.empty());
}

TEST_CASE("of two integrators of one signal the second reads it as any other block does") {
  const std::string text =
      "step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  back: {block: Gain, gain: -1, u: x}\n"
      "  x: {block: Integrator, u: back, initial: 1}\n  y: {block: Integrator, u: back, initial: 3}\n"
      "record: [x, y, back]\n";
  const Plan plan = plan_text(text);
  REQUIRE(plan.derivatives.size() == 1);
  CHECK(plan.derivatives.front().count == 1);
  const table::Table run = run_text(text);
  CHECK(column(run, "x").back() == Approx(std::exp(-1.0)).epsilon(1e-12));
  CHECK(column(run, "y").back() == Approx(2.0 + std::exp(-1.0)).epsilon(1e-12));
  CHECK(column(run, "back").back() == -column(run, "x").back());
}

TEST_CASE("states, sources of time and limited integrators keep their slopes apart") {
  const Plan plan = plan_text(
      "solver: rk4\nblocks:\n  wave: {block: Sine}\n  x: {block: Integrator, u: wave}\n"
      "  xx: {block: Integrator, u: x}\n  back: {block: Gain, gain: -1, u: xx}\n"
      "  held: {block: Integrator, u: back, upper: 1}\n");
  for (const char* block : {"wave", "x", "back"}) CHECK_FALSE(is_slope(plan, block));
}

TEST_CASE("a slope that a slower block writes holds between its ticks") {
  const table::Table run = run_text(
      "step: 1 s\nstop: 6 s\nsolver: rk4\nblocks:\n  t: {block: Clock}\n"
      "  held: {block: Gain, gain: 1, u: t, every: 3 s}\n  x: {block: Integrator, u: held}\nrecord: [x, "
      "held]\n");
  CHECK(column(run, "held") == std::vector<double>{0, 0, 0, 3, 3, 3, 6});
  CHECK(column(run, "x") == std::vector<double>{0, 0, 0, 0, 3, 6, 9});
}

TEST_CASE("a signal in the place of a slope that is not finite ends the run as any other does") {
  const run::RunResult result = result_of(
      "solver: rk4\nblocks:\n  huge: {block: Gain, gain: 1e308, u: x}\n  x: {block: Integrator, u: huge, "
      "initial: 10}\n");
  REQUIRE(result.faults.size() == 1);
  CHECK(result.faults[0].block == "huge");
  CHECK(result.faults[0].time == 0.0);
}

}  // namespace stepwire::plan
