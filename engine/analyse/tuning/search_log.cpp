#include "engine/analyse/tuning/search_log.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/tuning/constraint.hpp"

namespace stepwire::tuning {

namespace {

constexpr double farthest = 2.0;  // violation of a claim without a value

/// Limits a violation to the range from -2 to 2: identity below 1, then 2 - 1 / size. An infinite margin
/// would break the linear models of COBYLA.
double bounded(double violation) {
  if (std::isnan(violation)) return farthest;
  const double size = std::abs(violation);
  return size <= 1.0 ? violation : std::copysign(farthest - 1.0 / size, violation);
}

}  // namespace

double violation_of(const Evaluation& evaluation, const SearchProblem& problem) {
  double most = evaluation.is_bad() ? farthest : 0.0;
  for (std::size_t i = 0; i < evaluation.margins.size(); ++i)
    most = std::max(most, bounded(-evaluation.margins[i] / problem.claim_scales[i]));
  return most;
}

const Evaluation& SearchLog::add(const Shares& shares, Evaluation evaluation) {
  if (!evaluation.is_bad()) {
    const double scaled = evaluation.objective / problem_.objective_scale;
    least_ = std::min(least_, scaled);
    most_ = std::max(most_, scaled);
  }
  points_.push_back(shares);
  evaluations_.push_back(std::move(evaluation));
  return evaluations_.back();
}

std::optional<std::size_t> SearchLog::find(const Shares& shares) const {
  constexpr std::size_t looks = 16;
  for (std::size_t i = size(); i-- > size() - std::min(looks, size());)
    if (points_[i] == shares) return i;
  return std::nullopt;
}

std::optional<std::size_t> SearchLog::best() const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < size(); ++i)
    if (evaluations_[i].is_feasible() &&
        (!found || evaluations_[i].objective < evaluations_[*found].objective))
      found = i;
  return found;
}

std::optional<Shares> SearchLog::best_known() const {
  if (const auto found = best()) return points_[*found];
  std::optional<std::size_t> found;
  double nearest = farthest;
  for (std::size_t i = 0; i < size(); ++i) {
    const double away = violation_of(evaluations_[i], problem_);
    if (evaluations_[i].is_bad() || (found && away >= nearest)) continue;
    nearest = away;
    found = i;
  }
  return found ? std::optional(points_[*found]) : std::nullopt;
}

double SearchLog::merit() const {
  const auto found = best();
  return found ? evaluations_[*found].objective / problem_.objective_scale
               : std::numeric_limits<double>::infinity();
}

double SearchLog::objective_of(const Evaluation& evaluation) const {
  if (!evaluation.is_bad()) return evaluation.objective / problem_.objective_scale;
  return most_ < least_ ? 1.0 : most_ + std::max(1.0, most_ - least_);
}

std::vector<double> SearchLog::sides_of(const Evaluation& evaluation) const {
  std::vector<double> all;
  const auto& constraints = problem_.request.constraints;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const double scale = problem_.claim_scales[i];
    const double spare =
        std::min(problem_.request.tolerance, 0.05 * room_of(constraints[i].comparison) / scale);
    for (const double margin : tuning::sides_of(constraints[i].comparison, evaluation.claims[i]))
      all.push_back(bounded(-margin / scale + spare));
  }
  return all;
}

}  // namespace stepwire::tuning
