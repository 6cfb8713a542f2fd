#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::run {

/// Observer of a range of kernel calls in one phase. It is called before and after the range runs, even if no
/// call in it is due.
class ScheduleProbe {
 public:
  virtual ~ScheduleProbe() = default;
  virtual void enter() = 0;
  virtual void leave() = 0;

  const std::vector<plan::KernelCall>* phase =
      nullptr;                     ///< timed, outputs, stage, derivatives or updates of the plan
  std::size_t first = 0, end = 0;  ///< range of calls [first, end) in the phase
};

}  // namespace stepwire::run
