#include "engine/analyse/linear/margins.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "engine/analyse/linear/gain_at_rest.hpp"

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
  StateSpace direct;
  direct.B.resize(0, 1);
  direct.C.resize(1, 0);
  direct.D = Eigen::MatrixXd::Constant(1, 1, 3.0);
  CHECK(gain_at_rest(direct) == 3.0);
  CHECK(gain_at_rest(integrator(-3.0)) == -std::numeric_limits<double>::infinity());
  CHECK(gain_at_rest(sampled_integrator(2.0, 0.1, 1)) == std::numeric_limits<double>::infinity());
  CHECK(gain_at_rest(lags(3, 1e-3, 7.0)) == Approx(7.0));
}

TEST_CASE("a zero at rest cancels a pole there whose coefficients are rounded") {
  // b(z)/((z - 1)(z - p)) with b(1) = 0: the gain at rest is b'(1)/(1 - p).
  for (const double p : {0.9, 0.7, 0.3, 0.95}) {
    Eigen::MatrixXd A(2, 2);
    A << 1.0 + p, -p, 1.0, 0.0;
    const Eigen::MatrixXd B = Eigen::Vector2d(1.0, 0.0);
    const auto rest = [&](double first, double second) {
      return gain_at_rest(system_of(A, B, Eigen::RowVector2d(first, second), 0.01));
    };
    INFO(p);
    CHECK(rest(0.3, -0.3) == Approx(0.3 / (1.0 - p)).epsilon(1e-6));
    CHECK(rest(-1.7, 1.7) == Approx(-1.7 / (1.0 - p)).epsilon(1e-6));
  }
}

TEST_CASE("a zero at rest cancels a pole of a system of fourth order, too") {
  // (z - 1)(0.909 z^2 + ..)/((z - 1)(z - 0.958)(..)) with rounded coefficients; its limit is that of
  // fractions of these doubles at 1 + 1e-9: 47.6707.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4, 4);
  A.row(0) << 2.3091983805316456, -1.8295504351427985, 0.6967049880840206, -0.1763529334728676;
  A.block(1, 0, 3, 3).setIdentity();
  Eigen::VectorXd B = Eigen::VectorXd::Zero(4);
  B[0] = 1.0;
  const Eigen::RowVector4d C(0.9090667046998979, -0.32441410034919377, -0.4194035616675335,
                             -0.16524904268317062);
  CHECK(gain_at_rest(system_of(A, B, C, 0.002)) == Approx(47.6707).epsilon(1e-5));
}

