#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/app/session/study_parts.hpp"
#include "engine/app/session/tuning.hpp"

namespace stepwire::session {

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

}  // namespace stepwire::session
