#include "engine/app/simulink/functions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

namespace stepwire::simulink {
namespace {

using Unary = double (*)(double);
using Binary = double (*)(double, double);
using Call = std::function<Value(const std::vector<Value>&)>;

double fixed(double x) {
  return std::trunc(x);
}
double sign_of(double x) {
  return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}
double modulo(double x, double y) {
  return y == 0.0 ? x : x - std::floor(x / y) * y;
}

/// Functions that diagrams have under the same name.
const std::map<std::string, Unary>& unary_functions() {
  static const std::map<std::string, Unary> all{
      {"sin", std::sin},     {"cos", std::cos},   {"tan", std::tan},    {"asin", std::asin},
      {"acos", std::acos},   {"atan", std::atan}, {"sinh", std::sinh},  {"cosh", std::cosh},
      {"tanh", std::tanh},   {"exp", std::exp},   {"log", std::log},    {"log10", std::log10},
      {"log2", std::log2},   {"sqrt", std::sqrt}, {"abs", std::abs},    {"sign", sign_of},
      {"floor", std::floor}, {"ceil", std::ceil}, {"round", std::round}};
  return all;
}

const std::map<std::string, Binary>& binary_functions() {
  static const std::map<std::string, Binary> all{{"atan2", std::atan2},
                                                 {"hypot", std::hypot},
                                                 {"mod", modulo},
                                                 {"min", [](double a, double b) { return std::fmin(a, b); }},
                                                 {"max", [](double a, double b) { return std::fmax(a, b); }}};
  return all;
}

std::size_t size_of(const Value& value) {
  const double number = value.number();
  if (!(number >= 0.0 && number <= 1e6)) throw ValueError(fmt::format("has a size of {}", number));
  return static_cast<std::size_t>(number);
}

Value filled(const std::vector<Value>& sizes, double number) {
  if (sizes.size() == 1 && sizes[0].cells.size() == 2)
    return Value::matrix(size_of(Value::of(sizes[0].cells[0])), size_of(Value::of(sizes[0].cells[1])),
                         number);
  const std::size_t rows = sizes.empty() ? 1 : size_of(sizes[0]);
  return Value::matrix(rows, sizes.size() > 1 ? size_of(sizes[1]) : rows, number);
}

Value unit_matrix(const std::vector<Value>& sizes) {
  Value value = filled(sizes, 0.0);
  for (std::size_t i = 0; i < std::min(value.rows, value.columns); ++i) value.at(i, i).number = 1.0;
  return value;
}

Value line_space(const std::vector<Value>& of) {
  const double from = of[0].number(), to = of[1].number();
  const std::size_t count = of.size() > 2 ? size_of(of[2]) : 100;
  Value value = Value::matrix(1, count, to);
  for (std::size_t i = 0; i + 1 < count; ++i)
    value.cells[i].number = from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
  return value;
}

Value diagonal(const std::vector<Value>& of) {
  const std::size_t count = of[0].cells.size();
  if (!of[0].is_vector()) throw ValueError("takes the diagonal of a matrix");
  Value value = Value::matrix(count, count, 0.0);
  for (std::size_t i = 0; i < count; ++i) value.at(i, i) = of[0].cells[i];
  return value;
}

Value convolution(const std::vector<Value>& of) {
  const std::vector<Cell>&a = of[0].cells, &b = of[1].cells;
  if (a.empty() || b.empty()) throw ValueError("multiplies an empty polynomial");
  Value value = Value::matrix(1, a.size() + b.size() - 1, 0.0);
  std::vector<bool> begun(value.cells.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) {
      const Cell term = combined('*', a[i], b[k]);
      value.cells[i + k] = begun[i + k] ? combined('+', value.cells[i + k], term) : term;
      begun[i + k] = true;
    }
  return value;
}

/// Returns the sum or product of the elements of a vector.
Value folded(char op, const Value& of) {
  if (!of.is_vector() || of.cells.empty()) throw ValueError("folds a matrix");
  Cell result = of.cells[0];
  for (std::size_t i = 1; i < of.cells.size(); ++i) result = combined(op, result, of.cells[i]);
  return Value::of(result);
}

Value constant(double number, const std::vector<Value>& sizes) {
  return sizes.empty() ? Value::of(number) : filled(sizes, number);
}

/// A function of MATLAB with the most and least arguments it may have here.
struct Function {
  std::size_t least, most;
  Call call;
};

/// Constants, and functions that make matrices of a size.
std::map<std::string, Function> makers() {
  using All = const std::vector<Value>&;
  return {{"pi", {0, 0, [](All) { return Value::of(std::numbers::pi); }}},
          {"inf", {0, 2, [](All of) { return constant(std::numeric_limits<double>::infinity(), of); }}},
          {"Inf", {0, 2, [](All of) { return constant(std::numeric_limits<double>::infinity(), of); }}},
          {"eps", {0, 0, [](All) { return Value::of(std::numeric_limits<double>::epsilon()); }}},
          {"realmax", {0, 0, [](All) { return Value::of(std::numeric_limits<double>::max()); }}},
          {"true", {0, 2, [](All of) { return constant(1.0, of); }}},
          {"false", {0, 2, [](All of) { return constant(0.0, of); }}},
          {"zeros", {0, 2, [](All of) { return filled(of, 0.0); }}},
          {"ones", {0, 2, [](All of) { return filled(of, 1.0); }}},
          {"eye", {0, 2, unit_matrix}}};
}

/// Functions of given values.
std::map<std::string, Function> transformers() {
  using All = const std::vector<Value>&;
  return {
      {"linspace", {2, 3, line_space}},
      {"diag", {1, 1, diagonal}},
      {"conv", {2, 2, convolution}},
      {"poly", {1, 1, [](All of) { return polynomial_of_roots(of[0]); }}},
      {"transpose", {1, 1, [](All of) { return transposed(of[0]); }}},
      {"double", {1, 1, [](All of) { return of[0]; }}},
      {"sum", {1, 1, [](All of) { return folded('+', of[0]); }}},
      {"prod", {1, 1, [](All of) { return folded('*', of[0]); }}},
      {"length",
       {1, 1, [](All of) { return Value::of(static_cast<double>(std::max(of[0].rows, of[0].columns))); }}},
      {"numel", {1, 1, [](All of) { return Value::of(static_cast<double>(of[0].cells.size())); }}},
      {"deg2rad", {1, 1, [](All of) { return each('*', of[0], Value::of(std::numbers::pi / 180.0)); }}},
      {"rad2deg", {1, 1, [](All of) { return each('*', of[0], Value::of(180.0 / std::numbers::pi)); }}},
      {"fix", {1, 1, [](All of) {
                 Value result = of[0];
                 for (Cell& cell : result.cells) cell = Cell{fixed(Value::of(cell).number())};
                 return result;
               }}}};
}

const std::map<std::string, Function>& functions() {
  static const std::map<std::string, Function> all = [] {
    std::map<std::string, Function> both = makers();
    both.merge(transformers());
    return both;
  }();
  return all;
}

Value of_each(const std::string& name, Unary function, const Value& argument) {
  Value result = argument;
  result.name.clear();
  for (Cell& cell : result.cells) cell = applied(name, {cell}, function(cell.number));
  return result;
}

Value of_both(const std::string& name, Binary function, const Value& a, const Value& b) {
  Value result = each('+', a, b);
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    const Cell &x = a.cells[a.is_scalar() ? 0 : i], &y = b.cells[b.is_scalar() ? 0 : i];
    result.cells[i] = applied(name, {x, y}, function(x.number, y.number));
  }
  return result;
}

/// Returns the least or greatest element of a vector.
Value extreme(const std::string& name, const Value& of) {
  Value result = Value::of(of.cells.at(0));
  for (const Cell& cell : of.cells)
    result = of_both(name, binary_functions().at(name), result, Value::of(cell));
  return result;
}

std::size_t index_of(const Value& value, std::size_t size) {
  const double number = value.number();
  if (!(number >= 1.0 && number <= static_cast<double>(size)) || number != std::floor(number))
    throw ValueError(fmt::format("has the index {} beyond 1 to {}", number, size));
  return static_cast<std::size_t>(number) - 1;
}

bool is_whole(const Value& index) {
  return index.name == ":";
}

/// Returns the places of an index, from 0.
std::vector<std::size_t> places_of(const Value& index, std::size_t size) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; is_whole(index) && i < size; ++i) places.push_back(i);
  for (const Cell& cell : index.cells) places.push_back(index_of(Value::of(cell), size));
  return places;
}

