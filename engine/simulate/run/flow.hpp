#pragma once

namespace stepwire {

/// How a run goes on.
enum class Flow {
  go_on,
  pause,  ///< before the next tick; the run can be taken up again
  stop    ///< for good, with what is recorded so far
};

}  // namespace stepwire
