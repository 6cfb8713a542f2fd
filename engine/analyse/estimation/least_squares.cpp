// Least squares within bounds by a trust region.
//
// A step s minimises the linear model |r + J s| subject to |D s| <= radius. D has the largest norms of the
// columns of J so far (J. J. More 1978). The first radius is |D x|, so that the first step changes no unknown
// by much more than its value. A radius holds searches that begin far away (NIST's BoxBOD, MGH10 and MGH17,
// start 1) in the region where the unknowns have an effect. A damping factor does not. In a narrow bent
// valley a straight step leaves the valley, and the search becomes slow. The geodesic acceleration corrects
// for the second derivative of the residuals along the step (M. K. Transtrum, J. P. Sethna 2012). It costs
// two additional runs, beside the step and at its end, and is accepted if it lowers the cost further. An
// unknown at a bound towards which the cost falls is held. A first step that crosses a bound ends before it,
// since a long step from a poor start would reach bounds at which the unknown has little effect. The second
// one in a row ends at the bound.
//
// A search that ends at a bound may have found a minimum there that is not the best one, e.g. a time constant
// that is too short for the record. It is repeated once with these unknowns in the middle of their bounds,
// and the better end is returned.
//
// The largest norms of a search from a poor start are those of the start, e.g. of an exponential, and hold
// all later steps. The search then ends where the cost still falls. Where the cosines between the residuals
// and the columns of J are not small at the end, it begins again from there with the norms of that point.
// This costs no run. It is repeated while it lowers the cost, a limited number of times.
#include "engine/analyse/estimation/least_squares.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/estimation/certainty.hpp"

namespace stepwire::estimation {
namespace {

constexpr double flat = 1e-3;  // cosine; differences of runs with few correct digits have more than rounding

bool is_held(const FitParameter& parameter, double x, double gradient) {
  return (x <= parameter.lower && gradient > 0.0) || (x >= parameter.upper && gradient < 0.0);
}

/// Linear model r + A s of residuals around a point, factorised for steps of several lengths.
class LinearModel {
 public:
  /// Factorises the model. A has more rows than columns.
  LinearModel(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& residuals);

  /// Returns the step s that minimises |r + A s| subject to |s| <= radius. Its damping is kept for answer().
  Eigen::VectorXd step(double radius);
  /// Returns the step that compensates a second-order change of the residuals, with the damping of the last
  /// step.
  Eigen::VectorXd answer(const Eigen::VectorXd& change) const;
  /// Returns the decrease of half the squared residuals by a step, as the model predicts it.
  double gain(const Eigen::VectorXd& step) const;

 private:
  Eigen::VectorXd damped(const Eigen::VectorXd& along, double damping) const;
  double damping_for(double radius) const;

