#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/outcome.hpp"
#include "engine/base/result/record.hpp"

namespace stepwire::session {

/// A judged claim: an entry of claims.json.
struct JudgedClaim : claim::Verdict {
  std::string file;
  std::optional<int> figure;  ///< figure of a publication that the file reproduces
};

/// Cost of an algebraic loop, as in run.json, loop.json and a profile.
struct AlgebraicLoop : run::LoopCost {};

/// Result of a run, a sweep or a study's runs: run.json.
struct RunReport {
  const LoadedModel* model;
  const Outcome* outcome;
};

/// Returns the judged claims of an outcome.
std::vector<JudgedClaim> judged_claims(const LoadedModel& model, const Outcome& outcome);

/// Declare the fields of claims.json, of a loop's cost and of run.json.
void declare(result::Record<JudgedClaim>& is);
void declare(result::Record<AlgebraicLoop>& is);
void declare(result::Record<RunReport>& is);

}  // namespace stepwire::session
