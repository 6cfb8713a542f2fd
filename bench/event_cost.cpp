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

std::vector<Result> measure_events() {
  const Registry registry = blocks();
  codegen::GeneratedCode source{run::code_trial()};
  const subprocess::ScratchFolder folder;
  const std::string path = folder.path() + "/located.yaml", file = STEPWIRE_BENCH_DIR "/far-limits.yaml";
  io::write_file(path, io::read_file(file) + "events: locate\n");
  const plan::Plan at_ticks = plan::make_plan(diagram::Loader(registry).load_point(file, {}));
  const plan::Plan located = plan::make_plan(diagram::Loader(registry).load_point(path, {}));
  const std::size_t blocks = located.blocks.size();
  const std::string name = "nothing crosses, events: locate over events: tick";
  Steps a(located, nullptr), b(at_ticks, nullptr);
  std::vector<Result> results{{name, "interpreted", "ratio", ratio_of(a, b), blocks}};
  const auto code = source.compile(located, {}, {}), code_of_ticks = source.compile(at_ticks, {}, {});
  if (!code || !code_of_ticks) return results;
  Steps c(located, &*code), d(at_ticks, &*code_of_ticks);
  results.push_back({name, "compiled", "ratio", ratio_of(c, d), blocks});
  return results;
}

}  // namespace stepwire
