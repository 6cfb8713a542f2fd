#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

/// A parsed shape: "n", "+n", "m x n", "m x +n", "+m x n". A plus marks the sum over the elements of a list.
struct PortShape {
  explicit PortShape(const std::string& text) {
    const std::size_t times = text.find(" x ");
    is_matrix = times != std::string::npos;
    rows = text.substr(0, times);
    if (is_matrix) columns = text.substr(times + 3);
    adds_rows = take_plus(rows);
    adds_columns = take_plus(columns);
  }

  std::string rows, columns;  ///< letters or numbers; a vector has `rows` only
  bool is_matrix = false, adds_rows = false, adds_columns = false;

 private:
  static bool take_plus(std::string& letter) {
    if (!letter.starts_with('+')) return false;
    letter.erase(0, 1);
    return true;
  }
};

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

/// Sizes of all ports, states and parameters of a draft, by the letters of the declared shapes.
class PortSizes : public Sizes {
 public:
  explicit PortSizes(const Draft& draft) : draft_(draft), symbols_(draft.blocks.size()) {}

  /// Returns the size of a letter or number in the shapes of one block.
  int symbol(std::size_t block, const std::string& text);
  /// Returns the size of the whole output of a source.
  int of_output(const diagram::Source& source);
  /// Returns the size of a source; a new one for constants and elements.
  int of_source(const diagram::Source& source);
  /// Records the rows and columns of a port with a matrix shape; returns false for other shapes.
  bool declare_matrix(std::size_t block, const std::string& shape);
  /// Returns the total size of a list input.
  int of_list(std::size_t block, std::size_t input);
  /// Returns the number of elements of a source; std::nullopt if unknown.
  std::optional<Eigen::Index> value_of(const diagram::Source& source);

 private:
  const Draft& draft_;
  std::vector<std::vector<std::pair<std::string, int>>> symbols_;
};

}  // namespace stepwire::plan
