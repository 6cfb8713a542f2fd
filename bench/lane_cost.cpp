#include "bench/lane_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>

#include "bench/workload.hpp"
#include "blocks/register.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/model/plan/variable_blocks.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/lane_group.hpp"

namespace stepwire {

namespace {

constexpr int tries = 25;
constexpr std::int64_t ticks = 20'000;

double seconds_of(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A diagram with one value that differs between runs.
struct Workload {
  std::string name;
  plan::Plan plan;
  std::string varies;  ///< Name of the value: "spring.gain".
  double from;
  std::string unit;
};

/// Runs of a workload, in lanes or a single one, from time 0.
class Runs {
 public:
  Runs(const Workload& of, int count) {
    for (int i = 0; i < count; ++i) {
      runs_.push_back(std::make_unique<run::Executor>(of.plan));
      static_cast<void>(
          runs_.back()->set(of.varies, fmt::format("{} {}", of.from * (1.0 + 1e-4 * i), of.unit)));
      runs_.back()->reset();
      recordings_.push_back(std::make_unique<record::RunRecording>(of.plan));
    }
  }

  void step_alone(const plan::CompiledPlan& code) {
    run::Executor& run = *runs_.front();
    std::vector<record::Recorder>& recorders = recordings_.front()->recorders();
    run.reset();
    run.use(code);
    for (record::Recorder& recorder : recorders) recorder.go_back_to(0);
    for (std::int64_t tick = 0; tick < ticks; ++tick) {
      run.evaluate();
      for (record::Recorder& recorder : recorders) recorder.record(tick, run.values());
      run.advance();
    }
  }

  void step_together(const plan::CompiledLanes& code) {
    std::vector<run::LaneGroup::Run> lanes;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      lanes.push_back({runs_[i].get(), &recordings_[i]->recorders()});
      runs_[i]->reset();
      for (record::Recorder& recorder : recordings_[i]->recorders()) recorder.go_back_to(0);
    }
    run::LaneGroup group(code, lanes);
    while (group.goes_on()) group.step(run::LaneGroup::ticks_at_once);
  }

 private:
  std::vector<std::unique_ptr<run::Executor>> runs_;
  std::vector<std::unique_ptr<record::RunRecording>> recordings_;
};

std::vector<Result> measure(codegen::GeneratedCode& source, Workload of) {
  of.plan.steps = ticks;
  const diagram::Variation variation(of.plan.diagram, {of.varies});
  const plan::RunDifferences differences{plan::variable_blocks(of.plan, variation), variation.targets()};
  std::string why;
  const auto lanes = source.compile_lanes(of.plan, differences, {}, why);
  const auto code = source.compile(of.plan, differences.variable, {});
  if (!lanes || !code) {
    fmt::print(stderr, "{} has no lanes: {}\n", of.name, why);
    return {};
  }
  Runs one(of, 1), all(of, lanes->lanes);
  double alone = 1e9, together = 1e9;  // minimum: other load only adds time
  for (int i = 0; i < tries; ++i) {
    alone = std::min(alone, seconds_of([&] { one.step_alone(*code); }));
    together = std::min(together, seconds_of([&] { all.step_together(*lanes); }));
  }
  const std::string name = fmt::format("{} in {} lanes", of.name, lanes->lanes);
  const double per_step = 1e9 * together / static_cast<double>(ticks * lanes->lanes);
  const std::size_t blocks = of.plan.diagram.blocks.size();
  return {{name + ", step of a run", "compiled", "ns", per_step, blocks},
          {name + ", over one run alone", "compiled", "ratio", together / alone / lanes->lanes, blocks}};
}

}  // namespace

std::vector<Result> measure_lanes() {
  const Registry registry = blocks();
  const auto plan_of = [&](const std::string& file) {
    return plan::make_plan(diagram::Loader(registry).load(STEPWIRE_BENCH_DIR "/" + file));
  };
  codegen::GeneratedCode source{run::code_trial()};
  std::vector<Result> results;
  for (auto&& workload : {Workload{"W1", w1_plan(), "gA.gain", 36.0, ""},
                          Workload{"W2 100", w2_plan(100, static_cast<int>(ticks)), "g0.gain", 1.0, ""},
                          Workload{"formulas", plan_of("formulas.yaml"), "scaled.gain", 1.0, ""},
                          Workload{"figure 14", plan_of("../diagrams/thesis/fig14-controller-1d.yaml"),
                                   "hand.gain", 2000.0, "N/m"}})
    for (const Result& result : measure(source, workload)) results.push_back(result);
  return results;
}

}  // namespace stepwire
