#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/analyse/estimation/fit.hpp"
#include "engine/app/cli/work.hpp"
#include "engine/base/json/json.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire {

/// What a call asks of a fit in place of the file's words.
struct FitWords {
  std::optional<std::size_t> starts, follow;
  std::optional<std::uint64_t> seed;
  unsigned threads = 0;  ///< 0: all cores
};

/// Will the fit's runs take longer than a compilation?
bool worth_compiling(const Work& work);

/// Finds the parameters that the file asks for; `progress` is told how far it is. Throws Error.
FitResult fit_quietly(const Registry& registry, const Work& work, const WorkOptions& options,
                      const FitWords& words, CodeSource* code,
                      const std::function<void(double, const std::string&)>& progress = {});
/// The same with its progress shown.
FitResult fit_visibly(const Registry& registry, const Work& work, const WorkOptions& options,
                      const FitWords& words, CodeSource* code);

/// The options with what was found in the place of the file's values.
WorkOptions with_fitted(WorkOptions options, const FitResult& result);

/// A picture of a fit and the name of its files.
struct FitPicture {
  std::string name;
  FigureSpec figure;
};

/// Measured and model of the worst, middle and best record of each comparison, over time and over what the
/// file names, with the residuals; the curves with their intervals; the correlations.
std::vector<FitPicture> fit_pictures(const FitRequest& request, const FitResult& result);

/// Writes fit.json, parameters.yaml and the pictures into a folder and returns the pictures' names. Throws
/// SurroundingsError.
std::vector<std::string> write_fit(const std::string& folder, const Work& work, const FitResult& result);

/// How well a record is described, in percent; of what is constant in the record there is no such number.
std::string agreement_text(const ComparedRows& rows, int width = 0);
/// What was found, for people.
std::string fit_text(const FitResult& result);
Json fit_json(const Work& work, const FitResult& result);
/// What all records share, as a file that --set-from takes.
std::string parameters_text(const Work& work, const FitResult& result);

/// How it went: interrupted, refused by the diagram, or done.
ExitCode code_of(const FitResult& result);

}  // namespace stepwire
