// Systems with delays, against closed forms.
#include "engine/analyse/linear/delay_system.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/analyse/linear/gain_at_rest.hpp"
#include "engine/analyse/linear/margins.hpp"
#include "engine/analyse/linear/step_response.hpp"

namespace stepwire::linear {

namespace {

constexpr double pi = std::numbers::pi;

/// The input goes through a delay, then into A, B, C.
StateSpace delayed(const Eigen::MatrixXd& A, const Eigen::VectorXd& B, const Eigen::RowVectorXd& C,
                   double time) {
  const Eigen::Index n = A.rows();
  StateSpace system{A,
                    Eigen::MatrixXd::Zero(n, 2),
                    Eigen::MatrixXd::Zero(2, n),
                    Eigen::MatrixXd::Zero(2, 2),
                    {},
                    {{"u", ""}},
                    {{"y", ""}},
                    0.0,
                    {{time, {"d.u", ""}, {"d.y", ""}}}};
  for (Eigen::Index i = 0; i < n; ++i) system.states.push_back({"x" + std::to_string(i), ""});
  system.B.col(1) = B;
  system.C.row(0) = C;
  system.D(1, 0) = 1.0;
  return system;
}

StateSpace integrator(double gain, double time) {
  return delayed(Eigen::MatrixXd::Zero(1, 1), Eigen::VectorXd::Ones(1), Eigen::RowVectorXd::Constant(1, gain),
                 time);
}

/// y = u + a y(t - time): a loop of a delay alone.
StateSpace echo(double a, double time) {
  StateSpace system{Eigen::MatrixXd(0, 0),
                    Eigen::MatrixXd(0, 2),
                    Eigen::MatrixXd(2, 0),
                    Eigen::MatrixXd(2, 2),
                    {},
                    {{"u", ""}},
                    {{"y", ""}},
                    0.0,
                    {{time, {"d.u", ""}, {"d.y", ""}}}};
  system.D << 1.0, a, 1.0, a;
  return system;
}

double nearest(const std::vector<Complex>& poles, const Complex& wanted) {
  double distance = 1e300;
  for (const Complex& pole : poles) distance = std::min(distance, std::abs(pole - wanted));
  return distance;
}

}  // namespace

TEST_CASE("all crossings of a fast lag behind a delay are listed up to the last crossover") {
  // L = 100 / (0.01 s + 1) exp(-0.31 s) is real and negative where atan(0.01 w) + 0.31 w = (2 k + 1) pi.
  const Margins margins =
      margins_of(delayed(Eigen::MatrixXd::Constant(1, 1, -100.0), Eigen::VectorXd::Constant(1, 100.0),
                         Eigen::RowVectorXd::Constant(1, 100.0), 0.31),
                 -1.0);
  const double last = margins.gain_up_to;
  CHECK(last > 1e4);  // |L| = 1 at 9999.5 rad/s
  CHECK(margins.gain_left_out == 0);
  const double turns = (std::atan(0.01 * last) + 0.31 * last) / (2.0 * pi);
  REQUIRE(static_cast<double>(margins.gain.size()) == std::floor(turns + 0.5));
  for (std::size_t k = 0; k < margins.gain.size(); ++k) {
    const double w = margins.gain[k].frequency;
    CHECK(std::atan(0.01 * w) + 0.31 * w == Approx((2.0 * static_cast<double>(k) + 1.0) * pi).epsilon(1e-12));
    CHECK(margins.gain[k].margin == Approx(std::hypot(1.0, 0.01 * w) / 100.0).epsilon(1e-9));
  }
}

TEST_CASE("poles are counted beside two poles at rest, whichever states a controller has") {
  // A PD controller, an unstable lag, an all-pass and two integrators behind 0.1 s: no gain makes that
  // stable. The states of the controller are those of a PID, the idle integral among them, then of a transfer
  // function.
  for (const bool has_integral : {true, false}) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(7, 7);
    Eigen::VectorXd B = Eigen::VectorXd::Zero(7);
    A(1, 1) = -100.0;
    A(2, 0) = has_integral ? 1.0 : 0.0;
    A(2, 1) = has_integral ? -10.0 : -1000.0;
    A(2, 2) = 0.16674999999996962;
    A(3, 2) = A(5, 2) = 0.3335;
    A(3, 3) = -8.8;
    A(3, 4) = -30.5;
    A(4, 3) = A(6, 5) = 1.0;
    A(5, 3) = -17.6;
    B(1) = has_integral ? 100.0 : 1.0;
    B(2) = 11.0;
    Eigen::RowVectorXd C = Eigen::RowVectorXd::Zero(7);
    C(6) = 1.0;
    const Margins margins = margins_of(delayed(A, B, C, 0.1), -1.0);
    INFO(has_integral);
    CHECK(margins.knows_stability);
    CHECK_FALSE(margins.stable);
  }
}

