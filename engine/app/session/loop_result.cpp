// Fields of the result of a real-time loop. Times are in ns unless the name of the field has another unit.
#include "engine/app/session/loop_run.hpp"
#include "engine/app/session/run_result.hpp"
#include "engine/app/session/version.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/simulate/realtime/machine.hpp"

namespace stepwire::session {

using result::path;
using result::Record;

/// Distribution of measured times.
struct LoopTimes {
  const realtime::Histogram* of;
};

/// Longest times in intervals of a loop.
struct LoopWorst {
  double stretch;
  const std::vector<realtime::Measurements::Worst>* of;
};

/// Cost of the blocks of a type.
struct TypeCost : realtime::GroupCost {};

/// Cost of all block types.
struct TypeCosts {
  std::vector<TypeCost> types;
};

/// Thread of a loop.
struct LoopThreadUse : realtime::ThreadCounts {
  const LoopOutcome* outcome;
};

/// Rows of a loop.
struct RowCounts : LoopRows {};

/// Measurement by cyclictest.
struct BaselineTimes : realtime::Cyclictest {};

/// Machine of a loop.
struct LoopMachine : realtime::Machine {};

/// Deadlines of a loop.
struct DeadlineCounts {
  std::int64_t planned;
  const realtime::Deadlines* of;
};

/// Diagram of a loop.
struct LoopDiagram {
  const run::Executor* simulation;
};

namespace {

/// Returns a function that gives a quantile of measured times.
template <class Times, class Get>
auto quantile(Get times, double share) {
  return [times, share](const Times& of) { return times(of).quantile(share); };
}

const realtime::Histogram& histogram_of(const LoopTimes& times) {
  return *times.of;
}

/// Returns the nonempty bins as [[begin, count], ...].
std::vector<std::vector<std::int64_t>> bins_of(const LoopTimes& times) {
  std::vector<std::vector<std::int64_t>> bins;
  for (std::size_t bin = 0; bin < realtime::Histogram::bins(); ++bin)
    if (times.of->count_in(bin) > 0)
      bins.push_back({static_cast<std::int64_t>(realtime::Histogram::begin_of(bin)),
                      static_cast<std::int64_t>(times.of->count_in(bin))});
  return bins;
}

}  // namespace

static void declare(Record<LoopTimes>& is) {
  using realtime::Histogram;
  is.named("LoopTimes", "Distribution of measured times.");
  is.field("count", path(histogram_of, &Histogram::count), "number of times");
  is.field("min", path(histogram_of, &Histogram::min), "shortest", "ns");
  is.field("mean", path(histogram_of, &Histogram::mean), "mean", "ns");
  is.field("p50", quantile<LoopTimes>(histogram_of, 0.5), "median", "ns");
  is.field("p99", quantile<LoopTimes>(histogram_of, 0.99), "not exceeded by 99 %", "ns");
  is.field("p99.9", quantile<LoopTimes>(histogram_of, 0.999), "not exceeded by 99.9 %", "ns");
  is.field("max", path(histogram_of, &Histogram::max), "longest", "ns");
  is.field("histogram", bins_of, "begin [ns] and count of each bin that is not empty");
}

namespace {

/// Returns a function that lists one of the longest times of all intervals.
auto worst(std::int64_t realtime::Measurements::Worst::*time) {
  return [time](const LoopWorst& of) {
    std::vector<std::int64_t> times;
    for (const realtime::Measurements::Worst& one : *of.of) times.push_back(one.*time);
    return times;
  };
}

}  // namespace

static void declare(Record<LoopWorst>& is) {
  using Worst = realtime::Measurements::Worst;
  is.named("LoopWorst", "Longest times in equal intervals of the run.");
  is.field("stretch_s", &LoopWorst::stretch, "length of an interval", "s");
  is.field("wake_up", worst(&Worst::wake_up), "longest delay of a wake-up", "ns");
  is.field("response", worst(&Worst::response), "longest response", "ns");
  is.field("step", worst(&Worst::step), "longest step", "ns");
}

static void declare(Record<TypeCost>& is) {
  is.named("TypeCost", "Cost of the blocks of a type.");
  is.field("type", &TypeCost::type, "type");
  is.field("blocks", &TypeCost::blocks, "number of blocks");
  is.field(
      "mean", [](const TypeCost& of) { return of.samples > 0 ? std::optional(of.mean) : std::nullopt; },
      "mean time of a tick; null without samples", "ns");
  is.field("samples", &TypeCost::samples, "number of samples");
}

static void declare(Record<TypeCosts>& is) {
  is.named("TypeCosts", "Sampled cost of the block types.");
  is.field(
      "how",
      [](const TypeCosts&) {
        return "one stretch of calls of a tick at each wake-up, chosen pseudo-randomly";
      },
      "method");
  is.field("types", &TypeCosts::types, "types");
}

namespace {

const LoopSettings& thread_settings(const LoopThreadUse& use) {
  return use.outcome->settings;
}

}  // namespace

static void declare(Record<LoopThreadUse>& is) {
  using Use = LoopThreadUse;
  is.named("LoopThread", "Thread of the loop.");
  is.field("policy", path(&Use::outcome, &LoopOutcome::served, &realtime::Served::policy),
           "effective policy");
  is.field("cpu", path(thread_settings, &LoopSettings::cpu), "processor; null if the thread is not bound");
  is.field("spin", path(thread_settings, &LoopSettings::spin), "time awake before a deadline", "ns");
  is.field("refused", path(&Use::outcome, &LoopOutcome::served, &realtime::Served::refused),
           "requests that the system refused");
  is.field("minor_faults", &Use::minor_faults, "pages that were mapped");
  is.field("major_faults", &Use::major_faults, "pages that were read from a disk");
  is.field("allocations", &Use::allocations, "memory requests; null if not counted");
  is.field("voluntary_switches", &Use::voluntary, "switches while the thread waited");
  is.field("involuntary_switches", &Use::involuntary, "switches to another thread");
}

static void declare(Record<RowCounts>& is) {
  is.named("LoopRows", "Recorded rows.");
  is.field("written", &RowCounts::written, "written rows");
  is.field("lost_to_ring", &RowCounts::lost_to_ring, "rows that a slow writer lost");
  is.field("lost_to_disk", &RowCounts::lost_to_disk, "rows that the disk refused");
}

static void declare(Record<BaselineTimes>& is) {
  using Times = realtime::CyclictestHistogram;
  const auto times = path(&BaselineTimes::histogram);
  is.named("Cyclictest", "Wake-ups by cyclictest at the rate and policy of the loop.");
  is.field("command", &BaselineTimes::command, "command");
  is.field("count", path(times, &Times::count), "number of wake-ups");
  is.field("p50_us", quantile<BaselineTimes>(times, 0.5), "median", "us");
  is.field("p99_us", quantile<BaselineTimes>(times, 0.99), "not exceeded by 99 %", "us");
  is.field("p99.9_us", quantile<BaselineTimes>(times, 0.999), "not exceeded by 99.9 %", "us");
  is.field("max_us", path(times, &Times::max), "longest", "us");
}

namespace {

/// Returns a function of a text member that is std::nullopt where the text is empty.
auto text_if_any(std::string realtime::Machine::*text) {
  return [text](const LoopMachine& of) { return result::text_if_any(of.*text); };
}

}  // namespace

static void declare(Record<LoopMachine>& is) {
  is.named("Machine", "Machine of the loop. Unknown texts are null.");
  is.field("processor", &LoopMachine::processor, "processor");
  is.field("processors", &LoopMachine::processors, "number of processors");
  is.field("virtual", &LoopMachine::virtual_machine, "true for a virtual machine");
  is.field("kernel", &LoopMachine::kernel, "kernel");
  is.field("kernel_command_line", &LoopMachine::kernel_line,
           "words of the boot command line that matter for timing");
  is.field("governor", text_if_any(&LoopMachine::governor), "frequency governor");
  is.field("clock_source", text_if_any(&LoopMachine::clock_source), "clock source");
  is.field("isolated", text_if_any(&LoopMachine::isolated), "processors that the scheduler does not use");
}

static void declare(Record<DeadlineCounts>& is) {
  using realtime::Deadlines;
  is.named("Deadlines", "Counts of deadlines.");
  is.field("planned", &DeadlineCounts::planned, "planned deadlines");
  is.field("passed", path(&DeadlineCounts::of, &Deadlines::index), "deadlines that have passed");
  is.field("missed", path(&DeadlineCounts::of, &Deadlines::missed), "late and dropped ones");
  is.field("late", path(&DeadlineCounts::of, &Deadlines::late), "late ones");
  is.field("dropped", path(&DeadlineCounts::of, &Deadlines::dropped), "dropped ones");
  is.field("longest_row", path(&DeadlineCounts::of, &Deadlines::longest_row), "longest row of missed ones");
}

namespace {

const diagram::Diagram& loop_diagram(const LoopDiagram& of) {
  return of.simulation->plan().diagram;
}

}  // namespace

static void declare(Record<LoopDiagram>& is) {
  is.named("LoopDiagram", "Diagram of the loop.");
  is.field("file", path(loop_diagram, &diagram::Diagram::file), "file");
  is.field("title", path(loop_diagram, &diagram::Diagram::title), "title");
  is.field(
      "hash", [](const LoopDiagram& of) { return diagram::diagram_hash(loop_diagram(of)); }, "hash");
  is.field(
      "blocks", [](const LoopDiagram& of) { return loop_diagram(of).blocks.size(); }, "number of blocks");
  is.field(
      "states",
      [](const LoopDiagram& of) {
        const auto& layout = of.simulation->plan().layout;
        return layout.state_count + layout.discrete_count;
      },
      "number of states");
  is.field("step_s", path(loop_diagram, &diagram::Diagram::step), "step", "s");
  is.field(
        "engine",
        [](const LoopDiagram& of) { return of.simulation->compiled() ? "compiled" : "interpreted"; },
        "engine")
      .choices = {"compiled", "interpreted"};
}

namespace {

const realtime::Loop& loop_of(const LoopOutcome& of) {
  return of.loop;
}

const LoopSettings& settings_of_loop(const LoopOutcome& of) {
  return of.settings;
}

std::vector<std::string> loop_faults(const LoopOutcome& of) {
  std::vector<std::string> faults;
  if (const auto fault = of.loop.simulation().fault()) faults.push_back(fault->fault.text());
  if (!of.device_fault.empty()) faults.push_back(of.device_fault);
  return faults;
}

std::vector<AlgebraicLoop> algebraic_loops_of(const LoopOutcome& of) {
  return result::as<AlgebraicLoop>(of.loop.simulation().loop_costs());
}

/// Returns a function that gives one of the measured distributions.
auto times(const realtime::Histogram& (realtime::Measurements::*of)() const) {
  return [of](const LoopOutcome& outcome) { return LoopTimes{&(outcome.loop.measurements().*of)()}; };
}

LoopWorst worst_of(const LoopOutcome& of) {
  return {of.settings.duration / static_cast<double>(realtime::Measurements::worst_count),
          &of.loop.measurements().worst()};
}

std::optional<RowCounts> rows_of(const LoopOutcome& of) {
  return of.rows ? std::optional(RowCounts{*of.rows}) : std::nullopt;
}

std::optional<BaselineTimes> baseline_of(const LoopOutcome& of) {
  return of.baseline ? std::optional(BaselineTimes{*of.baseline}) : std::nullopt;
}

void add_times(Record<LoopOutcome>& is) {
  using realtime::Measurements;
  is.field("algebraic_loops", algebraic_loops_of, "costs of algebraic loops");
  is.field(
      "resolution", [](const LoopOutcome&) { return realtime::Histogram::resolution; },
      "width of a bin as a share of its times");
  is.field("wake_up", times(&Measurements::wake_up), "delay of the wake-ups");
  is.field("response", times(&Measurements::response), "time until outputs are written");
  is.field("step", times(&Measurements::step), "time of a step");
  is.field("device_read", times(&Measurements::reading), "time in which the devices were read");
  is.field("device_write", times(&Measurements::writing), "time in which the devices were written");
}

void add_measurements(Record<LoopOutcome>& is) {
  add_times(is);
  is.field("devices", &LoopOutcome::device_lines,
           "counts of the devices, and outputs that limits have changed");
  is.field("worst", worst_of, "longest times over the run");
  is.field(
      "block_types",
      [](const LoopOutcome& of) { return TypeCosts{result::as<TypeCost>(of.loop.group_costs())}; },
      "cost of the block types");
  is.field(
      "thread",
      [](const LoopOutcome& of) {
        return LoopThreadUse{of.loop.counts(), &of};
      },
      "thread");
  is.field("rows", rows_of, "recorded rows; null if none are recorded");
  is.field("cyclictest", baseline_of, "measurement beside the loop; null without --baseline");
  is.field(
      "machine", [](const LoopOutcome&) { return LoopMachine{realtime::Machine::here()}; }, "machine");
}

}  // namespace

void declare(Record<LoopOutcome>& is) {
  is.named("LoopResult", "The result of a real-time loop: loop.json.");
  is.field(
      "diagram", [](const LoopOutcome& of) { return LoopDiagram{&of.loop.simulation()}; }, "diagram");
  is.field(
      "end", [](const LoopOutcome& of) { return end_word(of.loop.end()); }, "reason of the end");
  is.field("faults", loop_faults, "fault that ended the loop");
  is.field("rate_hz", path(settings_of_loop, &LoopSettings::rate), "wake-ups in a second", "Hz");
  is.field("duration_s", path(settings_of_loop, &LoopSettings::duration), "planned duration", "s");
  is.field("steps", path(loop_of, &realtime::Loop::steps), "steps");
  is.field("ticks", path(loop_of, &realtime::Loop::simulation, &run::Executor::tick), "ticks");
  is.field(
      "deadlines",
      [](const LoopOutcome& of) {
        return DeadlineCounts{of.settings.deadlines, &of.loop.deadlines()};
      },
      "deadlines");
  add_measurements(is);
  is.field(
      "version", [](const LoopOutcome&) { return program_version(); }, "version of the program");
  is.field(
      "compiler", [](const LoopOutcome&) { return compiler_version(); }, "compiler of the program");
}

}  // namespace stepwire::session
