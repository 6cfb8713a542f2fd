#include "engine/simulate/run/lane_batcher.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "engine/model/plan/variable_blocks.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

const std::string decaying =
    "step: 10 ms\nstop: 3 s\nsolver: rk4\nparameters: {k: 1}\n"
    "blocks:\n  rate: {block: Gain, gain: $k, u: x}\n  x: {block: Integrator, u: rate, initial: 1}\n"
    "record: {every: 10 ms, signals: [x]}\n";

/// x of a run with rate -k at its end, or where it is given up.
struct Decay {
  explicit Decay(const plan::Plan& plan, std::size_t number)
      : recording(plan), simulation(plan), run{number, &simulation, &recording.recorders()} {
    static_cast<void>(simulation.set("k", std::to_string(-0.1 * static_cast<double>(number))));
    simulation.reset();
  }

  void go_alone() {
    for (; !simulation.finished(); simulation.advance()) record();
    record();
  }
  void record() {
    simulation.evaluate();
    for (record::Recorder& one : recording.recorders())
      one.record(simulation.tick(), simulation.values(), false);
  }
  std::vector<double> x() { return recording.take().front().table.find("x")->values; }

  record::RunRecording recording;
  Executor simulation;
  PendingRun run;
};

std::vector<PlanOfRuns> members_of(const plan::Plan& plan) {
  const diagram::Variation variation(plan.diagram, {"k"});
  return {{&plan, {plan::variable_blocks(plan, variation), variation.targets()}}};
}

/// Returns the results of chains of three runs each, which threads bring to a lane batch. `together` counts
/// the runs that were batched.
std::vector<std::vector<double>> meet(const plan::Plan& plan, std::size_t chains, unsigned threads,
                                      LaneReport& report, std::atomic<std::size_t>& together) {
  codegen::GeneratedCode code{run::code_trial()};
  LaneBatcher meeting(members_of(plan), LaneUse::at_once, &code, nullptr);
  std::vector<std::vector<double>> all(3 * chains);
  meeting.in_parallel(chains, threads, [&](std::size_t chain) {
    for (std::size_t i = 3 * chain; i < 3 * chain + 3; ++i) {
      Decay one(plan, i);
      if (meeting.run(0, nullptr, one.run))
        ++together;
      else
        one.go_alone();
      all[i] = one.x();
    }
  });
  report = meeting.lanes();
  return all;
}

}  // namespace

TEST_CASE("runs that threads bring one after the other meet and give what they give alone") {
  const plan::Plan plan = plan_text(decaying);
  for (const unsigned threads : {1u, 3u, 11u}) {
    LaneReport report;
    std::atomic<std::size_t> together = 0;
    const auto all = meet(plan, 11, threads, report, together);
    for (std::size_t i = 0; i < all.size(); ++i) {
      Decay alone(plan, i);
      alone.go_alone();
      CHECK(all[i] == alone.x());
    }
    INFO(report.why_not);
    if (report.count > 1) CHECK(together == all.size());
  }
}

TEST_CASE("without lanes no run waits for another") {
  const plan::Plan plan = plan_text(decaying);
  LaneBatcher meeting(members_of(plan), LaneUse::never, nullptr, nullptr);
  meeting.in_parallel(5, 5, [&](std::size_t i) {
    Decay one(plan, i);
    if (meeting.run(0, nullptr, one.run)) throw std::logic_error("a run met another one");
  });
  CHECK(meeting.threads(2) == 2);
}

TEST_CASE("a thread that fails is not waited for") {
  const plan::Plan plan = plan_text(decaying);
  codegen::GeneratedCode code{run::code_trial()};
  LaneBatcher meeting(members_of(plan), LaneUse::at_once, &code, nullptr);
  std::atomic<std::size_t> made = 0;
  const auto task = [&](std::size_t i) {
    if (i == 1) throw std::runtime_error("the second one fails");
    Decay one(plan, i);
    if (!meeting.run(0, nullptr, one.run)) one.go_alone();
    ++made;
  };
  CHECK_THROWS_WITH(meeting.in_parallel(9, 4, task), "the second one fails");
  CHECK(made == 8);
}

}  // namespace stepwire::run
