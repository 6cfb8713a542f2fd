#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The inverse of a matrix, by Gauss and Jordan in place with pivots from each column.
struct Inverse {
  static constexpr Index most_rows = 8192;  // more fit into no plan, with as many columns

  Input<> u{};
  Output<> y{};
  Diagnostic singular{};
  Time t{};
  Index rows = 0;

  double& at(Index row, Index column) { return y[column * rows + row]; }

  void outputs() {
    y = u;
    std::array<std::uint16_t, most_rows> swapped;  // not set here: a small matrix uses little of it
    for (Index k = 0; k < rows; ++k) {
      swapped[static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(take_pivot(k));
      eliminate(k);
    }
    for (Index k = rows - 1; k >= 0; --k)
      for (Index row = 0; row < rows; ++row)
        std::swap(at(row, k), at(row, swapped[static_cast<std::size_t>(k)]));
  }

  void update() {
    for (Index i = 0; i < y.size(); ++i)
      if (!std::isfinite(y[i])) singular.raise(t);
  }

  /// Brings the largest number of a column up; returns in which row it was.
  Index take_pivot(Index k) {
    Index best = k;
    for (Index row = k + 1; row < rows; ++row)
      if (std::abs(at(row, k)) > std::abs(at(best, k))) best = row;
    for (Index column = 0; column < rows; ++column) std::swap(at(k, column), at(best, column));
    return best;
  }

  void eliminate(Index k) {
    const double pivot = 1.0 / at(k, k);
    at(k, k) = 1.0;
    for (Index column = 0; column < rows; ++column) at(k, column) *= pivot;
    for (Index row = 0; row < rows; ++row) {
      if (row == k) continue;
      const double factor = at(row, k);
      at(row, k) = 0.0;
      for (Index column = 0; column < rows; ++column) at(row, column) -= factor * at(k, column);
    }
  }

  static void declare(Declare<Inverse>& is);
};

}  // namespace stepwire
