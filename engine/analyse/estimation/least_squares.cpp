#include "engine/analyse/estimation/least_squares.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/estimation/loss.hpp"

namespace stepwire::estimation {

namespace {

/// The residuals as Ceres takes them, with the unknowns in parts of their scales.
class Cost : public ceres::CostFunction {
 public:
  Cost(const Residuals& residuals, const FitRequest& request, const Eigen::VectorXd& scales, KnownPoint known)
      : residuals_(residuals), request_(request), scales_(scales), known_(std::move(known)) {
    set_num_residuals(static_cast<int>(residuals.count()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(scales.size()));
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::VectorXd x =
        Eigen::Map<const Eigen::VectorXd>(parameters[0], scales_.size()).cwiseProduct(scales_);
    const bool wanted = jacobians && jacobians[0];
    if (!know(x, wanted)) {
      if (best_.refusal.empty()) best_.refusal = residuals_.refusal(x);  // else it blew up
      return false;
    }
    Eigen::VectorXd r = known_.residuals;
    Jacobian slopes;
    if (wanted) slopes = known_.slopes * scales_.asDiagonal();
    count(request_, r, slopes);
    if (const double cost = 0.5 * r.squaredNorm(); cost < best_.cost) {
      best_.cost = cost;
      best_.x = x;
    }
    std::copy_n(r.data(), r.size(), residuals);
    if (wanted) std::copy_n(slopes.data(), slopes.size(), jacobians[0]);
    return true;
  }

  /// The best point so far: a search may end at another, and Ceres takes nothing from one that failed.
  const Minimum& best() const { return best_; }

 private:
  bool know(const Eigen::VectorXd& x, bool slopes) const {
    if (known_.x.size() != x.size() || known_.x != x) {
      known_ = {};
      if (!residuals_.evaluate(x, known_.residuals)) return false;
      known_.x = x;
    }
    return !slopes || known_.slopes.size() > 0 ||
           residuals_.differentiate(x, known_.residuals, known_.slopes, Residuals::Differences::forward);
  }

  const Residuals& residuals_;
  const FitRequest& request_;
  const Eigen::VectorXd& scales_;
  mutable Minimum best_;
  mutable KnownPoint known_;  ///< the last one; Ceres asks for the cost of a step first, for its slopes later
};

class Watch : public ceres::IterationCallback {
 public:
  /// `before`: steps that have been done already.
  Watch(const LeastSquaresOptions& options, std::size_t before) : options_(options), before_(before) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (options_.watch) options_.watch(before_ + static_cast<std::size_t>(summary.iteration), summary.cost);
    return options_.interrupt && *options_.interrupt ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                     : ceres::SOLVER_CONTINUE;
  }

 private:
  const LeastSquaresOptions& options_;
  std::size_t before_;
};

/// A part of a search: how far a step may go at first (in Ceres' measure), and the part of the cost that a
/// step must gain for the next one to be tried.
struct Phase {
  double radius, gain;
};
/// Far from a minimum, long steps leave its valley. Near it, where one step gains little of the cost, they
/// are right, and short ones creep along what the records tell little of: two parameters that go together.
constexpr double near_minimum = 0.1, short_steps = 1e4, long_steps = 1e10;

/// What a step may still gain, in parts of the cost: so little that no unknown moves by more than some
/// hundredth of its standard error. (The cost of `freedom` rows is half of freedom s^2, and one standard
/// error costs s^2 / 2.)
double smallest_gain(const Residuals& residuals, Eigen::Index unknowns) {
  constexpr double part = 1e-4;
  const double freedom = static_cast<double>(residuals.count() - unknowns);
  return std::clamp(part / std::max(1.0, freedom), 1e-10, 1e-8);
}

ceres::Solver::Options solver_options(const Phase& phase, std::size_t iterations, Watch& watch) {
  ceres::Solver::Options result;
  result.linear_solver_type = ceres::DENSE_QR;
  result.max_num_iterations = static_cast<int>(iterations);
  result.initial_trust_region_radius = phase.radius;
  result.function_tolerance = phase.gain;
  // Where bounds shorten a step, Ceres would look at the slopes of each length that it tries.
  result.line_search_interpolation_type = ceres::QUADRATIC;
  result.max_num_consecutive_invalid_steps = 20;  // a step may lead where the model blows up
  result.parameter_tolerance = 1e-10;
  result.gradient_tolerance = 1e-14;
  result.logging_type = ceres::SILENT;
  result.update_state_every_iteration = true;
  result.callbacks.push_back(&watch);
  return result;
}

/// What Ceres writes of points that cannot be evaluated is not for people: a fit says what it found.
void keep_log_inside() {
  FLAGS_minloglevel = google::GLOG_FATAL;
}

void set_bounds(const Residuals& residuals, Eigen::VectorXd& scaled, ceres::Problem& problem) {
  for (int at = 0; at < static_cast<int>(scaled.size()); ++at) {
    const FitParameter& parameter = residuals.parameter(static_cast<std::size_t>(at));
    if (parameter.lower > -FitParameter::open)
      problem.SetParameterLowerBound(scaled.data(), at, parameter.lower / parameter.scale);
    if (parameter.upper < FitParameter::open)
      problem.SetParameterUpperBound(scaled.data(), at, parameter.upper / parameter.scale);
  }
}

/// Scaling may round beyond a bound.
void keep_within_bounds(const Residuals& residuals, Eigen::VectorXd& x) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const FitParameter& parameter = residuals.parameter(static_cast<std::size_t>(i));
    x[i] = std::clamp(x[i], parameter.lower, parameter.upper);
  }
}

struct Descent {
  std::size_t steps = 0;
  bool converged = false;
};

/// Both phases of a search, up to a step that gains less than `gain` of the cost.
Descent descend(ceres::Problem& problem, double gain, const LeastSquaresOptions& options) {
  Descent done;
  for (const Phase& phase : {Phase{short_steps, near_minimum}, Phase{long_steps, gain}}) {
    Watch watch(options, done.steps);
    ceres::Solver::Summary summary;
    ceres::Solve(solver_options(phase, options.iterations - done.steps, watch), &problem, &summary);
    done.steps += summary.iterations.size() - std::min<std::size_t>(1, summary.iterations.size());
    done.converged = summary.termination_type == ceres::CONVERGENCE;
    if (!done.converged) break;
  }
  return done;
}

}  // namespace

Minimum minimise(const Residuals& residuals, const FitRequest& request, const Eigen::VectorXd& start,
                 const LeastSquaresOptions& options) {
  keep_log_inside();
  Eigen::VectorXd scales(start.size());
  for (Eigen::Index i = 0; i < start.size(); ++i)
    scales[i] = residuals.parameter(static_cast<std::size_t>(i)).scale;
  Eigen::VectorXd scaled = start.cwiseQuotient(scales);
  Cost cost(residuals, request, scales, options.known);
  ceres::Problem::Options kept;
  kept.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(kept);
  problem.AddResidualBlock(&cost, nullptr, scaled.data());
  set_bounds(residuals, scaled, problem);
  const Descent descent = descend(problem, smallest_gain(residuals, start.size()), options);
  Minimum found = cost.best();
  found.iterations = descent.steps;
  if (!std::isfinite(found.cost)) {  // not even the start could be evaluated
    found.x = start;
    return found;
  }
  keep_within_bounds(residuals, found.x);
  found.converged = descent.converged;
  return found;
}

}  // namespace stepwire::estimation
