#include "engine/solve/rosenbrock_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire {

namespace {

const double root_epsilon = std::sqrt(std::numeric_limits<double>::epsilon());
constexpr double smallest_scale = 1e-9;  // of a state at rest at 0, in its own SI unit
const double d = 1.0 / (2.0 + std::sqrt(2.0));

}  // namespace

RosenbrockSolver::RosenbrockSolver(std::size_t states) : factors_(static_cast<Eigen::Index>(states)) {
  const auto n = static_cast<Eigen::Index>(states);
  for (Eigen::VectorXd* vector : {&start_, &slope0_, &slope1_, &slope_time_, &k1_, &k2_, &right_})
    vector->setZero(n);
  jacobian_.setZero(n, n);
}

void RosenbrockSolver::differentiate(System& system, double time, double step) {
  const auto n = static_cast<Eigen::Index>(system.count);
  Eigen::Map<Eigen::VectorXd> x(system.x, n);
  const Eigen::Map<const Eigen::VectorXd> dot(system.dot, n);
  *system.time = time;
  for (Eigen::Index j = 0; j < n; ++j) {
    // The slope's own scale keeps the difference above rounding where the state passes through 0.
    const double scale = std::max({std::abs(start_[j]), std::abs(step * slope0_[j]), smallest_scale});
    const double moved = start_[j] + root_epsilon * scale;
    x[j] = moved;
    system.evaluate();
    jacobian_.col(j) = (dot - slope0_) / (moved - start_[j]);
    x[j] = start_[j];
  }
  // Far from time 0 a tiny fraction of a step is lost in rounding; a tenth of the step is not, and its error
  // is of the method's own order.
  const double ahead = time + 0.1 * step;
  *system.time = ahead;
  system.evaluate();
  slope_time_ = (dot - slope0_) / (ahead - time);
}

void RosenbrockSolver::advance(System& system, double time, double step) {
  const auto n = static_cast<Eigen::Index>(system.count);
  Eigen::Map<Eigen::VectorXd> x(system.x, n);
  const Eigen::Map<const Eigen::VectorXd> dot(system.dot, n);
  start_ = x;
  slope0_ = dot;
  differentiate(system, time, step);
  jacobian_ *= -step * d;
  jacobian_.diagonal().array() += 1.0;
  factors_.compute(jacobian_);
  right_ = slope0_ + (step * d) * slope_time_;
  k1_ = factors_.solve(right_);
  x = start_ + (0.5 * step) * k1_;
  *system.time = time + 0.5 * step;
  system.evaluate();
  right_ = dot - k1_;
  k2_ = factors_.solve(right_);
  x = start_ + step * (k2_ + k1_);
}

}  // namespace stepwire
