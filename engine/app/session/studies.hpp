#pragma once

#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "engine/analyse/study/distribution.hpp"
#include "engine/analyse/study/experiment.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/base/messages/items.hpp"
#include "engine/base/result/record.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// Options of a study.
struct StudyCall {
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  unsigned threads = 0;                      ///< 0: all cores
  std::string kept{};                        ///< folder of the journal of finished experiments; empty: none
  messages::ItemWorkers* workers = nullptr;  ///< processes that perform them; nullptr: this process
};

/// Cache of the studies of one call. Files with the same study, which differ only in figures and claims,
/// share its experiments.
class Studies {
 public:
  using Shared = std::shared_ptr<const study::Experiments>;

  /// Returns the experiments of a file, one for each point of its sweep. Performs them unless they are
  /// cached. Thread-safe: a concurrent call for the same study waits. Throws Error.
  Shared experiments(const Registry& registry, const LoadedModel& model, const StudyCall& call,
                     const Monitor& monitor);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_future<Shared>> known_;
};

/// Returns subjects and experiments of a study as work items for another process. The model must outlive
/// them. Throws Error.
messages::ItemWork study_work(const Registry& registry, const LoadedModel& model, const StudyCall& call);
/// Returns the largest number of items of such a study, and a key of everything that determines their
/// results.
std::size_t most_items(const LoadedModel& model);
std::string study_items_key(const LoadedModel& model);

/// Converts experiments to the outcome of a run: trials as runs of the model, tables and recordings. Judges
/// the claims.
Outcome study_outcome(LoadedModel& model, const study::Experiments& experiments);

/// Writes the replay, trials.csv, errors.csv, study.json and tables.txt into a folder. A sweep has
/// trials-2.csv, ... for further points. Throws EnvironmentError.
void write_study(const std::string& folder, const LoadedModel& model, const study::Experiments& experiments,
                 const Outcome& outcome);

/// A file of a study and its content.
struct StudyFile {
  std::string name, text;
};
/// Returns trials.csv, errors.csv and tables.txt.
std::vector<StudyFile> study_texts(const LoadedModel& model, const study::Experiments& experiments,
                                   const Outcome& outcome);

/// Result of a study: study.json.
struct StudyReport {
  const LoadedModel* model;
  const study::Experiments* experiments;
};
void declare(result::Record<StudyReport>& is);

/// Returns a key of everything that determines the experiment of a model. The seeds, which determine the
/// subjects, are optional.
std::string study_key(const LoadedModel& model, bool with_seed = true);

/// Chooses the execution mode of the trials of `experiments` experiments: that of the call, else by their
/// estimated interpreted duration. Long studies wait for the compilation, medium ones start interpreted
/// during it, short ones are not compiled.
run::ExecutionMode engine_of(const LoadedModel& model, const StudyCall& call, std::size_t experiments);

/// Returns the runs of a model as trials; `code` compiles them.
study::TrialSource trial_source(diagram::Loader& loader, const LoadedModel& model, run::ExecutionMode engine,
                                plan::CodeSource& code, const Monitor& monitor);

/// Returns histograms over all experiments of the values that the thesis prints, with a line at the printed
/// value. P values are drawn by their logarithm.
plot::FigureSpec repetition_figure(const std::vector<study::ExperimentOutcome>& experiments,
                                   const study::StudyRequest& request);

}  // namespace stepwire::session
