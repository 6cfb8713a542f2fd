#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/analyse/estimation/fit.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/monitor.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// Options of a fit; values that are set replace those of the file.
struct FitCall {
  std::optional<std::size_t> starts, follow;
  std::optional<std::uint64_t> seed;
  unsigned threads = 0;  ///< 0: all cores
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  messages::ItemWorkers* workers = nullptr;  ///< processes that search; nullptr: this process
};

/// Estimates the parameters of the section `fit`. Throws Error.
estimation::FitResult fit_model(const Registry& registry, const LoadedModel& model, const FitCall& call,
                                const Monitor& monitor);

/// Returns the searches of such a fit as work items for another process. The model must outlive them. Throws
/// Error.
messages::ItemWork fit_work(const Registry& registry, const LoadedModel& model, const FitCall& call);
/// Returns the largest number of searches, and a key of everything that determines their results.
std::size_t most_searches(const LoadedModel& model, const FitCall& call);
std::string fit_key(const LoadedModel& model, const FitCall& call);

/// Returns the options with the fitted values in place of those of the file.
LoadOptions with_fitted(LoadOptions options, const estimation::FitResult& result);

/// Figure of a fit and the stem of its file names.
struct FitPicture {
  std::string name;
  plot::FigureSpec figure;
};

/// Returns the figures of a fit. For each comparison they show model, measurement and residuals of the worst,
/// the median and the best record, over time and over the named quantities. Then follow the curves with their
/// intervals, and the correlations.
std::vector<FitPicture> fit_pictures(const estimation::FitRequest& request,
                                     const estimation::FitResult& result);

/// Writes fit.json, parameters.yaml and the pictures into a folder, and returns the names of the pictures.
/// Throws EnvironmentError.
std::vector<std::string> write_fit(const std::string& folder, const LoadedModel& model,
                                   const estimation::FitResult& result);

/// Formats the agreement of model and record in percent; it is undefined for a constant record.
std::string agreement_text(const estimation::ComparedRows& rows, int width = 0);
/// Returns the shared fitted values as text of a file for --set-from.
std::string parameters_text(const estimation::FitResult& result);

}  // namespace stepwire::session
