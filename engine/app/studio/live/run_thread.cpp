#include "engine/app/studio/live/run_thread.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

#include "engine/model/diagram/variation.hpp"

namespace stepwire::live {

namespace {

/// Returns the parameters of the diagram that can be set without changing its structure.
std::vector<std::string> names_to_set(const diagram::Diagram& diagram) {
  std::vector<std::string> names;
  for (const diagram::DiagramParameter& parameter : diagram.parameters)
    if (std::holds_alternative<double>(parameter.value.content) &&
        !diagram::Variation(diagram, {parameter.name}).structural())
      names.push_back(parameter.name);
  return names;
}

/// Returns the first checkpoint after a tick.
auto behind(const std::vector<run::Workspace>& kept, std::int64_t tick) {
  return std::ranges::upper_bound(kept, tick, {}, &run::Workspace::tick);
}

constexpr std::int64_t most_samples = std::int64_t{32} << 20;  // 256 MB

class PastSampling : public run::RunObserver {
 public:
  PastSampling(const EventLog& log, std::span<const RowGathering::Incomplete> columns)
      : log_(log), columns_(columns), samples(columns.size()) {
    for (const auto& one : columns) end_ = std::max(end_, one.first_tick);
  }

  run::Flow before_tick(const run::ObservedRun& run) override {
    const std::int64_t tick = run.simulation.tick();
    if (tick >= end_) return run::Flow::stop;
    log_.each(tick, tick + 1, [&](const LiveEvent& event) { apply(event, run.simulation); });
    return run::Flow::go_on;
  }
  void evaluated(const run::ObservedRun& run) override {
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (run.simulation.tick() < columns_[i].first_tick)
        samples[i].push_back(columns_[i].column(run.simulation.values()));
  }
  bool is_whole() const {
    return std::ranges::equal(columns_, samples, [](const auto& column, const std::vector<double>& past) {
      return column.first_tick == static_cast<std::int64_t>(past.size());
    });
  }

 private:
  const EventLog& log_;
  std::span<const RowGathering::Incomplete> columns_;
  std::int64_t end_ = 0;

