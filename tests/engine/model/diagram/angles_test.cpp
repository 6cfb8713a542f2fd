// Angles are shown in rad, and count as 1.
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {

namespace {

std::string unit_of(const plan::Plan& plan, const std::string& block) {
  for (std::size_t b = 0; b < plan.diagram.blocks.size(); ++b)
    if (plan.diagram.blocks[b].name == block) return unit::si_name(*plan.diagram.output_dimensions[b][0]);
  return "none";
}

}  // namespace

TEST_CASE("an angle stays one through sums, gains and integrators, forward and backward") {
  const plan::Plan plan = plan_text(
      "solver: rk4\nblocks:\n"
      "  torque: {block: Constant, value: 3 N m}\n"
      "  alpha: {block: Gain, u: torque, gain: 0.5 1/(kg m^2)}\n"
      "  omega: {block: Integrator, u: alpha}\n"
      "  theta: {block: Integrator, u: omega, initial: 45 deg}\n"
      "  wanted: {block: Constant, value: 30 deg}\n"
      "  error: {block: Sum, signs: \"+-\", u: [wanted, theta]}\n"
      "  twice: {block: Gain, u: error, gain: 2}\n"
      "record: [twice, alpha]\n");
  CHECK(unit_of(plan, "wanted") == "rad");
  CHECK(unit_of(plan, "error") == "rad");
  CHECK(unit_of(plan, "theta") == "rad");
  CHECK(unit_of(plan, "omega") == "rad/s");
}

TEST_CASE("a torque per angle times an angle is a torque, and a length times an angle a length") {
  const plan::Plan plan = plan_text(
      "blocks:\n"
      "  theta: {block: Constant, value: 30 deg}\n"
      "  spring: {block: Gain, u: theta, gain: 2 N m/rad}\n"
      "  arc: {block: Gain, u: theta, gain: 0.2 m}\n"
      "record: [spring, arc]\n");
  CHECK(unit_of(plan, "spring") == "N m");
  CHECK(unit_of(plan, "arc") == "m");
}

TEST_CASE("what is no angle is none, and both may be joined as before") {
  const plan::Plan plan = plan_text(
      "blocks:\n"
      "  share: {block: Constant, value: 50 %}\n"
      "  angle: {block: Constant, value: 1 rad}\n"
      "  both: {block: Product, u: [share, angle]}\n"
      "  sum: {block: Sum, u: [share, share]}\n"
      "record: [both, sum]\n");
  CHECK(unit_of(plan, "sum") == "1");
  CHECK(unit_of(plan, "both") == "rad");
}

}  // namespace stepwire::diagram
