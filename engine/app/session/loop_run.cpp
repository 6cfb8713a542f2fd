#include "engine/app/session/loop_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "engine/base/io/file.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/devices/wired_device.hpp"
#include "engine/simulate/realtime/loop_recorder.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/memory.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/plot_tools.hpp"
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

constexpr double bins_per_decade = 20.0;

double edge(std::size_t index) {
  return std::pow(10.0, static_cast<double>(index) / bins_per_decade);
}

/// Histogram with 20 logarithmic bins per decade. The bins of the measured histograms are too narrow for a
/// picture.
class Coarse {
 public:
  Coarse(std::string name, const realtime::Histogram& times) : name(std::move(name)) {
    for (std::size_t bin = 0; bin + 1 < realtime::Histogram::bins(); ++bin)
      add(0.5 * static_cast<double>(realtime::Histogram::begin_of(bin) +
                                    realtime::Histogram::begin_of(bin + 1)),
          times.count_in(bin));
  }
  Coarse(std::string name, const realtime::CyclictestHistogram& times) : name(std::move(name)) {
    for (std::size_t us = 0; us < times.counts().size(); ++us)
      add(1e3 * (static_cast<double>(us) + 0.5), times.counts()[us]);
  }

  double operator[](std::size_t index) const { return index < counts_.size() ? counts_[index] : 0.0; }
  std::size_t begin() const {
    std::size_t index = 0;
    while (index < counts_.size() && counts_[index] == 0.0) ++index;
    return index;
  }
  std::size_t end() const { return counts_.size(); }
  double most() const { return counts_.empty() ? 0.0 : *std::max_element(counts_.begin(), counts_.end()); }

  std::string name;

 private:
  void add(double time, std::int64_t count) {
    if (count == 0) return;
    const auto index = static_cast<std::size_t>(bins_per_decade * std::log10(std::max(1.0, time)));
    counts_.resize(std::max(counts_.size(), index + 1));
    counts_[index] += static_cast<double>(count);
  }

  std::vector<double> counts_;
};

/// Histograms, with the bounds of the axes.
struct Counted {
  std::vector<Coarse> all;
  std::size_t first = std::numeric_limits<std::size_t>::max(), end = 0;
  double most = 1.0;
};

Counted counted(const LoopOutcome& outcome) {
  const realtime::Measurements& measured = outcome.loop.measurements();
  Counted counted{{{"wake-up latency", measured.wake_up()},
                   {"response", measured.response()},
                   {"cost of a step", measured.step()}}};
  if (outcome.baseline) counted.all.emplace_back("cyclictest", outcome.baseline->histogram());
  for (const Coarse& coarse : counted.all) {
    counted.first = std::min(counted.first, coarse.begin());
    counted.end = std::max(counted.end, coarse.end());
    counted.most = std::max(counted.most, coarse.most());
  }
  counted.first -= std::min<std::size_t>(counted.first, 1);
  return counted;
}
constexpr double below_axis = 0.1, axis = 0.7;

/// Returns a histogram as a step curve. Empty bins are below the axis.
plot::NumberCurve staircase(const Counted& counted, const Coarse& coarse) {
  plot::NumberCurve curve{{}, {}, coarse.name};
  for (std::size_t bin = counted.first; bin <= counted.end; ++bin)
    for (const std::size_t at : {bin, bin + 1}) {
      curve.x.push_back(1e-3 * edge(at));
      curve.y.push_back(std::max(below_axis, coarse[bin]));
    }
  return curve;
}

void draw_counts(const Counted& counted, plot::PlotBuilder& plot) {
  plot::name_axis(plot.spec.x, "time", "µs");
  plot::name_axis(plot.spec.y, "deadlines", "");
  std::vector<plot::NumberCurve> curves;
  for (const Coarse& coarse : counted.all) curves.push_back(staircase(counted, coarse));
  plot::draw_curves(curves, plot);
  plot.plane(0.05);
}

double stretch_of(const LoopOutcome& outcome) {
  return outcome.settings.duration / static_cast<double>(realtime::Measurements::worst_count);
}

