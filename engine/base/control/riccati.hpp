#pragma once

#include "engine/base/control/design.hpp"

namespace stepwire::control {

/// Returns the stabilizing X of A'X + X A - X B R^-1 B'X + Q = 0. Throws ControlFault for sizes that do not
/// fit, an invalid weight, a system that is not stabilizable, or an unweighted mode on the imaginary axis.
/// Uses the matrix sign function of the Hamiltonian (Roberts 1980, Int. J. Control 32, 677), then Newton's
/// method (Kleinman 1968, IEEE Trans. Autom. Control 13, 114).
Matrix continuous_riccati(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R);

/// Returns the stabilizing X of A'X A - X - A'X B (R + B'X B)^-1 B'X A + Q = 0. Uses structure-preserving
/// doubling (Chu, Fan, Lin and Wang 2004, Int. J. Control 77, 767). Throws as continuous_riccati(), with the
/// unit circle in the place of the imaginary axis.
Matrix sampled_riccati(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R);

/// Returns the X of A'X + X A + W = 0 by the Schur form of A, whose eigenvalues must have negative real
/// parts.
Matrix lyapunov(const Matrix& A, const Matrix& W);

}  // namespace stepwire::control
