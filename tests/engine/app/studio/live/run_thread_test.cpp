#include "engine/app/studio/live/run_thread.hpp"

#include <catch2/catch.hpp>
#include <thread>

#include "blocks/register.hpp"
#include "engine/app/session/session.hpp"
#include "tests/engine/app/studio/live/waiting.hpp"

namespace stepwire::live {

namespace {

const std::string slide = R"(stepwire: 1
title: t
step: 1 ms
stop: 4 s
solver: rk4
parameters: {mass: {value: 2 kg, above: 0 kg}}
inputs: {push: {unit: N, default: 1 N}}
record: [slide.position, slide.velocity]
blocks:
  spring: {block: Gain, u: slide.position, gain: -100 N/m}
  friction: {block: Gain, u: slide.velocity, gain: -0.4 N s/m}
  net: {block: Sum, u: [push, spring, friction]}
  slide: {block: Mass, force: net, mass: $mass, initial_position: 0 m}
)";

struct Model {
  explicit Model(const std::string& text)
      : loader(library()), plan(plan::make_plan(loader.load_text(text, "slide.yaml"))), signals(plan) {}
  diagram::Loader loader;
  plan::Plan plan;
  SignalList signals;
};

/// Returns the recordings of a run with these events, computed without a thread.
std::vector<record::Recording> replayed(const plan::Plan& plan, const EventLog& log) {
  LogReplay replay(EventLog::read(json::Json::parse(log.json().text())));
  run::RunOptions options;
  options.observers = {&replay};
  return run::run_plan(plan, options).recordings;
}

void require_same_bits(const RunThread& run, const std::vector<record::Recording>& recordings) {
  for (std::size_t c = 1; c < recordings[0].table.columns.size(); ++c) {
    const std::vector<double>& right = recordings[0].table.columns[c].values;
    std::vector<double> live(right.size());
    run.store().read(c - 1, 0, live);
    for (std::size_t i = 0; i < right.size(); ++i) {
      INFO("column " << c << ", row " << i);
      REQUIRE(live[i] == right[i]);
    }
  }
}

}  // namespace

TEST_CASE("a live run has the bits of a run") {
  const Model model(slide);
  RunThread run(model.plan, model.signals, {});
  CHECK(run.status().state != RunStatus::State::playing);
  run.play(0.0);
  wait_for_end(run);
  CHECK(run.status().tick == 4000);
  require_same_bits(run, run::run_plan(model.plan).recordings);
}

TEST_CASE("what is set and written is logged with its tick, and the log gives the same bits again") {
  const Model model(slide);
  RunThread run(model.plan, model.signals, {});
  for (int i = 0; i < 5; ++i) {
    run.one_tick();
    const SetResult set = run.set("mass", std::to_string(2 + i) + " kg");
    CHECK(set.value == 2.0 + i);
    run.input({1, 0.0, "push", {3.0 * i}});
    run.set("spring.gain", std::to_string(-100 - i));
    run.seek(0.3 * (i + 1));
    wait_for_tick(run, 300 * (i + 1));
  }
  run.release(1);
  run.play(0.0);
  wait_for_end(run);
  const EventLog log = run.log();
  CHECK(log.events().size() >= 15);
  CHECK(log.events().back().values == std::vector{1.0});
  require_same_bits(run, replayed(model.plan, log));
}

TEST_CASE("a return to a moment gives the bits that were there, and goes on with what is set now") {
  const Model model(slide);
  RunThread run(model.plan, model.signals, {});
  run.seek(1.0);
  wait_for_tick(run, 1000);
  run.set("mass", "5 kg");
  run.seek(2.2);
  wait_for_tick(run, 2200);
  std::vector<double> before(2001), after(2001);
  run.store().read(0, 0, before);
  run.set("mass", "3 kg");
  run.seek(3.0);
  wait_for_tick(run, 3000);
  const std::uint32_t number = run.status().run;
  run.seek(2.0);
  wait_for_tick(run, 2000);
  CHECK(run.status().run == number + 1);
  CHECK(run.store().end_tick() == 2001);
  run.store().read(0, 0, after);
  CHECK(before == after);
  run.play(0.0);
  wait_for_end(run);
  const EventLog log = run.log();
  CHECK(log.events().back().tick == 2001);
  CHECK(log.events().back().text == "3 kg");
  require_same_bits(run, replayed(model.plan, log));
}

