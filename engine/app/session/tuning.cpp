#include "engine/app/session/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/tuning/search_items.hpp"
#include "engine/app/session/build_note.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/view/render/figure_file.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::session {

namespace {

/// Will a search take longer than a compilation?
bool is_long(const LoadedModel& model, const tuning::TuneRequest& request) {
  // What an interpreted block takes per tick and a compilation [s], and what a search takes at least.
  constexpr double per_block = 5e-8, compilation = 1.5, per_parameter = 20.0;
  const run::Job& job = model.job;
  double ticks = job.points.empty() ? static_cast<double>(job.plan.steps) : 0.0;
  for (std::size_t point = 0; point < job.points.size(); ++point)
    ticks += static_cast<double>(job.plan_of(point).steps);
  const double evaluations = std::min(per_parameter * static_cast<double>(request.parameters.size()),
                                      static_cast<double>(request.evaluations)) *
                             static_cast<double>(request.starts);
  return per_block * ticks * static_cast<double>(job.plan.diagram.blocks.size()) * evaluations > compilation;
}

tuning::TuneRequest request_of(const LoadedModel& model, const TuneCall& call) {
  tuning::TuneRequest request = *model.tune;
  if (call.starts) request.starts = *call.starts;
  if (call.evaluations) request.evaluations = *call.evaluations;
  if (call.seed) request.seed = *call.seed;
  return request;
}

/// What the runs of a tuning are made of.
struct TuneParts {
  TuneParts(const Registry& registry, const LoadedModel& model, const TuneCall& call,
            const std::atomic<bool>* interrupt)
      : request(request_of(model, call)),
        loader(registry, model.options.limits, model.options.reader),
        source{loader, model.file, model.options.settings, model.linear, nullptr, interrupt} {
    const bool compiles = call.engine == run::ExecutionMode::compiled ||
                          (call.engine == run::ExecutionMode::automatic && is_long(model, request));
    if (compiles) source.code = &code;
    if (model.scene)
      source.add_shown = [scene = model.scene](std::vector<record::Recording>& recordings) {
        scene::add_scene_states(*scene, recordings);
      };
    if (const auto& stop = model.options.stop) source.settings.push_back({"stop", *stop, "--stop " + *stop});
  }

  tuning::TuneRequest request;
  codegen::GeneratedCode code;
  diagram::Loader loader;
  tuning::TuneSource source;
};

}  // namespace

tuning::TuneResult tune_model(const Registry& registry, const LoadedModel& model, const TuneCall& call,
                              const Monitor& monitor) {
  TuneParts parts(registry, model, call, monitor.interrupt);
  tuning::TuneResult result =
      tuning::tune(parts.source, model.job, parts.request, {call.threads, monitor.progress, call.workers});
  monitor.note_interpreted(parts.code.take_problem());
  return result;
}

messages::ItemWork tune_work(const Registry& registry, const LoadedModel& model, const TuneCall& call) {
  const auto parts = std::make_shared<TuneParts>(registry, model, call, nullptr);
  const auto work =
      std::make_shared<tuning::SearchWork>(parts->source, model.job, parts->request, call.threads);
  return [parts, work](const messages::Item& item) { return work->work(item); };
}

std::size_t most_searches(const LoadedModel& model, const TuneCall& call) {
  return request_of(model, call).starts;
}

std::string tune_key(const LoadedModel& model, const TuneCall& call) {
  const tuning::TuneRequest request = request_of(model, call);
  return fmt::format("{} {} {} {}", search_key(model), request.starts, request.evaluations, request.seed);
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
  // An interruption ends what draws, too.
  if (!result.numbers.empty() && !result.interrupted)
    render::write_figure(folder, "tune-history", tune_figure(model, result));
}

}  // namespace stepwire::session