TEST_CASE("the number of crossings that are not listed is known") {
  // An integrator of gain 1e6 / s behind 1 s passes 159155 half turns before its crossover.
  const Margins margins = margins_of(integrator(1e6, 1.0), -1.0);
  CHECK(margins.gain_up_to > 1e6);
  const double turns = (0.5 * pi + margins.gain_up_to) / (2.0 * pi);
  CHECK(static_cast<double>(margins.gain.size() + margins.gain_left_out) == std::floor(turns + 0.5));
  CHECK(margins.gain_left_out > 100'000);
}

TEST_CASE("an integrator behind a delay has the margins of its closed form") {
  for (const double gain : {0.02, 0.3, 1.2})
    for (const double time : {0.01, 1.0}) {
      INFO(gain << " " << time);
      const Margins margins = margins_of(integrator(gain / time, time), -1.0);
      CHECK(margins.stable);
      REQUIRE(margins.worst_phase());
      CHECK(margins.worst_phase()->frequency * time == Approx(gain));
      CHECK(margins.worst_phase()->margin == Approx(0.5 * pi - gain));
      REQUIRE(margins.worst_gain());
      CHECK(margins.worst_gain()->frequency * time == Approx(0.5 * pi));
      CHECK(margins.worst_gain()->margin == Approx(0.5 * pi / gain));
      CHECK(margins.delay() / time == Approx(0.5 * pi / gain - 1.0));
    }
}

TEST_CASE("a loop with a delay is stable up to the gain of its closed form") {
  for (const double share : {0.1, 0.9, 0.999})
    CHECK(margins_of(integrator(share * 0.5 * pi, 1.0), -1.0).stable);
  for (const double share : {1.001, 1.5, 30.0}) {
    const Margins margins = margins_of(integrator(share * 0.5 * pi, 1.0), -1.0);
    CHECK_FALSE(margins.stable);
    REQUIRE(margins.worst_gain());
    CHECK(margins.worst_gain()->margin < 1.0);
  }
}

TEST_CASE("the number of unstable poles is counted, however far they are") {
  // s + k exp(-s) = 0 gains a pair at k = pi/2 + 2 pi n.
  for (int n = 0; n < 5; ++n) {
    const double border = 0.5 * pi + 2.0 * pi * n;
    CHECK(count_unstable(integrator(border - 0.01, 1.0).closed(-1.0)) == 2 * n);
    CHECK(count_unstable(integrator(border + 0.01, 1.0).closed(-1.0)) == 2 * n + 2);
  }
}

TEST_CASE("poles of a loop with a delay are those of Lambert's function") {
  // s = W_k(-1) from scipy.special.lambertw(-1, k), k = 0, 1, 2
  const auto poles = poles_of(integrator(1.0, 1.0).closed(-1.0));
  for (const Complex pole :
       {Complex(-0.31813150520476413, 1.3372357014306895), Complex(-2.0622777295982846, 7.588631178472513),
        Complex(-2.6531919740386973, 13.949208334533214)}) {
    CHECK(nearest(poles, pole) < 1e-9);
    CHECK(nearest(poles, std::conj(pole)) < 1e-9);
  }
}

TEST_CASE("two lags and two delays in one loop agree with their transfer function") {
  // L = k exp(-0.2 s)/(0.1 s + 1) * exp(-0.05 s)/(0.3 s + 1)
  StateSpace system{Eigen::MatrixXd(2, 2),
                    Eigen::MatrixXd::Zero(2, 3),
                    Eigen::MatrixXd::Zero(3, 2),
                    Eigen::MatrixXd::Zero(3, 3),
                    {{"a", ""}, {"b", ""}},
                    {{"u", ""}},
                    {{"y", ""}},
                    0.0,
                    {{0.2, {"d.u", ""}, {"d.y", ""}}, {0.05, {"e.u", ""}, {"e.y", ""}}}};
  system.A << -10.0, 0.0, 0.0, -1.0 / 0.3;
  system.B(0, 1) = 10.0;
  system.B(1, 2) = 1.0 / 0.3;
  system.C(0, 1) = 4.0;
  system.C(2, 0) = 1.0;
  system.D(1, 0) = 1.0;
  const FrequencyResponse response(system);
  for (const double w : {0.01, 1.0, 7.0, 200.0}) {
    const Complex s(0.0, w), expected = 4.0 * std::exp(-0.25 * s) / (0.1 * s + 1.0) / (0.3 * s + 1.0);
    CHECK(std::abs(response.at(w) - expected) < 1e-12 * std::abs(expected) + 1e-15);
  }
  CHECK(gain_at_rest(system) == Approx(4.0));
  CHECK(count_unstable(system.closed(-1.0)) == 2);
  CHECK(margins_of(system, -1.0).worst_gain()->margin < 1.0);
}

TEST_CASE("an echo is stable below a gain of 1 and not above") {
  CHECK(count_unstable(echo(0.9, 0.1)) == 0);
  CHECK(count_unstable(echo(-0.9, 0.1)) == 0);
  CHECK(is_stable(echo(0.5, 0.1)));
  CHECK_FALSE(is_stable(echo(1.1, 0.1)));
  // s = (ln|a| + i ...)/time is on the axis or to its right, without end.
  for (const double a : {1.0, -1.0, 1.5, -3.0}) CHECK(count_unstable(echo(a, 0.1)) == infinitely_many);
  CHECK(count_unstable(echo(0.9995, 0.1)) == 0);
}

TEST_CASE("a closed loop of a gain and a delay is judged without doubt") {
  const auto closed = [](double gain) {
    StateSpace loop = echo(0.0, 0.1);
    loop.D << 0.0, gain, 1.0, 0.0;  // y = gain u(t - 0.1 s)
    return margins_of(loop, -1.0);
  };
  for (const double gain : {0.5, -0.5, 0.99}) CHECK((closed(gain).stable && closed(gain).knows_stability));
  for (const double gain : {1.0, 1.5, -2.0}) CHECK((!closed(gain).stable && closed(gain).knows_stability));
}

TEST_CASE("two echoes are judged by the roots of their polynomial") {
  // y = a y(t - T1) + b y(t - T2): the roots z of 1 = a/z^n + b/z^m, by numpy.roots. For T1 = 2 T2 and
  // (a, b) = (-0.5, 0.6): z^2 - 0.6 z + 0.5, |z| = 0.7071. For (0.5, 0.6): 1.0681. (-0.6, 0.6): 0.7746.
  const auto two = [](double a, double b, double first, double second) {
    StateSpace system{Eigen::MatrixXd(0, 0),
                      Eigen::MatrixXd(0, 3),
                      Eigen::MatrixXd(3, 0),
                      Eigen::MatrixXd(3, 3),
                      {},
                      {{"u", ""}},
                      {{"y", ""}},
                      0.0,
                      {{first, {"d.u", ""}, {"d.y", ""}}, {second, {"e.u", ""}, {"e.y", ""}}}};
    system.D << 1.0, a, b, 1.0, a, b, 1.0, a, b;
    return count_unstable(system);
  };
  CHECK(two(-0.5, 0.6, 0.2, 0.1) == 0);
  CHECK(two(0.5, 0.6, 0.2, 0.1) == infinitely_many);
  CHECK(two(-0.6, 0.6, 0.2, 0.1) == 0);
  CHECK(two(0.4, 0.5, 0.2, 0.1 * std::numbers::pi) == 0);
}

TEST_CASE("echoes without a common step are judged by their gains over all phases") {
  const auto two = [](const Eigen::Matrix2d& gains) {
    StateSpace system{Eigen::MatrixXd(0, 0),
                      Eigen::MatrixXd(0, 3),
                      Eigen::MatrixXd(3, 0),
                      Eigen::MatrixXd::Ones(3, 3),
                      {},
                      {{"u", ""}},
                      {{"y", ""}},
                      0.0,
                      {{1.0, {"d.u", ""}, {"d.y", ""}}, {std::numbers::sqrt2, {"e.u", ""}, {"e.y", ""}}}};
    system.D.bottomRightCorner(2, 2) = gains;
    return count_unstable(system);
  };
  const auto sum = [&](double a, double b) { return two(Eigen::Matrix2d{{a, b}, {a, b}}); };
  // 1 = a exp(-s T1) + b exp(-s T2) has roots on the right for |a| + |b| > 1, and none below 1.
  CHECK(sum(0.7, 0.7) == infinitely_many);
  CHECK(sum(0.7, -0.5) == infinitely_many);
  CHECK(sum(0.5, -0.4) == 0);
  CHECK_FALSE(sum(0.5, 0.5).has_value());
  // The eigenvalues of diag(1, exp(j p)) [0.6 0.6; -0.6 0.6] have the size sqrt(0.72) for each phase p.
  CHECK(two(Eigen::Matrix2d{{0.6, 0.6}, {-0.6, 0.6}}) == 0);
  CHECK(two(Eigen::Matrix2d{{0.8, 0.8}, {-0.8, 0.8}}) == infinitely_many);
}

TEST_CASE("a step comes out of an integrator with delayed feedback as the method of steps has it") {
  // x' = 1 - x(t - 1): t, then t - (t-1)^2/2, then + (t-2)^3/6.
  StateSpace loop{Eigen::MatrixXd::Zero(1, 1),
                  Eigen::MatrixXd(1, 2),
                  Eigen::MatrixXd(2, 1),
                  Eigen::MatrixXd::Zero(2, 2),
                  {{"x", ""}},
                  {{"u", ""}},
                  {{"y", ""}},
                  0.0,
                  {{1.0, {"d.u", ""}, {"d.y", ""}}}};
  loop.B << 1.0, -1.0;
  loop.C << 1.0, 1.0;
  const ResponseCurve curve = step_response(loop);
  double worst = 0.0;
  for (std::size_t i = 0; i < curve.x.size() && curve.x[i] <= 3.0; ++i) {
    const double t = curve.x[i], first = std::max(0.0, t - 1.0), second = std::max(0.0, t - 2.0);
    worst =
        std::max(worst, std::abs(curve.y[i] - (t - first * first / 2.0 + second * second * second / 6.0)));
  }
  CHECK(curve.x.back() > 3.0);
  CHECK(worst < 1e-5);
  CHECK(curve.y.back() == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("a jump that comes back is not smeared") {
  const ResponseCurve curve = step_response(echo(0.5, 1.0));
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const double turns = curve.x[i] - std::floor(curve.x[i] + 1e-9);
    if (turns < 0.05 || turns > 0.95) continue;
    CHECK(curve.y[i] == Approx(2.0 - std::pow(0.5, std::floor(curve.x[i]))).epsilon(1e-9));
  }
}

TEST_CASE("a long delay and a high gain take bounded work") {
  // 1e8 exp(-0.002 s)/s: near 1e8 rad/s L passes -1 at most half a turn away, |1 + L| <= pi / 0.002 / 1e8.
  const Margins fast = margins_of(integrator(1e8, 0.002), -1.0);
  CHECK_FALSE(fast.stable);
  CHECK(fast.modulus <= 1.6e-5);
  REQUIRE(fast.worst_gain());
  CHECK(fast.worst_gain()->margin < 1.0);
  CHECK(fast.worst_gain()->margin > 1.0 - 4e-5);
  CHECK(fast.phase.at(0).frequency == Approx(1e8));
  // 0.5 exp(-1000 s)/(1 + 1e-6 s): the first passage of the negative axis is at pi/1000 rad/s.
  const auto slow = [](double gain) {
    return delayed(Eigen::MatrixXd::Constant(1, 1, -1e6), Eigen::VectorXd::Constant(1, 1e6),
                   Eigen::RowVectorXd::Constant(1, gain), 1000.0);
  };
  const Margins half = margins_of(slow(0.5), -1.0);
  CHECK(half.stable);
  CHECK(half.gain_margin() == Approx(2.0).epsilon(1e-9));
  CHECK(std::isinf(half.phase_margin()));
  CHECK(std::isinf(half.delay()));
  CHECK(half.modulus == Approx(0.5).epsilon(1e-9));
  const Margins ten = margins_of(slow(10.0), -1.0);
  CHECK_FALSE(ten.stable);
  CHECK(ten.knows_stability);
  CHECK(ten.phase.at(0).frequency == Approx(1e6 * std::sqrt(99.0)));
  CHECK(poles_of(slow(0.5)).at(0).real() == Approx(-1e6));
}

TEST_CASE("many poles of a long delay are counted by its crossings") {
  // s + k exp(-s) = 0 has 2 (n + 1) poles on the right for pi/2 + 2 pi n < k < pi/2 + 2 pi (n + 1).
  for (const int n : {60, 1000, 123456}) {
    const double border = 0.5 * pi + 2.0 * pi * n;
    CHECK(count_unstable(integrator(border - 0.01, 1.0).closed(-1.0)) == 2 * n);
    CHECK(count_unstable(integrator(border + 0.01, 1.0).closed(-1.0)) == 2 * n + 2);
  }
  // An oscillator 1/(s^2 + 1) with feedback 0.1: crossovers at sqrt(1.1) and sqrt(0.9); the delay makes it
  // unstable and stable in turn.
  Eigen::MatrixXd A(2, 2);
  A << 0.0, -1.0, 1.0, 0.0;
  const Eigen::VectorXd B = Eigen::Vector2d(1.0, 0.0);
  const Eigen::RowVectorXd C = Eigen::RowVector2d(0.0, 0.1);
  const auto pairs = [&](double time) {  // Walton and Marshall by hand
    const double up = std::sqrt(1.1), down = std::sqrt(0.9);
    return 1.0 + std::floor(time * up / (2.0 * pi)) - std::floor((time * down + pi) / (2.0 * pi));
  };
  for (const double time : {1.0, 4.0, 20.0, 500.5, 3001.0})
    CHECK(count_unstable(delayed(A, B, C, time).closed(-1.0)) == 2 * static_cast<int>(pairs(time)));
}

TEST_CASE("a slow loop beside a fast lag is counted, too") {
  // 2e-3 exp(-1000 s) / s behind a lag of 1 us: unstable, as 2 > pi/2.
  Eigen::MatrixXd A(2, 2);
  A << -1e6, 0.0, 1e6, 0.0;
  const auto loop = [&](double gain) {
    Eigen::MatrixXd slow = A;
    slow(1, 0) = gain;
    return delayed(slow, Eigen::Vector2d(1e6, 0.0), Eigen::RowVector2d(0.0, 1.0), 1000.0);
  };
  CHECK(count_unstable(loop(2e-3).closed(-1.0)) == 2);
  CHECK(count_unstable(loop(1e-3).closed(-1.0)) == 0);
}

TEST_CASE("a short delay before a slow lag costs no more steps than the lag") {
  const auto lag = delayed(Eigen::MatrixXd::Constant(1, 1, -1e-3), Eigen::VectorXd::Constant(1, 1e-3),
                           Eigen::RowVectorXd::Ones(1), 1e-6);
  const ResponseCurve curve = step_response(lag);
  const auto later = delayed(Eigen::MatrixXd::Constant(1, 1, -1e-3), Eigen::VectorXd::Constant(1, 1e-3),
                             Eigen::RowVectorXd::Ones(1), 1.0);  // a delay of a second
  REQUIRE(curve.x.size() == step_response(later).x.size());
  CHECK(curve.x.size() == 1242);  // 100 a time constant, to the rest within 3e-5 of the way
  for (const std::size_t k : {101u, 200u, 900u})
    CHECK(curve.y[k] == Approx(1.0 - std::exp(-1e-3 * (curve.x[k] - 1e-6))).epsilon(1e-9));
}

TEST_CASE("beyond the turns of parallel delays nothing is promised") {
  // 0.5 u(t - 1) + 0.3 u(t - 1.001): |L| comes near 0.8, or with 0.9 in place of 0.5 near 1.2, without end.
  StateSpace both{Eigen::MatrixXd(0, 0),
                  Eigen::MatrixXd(0, 3),
                  Eigen::MatrixXd(3, 0),
                  Eigen::MatrixXd::Zero(3, 3),
                  {},
                  {{"u", ""}},
                  {{"y", ""}},
                  0.0,
                  {{1.0, {"d.u", ""}, {"d.y", ""}}, {1.001, {"e.u", ""}, {"e.y", ""}}}};
  both.D << 0.0, 0.5, 0.3, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0;
  const Margins margins = margins_of(both, -1.0);
  CHECK(margins.stable);
  CHECK(margins.knows_phase);
  CHECK(margins.gain_margin() == Approx(1.25).epsilon(1e-4));
  both.D(0, 1) = 0.9;
  CHECK(std::isnan(margins_of(both, -1.0).phase_margin()));
  CHECK(std::isnan(margins_of(both, -1.0).modulus_margin()));
}

namespace {

/// A gain, a delay, a system of one state with dx/dt = a x + b u, and a second delay, one behind the other.
StateSpace in_series(double gain, double first, double a, double b, double second) {
  StateSpace system{Eigen::MatrixXd::Constant(1, 1, a),
                    Eigen::MatrixXd::Zero(1, 3),
                    Eigen::MatrixXd::Zero(3, 1),
                    Eigen::MatrixXd::Zero(3, 3),
                    {{"x", ""}},
                    {{"u", ""}},
                    {{"y", ""}},
                    0.0,
                    {{first, {"d.u", ""}, {"d.y", ""}}, {second, {"e.u", ""}, {"e.y", ""}}}};
  system.D(1, 0) = gain;
  system.B(0, 1) = b;
  system.C(2, 0) = 1.0;
  system.D(0, 2) = 1.0;
  return system;
}

/// A Smith predictor with the gain 2 for a lag of 1 s, whose gain is `plant`. Delays of 0.2 s and 0.1 s are
/// before and behind it. The model has a gain of 1 and one delay. The input is the reference.
StateSpace smith(double plant) {
  StateSpace system{
      -Eigen::MatrixXd::Identity(2, 2),
      Eigen::MatrixXd::Zero(2, 4),
      Eigen::MatrixXd::Zero(4, 2),
      Eigen::MatrixXd::Zero(4, 4),
      {{"p", ""}, {"m", ""}},
      {{"r", ""}},
      {{"y", ""}},
      0.0,
      {{0.2, {"a.u", ""}, {"a.y", ""}}, {0.1, {"b.u", ""}, {"b.y", ""}}, {0.3, {"c.u", ""}, {"c.y", ""}}}};
  // u = 2 (r - b.y + c.y - m) drives the model and the first delay.
  const Eigen::RowVector4d control(2.0, 0.0, -2.0, 2.0);
  system.A(1, 1) = -3.0;
  system.B(0, 1) = plant;
  system.B.row(1) = control;
  system.C(1, 1) = -2.0;
  system.D.row(1) = control;
  system.C(2, 0) = 1.0;
  system.C(3, 1) = 1.0;
  system.D(0, 2) = 1.0;
  return system;
}

}  // namespace

TEST_CASE("two delays in one loop are as stable as one delay of their sum") {
  // k exp(-0.2 s)/(s + 1): a pole is on the axis where atan(w) + 0.2 w = pi, w = 8.443413449792345, at
  // k = sqrt(1 + w^2) = 8.502424988445018.
  for (const double first : {0.1, 0.03}) {
    const auto count = [&](double gain) {
      return count_unstable(in_series(gain, first, -1.0, 1.0, 0.2 - first).closed(-1.0));
    };
    for (const double gain : {0.5, 1.0, 2.0, 8.5}) CHECK(count(gain) == 0);
    CHECK(count(8.505) == 2);
    CHECK(count(200.0) == count_unstable(delayed(-Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Ones(1),
                                                 Eigen::RowVectorXd::Constant(1, 200.0), 0.2)
                                             .closed(-1.0)));
  }
  const Margins margins = margins_of(in_series(2.0, 0.1, -1.0, 1.0, 0.1), -1.0);
  CHECK(margins.knows_stability);
  CHECK(margins.stable);
  CHECK(margins.phase_margin() == Approx(2.0 * pi / 3.0 - 0.2 * std::sqrt(3.0)));
  // An integrator, k exp(-s T)/s, up to k T = pi/2.
  CHECK(count_unstable(in_series(1.0, 0.7, 0.0, 1.0, 0.8).closed(-1.0)) == 0);
  CHECK(count_unstable(in_series(1.0, 0.7, 0.0, 1.0, 0.9).closed(-1.0)) == 2);
  // 2 exp(-s T)/(s - 1), up to T = (pi/3)/sqrt(3) = 0.6046.
  CHECK(count_unstable(in_series(2.0, 0.3, 1.0, 1.0, 0.304).closed(-1.0)) == 0);
  CHECK(count_unstable(in_series(2.0, 0.3, 1.0, 1.0, 0.305).closed(-1.0)) == 2);
}

TEST_CASE("several loops with direct ways from delay to delay are counted") {
  // The poles are -1 and the roots of s + 3 + 2 (k - 1) exp(-0.3 s) for a plant of gain k. The first is on
  // the axis where 3 tan(0.3 w) = -w: w = 6.648843221281488, at k = 1 + sqrt(9 + w^2)/2 = 4.647160408495244.
  for (const double plant : {1.0, 2.0, 4.64}) CHECK(count_unstable(smith(plant)) == 0);
  CHECK(count_unstable(smith(4.65)) == 2);
}

TEST_CASE("the number of unstable poles is that of the poles found by Newton's method") {
  std::mt19937 bits(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  int stable = 0, unstable = 0;
  for (int k = 0; k < 60; ++k) {
    StateSpace system = smith(1.0);
    for (Eigen::MatrixXd* matrix : {&system.A, &system.B, &system.C})
      *matrix = matrix->unaryExpr([&](double) { return 2.0 * number(bits); });
    system.A.diagonal().array() -= 2.0;
    // Direct ways go from a delay to later ones only, with gains up to 3.
    system.D.setZero();
    for (int i = 1; i < 4; ++i)
      for (int j = 1; j < i; ++j) system.D(i, j) = 3.0 * number(bits);
    const auto poles = delay_poles(system);
    const auto right = std::ranges::count_if(poles, [](const Complex& pole) { return pole.real() > 0.0; });
    CHECK(count_unstable(system) == static_cast<int>(right));
    stable += right == 0;
    unstable += right > 0;
  }
  CHECK(stable > 10);
  CHECK(unstable > 10);
}

TEST_CASE("two delays that echo are stable below a gain of 1 around both") {
  const auto echoes = [](double there, double back) {
    StateSpace system = echo(0.0, 0.2);
    system.delays.push_back({0.3, {"e.u", ""}, {"e.y", ""}});
    system.B.resize(0, 3);
    system.C.resize(3, 0);
    system.D = Eigen::MatrixXd::Zero(3, 3);
    system.D << 1.0, 0.0, back, 1.0, 0.0, back, 0.0, there, 0.0;
    return count_unstable(system);
  };
  CHECK(echoes(5.0, 0.19) == 0);
  CHECK(echoes(0.19, 5.0) == 0);
  CHECK(echoes(5.0, 0.21) == infinitely_many);
}

}  // namespace stepwire::linear
