#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace stepwire::ivp {

/// An initial value problem x' = f(t, x) from 0 to `end`, with the states at its end.
struct Problem {
  template <class Number>
  using Derivative = std::function<void(Number time, const Number* x, Number* derivative)>;

  template <class Function>
  Problem(std::string name, bool stiff, double absolute, std::vector<double> start, double end,
          Function function, std::vector<double> right)
      : name(std::move(name)),
        stiff(stiff),
        absolute(absolute),
        start(std::move(start)),
        end(end),
        derivative(function),
        long_derivative(function),
        right(std::move(right)) {}

  std::string name;
  bool stiff;
  double absolute;  ///< absolute tolerance, in parts of the relative one
  std::vector<double> start;
  double end;
  Derivative<double> derivative;
  Derivative<long double> long_derivative;  ///< for references of more digits
  std::vector<double> right;                ///< states at the end; empty: no closed form and none published
};

/// Returns the digits of the worst state, as the test set counts them: an error in parts of the state plus
/// the absolute tolerance over the relative one.
inline double digits(const Problem& problem, const double* x) {
  double worst = 1e-17;
  for (std::size_t i = 0; i < problem.right.size(); ++i) {
    const double error = std::abs(x[i] - problem.right[i]) / (problem.absolute + std::abs(problem.right[i]));
    if (!(error <= worst)) worst = error;
  }
  return -std::log10(worst);
}

}  // namespace stepwire::ivp
