#include "engine/analyse/statistics/circle.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::statistics {
namespace {

constexpr double negligible = 1e-11;    // of the largest singular value
constexpr double largest_radius = 1e5;  // times the points' spread; beyond it an arc counts as a line
constexpr const char* on_a_line =
    "the points lie on a line, or so near to one that their circle would be 100000 times as large as their "
    "spread";

/// Returns the circle a (x^2 + y^2) + b x + c y + d = 0.
Circle from_coefficients(const Eigen::Vector4d& k) {
  if (std::abs(k[0]) * largest_radius < k.segment<2>(1).norm()) throw StatisticsError(on_a_line);
  const Eigen::Vector2d centre = -0.5 * k.segment<2>(1) / k[0];
  return {centre, std::sqrt(std::max(0.0, centre.squaredNorm() - k[3] / k[0]))};
}

Eigen::VectorXd squares(const PlanePoints& points) {
  return points.colwise().squaredNorm().transpose();
}

Circle kasa(const PlanePoints& points) {
  Eigen::MatrixXd columns(points.cols(), 3);
  columns << points.transpose(), Eigen::VectorXd::Ones(points.cols());
  const Eigen::VectorXd solution = columns.colPivHouseholderQr().solve(-squares(points));
  return from_coefficients({1.0, solution[0], solution[1], solution[2]});
}

/// Pratt's fit: minimises |M k| subject to b^2 + c^2 - 4 a d = 1. M has the rows (x^2 + y^2, x, y, 1). In the
/// axes of M's singular vectors the constraint has one negative eigenvalue; the next larger one belongs to
/// the solution.
Circle pratt(const PlanePoints& points) {
  Eigen::MatrixXd columns(points.cols(), 4);
  columns << squares(points), points.transpose(), Eigen::VectorXd::Ones(points.cols());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(columns, Eigen::ComputeFullV);
  Eigen::Vector4d sizes = Eigen::Vector4d::Zero();  // three points have three singular values
  sizes.head(svd.singularValues().size()) = svd.singularValues();
  const Eigen::Matrix4d axes = svd.matrixV();
  if (sizes[3] < negligible * sizes[0]) return from_coefficients(axes.col(3));
  Eigen::Matrix4d inverse = Eigen::Matrix4d::Zero();  // inverse of the constraint matrix
  inverse(0, 3) = inverse(3, 0) = -0.5;
  inverse(1, 1) = inverse(2, 2) = 1.0;
  const Eigen::Matrix4d scaled = axes * sizes.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled.transpose() * inverse * scaled);
  return from_coefficients(axes * solver.eigenvectors().col(1).cwiseQuotient(sizes));
}

/// Taubin's fit: Pratt's with the mean of |grad|^2 as the constraint, which leaves three columns.
Circle taubin(const PlanePoints& points) {
  const Eigen::VectorXd z = squares(points);
  const double mean = z.mean(), scale = 2.0 * std::sqrt(mean);
  Eigen::MatrixXd columns(points.cols(), 3);
  columns << (z.array() - mean).matrix() / scale, points.transpose();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(columns, Eigen::ComputeFullV);
  const Eigen::Vector3d k = svd.matrixV().col(2);
  return from_coefficients({k[0] / scale, k[1], k[2], -mean * k[0] / scale});
}

/// Normal equations of one step, from the residuals r_i - R and their derivatives by (centre, R).
struct Normal {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
};

Normal normal_equations(const PlanePoints& points, const Circle& circle) {
  Normal normal;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d from = points.col(i) - circle.centre;
    const double r = from.norm();
    if (r == 0.0) continue;  // undefined at the centre
    const Eigen::Vector3d slope(-from.x() / r, -from.y() / r, -1.0);
    normal.matrix += slope * slope.transpose();
    normal.right -= slope * (r - circle.radius);
  }
  return normal;
}

Circle moved(const Circle& circle, const Eigen::Vector3d& step) {
  return {circle.centre + step.head<2>(), circle.radius + step[2]};
}

Circle geometric(const PlanePoints& points) {
  constexpr int max_steps = 1000;
  Circle circle = taubin(points);
  double error = squared_deviations(points, circle), damping = 1e-4;
  for (int i = 0; i < max_steps; ++i) {
    Normal normal = normal_equations(points, circle);
    normal.matrix.diagonal() *= 1.0 + damping;
    const Eigen::Vector3d step = normal.matrix.ldlt().solve(normal.right);
    if (step.norm() <= 1e-14 * (1.0 + circle.radius)) return circle;
    const Circle next = moved(circle, step);
    const double next_error = squared_deviations(points, next);
    const bool better = next_error < error;
    damping *= better ? 0.1 : 10.0;
    if (better) circle = next, error = next_error;
    if (!better && damping > 1e10) return circle;  // no step reduces the error: rounding limit
    if (circle.radius > largest_radius) throw StatisticsError(on_a_line);
  }
  throw StatisticsError(fmt::format("the circle does not settle in {} steps", max_steps));
}

void check(const PlanePoints& points) {
  if (points.cols() < 3)
    throw StatisticsError(fmt::format("a circle needs three points or more; there are {}", points.cols()));
  if (!points.allFinite()) throw StatisticsError("a coordinate is no finite number");
}

/// Returns the spread of the points about their mean. Throws StatisticsError for collinear points, whose
/// second singular value vanishes.
double spread(const PlanePoints& centred) {
  const Eigen::Vector2d sizes = Eigen::JacobiSVD<Eigen::MatrixXd>(centred).singularValues();
  if (!(sizes[1] > negligible * sizes[0])) throw StatisticsError(on_a_line);
  return sizes[0] / std::sqrt(static_cast<double>(centred.cols()));
}

Circle fitted(const PlanePoints& points, CircleFit fit) {
  switch (fit) {
    case CircleFit::kasa:
      return kasa(points);
    case CircleFit::pratt:
      return pratt(points);
    case CircleFit::taubin:
      return taubin(points);
    case CircleFit::geometric:
      break;
  }
  return geometric(points);
}

}  // namespace

Circle fit_circle(const PlanePoints& points, CircleFit fit) {
  check(points);
  // Centring and scaling make the fit independent of the origin and the size of the points.
  const Eigen::Vector2d mean = points.rowwise().mean();
  const PlanePoints centred = points.colwise() - mean;
  const double scale = spread(centred);
  const Circle circle = fitted(centred / scale, fit);
  return {mean + scale * circle.centre, scale * circle.radius};
}

double squared_deviations(const PlanePoints& points, const Circle& circle) {
  const Eigen::RowVectorXd distances = (points.colwise() - circle.centre).colwise().norm();
  return (distances.array() - circle.radius).square().sum();
}

}  // namespace stepwire::statistics
