#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/simulate/solve/bracket.hpp"
#include "engine/simulate/solve/loop_task.hpp"

namespace stepwire::solve {

/// Solves an algebraic loop z = g(z), where z are the numbers at which the loop is torn and g is one pass
/// through its blocks.
///
/// Newton's method starts at the last solution. Each correction is damped until the next one is smaller
/// (Deuflhard 2011, Newton Methods for Nonlinear Problems, 3.3). The Jacobian is computed by differences and
/// reused while corrections shrink tenfold, so a linear loop needs it once. If Newton's method fails, a loop
/// of one number is solved by bracketing, and then all is tried again from 0, or from 1. With `max_unknowns`
/// no memory is allocated, and the results are the same to the last bit.
///
/// The residual of the last solution is stored. A loop that has it at its guess has the same inputs as then,
/// so the guess is the solution. Without this test a loop that is computed twice at one instant would lose
/// its last bits, where rounding is left in the residual.
template <int max_unknowns = Eigen::Dynamic>
class LoopSolver {
 public:
  explicit LoopSolver(Eigen::Index unknowns) : factors_(unknowns) {
    for (Vector* vector : {&guess_, &residual_, &point_, &base_, &step_, &next_, &size_, &scale_})
      vector->setZero(unknowns);
    jacobian_.setZero(unknowns, unknowns);
  }

  /// Solves the loop. pass() computes the outputs of the loop's blocks from the workspace. On return the torn
  /// numbers and their dependents solve the loop. Without a solution, that is written to the report.
  template <class Pass>
  void solve(const LoopTask& loop, double* values, const Pass& pass) {
    passes_ = 0;
    const auto evaluate = [&] {
      put(loop, values);
      pass();
      take(loop, values);
      ++passes_;
      is_at_guess_ = true;
    };
    save_diagnostics(loop, values);
    read(loop, values);
    scale_ = guess_.cwiseAbs().cwiseMax(small_size);
    const bool solved = search(loop, values, evaluate);
    if (take_back_diagnostics(loop, values) || !is_at_guess_) evaluate();
    put(loop, values);
    store_residual(loop, values, solved);
    report(loop, values, solved);
  }

 private:
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_unknowns, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_unknowns, max_unknowns>;

  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  static constexpr double smallest = 1e-20;      // Fraction of a signal's size that counts as 0.
  static constexpr double smallest_size = 1e-9;  // Size of a signal that is 0, in its SI unit.
  static constexpr double small_size = 1e-3;     // Size below which rounding dominates.
  static constexpr double shortest = 1e-12;      // Smallest damping factor.
  static constexpr double keeps_matrix = 0.1;    // Largest ratio of corrections for reuse of the matrix.
  static constexpr int most_polishes = 4;        // Matrices by close differences.

  template <class Visit>
  static void each_number(const LoopTask& loop, double* values, const Visit& visit) {
    Eigen::Index i = 0;
    for (std::size_t t = 0; t < loop.tear_count; ++t)
      for (std::size_t k = 0; k < loop.tears[t].size; ++k) visit(i++, values[loop.tears[t].offset + k]);
  }
  void read(const LoopTask& loop, double* values) {
    each_number(loop, values, [&](Eigen::Index i, const double& place) { guess_[i] = place; });
  }
  void put(const LoopTask& loop, double* values) {
    each_number(loop, values, [&](Eigen::Index i, double& place) { place = guess_[i]; });
  }
  void take(const LoopTask& loop, double* values) {
    each_number(loop, values, [&](Eigen::Index i, const double& place) { residual_[i] = place - guess_[i]; });
  }

  template <class Visit>
  static void each_residual(const LoopTask& loop, double* values, const Visit& visit) {
    Eigen::Index i = 0;
    for (std::size_t t = 0; t < loop.tear_count; ++t)
      for (std::size_t k = 0; k < loop.tears[t].size; ++k) visit(i++, values[loop.tears[t].residual + k]);
  }
  void store_residual(const LoopTask& loop, double* values, bool solved) {
    each_residual(loop, values, [&](Eigen::Index i, double& place) {
      place = solved ? residual_[i] : std::numeric_limits<double>::quiet_NaN();
    });
  }
  bool is_stored_residual(const LoopTask& loop, double* values) const {
    bool same = true;
    each_residual(loop, values,
                  [&](Eigen::Index i, const double& place) { same = same && residual_[i] == place; });
    return same;
  }

