#include "bench/sweep_cost.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

#include "blocks/register.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire {

namespace {

const char* const program = "/proc/self/exe";
constexpr int tries = 3;

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Returns the resident memory after free memory was returned to the system; the peak would include earlier
/// work.
double present_megabytes() {
  malloc_trim(0);
  std::ifstream pages("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  pages >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
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

run::RunOptions options_for(codegen::GeneratedCode& code, unsigned threads) {
  run::RunOptions options;
  options.engine = run::ExecutionMode::compiled;
  options.code = &code;
  options.threads = threads;
  return options;
}

/// Returns the plan of one run that is as long as all runs of the sweep.
plan::Plan long_plan(const Registry& registry, const std::string& file, std::size_t points) {
  const std::string seconds = std::to_string(points) + " s";
  return plan::make_plan(diagram::Loader(registry).load_point(file, {{"stop", seconds}}));
}

/// Returns the increase of peak memory by the sweep, measured in a process of its own; in this one an earlier
/// peak would hide it.
double memory_in_own_process(const std::string& file) {
  const subprocess::ProcessResult result = subprocess::run_process(
      {.command = {std::filesystem::read_symlink(program).string(), sweep_memory_option, file}});
  if (!result.succeeded()) throw std::runtime_error(result.problem(sweep_memory_option));
  return std::stod(result.output);
}

/// Writes W1 with the last tick of each second recorded and 10,000 values of one gain; returns its path.
std::string w1_of_seconds(const std::string& folder) {
  const std::string path = folder + "/w1-seconds.yaml", record = "record: [";
  std::string text = io::read_file(STEPWIRE_BENCH_DIR "/w1.yaml");
  const std::size_t at = text.rfind(record), end = text.find(']', at);
  const std::string signals = text.substr(at + record.size(), end - at - record.size());
  text.replace(at, end + 1 - at, fmt::format("record: {{every: 1 s, signals: [{}]}}", signals));
  io::write_file(path, text + "sweep: {gA.gain: {from: 36, to: 36.25, count: 10000}, keep: final}\n");
  return path;
}

/// Measures a sweep of runs of one second against one run of the same total time.
std::vector<Result> against_one_run(const std::string& name, const std::string& file) {
  const Registry registry = blocks();
  codegen::GeneratedCode code{run::code_trial()};
  diagram::Loader loader(registry);
  const auto make = [&] { return run::make_job(loader, file, {}, "1 s"); };
  const run::Job job = make();
  if (run::run_job(job, options_for(code, 1)).compiled_ticks == 0) return {};
  const double memory = memory_in_own_process(file);
  const plan::Plan one = long_plan(registry, file, job.points.size());
  std::vector<double> sweep, single, once, twice;
  for (int i = 0; i < tries; ++i) {
    sweep.push_back(processor_seconds([&] { run::run_job(make(), options_for(code, 1)); }));
    single.push_back(processor_seconds([&] { run::run_plan(one, options_for(code, 1)); }));
    once.push_back(wall_seconds([&] { run::run_job(job, options_for(code, 1)); }));
    twice.push_back(wall_seconds([&] { run::run_job(job, options_for(code, 2)); }));
  }
  const auto points = static_cast<double>(job.points.size());
  const double beside = 1e6 * (median(sweep) - median(single)) / points;
  const std::size_t blocks = job.plan.diagram.blocks.size();
  return {{name + ", time over that of one long run", "compiled", "ratio", median(sweep) / median(single),
           blocks},
          {name + ", beside the ticks of each", "compiled", "us", beside, blocks},
          {name + ", beyond its rows", "compiled", "MB", memory, blocks},
          {name + ", with two threads over one", "compiled", "ratio", median(twice) / median(once), blocks}};
}

}  // namespace

double sweep_memory(const std::string& file) {
  const Registry registry = blocks();
  codegen::GeneratedCode code{run::code_trial()};
  const double before = present_megabytes();
  diagram::Loader loader(registry);
  const run::Job job = run::make_job(loader, file, {}, "1 s");
  const run::RunResult result = run::run_job(job, options_for(code, 1));
  double rows = 0.0;
  for (const table::Column& column : result.recordings.front().table.columns)
    rows += static_cast<double>(column.values.size() * sizeof(double)) / (1024.0 * 1024.0);
  return peak_megabytes() - before - rows;
}

std::vector<Result> measure_sweeps() {
  std::vector<Result> results = against_one_run("sweep of 100,000 runs", STEPWIRE_BENCH_DIR "/cart.yaml");
  const subprocess::ScratchFolder folder;
  for (Result& result : against_one_run("10,000 runs of W1", w1_of_seconds(folder.path())))
    results.push_back(std::move(result));
  return results;
}

namespace {

/// Returns a job of W1 with a sweep of one gain.
run::Job w1_sweep(diagram::Loader& loader, const std::string& folder, std::size_t points) {
  const std::string path = folder + "/w1-sweep.yaml";
  io::write_file(path, io::read_file(STEPWIRE_BENCH_DIR "/w1.yaml") +
                           fmt::format("sweep: {{gA.gain: {{from: 36, to: 36.25, count: {}}}}}\n", points));
  return run::make_job(loader, path, {}, "10 s");
}

/// Makes the steps of all runs in sequence, without anything else.
void step_alone(const plan::Plan& plan, const plan::CompiledPlan& code, std::size_t runs) {
  run::Executor run(plan);
  run.use(code);
  for (std::size_t i = 0; i < runs; ++i) {
    run.reset();
    for (std::int64_t tick = 0; tick < plan.steps; ++tick) {
      run.evaluate();
      run.advance();
    }
  }
}

}  // namespace

std::vector<Result> measure_w1_sweep() {
  const Registry registry = blocks();
  codegen::GeneratedCode source{run::code_trial()};
  diagram::Loader loader(registry);
  const subprocess::ScratchFolder folder;
  const run::Job job = w1_sweep(loader, folder.path(), 256);
  const plan::Plan& plan = job.family->plan(0);
  const auto code = source.compile(plan, job.family->variable(0), {});
  if (!code) return {};
  std::vector<double> ratios;
  for (int i = 0; i < tries; ++i) {
    const double all = processor_seconds([&] { run::run_job(job, options_for(source, 2)); });
    const double steps = processor_seconds([&] { step_alone(plan, *code, job.points.size()); });
    ratios.push_back(all / steps);
  }
  return {{"sweep of W1, time over that of its steps alone", "compiled", "ratio", median(ratios),
           plan.blocks.size()}};
}

}  // namespace stepwire
