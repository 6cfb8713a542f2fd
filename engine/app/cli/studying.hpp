#pragma once

#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "engine/analyse/study/experiment.hpp"
#include "engine/app/cli/work.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire {

/// How a call wants its studies to be made.
struct StudyCall {
  Engine engine = Engine::automatic;
  unsigned threads = 0;  ///< 0: all cores
  bool visible = false;  ///< with its progress shown
};

/// The studies of one call. Files of one study, which differ in figures and claims only, share its
/// experiments.
class Studies {
 public:
  using Shared = std::shared_ptr<const Experiments>;

  /// The experiments of a file, one for each point of its sweep, performed now or before. From any thread;
  /// who asks for some that are being performed waits for them. Throws Error.
  Shared experiments(const Registry& registry, const Work& work, const WorkOptions& options,
                     const StudyCall& call);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_future<Shared>> known_;
};

/// Puts the experiments into the place of a run: their trials as runs of the work, tables, recordings; and
/// judges the claims.
Outcome carry_out_study(Work& work, const Experiments& experiments);

/// Writes what verify() needs, trials.csv (of a sweep one for each point: trials-2.csv, ...), errors.csv,
/// study.json, tables.txt into a folder. Throws SurroundingsError.
void write_study(const std::string& folder, const Work& work, const Experiments& experiments,
                 const Outcome& outcome);

/// What errors.csv and tables.txt have.
std::string errors_text(const Work& work, const Experiments& experiments, const Outcome& outcome);
std::string tables_text(const Work& work, const Experiments& experiments);

/// What the study found, for people.
std::string study_text(const Work& work, const Experiments& experiments);
Json study_json(const Work& work, const Experiments& experiments);

/// All that decides on the experiment of a work, as a text; with or without the seed, which decides who the
/// people are.
std::string study_key(const Work& work, bool with_seed = true);

/// How the trials of so many experiments are computed: as the call says, else by how long they would take
/// interpreted. The longest wait for a compilation, shorter ones have it beside them, others have none.
Engine engine_of(const Work& work, const StudyCall& call, std::size_t experiments);

/// The runs of a work as trials; `code` is for what is compiled.
TrialSource trial_source(Loader& loader, const Work& work, const WorkOptions& options, Engine engine,
                         CodeSource& code);

/// Performs experiments with `count` seeds from the file's one on, as far as the folder does not have them
/// yet in experiments.csv; draws their distribution in experiments.svg. What is done is kept when it is
/// interrupted. Throws Error, SurroundingsError.
ExitCode repeat_study(const Registry& registry, const Work& work, const WorkOptions& options,
                      const StudyCall& call, std::size_t count, const std::string& folder);

}  // namespace stepwire