/// Returns the longest times in each interval of the run.
std::vector<plot::NumberCurve> worst_over_time(const LoopOutcome& outcome) {
  std::vector<plot::NumberCurve> curves{
      {{}, {}, "wake-up latency"}, {{}, {}, "response"}, {{}, {}, "cost of a step"}};
  const auto& all = outcome.loop.measurements().worst();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].wake_up == 0 && all[i].response == 0) continue;  // no deadline, or not reached
    const auto add = [&](plot::NumberCurve& curve, std::int64_t longest) {
      curve.x.push_back(stretch_of(outcome) * (static_cast<double>(i) + 0.5));
      curve.y.push_back(1e-3 * static_cast<double>(longest));
    };
    add(curves[0], all[i].wake_up);
    add(curves[1], all[i].response);
    add(curves[2], all[i].step);
  }
  return curves;
}

void draw_worst(const LoopOutcome& outcome, plot::PlotBuilder& plot) {
  plot::name_axis(plot.spec.x, "time", "s");
  plot::name_axis(plot.spec.y, fmt::format("longest in {:.4g} s", stretch_of(outcome)), "µs");
  plot::draw_curves(worst_over_time(outcome), plot);
  plot::set_line_ranges(plot);
}

/// Returns a figure with two panels: the histograms of wake-up latency, response and step cost, and their
/// longest times over the run.
plot::FigureSpec loop_figure(const LoopOutcome& outcome) {
  const Counted all = counted(outcome);
  const diagram::Diagram& diagram = outcome.loop.simulation().plan().diagram;
  plot::FigureBuilder figure(
      {.title = fmt::format("{}: {:.6g} Hz, {}", diagram.title.empty() ? diagram.file : diagram.title,
                            outcome.settings.rate, outcome.served.policy),
       .columns = 2},
      2);
  draw_counts(all,
              figure.add({.x = {.range = {{1e-3 * edge(all.first), 1e-3 * edge(all.end + 1)}}, .log = true},
                          .y = {.range = {{axis, 2.0 * all.most}}, .log = true}}));
  draw_worst(outcome, figure.add({.x = {.range = {{0.0, outcome.settings.duration}}}, .y = {.log = true}}));
  return figure.finished();
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
    io::write_file(path_ + "/loop.json", result::json_of(outcome).text() + "\n");
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

/// Opens the devices of a loop; nullptr without any.
std::unique_ptr<devices::LoopRig> rig_of(const LoopCall& call, const plan::Plan& plan,
                                         const LoopSettings& settings, const Monitor& monitor) {
  if (call.plant) return std::make_unique<devices::HostedPlant>(*call.plant, plan, 1.0 / settings.rate);
  if (call.io.empty()) return nullptr;
  auto rig =
      std::make_unique<devices::Rig>(call.io, plan, 1.0 / settings.rate,
                                     std::min(99, settings.policy.fifo.value_or(-1) + 1), monitor.interrupt);
  if (monitor.diagnostic)
    for (const std::string& note : rig->notes()) monitor.diagnostic(note);
  return rig;
}

void add_devices(devices::LoopRig& rig, LoopOutcome& outcome) {
  outcome.has_devices = true;
  outcome.device_lines = rig.finish();
  outcome.device_fault = rig.trouble();
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
  realtime::NoDevice none;
  realtime::SystemClock timer(settings.spin);
  const std::optional<plan::CompiledPlan> compiled = code_for(plan, call.engine, monitor);
  const realtime::LoopOptions options{settings.rate,
                                      settings.deadlines,
                                      settings.overrun,
                                      monitor.interrupt,
                                      compiled ? &*compiled : nullptr,
                                      monitor.observers};
  const std::unique_ptr<devices::LoopRig> rig = rig_of(call, plan, settings, monitor);
  realtime::Loop loop(plan, options, rig ? rig->device() : none, rig && rig->clock() ? *rig->clock() : timer,
                      folder ? &folder->recorder() : nullptr);
  LoopOutcome outcome{loop, settings, serve_all(loop, settings, baseline, monitor), {}, std::move(baseline)};
  if (rig) add_devices(*rig, outcome);
  if (folder) outcome.rows = folder->finish();
  subprocess::processes_stop() = false;  // allows the picture of an interrupted loop to be drawn
  report(outcome);
  if (folder) folder->describe(outcome);
}

std::string end_word(realtime::Loop::End end) {
  switch (end) {
    case realtime::Loop::End::stopped:
      return "stopped after too many misses in a row";
    case realtime::Loop::End::interrupted:
      return "interrupted";
    case realtime::Loop::End::fault:
      return "ended by the diagram";
    case realtime::Loop::End::device:
      return "ended by a device";
    case realtime::Loop::End::done:
      break;
  }
  return "done";
}

}  // namespace stepwire::session
