#include "engine/app/simulink/value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire::simulink {

namespace {

int strength_of(char op) {
  return op == '+' || op == '-' ? 1 : op == '*' || op == '/' ? 2 : 4;
}

double computed(char op, double a, double b) {
  switch (op) {
    case '+':
      return a + b;
    case '-':
      return a - b;
    case '*':
      return a * b;
    case '/':
      return a / b;
    default:
      return std::pow(a, b);
  }
}

/// Returns an operand in brackets where its operators bind weaker than they must.
std::string operand(const Cell& cell, int least) {
  const bool is_negative = cell.text.empty() && (cell.number < 0.0 || std::signbit(cell.number));
  const int strength = is_negative ? 3 : cell.strength;
  return strength < least ? "(" + cell.formula() + ")" : cell.formula();
}

}  // namespace

std::string Cell::formula() const {
  if (!text.empty()) return text;
  return std::isinf(number) ? number > 0.0 ? "inf" : "-inf" : fmt::format("{}", number);
}

Value Value::matrix(std::size_t rows, std::size_t columns, double number) {
  if (rows * columns > 1'000'000) throw ValueError("has more than 1,000,000 numbers");
  return {rows, columns, std::vector<Cell>(rows * columns, Cell{number})};
}

bool Value::has_formula() const {
  return std::ranges::any_of(cells, [](const Cell& cell) { return !cell.text.empty(); });
}

std::vector<double> Value::numbers() const {
  std::vector<double> all;
  for (const Cell& cell : cells) {
    if (std::isnan(cell.number))
      throw ValueError(fmt::format("needs the number of '{}', which is not in the file", cell.formula()));
    all.push_back(cell.number);
  }
  return all;
}

double Value::number() const {
  if (!is_scalar()) throw ValueError(fmt::format("is {} x {} and should be one number", rows, columns));
  return numbers()[0];
}

Cell combined(char op, const Cell& a, const Cell& b) {
  Cell result{computed(op, a.number, b.number)};
  if (a.text.empty() && b.text.empty()) return result;
  const int strength = strength_of(op);
  // The right operand of - and / binds stronger, and a sign behind an operator has brackets.
  const int right = strength == 4 ? 5 : op == '+' ? 2 : strength + 1;
  const bool is_signed = b.formula().starts_with('-');
  const std::string sign = strength == 1 ? fmt::format(" {} ", op) : std::string(1, op);
  result.strength = strength;
  result.text = operand(a, strength == 4 ? 5 : strength) + sign + operand(b, is_signed ? 9 : right);
  return result;
}

Cell applied(const std::string& function, const std::vector<Cell>& arguments, double number) {
  Cell result{number};
  if (std::ranges::all_of(arguments, [](const Cell& cell) { return cell.text.empty(); })) return result;
  std::string list;
  for (const Cell& argument : arguments) list += (list.empty() ? "" : ", ") + argument.formula();
  result.text = function + "(" + list + ")";
  return result;
}

Value each(char op, const Value& a, const Value& b) {
  if (!a.is_scalar() && !b.is_scalar() && (a.rows != b.rows || a.columns != b.columns))
    throw ValueError(fmt::format("joins {} x {} and {} x {}", a.rows, a.columns, b.rows, b.columns));
  const Value& shape = a.is_scalar() ? b : a;
  Value result = Value::matrix(shape.rows, shape.columns, 0.0);
  for (std::size_t i = 0; i < result.cells.size(); ++i)
    result.cells[i] = combined(op, a.cells[a.is_scalar() ? 0 : i], b.cells[b.is_scalar() ? 0 : i]);
  return result;
}

Value product(const Value& a, const Value& b) {
  if (a.is_scalar() || b.is_scalar()) return each('*', a, b);
  if (a.columns != b.rows)
    throw ValueError(fmt::format("multiplies {} x {} and {} x {}", a.rows, a.columns, b.rows, b.columns));
  Value result = Value::matrix(a.rows, b.columns, 0.0);
  for (std::size_t i = 0; i < a.rows; ++i)
    for (std::size_t j = 0; j < b.columns; ++j)
      for (std::size_t k = 0; k < a.columns; ++k) {
        const Cell term = combined('*', a.at(i, k), b.at(k, j));
        result.at(i, j) = k == 0 ? term : combined('+', result.at(i, j), term);
      }
  return result;
}

Value transposed(const Value& a) {
  Value result = Value::matrix(a.columns, a.rows, 0.0);
  for (std::size_t i = 0; i < a.rows; ++i)
    for (std::size_t j = 0; j < a.columns; ++j) result.at(j, i) = a.at(i, j);
  return result;
}

Value polynomial_of_roots(const Value& roots) {
  std::vector<Cell> coefficients{Cell{1.0}};
  for (const Cell& root : roots.cells) {
    std::vector<Cell> next(coefficients.size() + 1);
    for (std::size_t i = 0; i < next.size(); ++i) {
      const bool is_last = i == coefficients.size();
      const Cell shifted = is_last ? Cell{0.0} : coefficients[i];
      if (i == 0 || (root.text.empty() && root.number == 0.0))
        next[i] = shifted;
      else
        next[i] = is_last ? combined('*', Cell{-1.0}, combined('*', root, coefficients[i - 1]))
                          : combined('-', shifted, combined('*', root, coefficients[i - 1]));
    }
    coefficients = next;
  }
  const std::size_t count = coefficients.size();
  return {1, count, std::move(coefficients)};
}

}  // namespace stepwire::simulink
