// Cost of one step: W1 and W2 as diagrams and by hand, in one program, interleaved. Agreement with the
// reference values comes first: a fast wrong answer is no result.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <map>
#include <vector>

#include "bench/hand_written.hpp"
#include "bench/workload.hpp"
#include "blocks/register.hpp"
#include "engine/record/recorder.hpp"
#include "engine/run/run.hpp"

namespace stepwire {

namespace {

const Registry& registry() {
  static const Registry blocks = all_blocks();
  return blocks;
}

Plan w1_plan() {
  Loader loader(registry());
  return make_plan(loader.load(w1_file()));
}

Plan w2_plan(int blocks, int steps) {
  Loader loader(registry());
  return make_plan(loader.load_text(w2_text(blocks, steps), "w2.yaml"));
}

bool agree(const std::string& what, double value, double reference) {
  const bool good = std::abs(value - reference) <= 1e-11 * std::abs(reference);
  if (!good) fmt::print("{}: {:.16g} where {:.16g} is right\n", what, value, reference);
  return good;
}

double state(const Simulation& simulation, const std::string& name) {
  const auto& blocks = simulation.plan().diagram.blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (blocks[b].name == name) return simulation.values()[simulation.plan().blocks[b].states[0].offset];
  return std::nan("");
}

void go(Simulation& simulation, std::int64_t steps) {
  for (std::int64_t i = 0; i < steps; ++i) {
    simulation.evaluate();
    simulation.advance();
  }
}

bool w1_agrees() {
  const std::map<int, std::vector<double>> reference = {
      {2000, {-22.0660615859992, 0.500905335020262, 1.10514893010915, 0.273227421053629}},
      {100000, {-23.1581554834532, 0.500891457269049, 1.10514961942006, 0.273227418748788}}};
  const Plan plan = w1_plan();
  bool good = true;
  for (const auto& [steps, values] : reference) {
    Simulation simulation(plan);
    go(simulation, steps);
    HandWrittenW1 by_hand;
    for (int i = 0; i < steps; ++i) by_hand.step();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string name = std::vector<std::string>{"x", "v", "z", "amp"}[i];
      good = agree(fmt::format("W1 {} after {}", name, steps), state(simulation, name), values[i]) && good;
      good = agree(fmt::format("W1 by hand {} after {}", name, steps), by_hand.state()[i], values[i]) && good;
    }
  }
  return good;
}

bool w2_agrees() {
  const std::vector<std::tuple<int, int, double>> reference = {{10, 1000, -0.0748070793824835},
                                                               {100, 300, 1.62651668141925},
                                                               {1000, 40, 0.395875330268821},
                                                               {10000, 5, 0.0627443518970763}};
  bool good = true;
  for (const auto& [blocks, steps, sum] : reference) {
    const Plan plan = w2_plan(blocks, steps);
    Simulation simulation(plan);
    go(simulation, steps);
    double total = 0.0;
    for (int j = 0; j < blocks / 5; ++j) total += state(simulation, fmt::format("x{}", j));
    HandWrittenW2 by_hand(blocks);
    for (int i = 0; i < steps; ++i) by_hand.step();
    good = agree(fmt::format("W2 N = {}", blocks), total, sum) && good;
    good = agree(fmt::format("W2 by hand N = {}", blocks), by_hand.sum(), sum) && good;
  }
  return good;
}

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

/// Keeps the median of each benchmark for the table of ratios.
class Medians : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.aggregate_name == "median") nanoseconds[run.run_name.function_name] = run.GetAdjustedRealTime();
  }
  std::map<std::string, double> nanoseconds;
};

void add_benchmarks(std::vector<Plan>& plans, const std::vector<int>& sizes) {
  plans.reserve(sizes.size() + 1);
  const Plan& w1 = plans.emplace_back(w1_plan());
  benchmark::RegisterBenchmark("W1", [&w1](benchmark::State& bench) { run_diagram(bench, w1); });
  benchmark::RegisterBenchmark("W1 by hand",
                               [](benchmark::State& bench) { run_by_hand(bench, HandWrittenW1()); });
  for (int size : sizes) {
    const Plan& w2 = plans.emplace_back(w2_plan(size, 1000));
    benchmark::RegisterBenchmark(fmt::format("W2 {}", size).c_str(),
                                 [&w2](benchmark::State& bench) { run_diagram(bench, w2); });
    benchmark::RegisterBenchmark(fmt::format("W2 {} by hand", size).c_str(), [size](benchmark::State& bench) {
      run_by_hand(bench, HandWrittenW2(size));
    });
  }
}

void print_ratios(std::map<std::string, double>& ns, const std::vector<int>& sizes) {
  fmt::print("| workload | ns per step | by hand | ratio | ns per block and step |\n|---|---|---|---|---|\n");
  const auto row = [&](const std::string& name, int blocks) {
    const double mine = ns[name], hand = ns[name + " by hand"];
    fmt::print("| {} | {:.0f} | {:.0f} | {:.2f} | {:.2f} |\n", name, mine, hand, mine / hand, mine / blocks);
  };
  row("W1", 35);
  for (int size : sizes) row(fmt::format("W2 {}", size), size + 2);
  fmt::print("\ncost per block, N = 10000 / N = 1000: {:.2f}\n",
             ns["W2 10000"] / 10002 / (ns["W2 1000"] / 1002));
}

void print_load() {
  const std::string text = w2_text(10000, 5);
  std::vector<double> seconds;
  for (int i = 0; i < 7; ++i) {
    const auto start = std::chrono::steady_clock::now();
    Loader loader(registry());
    const Plan plan = make_plan(loader.load_text(text, "w2.yaml"));
    Simulation simulation(plan);
    simulation.evaluate();
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    if (i == 0) {
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      fmt::print("10,000 blocks: peak memory of the process {:.1f} MB\n",
                 static_cast<double>(usage.ru_maxrss) / 1024.0);
    }
  }
  std::sort(seconds.begin(), seconds.end());
  fmt::print("10,000 blocks: text to first step {:.0f} ms (median of {})\n\n",
             1000.0 * seconds[seconds.size() / 2], seconds.size());
}

}  // namespace

}  // namespace stepwire

int main(int argc, char** argv) {
  using namespace stepwire;
  print_load();
  if (!w1_agrees() || !w2_agrees()) return 1;
  fmt::print("results agree with the reference values to 1e-11\n\n");
  const std::vector<int> sizes = {10, 100, 1000, 10000};
  std::vector<Plan> plans;
  add_benchmarks(plans, sizes);
  std::vector<char*> arguments(argv, argv + argc);
  std::string interleave = "--benchmark_enable_random_interleaving=true",
              repeat = "--benchmark_repetitions=7", shortly = "--benchmark_min_time=0.05";
  for (std::string* option : {&interleave, &repeat, &shortly})
    arguments.insert(arguments.begin() + 1, option->data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  print_ratios(medians.nanoseconds, sizes);
  return 0;
}
