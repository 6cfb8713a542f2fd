#include <catch2/catch.hpp>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::run {

TEST_CASE("compiled code controls the error with the bits of the interpreter") {
  codegen::GeneratedCode source{run::code_trial()};
  // Van der Pol's oscillator, mu = 100, with a sampled push: explicit steps, then implicit ones.
  const std::string blocks = R"(
blocks:
  wave: {block: Sine, frequency: 0.01 Hz, every: 1 s}
  pull: {block: Expression, u: [y, v, wave], expression: "100*(1 - u1^2)*u2 - u1 + u3"}
  v:    {block: Integrator, u: pull}
  y:    {block: Integrator, u: v, initial: 2}
record: [y, v]
)";
  const plan::Plan plan = plan_text("step: 500 ms\nstop: 100 s\nsolver: auto" + blocks);
  const auto code = source.compile(plan, {}, {});
  INFO(source.take_problem());
  REQUIRE(code);
  Executor one(plan), other(plan);
  other.use(*code);
  while (!one.finished()) {
    one.evaluate();
    other.evaluate();
    for (std::size_t i = plan.layout.signals; i < plan.layout.derivatives; ++i)
      REQUIRE(one.values()[i] == other.values()[i]);
    one.advance();
    other.advance();
  }
  CHECK(other.compiled());
}

}  // namespace stepwire::run
