#include "engine/stepwire/simulate.hpp"

#include <fmt/format.h>

#include <atomic>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/stepwire/content.hpp"
#include "engine/stepwire/shown.hpp"

namespace stepwire {

Result simulate(const Model& model, const SimulateOptions& options) {
  std::atomic<bool> interrupt = false;
  const std::stop_callback stop(options.stop, [&] { interrupt = true; });
  std::vector<std::unique_ptr<Shown>> shown;
  codegen::GeneratedCode code{run::code_trial()};
  run::RunOptions run;
  run.interrupt = &interrupt;
  run.progress = options.progress;
  run.threads = options.threads;
  run.engine = options.engine;
  run.code = &code;
  run.numbers = model.content().kept.get();
  for (Observer* observer : options.observers) {
    shown.push_back(std::make_unique<Shown>(model.content(), *observer));
    run.observers.push_back(shown.back().get());
  }
  run::RunResult result = run::run_job(*model.content().job, run);
  return {std::move(result.recordings),
          std::move(result.faults),
          std::move(result.diagnostics),
          result.interrupted,
          result.ticks,
          result.compiled_ticks,
          code.take_problem()};
}

std::span<const double> Result::operator[](const std::string& column) const {
  std::vector<std::string> names;
  for (const record::Recording& recording : recordings) {
    if (const table::Column* found = recording.table.find(column)) return found->values;
    for (const table::Column& known : recording.table.columns) names.push_back(known.name);
  }
  throw yaml::Error(
      yaml::Fault{{}, column, "nothing of this name is recorded" + yaml::did_you_mean(column, names), {}});
}

}  // namespace stepwire
