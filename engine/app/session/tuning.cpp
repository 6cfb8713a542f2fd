#include "engine/app/session/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/tuning/search_items.hpp"
#include "engine/app/session/build_note.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/app/session/tuned_study.hpp"
#include "engine/base/io/file.hpp"
#include "engine/view/render/figure_file.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::session {

namespace {

tuning::TuneRequest request_of(const LoadedModel& model, const TuneCall& call) {
  tuning::TuneRequest request = *model.tune;
  if (call.starts) request.starts = *call.starts;
  if (call.evaluations) request.evaluations = *call.evaluations;
  if (call.seed) request.seed = *call.seed;
  if (call.experiments) request.experiments = call.experiments;
  return request;
}

/// Returns a lower bound of the number of runs of the searches.
double runs_of(const tuning::TuneRequest& request) {
  constexpr std::size_t per_parameter = 20;
  return static_cast<double>(std::min(per_parameter * request.parameters.size(), request.evaluations) *
                             request.starts);
}

struct TuneParts : SearchParts {
  TuneParts(const Registry& registry, const LoadedModel& model, const TuneCall& call, const Monitor& monitor)
      : SearchParts(registry, model, call.engine, runs_of(request_of(model, call))),
        request(request_of(model, call)),
        source{loader, model.file, settings, model.linear, used, monitor.interrupt} {
    if (model.study) {
      study.emplace(registry, model, request, call, monitor);
      source.code = nullptr;
      source.perform = [this](const std::vector<diagram::Setting>& values, std::string& fault) {
        return study->run(values, fault);
      };
    }
    if (model.scene)
      source.add_shown = [scene = model.scene](std::vector<record::Recording>& recordings) {
        scene::add_scene_states(*scene, recordings);
      };
  }

  tuning::TuneRequest request;
  tuning::TuneSource source;
  std::optional<TunedStudy> study{};

  std::string take_problem() { return study ? study->take_problem() : code.take_problem(); }
};

}  // namespace

tuning::TuneResult tune_model(const Registry& registry, const LoadedModel& model, const TuneCall& call,
                              const Monitor& monitor) {
  TuneParts parts(registry, model, call, monitor);
  tuning::TuneResult result =
      tuning::tune(parts.source, model.job, parts.request, {call.threads, monitor.progress, call.workers});
  monitor.note_interpreted(parts.take_problem());
  return result;
}

messages::ItemWork tune_work(const Registry& registry, const LoadedModel& model, const TuneCall& call) {
  const auto parts = std::make_shared<TuneParts>(registry, model, call, Monitor{});
  const auto work =
      std::make_shared<tuning::SearchWork>(parts->source, model.job, parts->request, call.threads);
  return [parts, work](const messages::Item& item) { return work->work(item); };
}

std::size_t most_searches(const LoadedModel& model, const TuneCall& call) {
  return request_of(model, call).starts;
}

std::string tune_key(const LoadedModel& model, const TuneCall& call) {
  const tuning::TuneRequest request = request_of(model, call);
  return fmt::format("{} {} {} {} {}", search_key(model), request.starts, request.evaluations, request.seed,
                     request.experiments.value_or(0));
}

LoadOptions with_tuned(LoadOptions options, const tuning::TuneResult& result) {
  options.settings.insert(options.settings.end(), result.settings.begin(), result.settings.end());
  return options;
}

void write_tune(const std::string& folder, const LoadedModel& model, const tuning::TuneResult& result) {
  io::write_file(folder + "/tune.json", tune_json(model, result).text() + "\n");
  io::write_file(folder + "/tune-history.csv", history_csv(model, result));
  if (result.feasible && !result.numbers.empty())
    io::write_file(folder + "/parameters.yaml", parameters_text(model, result));
  // An interruption would also end the renderer.
  if (!result.numbers.empty() && !result.interrupted)
    render::write_figure(folder, "tune-history", tune_figure(model, result));
}

}  // namespace stepwire::session
