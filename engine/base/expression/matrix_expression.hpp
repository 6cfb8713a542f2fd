#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

/// A formula with matrix values. A number is a 1 x 1 matrix and a list is a column. The language is that of
/// Expression with [a, b, ..], [[a, b], [c, d]], and products, sums and whole powers of matrices. The inner
/// lists of a list are its rows. Matrices in a list are side by side; such lists in a list are below each
/// other. Functions are transpose inv expm det trace norm rank diag ctrb obsv c2d. Others are size(A, 1 or
/// 2), and eye(n), zeros and ones of (n) or (m, n). The designs care dare lqr dlqr kalman dkalman place are
/// those of base/control. Functions of one number act on every element.
class MatrixExpression {
 public:
  /// Parses a text as Expression does.
  MatrixExpression(std::string_view text, const std::function<bool(std::string_view)>& known);

  const std::vector<std::string>& variables() const;
  Measure measure(const std::vector<Measure>& variables) const;
  /// Evaluates the formula. Throws ExpressionError, with its place, where sizes do not fit or a design has no
  /// solution.
  Eigen::MatrixXd operator()(const std::vector<Eigen::MatrixXd>& variables) const;

 private:
  std::shared_ptr<const Program> program_;
};

}  // namespace stepwire::expression
