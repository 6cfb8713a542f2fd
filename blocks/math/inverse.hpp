#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Inverse of a matrix by Gauss-Jordan elimination in place with partial pivoting.
struct Inverse {
  static constexpr Index most_rows = 8192;  // no plan has memory for more, with as many columns

  Input<> u{};
  Output<> y{};
  Diagnostic singular{};
  Time t{};
  Index rows = 0;

  double& at(Index row, Index column) { return y[column * rows + row]; }

  void outputs() {
    y = u;
    Places from;  // uninitialised: a small matrix uses little of it
    for (Index k = 0; k < rows; ++k) from[static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(k);
    for (Index k = 0; k < rows; ++k) {
      const Index best = take_pivot(k);
      std::swap(from[static_cast<std::size_t>(k)], from[static_cast<std::size_t>(best)]);
      if (is_rounding(at(k, k), from[static_cast<std::size_t>(k)], k)) singular.raise(t);
      eliminate(k);
    }
    put_columns_back(from);
  }

  static void declare(Declare<Inverse>& is);

 private:
  /// Original index of each row.
  using Places = std::array<std::uint16_t, most_rows>;

  /// Swaps the largest number of a column into row k; returns its row.
  Index take_pivot(Index k) {
    Index best = k;
    for (Index row = k + 1; row < rows; ++row)
      if (std::abs(at(row, k)) > std::abs(at(best, k))) best = row;
    for (Index column = 0; column < rows; ++column) std::swap(at(k, column), at(best, column));
    return best;
  }

  /// True if a pivot is at the rounding level of its row and column, which makes it independent of units.
  bool is_rounding(double pivot, Index row, Index column) const {
    double in_row = 0.0, in_column = 0.0;
    for (Index k = 0; k < rows; ++k) {
      in_row = std::max(in_row, std::abs(u[k * rows + row]));
      in_column = std::max(in_column, std::abs(u[column * rows + k]));
    }
    const double rounding = static_cast<double>(rows) * std::numeric_limits<double>::epsilon();
    return std::abs(pivot) <= rounding * std::min(in_row, in_column);
  }

  void put_columns_back(Places& from) {
    for (Index k = 0; k < rows; ++k)
      for (std::uint16_t& place = from[static_cast<std::size_t>(k)]; place != k;) {
        const Index to = place;
        for (Index row = 0; row < rows; ++row) std::swap(at(row, k), at(row, to));
        std::swap(place, from[static_cast<std::size_t>(to)]);
      }
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
};

}  // namespace stepwire
