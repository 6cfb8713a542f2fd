#include "engine/base/expression/matrix_expression.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <map>
#include <utility>

#include "engine/base/control/control_fault.hpp"
#include "engine/base/control/design.hpp"
#include "engine/base/control/riccati.hpp"
#include "engine/base/expression/fold.hpp"
#include "engine/base/expression/measure.hpp"

namespace stepwire::expression {
namespace {

using Eigen::Index;
using Matrix = Eigen::MatrixXd;
using Matrices = std::vector<Matrix>;
using control::ControlFault;

constexpr double most_rows = 1000;

double number(const Matrix& value, const char* what) {
  if (value.size() == 1) return value(0, 0);
  throw ControlFault(fmt::format("{} is a single number, and this is {}", what, control::size_text(value)));
}

Index count(const Matrix& value, const char* what) {
  const double of = number(value, what);
  if (!(of >= 1.0 && of <= most_rows && of == std::floor(of)))
    throw ControlFault(fmt::format("{} is a whole number from 1 to {}, and this is {}", what, most_rows, of));
  return static_cast<Index>(of);
}

Matrix filled(const Matrices& of, double with) {
  const Index rows = count(of[0], "a number of rows"), columns = count(of.back(), "a number of columns");
  return Matrix::Constant(rows, columns, with);
}

Matrix one(double number) {
  return Matrix::Constant(1, 1, number);
}

Matrix diagonal(const Matrices& of) {
  if (of.size() == 1 && of[0].rows() > 1 && of[0].cols() > 1) return of[0].diagonal();
  Eigen::VectorXd numbers(static_cast<Index>(of.size()));
  if (of.size() == 1) numbers = of[0].reshaped();
  for (std::size_t i = 0; of.size() > 1 && i < of.size(); ++i)
    numbers[static_cast<Index>(i)] = number(of[i], "a value of the diagonal");
  return numbers.asDiagonal();
}

Matrix reached(const Matrix& A, const Matrix& B) {
  control::require_square(A, "A");
  control::require_size(B, A.rows(), B.cols(), "B");
  Matrix all(A.rows(), A.rows() * B.cols());
  all.leftCols(B.cols()) = B;
  for (Index k = 1; k < A.rows(); ++k)
    all.middleCols(k * B.cols(), B.cols()) = A * all.middleCols((k - 1) * B.cols(), B.cols());
  return all;
}

Matrix sampled(const Matrices& of) {
  const double T = number(of.back(), "the period");
  if (!(T > 0.0)) throw ControlFault(fmt::format("the period is {}; it must be above 0", T));
  return of.size() == 2 ? control::sampled_A(of[0], T) : control::sampled_B(of[0], of[1], T);
}

Matrix size_of(const Matrices& of) {
  const Index which = count(of[1], "which of the sizes");
  if (which > 2) throw ControlFault("size(A, 1) is the number of rows, size(A, 2) that of columns");
  return one(static_cast<double>(which == 1 ? of[0].rows() : of[0].cols()));
}

Matrix determinant(const Matrix& A) {
  control::require_square(A, "A");
  return one(A.determinant());
}

Matrix trace(const Matrix& A) {
  control::require_square(A, "A");
  return one(A.trace());
}

using MatrixFunction = Matrix (*)(const Matrices&);

const std::map<std::string_view, MatrixFunction>& matrix_table() {
  static const std::map<std::string_view, MatrixFunction> all{
      {"transpose", [](const Matrices& v) -> Matrix { return v[0].transpose(); }},
      {"inv", [](const Matrices& v) { return control::inverse(v[0]); }},
      {"expm", [](const Matrices& v) { return control::exponential(v[0]); }},
      {"det", [](const Matrices& v) { return determinant(v[0]); }},
      {"trace", [](const Matrices& v) { return trace(v[0]); }},
      {"norm", [](const Matrices& v) { return one(v[0].jacobiSvd().singularValues()[0]); }},
      {"rank", [](const Matrices& v) { return one(static_cast<double>(v[0].colPivHouseholderQr().rank())); }},
      {"size", size_of},
      {"eye",
       [](const Matrices& v) -> Matrix {
         const Index rows = count(v[0], "a number of rows");
         return Matrix::Identity(rows, rows);
       }},
      {"zeros", [](const Matrices& v) { return filled(v, 0.0); }},
      {"ones", [](const Matrices& v) { return filled(v, 1.0); }},
      {"diag", diagonal},
      {"ctrb", [](const Matrices& v) { return reached(v[0], v[1]); }},
      {"obsv",
       [](const Matrices& v) -> Matrix { return reached(v[0].transpose(), v[1].transpose()).transpose(); }},
      {"c2d", sampled},
      {"care", [](const Matrices& v) { return control::continuous_riccati(v[0], v[1], v[2], v[3]); }},
      {"dare", [](const Matrices& v) { return control::sampled_riccati(v[0], v[1], v[2], v[3]); }},
      {"lqr", [](const Matrices& v) { return control::lqr(v[0], v[1], v[2], v[3]); }},
      {"dlqr", [](const Matrices& v) { return control::dlqr(v[0], v[1], v[2], v[3]); }},
      {"kalman", [](const Matrices& v) { return control::kalman(v[0], v[1], v[2], v[3]); }},
      {"dkalman", [](const Matrices& v) { return control::dkalman(v[0], v[1], v[2], v[3]); }},
      {"place", [](const Matrices& v) { return control::place(v[0], v[1], v[2]); }}};
  return all;
}

/// Evaluates the matrix function of this name. Throws control::ControlFault.
Matrix matrix_function(std::string_view name, const Matrices& of) {
  return matrix_table().at(name)(of);
}
using Eigen::MatrixXd;

/// An intermediate value. A bracket list is a row until it is known whether it is one of several rows.
struct MatrixPiece {
  MatrixXd numbers;
  bool is_row = false, of_numbers = false;

