#pragma once

#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "engine/analyse/study/experiment.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::session {

/// How a call wants its studies to be made.
struct StudyCall {
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  unsigned threads = 0;  ///< 0: all cores
  std::string kept{};    ///< folder in which experiments are kept that are done; empty: none
  messages::ItemWorkers* workers = nullptr;  ///< that perform them; null: this process does
};

/// The studies of one call. Files of one study, which differ in figures and claims only, share its
/// experiments.
class Studies {
 public:
  using Shared = std::shared_ptr<const study::Experiments>;

  /// The experiments of a file, one for each point of its sweep, performed now or before. From any thread;
  /// who asks for some that are being performed waits for them. Throws Error.
  Shared experiments(const Registry& registry, const LoadedModel& model, const StudyCall& call,
                     const Monitor& monitor);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_future<Shared>> known_;
};

/// People and experiments of a study for another process. The model must outlive it. Throws Error.
messages::ItemWork study_work(const Registry& registry, const LoadedModel& model, const StudyCall& call);
/// How many items such a study has at most, and all that decides what they give.
std::size_t most_items(const LoadedModel& model);
std::string study_items_key(const LoadedModel& model);

/// Puts the experiments into the place of a run: their trials as runs of the model, tables, recordings; and
/// judges the claims.
Outcome study_outcome(LoadedModel& model, const study::Experiments& experiments);

/// Writes what verify() needs, trials.csv (of a sweep one for each point: trials-2.csv, ...), errors.csv,
/// study.json, tables.txt into a folder. Throws EnvironmentError.
void write_study(const std::string& folder, const LoadedModel& model, const study::Experiments& experiments,
                 const Outcome& outcome);

/// What errors.csv and tables.txt have.
std::string errors_text(const LoadedModel& model, const study::Experiments& experiments,
                        const Outcome& outcome);
std::string tables_text(const LoadedModel& model);

/// All that it found, for programs.
json::Json study_json(const LoadedModel& model, const study::Experiments& experiments);

/// All that decides on the experiment of a model, as a text; with or without the seeds, which decide who the
/// people are.
std::string study_key(const LoadedModel& model, bool with_seed = true);

/// How the trials of so many experiments are computed: as the call says, else by how long they would take
/// interpreted. The longest wait for a compilation, shorter ones have it beside them, others have none.
run::ExecutionMode engine_of(const LoadedModel& model, const StudyCall& call, std::size_t experiments);

/// The runs of a model as trials; `code` is for what is compiled.
study::TrialSource trial_source(diagram::Loader& loader, const LoadedModel& model, run::ExecutionMode engine,
                                plan::CodeSource& code, const Monitor& monitor);

}  // namespace stepwire::session
