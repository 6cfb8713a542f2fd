#include "engine/app/studio/live/fan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "engine/app/studio/live/command_queue.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/profile/profile.hpp"
#include "engine/simulate/run/drive.hpp"

namespace stepwire::live {

namespace {

using json::Json;

constexpr std::int64_t samples_shown = 1000;
constexpr std::size_t most_points = 64;
constexpr std::int64_t profiled_ticks = 2000;

/// Accessor of a column's value at a tick.
struct Reading {
  std::size_t offset = 0;
  std::optional<expression::Expression> formula{};
  std::vector<std::size_t> places{};

  double operator()(const double* values) const {
    return formula ? (*formula)(values, places) : values[offset];
  }
};

Reading reading_of(const LoadedRun& run, std::size_t index) {
  const LiveColumn column = run.column(index);
  if (!column.formula) return {run.signals().all()[index].offset};
  Reading reading{0, column.formula->expression};
  for (const std::string& name : column.formula->columns) {
    const auto signal = run.signals().find(name);
    reading.places.push_back(signal ? run.signals().all()[*signal].offset : plan::Layout::time);
  }
  return reading;
}

/// Observer that records readings at every n-th tick.
class Sampling : public run::RunObserver {
 public:
  Sampling(const std::vector<Reading>& readings, std::int64_t every) : readings_(readings), every_(every) {
    columns.resize(readings.size());
  }

  void evaluated(const run::ObservedRun& run) override {
    if (run.simulation.tick() % every_ != 0) return;
    times.push_back(run.simulation.time());
    for (std::size_t i = 0; i < columns.size(); ++i)
      columns[i].push_back(readings_[i](run.simulation.values()));
  }

  std::vector<double> times;
  std::vector<std::vector<double>> columns;

 private:
  const std::vector<Reading>& readings_;
  std::int64_t every_;
};

class Fan {
 public:
  Fan(LoadedRun& run, const FanCall& call, const std::atomic<bool>& interrupt)
      : run_(run), call_(call), interrupt_(interrupt), set_(run.thread().log()) {
    for (const std::size_t column : call.columns) readings_.push_back(reading_of(run, column));
  }

  Json points() {
    std::vector<Json> points(call_.count);
    const unsigned threads = std::max(1u, std::thread::hardware_concurrency() - 1);  // one core for the run
    parallel::in_parallel(call_.count, threads, [&](std::size_t i) { points[i] = point(i); });
    if (refused_ == call_.count) throw std::runtime_error(refusal_);
    Json list = Json::list();
    for (Json& point : points)
      if (point.is_object()) list.push(std::move(point));
    return Json::object().set("points", std::move(list));
  }

 private:
  double value(std::size_t i) const {
    const double share = static_cast<double>(i) / static_cast<double>(call_.count - 1);
    return call_.low + share * (call_.high - call_.low);
  }

  /// True if the run accepts the value; it refuses a mass of 0, for example.
  bool takes(run::Executor& simulation, double value) {
    try {
      apply({0, call_.name, fmt::format("{}", value), {}, 0.0}, simulation);
      return true;
    } catch (const yaml::Error& error) {
      const std::lock_guard lock(mutex_);
      ++refused_;
      refusal_ = error.what();
      return false;
    }
  }

  /// Returns null if the run was interrupted or the value is refused.
  Json point(std::size_t i) {
    run::Executor simulation(run_.plan());
    for (const LiveEvent& event : set_.events())
      if (!event.is_input()) apply(event, simulation);
    if (!takes(simulation, value(i))) return {};
    simulation.reset();
    Sampling sampling(readings_, std::max<std::int64_t>(1, run_.plan().steps / samples_shown));
    run::RunObserver* const observer = &sampling;
    std::vector<record::Recorder> nothing_recorded;
    run::Drive drive(simulation, nothing_recorded);
    drive.observers = {&observer, 1};
    drive.shows_rows = false;
    drive.interrupt = &interrupt_;
    if (drive.run() == run::Drive::End::interrupted) return {};
    Json columns = Json::list();
    for (const std::vector<double>& column : sampling.columns) columns.push(Json::list_of(column));
    return Json::object()
        .set("value", value(i))
        .set("time", Json::list_of(sampling.times))
        .set("columns", std::move(columns));
  }

  LoadedRun& run_;
  const FanCall& call_;
  const std::atomic<bool>& interrupt_;
  EventLog set_;  ///< values that are set in the run
  std::vector<Reading> readings_;
  std::mutex mutex_;
  std::size_t refused_ = 0;
  std::string refusal_;  ///< message of a refused value
};

}  // namespace

Json fan(LoadedRun& run, const FanCall& call, const std::atomic<bool>& interrupt) {
  if (call.count < 2 || call.count > most_points)
    throw std::runtime_error(fmt::format("a fan has 2 to {} values", most_points));
  return Fan(run, call, interrupt).points();
}

Json profile_now(const LoadedRun& run, const std::atomic<bool>& interrupt) {
  plan::Plan part = run.plan();
  part.steps = std::min(part.steps, profiled_ticks);
  const profile::Profile profile = profile::profile_plan(part, {seconds_now, &interrupt});
  const auto ticks = static_cast<double>(std::max<std::int64_t>(1, profile.ticks));
  Json blocks = Json::list();
  for (const profile::BlockCost& block : profile.blocks) {
    const double seconds = block.total().seconds;
    blocks.push(Json::object()
                    .set("name", block.name)
                    .set("type", block.type)
                    .set("share", profile.share(seconds))
                    .set("ns", seconds / ticks * 1e9));
  }
  return Json::object().set("blocks", std::move(blocks));
}

}  // namespace stepwire::live
