#pragma once

#include <optional>
#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// Returns the eigenvalues of a matrix in the order of sort_by_size(). Each group of mutually dependent
/// states is solved separately, so that chains of delays have exact zeros.
std::vector<Complex> eigenvalues(const Eigen::MatrixXd& A);

/// Sorts by absolute value; of a conjugate pair the value above the real axis is first.
void sort_by_size(std::vector<Complex>& values);

/// A pole with its frequency and damping.
struct Mode {
  Complex pole;
  double frequency = 0.0;  ///< Natural frequency [rad/s].
  double damping = 1.0;    ///< -1 to 1: cosine of the angle to the negative real axis of the s plane.
};

/// Returns the poles of a system; with delays, which have infinitely many, those of delay_poles().
std::vector<Complex> poles_of(const StateSpace& system);
/// Returns the modes of a system. A sampled pole z is converted to s = log(z) / sample time; z = 0 has an
/// infinite frequency.
std::vector<Mode> modes_of(const StateSpace& system);

/// True if all poles are to the left of the imaginary axis, or inside of the unit circle. Poles that
/// poles_of() leaves out count, too. A pole within 1e-12 of the border (of the largest pole) counts as
/// unstable. So does a system with delays whose poles cannot be counted.
bool is_stable(const StateSpace& system);

/// True for a pole that decays: beyond 1e-12 of the border, of the largest pole.
bool decays(const StateSpace& system, const Complex& pole, double largest);

/// Stability of a system under one rule, with and without feedback.
struct Stability {
  bool stable = false;
  bool known = true;                ///< False where the poles of a system with delays cannot be counted.
  std::optional<Complex> hidden{};  ///< Growing mode that is not on the way from inputs to outputs.
};

/// Judges a system. All poles of the states on the way from inputs to outputs must decay, also those that a
/// zero cancels. A state is on the way by the non-zero elements of the matrices. Other states must not grow:
/// an integrator that nothing reads does no harm.
Stability stability_of(const StateSpace& system);

/// Returns the invariant zeros, at which the system matrix loses rank. For a controllable and observable
/// system they are its transmission zeros. A. Emami-Naeini, P. Van Dooren, "Computation of zeros of linear
/// multivariable systems", 1982. Empty for a system with delays, which has infinitely many.
std::vector<Complex> zeros_of(const StateSpace& system);

}  // namespace stepwire::linear
