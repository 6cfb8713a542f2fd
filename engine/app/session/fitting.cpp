#include "engine/app/session/fitting.hpp"

#include "engine/base/io/file.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/view/render/figure_file.hpp"

namespace stepwire::session {

bool worth_compiling(const LoadedModel& model) {
  // What an interpreted block takes per tick, a compilation [s], and a search in steps.
  constexpr double per_block = 5e-8, compilation = 1.5, steps = 10.0;
  const run::Job& job = model.job;
  double ticks = job.points.empty() ? static_cast<double>(job.plan.steps) : 0.0;
  for (std::size_t point = 0; point < job.points.size(); ++point)
    ticks += static_cast<double>(job.plan_of(point).steps);
  const double run = per_block * ticks * static_cast<double>(job.plan.diagram.blocks.size());
  const auto runs = static_cast<double>((model.fit->parameters.size() + 1) * model.fit->starts);
  return run * runs * steps > compilation;
}

estimation::FitResult fit_model(const Registry& registry, const LoadedModel& model, const FitCall& call,
                                const Monitor& monitor) {
  estimation::FitRequest request = *model.fit;
  if (call.starts) request.starts = *call.starts;
  if (call.follow) request.follow = call.follow;
  if (call.seed) request.seed = *call.seed;
  codegen::GeneratedCode code;
  const bool compiles = call.engine == run::ExecutionMode::compiled ||
                        (call.engine == run::ExecutionMode::automatic && worth_compiling(model));
  diagram::Loader loader(registry, model.options.limits, model.options.reader);
  estimation::ModelSource source{loader, model.file, model.options.settings, compiles ? &code : nullptr,
                                 monitor.interrupt};
  if (const auto& stop = model.options.stop) source.settings.push_back({"stop", *stop, "--stop " + *stop});
  estimation::FitResult result = fit(source, model.job, request, {call.threads, monitor.progress});
  monitor.note_interpreted(code.take_problem());
  return result;
}

LoadOptions with_fitted(LoadOptions options, const estimation::FitResult& result) {
  options.settings.insert(options.settings.end(), result.shared.begin(), result.shared.end());
  if (result.of_records.size() == 1)
    options.settings.insert(options.settings.end(), result.of_records[0].begin(), result.of_records[0].end());
  options.of_points = result.of_records;
  return options;
}

std::vector<std::string> write_fit(const std::string& folder, const LoadedModel& model,
                                   const estimation::FitResult& result) {
  io::write_file(folder + "/fit.json", fit_json(model, result).text() + "\n");
  if (!result.numbers.empty()) io::write_file(folder + "/parameters.yaml", parameters_text(model, result));
  std::vector<std::string> names;
  for (const FitPicture& picture : fit_pictures(*model.fit, result)) {
    names.push_back(picture.name + ".svg");
    render::write_figure(folder, picture.name, picture.figure);
  }
  return names;
}

}  // namespace stepwire::session
