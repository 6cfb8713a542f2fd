#include "engine/app/session/fitting.hpp"

#include <fmt/format.h>

#include "engine/analyse/estimation/search_items.hpp"
#include "engine/app/session/build_note.hpp"
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

namespace {

estimation::FitRequest request_of(const LoadedModel& model, const FitCall& call) {
  estimation::FitRequest request = *model.fit;
  if (call.starts) request.starts = *call.starts;
  if (call.follow) request.follow = call.follow;
  if (call.seed) request.seed = *call.seed;
  return request;
}

/// What the runs of a fit are made of.
struct FitRuns {
  FitRuns(const Registry& registry, const LoadedModel& model, const FitCall& call,
          const std::atomic<bool>* interrupt)
      : request(request_of(model, call)),
        loader(registry, model.options.limits, model.options.reader),
        source{loader, model.file, model.options.settings, nullptr, interrupt} {
    const bool compiles = call.engine == run::ExecutionMode::compiled ||
                          (call.engine == run::ExecutionMode::automatic && worth_compiling(model));
    if (compiles) source.code = &code;
    if (const auto& stop = model.options.stop) source.settings.push_back({"stop", *stop, "--stop " + *stop});
  }

  estimation::FitRequest request;
  codegen::GeneratedCode code;
  diagram::Loader loader;
  estimation::ModelSource source;
};

}  // namespace

estimation::FitResult fit_model(const Registry& registry, const LoadedModel& model, const FitCall& call,
                                const Monitor& monitor) {
  FitRuns runs(registry, model, call, monitor.interrupt);
  estimation::FitResult result =
      fit(runs.source, model.job, runs.request, {call.threads, monitor.progress, call.workers});
  monitor.note_interpreted(runs.code.take_problem());
  return result;
}

messages::ItemWork fit_work(const Registry& registry, const LoadedModel& model, const FitCall& call) {
  const auto runs = std::make_shared<FitRuns>(registry, model, call, nullptr);
  const auto work =
      std::make_shared<estimation::SearchWork>(runs->source, model.job, runs->request, call.threads);
  return [runs, work](const messages::Item& item) { return work->work(item); };
}

/// A few steps from each start and from what a global search gives, and searches that go on.
std::size_t most_searches(const LoadedModel& model, const FitCall& call) {
  return 2 * (request_of(model, call).starts + 1);
}

std::string fit_key(const LoadedModel& model, const FitCall& call) {
  const estimation::FitRequest request = request_of(model, call);
  return fmt::format("{} {} {} {}", search_key(model), request.starts, request.follow.value_or(0),
                     request.seed);
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
