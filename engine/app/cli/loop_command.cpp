#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "engine/app/cli/commands.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/loop_report.hpp"
#include "engine/app/cli/report.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/realtime/row_writer.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/run/memory.hpp"
#include "engine/view/render/figure_file.hpp"

namespace stepwire {

namespace {

constexpr double seconds_in_ring = 4.0;  // that the writer may be late
constexpr double fewest_numbers = 1 << 16, most_numbers = 1 << 23;
constexpr double slice = 1.0;  // [s] of each in turn with a baseline

/// A loop runs the file once with its own values, so its sweep, figures and claims are left alone.
Plan plan_for_loop(const LoopCommand& command, const Registry& registry, const LoopSettings& settings) {
  Loader loader(registry, command.options.limits);
  Plan plan = make_plan(loader.load_point(command.file, command.options.settings));
  require_solver_memory(plan);
  ticks_per_period(plan.diagram, settings.rate);
  require_fit_for_loop(plan);
  return plan;
}

std::size_t ring_size(const Plan& plan, const LoopSettings& settings) {
  const auto of_tick = static_cast<double>(LoopRecorder::numbers_per_tick(plan));
  const auto ticks = static_cast<double>(ticks_per_period(plan.diagram, settings.rate));
  const double wanted = seconds_in_ring * settings.rate * ticks * of_tick;
  return static_cast<std::size_t>(
      std::max(std::clamp(wanted, fewest_numbers, most_numbers), 16.0 * ticks * of_tick));
}

/// The way of rows from the loop into the files of a folder.
class RowsToFolder {
 public:
  RowsToFolder(const Plan& plan, const LoopSettings& settings, const std::string& folder)
      : ring_(ring_size(plan, settings)), recorder_(plan, ring_), writer_(ring_, folder, loop_files(plan)) {}

  LoopRecorder& recorder() { return recorder_; }
  LoopRows finish() {
    writer_.finish();
    return {writer_.rows(), recorder_.lost(), writer_.lost(), writer_.trouble()};
  }

 private:
  RowRing ring_;
  LoopRecorder recorder_;
  RowWriter writer_;
};

/// Compiled code, where that is asked for and can be; with `auto`, too, since a loop has no time for it
/// later.
std::optional<CompiledPlan> code_for(const Plan& plan, Engine engine) {
  if (engine == Engine::interpreted) return std::nullopt;
  GeneratedCode source;
  std::optional<CompiledPlan> code = source.compile(plan, {}, {});
  const std::string problem = source.take_problem();
  if (!problem.empty()) complain("interpreted, since {}\n", problem);
  return code;
}

/// Serves all deadlines; in slices, with one of the baseline before each, where there is one.
Served serve_all(Loop& loop, const LoopSettings& settings, std::optional<Cyclictest>& baseline) {
  const auto count =
      baseline ? std::max<std::int64_t>(1, std::llround(slice * settings.rate)) : settings.deadlines;
  Served served;
  while (!loop.ended()) {
    const std::int64_t left = settings.deadlines - loop.deadlines().index();
    if (baseline && !interrupted()) baseline->run(std::min(count, left));
    served = serve_in_real_time(loop, count, settings.policy, settings.cpu);
  }
  return served;
}

/// Everything that a loop leaves behind in its folder besides the rows, which are there.
void write_results(const std::string& folder, const LoopOutcome& outcome) {
  write_file(folder + "/loop.json", loop_json(outcome).text() + "\n");
  write_figure(folder, "loop", loop_figure(outcome), "loop-figure");
  say("  written to {}\n", folder);
}

ExitCode code_of(const LoopOutcome& outcome) {
  switch (outcome.loop.end()) {
    case Loop::End::stopped:
      return ExitCode::fails;
    case Loop::End::interrupted:
      return ExitCode::interrupted;
    case Loop::End::fault:
      return ExitCode::wrong;
    case Loop::End::done:
      break;
  }
  return ExitCode::done;
}

/// What went wrong, on the standard error.
ExitCode print_troubles(const LoopOutcome& outcome) {
  ExitCode code = code_of(outcome);
  if (const auto fault = outcome.loop.simulation().fault()) complain("{}\n", fault->fault.text());
  if (!outcome.rows || outcome.rows->trouble.empty()) return code;
  complain("{}; {} rows are lost\n", outcome.rows->trouble, outcome.rows->lost_to_disk);
  return worst(code, ExitCode::surroundings);
}

}  // namespace

ExitCode run_loop(const LoopCommand& command, const Registry& registry) {
  const LoopSettings settings = read_loop_settings(command.words);
  const Plan plan = plan_for_loop(command, registry, settings);
  std::optional<Cyclictest> baseline;
  if (command.baseline) baseline.emplace(settings.rate, settings.policy, settings.cpu);
  std::optional<OwnedFolder> folder;
  std::unique_ptr<RowsToFolder> recording;
  if (!command.out.empty()) {
    folder.emplace(command.out, [&] { return files_read(plan); });
    write_replay(command.out, plan);  // of the data files as they are now
    recording = std::make_unique<RowsToFolder>(plan, settings, command.out);
  }
  NoDevice device;
  SystemClock clock(settings.spin);
  const std::optional<CompiledPlan> compiled = code_for(plan, command.engine);
  const LoopOptions options{settings.rate, settings.deadlines, settings.overrun, &interrupted(),
                            compiled ? &*compiled : nullptr};
  const EndDelay delay(EndDelay::Signals::all);
  Loop loop(plan, options, device, clock, recording ? &recording->recorder() : nullptr);
  LoopOutcome outcome{loop, settings, serve_all(loop, settings, baseline), {}, std::move(baseline)};
  if (recording) outcome.rows = recording->finish();
  processes_stop() = false;  // of an interrupted loop there is a picture, too
  put_text(loop_text(outcome));
  const ExitCode code = print_troubles(outcome);
  if (recording) write_results(command.out, outcome);
  return code;
}

}  // namespace stepwire
