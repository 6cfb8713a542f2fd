#include <fmt/format.h>

#include <bit>

#include "engine/simulate/run/drive.hpp"
#include "tests/random/law_tools.hpp"

namespace stepwire::random {

namespace {

constexpr const char* no_code = "no code can be made of a block, or a value of the sweep is refused";
constexpr const char* not_yet = "it is not compiled yet";

run::RunOptions with_code(plan::CodeSource& code) {
  run::RunOptions options;
  options.engine = run::ExecutionMode::compiled;
  options.lanes = run::LaneUse::never;
  options.code = &code;
  return options;
}

/// Compares with a run, or all runs of a sweep, that code has made from the first tick on.
Verdict like_compiled(const run::RunResult& expected, const Loaded& loaded, BatchCode& code,
                      const run::RunOptions& options) {
  const run::RunResult result = run(loaded, options);
  if (!code.problem().empty()) return verdict_of(code.problem());
  if (result.compiled_ticks == 0 && result.ticks > 0) return skipped(not_yet);
  return verdict_of(difference(expected, result));
}

Verdict compiled(const Trial& trial, BatchCode& code) try {
  return like_compiled(trial.expected, *trial.loaded, code, with_code(code));
} catch (const yaml::Error&) {
  return skipped(no_code);
}

Verdict swept_compiled(const Trial& trial, BatchCode& code) try {
  if (trial.sketch.parameters.empty()) return skipped("it has no parameter");
  const auto sweep = sweep_of(trial);
  return like_compiled(one_by_one(*sweep), *sweep, code, with_code(code));
} catch (const yaml::Error&) {
  return skipped(no_code);
}

Verdict in_lanes(const Trial& trial, BatchCode& code) try {
  if (trial.sketch.parameters.empty()) return skipped("it has no parameter");
  const auto sweep = sweep_of(trial);
  run::RunOptions options = with_code(code);
  options.lanes = run::LaneUse::at_once;
  const run::RunResult result = run(*sweep, options);
  if (result.lane_ticks == 0) return skipped(result.lanes.why_not);
  return verdict_of(difference(one_by_one(*sweep), result));
} catch (const yaml::Error&) {
  return skipped(no_code);
}

Verdict compiled_as_runs_are(const Trial& trial, BatchCode& code) try {
  const auto own = code.as_runs_have_it(trial.loaded->plan());
  if (!code.problem().empty()) return verdict_of(code.problem());
  if (!own) return skipped(not_yet);
  run::Executor simulation(trial.loaded->plan());
  simulation.use(*own);
  record::RunRecording recording(trial.loaded->plan());
  run::Drive(simulation, recording.recorders()).run();
  run::RunResult result{run::end_of(simulation), recording.take(), {}};
  return verdict_of(difference(trial.expected, result));
} catch (const yaml::Error&) {
  return skipped(no_code);
}

// --- Runs that begin in the interpreter.

/// Hands a run to its code at a tick, and sets a parameter at another one, which takes it back.
class TakingOver : public run::RunObserver {
 public:
  TakingOver(const plan::CompiledPlan* code, std::int64_t take_at, std::int64_t set_at, const Key* parameter)
      : code_(code), take_at_(take_at), set_at_(set_at), parameter_(parameter) {}

  run::Flow before_tick(const run::ObservedRun& run) override {
    if (code_ && run.simulation.tick() == take_at_) run.simulation.use(*code_);
    if (parameter_ && run.simulation.tick() == set_at_)
      static_cast<void>(run.simulation.set(parameter_->name, swept_values(*parameter_)[3]));
    return run::Flow::go_on;
  }

 private:
  const plan::CompiledPlan* code_;
  std::int64_t take_at_, set_at_;
  const Key* parameter_;
};

run::RunResult observed(const Loaded& loaded, run::RunObserver& observer) {
  run::RunOptions options;
  options.observers = {&observer};
  return run(loaded, options);
}

Verdict taken_over(const Trial& trial, BatchCode& code) try {
  const auto own = code.compile(trial.loaded->plan(), {}, {});
  if (!own) return skipped(not_yet);
  Dice dice = dice_of(trial, 4);
  TakingOver observer(&*own, dice.whole(1, 40), 0, nullptr);
  return verdict_of(difference(trial.expected, observed(*trial.loaded, observer)));
} catch (const yaml::Error&) {
  return skipped(no_code);
}

Verdict set_while_compiled(const Trial& trial, BatchCode& code) try {
  if (trial.sketch.parameters.empty()) return skipped("it has no parameter");
  const auto own = code.compile(trial.loaded->plan(), {}, {});
  if (!own) return skipped(not_yet);
  Dice dice = dice_of(trial, 5);
  const int tick = dice.whole(5, 40);
  TakingOver interpreted(nullptr, 0, tick, &swept_parameter(trial));
  TakingOver compiled(&*own, 2, tick, &swept_parameter(trial));
  return verdict_of(difference(observed(*trial.loaded, interpreted), observed(*trial.loaded, compiled)));
} catch (const yaml::Error&) {
  return skipped(no_code);
}

// --- Programs of their own.

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
  const auto program = code.program(trial.loaded->plan(), trial.seed % 2 == 0);
  if (!code.problem().empty()) return verdict_of(code.problem());
  if (!program) return skipped(not_yet);
  return verdict_of(program_difference(trial.loaded->plan(), *program));
} catch (const yaml::Error&) {
  return skipped(no_code);
}

}  // namespace

// Compiling takes most of the time, so that not every law is tried on each
// diagram.
const std::vector<Law>& laws_of_code() {
  static const std::vector<Law> all{{"compiled", compiled, 2, 1, true, true},
                                    {"taken over by code", taken_over, 2, 1, true, true},
                                    {"set while compiled", set_while_compiled, 2, 1, true, true},
                                    {"swept and compiled", swept_compiled, 2, 0, true, true},
                                    {"swept in lanes", in_lanes, 1, 0, true, true},
                                    {"compiled as runs are", compiled_as_runs_are, 24, 7, true, true},
                                    {"generated program", generated, 3, 0, true, true},
                                    {"exported and imported", exported, 12, 5, true, true},
                                    {"exported for exchange", exported_for_exchange, 14, 3, true, true}};
  return all;
}

}  // namespace stepwire::random
