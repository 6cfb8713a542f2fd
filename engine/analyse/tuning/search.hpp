#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/analyse/tuning/evaluation.hpp"

namespace stepwire::tuning {

/// What all searches of a tuning share.
struct SearchProblem {
  const TuneRuns& runs;
  const TuneRequest& request;
  unsigned threads = 1;  ///< for the runs of one evaluation
  double objective_scale = 1.0;
  std::vector<double> claim_scales{};
  std::function<void(const Evaluation&)> watch{};  ///< shown each evaluation, from any thread
};

/// One search, and all that it has looked at.
struct SearchResult {
  std::vector<Evaluation> evaluations{};
  std::optional<std::size_t> best{};  ///< of these, with all claims; none where they never hold together
  bool converged = false;
};

/// How far a point is from holding its claims: the largest share of its bound by which one fails, 0 where all
/// hold, 2 where there is nothing to judge.
double violation_of(const Evaluation& evaluation, const SearchProblem& problem);

/// Searches from the given start (number 0) or from a random one within the bounds. The same for the same
/// seed and number. `known`: evaluations of the given start.
SearchResult search(const SearchProblem& problem, std::size_t number, const std::optional<Evaluation>& known);

/// Looks for a point at which all claims hold, whatever the objective is: from some values on.
SearchResult restore(const SearchProblem& problem, const Values& from);

}  // namespace stepwire::tuning
