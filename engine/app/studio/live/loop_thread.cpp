#include "engine/app/studio/live/loop_thread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/app/studio/live/live_inputs.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {
namespace {

std::size_t numbers_of(const std::vector<std::vector<double>>& defaults) {
  std::size_t count = 0;
  for (const std::vector<double>& values : defaults) count += 1 + values.size();
  return count;
}

using realtime::Histogram;
using result::Finite;
using result::path;
using result::Record;

constexpr double per_octave = 4.0, ns = 1e-9;
constexpr double shortest = 64.0;  // [ns] upper edge of the first bin
constexpr std::size_t bins = 145;  // up to 73 min

double edge(std::size_t bin) {
  return bin == 0 ? 0.0 : shortest * std::exp2(static_cast<double>(bin - 1) / per_octave);
}

std::size_t bin_of(double time) {
  if (time < shortest) return 0;
  return std::min(bins - 1, 1 + static_cast<std::size_t>(per_octave * std::log2(time / shortest)));
}

/// Bins of a histogram without the empty ones at both ends.
struct Bins {
  std::vector<Finite> edges;  ///< [s]
  std::vector<std::int64_t> counts;
};

Bins bins_of(const Histogram& times) {
  std::vector<std::int64_t> counts(bins, 0);
  for (std::size_t fine = 0; fine < Histogram::bins(); ++fine)
    counts[bin_of(static_cast<double>(Histogram::begin_of(fine)))] += times.count_in(fine);
  const auto is_full = [](std::int64_t count) { return count > 0; };
  const auto first = std::ranges::find_if(counts, is_full);
  const auto end = std::find_if(counts.rbegin(), counts.rend(), is_full).base();
  Bins full;
  for (auto count = first; count < end; ++count) {
    if (count == first) full.edges.push_back({ns * edge(static_cast<std::size_t>(first - counts.begin()))});
    full.edges.push_back({ns * edge(static_cast<std::size_t>(count - counts.begin()) + 1)});
    full.counts.push_back(*count);
  }
  return full;
}

}  // namespace

/// Distribution of times in a loop.
struct LiveTimes {
  const Histogram* of;

  auto quantile(double share) const { return Finite{ns * static_cast<double>(of->quantile(share))}; }
};

/// Cost of the blocks of a type.
struct LiveCost {
  std::string type;
  std::size_t blocks;
  double mean;  ///< [ns]
};

static void declare(Record<LiveTimes>& is) {
  is.named("Histogram", "Histogram of times with bins of a quarter octave.");
  is.field(
      "edges", [](const LiveTimes& of) { return bins_of(*of.of).edges; }, "edges, one more than counts", "s");
  is.field(
      "counts", [](const LiveTimes& of) { return bins_of(*of.of).counts; }, "counts of the bins");
  is.field("count", path(&LiveTimes::of, &Histogram::count), "number of times");
  is.field(
      "p50", [](const LiveTimes& of) { return of.quantile(0.5); }, "median", "s");
  is.field(
      "p99", [](const LiveTimes& of) { return of.quantile(0.99); }, "not exceeded by 99 %", "s");
  is.field(
      "p999", [](const LiveTimes& of) { return of.quantile(0.999); }, "not exceeded by 99.9 %", "s");
  is.field(
      "max", [](const LiveTimes& of) { return Finite{ns * static_cast<double>(of.of->max())}; }, "longest",
      "s");
}

static void declare(Record<LiveCost>& is) {
  is.named("LiveCost", "Cost of the blocks of a type.");
  is.field("type", &LiveCost::type, "type");
  is.field("blocks", &LiveCost::blocks, "number of blocks");
  is.field(
      "mean", [](const LiveCost& of) { return Finite{ns * of.mean}; }, "mean time of a tick", "s");
}

namespace {

const realtime::Deadlines& deadlines_of(const LoopNews& of) {
  return of.loop->deadlines();
}

/// Returns a function that gives one of the measured distributions.
auto times(const Histogram& (realtime::Measurements::*of)() const) {
  return [of](const LoopNews& news) { return LiveTimes{&(news.loop->measurements().*of)()}; };
}

std::vector<LiveCost> costs_of(const LoopNews& of) {
  std::vector<LiveCost> costs;
  for (const realtime::GroupCost& cost : of.loop->group_costs())
    if (cost.samples > 0) costs.push_back({cost.type, cost.blocks, cost.mean});
  return costs;
}

}  // namespace

