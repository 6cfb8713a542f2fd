#include "engine/app/session/fitting.hpp"

#include <fmt/format.h>

#include "engine/analyse/estimation/searches.hpp"
#include "engine/app/session/build_note.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/base/io/file.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::session {

namespace {

estimation::FitRequest request_of(const LoadedModel& model, const FitCall& call) {
  estimation::FitRequest request = *model.fit;
  if (call.starts) request.starts = *call.starts;
  if (call.follow) request.follow = call.follow;
  if (call.seed) request.seed = *call.seed;
  return request;
}

/// Returns an estimate of the number of runs that the searches need.
double runs_of(const estimation::FitRequest& request) {
  constexpr double steps = 10.0;  // iterations of a search
  return steps * static_cast<double>((request.parameters.size() + 1) * request.starts);
}

struct FitParts : SearchParts {
  FitParts(const Registry& registry, const LoadedModel& model, const FitCall& call,
           const std::atomic<bool>* interrupt)
      : SearchParts(registry, model, call.engine, runs_of(request_of(model, call))),
        request(request_of(model, call)),
        source{loader, model.file, settings, used, interrupt} {}

  estimation::FitRequest request;
  estimation::ModelSource source;
};

}  // namespace

estimation::FitResult fit_model(const Registry& registry, const LoadedModel& model, const FitCall& call,
                                const Monitor& monitor) {
  FitParts parts(registry, model, call, monitor.interrupt);
  estimation::FitResult result =
      fit(parts.source, model.job, parts.request, {call.threads, monitor.progress, call.workers});
  monitor.note_interpreted(parts.code.take_problem());
  return result;
}

messages::ItemWork fit_work(const Registry& registry, const LoadedModel& model, const FitCall& call) {
  const auto parts = std::make_shared<FitParts>(registry, model, call, nullptr);
  const auto work =
      std::make_shared<estimation::SearchWork>(parts->source, model.job, parts->request, call.threads);
  return [parts, work](const messages::Item& item) { return work->work(item); };
}

/// Each start, from the request or from the global search, has a short first search and may have a continued
/// one.
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
