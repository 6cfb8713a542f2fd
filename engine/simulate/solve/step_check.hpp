#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/rodas.hpp"
#include "engine/simulate/solve/step_report.hpp"

namespace stepwire::solve {

/// Repeats a step with a doubtful error estimate under error control, and compares the states. An implicit
/// method damps components that it does not resolve, and its estimate with them; a state that has jumped with
/// its input is still correct.
template <int max_states>
class StepCheck {
 public:
  explicit StepCheck(Eigen::Index states) : solver_(states) {
    kept_.setZero(states);
    report_.setZero(static_cast<Eigen::Index>(ControlReport::count(static_cast<std::size_t>(states))));
  }

  /// Returns the error relative to the sizes of the states. `x` is restored.
  template <class X, class Start, class Evaluate>
  WorstError error(X& x, double* dot_place, const Start& start, double* now, double time, double end,
                   double step, const Evaluate& evaluate) {
    constexpr ErrorControl control{1e-3, 1e-2 * WorstError::smallest_size, 100000};
    report_.setZero();
    double* const numbers = report_.data();
    kept_ = x;
    x = start;
    *now = time;
    evaluate();
    solver_.advance(x.data(), dot_place, now, time, end, step, control, numbers, evaluate);
    WorstError worst;
    if (numbers[0] != StepReport::fine) {
      x = kept_;
      return {std::numeric_limits<double>::infinity(), static_cast<std::ptrdiff_t>(numbers[2])};
    }
    *now = end;
    evaluate();
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      // A state that is 0 and whose input jumps in the step may err by a part of its change.
      const bool rests = std::abs(start[i]) <= WorstError::smallest_size;
      const double late = rests ? 16.0 * step * std::abs(dot_place[i]) : 0.0;
      worst.add(std::max(std::abs(kept_[i] - x[i]) - late, 0.0), size(start[i], x[i], step * dot_place[i]),
                i);
    }
    x = kept_;
    return worst;
  }

 private:
  static constexpr double slow = 4.0;

  /// Returns the size of a state that errors are compared with. It is the larger of the values at the start
  /// and at the end. A state that decays by powers of ten and is slow at the end keeps its error, so its size
  /// is the value at the end. A state with a time constant below the step loses the error in the next step.
  static double size(double start, double end, double change) {
    return std::abs(change) <= slow * std::abs(end) ? std::abs(end)
                                                    : std::max(std::abs(start), std::abs(end));
  }

  Controlled<Rodas, max_states> solver_;
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_states, 1> kept_;
  static constexpr int most_numbers =
      max_states == Eigen::Dynamic
          ? Eigen::Dynamic
          : static_cast<int>(ControlReport::count(static_cast<std::size_t>(max_states)));
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_numbers, 1> report_;
};

}  // namespace stepwire::solve
