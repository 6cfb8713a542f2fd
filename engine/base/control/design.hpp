#pragma once

#include <Eigen/Core>
#include <string>

namespace stepwire::control {

using Matrix = Eigen::MatrixXd;

/// Returns a size as text, "3 x 2".
std::string size_text(const Matrix& matrix);
/// Throws ControlFault unless a matrix has this size; `name` identifies it in the message.
void require_size(const Matrix& matrix, Eigen::Index rows, Eigen::Index columns, const std::string& name);
/// Throws ControlFault unless a matrix is square.
void require_square(const Matrix& matrix, const std::string& name);
/// Throws ControlFault unless a weight is symmetric and its eigenvalues are at least 0, or above 0 where it
/// is `definite`.
void require_weight(const Matrix& weight, bool definite, const std::string& name);
/// Returns the inverse. Throws ControlFault for a matrix that is not square or is singular.
Matrix inverse(const Matrix& matrix);

/// Region of unstable modes: right of the imaginary axis (continuous) or outside the unit circle (sampled).
enum class Stability { continuous, sampled };

/// Throws ControlFault, naming the mode, where A has an unstable mode that B does not reach.
void require_stabilizable(const Matrix& A, const Matrix& B, Stability stability);
/// Throws ControlFault where no weight covers a mode on the limit of stability.
void require_weighed(const Matrix& A, const Matrix& Q, Stability stability);

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