  static void save_diagnostics(const LoopTask& loop, double* values) {
    for (std::size_t d = 0; d < loop.diagnostic_count; ++d)
      values[loop.report + LoopReport::count + d] = values[loop.diagnostics[d]];
  }
  /// Restores the diagnostics. Returns true if a pass has raised one; the last pass may then have to raise it
  /// again.
  static bool take_back_diagnostics(const LoopTask& loop, double* values) {
    bool raised = false;
    for (std::size_t d = 0; d < loop.diagnostic_count; ++d) {
      double& now = values[loop.diagnostics[d]];
      const double before = values[loop.report + LoopReport::count + d];
      raised = raised || now != before;
      now = before;
    }
    return raised;
  }

  template <class Evaluate>
  bool search(const LoopTask& loop, double* values, const Evaluate& evaluate) {
    const bool from_zero = guess_.isZero(0.0);
    evaluate();
    if (is_stored_residual(loop, values)) return true;
    if (search_from_here(loop, evaluate)) return true;
    if (!may_close_in(loop)) return false;
    guess_.setConstant(from_zero ? 1.0 : 0.0);
    evaluate();
    return search_from_here(loop, evaluate);
  }

  /// Searches from the guess, whose residual is known.
  template <class Evaluate>
  bool search_from_here(const LoopTask& loop, const Evaluate& evaluate) {
    point_ = guess_;
    if (is_rounding()) return true;
    if (!residual_.allFinite()) return false;
    const double start = guess_[0];
    if (newton(loop, evaluate)) return true;
    if (guess_.size() > 1 || !may_close_in(loop)) return false;
    guess_[0] = start;
    return close_in(loop, evaluate);
  }

  /// True if passes are left for more than the end of a search.
  bool may_close_in(const LoopTask& loop) const { return passes_ + 4 < loop.max_passes; }

  /// True if the residual of the guess is at rounding level.
  bool is_rounding() const {
    for (Eigen::Index i = 0; i < guess_.size(); ++i)
      if (!(std::abs(residual_[i]) <= epsilon * std::abs(guess_[i]))) return false;
    return true;
  }

  /// Runs Newton's method from the guess, whose residual is known.
  template <class Evaluate>
  bool newton(const LoopTask& loop, const Evaluate& evaluate) {
    int polishes = 0;
    while (passes_ + guess_.size() < loop.max_passes) {
      renew(evaluate, polishes > 0);
      bool fresh = true, keeps = true;
      while (keeps) {
        if (is_negligible()) return true;
        double size = measure(step_);
        if (!std::isfinite(size)) return false;
        const double part = go(loop, evaluate, size, fresh ? shortest : 0.75);
        const double next = measure(next_);
        const bool rests = part == 1.0 && !(next <= 0.75 * size) && is_at_rest(loop);
        if (rests && (is_rounding_step() || polishes++ == most_polishes)) return true;
        if (part == 0.0 && fresh) return false;
        fresh = false;
        keeps = part == 1.0 && next <= keeps_matrix * size && !rests;
        point_ = guess_;
        base_ = residual_;
        step_ = next_;
      }
    }
    return is_negligible();
  }

  /// Computes a new matrix at the guess, and the correction with it. `closely` is set beside a kink.
  template <class Evaluate>
  void renew(const Evaluate& evaluate, bool closely) {
    point_ = guess_;
    base_ = residual_;
    differentiate(evaluate, closely);
    residual_ = base_;
    // A number that is not computed at this instant keeps its value.
    for (Eigen::Index i = 0; i < guess_.size(); ++i)
      if (base_[i] == 0.0 && jacobian_.row(i).isZero(0.0)) jacobian_(i, i) = -1.0;
    factors_.compute(jacobian_);
    step_ = factors_.solve(base_);
    step_ = -step_;
    size_ = point_.cwiseAbs().cwiseMax(step_.cwiseAbs()).cwiseMax(smallest_size);
  }

  /// Computes the Jacobian by forward differences. Where a signal is 0, its residual is the scale of the
  /// difference. Close differences are a hundredth of the last correction. So they stay on one side of a
  /// kink, such as a limit, near which a correction is within the tolerance.
  template <class Evaluate>
  void differentiate(const Evaluate& evaluate, bool closely) {
    const double part = std::sqrt(epsilon);
    for (Eigen::Index j = 0; j < guess_.size(); ++j) {
      const double size = std::max({std::abs(point_[j]), std::min(std::abs(base_[j]), 1.0), smallest_size});
      const double change =
          closely ? std::max(0.01 * std::abs(step_[j]), 64.0 * epsilon * size) : part * size;
      guess_[j] = point_[j] + change;
      evaluate();
      jacobian_.col(j) = (residual_ - base_) / (guess_[j] - point_[j]);
      guess_[j] = point_[j];
    }
    is_at_guess_ = false;
  }

