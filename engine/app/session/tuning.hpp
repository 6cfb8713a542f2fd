#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/analyse/tuning/tune.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/monitor.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// Options of an optimisation; values that are set replace those of the file.
struct TuneCall {
  std::optional<std::size_t> starts{}, evaluations{};
  std::optional<std::size_t> experiments{};  ///< experiments of a study per evaluation
  std::optional<std::uint64_t> seed{};
  unsigned threads = 0;  ///< 0: all cores
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  messages::ItemWorkers* workers = nullptr;  ///< processes that search; nullptr: this process
};

/// Optimises the parameters of the section `tune`. Throws Error.
tuning::TuneResult tune_model(const Registry& registry, const LoadedModel& model, const TuneCall& call,
                              const Monitor& monitor);

/// Returns the searches of such an optimisation as work items for another process. The model must outlive
/// them. Throws Error.
messages::ItemWork tune_work(const Registry& registry, const LoadedModel& model, const TuneCall& call);
/// Returns the number of searches, and a key of everything that determines their results.
std::size_t most_searches(const LoadedModel& model, const TuneCall& call);
std::string tune_key(const LoadedModel& model, const TuneCall& call);

/// Returns the options with the optimised values in place of those of the file.
LoadOptions with_tuned(LoadOptions options, const tuning::TuneResult& result);

/// Returns a figure with the objective of all evaluations and the best so far, and with the parameters of the
/// best ones.
plot::FigureSpec tune_figure(const LoadedModel& model, const tuning::TuneResult& result);

/// Writes tune.json and tune-history.csv into a folder; parameters.yaml if all claims hold; tune-history.svg
/// unless interrupted. Throws EnvironmentError.
void write_tune(const std::string& folder, const LoadedModel& model, const tuning::TuneResult& result);

/// Returns a row for each evaluation: its start, two flags (it ran, it is feasible), the parameters, the
/// objective and the margin of each claim. Missing values are NaN.
std::string history_csv(const LoadedModel& model, const tuning::TuneResult& result);

}  // namespace stepwire::session
