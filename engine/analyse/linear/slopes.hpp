#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace stepwire::linear {

/// Derivatives of the elements of a function by one of its arguments.
struct Slopes {
  Eigen::VectorXd value;
  Eigen::VectorXd error;        ///< Estimated errors.
  Eigen::VectorXd left, right;  ///< One-sided derivatives at a kink or jump; else nan.
  std::vector<bool> jumps;      ///< True at a jump: a quotient grows as the difference shrinks.
  Eigen::VectorXd farther;  ///< Derivative from large differences, if the function is locally flat but rises
                            ///< on the whole; else nan.
  Eigen::VectorXd nearer;   ///< Derivative from small differences, if they disagree with the value; else nan.

  /// Removes one element.
  void erase(Eigen::Index row);
};

/// Sizes of the differences.
struct DifferenceSizes {
  std::optional<double>
      only;  ///< Single size, as a share of the argument or of 1; std::nullopt: from 1/16 downwards.
  double largest = std::numeric_limits<double>::infinity();  ///< Upper limit of all sizes.
  int stride = 1;  ///< Number of halvings from one size to the next: 1, 2 or 4.
};

/// Computes derivatives at `at` by central differences with Ridders' extrapolation ("Accurate computation of
/// F'(x) and F'(x) F''(x)", 1982). Differences begin at 1/16 of the argument (at least of 1) and are halved
/// down to 1e-9. Each element takes the extrapolation with the least estimated error. With a single size
/// there is no extrapolation, and the error is the change at half the size. Differences with non-finite
/// values are skipped. The cost is two calls per size.
Slopes slopes_of(const std::function<Eigen::VectorXd(double)>& function, double at,
                 const DifferenceSizes& sizes = {});

}  // namespace stepwire::linear
