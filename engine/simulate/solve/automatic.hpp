#pragma once

#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/explicit_pair.hpp"
#include "engine/simulate/solve/rodas.hpp"

namespace stepwire::solve {

/// DormandPrince first, and Rodas once steps are bounded by stability rather than by accuracy: 15 steps in a
/// row, by the test of DOPRI5 (Hairer and Wanner, Solving ODEs II, IV.2).
template <int max_states>
class Automatic {
 public:
  explicit Automatic(Eigen::Index states) : plain_(states), stiff_(states) {}

  template <class X, class Dot, class Evaluate>
  bool attempt(X& x, Dot& dot, double* now, double time, double end, double step, double* numbers,
               const Evaluate& evaluate) {
    is_stiff_ = numbers[ControlReport::stiff] != 0.0;
    if (is_stiff_) return stiff_.attempt(x, dot, now, time, end, step, numbers, evaluate);
    plain_.attempt(x, dot, now, time, end, step, numbers, evaluate);
    double& signs = numbers[ControlReport::signs];
    signs = plain_.stiffness(x, step) > 3.25 ? signs + 1.0 : std::max(signs - 0.25, 0.0);
    if (signs >= 15.0) numbers[ControlReport::stiff] = 1.0;
    return true;
  }
  const double* error() const { return is_stiff_ ? stiff_.error().data() : plain_.error().data(); }
  bool ends_with_slope() const { return !is_stiff_; }
  static constexpr double first_order = 5.0;
  /// Of the last attempt, for the length of the next step.
  double order() const { return is_stiff_ ? 4.0 : 5.0; }

 private:
  DormandPrince<max_states> plain_;
  Rodas<max_states> stiff_;
  bool is_stiff_ = false;  ///< of the last attempt
};

}  // namespace stepwire::solve
