#include "engine/simulate/profile/profile.hpp"

#include <map>
#include <numeric>

#include "engine/simulate/run/drive.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/solver_of.hpp"
#include "engine/simulate/run/whole_step.hpp"

namespace stepwire::profile {

namespace {

/// Measures the calls of one table of a plan, sample by sample.
class CallTimes {
 public:
  CallTimes(const plan::Plan& plan, const std::vector<plan::KernelCall>& batches);

  /// Measures each call at the present instant of a simulation. Only updates change its state.
  void sample(run::Executor& simulation, const Stopwatch& stopwatch);

  /// Returns how often the calls of a period are made in the whole run.
  using CallCount = std::function<std::int64_t(const plan::Period& period)>;
  /// Adds the time of the table in a whole run to each block's cost in a phase.
  void add_to(std::vector<BlockCost>& blocks, std::size_t phase, const CallCount& calls) const;

 private:
  struct Call {
    plan::KernelCall batch;
    std::vector<std::size_t> blocks;  ///< indices in the plan
    double seconds = 0.0;             ///< time of the call repeated alone, sum of all samples
    std::vector<double> alone{};      ///< the same for each of its blocks
  };

  const plan::Plan& plan_;
  std::vector<Call> calls_;
  double table_ = 0.0;  ///< time of the whole table [s], sum of all samples
  int samples_ = 0;
};

constexpr double aim_of_table = 4e-6, aim_of_call = 4e-7;  // [s]; 200 and 20 clock readings

/// Returns the block at each offset of the memory of blocks.
std::map<std::size_t, std::size_t> blocks_by_memory(const plan::Plan& plan) {
  std::map<std::size_t, std::size_t> blocks;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) blocks[plan.blocks[b].memory] = b;
  return blocks;
}

plan::KernelCall only(const plan::KernelCall& batch, std::size_t index, std::size_t bytes) {
  const std::size_t first = batch.first + index * bytes;
  return {batch.run, first, first + bytes, 1, batch.period};
}

double ratio(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}

CallTimes::CallTimes(const plan::Plan& plan, const std::vector<plan::KernelCall>& batches) : plan_(plan) {
  const auto blocks = blocks_by_memory(plan);
  for (const plan::KernelCall& batch : batches) {
    Call call{batch, {blocks.at(batch.first)}};
    const std::size_t bytes = plan.diagram.blocks[call.blocks.front()].type().bytes;
    for (std::size_t i = 1; i < batch.count; ++i) call.blocks.push_back(blocks.at(batch.first + i * bytes));
    call.alone.assign(batch.count, 0.0);
    calls_.push_back(std::move(call));
  }
}

void CallTimes::sample(run::Executor& simulation, const Stopwatch& stopwatch) {
  ++samples_;
  if (calls_.empty()) return;
  table_ += stopwatch.repeated(aim_of_table, [&] {
    for (const Call& call : calls_) simulation.call(call.batch);
  });
  for (Call& call : calls_) {
    call.seconds += stopwatch.repeated(aim_of_call, [&] { simulation.call(call.batch); });
    if (call.blocks.size() == 1) continue;
    const std::size_t bytes = plan_.diagram.blocks[call.blocks.front()].type().bytes;
    for (std::size_t i = 0; i < call.blocks.size(); ++i) {
      const plan::KernelCall one = only(call.batch, i, bytes);
      call.alone[i] += stopwatch.repeated(aim_of_call, [&] { simulation.call(one); });
    }
  }
}

void CallTimes::add_to(std::vector<BlockCost>& blocks, std::size_t phase, const CallCount& calls) const {
  double apart = 0.0;
  for (const Call& call : calls_) apart += call.seconds;
  for (const Call& call : calls_) {
    const std::int64_t count = calls(plan_.periods[static_cast<std::size_t>(call.batch.period)]);
    const double of_call =
        table_ * ratio(call.seconds, apart) / std::max(1, samples_) * static_cast<double>(count);
    const double alone = std::accumulate(call.alone.begin(), call.alone.end(), 0.0);
    for (std::size_t i = 0; i < call.blocks.size(); ++i) {
      const double share = call.blocks.size() == 1 ? 1.0 : ratio(call.alone[i], alone);
      blocks[call.blocks[i]].phases[phase] += {count, of_call * share};
    }
  }
}

constexpr std::int64_t max_segments = 64;
constexpr int tries = 3;
constexpr double aim = 2e-6;  // [s], 100 times the cost of reading the clock

/// Equations without cost, on numbers of their own.
class NoEquations : public solve::System {
 public:
  explicit NoEquations(std::size_t states) : x_(states), dot_(states) {
    time = &time_;
    x = x_.data();
    dot = dot_.data();
    count = states;
  }
  void evaluate() override {
    ++evaluations;
    follow_time();
  }
  /// Counts the times that differ from the previous one.
  void follow_time() {
    if (std::exchange(last_time_, time_) != time_) ++times;
  }
  void start(double at) {
    time_ = last_time_ = at;
    evaluations = times = 0;
  }
  /// Copies the numbers of a run, since arithmetic with zeros might be faster.
  void take(const double* values, const plan::Layout& layout) {
    std::copy_n(values + layout.states, count, x_.begin());
    std::copy_n(values + layout.derivatives, count, dot_.begin());
  }

