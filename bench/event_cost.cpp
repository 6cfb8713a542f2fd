#include "bench/event_cost.hpp"

#include <algorithm>
#include <ctime>
#include <optional>
#include <string>

#include "blocks/register.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire {

namespace {

constexpr int tries = 7;
constexpr std::int64_t ticks = 500'000;

/// A run that is stepped without anything else.
class Steps {
 public:
  Steps(const plan::Plan& plan, const plan::CompiledPlan* code) : run_(plan) {
    if (code) run_.use(*code);
  }

  /// Returns the seconds of the processor for all ticks.
  double seconds() {
    run_.reset();
    const std::clock_t start = std::clock();
    for (std::int64_t tick = 0; tick < ticks; ++tick) {
      run_.evaluate();
      run_.advance();
    }
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }

 private:
  run::Executor run_;
};

/// Returns the median of the ratios of two runs by turns.
double ratio_of(Steps& one, Steps& other) {
  std::vector<double> ratios;
  for (int i = 0; i < tries; ++i) {
    const double first = one.seconds();
    ratios.push_back(first / other.seconds());
  }
  std::ranges::sort(ratios);
  return ratios[ratios.size() / 2];
}

}  // namespace

namespace {

/// A diagram in which nothing crosses.
struct Quiet {
  const char* name;
  const char* file;
  std::vector<diagram::Setting> settings;
};

/// Adds the rows of a diagram.
void add_ratios(const Quiet& quiet, std::vector<Result>& results) {
  const Registry registry = blocks();
  codegen::GeneratedCode source{run::code_trial()};
  const subprocess::ScratchFolder folder;
  const std::string path = folder.path() + "/located.yaml";
  io::write_file(path, io::read_file(quiet.file) + "\nevents: locate\n");
  const auto plan_of = [&](const std::string& file) {
    return plan::make_plan(diagram::Loader(registry).load_point(file, quiet.settings));
  };
  const plan::Plan at_ticks = plan_of(quiet.file), located = plan_of(path);
  const std::size_t blocks = located.blocks.size();
  Steps a(located, nullptr), b(at_ticks, nullptr);
  results.push_back({quiet.name, "interpreted", "ratio", ratio_of(a, b), blocks});
  const auto code = source.compile(located, {}, {}), code_of_ticks = source.compile(at_ticks, {}, {});
  if (!code || !code_of_ticks) return;
  Steps c(located, &*code), d(at_ticks, &*code_of_ticks);
  results.push_back({quiet.name, "compiled", "ratio", ratio_of(c, d), blocks});
}

}  // namespace

std::vector<Result> measure_events() {
  // The hand pushes harder than the damper holds, so that nothing turns or meets a limit.
  const Quiet pushed{"W1 pushed one way, events: locate over events: tick",
                     STEPWIRE_BENCH_DIR "/w1.yaml",
                     {{"hand.bias", "8"},
                      {"hand.amplitude", "0.1"},
                      {"v.initial", "55"},
                      {"x.initial", "50"},
                      {"z.initial", "10.2"}}};
  const Quiet limits{
      "many far limits, events: locate over events: tick", STEPWIRE_BENCH_DIR "/far-limits.yaml", {}};
  std::vector<Result> results;
  for (const Quiet& quiet : {pushed, limits}) add_ratios(quiet, results);
  return results;
}

}  // namespace stepwire
