#include "engine/run/run.hpp"

#include "engine/record/recorder.hpp"
#include "engine/run/stopper.hpp"

namespace stepwire {

namespace {

constexpr std::int64_t ticks_between_looks = 256;  // at the interrupt flag and the stop condition's progress

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
  if (options.ended) options.ended(simulation);
  for (const Recorder& recorder : recorders) result.recordings.push_back(recorder.take());
  if (auto fault = simulation.fault()) result.faults.push_back(std::move(*fault));
  result.notices = simulation.notices();
  result.ticks = simulation.tick();
  result.compiled_ticks = changed < 0 ? 0 : result.ticks - changed;
  return result;
}

}  // namespace stepwire
