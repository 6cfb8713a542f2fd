#pragma once

#include <Eigen/Core>
#include <string>

namespace stepwire::control {

using Matrix = Eigen::MatrixXd;

/// "3 x 2"
std::string size_text(const Matrix& matrix);
/// Throws ControlFault unless a matrix has this size; `name` is what it is called in the message.
void require_size(const Matrix& matrix, Eigen::Index rows, Eigen::Index columns, const std::string& name);
/// Throws ControlFault unless a matrix is square.
void require_square(const Matrix& matrix, const std::string& name);
/// Throws ControlFault unless a weight is symmetric and its eigenvalues are at least 0, or above 0 where it is
/// `definite`.
void require_weight(const Matrix& weight, bool definite, const std::string& name);
/// The inverse; throws ControlFault where a matrix is not square or singular.
Matrix inverse(const Matrix& matrix);

/// When a mode needs to be controlled: its eigenvalue lies right of the imaginary axis, or outside of the
/// unit circle.
enum class Stability { continuous, sampled };

/// Throws ControlFault, with the mode, where A has a mode that is not stable and that B does not reach.
void require_stabilizable(const Matrix& A, const Matrix& B, Stability stability);
/// Throws ControlFault where a mode on the limit of stability stands in no weight.
void require_weighed(const Matrix& A, const Matrix& Q, Stability stability);

}  // namespace stepwire::control
