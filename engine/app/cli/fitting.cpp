#include "engine/app/cli/fitting.hpp"

#include <filesystem>

#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/progress.hpp"
#include "engine/base/io/file.hpp"
#include "engine/view/render/figure_file.hpp"

namespace stepwire {

bool worth_compiling(const Work& work) {
  // What an interpreted block takes per tick, a compilation [s], and a search in steps.
  constexpr double per_block = 5e-8, compilation = 1.5, steps = 10.0;
  const Job& job = work.job;
  double ticks = job.points.empty() ? static_cast<double>(job.plan.steps) : 0.0;
  for (std::size_t point = 0; point < job.points.size(); ++point)
    ticks += static_cast<double>(job.plan_of(point).steps);
  const double run = per_block * ticks * static_cast<double>(job.plan.diagram.blocks.size());
  const auto runs = static_cast<double>((work.fit->parameters.size() + 1) * work.fit->starts);
  return run * runs * steps > compilation;
}

FitResult fit_quietly(const Registry& registry, const Work& work, const WorkOptions& options,
                      const FitWords& words, CodeSource* code,
                      const std::function<void(double, const std::string&)>& progress) {
  FitRequest request = *work.fit;
  if (words.starts) request.starts = *words.starts;
  if (words.follow) request.follow = words.follow;
  if (words.seed) request.seed = *words.seed;
  Loader loader(registry, options.limits);
  ModelSource source{loader, work.file, options.settings, code, &interrupted()};
  if (options.stop) source.settings.push_back({"stop", *options.stop, "--stop " + *options.stop});
  return fit(source, work.job, request, {words.threads, progress});
}

FitResult fit_visibly(const Registry& registry, const Work& work, const WorkOptions& options,
                      const FitWords& words, CodeSource* code) {
  Progress progress("fit " + std::filesystem::path(work.file).filename().string());
  return fit_quietly(registry, work, options, words, code,
                     [&](double fraction, const std::string& what) { progress.show(fraction, what); });
}

WorkOptions with_fitted(WorkOptions options, const FitResult& result) {
  options.settings.insert(options.settings.end(), result.shared.begin(), result.shared.end());
  if (result.of_records.size() == 1)
    options.settings.insert(options.settings.end(), result.of_records[0].begin(), result.of_records[0].end());
  options.of_points = result.of_records;
  return options;
}

std::vector<std::string> write_fit(const std::string& folder, const Work& work, const FitResult& result) {
  write_file(folder + "/fit.json", fit_json(work, result).text() + "\n");
  if (!result.numbers.empty()) write_file(folder + "/parameters.yaml", parameters_text(work, result));
  std::vector<std::string> names;
  for (const FitPicture& picture : fit_pictures(*work.fit, result)) {
    names.push_back(picture.name + ".svg");
    write_figure(folder, picture.name, picture.figure);
  }
  return names;
}

ExitCode code_of(const FitResult& result) {
  if (result.interrupted) return ExitCode::interrupted;
  return result.refused ? ExitCode::wrong : ExitCode::done;
}

}  // namespace stepwire
