#pragma once

#include <memory>

#include "engine/analyse/study/study_request.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::study {

/// A signal of a diagram as a function of another one: the blocks between them as a plan of their own, which
/// is evaluated at any values.
class SignalMap {
 public:
  /// Throws Error where something between the two signals remembers, or follows from the time or from noise,
  /// so that the one is no function of the other.
  SignalMap(const diagram::Diagram& diagram, const diagram::SignalRef& from, const diagram::SignalRef& to,
            const yaml::Place& place);

  /// Its value, a point of the plane, where the other signal has this value.
  Eigen::Vector2d operator()(const Eigen::Vector2d& point) const;

 private:
  std::unique_ptr<const plan::Plan> plan_;
  std::unique_ptr<run::Executor> simulation_;
  run::Workspace start_;
  std::size_t result_ = 0;  ///< offset in the workspace
};

}  // namespace stepwire::study
