#include <fmt/format.h>

#include <bit>

#include "engine/simulate/codegen/generated_code.hpp"
#include "tests/random/law_tools.hpp"

namespace stepwire::random {

namespace {

/// Compiling takes most of the time, so that not every law about code is tried on each diagram.
Verdict compiled(const Trial& trial, BatchCode& code) {
  if (trial.seed % 2 == 0) return skipped("its sweep is compiled");
  run::RunOptions options;
  options.engine = run::ExecutionMode::compiled;
  options.code = &code;
  try {
    const run::RunResult result = run(*trial.loaded, options);
    if (!code.problem().empty()) return verdict_of(code.problem());
    if (result.compiled_ticks == 0 && result.ticks > 0) return skipped("it is not compiled yet");
    return verdict_of(difference(trial.expected, result));
  } catch (const yaml::Error&) {
    return skipped("no code can be made of a block");
  }
}

Verdict swept_compiled(const Trial& trial, BatchCode& code) try {
  if (trial.seed % 2 == 1) return skipped("its run is compiled");
  if (trial.sketch.parameters.empty()) return skipped("it has no parameter");
  const auto sweep = sweep_of(trial);
  run::RunOptions options;
  options.engine = run::ExecutionMode::compiled;
  options.lanes = run::LaneUse::never;
  options.code = &code;
  const run::RunResult result = run(*sweep, options);
  if (result.compiled_ticks == 0 && result.ticks > 0) return skipped("it is not compiled yet");
  return verdict_of(difference(one_by_one(*sweep), result));
} catch (const yaml::Error&) {
  return skipped("a value of the sweep is refused, or no code can be made of a block");
}

/// The code that the program itself makes for a run, with all that the compiler optimises.
Verdict compiled_as_runs_are(const Trial& trial, BatchCode& code) try {
  if (trial.seed % 24 != 0) return skipped("every 24th is tried");
  if (!code.has_compiler()) return skipped("there is no compiler");
  codegen::GeneratedCode own;
  run::RunOptions options;
  options.engine = run::ExecutionMode::compiled;
  options.code = &own;
  const run::RunResult result = run(*trial.loaded, options);
  if (result.compiled_ticks == 0 && result.ticks > 0) return skipped(own.take_problem());
  return verdict_of(difference(trial.expected, result));
} catch (const yaml::Error&) {
  return skipped("no code can be made of a block");
}

Verdict in_lanes(const Trial& trial, BatchCode& code) try {
  if (trial.seed % 2 == 1) return skipped("its run is compiled");
  if (trial.sketch.parameters.empty()) return skipped("it has no parameter");
  const auto sweep = sweep_of(trial);
  run::RunOptions options;
  options.engine = run::ExecutionMode::compiled;
  options.lanes = run::LaneUse::at_once;
  options.code = &code;
  const run::RunResult result = run(*sweep, options);
  if (result.lane_ticks == 0) return skipped(result.lanes.why_not);
  return verdict_of(difference(one_by_one(*sweep), result));
} catch (const yaml::Error&) {
  return skipped("a value of the sweep is refused, or no code can be made of a block");
}

std::vector<std::pair<std::size_t, std::size_t>> stretches_of(const plan::Layout& layout) {
  return {{layout.signals, layout.derivatives},
          {layout.discrete, layout.discrete + layout.discrete_count},
          {layout.diagnostics, layout.diagnostics + layout.diagnostic_count}};
}

std::string workspace_difference(const plan::Plan& plan, const double* expected, const double* other) {
  for (const auto& [first, end] : stretches_of(plan.layout))
    for (std::size_t i = first; i < end; ++i)
      if (std::bit_cast<std::uint64_t>(expected[i]) != std::bit_cast<std::uint64_t>(other[i]))
        return fmt::format("number {} of the workspace is {} and not {}", i, other[i], expected[i]);
  return "";
}

std::string program_difference(const plan::Plan& plan, const OwnProgram& program) {
  run::Executor interpreted(plan);
  void* own = program.make();
  std::vector<double> numbers(plan.layout.size);
  std::string text;
  while (text.empty() && interpreted.healthy() && !interpreted.finished()) {
    interpreted.evaluate();
    program.evaluate(own, numbers.data());
    text = workspace_difference(plan, interpreted.values(), numbers.data());
    if (!text.empty()) text += fmt::format(" at tick {}", interpreted.tick());
    interpreted.advance();
    program.advance(own);
  }
  program.free(own);
  return text;
}

Verdict generated(const Trial& trial, BatchCode& code) try {
  if (trial.seed % 3 != 0) return skipped("every third is tried");
  const auto program = code.program(trial.loaded->plan(), trial.seed % 2 == 0);
  if (!code.problem().empty()) return verdict_of(code.problem());
  if (!program) return skipped("it is not compiled yet");
  return verdict_of(program_difference(trial.loaded->plan(), *program));
} catch (const yaml::Error&) {
  return skipped("no code can be made of a block");
}

}  // namespace

const std::vector<Law>& laws_of_code() {
  static const std::vector<Law> all{{"compiled", compiled, true, true},
                                    {"swept and compiled", swept_compiled, true, true},
                                    {"swept in lanes", in_lanes, true, true},
                                    {"compiled as runs are", compiled_as_runs_are, false, true},
                                    {"generated program", generated, true, true}};
  return all;
}

}  // namespace stepwire::random