  Eigen::MatrixXd slopes_;
  Eigen::VectorXd residuals_;
  Eigen::MatrixXd left_, right_;  ///< Singular vectors: A = left S right'.
  Eigen::VectorXd values_;        ///< Singular values; those within rounding error of zero are set to zero.
  Eigen::VectorXd along_;         ///< left' r
  double damping_ = 0.0;
};

LinearModel::LinearModel(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& residuals)
    : slopes_(slopes), residuals_(residuals) {
  const Eigen::Index count = slopes.cols();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(slopes);
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(triangle, Eigen::ComputeFullU | Eigen::ComputeFullV);
  values_ = svd.singularValues();
  const double zero =
      std::numeric_limits<double>::epsilon() * static_cast<double>(slopes.rows()) * values_.maxCoeff();
  values_ = (values_.array() > zero).select(values_, 0.0);
  right_ = svd.matrixV();
  left_ = qr.householderQ() * Eigen::MatrixXd::Identity(slopes.rows(), count) * svd.matrixU();
  along_ = left_.transpose() * residuals;
}

Eigen::VectorXd LinearModel::damped(const Eigen::VectorXd& along, double damping) const {
  Eigen::VectorXd parts = Eigen::VectorXd::Zero(along.size());
  for (Eigen::Index i = 0; i < parts.size(); ++i)
    if (values_[i] > 0.0) parts[i] = -values_[i] * along[i] / (values_[i] * values_[i] + damping);
  return right_ * parts;
}

/// Finds the damping by Newton's method on 1/|s| = 1/radius within bounds (J. J. More 1978). The radius is
/// met to one per cent, where More allows ten.
double LinearModel::damping_for(double radius) const {
  const Eigen::ArrayXd s = values_.array(), force = s * along_.array();
  double low = 0.0, high = force.matrix().norm() / radius, damping = 1e-3 * high;
  constexpr int most = 30;
  for (int k = 0; k < most; ++k) {
    if (damping <= low || damping > high) damping = std::max(1e-3 * high, std::sqrt(low * high));
    const Eigen::ArrayXd below = s.square() + damping;
    const double length = (force / below).matrix().norm(), excess = length - radius;
    if (std::abs(excess) <= 0.01 * radius) break;
    (excess < 0.0 ? high : low) = damping;
    const double slope = -(force.square() / below.cube()).sum() / length;
    damping -= length / radius * excess / slope;
  }
  return damping;
}

Eigen::VectorXd LinearModel::step(double radius) {
  damping_ = 0.0;
  Eigen::VectorXd whole = damped(along_, 0.0);
  if (whole.norm() <= radius) return whole;
  damping_ = damping_for(radius);
  Eigen::VectorXd result = damped(along_, damping_);
  return result * std::min(1.0, radius / result.norm());
}

Eigen::VectorXd LinearModel::answer(const Eigen::VectorXd& change) const {
  return damped(left_.transpose() * change, damping_);
}

double LinearModel::gain(const Eigen::VectorXd& step) const {
  const Eigen::VectorXd moved = slopes_ * step;
  return -moved.dot(residuals_ + 0.5 * moved);
}

constexpr double poor = 0.25, good = 0.75;  // Actual over predicted decrease of a step.
constexpr double probe = 0.1;               // Share of a step, for the second derivative along it.
constexpr double most_bend = 0.15;          // Limit of the acceleration over the step.
constexpr double shortest = 1e-10;          // Limit of the step over the size of the unknowns.
constexpr int most_restarts = 20;

/// Residuals after the loss, their derivatives, and half the sum of their squares.
struct Counts {
  Eigen::VectorXd r;
  Jacobian slopes;
  double cost = std::numeric_limits<double>::infinity();
};

/// Returns the least relative decrease of the cost after which another step follows. The cost of `freedom`
/// rows is half of freedom s^2, and one standard error costs s^2 / 2. Below this decrease, no unknown moves
/// by more than about a hundredth of its standard error. A larger tolerance allows more, as the cost changes
/// by its square.
double smallest_gain(const Residuals& residuals, Eigen::Index unknowns, double tolerance) {
  constexpr double part = 1e-4;
  const double freedom = static_cast<double>(residuals.count() - unknowns);
  return std::max(std::clamp(part / std::max(1.0, freedom), 1e-10, 1e-8), tolerance * tolerance);
}

class Descent {
 public:
  Descent(const Residuals& residuals, const FitRequest& request, const LeastSquaresOptions& options)
      : residuals_(residuals), request_(request), options_(options) {}

  Minimum run(const Eigen::VectorXd& start) {
    found_.x = start;
    if (!begin()) return found_;
    const double gain = smallest_gain(residuals_, start.size(), request_.tolerance);
    while (found_.iterations < options_.iterations && !found_.converged && !found_.stalled) {
      if (options_.watch) options_.watch(found_.iterations, found_.cost);
      if (options_.interrupt && *options_.interrupt) break;
      advance(gain);
      ++found_.iterations;
    }
    return found_;
  }

 private:
  const FitParameter& parameter(Eigen::Index i) const {
    return residuals_.parameter(static_cast<std::size_t>(i));
  }

  bool begin() {
    const Eigen::VectorXd& x = found_.x;
    KnownPoint point = options_.known;
    if (point.x.size() != x.size() || point.x != x) point = {x, {}, {}};
    if (point.residuals.size() == 0 && !evaluate(x, point.residuals)) return false;
    if (point.slopes.size() == 0 && !differentiate(x, point.residuals, point.slopes)) return false;
    take(std::move(point));
    set_radius();
    return true;
  }

  void set_radius() {
    Eigen::VectorXd sizes = found_.x.cwiseAbs();
    for (Eigen::Index i = 0; i < sizes.size(); ++i) sizes[i] = std::max(sizes[i], parameter(i).scale);
    radius_ = metric_.cwiseProduct(sizes).norm();
  }

  /// Ends the search at a minimum; elsewhere begins again with the metric of this point. A search that has
  /// begun again without effect has stalled. Values that the diagram refuses may hold it, too.
  void end_or_begin_again(double gain) {
    found_.converged = still_falling(residuals_, request_, found_.x, here_.r, here_.slopes).empty();
    if (found_.converged) return;
    found_.stalled = restarts_++ == most_restarts || !(found_.cost < begun_at_ * (1.0 - gain));
    begun_at_ = found_.cost;
    metric_.resize(0);
    add_to_metric();
    set_radius();
  }

  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& r) {
    if (residuals_.evaluate(x, r)) return true;
    if (found_.refusal.empty()) found_.refusal = residuals_.refusal(x);  // otherwise the run failed
    return false;
  }

