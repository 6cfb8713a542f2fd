#include <catch2/catch.hpp>
#include <csignal>
#include <regex>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

const std::string swinging =
    "step: 1 ms\nstop: 2 s\nsolver: rk4\nblocks:\n  a: {block: Gain, gain: -40, u: x}\n"
    "  v: {block: Integrator, u: a}\n  x: {block: Integrator, u: v, initial: 0.1}\nrecord: [x, v]\n";

/// A step of the interpreter in the place of compiled code, but for one number at one tick.
struct WrongCode {
  static inline Executor* interpreter = nullptr;
  static inline std::size_t evaluated = 0, advanced = 0;  ///< places of wrong numbers; 0: none
  static inline std::int64_t at = 0;

  static void step(double* values, std::int64_t tick, void (Executor::*phase)(), std::size_t wrong) {
    Workspace workspace{tick, {values, values + interpreter->plan().layout.size}};
    interpreter->restore(workspace);
    if (phase == &Executor::advance) interpreter->evaluate();
    (interpreter->*phase)();
    std::copy_n(interpreter->values(), workspace.values.size(), values);
    if (wrong > 0 && tick == at) values[wrong] += 1e-15;
  }
  static void evaluate(double* values, const double*, std::int64_t tick) {
    step(values, tick, &Executor::evaluate, evaluated);
  }
  static void advance(double* values, const double*, std::int64_t tick) {
    step(values, tick, &Executor::advance, advanced);
  }
};

std::string difference(std::size_t evaluated, std::size_t advanced, std::int64_t at) {
  const plan::Plan plan = plan_text(swinging);
  Executor interpreter(plan);
  WrongCode::interpreter = &interpreter;
  WrongCode::evaluated = evaluated;
  WrongCode::advanced = advanced;
  WrongCode::at = at;
  return code_trial().fault(plan, {{WrongCode::evaluate, WrongCode::advance}, {}});
}

std::size_t place(const std::string& block) {
  const plan::Plan plan = plan_text(swinging);
  for (std::size_t b = 0; b < plan.blocks.size(); ++b)
    if (plan.diagram.blocks[b].name == block) return plan.blocks[b].outputs.front().offset;
  return 0;
}

}  // namespace

TEST_CASE("code with the interpreter's numbers passes its trial") {
  CHECK(difference(0, 0, 0) == "");
}

TEST_CASE("a wrong output is found at its tick, with both numbers") {
  const std::regex sentence(
      "compiled code gives other numbers: a is (-[0-9.]+) at 0.057 s, where the interpreter has (-[0-9.]+); "
      ".*");
  const std::string found = difference(place("a"), 0, 57);
  INFO(found);
  std::smatch numbers;
  REQUIRE(std::regex_match(found, numbers, sentence));
  CHECK(std::stod(numbers[1]) > std::stod(numbers[2]));
  CHECK(std::stod(numbers[1]) < std::stod(numbers[2]) + 1e-14);
}

TEST_CASE("a wrong state is found after its step") {
  CHECK_THAT(difference(0, place("x"), 999), Catch::Contains("x is ") && Catch::Contains("at 1 s"));
}

TEST_CASE("code that crashes ends its trial alone") {
  const plan::Plan plan = plan_text(swinging);
  const auto crash = [](double*, const double*, std::int64_t tick) {
    if (tick == 3) ::raise(SIGSEGV);
  };
  CHECK_THAT(code_trial().fault(plan, {{crash, crash}, {}}), Catch::Contains("compiled code "));
  CHECK_THAT(
      code_trial().fault(plan, {{[](double*, const double*, std::int64_t) { ::raise(SIGSEGV); }, crash}, {}}),
      Catch::Contains("was ended by signal 11"));
}

TEST_CASE("a trial ends after a thousand ticks") {
  CHECK(difference(0, place("x"), 1000) == "");
}

TEST_CASE("lanes that mix up their runs fail the trial") {
  const plan::Plan plan = plan_text(swinging);
  codegen::GeneratedCode source{code_trial()};
  const plan::RunDifferences differences{
      plan::variable_blocks(plan, diagram::Variation(plan.diagram, {"a.gain"})), {}};
  std::string why;
  auto lanes = source.compile_lanes(plan, differences, {}, why);
  if (!lanes) {
    WARN("there are no lanes here: " << why);
    return;
  }
  CHECK(code_trial().fault(plan, *lanes) == "");
  static void (*right)(plan::LaneTask&) = nullptr;
  right = lanes->run;
  static std::size_t x = 0;
  x = place("x");
  const std::size_t count = static_cast<std::size_t>(lanes->lanes);
  static std::size_t width = 0;
  width = count;
  lanes->run = [](plan::LaneTask& task) {
    std::swap(task.values[x * width], task.values[x * width + 1]);
    right(task);
  };
  CHECK_THAT(code_trial().fault(plan, *lanes), Catch::Contains("compiled code gives other numbers"));
}

}  // namespace stepwire::run
