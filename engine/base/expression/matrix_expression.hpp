#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

/// A formula whose values are matrices, of which a number is one of 1 x 1 and a list one of one column: the
/// language of Expression with [a, b, ..], [[a, b], [c, d]], and products, sums and whole powers of matrices.
/// A list of lists has them for its rows; a list of matrices has them side by side, and a list of such lists
/// one below the other. Functions: transpose inv expm det trace norm rank size(A, 1 or 2) eye(n) zeros(n) or
/// (m, n) ones diag ctrb obsv c2d care dare lqr dlqr kalman dkalman place (base/control); of one number they
/// work on every element.
class MatrixExpression {
 public:
  /// As that of Expression.
  MatrixExpression(std::string_view text, const std::function<bool(std::string_view)>& known);

  const std::vector<std::string>& variables() const;
  Measure measure(const std::vector<Measure>& variables) const;
  /// Throws ExpressionError, with its place, where sizes do not fit or a design has no solution.
  Eigen::MatrixXd operator()(const std::vector<Eigen::MatrixXd>& variables) const;

 private:
  std::shared_ptr<const Program> program_;
};

}  // namespace stepwire::expression