TEST_CASE("a restart begins with the values that are set, initial values among them") {
  const Model model(slide);
  RunThread run(model.plan, model.signals, {});
  run.seek(0.5);
  wait_for_tick(run, 500);
  run.set("slide.initial_position", "0.25 m");
  run.set("mass", "3 kg");
  run.restart();
  run.play(0.0);
  wait_for_end(run);
  std::vector<double> first(1);
  run.store().read(0, 0, first);
  CHECK(first.front() == 0.25);
  CHECK(run.log().events().front().tick == before_start);
  require_same_bits(run, replayed(model.plan, run.log()));
}

TEST_CASE("a value that is refused changes nothing and is not logged") {
  const Model model(slide);
  RunThread run(model.plan, model.signals, {});
  CHECK_THROWS_WITH(run.set("mass", "-1 kg"), Catch::Contains("mass"));
  CHECK_THROWS_WITH(run.set("mas", "1 kg"), Catch::Contains("mass"));
  CHECK_THROWS_WITH(run.input({1, 0.0, "push", {1.0, 2.0}}), Catch::Contains("takes 1 number, not 2"));
  CHECK_THROWS_WITH(run.input({1, 0.0, "pull", {1.0}}), Catch::Contains("push"));
  CHECK(run.log().events().empty());
}

TEST_CASE("a fault ends the run as data, and the run goes back from there") {
  const Model model(R"(stepwire: 1
title: t
step: 1 ms
stop: 1 s
parameters: {fall: 1}
record: [over]
blocks:
  ramp: {block: Ramp, slope: = -fall}
  left: {block: Sum, u: [ramp, 0.5]}
  over: {block: Divide, numerator: 1, denominator: left}
)");
  RunThread run(model.plan, model.signals, {});
  run.play(0.0);
  wait_for_end(run);
  CHECK(run.status().fault.find("over") != std::string::npos);
  CHECK(run.store().end_tick() == 500);
  run.set("fall", "0.1");
  run.restart();
  run.play(0.0);
  wait_for_end(run);
  CHECK(run.status().fault.empty());
  CHECK(run.store().end_tick() == 1001);
}

TEST_CASE("a formula is computed from what is stored, and a signal that is not is computed again") {
  const Model model(slide);
  RunThread run(model.plan, model.signals, {});
  run.seek(1.0);
  wait_for_tick(run, 1000);
  yaml::Faults faults;
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = "1000*slide.position + time";
  const auto formula = query::read_formula(node, model.signals.names(model.plan), "signal", faults);
  REQUIRE(formula);
  const std::size_t column = run.stored(*formula);
  const std::size_t late = run.stored(*model.signals.find("net"));
  run.play(0.0);
  wait_for_end(run);
  wait_until([&] { return run.store().first_tick(late) == 0; });
  std::vector<double> position(4001), velocity(4001), sum(4001), net(4001);
  run.store().read(0, 0, position);
  run.store().read(1, 0, velocity);
  run.store().read(column, 0, sum);
  run.store().read(late, 0, net);
  for (std::size_t i = 0; i < sum.size(); ++i) {
    REQUIRE(sum[i] == 1000.0 * position[i] + static_cast<double>(i) / 1000.0);
    REQUIRE(net[i] == Approx(1.0 - 100.0 * position[i] - 0.4 * velocity[i]).margin(1e-12));
  }
}

TEST_CASE("many moments are thinned out, the older the more") {
  Moments moments(10, 20 * (sizeof(run::Workspace) + 8 * sizeof(double)));
  for (std::int64_t tick = 0; tick < 5000; ++tick)
    if (moments.due(tick)) moments.keep({tick, std::vector<double>(8, 1.0)});
  CHECK(moments.size() <= 20);
  CHECK(moments.before(5)->tick == 0);
  CHECK(4999 - moments.before(4999)->tick < 10);
  CHECK(4000 - moments.before(4000)->tick < 1000);
  moments.cut(3000);
  CHECK(moments.before(5000)->tick <= 3000);
}

}  // namespace stepwire::live
