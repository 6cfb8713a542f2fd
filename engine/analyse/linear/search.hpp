#pragma once

#include <functional>

namespace stepwire::linear {

/// Returns the zero of a function between two points where it has different signs, by bisection.
double find_zero(const std::function<double(double)>& function, double low, double high);

/// A point of a curve.
struct CurvePoint {
  double x = 0.0, y = 0.0;
};

/// Returns the minimum of a function between two points, by Brent's method (R. P. Brent, "Algorithms for
/// Minimization without Derivatives", 1973). The function has one minimum there.
CurvePoint find_minimum(const std::function<double(double)>& function, double low, double high);

}  // namespace stepwire::linear