  std::int64_t evaluations = 0, times = 0;

 private:
  double time_ = 0.0, last_time_ = 0.0;
  std::vector<double> x_, dot_;
};

/// Pauses a run at a tick and counts the evaluated ticks.
class Segment : public run::RunObserver {
 public:
  explicit Segment(std::int64_t end) : end_(end) {}
  run::Flow before_tick(const run::ObservedRun& run) override {
    if (run.simulation.tick() >= end_) return run::Flow::pause;
    evaluated = run.simulation.tick() + 1;
    return run::Flow::go_on;
  }

  std::int64_t evaluated = 0;

 private:
  std::int64_t end_;
};

/// Measurement of one run.
class Profiler {
 public:
  Profiler(const plan::Plan& plan, const ProfileOptions& options)
      : plan_(plan),
        options_(options),
        stopwatch_(options.clock),
        simulation_(plan),
        rows_(plan),
        stopper_(plan),
        equations_(plan.layout.state_count),
        tables_{CallTimes(plan, plan.timed), CallTimes(plan, plan.outputs), CallTimes(plan, plan.stage),
                CallTimes(plan, plan.derivatives), CallTimes(plan, plan.updates)} {
    if (!plan.diagram.solver.empty() && plan.layout.state_count > 0) solver_ = run::solver_of(plan);
    recording_.resize(recorders().size());
  }

  Profile run() {
    const std::int64_t length = std::max<std::int64_t>(1, (plan_.steps + max_segments) / max_segments);
    while (!ended_ && !(options_.interrupt && *options_.interrupt)) {
      const run::Workspace start = simulation_.workspace();
      sample(start);
      seconds_ += stopwatch_.shortest(
          tries, [&] { go_back_to(start); }, [&] { go_on(start.tick + length); });
    }
    return profile();
  }

 private:
  std::vector<record::Recorder>& recorders() { return rows_.recorders(); }

  void go_back_to(const run::Workspace& moment) {
    simulation_.restore(moment);
    for (record::Recorder& recorder : recorders()) recorder.go_back_to(moment.tick);
  }

  /// Runs to a tick.
  void go_on(std::int64_t tick) {
    Segment segment(tick);
    run::RunObserver* const observer = &segment;
    run::Drive drive(simulation_, recorders());
    drive.judges_steps = false;
    drive.observers = {&observer, 1};
    drive.shows_rows = false;
    ended_ = drive.run() != run::Drive::End::paused;
    evaluated_ = segment.evaluated;
  }

  void sample(const run::Workspace& moment) {
    ++samples_;
    simulation_.evaluate();
    check_ += stopwatch_.repeated(aim, [&] { static_cast<void>(simulation_.is_finite()); });
    if (plan_.diagram.stop_when)
      stop_ += stopwatch_.repeated(aim, [&] { stopper_.stops(simulation_.values()); });
    sample_recording(moment.tick);
    for (CallTimes& table : tables_) table.sample(simulation_, stopwatch_);
    sample_solver();
    simulation_.restore(moment);
  }

  void sample_recording(std::int64_t tick) {
    for (std::size_t i = 0; i < recorders().size(); ++i) {
      record::Recorder& recorder = recorders()[i];
      const std::int64_t own = tick / recorder.every() * recorder.every();
      recording_[i] += stopwatch_.repeated(aim, [&] {
        recorder.go_back_to(own);
        recorder.record(own, simulation_.values());
      });
    }
  }

  void sample_solver() {
    if (!solver_) return;
    equations_.take(simulation_.values(), plan_.layout);
    solving_ += stopwatch_.repeated(
        aim, [&] { solver_->advance(equations_, run::whole_step(plan_, simulation_.tick())); });
  }

  /// Returns the count of the first ticks at which a period is due.
  static std::int64_t due(std::int64_t ticks, const plan::Period& period) {
    return (ticks - period.first + period.ticks - 1) / period.ticks + (period.at_start ? 1 : 0);
  }

