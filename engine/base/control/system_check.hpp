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
/// Throws ControlFault unless a weight is symmetric and its eigenvalues are at least 0, or above 0 where it is
/// `definite`.
void require_weight(const Matrix& weight, bool definite, const std::string& name);
/// Returns the inverse. Throws ControlFault for a matrix that is not square or is singular.
Matrix inverse(const Matrix& matrix);

/// Region of unstable modes: right of the imaginary axis (continuous) or outside the unit circle (sampled).
enum class Stability { continuous, sampled };

/// Throws ControlFault, naming the mode, where A has an unstable mode that B does not reach.
void require_stabilizable(const Matrix& A, const Matrix& B, Stability stability);
/// Throws ControlFault where no weight covers a mode on the limit of stability.
void require_weighed(const Matrix& A, const Matrix& Q, Stability stability);

}  // namespace stepwire::control
