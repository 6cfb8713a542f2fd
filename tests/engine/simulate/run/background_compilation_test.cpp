#include "engine/simulate/run/background_compilation.hpp"

#include <catch2/catch.hpp>
#include <future>
#include <vector>

using namespace stepwire;
using run::BackgroundCompilation;

namespace {

constexpr std::int64_t one_tick = 1;
constexpr BackgroundCompilation::Prospect endless{.seconds = 1e-3, .ticks = 1e12, .patience = 0.0};

/// Makes ticks until the code is there.
template <class Code>
void run_until(BackgroundCompilation& compilation, const Code& is_there) {
  while (!is_there()) compilation.done(one_tick);
}

}  // namespace

TEST_CASE("Code that is kept is looked for before any is compiled") {
  std::vector<bool> only_kept;
  std::atomic<bool> compiled = false;
  {
    BackgroundCompilation compilation(endless, [&](const plan::CodeLimits& limits) {
      only_kept.push_back(limits.only_kept);
      compiled = !limits.only_kept;
      return !limits.only_kept;
    });
    run_until(compilation, [&] { return compiled.load(); });
    for (int i = 0; i < 1000; ++i) compilation.done(one_tick);
  }
  CHECK(only_kept == std::vector{true, false});
}

TEST_CASE(
    "Nothing is compiled where all code is kept, and nothing is looked for where there is none to get") {
  std::atomic<int> calls = 0;
  const auto found = [&](const plan::CodeLimits&) { return ++calls > 0; };
  {
    BackgroundCompilation compilation(endless, found), nothing({.seconds = 0.0, .ticks = 1e12}, found);
    run_until(compilation, [&] {
      nothing.done(one_tick);
      return calls > 0;
    });
    for (int i = 0; i < 1000; ++i) compilation.done(one_tick);
  }
  CHECK(calls == 1);
}

TEST_CASE("What is got at once is not looked for, and a compilation that goes on is stopped at the end") {
  std::atomic<int> calls = 0;
  BackgroundCompilation now(endless,
                            [&](const plan::CodeLimits& limits) { return ++calls > 0 && !limits.only_kept; });
  now.at_once();
  for (int i = 0; i < 1000; ++i) now.done(one_tick);
  CHECK(calls == 1);

  std::promise<bool> stopped;
  {
    std::atomic<bool> begun = false;
    BackgroundCompilation beside(endless, [&](const plan::CodeLimits& limits) {
      begun = true;
      while (!limits.stop.stop_requested()) std::this_thread::yield();
      stopped.set_value(true);
      return true;
    });
    run_until(beside, [&] { return begun.load(); });
  }
  CHECK(stopped.get_future().get());
}
