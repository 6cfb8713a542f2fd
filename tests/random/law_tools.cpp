#include "tests/random/law_tools.hpp"

#include <fmt/format.h>

namespace stepwire::random {

Verdict verdict_of(const std::string& difference) {
  return {difference.empty() ? Verdict::Kind::same : Verdict::Kind::different, difference};
}

Verdict skipped(const std::string& why) {
  return {Verdict::Kind::skipped, why};
}

run::RunResult run(const Loaded& loaded, run::RunOptions options) {
  options.threads = 1;
  return run::run_job(loaded.all(), options);
}

run::RunResult one_by_one(const Loaded& sweep) {
  run::RunOptions options;
  options.lanes = run::LaneUse::never;
  return run(sweep, options);
}

/// "p1" and texts of its values; its number is the first thing in the text.
std::vector<std::string> swept_values(const Key& parameter) {
  std::size_t end = 0;
  const double value = std::stod(parameter.value, &end);
  std::vector<std::string> values;
  for (const double factor : {1.0, 1.03, 0.97, 0.9, 1.05})
    values.push_back(fmt::format("{}{}", value * factor, parameter.value.substr(end)));
  return values;
}

Dice dice_of(const Trial& trial, std::uint64_t law) {
  return Dice(trial.seed * 64 + law);
}

const Key& swept_parameter(const Trial& trial) {
  const auto& all = trial.sketch.parameters;
  return all[trial.seed % all.size()];
}

std::unique_ptr<Loaded> sweep_of(const Trial& trial) {
  Sketch sketch = trial.sketch;
  const Key& parameter = swept_parameter(trial);
  std::string list;
  for (const std::string& value : swept_values(parameter)) list += (list.empty() ? "" : ", ") + value;
  sketch.head.push_back({"sweep", fmt::format("{{{}: [{}]}}", parameter.name, list)});
  return std::make_unique<Loaded>(*trial.registry, sketch, trial.folder);
}

}  // namespace stepwire::random
