#pragma once

#include "engine/base/control/system_check.hpp"

namespace stepwire::control {

/// K of u = -K x with the least integral of x'Q x + u'R u for dx/dt = A x + B u.
Matrix lqr(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R);
/// K of u = -K x with the least sum of x'Q x + u'R u for x[k+1] = A x[k] + B u[k].
Matrix dlqr(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R);
/// L of the estimate dx/dt = A x + B u + L (y - C x), for disturbances of the state and noise of y of power
/// densities Q and R.
Matrix kalman(const Matrix& A, const Matrix& C, const Matrix& Q, const Matrix& R);
/// M of the estimate that follows a sample, x + M (y - C x), for disturbances of the state and noise of y of
/// covariances Q and R; the prediction takes A M.
Matrix dkalman(const Matrix& A, const Matrix& C, const Matrix& Q, const Matrix& R);

/// A and B of x[k+1] = A x[k] + B u[k], with u held over a period T. From expm of both in one matrix (Van
/// Loan 1978, IEEE Trans. Autom. Control 23, 395).
Matrix sampled_A(const Matrix& A, double T);
Matrix sampled_B(const Matrix& A, const Matrix& B, double T);
Matrix exponential(const Matrix& A);

/// K that gives A - B K these poles: real ones in a column, or [re, im] in rows with both of each pair. Of
/// several K that with eigenvectors far from parallel (Kautsky, Nichols and Van Dooren 1985, Int. J. Control
/// 41, 1129, method 0); with one input the only one.
Matrix place(const Matrix& A, const Matrix& B, const Matrix& poles);

}  // namespace stepwire::control
