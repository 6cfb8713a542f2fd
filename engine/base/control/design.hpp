#pragma once

#include "engine/base/control/system_check.hpp"

namespace stepwire::control {

/// Gain K of u = -K x that minimises the integral of x'Q x + u'R u for dx/dt = A x + B u.
Matrix lqr(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R);
/// Gain K of u = -K x that minimises the sum of x'Q x + u'R u for x[k+1] = A x[k] + B u[k].
Matrix dlqr(const Matrix& A, const Matrix& B, const Matrix& Q, const Matrix& R);
/// Observer gain L of dx/dt = A x + B u + L (y - C x). Q and R are the power densities of the state
/// disturbance and of the noise of y.
Matrix kalman(const Matrix& A, const Matrix& C, const Matrix& Q, const Matrix& R);
/// Kalman gain M of the correction x + M (y - C x) at a sample; the gain of the prediction is A M. Q and R
/// are the covariances of the state disturbance and of the noise of y.
Matrix dkalman(const Matrix& A, const Matrix& C, const Matrix& Q, const Matrix& R);

/// A and B of x[k+1] = A x[k] + B u[k], with u held over a period T. Both are blocks of one matrix
/// exponential (Van Loan 1978, IEEE Trans. Autom. Control 23, 395).
Matrix sampled_A(const Matrix& A, double T);
Matrix sampled_B(const Matrix& A, const Matrix& B, double T);
Matrix exponential(const Matrix& A);

/// Gain K that gives A - B K these poles: real ones in a column, or rows [re, im] with both poles of each
/// pair. With several inputs the eigenvectors are chosen far from parallel, for robustness (Kautsky, Nichols
/// and Van Dooren 1985, Int. J. Control 41, 1129, method 0). With one input K is unique.
Matrix place(const Matrix& A, const Matrix& B, const Matrix& poles);

}  // namespace stepwire::control
