#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stepwire::plan {

/// Sizes that are known or found to be equal to others (union-find). A size may be that of a matrix: the
/// product of two others, its rows and its columns, and sizes that are equal have the same of these.
class Sizes {
 public:
  int add();
  int count() const { return static_cast<int>(parents_.size()); }

  std::optional<Eigen::Index> value(int size) { return values_[static_cast<std::size_t>(root(size))]; }
  /// False if it is known to be another.
  bool set(int size, Eigen::Index value);
  /// False if both are known and differ, or their rows or columns do.
  bool join(int a, int b);
  /// Makes it the size of a matrix; false if its rows or columns are others.
  bool set_factors(int size, int rows, int columns);
  /// Rows and columns, where it is the size of a matrix.
  const std::optional<std::pair<int, int>>& factors(int size) {
    return factors_[static_cast<std::size_t>(root(size))];
  }
  /// Columns; 1 of a vector and where they are not known.
  Eigen::Index columns(int size);
  /// Finds products, rows and columns that follow by now. True where anything is new; what does not divide
  /// is left.
  bool multiply();
  /// Takes what has a size and neither rows nor columns for one column.
  bool settle_columns();
  bool has_matrices() const { return matrices_; }
  /// "3 x 2", "6 elements", or "a x 2" with what is not known yet
  std::string shown(int size);
  /// "6", or "3 x 2" of a matrix
  std::string fitting(int size);
  /// One of all sizes that are equal to this one, the same for each of them.
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
