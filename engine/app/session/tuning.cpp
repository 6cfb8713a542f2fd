#include "engine/app/session/tuning.hpp"

#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <algorithm>

#include "engine/analyse/study/study_columns.hpp"
#include "engine/analyse/tuning/search_items.hpp"
#include "engine/app/session/build_note.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/app/session/study_parts.hpp"
#include "engine/base/io/file.hpp"
#include "engine/view/render/render.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::session {

namespace {

/// Study within an optimisation: performs the experiments with given parameter values. Subjects, noises and
/// orders are the same each time, so that only the values make a difference. All calls share plans and code.
class TunedStudy {
 public:
  /// The registry, the model and the pointers of the monitor must outlive the object. Throws Error.
  TunedStudy(const Registry& registry, const LoadedModel& model, const tuning::TuneRequest& request,
             const TuneCall& call, const Monitor& monitor);

  /// Returns the recordings of the experiments with these values; empty after an interruption, which `fault`
  /// then names. Thread-safe; calls are serialized. Throws Error if the diagram refuses the values.
  std::vector<record::Recording> run(const std::vector<diagram::Setting>& values, std::string& fault);
  /// Returns the reason of an interpreted run, if there was one.
  std::string take_problem() { return parts_->code.take_problem(); }

 private:
  void set_points(const std::vector<std::vector<diagram::Setting>>& values);

  const LoadedModel& model_;
  LoadedModel varied_;  ///< its points have the values of the current evaluation
  Monitor monitor_;
  diagram::Loader loader_;
  std::vector<std::uint64_t> seeds_;
  std::unique_ptr<StudyParts> parts_;
  std::mutex mutex_;
};

/// Offset from the start, as a fraction of a parameter's range. With several values the compiled code does
/// not fix those of the start.
constexpr double aside = 0.01;

/// Returns the settings of the start, and of values slightly above and below it.
std::vector<std::vector<diagram::Setting>> about_start(const tuning::TuneRequest& request) {
  std::vector<std::vector<diagram::Setting>> all;
  for (const double by : {0.0, aside, -aside}) {
    tuning::Values values;
    for (const tuning::TuneParameter& parameter : request.parameters)
      values.push_back(parameter.at(std::clamp(parameter.share_of(parameter.start) + by, 0.0, 1.0)));
    all.push_back(tuning::settings_of(request.parameters, values));
  }
  return all;
}

/// Returns the options of the repeated study.
StudyCall study_call(const TuneCall& call) {
  StudyCall study;
  study.engine = call.engine;
  study.threads = call.threads;
  return study;
}

TunedStudy::TunedStudy(const Registry& registry, const LoadedModel& model, const tuning::TuneRequest& request,
                       const TuneCall& call, const Monitor& monitor)
    : model_(model),
      varied_(load_model(registry, model.file, model.options)),
      loader_(registry, model.options.limits, model.options.reader) {
  monitor_.interrupt = monitor.interrupt;
  study::StudyRequest& own = *varied_.study;
  own.seed = request.study_seed.value_or(own.seed);
  own.experiments = request.experiments.value_or(own.experiments);
  run::Job& job = varied_.job;
  if (!job.family)
    job.family =
        std::make_shared<run::PlanFamily>(loader_, model.file, call_settings(model.options), job.plan);
  set_points(about_start(request));
  for (std::uint64_t i = 0; i < own.experiments; ++i) seeds_.push_back(own.seed + i);
  parts_ = std::make_unique<StudyParts>(registry, varied_, study_call(call),
                                        seeds_.size() * request.evaluations, monitor_);
}

/// Sets the points of the job: each point of the file's sweep, for each of these values.
void TunedStudy::set_points(const std::vector<std::vector<diagram::Setting>>& values) {
  run::Job& job = varied_.job;
  job.points.clear();
  job.trials = true;
  for (const std::vector<diagram::Setting>& tuned : values)
    for (std::size_t study = 0; study < study::study_count(model_.job); ++study) {
      run::SweepPoint& point = job.points.emplace_back();
      if (!model_.job.points.empty()) point.own = model_.job.settings_of(study);
      point.own.insert(point.own.end(), tuned.begin(), tuned.end());
      point.member = job.family->find(point.own);
    }
}

std::vector<record::Recording> TunedStudy::run(const std::vector<diagram::Setting>& values,
                                               std::string& fault) {
  const std::lock_guard lock(mutex_);
  set_points({values});
  KeptExperiments kept(varied_, {});
  const study::Experiments found = perform_here(*parts_->runs, varied_, seeds_, kept, monitor_);
  if (found.empty()) fault = "interrupted";
  return found.empty() ? std::vector<record::Recording>{}
                       : study::study_recordings(found, *varied_.study, model_.job);
}

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
