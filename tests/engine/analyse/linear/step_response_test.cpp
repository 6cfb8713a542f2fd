// Step responses against closed forms.
#include "engine/analyse/linear/step_response.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace stepwire::linear {

namespace {

StateSpace siso(const Eigen::MatrixXd& A, const Eigen::VectorXd& B, const Eigen::RowVectorXd& C,
                double sample_time = 0.0) {
  StateSpace system{A, B, C, Eigen::MatrixXd::Zero(1, 1), {}, {{"u", ""}}, {{"y", ""}}, sample_time};
  for (Eigen::Index i = 0; i < A.rows(); ++i) system.states.push_back({"x", ""});
  return system;
}

/// Returns the value of a curve between its rows.
double between_rows(const ResponseCurve& curve, double x) {
  const auto next = std::ranges::upper_bound(curve.x, x);
  const auto i = static_cast<std::size_t>(next - curve.x.begin());
  const double part = (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1]);
  return curve.y[i - 1] + part * (curve.y[i] - curve.y[i - 1]);
}

constexpr double swing = 100.0, swing_decay = 5.0;  // [rad/s], [1/s]

/// A swing of 100 rad/s beside a lag of 100 s with the gain 0.05.
StateSpace swing_beside_lag() {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3, 3);
  A(0, 1) = 1.0;
  A(1, 0) = -(swing * swing + swing_decay * swing_decay);
  A(1, 1) = -2.0 * swing_decay;
  A(2, 2) = -0.01;
  return siso(A, Eigen::Vector3d(0.0, -A(1, 0), 0.0005), Eigen::RowVector3d(1.0, 0.0, 1.0));
}

double swing_and_lag(double t) {
  const double fast =
      1.0 - std::exp(-swing_decay * t) * (std::cos(swing * t) + swing_decay / swing * std::sin(swing * t));
  return fast - 0.05 * std::expm1(-0.01 * t);
}

}  // namespace

TEST_CASE("a fast swing is seen beside a slow tail") {
  const ResponseCurve curve = step_response(swing_beside_lag());
  CHECK(*std::ranges::max_element(curve.y) == Approx(swing_and_lag(std::numbers::pi / swing)).epsilon(1e-7));
  CHECK(curve.x.back() >= 800.0);
  for (const double t : {1e-3, 7.7e-3, 0.0314, 0.123, 0.777, 3.0, 99.0, 512.0}) {
    INFO(t);
    CHECK(between_rows(curve, t) == Approx(swing_and_lag(t)).margin(1e-3));
  }
}

TEST_CASE("a peak between two rows is a row") {
  // The peak of a swing of damping 0.2 is 1 + exp(-pi 0.2/sqrt(1 - 0.04)), at pi/sqrt(1 - 0.04).
  const double damping = 0.2, damped = std::sqrt(1.0 - damping * damping);
  const Eigen::MatrixXd A = Eigen::Matrix2d{{0.0, 1.0}, {-1.0, -2.0 * damping}};
  const ResponseCurve curve = step_response(siso(A, Eigen::Vector2d(0.0, 1.0), Eigen::RowVector2d(1.0, 0.0)));
  const auto peak = std::ranges::max_element(curve.y);
  CHECK(*peak == Approx(1.0 + std::exp(-std::numbers::pi * damping / damped)).epsilon(1e-8));
  CHECK(curve.x[static_cast<std::size_t>(peak - curve.y.begin())] ==
        Approx(std::numbers::pi / damped).epsilon(1e-6));
  CHECK(std::ranges::is_sorted(curve.x));
}

TEST_CASE("a response lasts until a slow mode of a large part is over") {
  // (10 s + 1)/((s + 1)(1e-4 s + 1)) = 1 - 9 s/(s + 1) + ...: 1 + 9 exp(-t) behind the fast lag.
  const Eigen::MatrixXd A = Eigen::Vector2d(-1.0, -1e4).asDiagonal();
  const double fast = 1e4 * (1.0 - 10.0 * 1e4) / (1.0 - 1e4), slow = (1.0 - 10.0) * 1e4 / (1e4 - 1.0);
  const ResponseCurve curve =
      step_response(siso(A, Eigen::Vector2d(slow, fast), Eigen::RowVector2d(1.0, 1.0)));
  CHECK(curve.y.back() == Approx(1.0).margin(6e-4));
  CHECK(between_rows(curve, 3.0) == Approx(1.0 + 9.0 * std::exp(-3.0)).epsilon(1e-3));
}

