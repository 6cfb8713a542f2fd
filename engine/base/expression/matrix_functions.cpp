#include "engine/base/expression/matrix_functions.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <map>
#include <string>

#include "engine/base/control/control_fault.hpp"
#include "engine/base/control/design.hpp"
#include "engine/base/control/riccati.hpp"

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

}  // namespace

Matrix matrix_function(std::string_view name, const Matrices& of) {
  return matrix_table().at(name)(of);
}

}  // namespace stepwire::expression