void declare(Record<LoopNews>& is) {
  using realtime::Deadlines;
  using realtime::Measurements;
  is.named("LoopNews", "Timing of a real-time loop, which may be running.");
  is.field(
      "period", [](const LoopNews& of) { return Finite{1.0 / of.rate}; }, "period", "s");
  is.field("served", path(&LoopNews::loop, &realtime::Loop::steps), "number of executed steps");
  is.field("missed", path(deadlines_of, &Deadlines::missed), "late and dropped deadlines");
  is.field("late", path(deadlines_of, &Deadlines::late), "late deadlines");
  is.field("dropped", path(deadlines_of, &Deadlines::dropped), "dropped deadlines");
  is.field("longest", path(deadlines_of, &Deadlines::longest_row), "longest run of successive misses");
  is.field("lateness", times(&Measurements::wake_up), "delay of the wake-up");
  is.field("response", times(&Measurements::response), "time until outputs are written");
  is.field("step", times(&Measurements::step), "duration of a whole wake-up");
  is.field("costs", costs_of, "cost by block type, most expensive first");
  is.field("run", &LoopNews::run, "number of the run");
  is.field("lost", &LoopNews::lost, "ticks that were lost on the way to the page");
  is.field("policy", &LoopNews::policy, "effective policy");
  is.field("refused", &LoopNews::refused, "requests that the system refused");
}

std::string loop_news_typescript() {
  return "// Types of the news 'loop', which follow from the declaration in loop_thread.cpp. A test compares "
         "them.\n" +
         result::typescript_of({&result::record_type<LoopNews>()});
}

namespace {

constexpr double unknown_number = std::numeric_limits<double>::quiet_NaN();
constexpr double between_hub_looks = 4e-3, hub_idle = 0.05;     // [s]
constexpr std::int64_t most_deadlines = std::int64_t{1} << 50;  // no end: 35 years at 1 MHz

realtime::LoopOptions options_of(const session::LoopSettings& settings) {
  realtime::LoopOptions options;
  options.rate = settings.rate;
  options.deadlines = most_deadlines;
  options.overrun = settings.overrun;
  return options;
}

constexpr double between_asks = 1e-4;  // [s] between checks of whether the loop has taken a value

[[noreturn]] void refuse_of_loop(const char* what) {
  throw std::runtime_error(std::string("a real-time loop ") + what);
}

}  // namespace

PageDevice::PageDevice(const plan::Plan& plan, realtime::LoopClock& clock)
    : clock_(clock), row_(numbers_of(defaults_of_inputs(plan)), 0.0), latest_(row_) {
  std::size_t first = 0;
  for (std::vector<double>& defaults : defaults_of_inputs(plan)) {
    const std::size_t size = defaults.size();
    inputs_.push_back({first, std::move(defaults)});
    first += 1 + size;
  }
}

void PageDevice::read(double* inputs) noexcept {
  const std::span<const double> row = latest_.take();
  const auto now = static_cast<double>(clock_.now());
  for (const Input& input : inputs_) {
    const bool holds = now <= row[input.first];
    const double* from = holds ? row.data() + input.first + 1 : input.defaults.data();
    inputs = std::copy_n(from, input.defaults.size(), inputs);
  }
}

void PageDevice::put(std::size_t input, const std::vector<double>& values, std::int64_t until) {
  extend(input, until);
  std::ranges::copy(values, row_.begin() + static_cast<std::ptrdiff_t>(inputs_[input].first) + 1);
}

LoopThread::Life::Life(const plan::Plan& plan, const session::LoopSettings& settings,
                       realtime::LoopClock& clock)
    : values(plan),
      device(plan, clock),
      loop(
          plan,
          [&] {
            realtime::LoopOptions options = options_of(settings);
            options.pause = &pause;
            options.tap = &tap;
            options.values = &values;
            return options;
          }(),
          device, clock, nullptr) {}

