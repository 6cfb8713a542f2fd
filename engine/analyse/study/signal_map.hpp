#pragma once

#include <memory>

#include "engine/analyse/study/study_request.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::study {

/// A signal of a diagram as a function of another one. The blocks between them have a plan of their own,
/// which is evaluated at any input.
class SignalMap {
 public:
  /// Throws Error if a block between the signals has memory or depends on time or noise: the result is then
  /// no function.
  SignalMap(const diagram::Diagram& diagram, const diagram::SignalRef& from, const diagram::SignalRef& to,
            const yaml::Place& place);

  /// Returns the signal, a point of the plane, for a value of the other one.
  Eigen::Vector2d operator()(const Eigen::Vector2d& point) const;

 private:
  std::unique_ptr<const plan::Plan> plan_;
  std::unique_ptr<run::Executor> simulation_;
  run::Workspace start_;
  std::size_t result_ = 0;  ///< Offset in the workspace.
};

}  // namespace stepwire::study
