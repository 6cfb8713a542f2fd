#pragma once

#include "engine/analyse/estimation/fit.hpp"
#include "engine/analyse/tuning/tune.hpp"
#include "engine/app/session/outcome.hpp"

namespace stepwire::cli {

/// Exit codes, which scripts rely on. If several apply, the greatest wins.
enum class ExitCode {
  done = 0,          ///< Success; all claims hold.
  fails = 1,         ///< Failed claim, replay with differences, or a loop stopped after misses.
  wrong = 2,         ///< Fault in the diagram or the call, also one that only the run reveals.
  surroundings = 3,  ///< Disk full, gnuplot missing, data folder absent, no permission.
  interrupted = 130
};

inline ExitCode worst(ExitCode a, ExitCode b) {
  return static_cast<int>(a) > static_cast<int>(b) ? a : b;
}

/// Returns the code of a run: failed claims, unexpected verdicts, faults, interruption.
ExitCode code_of(const session::Outcome& outcome);
/// Returns interrupted, wrong if the diagram refused the fit, or done.
ExitCode code_of(const estimation::FitResult& result);
/// Returns interrupted, wrong if no point satisfies all claims, or done.
ExitCode code_of(const tuning::TuneResult& result);

}  // namespace stepwire::cli
