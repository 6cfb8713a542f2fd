#include "bench/step_time.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>
#include <utility>

#include "bench/hand_written.hpp"
#include "bench/workload.hpp"
#include "engine/record/recorder.hpp"
#include "engine/run/simulation.hpp"

namespace stepwire {

namespace {

/// Steps a diagram with its 8 signals recorded and the finite check on.
void run_diagram(benchmark::State& bench, const Plan& plan) {
  Simulation simulation(plan);
  Recorder recorder(plan, plan.diagram.records.front());
  const Workspace start = simulation.workspace();
  for (auto _ : bench) {
    if (simulation.finished()) {
      bench.PauseTiming();
      simulation.restore(start);
      recorder = Recorder(plan, plan.diagram.records.front());
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

/// What is timed, and what came of it.
class Steps : public benchmark::ConsoleReporter {
 public:
  /// One workload by all means.
  template <class HandWritten>
  void add(const std::string& workload, Plan plan, const HandWritten& by_hand) {
    const std::size_t blocks = plan.diagram.blocks.size();
    add_loop({workload, "by hand", "ns per step", 0.0, blocks},
             [by_hand](benchmark::State& bench) { run_by_hand(bench, by_hand); });
    add_loop({workload, "interpreted", "ns per step", 0.0, blocks},
             [plan = std::move(plan)](benchmark::State& bench) { run_diagram(bench, plan); });
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
      results_.back().value = run.GetAdjustedCPUTime();  // waiting for a busy processor is no cost
    }
  }

  std::map<std::string, Result> loops_;  ///< by the names of benchmarks
  std::vector<Result> results_;
};

}  // namespace

std::vector<Result> measure_steps() {
  Steps steps;
  steps.add("W1", w1_plan(), HandWrittenW1());
  for (const int blocks : {10, 100, 1000, 10000})
    steps.add(fmt::format("W2 {}", blocks), w2_plan(blocks, 1000), HandWrittenW2(blocks));
  benchmark::RunSpecifiedBenchmarks(&steps);
  return steps.results();
}

}  // namespace stepwire