 public:
  std::vector<std::vector<double>> samples;
};

/// Repeats a run with the events of its log, for samples that columns lack; the bits are the same. Returns a
/// list of samples for each column, from tick 0 up to its first stored tick. The list is empty after an
/// interruption, if the run ends early, and beyond 256 MB.
std::vector<std::vector<double>> past_of(const plan::Plan& plan, const EventLog& log,
                                         std::span<const RowGathering::Incomplete> columns,
                                         const std::atomic<bool>& interrupt) {
  std::int64_t count = 0;
  for (const auto& one : columns) count += one.first_tick;
  if (count > most_samples) return {};
  run::Executor simulation(plan);
  log.each(before_start, 0, [&](const LiveEvent& event) { apply(event, simulation); });
  simulation.reset();
  PastSampling sampling(log, columns);
  run::RunObserver* const observer = &sampling;
  std::vector<record::Recorder> nothing_recorded;
  run::Drive drive(simulation, nothing_recorded);
  drive.observers = {&observer, 1};
  drive.shows_rows = false;
  drive.interrupt = &interrupt;
  drive.run();
  return sampling.is_whole() ? std::move(sampling.samples) : std::vector<std::vector<double>>{};
}

constexpr double between_moments = 0.5;   // [s] simulated time between checkpoints
constexpr double ahead = 1e-3;            // [s] by which a tick may be early; no sleep is shorter
constexpr double between_flushes = 4e-3;  // [s]

std::int64_t ticks_between_moments(const plan::Plan& plan) {
  return std::max<std::int64_t>(1, std::llround(between_moments / plan.diagram.step));
}

}  // namespace

LiveCode::LiveCode(const plan::Plan& plan, plan::CodeSource* source) : plan_(plan), source_(source) {
  if (!source) return;
  const std::vector<std::string> names = names_to_set(plan.diagram);
  names_.insert(names.begin(), names.end());
  variable_ = plan::variable_blocks(plan, diagram::Variation(plan.diagram, names));
  compile();
}

void LiveCode::compile() {
  code_.reset();  // ends a pending compilation
  code_ = std::make_unique<run::TieredExecution>(run::ExecutionMode::automatic, source_,
                                                 std::vector<run::PlanOfRuns>{{&plan_, {variable_, {}}}},
                                                 static_cast<double>(plan_.steps));
}

void LiveCode::look(run::Executor& run, std::int64_t ticks) {
  if (!code_) return;
  code_->done(ticks);
  const plan::CompiledPlan* code = run.compiled() ? nullptr : code_->code(0);
  if (!code) return;
  run.use(*code);
  if (run.compiled()) return;
  run.widen(variable_);  // the run has another value for a constant of the code
  compile();
}

void LiveCode::was_set(const std::string& name) {
  if (!source_ || !names_.insert(name).second) return;
  plan::unite(variable_, plan_, plan::variable_blocks(plan_, diagram::Variation(plan_.diagram, {name})));
}

void Moments::keep(const run::Workspace& workspace) {
  next_ = (workspace.tick / every_ + 1) * every_;
  kept_.push_back(workspace);
  const std::size_t each = sizeof(run::Workspace) + workspace.values.size() * sizeof(double);
  if (kept_.size() > std::max<std::size_t>(8, bytes_ / each)) thin();
}

/// Removes the checkpoint with the smallest gap between its neighbours relative to its age. The spacing thus
/// grows in proportion to the age. The first and the newest checkpoint are never removed. Cost: one pass.
void Moments::thin() {
  std::size_t least = 1;
  double best = 0.0;
  const auto newest = static_cast<double>(kept_.back().tick);
  for (std::size_t i = 1; i + 1 < kept_.size(); ++i) {
    const auto gap = static_cast<double>(kept_[i + 1].tick - kept_[i - 1].tick);
    const double age = newest - static_cast<double>(kept_[i].tick) + 1.0;
    if (i > 1 && age / gap <= best) continue;
    best = age / gap;
    least = i;
  }
  kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(least));
}

const run::Workspace* Moments::before(std::int64_t tick) const {
  const auto found = behind(kept_, tick);
  return found == kept_.begin() ? nullptr : &*(found - 1);
}

void Moments::cut(std::int64_t tick) {
  kept_.erase(behind(kept_, tick), kept_.end());
  next_ = kept_.empty() ? 0 : (kept_.back().tick / every_ + 1) * every_;
}

RunThread::RunThread(const plan::Plan& plan, const SignalList& signals, Options options)
    : RunControl(plan, signals, options.store, options.run, std::move(options.changed)),
      code_(plan, options.code),
      moments_(ticks_between_moments(plan)) {
  thread_ = std::thread([this] { main(); });
}

RunThread::~RunThread() {
  quits_ = true;
  commands_.push([] {});
  thread_.join();
  past_interrupt_ = true;
  if (past_.joinable()) past_.join();
}

void RunThread::main() {
  while (!quits_) {
    try {
      begin_life();
      live();
      hand_over();
    } catch (const std::exception& error) {
      fault_ = error.what();
    }
    if (!quits_ && !back_to_) rest();
  }
}

/// Creates a run at its start, or at the checkpoint before the tick to return to.
void RunThread::begin_life() {
  life_.reset();
  life_ = std::make_unique<Life>(plan_);
  ended_ = is_paced_ = false;
  fault_.clear();
  if (back_to_) ++lives_;
  const std::int64_t to = std::exchange(back_to_, std::nullopt).value_or(before_start);
  if (to == before_start)
    start_anew();
  else
    go_back(to);
}

