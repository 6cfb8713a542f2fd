#include "engine/analyse/linear/margins.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace stepwire::linear {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

StateSpace system_of(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const Eigen::MatrixXd& C,
                     double sample_time = 0.0) {
  StateSpace system{A, B, C, Eigen::MatrixXd::Zero(1, 1), {}, {{"u", ""}}, {{"y", ""}}, sample_time};
  for (Eigen::Index i = 0; i < A.rows(); ++i) system.states.push_back({"x" + std::to_string(i), ""});
  return system;
}

StateSpace integrator(double gain) {
  return system_of(Eigen::MatrixXd::Zero(1, 1), Eigen::MatrixXd::Ones(1, 1),
                   Eigen::MatrixXd::Constant(1, 1, gain));
}

/// Lags of one time constant, one behind the other.
StateSpace lags(int count, double tau, double gain) {
  Eigen::MatrixXd A = -Eigen::MatrixXd::Identity(count, count) / tau;
  for (int i = 1; i < count; ++i) A(i, i - 1) = 1.0 / tau;
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(count, 1), C = Eigen::MatrixXd::Zero(1, count);
  B(0, 0) = 1.0 / tau;
  C(0, count - 1) = gain;
  return system_of(A, B, C);
}

/// gain T / (z - 1) behind a row of delays of one sample.
StateSpace sampled_integrator(double gain, double T, int delays) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(delays + 1, delays + 1);
  A(0, 0) = 1.0;
  for (int i = 1; i <= delays; ++i) A(i, i - 1) = 1.0;
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(delays + 1, 1), C = Eigen::MatrixXd::Zero(1, delays + 1);
  B(0, 0) = T;
  C(0, delays) = gain;
  return system_of(A, B, C, T);
}

}  // namespace

TEST_CASE("a crossover is found however far it is from poles and zeros") {
  for (const double gain : {1e-9, 1e-3, 1.0, 1000.0, 1e7}) {
    const Margins margins = margins_of(integrator(gain), -1.0);
    REQUIRE(margins.phase.size() == 1);
    CHECK(margins.phase[0].frequency == Approx(gain));
    CHECK(margins.phase[0].margin == Approx(90.0 * degree));
    CHECK(margins.gain.empty());
  }
  const Margins one = margins_of(lags(1, 2.0, 2500.0), -1.0);
  REQUIRE(one.phase.size() == 1);
  CHECK(one.phase[0].frequency == Approx(std::sqrt(2500.0 * 2500.0 - 1.0) / 2.0));
  CHECK(one.phase[0].margin == Approx(std::numbers::pi - std::atan(2.0 * one.phase[0].frequency)));
  const Margins two = margins_of(lags(2, 2.0, 1e8), -1.0);
  REQUIRE(two.phase.size() == 1);
  CHECK(two.phase[0].margin / degree == Approx(2.0 * std::atan(1e-4) / degree).epsilon(1e-4));
}

TEST_CASE("the crossover of a sampled loop is found far below its sample frequency") {
  const Margins margins = margins_of(sampled_integrator(1.0, 1e-3, 0), -1.0);
  REQUIRE(margins.phase.size() == 1);
  CHECK(margins.phase[0].frequency == Approx(1.0).epsilon(1e-6));
  CHECK(margins.phase[0].margin == Approx(90.0 * degree - 0.5e-3).epsilon(1e-6));
}

TEST_CASE("an unstable loop with a delay has no margin that is met") {
  // |L| = 5 / w and its phase -90 deg - 0.5 s w, but for half a sample of the integrator.
  const Margins margins = margins_of(sampled_integrator(5.0, 1e-3, 500), -1.0);
  CHECK_FALSE(margins.stable);
  REQUIRE(margins.worst_phase());
  CHECK(margins.worst_phase()->frequency == Approx(5.0).epsilon(1e-4));
  CHECK(margins.worst_phase()->margin / degree == Approx(90.0 - 2.5025 / degree).epsilon(1e-3));
  REQUIRE(margins.worst_gain());
  CHECK(20.0 * std::log10(margins.worst_gain()->margin) == Approx(-4.04).margin(0.02));
  CHECK(std::isnan(margins.delay()));
}

TEST_CASE("a gain that an unstable loop may still get is no margin") {
  // 1 / (s - 2) grows in a loop of gain 1; from gain 2 on it is stable.
  const Margins margins = margins_of(system_of(Eigen::MatrixXd::Constant(1, 1, 2.0),
                                               Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd::Ones(1, 1)),
                                     -1.0);
  CHECK_FALSE(margins.stable);
  REQUIRE(margins.gain.size() == 1);
  CHECK(margins.gain[0].margin == Approx(2.0));
  CHECK_FALSE(margins.worst_gain());
  CHECK_FALSE(margins.worst_phase());
}

TEST_CASE("rounding far beyond all corners makes no gain margin") {
  CHECK(margins_of(lags(2, 1e-3, 1e12), -1.0).gain.empty());
  CHECK(margins_of(lags(3, 1.0, 4.0), -1.0).gain.size() == 1);  // 8 / 4 at sqrt(3)
}

TEST_CASE("the gain at rest of what integrates is infinite") {
  CHECK(gain_at_rest(integrator(-3.0)) == -std::numeric_limits<double>::infinity());
  CHECK(gain_at_rest(sampled_integrator(2.0, 0.1, 1)) == std::numeric_limits<double>::infinity());
  CHECK(gain_at_rest(lags(3, 1e-3, 7.0)) == Approx(7.0));
}

}  // namespace stepwire::linear
