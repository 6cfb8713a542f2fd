#include "engine/app/studio/live/past.hpp"

#include <algorithm>

#include "engine/simulate/run/drive.hpp"

namespace stepwire::live {

namespace {

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

}  // namespace

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

}  // namespace stepwire::live
