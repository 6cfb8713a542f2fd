#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace stepwire::linear {

/// How the outcome of a function changes with one of its arguments.
struct Slopes {
  Eigen::VectorXd value;
  Eigen::VectorXd error;        ///< estimated
  Eigen::VectorXd left, right;  ///< from one side alone, where the function has a kink or jumps; else nan
  std::vector<bool> jumps;      ///< where one of them grows as the difference shrinks
  Eigen::VectorXd farther;  ///< from large differences, where it is flat here and rises as a whole; else nan
  Eigen::VectorXd nearer;   ///< from small differences, where these disagree with the value; else nan

  /// Leaves out one outcome.
  void erase(Eigen::Index row);
};

/// Of which sizes differences are.
struct DifferenceSizes {
  std::optional<double>
      only;  ///< one size, a share of the argument or of 1; none: from a sixteenth downwards
  double largest = std::numeric_limits<double>::infinity();  ///< of all sizes
  int stride = 1;  ///< by how many halvings the next one is smaller, 1, 2 or 4
};

/// Central differences at `at`. They begin at a sixteenth of the argument (of 1 where that is smaller) and
/// are halved down to 1e-9; of their extrapolations (Ridders, "Accurate computation of F'(x) and F'(x)
/// F''(x)", 1982) the one counts, element by element, whose estimated error is least. Of one size alone its
/// difference counts, and its error is that to half of it. The function may give numbers that are not finite;
/// such differences are passed over.
Slopes slopes_of(const std::function<Eigen::VectorXd(double)>& function, double at,
                 const DifferenceSizes& sizes = {});

}  // namespace stepwire::linear