TEST_CASE("rows do not multiply without end where a swing hardly decays") {
  const double damping = 1e-5;
  const Eigen::MatrixXd A = Eigen::Matrix2d{{0.0, 1.0}, {-1.0, -2.0 * damping}};
  const ResponseCurve curve = step_response(siso(A, Eigen::Vector2d(0.0, 1.0), Eigen::RowVector2d(1.0, 0.0)));
  CHECK(curve.x.size() < 100'000);
  CHECK(curve.x.back() >= 8.0 / damping * (1.0 - 1e-9));
  CHECK(*std::ranges::max_element(curve.y) ==
        Approx(1.0 + std::exp(-std::numbers::pi * damping)).epsilon(1e-7));
}

TEST_CASE("a sampled response lasts until its slowest mode is over") {
  // 1e-5/(z - 0.99999), a time constant of 100,000 samples.
  const ResponseCurve curve =
      step_response(siso(Eigen::MatrixXd::Constant(1, 1, 0.99999), Eigen::VectorXd::Constant(1, 1e-5),
                         Eigen::RowVectorXd::Ones(1), 1e-3));
  CHECK(curve.x.back() >= 799.0);
  CHECK(curve.x.size() < 10'000);
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    REQUIRE(curve.y[i] == Approx(1.0 - std::pow(0.99999, std::round(curve.x[i] / 1e-3))).margin(1e-9));
}

namespace {

/// A sum of modes in parallel: 1 + sum of parts exp(-rate t).
struct Modes {
  std::vector<double> rates, parts;

  double at(double t) const {
    double y = 1.0;
    for (std::size_t i = 0; i < rates.size(); ++i) y += parts[i] * std::exp(-rates[i] * t);
    return y;
  }
  StateSpace system() const {
    const auto n = static_cast<Eigen::Index>(rates.size());
    StateSpace result =
        siso(Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Ones(n), Eigen::RowVectorXd::Ones(n));
    double direct = 1.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      result.A(i, i) = -rates[k];
      result.C(0, i) = -parts[k] * rates[k];
      direct += parts[k];
    }
    result.D(0, 0) = direct;
    return result;
  }
  /// Returns the last time at which the response leaves the band of 2 % of its way, by halving.
  double settling_time() const {
    const auto away = [&](double t) { return std::abs(at(t) - 1.0) - 0.02 * std::abs(1.0 - at(0.0)); };
    double high = 1000.0;
    while (away(high) < 0.0) high *= 0.999;
    double low = high / 0.999;
    for (int i = 0; i < 100; ++i) (away(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
    return low;
  }
};

/// The settling time by the rows, with the last row as the end.
double settling_time(const ResponseCurve& curve) {
  const double end = curve.y.back(), band = 0.02 * std::abs(end - curve.y.front());
  std::size_t i = curve.y.size() - 1;
  while (std::abs(curve.y[i] - end) <= band) --i;
  const double here = std::abs(curve.y[i] - end), next = std::abs(curve.y[i + 1] - end);
  return curve.x[i] + (here - band) / (here - next) * (curve.x[i + 1] - curve.x[i]);
}

}  // namespace

TEST_CASE("the settling time of modes of any sizes and signs is that of their sum") {
  for (const Modes& modes :
       {Modes{{1.0}, {-1.0}}, Modes{{1.0, 5.0}, {9.0, -10.0}}, Modes{{1.0, 1.2}, {40.0, -41.0}},
        Modes{{0.1, 1.0, 30.0}, {-0.5, 20.0, -20.5}}, Modes{{1.0, 100.0}, {-200.0, 199.0}},
        Modes{{0.01, 1.0}, {0.015, -1.015}}, Modes{{1.0, 2.0, 3.0}, {-300.0, 600.0, -301.0}}}) {
    INFO(modes.parts.front() << " " << modes.rates.front());
    CHECK(settling_time(step_response(modes.system())) == Approx(modes.settling_time()).epsilon(1e-3));
  }
}

TEST_CASE("the settling time behind a delay in a loop is right, too") {
  // y' = 1 - y(t - 0.3 s): by the method of steps y is the sum over k of (-1)^k (t - 0.3 k)^(k+1)/(k+1)!.
  StateSpace system =
      siso(Eigen::MatrixXd::Zero(1, 1), Eigen::VectorXd::Ones(1), Eigen::RowVectorXd::Ones(1));
  system.B = Eigen::RowVector2d(1.0, -1.0);
  system.C = Eigen::Vector2d(1.0, 1.0);
  system.D = Eigen::Matrix2d::Zero();
  system.delays = {{0.3, {"d", ""}, {"e", ""}}};
  const auto y = [](double t) {
    double sum = 0.0, factorial = 1.0;
    for (int k = 0; t - 0.3 * k > 0.0; ++k, factorial *= k + 1)
      sum += (k % 2 == 0 ? 1.0 : -1.0) * std::pow(t - 0.3 * k, k + 1) / factorial;
    return sum;
  };
  double last = 0.0;
  for (double t = 0.0; t < 8.0; t += 1e-5)
    if (std::abs(y(t) - 1.0) > 0.02) last = t;
  CHECK(settling_time(step_response(system)) == Approx(last).epsilon(1e-3));
}

}  // namespace stepwire::linear