void RunThread::live() {
  run::RunObserver* const self = this;
  life_->drive.observers = {&self, 1};
  life_->drive.shows_rows = false;
  life_->drive.look = [this] {
    code_.look(life_->run, run::Drive::ticks_between_looks);
    tell();
  };
  life_->drive.run();
  if (const auto fault = life_->run.fault()) fault_ = fault->fault.text();
}

/// Waits, after the end of the run, for a restart or seek.
void RunThread::rest() {
  ended_ = true;
  plays_ = false;
  while (!quits_ && !back_to_) {
    tell();
    if (arrived_) std::exchange(arrived_, nullptr)->set_value();
    commands_.wait();
    commands_.run_all();
  }
  tell();
}

run::Flow RunThread::before_tick(const run::ObservedRun& run) {
  const std::int64_t tick = run.simulation.tick();
  if (quits_) return run::Flow::stop;
  if (tick <= known_) do_events(tick);
  if (tick >= known_) {
    if (!wait_for_turn()) return run::Flow::stop;
    for (LiveEvent& event : inputs_.take(seconds_now(), tick)) add_event(std::move(event));
  }
  if (moments_.due(tick)) moments_.keep(run.simulation.workspace());
  return run::Flow::go_on;
}

/// Executes commands until the next tick may be computed; false if this run ends.
bool RunThread::wait_for_turn() {
  if (next_tick() == 0) return true;  // tick 0 is computed even while paused
  while (!quits_) {
    commands_.run_all();
    if (quits_ || back_to_) return false;
    if (next_tick() <= goal_) return true;
    arrive();
    if (!plays_)
      wait_until({});
    else if (is_due())
      return true;
  }
  return false;
}

/// Publishes the target tick and completes the pending call.
void RunThread::arrive() {
  if (!arrived_) return;
  hand_over();
  tell();
  std::exchange(arrived_, nullptr)->set_value();
}

void RunThread::hand_over() {
  rows_.flush();
  stored_input_ = inputs_.taken();
}

/// True if the next tick is due by the clock. Otherwise it waits until then or until a command arrives, and
/// returns false.
bool RunThread::is_due() {
  const double now = seconds_now();
  if (!std::exchange(is_paced_, true)) pace_.begin(pace_.rate(), next_tick(), now);
  const double due = pace_.due(next_tick(), now);
  if (due - now > ahead) {
    wait_until(due);
    return false;
  }
  pace_.begun(next_tick(), now);
  if (now - flushed_ < between_flushes) return true;
  flushed_ = now;
  hand_over();
  tell();
  return true;
}

void RunThread::wait_until(std::optional<double> time) {
  hand_over();
  tell();
  if (time)
    commands_.wait_until(*time);
  else
    commands_.wait();
}

void RunThread::evaluated(const run::ObservedRun& run) {
  shown_ = run.simulation.tick();
  rows_.take(run.simulation.values());
}

void RunThread::do_events(std::int64_t tick) {
  log_.each(tick, tick + 1, [&](const LiveEvent& event) { apply(event, life_->run); });
}

void RunThread::add_event(LiveEvent event) {
  apply(event, life_->run);
  log_.add(std::move(event));
}

/// Resets the run to its start, with the values that are set now.
void RunThread::start_anew() {
  begin_log([this](const LiveEvent& event) { apply(event, life_->run); });
  life_->run.reset();
  moments_ = Moments(ticks_between_moments(plan_));
  rows_.cut(0);
  known_ = goal_ = 0;
  shown_ = before_start;
}

/// Restores the last checkpoint before a tick; the ticks from there on are computed again.
void RunThread::go_back(std::int64_t tick) {
  const run::Workspace* moment = moments_.before(tick);
  const std::int64_t at = moment ? moment->tick : 0;
  for (const LiveEvent& event : log_.last_of_each(moment ? at : 0))
    if (!event.is_input()) apply(event, life_->run);
  if (moment)
    life_->run.restore(*moment);
  else
    life_->run.reset();
  carry_values(tick);
  moments_.cut(at);
  rows_.cut(at);
  known_ = tick + 1;
  goal_ = tick;
  shown_ = at - 1;
  select();
}

