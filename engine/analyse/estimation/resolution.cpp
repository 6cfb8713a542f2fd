#include "engine/analyse/estimation/resolution.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace stepwire::estimation {

namespace {

// Differences of runs have an error of about 1e-8 of a column; determined directions are larger.
constexpr double negligible = 1e-6;

}  // namespace

Resolution Resolution::of(const RowMajor& jacobian) {
  const Eigen::Index count = jacobian.cols();
  Resolution result;
  result.lengths = jacobian.colwise().norm().transpose().cwiseMax(1e-300);
  result.scaled = jacobian * result.lengths.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(result.scaled);
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(triangle, Eigen::ComputeFullV);
  result.inverse = Eigen::MatrixXd::Zero(count, count);
  result.unknown = Eigen::VectorXd::Zero(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd v = svd.matrixV().col(k);
    const double value = svd.singularValues()[k];
    if (value > negligible * svd.singularValues()[0]) {
      result.inverse += v * v.transpose() / (value * value);
      continue;
    }
    result.unknown = result.unknown.cwiseMax(v.cwiseAbs());
    result.free.push_back(v);
  }
  return result;
}

}  // namespace stepwire::estimation
