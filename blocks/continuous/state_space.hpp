#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Linear system: dx/dt = A x + B u, y = C x + D u.
struct StateSpace {
  Eigen::MatrixXd A, B, C, D;
  Input<> u{};
  Output<> y{};
  State<> x{};

  bool direct = false;

  void outputs() {
    y = 0.0;
    add(C, x, y);
    if (direct) add(D, u, y);
  }

  void derivatives() {
    x.dot = 0.0;
    add(A, x, x.dot);
    add(B, u, x.dot);
  }

  void configure(Configure& is);
  static void declare(Declare<StateSpace>& is);

 private:
  /// to += matrix from, column by column as the matrix lies in memory, without a temporary.
  template <class From, class To>
  static void add(const Eigen::MatrixXd& matrix, const From& from, To& to) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      const double factor = from.coeff(j);
      for (Eigen::Index i = 0; i < matrix.rows(); ++i) to.coeffRef(i) += matrix.coeff(i, j) * factor;
    }
  }
};

}  // namespace stepwire
