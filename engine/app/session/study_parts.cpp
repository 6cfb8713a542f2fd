#include "engine/app/session/study_parts.hpp"

#include <fmt/format.h>

#include <atomic>

#include "engine/analyse/study/study_items.hpp"

namespace stepwire::session {

namespace {

/// Progress counter of trials and experiments.
class StudyProgress {
 public:
  StudyProgress(const study::StudyRequest& request, std::size_t studies, std::size_t experiments,
                const Monitor& monitor)
      : monitor_(monitor),
        trials_(experiments * studies * request.subjects.size() *
                (request.conditions.size() + request.practice.size())),
        experiments_(experiments) {}

  void trial() {
    const double fraction = static_cast<double>(++trials_done_) / static_cast<double>(trials_);
    const std::size_t done = experiments_done_;
    monitor_.show(fraction, experiments_ == 1 ? "" : fmt::format("{} of {} experiments", done, experiments_));
  }
  void experiment() { ++experiments_done_; }

 private:
  const Monitor& monitor_;
  std::size_t trials_, experiments_;
  std::atomic<std::size_t> trials_done_ = 0, experiments_done_ = 0;
};

}  // namespace

study::Experiments perform_here(study::TrialRuns& runs, const LoadedModel& model,
                                const std::vector<std::uint64_t>& seeds, KeptExperiments& kept,
                                const Monitor& monitor) {
  const study::StudyRequest& request = *model.study;
  StudyProgress progress(request, study::study_count(model.job), seeds.size(), monitor);
  study::Experiments first;
  study::ExperimentSink sink;
  sink.told = [&] { progress.trial(); };
  sink.done = [&](study::Experiments experiments) {
    kept.add(experiments);
    progress.experiment();
    if (experiments.front().seed == request.seed) first = std::move(experiments);
  };
  study::perform(runs, request, model.job, seeds, sink);
  if (monitor.interrupted()) return {};
  kept.complete(first);
  return first;
}

study::Experiments perform_by(messages::ItemWorkers& workers, StudyParts& parts, const LoadedModel& model,
                              const std::vector<std::uint64_t>& seeds, KeptExperiments& kept) {
  study::Experiments first = study::StudyItems(*parts.runs, *model.study, model.job)
                                 .perform_by(workers, seeds, [&](std::uint64_t seed, const auto& outcomes) {
                                   kept.add(seed, outcomes);
                                 });
  kept.add(first);
  kept.complete(first);
  return first;
}

messages::ItemWork study_work(const Registry& registry, const LoadedModel& model, const StudyCall& call) {
  const study::StudyRequest& request = *model.study;
  const auto parts = std::make_shared<StudyParts>(registry, model, call, request.experiments, Monitor{});
  const auto items = std::make_shared<study::StudyItems>(*parts->runs, request, model.job);
  return [parts, items](const messages::Item& item) { return items->work(item); };
}

std::size_t most_items(const LoadedModel& model) {
  return study::people_of(*model.study, model.job) + model.study->experiments;
}

std::string study_items_key(const LoadedModel& model) {
  return fmt::format("{} {}", experiments_note(model), model.study->seed);
}

}  // namespace stepwire::session
