#pragma once

#include <string>
#include <vector>

#include "engine/analyse/comparison/compare.hpp"
#include "engine/app/session/session.hpp"

namespace stepwire::session {

/// Claim with different verdicts in the runs of two diagrams.
struct ChangedVerdict {
  std::string that;
  std::string before, after;  ///< Verdict and value, or "absent".
};

/// Differences between the runs of two diagrams. Signals are compared by name.
struct ResultComparison {
  comparison::RecordingDifference signals;
  std::vector<ChangedVerdict> claims;

  bool agrees() const { return signals.agrees && claims.empty(); }
};

/// Runs two diagrams and compares their recorded signals and the verdicts of their claims. Throws yaml::Error for a
/// diagram with a fault, for a run that ends by one, and for studies and fits.
ResultComparison compare_results(Session& session, const std::string& before, const std::string& after);

void declare(result::Record<ResultComparison>& is);

}  // namespace stepwire::session
