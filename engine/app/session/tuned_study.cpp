#include "engine/app/session/tuned_study.hpp"

#include <algorithm>

#include "engine/analyse/study/study_columns.hpp"
#include "engine/app/session/search_parts.hpp"

namespace stepwire::session {

namespace {

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

}  // namespace

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

}  // namespace stepwire::session