  bool differentiate(const Eigen::VectorXd& x, const Eigen::VectorXd& r, Jacobian& slopes) const {
    return residuals_.differentiate(x, r, slopes, Residuals::Differences::forward);
  }

  void take(KnownPoint point) {
    found_.x = std::move(point.x);
    found_.cost = cost_of(point.residuals, request_);
    here_ = {std::move(point.residuals), std::move(point.slopes), found_.cost};
    count(request_, here_.r, here_.slopes);
    add_to_metric();
  }

  /// Makes the metric that of the largest derivatives so far.
  void add_to_metric() {
    const Eigen::VectorXd lengths = here_.slopes.colwise().norm();
    metric_ = metric_.size() == 0 ? lengths : Eigen::VectorXd(metric_.cwiseMax(lengths));
    for (Eigen::Index i = 0; i < metric_.size(); ++i)
      if (!(metric_[i] > 0.0)) metric_[i] = 1.0 / parameter(i).scale;
  }

  /// Returns the derivatives by the unknowns in units of the metric; columns of unknowns held at a bound are
  /// 0.
  Eigen::MatrixXd free_slopes() const {
    const Eigen::VectorXd gradient = here_.slopes.transpose() * here_.r;
    Eigen::MatrixXd slopes = here_.slopes * metric_.cwiseInverse().asDiagonal();
    for (Eigen::Index i = 0; i < gradient.size(); ++i)
      if ((found_.x[i] <= parameter(i).lower && gradient[i] > 0.0) ||
          (found_.x[i] >= parameter(i).upper && gradient[i] < 0.0))
        slopes.col(i).setZero();
    return slopes;
  }

  /// Returns the bound that the end of a step crosses in each unknown; NaN where it crosses none.
  Eigen::VectorXd crossed_by(const Eigen::VectorXd& step) const {
    Eigen::VectorXd bounds = found_.x + step.cwiseQuotient(metric_);
    for (double* x = bounds.data(); x != bounds.data() + bounds.size(); ++x) {
      const FitParameter& of = parameter(x - bounds.data());
      *x = *x < of.lower ? of.lower : *x > of.upper ? of.upper : std::numeric_limits<double>::quiet_NaN();
    }
    return bounds;
  }

  /// Returns the end point of a step, cut before a bound that it crosses, and at a bound that the step before
  /// has crossed, too.
  Eigen::VectorXd end_of(const Eigen::VectorXd& step) const {
    constexpr double share = 0.9;
    Eigen::VectorXd x = found_.x + step.cwiseQuotient(metric_);
    const Eigen::VectorXd bounds = crossed_by(step);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      if (std::isnan(bounds[i])) continue;
      const bool again = crossed_.size() > 0 && crossed_[i] == bounds[i];
      x[i] = again ? bounds[i] : found_.x[i] + share * (bounds[i] - found_.x[i]);
    }
    return x;
  }

  KnownPoint at(Eigen::VectorXd x) {
    KnownPoint point{std::move(x), {}, {}};
    if (!evaluate(point.x, point.residuals)) point.residuals.resize(0);
    return point;
  }

  double cost(const KnownPoint& point) const {
    return point.residuals.size() == 0 ? std::numeric_limits<double>::infinity()
                                       : cost_of(point.residuals, request_);
  }

  /// Tries one step; it may be rejected.
  void advance(double gain) {
    LinearModel model(free_slopes(), here_.r);
    const Eigen::VectorXd whole = model.step(radius_);
    KnownPoint next = at(end_of(whole));
    const Eigen::VectorXd step = (next.x - found_.x).cwiseProduct(metric_);
    const double expected = model.gain(step), length = step.norm();
    if (expected > gain * found_.cost && (step - whole).norm() <= 1e-6 * length)
      next = bent(std::move(next), model, step);
    const double reached = cost(next);
    const bool small = length <= shortest * metric_.cwiseProduct(found_.x).norm();
    const bool flat = std::abs(found_.cost - reached) <= gain * found_.cost && expected <= gain * found_.cost;
    resize(expected > 0.0 ? (found_.cost - reached) / expected : -1.0, length);
    if (reached < found_.cost && differentiate(next.x, next.residuals, next.slopes)) {
      crossed_ = crossed_by(whole);
      take(std::move(next));
    }
    if (small || flat) end_or_begin_again(gain);
  }

  void resize(double share, double length) {
    if (!(share >= poor))
      radius_ = poor * std::min(length, radius_);
    else if (share > good && length > 0.95 * radius_)
      radius_ *= 2.0;
  }

