#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/analyse/tuning/search.hpp"

namespace stepwire::tuning {

/// A point of a search: for each parameter its share of the way between its bounds.
using Shares = std::vector<double>;

/// What a search has looked at, and the numbers that a method of NLopt takes of it.
class SearchLog {
 public:
  explicit SearchLog(const SearchProblem& problem) : problem_(problem) {}

  std::size_t size() const { return evaluations_.size(); }
  const Evaluation& operator[](std::size_t i) const { return evaluations_[i]; }
  const Evaluation& add(const Shares& shares, Evaluation evaluation);
  /// One of the last points, since objective and claims are read apart.
  std::optional<std::size_t> find(const Shares& shares) const;

  /// The least objective with all claims, the first of equal ones.
  std::optional<std::size_t> best() const;
  /// That point, or the one whose claims are nearest to holding.
  std::optional<Shares> best_known() const;
  /// Its objective in shares of the objective's scale; infinite where the claims hold nowhere.
  double merit() const;

  /// In shares of the objective's scale; what cannot be run is worse than all others so far.
  double objective_of(const Evaluation& evaluation) const;
  /// How far each side of each claim fails, in shares of its scale; each with a little to spare, so that what
  /// is found holds as it is judged.
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
