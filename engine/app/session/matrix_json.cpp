#include "engine/app/session/matrix_json.hpp"

namespace stepwire::session {

json::Json matrix_json(const Eigen::MatrixXd& matrix) {
  json::Json rows = json::Json::list();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push(json::Json::list_of(matrix.row(i)));
  return rows;
}

}  // namespace stepwire::session