/// Applies the present values from the tick after `tick` on.
void RunThread::carry_values(std::int64_t tick) {
  const std::vector<LiveEvent> now = log_.last_of_each();
  log_.cut(tick + 1);
  const std::vector<LiveEvent> then = log_.last_of_each(tick + 1);
  for (LiveEvent event : now) {
    const auto same = std::ranges::find(then, event.name, &LiveEvent::name);
    if (same != then.end() && same->text == event.text && same->values == event.values) continue;
    event.tick = tick + 1;
    log_.add(std::move(event));
  }
}

/// Executes an action in the run's thread and publishes the new status.
template <class Act>
void RunThread::act(const Act& act) {
  commands_.ask([&] {
    act();
    tell();
  });
}

void RunThread::go_to(std::int64_t tick) {
  back_to_ = tick;
  ended_ = false;
}

void RunThread::play(double rate) {
  act([&] {
    if (ended_) go_to(before_start);
    pace_.begin(rate, next_tick(), seconds_now());
    is_paced_ = false;
    plays_ = true;
  });
}

void RunThread::pause() {
  act([&] {
    plays_ = false;
    goal_ = std::min(goal_, shown_);
  });
}

std::int64_t RunThread::one_tick() {
  constexpr std::chrono::seconds patience{1};  // limit for very slow ticks
  const auto arrived = std::make_shared<std::promise<void>>();
  const std::int64_t tick = commands_.ask([&] {
    plays_ = false;
    goal_ = ended_ ? shown_ : next_tick();
    arrived_ = arrived;
    return goal_;
  });
  arrived->get_future().wait_for(patience);
  return tick;
}

void RunThread::restart() {
  act([&] { go_to(before_start); });
}

std::int64_t RunThread::seek(double time) {
  const double ticks =
      std::clamp(std::round(time / plan_.diagram.step), 0.0, static_cast<double>(plan_.steps));
  const auto tick = static_cast<std::int64_t>(ticks);
  act([&] {
    if (tick <= shown_)
      go_to(tick);
    else
      goal_ = tick;
    is_paced_ = false;
  });
  return tick;
}

std::int64_t RunThread::apply_now(const LiveEvent& event) {
  apply(event, life_->run);
  code_.was_set(event.name);
  return event.tick;
}

/// Starts the computation of samples before the first tick of columns that were selected after the start.
void RunThread::select() {
  past_interrupt_ = true;
  if (past_.joinable()) past_.join();
  std::vector<RowGathering::Incomplete> columns = rows_.incomplete();
  if (columns.empty()) return;
  past_interrupt_ = false;
  past_ = std::thread([this, life = lives_, log = log_, columns = std::move(columns)] {
    std::vector<std::vector<double>> samples;
    try {
      samples = past_of(plan_, log, columns, past_interrupt_);
    } catch (const std::exception&) {  // the columns remain incomplete; the page shows their begin
    }
    if (!samples.empty()) commands_.push([=, this] { put_past(life, columns, samples); });
  });
}

void RunThread::put_past(std::uint32_t life, const std::vector<RowGathering::Incomplete>& columns,
                         const std::vector<std::vector<double>>& samples) {
  if (life != lives_) return;
  rows_.flush();
  for (std::size_t i = 0; i < columns.size(); ++i) rows_.put_past(columns[i].index, samples[i]);
  tell();
}

void RunThread::describe(RunStatus& status) const {
  status.state = ended_   ? RunStatus::State::ended
                 : plays_ ? RunStatus::State::playing
                          : RunStatus::State::paused;
  status.missed = pace_.missed();
  status.compiled = life_ && life_->run.compiled();
  status.input = stored_input_;
  status.fault = fault_;
}

}  // namespace stepwire::live
