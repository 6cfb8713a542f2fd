#pragma once

namespace stepwire::run {

/// How a run goes on.
enum class Flow {
  go_on,
  pause,  ///< before the next tick; a Drive goes on when it is run again, other runs end here
  stop    ///< for good, with what is recorded so far
};

}  // namespace stepwire::run
