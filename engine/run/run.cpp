#include "engine/run/run.hpp"

#include <algorithm>

#include "engine/record/recorder.hpp"

namespace stepwire {

namespace {

constexpr std::int64_t ticks_between_looks = 256;  // at the interrupt flag and the stop condition's progress

/// Evaluates `stop_when` at a tick.
class Stopper {
 public:
  explicit Stopper(const Plan& plan) {
    if (!plan.diagram.stop_when) return;
    condition_ = plan.diagram.stop_when->expression;
    for (const SignalRef& signal : plan.diagram.stop_when->variables)
      offsets_.push_back(signal.block < 0 ? plan.layout.time : plan.slot(signal).offset);
    numbers_.resize(offsets_.size());
  }
  bool stops(const double* values) {
    if (!condition_) return false;
    for (std::size_t i = 0; i < offsets_.size(); ++i) numbers_[i] = values[offsets_[i]];
    return (*condition_)(numbers_) != 0.0;
  }

 private:
  std::optional<Expression> condition_;
  std::vector<std::size_t> offsets_;
  std::vector<double> numbers_;
};

}  // namespace

RunResult run_plan(const Plan& plan, const RunOptions& options) {
  Changeover changeover(options.engine, options.code, {&plan});
  return run_plan(plan, options, changeover, 0);
}

RunResult run_plan(const Plan& plan, const RunOptions& options, Changeover& changeover, std::size_t index) {
  Simulation simulation(plan);
  std::int64_t changed = -1;  // tick at which compiled code took over
  const auto take_over = [&] {
    const CompiledPlan* code = changed < 0 ? changeover.code(index) : nullptr;
    if (!code) return;
    simulation.use(*code);
    changed = simulation.tick();
  };
  take_over();
  std::vector<Recorder> recorders;
  for (const RecordRequest& request : plan.diagram.records) recorders.emplace_back(plan, request);
  Stopper stopper(plan);
  RunResult result;
  while (true) {
    simulation.evaluate();
    for (Recorder& recorder : recorders)
      if (simulation.healthy()) recorder.record(simulation.tick(), simulation.values());
    if (!simulation.healthy() || simulation.finished() || stopper.stops(simulation.values())) break;
    simulation.advance();
    if (!simulation.healthy()) break;
    if (simulation.tick() % ticks_between_looks != 0) continue;
    changeover.done(ticks_between_looks);
    take_over();
    if (options.progress)
      options.progress(static_cast<double>(simulation.tick()) / static_cast<double>(plan.steps));
    result.interrupted = options.interrupt && *options.interrupt;
    if (result.interrupted) break;
  }
  for (const Recorder& recorder : recorders) result.recordings.push_back(recorder.take());
  if (auto fault = simulation.fault()) result.faults.push_back(std::move(*fault));
  result.notices = simulation.notices();
  result.ticks = simulation.tick();
  result.compiled_ticks = changed < 0 ? 0 : result.ticks - changed;
  return result;
}

}  // namespace stepwire
