#include "engine/simulate/run/run_meeting.hpp"

#include <catch2/catch.hpp>
#include <cstring>

#include "engine/base/parallel/parallel.hpp"
#include "engine/model/plan/variable_blocks.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

const std::string decaying =
    "step: 10 ms\nstop: 3 s\nsolver: rk4\nparameters: {k: 1}\n"
    "blocks:\n  rate: {block: Gain, gain: $k, u: x}\n  x: {block: Integrator, u: rate, initial: 1}\n"
    "record: {every: 10 ms, signals: [x]}\n";

/// x of a run with rate -k at its end, or where it is given up.
struct Decay {
  explicit Decay(const plan::Plan& plan, std::size_t number) : recording(plan) {
    run.simulation = std::make_unique<Executor>(plan);
    static_cast<void>(run.simulation->set("k", std::to_string(-0.1 * static_cast<double>(number))));
    run.simulation->reset();
    run.recorders = &recording.recorders();
  }

  void go_alone() {
    for (; !run.simulation->finished(); run.simulation->advance()) record();
    record();
  }
  void record() {
    run.simulation->evaluate();
    for (record::Recorder& one : *run.recorders)
      one.record(run.simulation->tick(), run.simulation->values(), false);
  }
  std::vector<double> x() { return recording.take().front().table.find("x")->values; }

  record::RunRecording recording;
  SweptRun run{};
};

TogetherRuns::Members members_of(const plan::Plan& plan) {
  const diagram::Variation variation(plan.diagram, {"k"});
  return {{&plan, {plan::variable_blocks(plan, variation), variation.targets()}}};
}

/// What chains of runs give that meet, each of several runs one after the other, and whether all met.
std::vector<std::vector<double>> meet(const plan::Plan& plan, std::size_t chains, unsigned threads,
                                      LaneReport& report, std::atomic<std::size_t>& together) {
  codegen::GeneratedCode code;
  RunMeeting meeting(members_of(plan), LaneUse::at_once, &code, nullptr);
  std::vector<std::vector<double>> all(3 * chains);
  RunMeeting::Items items(meeting, chains, threads);
  parallel::in_parallel(chains, threads, [&](std::size_t chain) {
    for (std::size_t i = 3 * chain; i < 3 * chain + 3; ++i) {
      Decay one(plan, i);
      if (meeting.run(0, nullptr, one.run))
        ++together;
      else
        one.go_alone();
      all[i] = one.x();
    }
    items.done();
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
  RunMeeting meeting(members_of(plan), LaneUse::never, nullptr, nullptr);
  const RunMeeting::Items items(meeting, 5, 5);
  Decay one(plan, 1);
  CHECK_FALSE(meeting.run(0, nullptr, one.run));
  CHECK(meeting.threads(2) == 2);
}

}  // namespace stepwire::run