  /// Returns the matrix; a list of numbers that is not a row of a matrix is a column.
  MatrixXd value() const { return is_row && of_numbers ? MatrixXd(numbers.transpose()) : numbers; }
};

class MakeMatrix {
 public:
  explicit MakeMatrix(const std::vector<MatrixXd>& variables) : variables_(variables) {}

  MatrixPiece variable(std::size_t i) const { return {variables_[i]}; }
  MatrixPiece number(const Program::Number& number) const { return {MatrixXd::Constant(1, 1, number.value)}; }

  MatrixPiece operation(const Operation& operation, const std::vector<MatrixPiece>& values,
                        std::size_t place) const {
    try {
      if (&operation == &brackets) return list(values);
      std::vector<MatrixXd> of;
      for (const MatrixPiece& value : values) of.push_back(value.value());
      return {operation.value ? of_numbers(operation, of) : matrix_function(operation.name, of)};
    } catch (const control::ControlFault& fault) {
      throw ExpressionError(fault.what(), place);
    }
  }

  MatrixPiece choice(const MatrixPiece& condition, const MatrixPiece& a, const MatrixPiece& b) const {
    if (condition.value().size() != 1) throw ExpressionError("a condition is a single number", 0);
    return condition.value()(0, 0) != 0.0 ? a : b;
  }

 private:
  /// Joins rows below each other, or numbers and matrices side by side.
  static MatrixPiece list(const std::vector<MatrixPiece>& values) {
    bool of_rows = true, of_numbers = true;
    for (const MatrixPiece& value : values) {
      of_rows = of_rows && value.is_row;
      of_numbers = of_numbers && !value.is_row && value.numbers.size() == 1;
    }
    MatrixXd all = of_rows ? values[0].numbers : values[0].value();
    for (std::size_t i = 1; i < values.size(); ++i) {
      const MatrixXd next = of_rows ? values[i].numbers : values[i].value();
      if (of_rows ? next.cols() != all.cols() : next.rows() != all.rows())
        throw control::ControlFault(
            of_rows ? fmt::format("row {} has {} columns, the first has {}", i + 1, next.cols(), all.cols())
                    : fmt::format("matrices side by side have as many rows; these have {} and {}", all.rows(),
                                  next.rows()));
      MatrixXd joined(of_rows ? all.rows() + next.rows() : all.rows(),
                      of_rows ? all.cols() : all.cols() + next.cols());
      if (of_rows)
        joined << all, next;
      else
        joined.leftCols(all.cols()) = all, joined.rightCols(next.cols()) = next;
      all = std::move(joined);
    }
    return {std::move(all), !of_rows, of_numbers};
  }

