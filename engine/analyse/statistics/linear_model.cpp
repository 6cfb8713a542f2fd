#include "engine/analyse/statistics/linear_model.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace stepwire::statistics {
namespace {

constexpr double independent = 1e-9;  // least new part of a column, as a share of its length

/// Returns one column per level but the last: 1 there, -1 at the last level, 0 else.
Eigen::MatrixXd coded(const Factor& factor) {
  const auto rows = static_cast<Eigen::Index>(factor.level.size());
  const auto last = static_cast<Eigen::Index>(factor.levels.size()) - 1;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows, std::max<Eigen::Index>(0, last));
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto level = static_cast<Eigen::Index>(factor.level[static_cast<std::size_t>(row)]);
    if (level == last)
      columns.row(row).setConstant(-1.0);
    else
      columns(row, level) = 1.0;
  }
  return columns;
}

Eigen::MatrixXd products(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd columns(a.rows(), a.cols() * b.cols());
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    for (Eigen::Index j = 0; j < b.cols(); ++j)
      columns.col(i * b.cols() + j) = a.col(i).cwiseProduct(b.col(j));
  return columns;
}

Eigen::MatrixXd all_columns(const Observations& observations, const Term& term) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(observations.values.size()), 1);
  for (const std::string& name : term.factors) columns = products(columns, coded(observations.factor(name)));
  return columns;
}

/// Orthonormal basis of the columns so far, and the term of each (Gram-Schmidt, applied twice for accuracy).
class Basis {
 public:
  explicit Basis(Eigen::Index rows) : directions_(rows, 1), columns_(rows, 1), owners_(1, -1) {
    directions_.col(0).setConstant(1.0 / std::sqrt(static_cast<double>(rows)));
    columns_.col(0).setOnes();
  }

  /// Adds a column if it is linearly independent of the basis; false if it is not.
  bool takes(const Eigen::VectorXd& column, int owner) {
    Eigen::VectorXd rest = column;
    for (int twice = 0; twice < 2; ++twice) rest -= directions_ * (directions_.transpose() * rest);
    if (rest.norm() <= independent * std::max(1.0, column.norm())) return false;
    directions_.conservativeResize(Eigen::NoChange, directions_.cols() + 1);
    directions_.rightCols(1) = rest.normalized();
    columns_.conservativeResize(Eigen::NoChange, columns_.cols() + 1);
    columns_.rightCols(1) = column;
    owners_.push_back(owner);
    return true;
  }

  /// Returns the terms that a dependent column is a combination of, without the constant (-1).
  std::vector<int> makers(const Eigen::VectorXd& column) const {
    const Eigen::VectorXd shares = columns_.colPivHouseholderQr().solve(column);
    std::vector<int> result;
    for (Eigen::Index i = 0; i < shares.size(); ++i) {
      const int owner = owners_[static_cast<std::size_t>(i)];
      if (owner < 0 || std::abs(shares[i]) < 1e-7) continue;
      if (std::find(result.begin(), result.end(), owner) == result.end()) result.push_back(owner);
    }
    return result;
  }

 private:
  Eigen::MatrixXd directions_, columns_;
  std::vector<int> owners_;
};

void add_new(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

std::vector<TermColumns> model_columns(const Observations& observations, const std::vector<Term>& terms) {
  Basis basis(static_cast<Eigen::Index>(observations.values.size()));
  std::vector<TermColumns> result;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Eigen::MatrixXd all = all_columns(observations, terms[i]);
    TermColumns model{terms[i], Eigen::MatrixXd(all.rows(), 0), all.cols(), {}};
    for (Eigen::Index k = 0; k < all.cols(); ++k) {
      if (basis.takes(all.col(k), static_cast<int>(i))) {
        model.columns.conservativeResize(Eigen::NoChange, model.columns.cols() + 1);
        model.columns.rightCols(1) = all.col(k);
        continue;
      }
      for (const int maker : basis.makers(all.col(k)))
        if (maker != static_cast<int>(i))
          add_new(model.same_as, terms[static_cast<std::size_t>(maker)].name());
    }
    result.push_back(std::move(model));
  }
  return result;
}

Eigen::VectorXd explained(const Eigen::VectorXd& response, const std::vector<const TermColumns*>& terms,
                          const Eigen::VectorXd& roots) {
  Eigen::Index count = 1;
  for (const TermColumns* term : terms) count += term->columns.cols();
  Eigen::MatrixXd columns(response.size(), count);
  columns.col(0) = roots;
  Eigen::Index at = 1;
  for (const TermColumns* term : terms) {
    columns.middleCols(at, term->columns.cols()) = roots.asDiagonal() * term->columns;
    at += term->columns.cols();
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
  Eigen::VectorXd along = qr.householderQ().adjoint() * response;
  along.tail(along.size() - count).setZero();
  return qr.householderQ() * along;
}

}  // namespace stepwire::statistics
