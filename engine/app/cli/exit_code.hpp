#pragma once

#include "engine/analyse/estimation/fit.hpp"
#include "engine/analyse/tuning/tune.hpp"
#include "engine/app/session/outcome.hpp"

namespace stepwire::cli {

/// What scripts may rely on. Where several apply, the greatest but for 130 wins.
enum class ExitCode {
  done = 0,          ///< and all claims hold
  fails = 1,         ///< a claim, a replay that is not the same, a loop that stops after misses
  wrong = 2,         ///< the diagram or the call, also where it shows only in the run
  surroundings = 3,  ///< disk full, gnuplot missing, data folder absent, no permission
  interrupted = 130
};

inline ExitCode worst(ExitCode a, ExitCode b) {
  return static_cast<int>(a) > static_cast<int>(b) ? a : b;
}

/// How it went: claims that fail, claims that surprise, faults, interruption.
ExitCode code_of(const session::Outcome& outcome);
/// Interrupted, refused by the diagram, or done.
ExitCode code_of(const estimation::FitResult& result);
/// Interrupted, no point with all claims, or done.
ExitCode code_of(const tuning::TuneResult& result);

}  // namespace stepwire::cli
