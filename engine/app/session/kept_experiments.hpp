#pragma once

#include <mutex>
#include <string>

#include "engine/analyse/study/repetition.hpp"
#include "engine/app/session/loaded_model.hpp"

namespace stepwire::session {

/// What the experiments of a model's study follow from but for their seeds: the study, the program that
/// makes them, and blocks from outside. A line of JSON.
std::string experiments_note(const LoadedModel& model);

/// Which experiments of a study's folder a replay of its trials leaves out, as a sentence; empty where there
/// are none. Throws TableError where one of them is not as it was written; EnvironmentError, JsonError.
std::string not_replayed(const std::string& folder);

/// The experiments of a model's study that are done, kept in a folder as soon as each of them is
/// (experiments.csv, and experiments.json with the note of what they follow from), so that a call that was
/// interrupted goes on. Without a folder, or where the study is one experiment alone, nothing is written.
class KeptExperiments {
 public:
  /// Takes what an earlier call left. Throws Error where that is of another study, TableError,
  /// EnvironmentError also
  /// where a link is in the place of its files.
  KeptExperiments(const LoadedModel& model, const std::string& folder);

  /// The seeds that are still to be done: the first one always, since its trials are drawn.
  std::vector<std::uint64_t> missing() const;
  /// From any thread.
  void add(const study::Experiments& experiments);
  /// Adds what came out of one at each point of the sweep, which is written with the next whole one.
  void add(std::uint64_t seed, const std::vector<std::vector<study::NamedValue>>& outcomes);
  /// Puts what other people did behind the experiments of the first seed.
  void complete(study::Experiments& first) const;

 private:
  const LoadedModel& model_;
  std::string path_;  ///< empty: nothing is written
  study::Repetition repetition_;
  std::mutex mutex_;
};

}  // namespace stepwire::session
