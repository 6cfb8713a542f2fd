#pragma once

namespace stepwire::run {

/// Control of a run by its observers.
enum class Flow {
  go_on,
  pause,  ///< Pauses before the next tick. Another Drive::run() resumes; runs without a Drive end.
  stop    ///< Ends the run and keeps what is recorded.
};

}  // namespace stepwire::run
