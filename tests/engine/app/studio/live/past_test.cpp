// Signals that are chosen late in a run.
#include <cmath>

#include "engine/app/studio/live/run_thread.hpp"
#include "tests/engine/app/studio/live/live_studio.hpp"

namespace stepwire::live {

namespace {

/// y(t) = 1 - exp(-t/0.1 s), and of it 2 y; only `other` is recorded.
const std::string lag = R"(stepwire: 1
title: A lag
step: 1 ms
stop: 2 s
solver: rk4
parameters: {goal: 1}
blocks:
  one: {block: Constant, value: $goal}
  lag: {block: Lag, u: one, tau: 0.1 s}
  twice: {block: Gain, u: lag, gain: 2}
  other: {block: Constant, value: 3}
record: [other]
)";

struct Columns {
  diagram::Loader loader;
  plan::Plan plan;
  SignalList signals;
  explicit Columns(const std::string& text)
      : loader(library()), plan(plan::make_plan(loader.load_text(text, "lag.yaml"))), signals(plan) {}
  std::size_t of(const std::string& name) const { return *signals.find(name); }
};

std::vector<double> samples(const RunThread& run, std::size_t column, std::size_t count) {
  std::vector<double> all(count);
  run.store().read(column, 0, all);
  return all;
}

}  // namespace

TEST_CASE("a signal that is asked for after the end has the samples of the whole run") {
  const Columns model(lag);
  RunThread run(model.plan, model.signals, {});
  run.play(0.0);
  wait_until([&] { return run.status().state == RunStatus::State::ended; });
  const std::size_t column = run.stored(model.of("twice.y"));
  wait_until([&] { return run.store().first_tick(column) == 0; });
  const auto values = samples(run, column, 2001);
  for (std::size_t i = 0; i < values.size(); ++i) {
    INFO("tick " << i);
    REQUIRE(values[i] == Approx(2.0 * (1.0 - std::exp(-static_cast<double>(i) / 100.0))).margin(1e-9));
  }
  CHECK(run.status().state == RunStatus::State::ended);
}

TEST_CASE("a signal that is asked for on the way has what was set before, and goes on without a gap") {
  const Columns model(lag);
  RunThread run(model.plan, model.signals, {});
  run.seek(0.5);
  wait_until([&] { return run.status().tick == 500; });
  run.set("goal", "5");
  run.seek(1.0);
  wait_until([&] { return run.status().tick == 1000; });
  const std::size_t column = run.stored(model.of("lag.y"));
  run.seek(1.5);
  wait_until([&] { return run.status().tick == 1500 && run.store().first_tick(column) == 0; });
  const auto values = samples(run, column, 1501);
  const double at_half = 1.0 - std::exp(-5.0);
  CHECK(values[500] == Approx(at_half).margin(1e-9));
  for (const std::size_t i : {600u, 999u, 1000u, 1001u, 1400u}) {
    INFO("tick " << i);
    // The value holds from tick 501 on, which acts on the step behind it.
    const double since = (static_cast<double>(i) - 501.0) / 100.0, start = 1.0 - std::exp(-5.01);
    CHECK(values[i] == Approx(5.0 + (start - 5.0) * std::exp(-since)).margin(1e-6));
  }
}

TEST_CASE("frames of a paused run come again once the past of a column is there") {
  Studio studio(lag);
  const Json loaded = studio.call("run.load", R"({"file": 1})");
  studio.run_to_end();
  std::size_t column = 0;
  for (const Json& one : loaded.find("columns")->items())
    if (*one.find("name")->as_text() == "lag.y" || *one.find("name")->as_text() == "lag")
      column = static_cast<std::size_t>(*one.find("column")->as_number());
  studio.call("data.want", R"({"views": [{"view": 7, "columns": [)" + std::to_string(column) +
                               R"(], "from": 0.1, "to": 0.2, "pixels": 1000}]})");
  wait_until([&] {
    const std::lock_guard lock(studio.received.mutex);
    if (studio.received.frames.empty()) return false;
    const std::string& bytes = studio.received.frames.back().second;
    const auto rows = number_at<std::uint32_t>(bytes, 12);
    return rows == 101 && std::abs(number_at<double>(bytes, 32 + 8 * rows) - (1.0 - std::exp(-1.0))) < 1e-6;
  });
}

}  // namespace stepwire::live