  /// Counts the evaluations of the equations in one step of the solver, without the one at its start. Also
  /// counts the distinct times up to and including the next tick.
  void count_evaluations() {
    equations_.start(0.0);
    if (solver_) solver_->advance(equations_, run::whole_step(plan_, 0));
    *equations_.time = plan_.time_of(1);
    equations_.follow_time();
  }

  Profile profile() {
    Profile profile{simulation_.tick(), seconds_, {}, others(), simulation_.loop_costs()};
    for (const diagram::DiagramBlock& block : plan_.diagram.blocks)
      profile.blocks.push_back({block.name, block.type().name});
    count_evaluations();
    const std::int64_t steps = simulation_.tick(), per_step = equations_.evaluations;
    const auto at_times = [&](const plan::Period&) { return 1 + steps * equations_.times; };
    const auto at_ticks = [&](const plan::Period& period) { return due(evaluated_, period); };
    const auto at_steps = [&](const plan::Period& period) { return due(steps, period); };
    const auto at_stages = [&](const plan::Period&) {
      return steps * (per_step + (plan_.updates_continuous ? 1 : 0));
    };
    const auto at_slopes = [&](const plan::Period&) { return steps * (per_step + 1); };
    tables_[0].add_to(profile.blocks, 0, at_times);
    tables_[1].add_to(profile.blocks, 1, at_ticks);
    tables_[2].add_to(profile.blocks, 2, at_stages);
    tables_[3].add_to(profile.blocks, 3, at_slopes);
    tables_[4].add_to(profile.blocks, 4, at_steps);
    return profile;
  }

  RunCost other(const std::string& name, std::int64_t calls, double sampled) const {
    return {name, {calls, sampled / std::max(1, samples_) * static_cast<double>(calls)}};
  }

  std::vector<RunCost> others() const {
    std::vector<RunCost> list;
    if (solver_) list.push_back(other("solver", simulation_.tick(), solving_));
    list.push_back(other("finite check", evaluated_, check_));
    RunCost recording{"recording", {}};
    for (std::size_t i = 0; i < rows_.recorders().size(); ++i)
      recording.cost += other("", due(evaluated_, {rows_.recorders()[i].every()}), recording_[i]).cost;
    list.push_back(recording);
    if (plan_.diagram.stop_when) list.push_back(other("stop condition", evaluated_, stop_));
    return list;
  }

  const plan::Plan& plan_;
  const ProfileOptions& options_;
  Stopwatch stopwatch_;
  run::Executor simulation_;
  record::RunRecording rows_;
  run::StopConditionEvaluator stopper_;
  std::unique_ptr<solve::Solver> solver_;
  NoEquations equations_;
  std::array<CallTimes, phase_count> tables_;
  std::vector<double> recording_;  ///< sum of all samples [s], like the next ones
  double check_ = 0.0, stop_ = 0.0, solving_ = 0.0;
  double seconds_ = 0.0;
  std::int64_t evaluated_ = 0;  ///< ticks
  int samples_ = 0;
  bool ended_ = false;
};

/// Adds a row for each part: a.b.c is added to a and to a.b.
void add_parts(Profile& profile) {
  std::map<std::string, BlockCost> parts;
  for (const BlockCost& block : profile.blocks)
    for (std::size_t dot = block.name.find('.'); dot != std::string::npos;
         dot = block.name.find('.', dot + 1)) {
      const std::string name = block.name.substr(0, dot);
      BlockCost& part = parts.try_emplace(name, BlockCost{name, "part", true}).first->second;
      for (std::size_t phase = 0; phase < phase_count; ++phase) part.phases[phase] += block.phases[phase];
    }
  for (auto& [name, part] : parts) profile.blocks.push_back(std::move(part));
}

}  // namespace

Cost& Cost::operator+=(const Cost& other) {
  calls += other.calls;
  seconds += other.seconds;
  return *this;
}

Cost BlockCost::total() const {
  Cost sum;
  for (const Cost& cost : phases) sum += cost;
  return sum;
}

double Profile::left() const {
  double rest = seconds;
  for (const BlockCost& block : blocks) rest -= block.self();
  for (const RunCost& other : others) rest -= other.cost.seconds;
  return rest;
}

Profile profile_plan(const plan::Plan& plan, const ProfileOptions& options) {
  Profile profile = Profiler(plan, options).run();
  add_parts(profile);
  std::stable_sort(profile.blocks.begin(), profile.blocks.end(), [](const BlockCost& a, const BlockCost& b) {
    return a.total().seconds > b.total().seconds;
  });
  return profile;
}

}  // namespace stepwire::profile
