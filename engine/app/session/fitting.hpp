#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/analyse/estimation/fit.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/monitor.hpp"
#include "engine/base/json/json.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// What a call asks of a fit, where it says so in place of the file's words.
struct FitCall {
  std::optional<std::size_t> starts, follow;
  std::optional<std::uint64_t> seed;
  unsigned threads = 0;  ///< 0: all cores
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  messages::ItemWorkers* workers = nullptr;  ///< that search from the starts; null: this process does
};

/// Finds the parameters that the file asks for. Throws Error.
estimation::FitResult fit_model(const Registry& registry, const LoadedModel& model, const FitCall& call,
                                const Monitor& monitor);

/// Searches of such a fit for another process. The model must outlive it. Throws Error.
messages::ItemWork fit_work(const Registry& registry, const LoadedModel& model, const FitCall& call);
/// How many searches there are at most, and all that decides what they find.
std::size_t most_searches(const LoadedModel& model, const FitCall& call);
std::string fit_key(const LoadedModel& model, const FitCall& call);

/// The options with what was found in the place of the file's values.
LoadOptions with_fitted(LoadOptions options, const estimation::FitResult& result);

/// A picture of a fit and the name of its files.
struct FitPicture {
  std::string name;
  plot::FigureSpec figure;
};

/// Measured and model of the worst, middle and best record of each comparison, over time and over what the
/// file names, with the residuals; the curves with their intervals; the correlations.
std::vector<FitPicture> fit_pictures(const estimation::FitRequest& request,
                                     const estimation::FitResult& result);

/// Writes fit.json, parameters.yaml and the pictures into a folder and returns the pictures' names. Throws
/// EnvironmentError.
std::vector<std::string> write_fit(const std::string& folder, const LoadedModel& model,
                                   const estimation::FitResult& result);

/// How well a record is described, in percent; of what is constant in the record there is no such number.
std::string agreement_text(const estimation::ComparedRows& rows, int width = 0);
/// All that was found, for programs.
json::Json fit_json(const LoadedModel& model, const estimation::FitResult& result);
/// What all records share, as a file that --set-from takes.
std::string parameters_text(const LoadedModel& model, const estimation::FitResult& result);

}  // namespace stepwire::session
