#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/analyse/tuning/evaluation.hpp"

namespace stepwire::tuning {

/// A point of a search: for each parameter its share of the way between its bounds.
using Shares = std::vector<double>;

/// Function that evaluates a point of a search. An exception ends the search.
using LookAt = std::function<const Evaluation&(const Shares&)>;

/// Computes the Jacobian of the targets by the share of each parameter, a row per target. It uses central
/// differences over a tenth of the bounds on each side, or up to the bounds. Returns std::nullopt at a point
/// without a value; `without` is the parameter that was moved.
std::optional<std::vector<std::vector<double>>> target_jacobian(const LookAt& look,
                                                                const TuneRequest& request, const Shares& at,
                                                                std::size_t& without);

/// Data that all searches of an optimisation share.
struct SearchProblem {
  const TuneRuns& runs;
  const TuneRequest& request;
  unsigned threads = 1;  ///< Threads for the runs of one evaluation.
  double objective_scale = 1.0;
  std::vector<double> claim_scales{};
  std::function<void(const Evaluation&)> watch{};  ///< Callback for each evaluation; called from any thread.
};

/// Evaluations of one search.
struct SearchResult {
  std::vector<Evaluation> evaluations{};
  std::optional<std::size_t> best{};  ///< Best one that satisfies all claims; std::nullopt if none does.
  bool converged = false;
};

/// Returns the largest violation of a claim as a share of its scale. 0 if all claims hold, 2 if a claim has
/// no value.
double violation_of(const Evaluation& evaluation, const SearchProblem& problem);

/// Searches from the given start (number 0) or from a random one within the bounds. The result depends on
/// seed and number only. `known` is the evaluation of the given start.
SearchResult search(const SearchProblem& problem, std::size_t number, const std::optional<Evaluation>& known);

/// Searches from these values for a point at which all claims hold, whatever the objective there.
SearchResult restore(const SearchProblem& problem, const Values& from);

}  // namespace stepwire::tuning
