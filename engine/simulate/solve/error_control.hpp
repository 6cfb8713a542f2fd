#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "engine/base/math/elementary.hpp"
#include "engine/simulate/solve/step_report.hpp"

namespace stepwire::solve {

/// Tolerances of the step size control. An error of `relative |x| + absolute` counts as 1.
struct ErrorControl {
  double relative = 1e-6;
  double absolute = 1e-9;           ///< In the SI unit of the state.
  std::int64_t max_steps = 100000;  ///< Limit between two instants, with rejected steps.
};

/// State of the step size control, as indices into numbers of the workspace. The first three numbers are a
/// StepReport.
struct ControlReport {
  static constexpr std::size_t next = 3;      ///< Length of the next step [s]; 0 before the first.
  static constexpr std::size_t before = 4;    ///< Error of the last step.
  static constexpr std::size_t steps = 5;     ///< Number of accepted steps.
  static constexpr std::size_t rejected = 6;  ///< Number of rejected steps.
  static constexpr std::size_t largest = 7;   ///< Largest error of an accepted step.
  static constexpr std::size_t stiff = 8;  ///< 1 once an automatic solver has switched to the stiff method.
  static constexpr std::size_t signs = 9;  ///< Accumulated evidence for stiffness.
  static constexpr std::size_t sizes =
      10;  ///< From here: largest modulus of each state at the ends of steps.
  static constexpr std::size_t count(std::size_t states) { return sizes + states; }
};

/// Predicate that decides after each step of a solver with error control whether the integration ends at that
/// time.
struct Stops {
  virtual bool operator()(double at) const = 0;

 protected:
  ~Stops() = default;
};

/// Derivative function with a stop predicate for the end of each step.
template <class Evaluate>
struct Asked {
  void operator()() const { evaluate(); }
  bool stops(double at) const { return ask(at); }

  const Evaluate& evaluate;
  const Stops& ask;
};
template <class Evaluate>
Asked<Evaluate> asked(const Evaluate& evaluate, const Stops& stops) {
  return {evaluate, stops};
}

/// Integrates from one instant to another with error control.
///
/// A `Method` attempts one step and estimates its error. A PI controller chooses the next step size, and
/// Hairer's rule the first one (Hairer, Norsett and Wanner, Solving ODEs I, II.4). If `Evaluate` has
/// stops(time), it is called at the end of each step but the last one, with the states there. The integration
/// ends there if it returns true. With `max_states` no memory is allocated, and the results are the same to
/// the last bit.
template <template <int> class Method, int max_states = Eigen::Dynamic>
class Controlled {
 public:
  explicit Controlled(Eigen::Index states) : method_(states) {
    for (Vector* vector : {&origin_, &start_, &slope_}) vector->setZero(states);
  }

  /// Integrates `x` from `time` over `length`; the end time is passed on as `end`. On entry `dot` must be the
  /// derivative at (time, x). evaluate() recomputes it for the present `x` and `*now`.
  template <class Evaluate>
  void advance(double* x_place, double* dot_place, double* now, double time, double end, double length,
               const ErrorControl& control, double* numbers, const Evaluate& evaluate) {
    Eigen::Map<Vector> x(x_place, origin_.size()), dot(dot_place, origin_.size());
    origin_ = x;
    double at = time, wished = numbers[ControlReport::next];
    if (!(wished > 0.0)) wished = first_step(x, dot, now, at, length, control, numbers, evaluate);
    if constexpr (requires { method_.begin(control, numbers, wished, length); })
      method_.begin(control, numbers, wished, length);
    rejected_ = false;
    for (std::int64_t attempts = 0; at < time + length; ++attempts) {
      const double left = time + length - at;
      const bool last = !(1.000001 * wished < left);
      const double step = last ? left : wished;
      if (attempts == control.max_steps || !(at + step > at)) return fail(x, control, numbers);
      start_ = x;
      slope_ = dot;
      const bool solved = method_.attempt(x, dot, now, at, last ? end : at + step, step, numbers, evaluate);
      const double error = solved ? norm(x, control) : std::numeric_limits<double>::infinity();
      const bool accepted = error <= 1.0;
      const double next = step * (accepted ? accept(x, error, numbers) : reject(error, numbers));
      wished = last && accepted ? std::max(wished, next) : next;
      if (accepted) at = last ? time + length : at + step;
      if (!accepted || !last) go_on(x, dot, now, at, accepted, evaluate);
      if constexpr (requires { evaluate.stops(at); })
        if (accepted && !last && evaluate.stops(at)) break;
    }
    numbers[ControlReport::next] = wished;
  }

  /// Returns the states at the start of the last call.
  const double* start() const { return origin_.data(); }

 private:
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_states, 1>;