TEST_CASE("the gain at rest is the limit where poles there are double, slow or cancel") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  // (0.1 z + 0.05)/(z - 1)^2, and its negative.
  const Eigen::MatrixXd double_pole = Eigen::Matrix2d{{2.0, -1.0}, {1.0, 0.0}};
  const Eigen::MatrixXd first = Eigen::Vector2d(1.0, 0.0), row = Eigen::RowVector2d(0.1, 0.05);
  CHECK(gain_at_rest(system_of(double_pole, first, row, 0.01)) == infinite);
  CHECK(gain_at_rest(system_of(double_pole, first, -row, 0.01)) == -infinite);
  for (const int delays : {2, 20, 200, 500}) {
    StateSpace late = sampled_integrator(-5.0, 1e-3, delays);
    CHECK(gain_at_rest(late) == -infinite);
    late.A(0, 0) = 0.9999999999999999;  // a step of the solver, rounded
    CHECK(gain_at_rest(late) == -infinite);
  }
  // 1/s - 1/s + 1/(s + 1); with a little more of the second, -1e-6/s remains.
  const Eigen::MatrixXd poles = Eigen::Vector3d(0.0, 0.0, -1.0).asDiagonal();
  const auto difference = [&](double second) {
    return system_of(poles, Eigen::Vector3d::Ones(), Eigen::RowVector3d(1.0, -second, 1.0));
  };
  CHECK(gain_at_rest(difference(1.0)) == Approx(1.0));
  CHECK(bandwidth(difference(1.0)) == Approx(1.0));
  CHECK(gain_at_rest(difference(1.0 + 1e-6)) == -infinite);
  // 1e-6/s beside a fast lag of gain 1, and 1/(s + 1e-6) beside it.
  const auto beside = [](double slow, double gain) {
    const Eigen::MatrixXd A = Eigen::Vector2d(-slow, -1e4).asDiagonal();
    return system_of(A, Eigen::Vector2d(1.0, 1e4), Eigen::RowVector2d(gain, 1.0));
  };
  CHECK(gain_at_rest(beside(0.0, 1e-6)) == infinite);
  CHECK(gain_at_rest(beside(1e-6, 1.0)) == Approx(1e6 + 1.0));
  // s/(s (s + 2)) in its canonical form, and 1/(s^2 + w^2) with a slow w.
  const Eigen::MatrixXd shown = Eigen::Matrix2d{{-2.0, 0.0}, {1.0, 0.0}};
  CHECK(gain_at_rest(system_of(shown, first, Eigen::RowVector2d(1.0, 0.0))) == Approx(0.5));
  const Eigen::MatrixXd slow = Eigen::Matrix2d{{0.0, -1e-6}, {1.0, 0.0}};
  CHECK(gain_at_rest(system_of(slow, first, Eigen::RowVector2d(0.0, 1.0))) == Approx(1e6));
  // The same beside a lag of 1e4/(s + 1e4).
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(3, 3);
  both.topLeftCorner(2, 2) = slow;
  both(2, 2) = -1e4;
  CHECK(gain_at_rest(system_of(both, Eigen::Vector3d(1.0, 0.0, 1e4), Eigen::RowVector3d(0.0, 1.0, 1.0))) ==
        Approx(1e6 + 1.0));
}

TEST_CASE("a gain at rest that rounding may hide is never a wrong one") {
  // 1/s - 1/s + 1/(s^2 + w^2) + 1e4/(s + 1e4) with w = 1e-3.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(5, 5);
  A(2, 3) = -1e-6;
  A(3, 2) = 1.0;
  A(4, 4) = -1e4;
  Eigen::MatrixXd B(5, 1), C(1, 5);
  B << 1.0, 1.0, 1.0, 0.0, 1e4;
  C << 1.0, -1.0, 0.0, 1.0, 1.0;
  const double gain = gain_at_rest(system_of(A, B, C));
  CHECK((std::isnan(gain) || gain == Approx(1e6 + 1.0)));
  CHECK((std::isnan(gain) || std::isfinite(bandwidth(system_of(A, B, C)))));
}

