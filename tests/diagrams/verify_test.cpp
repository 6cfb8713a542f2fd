#include "engine/simulate/replay/verify.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "engine/app/session/run_files.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "tests/diagrams/diagram_files.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/plan_text.hpp"

using namespace stepwire;

namespace {

constexpr std::size_t max_runs = 3;
constexpr std::int64_t min_steps = 100;

/// Ends runs early, after two rows of every recording.
class Hurry : public run::RunObserver {
 public:
  explicit Hurry(const plan::Plan& plan) {
    for (const diagram::RecordRequest& request : plan.diagram.records)
      steps_ = std::max(steps_, record::ticks_between_rows(plan, request));
  }

  run::Flow before_tick(const run::ObservedRun& run) override {
    return run.simulation.tick() > steps_ ? run::Flow::stop : run::Flow::go_on;
  }

 private:
  std::int64_t steps_ = min_steps;
};

}  // namespace

TEST_CASE("what every diagram leaves in its folder can be verified there") {
  for_every_job([](run::Job job) {
    const Scratch folder;
    const std::string out = folder.path("out");
    if (job.points.size() > max_runs) job.points.resize(max_runs);
    replay::write_replay(out, job);
    session::LoadedModel model;
    model.file = job.plan.diagram.file;
    model.job = std::move(job);
    Hurry hurry(model.job.plan);
    run::RunOptions options;
    options.observers = {&hurry};
    session::write_outputs(out, model, session::run_model(model, options));
    const replay::Verification verification = replay::verify(out, library());
    CHECK(verification.difference == "");
    CHECK(verification.rows > 1);
    CHECK(verification.signals > 0);
    CHECK(verification.runs == std::max<std::size_t>(1, model.job.points.size()));
  });
}
