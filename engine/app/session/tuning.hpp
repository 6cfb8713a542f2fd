#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/tuning/tune.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/monitor.hpp"
#include "engine/base/json/json.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// What a call sets of a tuning, in place of the file's values.
struct TuneCall {
  std::optional<std::size_t> starts{}, evaluations{};
  std::optional<std::size_t> experiments{};  ///< of one evaluation of a study
  std::optional<std::uint64_t> seed{};
  unsigned threads = 0;  ///< 0: all cores
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  messages::ItemWorkers* workers = nullptr;  ///< that search from the starts; null: this process does
};

/// Finds the parameters that the file's section `tune` asks for. Throws Error.
tuning::TuneResult tune_model(const Registry& registry, const LoadedModel& model, const TuneCall& call,
                              const Monitor& monitor);

/// Searches of such a tuning for another process. The model must outlive it. Throws Error.
messages::ItemWork tune_work(const Registry& registry, const LoadedModel& model, const TuneCall& call);
/// How many searches there are, and all that decides what they find.
std::size_t most_searches(const LoadedModel& model, const TuneCall& call);
std::string tune_key(const LoadedModel& model, const TuneCall& call);

/// The options with what was found in the place of the file's values.
LoadOptions with_tuned(LoadOptions options, const tuning::TuneResult& result);

/// The objective of all evaluations and the best so far, and below it the parameters of the best.
plot::FigureSpec tune_figure(const LoadedModel& model, const tuning::TuneResult& result);

/// Writes tune.json, tune-history.csv, parameters.yaml where all claims hold, and tune-history.svg unless the
/// tuning was interrupted, into a folder. Throws EnvironmentError.
void write_tune(const std::string& folder, const LoadedModel& model, const tuning::TuneResult& result);

/// All that was found, for programs.
json::Json tune_json(const LoadedModel& model, const tuning::TuneResult& result);
/// Each evaluation as a row: its start, whether it ran and holds all claims, the parameters, the objective
/// and the margin of each claim. Cells of what there is none of are nan.
std::string history_csv(const LoadedModel& model, const tuning::TuneResult& result);
/// What was found, as a file that --set-from takes.
std::string parameters_text(const LoadedModel& model, const tuning::TuneResult& result);

}  // namespace stepwire::session
