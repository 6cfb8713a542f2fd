#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stepwire::plan {

/// Sizes that are known or found equal to others (union-find). A size may be that of a matrix, the product of
/// two other sizes, its rows and columns. Equal sizes have equal rows and columns.
class Sizes {
 public:
  int add();
  int count() const { return static_cast<int>(parents_.size()); }

  std::optional<Eigen::Index> value(int size) { return values_[static_cast<std::size_t>(root(size))]; }
  /// Sets a size; returns false if another value is known.
  bool set(int size, Eigen::Index value);
  /// Makes two sizes equal; returns false if both are known and differ, or their rows or columns do.
  bool join(int a, int b);
  /// Makes it the size of a matrix; returns false if it has other rows or columns.
  bool set_factors(int size, int rows, int columns);
  /// Returns its rows and columns; std::nullopt unless it is the size of a matrix.
  const std::optional<std::pair<int, int>>& factors(int size) {
    return factors_[static_cast<std::size_t>(root(size))];
  }
  /// Returns the columns; 1 for a vector and if unknown.
  Eigen::Index columns(int size);
  /// Determines products, rows and columns from known values. Returns true if one is new; quotients with a
  /// remainder are ignored. The rows and columns of a single number are 1.
  bool multiply();
  /// Gives a size without rows and columns a single column.
  bool settle_columns();
  bool has_matrices() const { return matrices_; }
  /// Returns the shape as text: "3 x 2", "6 elements", or "a x 2" with unknown parts.
  std::string shown(int size);
  /// Returns the required size as text: "6", or "3 x 2" for a matrix.
  std::string fitting(int size);
  /// Returns the representative of all sizes equal to this one.
  int root(int size);

 private:
  bool set_if_open(int size, Eigen::Index value);
  bool multiply(int size);

  std::vector<int> parents_;
  std::vector<std::optional<Eigen::Index>> values_;
  std::vector<std::optional<std::pair<int, int>>> factors_;
  bool matrices_ = false;
};

}  // namespace stepwire::plan