  template <class X>
  double part(const X& x, double error, Eigen::Index i, const ErrorControl& control) const {
    return std::abs(error) /
           (control.absolute + control.relative * std::max(std::abs(start_[i]), std::abs(x[i])));
  }

  template <class X>
  static void keep_sizes(const X& x, double* numbers) {
    double* const sizes = numbers + ControlReport::sizes;
    for (Eigen::Index i = 0; i < x.size(); ++i) sizes[i] = std::max(sizes[i], std::abs(x[i]));
  }

  /// Returns the root mean square of the errors, relative to the tolerances. The sum keeps what its additions
  /// round off (Knuth's TwoSum), so the order of the states changes no bit.
  template <class X>
  double norm(const X& x, const ErrorControl& control) const {
    double sum = 0.0, rounded_off = 0.0;
    const auto& error = method_.error();
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double one = part(x, error[i], i, control), square = one * one;
      const double whole = sum + square, added = whole - sum;
      rounded_off += (sum - (whole - added)) + (square - added);
      sum = whole;
    }
    const double count = static_cast<double>(std::max<Eigen::Index>(x.size(), 1));
    return std::sqrt((std::isfinite(sum) ? sum + rounded_off : sum) / count);
  }

  /// Updates the controller after an accepted step. Returns the factor for the next step size.
  template <class X>
  double accept(const X& x, double error, double* numbers) {
    keep_sizes(x, numbers);
    double& before = numbers[ControlReport::before];
    numbers[ControlReport::steps] += 1.0;
    numbers[ControlReport::largest] = std::max(numbers[ControlReport::largest], error);
    const double beta = 0.04, last = before > 0.0 ? before : 1e-4;
    const double factor =
        0.9 * fn::pow(std::max(error, 1e-10), -(1.0 / method_.order() - 0.75 * beta)) * fn::pow(last, beta);
    before = std::max(error, 1e-4);
    const double clamped = std::clamp(factor, 0.2, std::exchange(rejected_, false) ? 1.0 : 5.0);
    if constexpr (requires { method_.keeps_step(); })
      if (method_.keeps_step() && clamped > 1.0 && clamped < 1.1) return 1.0;
    return clamped;
  }
  /// Updates the controller after a rejected step. Returns the factor for the next step size.
  double reject(double error, double* numbers) {
    numbers[ControlReport::rejected] += 1.0;
    rejected_ = true;
    return std::isfinite(error) ? std::max(0.2, 0.9 * fn::pow(error, -1.0 / method_.order())) : 0.2;
  }

  /// Sets the time, the states and the derivative for the next attempt: at the end of an accepted step, else
  /// at the start.
  template <class X, class Dot, class Evaluate>
  void go_on(X& x, Dot& dot, double* now, double at, bool accepted, const Evaluate& evaluate) {
    *now = at;
    if (!accepted) {
      x = start_;
      dot = slope_;
    } else if (!method_.ends_with_slope()) {
      evaluate();
    }
  }

  template <class X, class Dot, class Evaluate>
  double first_step(X& x, Dot& dot, double* now, double at, double length, const ErrorControl& control,
                    double* numbers, const Evaluate& evaluate) {
    start_ = x;
    slope_ = dot;
    keep_sizes(x, numbers);
    double size = 0.0, speed = 0.0, change = 0.0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      size = std::max(size, part(x, x[i], i, control));
      speed = std::max(speed, part(x, slope_[i], i, control));
    }
    const double guess = std::min(size < 1e-5 || speed < 1e-5 ? 1e-6 * length : 0.01 * size / speed, length);
    x = start_ + guess * slope_;
    *now = at + guess;
    evaluate();
    for (Eigen::Index i = 0; i < x.size(); ++i)
      change = std::max(change, part(x, dot[i] - slope_[i], i, control) / guess);
    x = start_;
    dot = slope_;
    *now = at;
    const double most = std::max(speed, change);
    const double other =
        most > 1e-15 ? fn::pow(0.01 / most, 1.0 / method_.first_order) : std::max(1e-6, 1e-3 * guess);
    return std::min({100.0 * guess, other, length});
  }

  template <class X>
  void fail(const X& x, const ErrorControl& control, double* numbers) const {
    double worst = 0.0;
    std::ptrdiff_t state = 0;
    for (Eigen::Index i = 0; i < x.size(); ++i)
      if (const double one = part(x, method_.error()[i], i, control); !(one <= worst)) {
        worst = one;
        state = i;
      }
    StepReport{numbers}.write(StepReport::too_many_steps, worst, state);
  }

  Method<max_states> method_;
  bool rejected_ = false;  ///< true after a rejected attempt
  Vector origin_, start_, slope_;
};

}  // namespace stepwire::solve
