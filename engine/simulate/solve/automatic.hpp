#pragma once

#include "engine/simulate/solve/dop853.hpp"
#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/explicit_pair.hpp"
#include "engine/simulate/solve/radau.hpp"

namespace stepwire::solve {

/// Solver that starts with an explicit method and switches to Radau once stability limits the steps.
///
/// The switch follows the stiffness test of DOPRI5 (Hairer and Wanner, Solving ODEs II, IV.2). Steps that
/// stability limits are within a quarter of the bound, other steps mostly below half of it, as measured on
/// the problems of bench/solvers. For small tolerances the explicit method is Dop853. For intervals between
/// instants that are hardly longer than a step it is DormandPrince, which needs half the evaluations.
template <int max_states>
class Automatic {
 public:
  explicit Automatic(Eigen::Index states) : plain_(states), fine_(states), stiff_(states) {}

  /// Chooses the explicit method of an interval from the last step size.
  void begin(const ErrorControl& control, double* numbers, double step, double length) {
    stiff_.begin(control, numbers, step, length);
    explicit_ = control.relative <= 1e-5 && step < 0.5 * length ? Used::fine : Used::plain;
  }

  template <class X, class Dot, class Evaluate>
  bool attempt(X& x, Dot& dot, double* now, double time, double end, double step, double* numbers,
               const Evaluate& evaluate) {
    used_ = numbers[ControlReport::stiff] != 0.0 ? Used::stiff : explicit_;
    if (used_ == Used::stiff) return stiff_.attempt(x, dot, now, time, end, step, numbers, evaluate);
    used_ == Used::fine ? fine_.attempt(x, dot, now, time, end, step, numbers, evaluate)
                        : plain_.attempt(x, dot, now, time, end, step, numbers, evaluate);
    double& signs = numbers[ControlReport::signs];
    signs = std::max(signs + (used_ == Used::fine ? sign(fine_.stiffness(x, step), 0.25, 0.25)
                                                  : sign(plain_.stiffness(x, step), 0.4, -0.1)),
                     0.0);
    if (signs >= 8.0) numbers[ControlReport::stiff] = 1.0;
    return true;
  }
  const double* error() const {
    return used_ == Used::stiff  ? stiff_.error().data()
           : used_ == Used::fine ? fine_.error().data()
                                 : plain_.error().data();
  }
  bool ends_with_slope() const { return used_ != Used::stiff; }
  bool keeps_step() const { return used_ == Used::stiff; }
  static constexpr double first_order = 5.0;
  /// Returns the order of the last attempt, for the choice of the next step size.
  double order() const {
    return used_ == Used::stiff ? stiff_.order() : used_ == Used::fine ? fine_.order() : plain_.order();
  }

 private:
  enum class Used { plain, fine, stiff };

  /// Returns the evidence for stiffness of a step that is `part` of the longest stable one; `between` in the
  /// unclear range.
  static double sign(double part, double clear, double between) {
    return part > 0.75 ? 1.0 : part > clear ? between : -0.25;
  }

  DormandPrince<max_states> plain_;
  Dop853<max_states> fine_;
  Radau<max_states> stiff_;
  Used explicit_ = Used::plain;  ///< method of this interval
  Used used_ = Used::plain;      ///< method of the last attempt
};

}  // namespace stepwire::solve
