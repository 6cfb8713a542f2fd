#pragma once

#include <functional>

#include "engine/analyse/estimation/fit.hpp"
#include "engine/analyse/tuning/tune.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::cli {

/// Exit codes, which scripts rely on. If several apply, the greatest wins.
enum class ExitCode {
  done = 0,   ///< Success; all claims hold.
  fails = 1,  ///< Failed claim, note with --strict, search without convergence, differences, missed loop.
  wrong = 2,  ///< Fault in the diagram or the call, also one that only the run reveals.
  surroundings = 3,  ///< Disk full, gnuplot missing, data folder absent, no permission.
  interrupted = 130
};

inline ExitCode worst(ExitCode a, ExitCode b) {
  return static_cast<int>(a) > static_cast<int>(b) ? a : b;
}

/// Returns the code of a run: failed claims, unexpected verdicts, faults, interruption.
ExitCode code_of(const session::Outcome& outcome);
/// Returns interrupted, wrong if the diagram refused the fit, fails if it has not converged, or done.
ExitCode code_of(const estimation::FitResult& result);
/// Returns interrupted, wrong if no point satisfies all claims, fails without convergence, or done.
ExitCode code_of(const tuning::TuneResult& result);

/// Runs an action that may throw, prints exceptions on the standard error (one line per fault), and returns
/// the exit code. Faults are also appended to `faults` as JSON unless it is nullptr.
ExitCode guarded(const std::function<ExitCode()>& action, json::Json* faults = nullptr);

/// Prints why runs ended early, on the standard error; at most the first few of many runs.
void print_faults(const run::RunResult& result);

}  // namespace stepwire::cli