LoopThread::LoopThread(const plan::Plan& plan, const SignalList& signals, Options options)
    : RunControl(plan, signals, options.store, options.run, std::move(options.changed)),
      options_(std::move(options)),
      clock_(options_.settings.spin),
      mirror_(plan.layout.size, unknown_number),
      absent_(mirror_) {
  begin_life();
  tell();
  hub_ = std::thread([this] { main(); });
}

LoopThread::~LoopThread() {
  commands_.push([this] { quits_ = true; });
  hub_.join();
}

void LoopThread::main() {
  while (!quits_) {
    commands_.run_all();
    try {
      look();
    } catch (const std::exception& error) {  // a full disk, for example
      end_thread();
      fault_ = error.what();
      tell();
    }
    commands_.wait_until(seconds_now() + (serves() ? between_hub_looks : hub_idle));
  }
  end_thread();
}

void LoopThread::look() {
  if (serves() && life_->done) return stop_serving();
  if (!serves()) return;
  hand_inputs();
  take_rows();
  pace_.begun(shown_, seconds_now());
  tell();
}

/// Creates a loop at its start, with the values that are set.
void LoopThread::begin_life() {
  life_.reset();
  life_ = std::make_unique<Life>(plan_, options_.settings, clock_);
  begin_log([this](const LiveEvent& event) {
    life_->values.change_both([&](run::Executor& run) {
      apply(event, run);
      run.reset();
    });
  });
  rows_.cut(0);
  shown_ = -1;
  seen_inputs_ = defaults_of_inputs(plan_);
  select();
}

void LoopThread::begin_serving() {
  life_->pause = life_->done = false;
  fault_.clear();
  pace_.begin(1.0, shown_ + 1, seconds_now());
  life_->thread = std::thread([this] { serve(); });
}

/// Serves deadlines; runs in the loop thread.
void LoopThread::serve() {
  const realtime::RealTimeThread real_time(options_.settings.policy, options_.settings.cpu);
  {
    const std::lock_guard lock(status_mutex_);
    policy_ = realtime::RealTimeThread::policy_in_force();
    refused_ = real_time.refused();
  }
  life_->loop.serve(most_deadlines);
  life_->done = true;
}

void LoopThread::end_thread() {
  life_->pause = true;
  if (serves()) life_->thread.join();
}

void LoopThread::stop_serving() {
  if (!serves()) return;
  end_thread();
  take_rows();
  tell();
}

