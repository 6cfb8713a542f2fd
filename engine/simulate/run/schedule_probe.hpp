#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::run {

/// Is told when a stretch of one phase's batches begins and ends to run, whatever of it is due.
class ScheduleProbe {
 public:
  virtual ~ScheduleProbe() = default;
  virtual void enter() = 0;
  virtual void leave() = 0;

  const std::vector<plan::KernelCall>* phase =
      nullptr;                     ///< timed, outputs, stage, derivatives or updates of the plan
  std::size_t first = 0, end = 0;  ///< the stretch: batches first to end - 1 of the phase
};

}  // namespace stepwire::run
