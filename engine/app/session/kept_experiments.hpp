#pragma once

#include <mutex>
#include <string>

#include "engine/analyse/study/repetition.hpp"
#include "engine/app/session/loaded_model.hpp"

namespace stepwire::session {

/// Returns a line of JSON with everything but the seeds that determines the experiments: the study, the
/// version of the program, and external blocks.
std::string experiments_note(const LoadedModel& model);

/// Returns a sentence on the experiments of a folder that a replay of its trials omits; empty if there are
/// none. Throws TableError if an experiment was modified, EnvironmentError, and JsonError.
std::string not_replayed(const std::string& folder);

/// Journal of the finished experiments of a study: experiments.csv, and experiments.json with the note of
/// experiments_note(). A call continues it after an interruption.
/// Without a folder, or for a single experiment, no file is written.
class KeptExperiments {
 public:
  /// Loads the experiments of an earlier call. Throws Error if they are of another study, TableError, and
  /// EnvironmentError, also if one of the files is a link.
  KeptExperiments(const LoadedModel& model, const std::string& folder);

  /// Returns the missing seeds. The first seed is always among them, because its trials are drawn.
  std::vector<std::uint64_t> missing() const;
  /// Stores finished experiments. Thread-safe.
  void add(const study::Experiments& experiments);
  /// Adds the outcomes of one experiment at each point of the sweep. The next call with whole experiments
  /// writes them.
  void add(std::uint64_t seed, const std::vector<std::vector<study::NamedValue>>& outcomes);
  /// Appends the outcomes of the other experiments to those of the first seed.
  void complete(study::Experiments& first) const;

 private:
  const LoadedModel& model_;
  std::string path_;  ///< empty: no file is written
  study::Repetition repetition_;
  std::mutex mutex_;
};

}  // namespace stepwire::session
