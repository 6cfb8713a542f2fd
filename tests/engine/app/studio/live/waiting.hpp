#pragma once

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "blocks/register.hpp"
#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/app/studio/live/run_thread.hpp"

namespace stepwire::live {

inline const Registry& library() {
  static const Registry registry = blocks();
  return registry;
}

/// Runs that are simulated.
inline MakeRun simulated() {
  return [](const plan::Plan& plan, const SignalList& signals) {
    return std::make_unique<RunThread>(plan, signals, RunThread::Options{});
  };
}

/// Waits until something has come true on another thread; a minute is a failure.
template <class Condition>
void wait_until(const Condition& holds) {
  for (int i = 0; i < 60'000 && !holds(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  REQUIRE(holds());
}

inline void wait_for_end(const RunControl& run) {
  wait_until([&] { return run.status().state == RunStatus::State::ended; });
}

/// Waits until a run is no longer playing, is at a tick, and has stored all rows up to it.
inline void wait_for_tick(const RunControl& run, std::int64_t tick) {
  wait_until([&] {
    return run.status().state != RunStatus::State::playing && run.status().tick == tick &&
           run.store().end_tick() == tick + 1;
  });
}

}  // namespace stepwire::live
