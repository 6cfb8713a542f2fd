#include "engine/app/session/repeated_study.hpp"

#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <mutex>

#include "engine/analyse/study/study_columns.hpp"
#include "engine/app/session/repetition_figure.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/view/render/figure_file.hpp"

namespace stepwire {

namespace {

/// The file of experiments that are done, of the study that the note beside it names.
class ExperimentFile {
 public:
  ExperimentFile(const std::string& folder, const LoadedModel& model, Repetition& repetition)
      : path_(folder + "/experiments.csv"), repetition_(repetition) {
    const std::string note = folder + "/experiments.json";
    const std::string text = Json::object().set("study", study_key(model, false)).text() + "\n";
    if (std::filesystem::exists(path_)) {
      if (!std::filesystem::exists(note) || read_file(note) != text)
        throw Error(Fault{{path_, {}}, "", "has experiments of another study; give another --out", {}});
      repetition.read(path_);
    }
    write_file(note, text);
  }

  void add(std::uint64_t seed, const std::vector<NamedValue>& outcome) {
    const std::lock_guard lock(mutex_);
    repetition_.add(seed, outcome);
    write_file(path_, repetition_.csv());
  }

 private:
  std::string path_;
  Repetition& repetition_;
  std::mutex mutex_;
};

/// Performs those that are missing, several at a time, each of them on one thread.
void perform_missing(const Registry& registry, const LoadedModel& model, const StudyCall& call,
                     const std::vector<std::uint64_t>& seeds, ExperimentFile& file, const Monitor& monitor) {
  const StudyRequest& request = *model.study;
  std::atomic<std::size_t> next = 0, done = 0;
  const auto workers = call.threads ? call.threads : std::max(1u, std::thread::hardware_concurrency());
  in_parallel(workers, workers, [&](std::size_t) {
    Loader loader(registry, model.options.limits);
    GeneratedCode code;
    TrialSource source = trial_source(loader, model, engine_of(model, call, seeds.size()), code, monitor);
    source.threads = 1;
    TrialRuns runs(std::move(source), request, model.job);
    for (std::size_t i = next++; i < seeds.size() && !monitor.interrupted(); i = next++) {
      const Experiments experiments = perform(runs, request, model.job, seeds[i]);
      if (experiments.empty()) return;
      file.add(seeds[i], outcome(experiments.front(), request));
      monitor.show(static_cast<double>(++done) / static_cast<double>(seeds.size()));
    }
  });
}

}  // namespace

Repetition repeat_study(const Registry& registry, const LoadedModel& model, const StudyCall& call,
                        std::size_t count, const std::string& folder, const Monitor& monitor) {
  const StudyRequest& request = *model.study;
  if (!request.trials.empty())
    throw Error(Fault{request.place, "study", "recorded trials cannot be repeated by the computer", {}});
  if (const std::size_t studies = study_count(model.job); studies > 1)
    throw Error(
        Fault{request.place,
              "study",
              fmt::format("--repeat makes many experiments of one study, and the sweep of this file has "
                          "{}; leave one of them with --set",
                          studies),
              {}});
  Repetition repetition(outcome_columns(request));
  ExperimentFile file(folder, model, repetition);
  std::vector<std::uint64_t> missing;
  for (std::uint64_t seed = request.seed; seed < request.seed + count; ++seed)
    if (!repetition.has(seed)) missing.push_back(seed);
  perform_missing(registry, model, call, missing, file, monitor);
  if (monitor.interrupted()) return repetition;
  write_figure(folder, "experiments", repetition_figure(repetition, request), "experiments-figure");
  write_file(folder + "/experiments.txt", text(repetition.table(request)));
  return repetition;
}

}  // namespace stepwire
