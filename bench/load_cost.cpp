#include "bench/load_cost.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <ctime>

#include "bench/workload.hpp"
#include "blocks/register.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire {

namespace {

double milliseconds_to_first_step(const Registry& registry, const std::string& text) {
  const std::clock_t start = std::clock();
  diagram::Loader loader(registry);
  const plan::Plan plan = plan::make_plan(loader.load_text(text, "w2.yaml"));
  run::Executor simulation(plan);
  simulation.evaluate();
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace

std::vector<Result> measure_load(int blocks, int times) {
  const Registry registry = stepwire::blocks();
  const std::string text = w2_text(blocks, 5);
  const Result result{fmt::format("text of W2 {} to first step", blocks), "interpreted", "ms", 0.0,
                      static_cast<std::size_t>(blocks) + 2};
  std::vector<Result> results;
  for (int i = 0; i < times; ++i) {
    results.push_back(result);
    results.back().value = milliseconds_to_first_step(registry, text);
    if (i > 0) continue;
    results.push_back(result);
    results.back().unit = "MB";
    results.back().value = peak_megabytes();
  }
  return results;
}

}  // namespace stepwire
