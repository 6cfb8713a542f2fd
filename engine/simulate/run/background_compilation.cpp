#include "engine/simulate/run/background_compilation.hpp"

#include <system_error>
#include <utility>

namespace stepwire::run {

namespace {

constexpr double margin = 2.0;  // minimal ratio of remaining time to compile time

/// Estimates a cache lookup: it generates the text of the code, a part of the compile time, and may begin
/// earlier.
BackgroundCompilation::Prospect of_a_look(const BackgroundCompilation::Prospect& compilation) {
  return {0.1 * compilation.seconds, compilation.ticks, 0.02};
}

}  // namespace

BackgroundCompilation::BackgroundCompilation(const Prospect& prospect, Work work)
    : compilation_(prospect),
      look_(of_a_look(prospect)),
      work_(std::move(work)),
      stage_(prospect.seconds > 0.0 ? Stage::idle : Stage::ended) {}

void BackgroundCompilation::at_once() {
  if (stage_.exchange(Stage::ended) == Stage::idle) work_({});
}

void BackgroundCompilation::done(std::int64_t ticks) {
  const auto done = static_cast<double>(done_ += ticks);
  Stage stage = stage_.load(std::memory_order_acquire);
  if (stage == Stage::idle && is_worth(look_, done)) {
    if (stage_.compare_exchange_strong(stage, Stage::looking)) beside([this](auto stop) { look(stop); });
  } else if (stage == Stage::looked && is_worth(compilation_, done)) {
    if (stage_.compare_exchange_strong(stage, Stage::ended)) beside([this](auto stop) { work_({stop}); });
  }
}

bool BackgroundCompilation::is_worth(const Prospect& prospect, double done) const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = prospect.ticks ? seconds * (*prospect.ticks - done) / done : seconds;
  return seconds > prospect.patience && left > margin * prospect.seconds;
}

void BackgroundCompilation::look(const std::stop_token& stop) {
  const bool all = work_({.stop = stop, .only_kept = true});
  stage_.store(all ? Stage::ended : Stage::looked, std::memory_order_release);
}

template <class Task>
void BackgroundCompilation::beside(const Task& task) {
  const std::lock_guard lock(mutex_);
  try {
    thread_ = std::jthread([task](const std::stop_token& stop) { task(stop); });
  } catch (const std::system_error&) {  // without a second thread nothing is compiled
    stage_ = Stage::ended;
  }
}

}  // namespace stepwire::run
