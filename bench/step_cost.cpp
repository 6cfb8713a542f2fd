// Measures the cost of a diagram: from its text to the first step, and per step, compared with a loop written
// by hand.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "bench/agreement.hpp"
#include "bench/event_cost.hpp"
#include "bench/lane_cost.hpp"
#include "bench/load_cost.hpp"
#include "bench/look_up.hpp"
#include "bench/step_time.hpp"
#include "bench/sweep_cost.hpp"

namespace {

/// Removes "--json FILE" from the arguments and returns FILE; empty if absent.
std::string take_json(std::vector<char*>& arguments) {
  for (std::size_t i = 1; i + 1 < arguments.size(); ++i) {
    if (std::string_view(arguments[i]) != "--json") continue;
    const std::string path = arguments[i + 1];
    const auto first = arguments.begin() + static_cast<std::ptrdiff_t>(i);
    arguments.erase(first, first + 2);
    return path;
  }
  return "";
}

/// Passes arguments to Google Benchmark, after our defaults so that the caller's take precedence. Returns
/// false for an unknown one.
bool initialize_benchmark(std::vector<char*> arguments) {
  std::string in_turn = "--benchmark_enable_random_interleaving=true", repeat = "--benchmark_repetitions=7",
              shortly = "--benchmark_min_time=0.05";
  for (std::string* option : {&in_turn, &repeat, &shortly})
    arguments.insert(arguments.begin() + 1, option->data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  return !benchmark::ReportUnrecognizedArguments(count, arguments.data());
}

}  // namespace

int main(int argc, char** argv) {
  using namespace stepwire;
  if (argc == 3 && std::string_view(argv[1]) == sweep_memory_option) {
    fmt::print("{}\n", sweep_memory(argv[2]));
    return 0;
  }
  std::vector<char*> arguments(argv, argv + argc);
  const std::string json = take_json(arguments);
  if (!initialize_benchmark(arguments)) return 2;

  std::vector<Result> results = measure_load(10000, 7);
  for (const Result& result : measure_sweeps()) results.push_back(result);
  for (const Result& result : measure_w1_sweep()) results.push_back(result);
  for (const Result& result : measure_lanes()) results.push_back(result);
  for (const Result& result : measure_events()) results.push_back(result);
  for (const Result& result : measure_look_up(7)) results.push_back(result);
  for (const Result& result : results)
    fmt::print("{}: {:.3g} {}\n", result.workload, result.value, result.unit);
  if (!results_agree()) return 1;
  fmt::print("results agree with the reference values to 1e-11\n\n");
  for (const Result& result : measure_steps()) results.push_back(result);
  if (json.empty() || write_json_lines(results, json)) return 0;
  fmt::print(stderr, "{} cannot be written\n", json);
  return 3;
}
