#include "engine/app/session/loop_run.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "engine/app/session/loop_files.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/realtime/row_writer.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/memory.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::session {

namespace {

constexpr double seconds_in_ring = 4.0;  // delay of the writer that the ring buffer can absorb [s]
constexpr double min_numbers = 1 << 16, max_numbers = 1 << 23;
constexpr double slice = 1.0;  // length of alternating slices of loop and baseline [s]

/// Returns the plan of a loop, which runs the file once with its own values, so sweep, figures and claims are
/// ignored. Event location is switched off, because its number of step divisions is unbounded and could miss
/// any deadline.
plan::Plan plan_for_loop(const LoopCall& call, const Registry& registry, const LoopSettings& settings,
                         const Monitor& monitor) {
  diagram::Loader loader(registry, call.load.limits);
  diagram::Diagram diagram = loader.load_point(call.file, call.load.settings);
  if (std::exchange(diagram.events.locate, false) && monitor.diagnostic)
    monitor.diagnostic("'events: locate' does not hold in a loop, which finds at its ticks what crosses");
  plan::Plan plan = plan::make_plan(std::move(diagram));
  run::require_solver_memory(plan);
  realtime::ticks_per_period(plan.diagram, settings.rate);
  realtime::require_fit_for_loop(plan);
  return plan;
}

std::size_t ring_size(const plan::Plan& plan, const LoopSettings& settings) {
  const auto of_tick = static_cast<double>(realtime::LoopRecorder::numbers_per_tick(plan));
  const auto ticks = static_cast<double>(realtime::ticks_per_period(plan.diagram, settings.rate));
  const double wanted = seconds_in_ring * settings.rate * ticks * of_tick;
  return static_cast<std::size_t>(
      std::max(std::clamp(wanted, min_numbers, max_numbers), 16.0 * ticks * of_tick));
}

/// Prepares the folder and writes a replay with the present data files.
std::unique_ptr<io::OwnedFolder> folder_with_replay(const std::string& path, const plan::Plan& plan) {
  auto folder = std::make_unique<io::OwnedFolder>(path, [&] { return replay::files_read(plan); });
  replay::write_replay(path, plan);
  return folder;
}

/// Output folder of a loop: its rows during the run, and its results at the end.
class LoopFolder {
 public:
  LoopFolder(const plan::Plan& plan, const LoopSettings& settings, const std::string& path)
      : path_(path),
        owned_(folder_with_replay(path, plan)),
        ring_(ring_size(plan, settings)),
        recorder_(plan, ring_),
        writer_(ring_, path, realtime::loop_files(plan)) {}

  realtime::LoopRecorder& recorder() { return recorder_; }
  LoopRows finish() {
    writer_.finish();
    return {writer_.rows(), recorder_.lost(), writer_.lost(), writer_.trouble()};
  }
  void describe(const LoopOutcome& outcome) const {
    io::write_file(path_ + "/loop.json", loop_json(outcome).text() + "\n");
    render::write_figure(path_, "loop", loop_figure(outcome), "loop-figure");
  }

 private:
  const std::string path_;
  std::unique_ptr<io::OwnedFolder> owned_;
  realtime::RowRing ring_;
  realtime::LoopRecorder recorder_;
  realtime::RowWriter writer_;
};

/// Compiles the code unless the engine is the interpreter; nullopt also if it cannot be compiled. With `auto`
/// it compiles as well, because a running loop has no time for that.
std::optional<plan::CompiledPlan> code_for(const plan::Plan& plan, run::ExecutionMode engine,
                                           const Monitor& monitor) {
  if (engine == run::ExecutionMode::interpreted) return std::nullopt;
  codegen::GeneratedCode source{run::code_trial()};
  std::optional<plan::CompiledPlan> code = source.compile(plan, {}, {});
  monitor.note_interpreted(source.take_problem());
  return code;
}

/// Runs the loop to its end. With a baseline, slices of both alternate.
realtime::Served serve_all(realtime::Loop& loop, const LoopSettings& settings,
                           std::optional<realtime::Cyclictest>& baseline, const Monitor& monitor) {
  const auto count =
      baseline ? std::max<std::int64_t>(1, std::llround(slice * settings.rate)) : settings.deadlines;
  realtime::Served served;
  while (!loop.ended()) {
    const std::int64_t left = settings.deadlines - loop.deadlines().index();
    if (baseline && !monitor.interrupted()) baseline->run(std::min(count, left));
    served = realtime::serve_in_real_time(loop, count, settings.policy, settings.cpu);
  }
  return served;
}

}  // namespace

void run_loop(const LoopCall& call, const Registry& registry, const Monitor& monitor,
              const std::function<void(const LoopOutcome&)>& report) {
  const LoopSettings settings = read_loop_settings(call.words);
  const plan::Plan plan = plan_for_loop(call, registry, settings, monitor);
  std::optional<realtime::Cyclictest> baseline;
  if (call.baseline) baseline.emplace(settings.rate, settings.policy, settings.cpu);
  std::optional<LoopFolder> folder;
  if (!call.out.empty()) folder.emplace(plan, settings, call.out);
  realtime::NoDevice device;
  realtime::SystemClock clock(settings.spin);
  const std::optional<plan::CompiledPlan> compiled = code_for(plan, call.engine, monitor);
  const realtime::LoopOptions options{settings.rate,
                                      settings.deadlines,
                                      settings.overrun,
                                      monitor.interrupt,
                                      compiled ? &*compiled : nullptr,
                                      monitor.observers};
  realtime::Loop loop(plan, options, device, clock, folder ? &folder->recorder() : nullptr);
  LoopOutcome outcome{loop, settings, serve_all(loop, settings, baseline, monitor), {}, std::move(baseline)};
  if (folder) outcome.rows = folder->finish();
  subprocess::processes_stop() = false;  // allows the picture of an interrupted loop to be drawn
  report(outcome);
  if (folder) folder->describe(outcome);
}

}  // namespace stepwire::session
