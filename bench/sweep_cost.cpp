#include "bench/sweep_cost.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>

#include "blocks/register.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire {

namespace {

const char* const file = STEPWIRE_BENCH_DIR "/cart.yaml";
constexpr int tries = 3;

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double processor_seconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double wall_seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

RunOptions options_for(GeneratedCode& code, unsigned threads) {
  RunOptions options;
  options.engine = Engine::compiled;
  options.code = &code;
  options.threads = threads;
  return options;
}

/// One run of as many seconds as the sweep has runs of one.
Plan long_plan(const Registry& registry, std::size_t points) {
  const std::string seconds = std::to_string(points) + " s";
  return make_plan(Loader(registry).load_point(file, {{"stop", seconds}}));
}

}  // namespace

std::vector<Result> measure_sweep() {
  const Registry registry = blocks();
  GeneratedCode code;
  const double before = peak_megabytes();
  Loader loader(registry);
  const Job job = make_job(loader, file);
  RunResult first = run_job(job, options_for(code, 1));
  double rows = 0.0;
  for (const Column& column : first.recordings.front().table.columns)
    rows += static_cast<double>(column.values.size() * sizeof(double)) / (1024.0 * 1024.0);
  const double memory = peak_megabytes() - before - rows;
  if (first.compiled_ticks == 0) return {};
  const Plan one = long_plan(registry, job.points.size());
  std::vector<double> sweep, single, once, twice;
  for (int i = 0; i < tries; ++i) {
    sweep.push_back(processor_seconds([&] { run_job(make_job(loader, file), options_for(code, 1)); }));
    single.push_back(processor_seconds([&] { run_plan(one, options_for(code, 1)); }));
    once.push_back(wall_seconds([&] { run_job(job, options_for(code, 1)); }));
    twice.push_back(wall_seconds([&] { run_job(job, options_for(code, 2)); }));
  }
  const auto points = static_cast<double>(job.points.size());
  const double beside = 1e6 * (median(sweep) - median(single)) / points;
  const std::string name = "sweep of 100,000 runs";
  const std::size_t blocks = job.plan.diagram.blocks.size();
  return {{name + ", time over that of one long run", "compiled", "ratio", median(sweep) / median(single),
           blocks},
          {name + ", beside the ticks of each", "compiled", "us", beside, blocks},
          {name + ", beyond its rows", "compiled", "MB", memory, blocks},
          {name + ", with two threads over one", "compiled", "ratio", median(twice) / median(once), blocks}};
}

}  // namespace stepwire
