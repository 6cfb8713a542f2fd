#include "engine/analyse/estimation/refine.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/estimation/loss.hpp"
#include "engine/analyse/estimation/resolution.hpp"

namespace stepwire::estimation {

namespace {

constexpr int most_steps = 20;
constexpr double cost_rounding = 1e-12;  // relative, from one run to the next

/// A Gauss-Newton step within the bounds, and its size.
struct Step {
  Eigen::VectorXd to;
  double change = 0.0;  ///< Largest change relative to a value or its standard error.
};

class Refinement {
 public:
  Refinement(const Residuals& residuals, const FitRequest& request, Minimum found)
      : residuals_(residuals), request_(request), result_{std::move(found), {}, 0.0} {}

  Refined run(const std::atomic<bool>* interrupt) {
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_steps && !(interrupt && *interrupt); ++k) {
      if (!differentiate()) break;
      const Step step = next();
      result_.change = step.change;
      if (step.change <= request_.tolerance || !take(step, before)) break;
      before = step.change;
    }
    return std::move(result_);
  }

 private:
  /// Computes derivatives at the minimum. On failure returns false and keeps the last point with derivatives.
  bool differentiate() {
    KnownPoint at{result_.minimum.x, {}, {}};
    if (!residuals_.evaluate(at.x, at.residuals, at.slopes, Residuals::Differences::central)) return false;
    result_.at = std::move(at);
    return true;
  }

  /// Clears the columns of unknowns at a bound towards which the cost falls.
  void hold(const Eigen::VectorXd& r, Jacobian& slopes) const {
    const Eigen::VectorXd gradient = slopes.transpose() * r;
    for (Eigen::Index i = 0; i < gradient.size(); ++i) {
      const FitParameter& of = residuals_.parameter(static_cast<std::size_t>(i));
      const double x = result_.minimum.x[i];
      if ((x <= of.lower && gradient[i] > 0.0) || (x >= of.upper && gradient[i] < 0.0))
        slopes.col(i).setZero();
    }
  }

  Step next() const {
    Eigen::VectorXd r = result_.at.residuals;
    Jacobian slopes = result_.at.slopes;
    count(request_, r, slopes);
    hold(r, slopes);
    const Resolution resolved = Resolution::of(slopes);
    const Eigen::VectorXd along = -(resolved.inverse * (resolved.scaled.transpose() * r));
    const double s =
        r.norm() / std::sqrt(static_cast<double>(std::max<Eigen::Index>(1, r.size() - slopes.cols())));
    Step step{result_.minimum.x};
    for (Eigen::Index i = 0; i < along.size(); ++i) {
      const FitParameter& of = residuals_.parameter(static_cast<std::size_t>(i));
      const double x = result_.minimum.x[i];
      step.to[i] = std::clamp(x + along[i] / resolved.lengths[i], of.lower, of.upper);
      const double error = s * std::sqrt(std::max(0.0, resolved.inverse(i, i))) / resolved.lengths[i];
      const double size = std::max(std::abs(x), error);
      if (step.to[i] != x) step.change = std::max(step.change, std::abs(step.to[i] - x) / size);
    }
    return step;
  }

  /// Takes the step, or the first half, quarter, ... of it that lowers the cost. Near the minimum rounding
  /// error hides the gain; a full step is accepted there while steps become smaller.
  bool take(const Step& step, double before) {
    Eigen::VectorXd r;
    Minimum& best = result_.minimum;
    for (double part = 1.0; part > 1e-3; part *= 0.5) {
      const Eigen::VectorXd x = best.x + part * (step.to - best.x);
      if (!residuals_.evaluate(x, r)) continue;
      const double cost = cost_of(r, request_);
      const bool within_rounding =
          part == 1.0 && step.change < 0.5 * before && cost <= best.cost * (1.0 + cost_rounding);
      if (!(cost < best.cost) && !within_rounding) continue;
      best.cost = cost;
      best.x = x;
      return true;
    }
    return false;
  }

  const Residuals& residuals_;
  const FitRequest& request_;
  Refined result_;
};

}  // namespace

Refined refine(const Residuals& residuals, const FitRequest& request, Minimum found,
               const std::atomic<bool>* interrupt) {
  return Refinement(residuals, request, std::move(found)).run(interrupt);
}

}  // namespace stepwire::estimation
