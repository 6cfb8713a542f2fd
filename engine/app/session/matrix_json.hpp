#pragma once

#include <Eigen/Core>

#include "engine/base/json/json.hpp"

namespace stepwire::session {

/// Converts a matrix to a list of its rows.
json::Json matrix_json(const Eigen::MatrixXd& matrix);

}  // namespace stepwire::session