/// Selects the numbers that the loop passes to the hub: time, inputs, and the signals that pages display.
void LoopThread::select() {
  std::vector<std::size_t> places = rows_.places();
  places.push_back(plan::Layout::time);
  for (const diagram::DiagramInput& input : plan_.diagram.inputs) {
    const plan::SignalSlot slot = plan_.slot({input.block, 0, -1});
    for (Eigen::Index k = 0; k < slot.size; ++k) places.push_back(slot.offset + static_cast<std::size_t>(k));
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  life_->tap.select(std::move(places));
}

void LoopThread::take_rows() {
  life_->tap.take_all([this](std::int64_t tick, const std::vector<std::size_t>& places,
                             std::span<const double> values) { take_row(tick, places, values); });
  rows_.flush();
}

void LoopThread::take_row(std::int64_t tick, const std::vector<std::size_t>& places,
                          std::span<const double> values) {
  for (++shown_; shown_ < tick; ++shown_) rows_.take(absent_.data());  // rows for which the ring had no room
  for (std::size_t i = 0; i < places.size(); ++i) mirror_[places[i]] = values[i];
  rows_.take(mirror_.data());
  note_inputs(tick);
}

/// Logs the inputs of a tick that differ from those of the previous one.
void LoopThread::note_inputs(std::int64_t tick) {
  for (std::size_t i = 0; i < seen_inputs_.size(); ++i) {
    const diagram::DiagramInput& input = plan_.diagram.inputs[i];
    const double* now = mirror_.data() + plan_.slot({input.block, 0, -1}).offset;
    if (std::equal(seen_inputs_[i].begin(), seen_inputs_[i].end(), now)) continue;
    seen_inputs_[i].assign(now, now + seen_inputs_[i].size());
    log_.add({tick, input.name, "", seen_inputs_[i], sampled_[input.name]});
    acted_ = handed_;
  }
}

void LoopThread::lose_silent_pages(double now) {
  std::vector<int> silent;
  {
    const std::lock_guard lock(status_mutex_);
    for (const int writer : inputs_.writers())
      if (writer != 0 && now - heard_[writer] > options_.patience) silent.push_back(writer);
  }
  for (const int writer : silent) inputs_.release(writer);
}

/// Passes inputs of pages to the loop; an input expires if its page falls silent.
void LoopThread::hand_inputs() {
  const double now = seconds_now();
  lose_silent_pages(now);
  const auto until = clock_.now() + std::llround(1e9 * options_.patience);
  const auto& inputs = plan_.diagram.inputs;
  for (const LiveEvent& event : inputs_.take(now, 0)) {
    const auto found = std::ranges::find(inputs, event.name, &diagram::DiagramInput::name);
    life_->device.put(static_cast<std::size_t>(found - inputs.begin()), event.values, until);
    sampled_[event.name] = event.time;
    handed_ = inputs_.taken();
  }
  const std::vector<int> writers = inputs_.writers();
  for (std::size_t i = 0; i < writers.size(); ++i)
    if (writers[i] != 0) life_->device.extend(i, until);
  life_->device.give();
}

void LoopThread::play(double rate) {
  if (rate != 1.0) refuse_of_loop("goes in real time: its rate is 1");
  commands_.ask([&] {
    if (serves()) return;
    if (life_->loop.ended()) {
      ++lives_;
      begin_life();
    }
    begin_serving();
    tell();
  });
}

void LoopThread::pause() {
  commands_.ask([&] { stop_serving(); });
}

std::int64_t LoopThread::one_tick() {
  refuse_of_loop("takes no single ticks");
}

std::int64_t LoopThread::seek(double) {
  refuse_of_loop("does not go back");
}

void LoopThread::restart() {
  commands_.ask([&] {
    const bool goes_on = serves();
    stop_serving();
    ++lives_;
    begin_life();
    if (goes_on) begin_serving();
    tell();
  });
}

std::int64_t LoopThread::apply_now(const LiveEvent& event) {
  const bool begins = shown_ < 0 && !serves();
  const auto change = [&](run::Executor& run) {
    apply(event, run);
    if (begins) run.reset();
  };
  if (serves()) {
    life_->values.offer(change);
    while (!life_->values.taken() && !life_->done)
      std::this_thread::sleep_for(std::chrono::duration<double>(between_asks));
    if (!life_->values.taken()) life_->values.at_tick();  // the loop ended before it took the value
    life_->values.follow(change);
    return *life_->values.taken();
  }
  life_->values.change_both(change);
  return begins ? before_start : life_->values.active().tick();
}

void LoopThread::input(const InputSample& sample) {
  inputs_.push(sample);
  heard(sample.client);
  commands_.push([] {});
}

void LoopThread::release(int client) {
  {
    const std::lock_guard lock(status_mutex_);
    heard_.erase(client);
  }
  inputs_.release(client);
  commands_.push([] {});
}

void LoopThread::heard(int client) {
  const std::lock_guard lock(status_mutex_);
  heard_[client] = seconds_now();
}

void LoopThread::describe(RunStatus& status) const {
  const bool ended = !serves() && life_->loop.ended();
  status.state = serves() ? RunStatus::State::playing
                 : ended  ? RunStatus::State::ended
                          : RunStatus::State::paused;
  status.missed = life_->loop.deadlines().missed();
  status.input = acted_;
  status.fault = fault_;
  if (const auto fault = ended ? life_->loop.simulation().fault() : std::nullopt)
    status.fault = fault->fault.text();
}

std::optional<json::Json> LoopThread::timing() {
  return commands_.ask([&] {
    const std::lock_guard lock(status_mutex_);
    const LoopNews news{&life_->loop, options_.settings.rate, lives_, life_->tap.lost(), policy_, refused_};
    return std::optional(result::json_of(news));
  });
}

}  // namespace stepwire::live