  /// Returns the end of a step with acceleration if that is small and lowers the cost further; else the
  /// straight end.
  KnownPoint bent(KnownPoint straight, const LinearModel& model, const Eigen::VectorXd& step) {
    Eigen::VectorXd beside;
    if (!residuals_.evaluate(end_of(probe * step), beside)) return straight;
    Jacobian none;
    count(request_, beside, none);
    const Eigen::VectorXd along = here_.slopes * step.cwiseQuotient(metric_);
    const Eigen::VectorXd change = 2.0 / probe * ((beside - here_.r) / probe - along);
    const Eigen::VectorXd answer = 0.5 * model.answer(change);
    if (!(answer.norm() <= most_bend * step.norm())) return straight;
    KnownPoint end = at(end_of(step + answer));
    return cost(end) < cost(straight) ? end : straight;
  }

  const Residuals& residuals_;
  const FitRequest& request_;
  const LeastSquaresOptions& options_;
  Minimum found_;
  Counts here_;
  Eigen::VectorXd metric_, crossed_{};  ///< crossed_: bounds that the last step crossed, NaN without one.
  double radius_ = 0.0;
  int restarts_ = 0;
  double begun_at_ = std::numeric_limits<double>::infinity();  ///< Cost at the last restart.
};

}  // namespace

std::vector<FallingUnknown> still_falling(const Residuals& residuals, const FitRequest& request,
                                          const Eigen::VectorXd& x, const Eigen::VectorXd& r,
                                          const Jacobian& slopes) {
  std::vector<FallingUnknown> falling;
  const double size = r.norm();
  const auto freedom = static_cast<double>(std::max<Eigen::Index>(1, r.size() - x.size()));
  const double least = std::max(flat, request.tolerance / std::sqrt(freedom));
  for (Eigen::Index i = 0; i < slopes.cols() && size > 0.0; ++i) {
    const FitParameter& parameter = residuals.parameter(static_cast<std::size_t>(i));
    const double length = slopes.col(i).norm(), gradient = slopes.col(i).dot(r);
    if (!(length > 0.0) || is_held(parameter, x[i], gradient)) continue;
    const double cosine = std::abs(gradient) / (length * size), change = cosine * size / length;
    const bool small = change <= request.tolerance * std::max(std::abs(x[i]), parameter.scale);
    if (cosine > least && !small) falling.push_back({i, cosine});
  }
  return falling;
}

std::string falling_text(const std::vector<FallingUnknown>& falling, const std::vector<std::string>& names) {
  std::vector<std::string> along;
  double most = 0.0;
  for (const FallingUnknown& one : falling) {
    along.push_back(names[static_cast<std::size_t>(one.unknown)]);
    most = std::max(most, one.cosine);
  }
  return fmt::format(
      "no minimum: the search has ended where the cost still falls along {} (cosine between residuals and "
      "derivatives up to {:.2g}, at a minimum 0); {}",
      fmt::join(along, ", "), most, elsewhere);
}

namespace {

/// Returns the middle between two bounds, that of the logarithms where they are more than tenfold apart.
double middle_of(const FitParameter& parameter) {
  const double low = parameter.lower, high = parameter.upper;
  const bool wide = low * high > 0.0 && std::max(low / high, high / low) > 10.0;
  return wide ? std::copysign(std::sqrt(low * high), low) : 0.5 * (low + high);
}

/// Returns x with the unknowns at a bound moved inside: to the middle of two bounds, or to the start where
/// the other side is open.
Eigen::VectorXd moved_inside(const Residuals& residuals, Eigen::VectorXd x, const Eigen::VectorXd& start) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const FitParameter& parameter = residuals.parameter(static_cast<std::size_t>(i));
    if (x[i] > parameter.lower && x[i] < parameter.upper) continue;
    x[i] = parameter.bounded() ? middle_of(parameter) : start[i];
  }
  return x;
}

}  // namespace

Minimum minimise(const Residuals& residuals, const FitRequest& request, const Eigen::VectorXd& start,
                 const LeastSquaresOptions& options) {
  Minimum found = Descent(residuals, request, options).run(start);
  const Eigen::VectorXd inside = found.converged ? moved_inside(residuals, found.x, start) : found.x;
  if (inside == found.x || found.iterations >= options.iterations) return found;
  const std::size_t before = found.iterations;
  LeastSquaresOptions again{options.iterations - before, options.interrupt};
  if (options.watch)
    again.watch = [&](std::size_t step, double cost) {
      options.watch(before + step, std::min(cost, found.cost));
    };
  Minimum other = Descent(residuals, request, again).run(inside);
  found.iterations = other.iterations += before;
  constexpr double better = 1e-9;  // relative
  return other.cost < found.cost * (1.0 - better) ? other : found;
}

}  // namespace stepwire::estimation
