#include "engine/analyse/linear/frequency_response.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analyse/linear/balance.hpp"

namespace stepwire::linear {

namespace {

/// Solves (point - H) x = b for H in upper Hessenberg form by elimination with row exchanges.
Eigen::VectorXcd solve(const Complex& point, const Eigen::MatrixXd& H, Eigen::VectorXcd b) {
  const Eigen::Index n = H.rows();
  Eigen::MatrixXcd M = -H.cast<Complex>();
  M.diagonal().array() += point;
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    if (std::abs(M(k + 1, k)) > std::abs(M(k, k))) {
      M.row(k).tail(n - k).swap(M.row(k + 1).tail(n - k));
      std::swap(b[k], b[k + 1]);
    }
    if (M(k, k) == 0.0) continue;
    const Complex factor = M(k + 1, k) / M(k, k);
    M.row(k + 1).tail(n - k) -= factor * M.row(k).tail(n - k);
    b[k + 1] -= factor * b[k];
  }
  M.triangularView<Eigen::Upper>().solveInPlace(b);
  return b;
}

}  // namespace

FrequencyResponse::FrequencyResponse(const StateSpace& system)
    : D_(system.D(0, 0)), sample_time_(system.sample_time), corners_(modes_of(system)) {
  for (const Complex& zero : zeros_of(system)) {
    const Complex s = system.is_sampled() ? std::log(zero) / system.sample_time : zero;
    corners_.push_back({zero, std::abs(s), std::abs(s) > 0.0 ? -s.real() / std::abs(s) : 0.0});
  }
  if (system.A.rows() == 0) return;
  const Eigen::VectorXd scale = balancing(system.A);
  const Eigen::MatrixXd A = scale.cwiseInverse().asDiagonal() * system.A * scale.asDiagonal();
  const Eigen::HessenbergDecomposition<Eigen::MatrixXd> reduced(A);
  const Eigen::MatrixXd Q = reduced.matrixQ();
  hessenberg_ = reduced.matrixH();
  B_ = Q.transpose() * (scale.cwiseInverse().asDiagonal() * system.B.col(0));
  C_ = (system.C.row(0) * scale.asDiagonal()) * Q;
}

Complex FrequencyResponse::at(double frequency) const {
  return at_point(sample_time_ > 0.0 ? std::polar(1.0, frequency * sample_time_) : Complex(0.0, frequency));
}

Complex FrequencyResponse::at_point(const Complex& point) const {
  if (hessenberg_.rows() == 0) return D_;
  return (C_.cast<Complex>() * solve(point, hessenberg_, B_.cast<Complex>()))(0) + D_;
}

std::array<double, 2> FrequencyResponse::range() const {
  const double half = sample_time_ > 0.0 ? std::numbers::pi / sample_time_ : 0.0;
  double low = half > 0.0 ? half : 1e300, high = 0.0;
  for (const Mode& corner : corners_) {
    if (!std::isfinite(corner.frequency) || corner.frequency < 1e-9 * (1.0 + half)) continue;
    low = std::min(low, corner.frequency);
    high = std::max(high, corner.frequency);
  }
  if (high == 0.0) low = high = half > 0.0 ? half : 1.0;
  const double first = std::pow(10.0, std::floor(std::log10(low)) - 2.0);
  return {first, half > 0.0 ? half : std::pow(10.0, std::ceil(std::log10(high)) + 2.0)};
}

/// Beyond all corners the gain is a power of the frequency, and the phase is constant. Up to there, and where
/// the gain is near to 1 or comes nearer over the next decade, there is more to see.
bool FrequencyResponse::may_cross_beyond(double frequency, double decade) const {
  constexpr double bend = 0.02, clear = 2.3;  // [rad], of a logarithm
  const Complex here = at(frequency), there = at(frequency * decade);
  const double gain = std::log(std::abs(here)), change = std::log(std::abs(there)) - gain;
  if (!std::isfinite(gain) || !std::isfinite(change)) return false;
  if (decade < 1.0 && std::abs(std::arg(there / here)) > bend) return true;
  if (std::abs(change) < 1e-3) return false;
  return std::abs(gain) < clear || gain * change < 0.0;
}

std::vector<double> FrequencyResponse::frequencies_across_one(std::size_t per_decade) const {
  constexpr int decades = 100;
  std::vector<double> all = frequencies(per_decade);
  const double lowest = all.front(), highest = all.back();
  const auto extend = [&](double from, double decade) {
    for (int k = 0; k < decades && may_cross_beyond(from, decade); ++k, from *= decade)
      for (std::size_t i = 1; i <= per_decade; ++i)
        all.push_back(from * std::pow(decade, static_cast<double>(i) / static_cast<double>(per_decade)));
  };
  extend(lowest, 0.1);
  if (sample_time_ == 0.0) extend(highest, 10.0);
  std::ranges::sort(all);
  return all;
}

/// Near to rest the gain is constant, or grows with the order of the pole there.
double FrequencyResponse::at_rest() const {
  const auto near = [&](double s) {
    return at_point(sample_time_ > 0.0 ? std::exp(s * sample_time_) : s).real();
  };
  double lowest = sample_time_ > 0.0 ? 1.0 / sample_time_ : 1.0;
  for (const Mode& corner : corners_)
    if (corner.frequency > 0.0) lowest = std::min(lowest, corner.frequency);
  const double far = near(1e-5 * lowest), closer = near(1e-7 * lowest);
  if (std::abs(closer) > 30.0 * std::abs(far))
    return std::copysign(std::numeric_limits<double>::infinity(), closer);
  return at_point(sample_time_ > 0.0 ? 1.0 : 0.0).real();
}

std::vector<double> FrequencyResponse::frequencies(std::size_t per_decade) const {
  const auto [first, last] = range();
  const double decades = std::log10(last / first);
  const auto count = static_cast<int>(std::max(1.0, decades * static_cast<double>(per_decade)));
  std::vector<double> all{last};
  for (int k = 0; k < count; ++k) all.push_back(first * std::pow(10.0, decades * k / count));
  for (const Mode& corner : corners_)
    for (int k = -20; k <= 20; ++k)
      all.push_back(corner.frequency * (1.0 + 0.25 * k * std::min(0.1, std::abs(corner.damping))));
  std::erase_if(all, [first = first, last = last](double w) { return !(w >= first && w <= last); });
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace stepwire::linear
