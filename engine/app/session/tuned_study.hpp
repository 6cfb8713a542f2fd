#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/app/session/study_parts.hpp"
#include "engine/app/session/tuning.hpp"

namespace stepwire::session {

/// The study of a model whose parameters are tuned: its experiments with any values of them, each time with
/// the same people, noises and orders, so that only the values make a difference. All share plans and code.
class TunedStudy {
 public:
  /// The registry, the model and what the monitor points to must outlive it. Throws Error.
  TunedStudy(const Registry& registry, const LoadedModel& model, const tuning::TuneRequest& request,
             const TuneCall& call, const Monitor& monitor);

  /// The recordings of the experiments with these values; empty after an interruption, which `fault` then
  /// names. One call after the other, from any thread. Throws Error where the diagram refuses the values.
  std::vector<record::Recording> run(const std::vector<diagram::Setting>& values, std::string& fault);
  /// The reason why something was interpreted, if any was.
  std::string take_problem() { return parts_->code.take_problem(); }

 private:
  void set_points(const std::vector<std::vector<diagram::Setting>>& values);

  const LoadedModel& model_;
  LoadedModel varied_;  ///< the points of its job have the values of an evaluation
  Monitor monitor_;
  diagram::Loader loader_;
  std::vector<std::uint64_t> seeds_;
  std::unique_ptr<StudyParts> parts_;
  std::mutex mutex_;
};

}  // namespace stepwire::session
