#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/analyse/tuning/search.hpp"

namespace stepwire::tuning {

/// A point of a search: for each parameter its share of the way between its bounds.
using Shares = std::vector<double>;

/// Evaluations of a search, and their numbers in the form that NLopt takes.
class SearchLog {
 public:
  explicit SearchLog(const SearchProblem& problem) : problem_(problem) {}

  std::size_t size() const { return evaluations_.size(); }
  const Evaluation& operator[](std::size_t i) const { return evaluations_[i]; }
  const Evaluation& add(const Shares& shares, Evaluation evaluation);
  /// Returns the index of a point among the last 16. NLopt reads objective and claims of a point in separate
  /// calls.
  std::optional<std::size_t> find(const Shares& shares) const;

  /// Returns the index of the least objective with all claims satisfied, the first of equal ones.
  std::optional<std::size_t> best() const;
  /// Returns the best point, or the one with the smallest violation.
  std::optional<Shares> best_known() const;
  /// Returns the best objective over the objective's scale; infinite if no point satisfies all claims.
  double merit() const;

  /// Returns the objective over its scale. A point that cannot be run is worse than all points so far.
  double objective_of(const Evaluation& evaluation) const;
  /// Returns the violation of each bound of each claim over its scale, plus a small reserve. The reserve
  /// ensures that a solution on the bound passes the claim's own check.
  std::vector<double> sides_of(const Evaluation& evaluation) const;

  std::vector<Evaluation> take() { return std::move(evaluations_); }

 private:
  const SearchProblem& problem_;
  std::vector<Shares> points_;
  std::vector<Evaluation> evaluations_;
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = -std::numeric_limits<double>::infinity();
};

}  // namespace stepwire::tuning