Value chosen(const Value& value, const Value& row_index, const Value& column_index) {
  const std::vector<std::size_t> rows = places_of(row_index, value.rows),
                                 columns = places_of(column_index, value.columns);
  Value result = Value::matrix(rows.size(), columns.size(), 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < columns.size(); ++j) result.at(i, j) = value.at(rows[i], columns[j]);
  return result;
}

}  // namespace

bool is_function(const std::string& name, std::size_t arguments) {
  if (arguments == 1 && unary_functions().contains(name)) return true;
  if ((arguments == 1 || arguments == 2) && (name == "min" || name == "max")) return true;
  if (arguments == 2 && binary_functions().contains(name)) return true;
  const auto found = functions().find(name);
  return found != functions().end() && arguments >= found->second.least && arguments <= found->second.most;
}

Value called(const std::string& name, const std::vector<Value>& arguments) {
  const auto unary = unary_functions().find(name);
  if (arguments.size() == 1 && unary != unary_functions().end())
    return of_each(name, unary->second, arguments[0]);
  if (arguments.size() == 1 && (name == "min" || name == "max")) return extreme(name, arguments[0]);
  const auto binary = binary_functions().find(name);
  if (arguments.size() == 2 && binary != binary_functions().end())
    return of_both(name, binary->second, arguments[0], arguments[1]);
  Value value = functions().at(name).call(arguments);
  value.name.clear();
  return value;
}

