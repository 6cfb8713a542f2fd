#pragma once

#include "engine/base/control/system_check.hpp"

namespace stepwire::control {

/// The stabilizing X of A'X + X A - X B R^-1 B'X + Q = 0. Throws ControlFault where sizes do not fit, a weight
/// is none, the system is not stabilizable, or a mode on the imaginary axis stands in no weight.
/// Matrix sign function of the Hamiltonian (Roberts 1980, Int. J. Control 32, 677), then Newton's method
/// (Kleinman 1968, IEEE Trans. Autom. Control 13, 114).
Matrix continuous_riccati(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R);

/// The stabilizing X of A'X A - X - A'X B (R + B'X B)^-1 B'X A + Q = 0, by structure-preserving doubling
/// (Chu, Fan, Lin and Wang 2004, Int. J. Control 77, 767). Faults as above, with the unit circle.
Matrix sampled_riccati(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R);

/// The X of A'X + X A + W = 0 by Schur's form of A, whose eigenvalues have negative real parts.
Matrix lyapunov(const Matrix& A, const Matrix& W);

}  // namespace stepwire::control
