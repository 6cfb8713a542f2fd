#include "engine/simulate/run/run.hpp"

#include "engine/simulate/run/drive.hpp"

namespace stepwire::run {

std::string fault_of(const Executor& simulation) {
  const auto fault = simulation.fault();
  return fault ? fault->fault.text() : "the run ended early";
}

RunEnd end_of(const Executor& simulation) {
  RunEnd end;
  if (auto fault = simulation.fault()) end.faults.push_back(std::move(*fault));
  end.diagnostics = simulation.diagnostics();
  end.loops = simulation.loop_costs();
  end.steps = simulation.step_count();
  end.events = simulation.event_count();
  end.ticks = simulation.tick();
  return end;
}

RunResult run_plan(const plan::Plan& plan, const RunOptions& options) {
  const ExecutionMode engine = plan.records_instants() ? ExecutionMode::interpreted : options.engine;
  TieredExecution changeover(engine, options.code, {{&plan, {}}}, static_cast<double>(plan.steps));
  Executor simulation(plan);
  record::RunRecording recording(plan);
  RunResult result{run_simulation(simulation, recording.recorders(), options, changeover, 0, 0), {}};
  result.recordings = recording.take();
  return result;
}

RunEnd run_simulation(Executor& simulation, std::vector<record::Recorder>& recorders,
                      const RunOptions& options, TieredExecution& changeover, std::size_t member,
                      std::size_t index) {
  std::int64_t changed = -1;  // tick at which compiled code took over
  const auto take_over = [&] {
    const plan::CompiledPlan* code = simulation.compiled() ? nullptr : changeover.code(member);
    if (code) simulation.use(*code);
    if (changed < 0 && simulation.compiled()) changed = simulation.tick();
  };
  take_over();
  Drive drive(simulation, recorders);
  drive.index = index;
  drive.observers = options.observers;
  drive.shows_rows = options.shows_rows;
  drive.interrupt = options.interrupt;
  drive.look = [&] {
    changeover.done(Drive::ticks_between_looks);
    take_over();
    if (options.progress)
      options.progress(static_cast<double>(simulation.tick()) / static_cast<double>(simulation.plan().steps));
  };
  const Drive::End how = drive.run();
  RunEnd end = end_of(simulation);
  end.interrupted = how == Drive::End::interrupted;
  end.stopped = how == Drive::End::stopped || how == Drive::End::paused;
  end.compiled_ticks = changed < 0 ? 0 : end.ticks - changed;
  return end;
}

}  // namespace stepwire::run