  /// Moves from the point along the correction until the next correction is smaller. Returns the damping
  /// factor. Returns 0 if there is none, and also 1 if only rounding is left.
  template <class Evaluate>
  double go(const LoopTask& loop, const Evaluate& evaluate, double size, double shortest_part) {
    for (double part = 1.0; part > shortest_part && passes_ < loop.max_passes; part *= 0.5) {
      guess_ = point_ + part * step_;
      evaluate();
      next_ = factors_.solve(residual_);
      next_ = -next_;
      if (measure(next_) <= (1.0 - 0.25 * part) * size) return part;
      if (part == 1.0 && residual_.allFinite() && is_at_rest(loop)) return part;
    }
    guess_ = point_;
    residual_ = base_;
    is_at_guess_ = false;
    return 0.0;
  }

  /// Returns the size of a correction, relative to the signals at the point of the matrix.
  double measure(const Vector& correction) const {
    double size = 0.0;
    for (Eigen::Index i = 0; i < correction.size(); ++i) {
      if (!std::isfinite(correction[i])) return std::numeric_limits<double>::infinity();
      if (correction[i] != 0.0) size = std::max(size, std::abs(correction[i]) / size_[i]);
    }
    return size;
  }

  /// True if the correction would change no bit.
  bool is_negligible() const {
    for (Eigen::Index i = 0; i < step_.size(); ++i)
      if (!(std::abs(step_[i]) <= 0.5 * epsilon * std::max(std::abs(point_[i]), smallest * scale_[i])))
        return false;
    return true;
  }

  /// True if the correction is at rounding level.
  bool is_rounding_step() const {
    for (Eigen::Index i = 0; i < step_.size(); ++i)
      if (!(std::abs(step_[i]) <= 64.0 * epsilon * std::max(std::abs(point_[i]), scale_[i]))) return false;
    return true;
  }

  /// True if the correction is within the tolerance.
  bool is_at_rest(const LoopTask& loop) const {
    for (Eigen::Index i = 0; i < step_.size(); ++i)
      if (!(std::abs(step_[i]) <= loop.tolerance * std::max(std::abs(point_[i]), scale_[i]))) return false;
    return true;
  }

  template <class Evaluate>
  bool close_in(const LoopTask& loop, const Evaluate& evaluate) {
    const auto residual_at = [&](double at) {
      guess_[0] = at;
      evaluate();
      return residual_[0];
    };
    const Bracket found = bracket_root(
        guess_[0], loop.tolerance, [&] { return may_close_in(loop); }, residual_at);
    residual_at(found.root);
    return found.solved;
  }

  void report(const LoopTask& loop, double* values, bool solved) const {
    double* report = values + loop.report;
    const double passes = static_cast<double>(passes_);
    report[LoopReport::instants] += 1.0;
    report[LoopReport::passes] += passes;
    report[LoopReport::most] = std::max(report[LoopReport::most], passes);
    if (solved) return;
    report[LoopReport::unsolved] += 1.0;
    if (report[LoopReport::unsolved] > 1.0) return;
    report[LoopReport::time] = values[loop.time];
    Eigen::Index worst = 0;
    for (Eigen::Index i = 0; i < residual_.size(); ++i)
      if (!(std::abs(residual_[i]) <= std::abs(residual_[worst]))) worst = i;
    report[LoopReport::residual] = std::abs(residual_[worst]);
    report[LoopReport::number] = static_cast<double>(worst);
  }

  Vector guess_, residual_;     ///< The iterate z and its residual g(z) - z.
  Vector point_, base_, step_;  ///< Last point of the matrix, its residual and its correction.
  Vector next_;                 ///< Correction at the guess, with the same matrix.
  Vector size_, scale_;         ///< Sizes of the signals at the matrix, and at the start.
  Matrix jacobian_;
  Eigen::PartialPivLU<Matrix> factors_;
  std::int64_t passes_ = 0;
  bool is_at_guess_ = false;  ///< true if the last pass was computed with this guess
};

}  // namespace stepwire::solve