TEST_CASE("an integrator that a delay closes inside of the system has a gain at rest") {
  // k/(s + k h exp(-s)): 1/h at rest. For k = 0.5 and h = 1 the gain is 1/sqrt(2) at 1.124334112484634 rad/s.
  const auto closed = [](double k, double h) {
    StateSpace system = integrator(1.0);
    system.delays = {{1.0, {"d.u", ""}, {"d.y", ""}}};
    system.B = Eigen::RowVector2d(k, -k);
    system.C = Eigen::Vector2d(1.0, h);
    system.D = Eigen::MatrixXd::Zero(2, 2);
    return system;
  };
  CHECK(gain_at_rest(closed(0.5, 1.0)) == Approx(1.0));
  CHECK(bandwidth(closed(0.5, 1.0)) == Approx(1.124334112484634).epsilon(1e-9));
  CHECK(gain_at_rest(closed(1.0, 0.25)) == Approx(4.0));
  CHECK(gain_at_rest(closed(1.0, 0.0)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("a loop whose gain is 1 everywhere has no phase and delay margin that is met") {
  // (s + 2)/(s + 1) * (s + 1)/(s + 2) = 1, and (1 - s)/(1 + s)
  StateSpace one =
      system_of(-Eigen::MatrixXd::Identity(2, 2), Eigen::MatrixXd::Ones(2, 1), Eigen::MatrixXd::Zero(1, 2));
  one.A << -1.0, 0.0, 1.0, -2.0;
  one.B << 1.0, 1.0;
  one.C << 1.0, -1.0;
  one.D << 1.0;
  StateSpace pass = system_of(-Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd::Ones(1, 1),
                              Eigen::MatrixXd::Constant(1, 1, 2.0));
  pass.D << -1.0;
  for (const StateSpace& system : {one, pass})
    for (const double feedback : {-1.0, 1.0}) {
      const Margins margins = margins_of(system, feedback);
      CHECK(margins.phase.empty());
      CHECK_FALSE(margins.knows_phase);
      CHECK(std::isnan(margins.phase_margin()));
      CHECK(std::isnan(margins.delay()));
      REQUIRE(margins.notes.size() == 1);
      CHECK_THAT(margins.notes[0], Catch::Contains("the loop gain is 1 within rounding from"));
    }
  CHECK(margins_of(one, -1.0).stable);
  CHECK(margins_of(one, -1.0).modulus == Approx(2.0));
  CHECK(std::isinf(margins_of(one, -1.0).gain_margin()));
}

TEST_CASE("the least distance from -1 is found at rest, at infinity and in narrow dips") {
  const Margins integrating = margins_of(integrator(1000.0), -1.0);
  CHECK(integrating.modulus == 1.0);
  CHECK(std::isinf(integrating.modulus_frequency));
  const Margins falling = margins_of(system_of(Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd::Ones(1, 1),
                                               Eigen::MatrixXd::Constant(1, 1, 0.5)),
                                     -1.0);
  CHECK(falling.modulus == Approx(0.5).epsilon(1e-14));
  CHECK(falling.modulus_frequency == 0.0);
  // Two lags of gain 1e8, with z = (2 w)^2: ((1 - z + 1e8)^2 + 4 z)/(1 + z)^2 is least near z = 1e8.
  const Margins two = margins_of(lags(2, 2.0, 1e8), -1.0);
  CHECK(two.modulus == Approx(2e-4).epsilon(1e-6));
}

TEST_CASE("a direct path with a gain of 1 or more leaves no room for a delay") {
  // (2 s + 1)/(s + 1) and (s + 2)/(s + 1): stable, and unstable with any delay.
  for (const double direct : {1.0, 2.0}) {
    StateSpace lead = system_of(-Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd::Ones(1, 1),
                                Eigen::MatrixXd::Constant(1, 1, direct == 1.0 ? 1.0 : -1.0));
    lead.D << direct;
    const Margins margins = margins_of(lead, -1.0);
    CHECK(margins.stable);
    CHECK(margins.delay() == 0.0);
  }
}

TEST_CASE("the bandwidth is found in a narrow notch and far beyond the corners") {
  // Notch at 1 rad/s with damping 1e-4: its flank is at 1 - 1e-4 (1/sqrt(2) of the gain).
  StateSpace notch =
      system_of(Eigen::MatrixXd::Zero(2, 2), Eigen::MatrixXd::Zero(2, 1), Eigen::MatrixXd::Zero(1, 2));
  notch.A << -2e-4, -1.0, 1.0, 0.0;
  notch.B << 1.0, 0.0;
  notch.C << -2e-4, 0.0;
  notch.D << 1.0;
  CHECK(bandwidth(notch) == Approx(std::sqrt(1.0 + 1e-8) - 1e-4).epsilon(1e-9));
  // (0.707 s + 1)/(s + 1) passes 1/sqrt(2) where w^2 (1/2 - 0.707^2) = 1 - 1/2.
  StateSpace lag = system_of(-Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd::Ones(1, 1),
                             Eigen::MatrixXd::Constant(1, 1, 1.0 - 0.707));
  lag.D << 0.707;
  CHECK(bandwidth(lag) == Approx(std::sqrt(0.5 / (0.5 - 0.707 * 0.707))).epsilon(1e-6));
}

TEST_CASE("a loop that is nowhere finite has no margins") {
  const Margins margins = margins_of(integrator(std::numeric_limits<double>::quiet_NaN()), -1.0);
  CHECK_FALSE(margins.stable);
  CHECK(std::isnan(margins.gain_margin()));
  CHECK(std::isnan(margins.modulus_margin()));
}

}  // namespace stepwire::linear
