#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace stepwire::simulink {

/// Thrown for a MATLAB text without a value here; the text is one sentence without its end.
class ValueError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A number of a MATLAB value, and its formula where it depends on variables of the model.
struct Cell {
  double number = 0.0;  ///< NaN without a value in the file
  std::string text{};   ///< formula of a diagram; empty: the number alone
  int strength = 9;     ///< of its weakest operator: 1 sum, 2 product, 3 sign, 4 power, 9 none

  /// Returns the formula, or the number in the shortest digits that read back to the same bits.
  std::string formula() const;
};

/// A MATLAB value of real numbers: a scalar, a vector or a matrix.
struct Value {
  std::size_t rows = 1, columns = 1;
  std::vector<Cell> cells;  ///< row after row
  std::string name{};       ///< of the variable whose whole value this is
  bool is_missing = false;  ///< a variable without a value in the file

  static Value of(double number) { return of(Cell{number}); }
  static Value of(Cell cell) { return {1, 1, {std::move(cell)}}; }
  static Value missing() {
    Value value;
    value.is_missing = true;
    return value;
  }
  static Value matrix(std::size_t rows, std::size_t columns, double number);

  bool is_scalar() const { return rows == 1 && columns == 1; }
  bool is_vector() const { return rows == 1 || columns == 1; }
  bool has_formula() const;
  Cell& at(std::size_t row, std::size_t column) { return cells[row * columns + column]; }
  const Cell& at(std::size_t row, std::size_t column) const { return cells[row * columns + column]; }
  /// Returns the numbers, row after row. Throws ValueError where a variable has no value.
  std::vector<double> numbers() const;
  /// Returns the only number. Throws ValueError for other values.
  double number() const;
};

/// Returns the cell a op b, for + - * / ^.
Cell combined(char op, const Cell& a, const Cell& b);
/// Returns the cell of a function of the formula language.
Cell applied(const std::string& function, const std::vector<Cell>& arguments, double number);
/// Returns a op b element by element; a scalar counts for all elements. Throws ValueError for other sizes.
Value each(char op, const Value& a, const Value& b);
/// Returns the product of matrices; Throws ValueError for sizes that do not fit.
Value product(const Value& a, const Value& b);
Value transposed(const Value& a);
/// Returns the coefficients of the polynomial with these roots, highest power first.
Value polynomial_of_roots(const Value& roots);

}  // namespace stepwire::simulink
