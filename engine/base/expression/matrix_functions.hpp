#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace stepwire::expression {

/// Evaluates the matrix function of this name. Throws control::ControlFault.
Eigen::MatrixXd matrix_function(std::string_view name, const std::vector<Eigen::MatrixXd>& of);

}  // namespace stepwire::expression
