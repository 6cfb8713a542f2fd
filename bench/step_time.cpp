#include "bench/step_time.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <deque>
#include <map>
#include <utility>

#include "bench/hand_written.hpp"
#include "bench/workload.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire {

namespace {

/// Steps a diagram with its 8 signals recorded and the finite check on; with compiled code if given.
void run_diagram(benchmark::State& bench, const plan::Plan& plan, const plan::CompiledPlan* code = nullptr) {
  run::Executor simulation(plan);
  if (code) simulation.use(*code);
  record::RunRecording recording(plan);
  record::Recorder& recorder = recording.recorders().front();
  const run::Workspace start = simulation.workspace();
  for (auto _ : bench) {
    if (simulation.finished()) {
      bench.PauseTiming();
      simulation.restore(start);
      recorder.go_back_to(0);
      bench.ResumeTiming();
    }
    simulation.evaluate();
    recorder.record(simulation.tick(), simulation.values());
    simulation.advance();
  }
}

template <class HandWritten>
void run_by_hand(benchmark::State& bench, HandWritten loop) {
  for (auto _ : bench) {
    loop.step();
    benchmark::ClobberMemory();
  }
}

/// The benchmarks of steps, and their results.
class Steps : public benchmark::ConsoleReporter {
 public:
  /// Adds one workload by all methods.
  template <class HandWritten2, class HandWritten3>
  void add(const std::string& workload, const plan::Plan& plan, const HandWritten2& by_hand,
           const HandWritten3& by_hand_O3) {
    const std::size_t blocks = plan.diagram.blocks.size();
    add_loop({workload, "by hand", "ns per step", 0.0, blocks},
             [by_hand](benchmark::State& bench) { run_by_hand(bench, by_hand); });
    add_loop({workload, "by hand, -O3", "ns per step", 0.0, blocks},
             [by_hand_O3](benchmark::State& bench) { run_by_hand(bench, by_hand_O3); });
    add_loop({workload, "interpreted", "ns per step", 0.0, blocks},
             [&plan](benchmark::State& bench) { run_diagram(bench, plan); });
    const std::optional<plan::CompiledPlan> code = source_.compile(plan, {}, {});
    if (!code) fmt::print(stderr, "{} is not generated: {}\n", workload, source_.take_problem());
    if (code)
      add_loop({workload, "generated", "ns per step", 0.0, blocks},
               [&plan, code](benchmark::State& bench) { run_diagram(bench, plan, &*code); });
  }

  const std::vector<Result>& results() const { return results_; }

 private:
  template <class Loop>
  void add_loop(const Result& what, Loop loop) {
    const std::string name = what.workload + " " + what.by;
    loops_[name] = what;
    benchmark::RegisterBenchmark(name.c_str(), std::move(loop));
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      results_.push_back(loops_.at(run.run_name.function_name));
      results_.back().value = run.GetAdjustedCPUTime();  // excludes waiting
    }
  }

  codegen::GeneratedCode source_{run::code_trial()};
  std::map<std::string, Result> loops_;  ///< Prototypes of results by the names of benchmarks.
  std::vector<Result> results_;
};

}  // namespace

std::vector<Result> measure_steps() {
  Steps steps;
  std::deque<plan::Plan> plans{w1_plan()};  // a deque, for stable addresses
  steps.add("W1", plans.back(), HandWrittenW1<2>(), HandWrittenW1<3>());
  for (const int blocks : {10, 100, 1000, 10000})
    steps.add(fmt::format("W2 {}", blocks), plans.emplace_back(w2_plan(blocks, 1000)),
              HandWrittenW2<2>(blocks), HandWrittenW2<3>(blocks));
  benchmark::RunSpecifiedBenchmarks(&steps);
  return steps.results();
}

}  // namespace stepwire