Value indexed(const Value& value, const std::vector<Value>& indices) {
  if (value.is_missing)
    throw ValueError(fmt::format("needs the value of '{}', which is not in the file", value.name));
  if (indices.size() == 1 && value.is_vector() && !is_whole(indices[0]))
    return chosen(value, value.rows == 1 ? Value::of(1.0) : indices[0],
                  value.rows == 1 ? indices[0] : Value::of(1.0));
  if (indices.size() == 2) return chosen(value, indices[0], indices[1]);
  throw ValueError("has an index that is not evaluated");
}

Value beside(const Value& a, const Value& b) {
  if (a.cells.empty()) {
    Value whole = b;
    whole.name.clear();
    return whole;
  }
  if (b.cells.empty()) return a;
  if (a.rows != b.rows) throw ValueError("has rows of different lengths");
  Value result = Value::matrix(a.rows, a.columns + b.columns, 0.0);
  for (std::size_t i = 0; i < a.rows; ++i) {
    for (std::size_t j = 0; j < a.columns; ++j) result.at(i, j) = a.at(i, j);
    for (std::size_t j = 0; j < b.columns; ++j) result.at(i, a.columns + j) = b.at(i, j);
  }
  return result;
}

Value stacked(const std::vector<Value>& rows) {
  if (rows.empty()) return {0, 0, {}};
  Value result{0, rows[0].columns, {}};
  for (const Value& row : rows) {
    if (row.columns != result.columns) throw ValueError("has rows of different lengths");
    result.rows += row.rows;
    result.cells.insert(result.cells.end(), row.cells.begin(), row.cells.end());
  }
  return result;
}

}  // namespace stepwire::simulink