  static double call(const Operation& operation, std::initializer_list<double> values) {
    return operation.value(values.begin(), static_cast<int>(values.size()));
  }

  static MatrixXd of_numbers(const Operation& operation, const std::vector<MatrixXd>& of) {
    if (of.size() == 1 && operation.name != "!")
      return of[0].unaryExpr([&](double x) { return call(operation, {x}); });
    bool single = true;
    for (const MatrixXd& one : of) single = single && one.size() == 1;
    if (single) return MatrixXd::Constant(1, 1, of_singles(operation, of));
    if (operation.binding == Binding::sum) return sum(operation, of[0], of[1]);
    if (operation.binding == Binding::product) return product(operation, of[0], of[1]);
    if (operation.binding == Binding::power) return power(of[0], of[1]);
    throw control::ControlFault(fmt::format("'{}' takes single numbers, not matrices", operation.name));
  }

  static double of_singles(const Operation& operation, const std::vector<MatrixXd>& of) {
    std::vector<double> numbers;
    for (const MatrixXd& one : of) numbers.push_back(one(0, 0));
    return operation.value(numbers.data(), static_cast<int>(numbers.size()));
  }

  static MatrixXd sum(const Operation& operation, const MatrixXd& a, const MatrixXd& b) {
    if (a.size() == 1) return b.unaryExpr([&](double x) { return call(operation, {a(0, 0), x}); });
    if (b.size() == 1) return a.unaryExpr([&](double x) { return call(operation, {x, b(0, 0)}); });
    if (a.rows() != b.rows() || a.cols() != b.cols())
      throw control::ControlFault(fmt::format("'{}' joins {} and {}; they must have the same size",
                                              operation.name, control::size_text(a), control::size_text(b)));
    return operation.name == "+" ? MatrixXd(a + b) : MatrixXd(a - b);
  }

  static MatrixXd product(const Operation& operation, const MatrixXd& a, const MatrixXd& b) {
    if (operation.name == "/" && b.size() > 1)
      throw control::ControlFault("a matrix divides nothing; a product with its inverse is A*inv(B)");
    if (a.size() == 1) return a(0, 0) * b;
    if (b.size() == 1) return operation.name == "*" ? MatrixXd(a * b(0, 0)) : MatrixXd(a / b(0, 0));
    if (a.cols() != b.rows())
      throw control::ControlFault(
          fmt::format("'*' has {} and {}; the first must have as many columns as the second has rows{}",
                      control::size_text(a), control::size_text(b),
                      a.rows() == b.rows() ? ", as transpose(..) of it has" : ""));
    return a * b;
  }

  static MatrixXd power(const MatrixXd& base, const MatrixXd& exponent) {
    control::require_square(base, "what is raised to a power");
    const double of = exponent.size() == 1 ? exponent(0, 0) : 0.5;
    if (of != std::floor(of) || std::abs(of) > 1000.0)
      throw control::ControlFault("a matrix has whole powers only");
    MatrixXd result = MatrixXd::Identity(base.rows(), base.cols());
    const MatrixXd factor = of < 0.0 ? control::inverse(base) : base;
    for (double k = 0.0; k < std::abs(of); ++k) result = result * factor;
    return result;
  }

  const std::vector<MatrixXd>& variables_;
};

}  // namespace

MatrixExpression::MatrixExpression(std::string_view text, const std::function<bool(std::string_view)>& known)
    : program_(std::make_shared<Program>(translate(text, known, Values::matrices))) {}

const std::vector<std::string>& MatrixExpression::variables() const {
  return program_->variables;
}

Measure MatrixExpression::measure(const std::vector<Measure>& variables) const {
  return measure_of(*program_, variables);
}

MatrixXd MatrixExpression::operator()(const std::vector<MatrixXd>& variables) const {
  return fold<MatrixPiece>(*program_, MakeMatrix(variables)).value();
}

}  // namespace stepwire::expression
