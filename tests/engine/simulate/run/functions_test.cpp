#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "engine/base/math/elementary.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

/// A block, a formula and a parameter with functions; a solver that chooses its steps by powers.
const std::string swinging =
    "stepwire: 1\nstep: 10 ms\nstop: 5 s\nsolver: {name: dormand_prince, relative: 1e-6}\n"
    "parameters: {rate: {value: 1 1/s}, growth: {value: = exp(0.7)}}\nblocks:\n"
    "  s: {block: Clock}\n  t: {block: Gain, u: s, gain: 1 1/s}\n  wave: {block: Trig, function: tanh, u: "
    "t}\n"
    "  formula: {block: Expression, u: t, expression: exp(u)}\n"
    "  fixed: {block: Constant, value: $growth}\n"
    "  pull: {block: Expression, u: x, expression: -$rate*sin(u)}\n"
    "  x: {block: Integrator, u: pull, initial: 3}\nrecord: [wave, formula, fixed, x]\n";

RunResult run_of(const std::string& yaml, RunOptions options = {}) {
  const DiagramFolder folder;
  folder.write("main.yaml", yaml);
  diagram::Loader loader(library());
  return run_job(make_job(loader, folder.path("main.yaml")), options);
}

const std::vector<double>& recorded(const RunResult& result, const std::string& name) {
  for (const table::Column& column : result.recordings.front().table.columns)
    if (column.name == name) return column.values;
  FAIL(name << " is not recorded");
  return result.recordings.front().table.columns.front().values;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

std::vector<double> applied(double (*function)(double), const std::vector<double>& to) {
  std::vector<double> values;
  for (const double x : to) values.push_back(function(x));
  return values;
}

RunOptions compiled(codegen::GeneratedCode& code, LaneUse lanes) {
  RunOptions options;
  options.engine = ExecutionMode::compiled;
  options.code = &code;
  options.lanes = lanes;
  return options;
}

}  // namespace

TEST_CASE("blocks and formulas call the functions that the file names") {
  const RunResult portable = run_of(swinging), libm = run_of("functions: libm\n" + swinging);
  const std::vector<double>& time = recorded(libm, "time");
  CHECK(same_bits(recorded(libm, "formula"), applied(std::exp, time)));
  CHECK(same_bits(recorded(libm, "wave"), applied(std::tanh, time)));
  CHECK(recorded(libm, "fixed").front() == std::exp(0.7));
  CHECK(same_bits(recorded(portable, "formula"), applied(fn::sleef::exp, time)));
  CHECK(same_bits(recorded(portable, "wave"), applied(fn::sleef::tanh, time)));
  CHECK(recorded(portable, "fixed").front() == fn::sleef::exp(0.7));
  for (const char* name : {"formula", "wave"})
    CHECK_FALSE(same_bits(recorded(portable, name), recorded(libm, name)));
  // Last bits of a slope reach a state where steps are long and nothing damps them.
  const std::string slow =
      "stepwire: 1\nstep: 100 ms\nstop: 100 s\nsolver: rk4\nblocks:\n"
      "  pull: {block: Expression, u: x, expression: -sin(u)}\n"
      "  v: {block: Integrator, u: pull, initial: 0.3}\n"
      "  x: {block: Integrator, u: v, initial: 2}\nrecord: [x]\n";
  CHECK_FALSE(same_bits(recorded(run_of(slow), "x"), recorded(run_of("functions: libm\n" + slow), "x")));
  CHECK(recorded(portable, "x").back() == Approx(recorded(libm, "x").back()).epsilon(1e-9));
  CHECK(same_bits(recorded(run_of("functions: portable\n" + swinging), "x"), recorded(portable, "x")));
}

TEST_CASE("compiled code calls the functions that the file names") {
  codegen::GeneratedCode code{code_trial()};
  for (const char* head : {"", "functions: libm\n", "functions: portable\n"}) {
    INFO(head);
    const RunResult interpreted = run_of(head + swinging),
                    made = run_of(head + swinging, compiled(code, LaneUse::never));
    for (const char* name : {"formula", "wave", "fixed", "x"})
      CHECK(same_bits(recorded(made, name), recorded(interpreted, name)));
    if (codegen::Compiler().found()) CHECK(made.compiled_ticks == made.ticks);
  }
}

TEST_CASE("the runs of a sweep call the functions that the file names, alone and in lanes") {
  std::string text =
      "functions: libm\n" + swinging + "sweep: {rate: [1 1/s, 1.1 1/s, 1.2 1/s, 1.3 1/s, 1.4 1/s]}\n";
  text.replace(text.find("{name: dormand_prince, relative: 1e-6}"), 38, "rk4");
  codegen::GeneratedCode code{code_trial()};
  const RunResult together = run_of(text, compiled(code, LaneUse::at_once)), interpreted = run_of(text);
  INFO(together.lanes.why_not);
  const std::vector<double>& time = recorded(together, "time");
  CHECK(same_bits(recorded(together, "formula"), applied(std::exp, time)));
  for (const char* name : {"formula", "wave", "x"})
    CHECK(same_bits(recorded(together, name), recorded(interpreted, name)));
}

}  // namespace stepwire::run
