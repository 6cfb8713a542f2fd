#pragma once

#include <cmath>

#include "engine/base/math/sum_of_squares.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Norm of a vector: y = sqrt(sum u_k^2), or sum |u_k|, or max |u_k|.
struct Norm {
  enum class Kind { euclidean, sum, max };

  Kind kind = Kind::euclidean;
  Input<> u{};
  Output<1> y{};

  void outputs() {
    double sum = 0.0, max = 0.0;
    SumOfSquares squares;
    for (Index k = 0; k < u.size(); ++k) {
      const double size = std::abs(u[k]);
      squares.add(size);
      sum += size;
      max = size <= max ? max : size;  // preserves NaN
    }
    y = kind == Kind::euclidean ? squares.root() : kind == Kind::sum ? sum : max;
  }

  static void declare(Declare<Norm>& is);
};

}  // namespace stepwire
