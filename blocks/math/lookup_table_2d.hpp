#pragma once

#include "blocks/math/extrapolation.hpp"
#include "engine/block/declare.hpp"

namespace stepwire {

/// A surface given on a grid, bilinear between its points, of each element: y = f(row, column).
struct LookupTable2D {
  Eigen::VectorXd rows = Eigen::Vector2d(0.0, 1.0), columns = Eigen::Vector2d(0.0, 1.0);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(2, 2);
  Extrapolation extrapolation = Extrapolation::hold;
  Input<> row{}, column{};
  Output<> y{};

  void outputs() {
    for (Eigen::Index k = 0; k < y.size(); ++k) {
      const Bracket r = bracket(rows, row.coeff(k), extrapolation);
      const Bracket c = bracket(columns, column.coeff(k), extrapolation);
      y.coeffRef(k) = between(along_row(r.index, c), along_row(r.index + 1, c), r.share);
    }
  }

  double along_row(Eigen::Index index, const Bracket& c) const {
    return between(values.coeff(index, c.index), values.coeff(index, c.index + 1), c.share);
  }

  void configure(Configure& is);
  static void declare(Declare<LookupTable2D>& is);
};

}  // namespace stepwire
