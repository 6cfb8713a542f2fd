#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "engine/analyse/linear/gain_at_rest.hpp"
#include "engine/analyse/linear/margins.hpp"
#include "engine/analyse/linear/poles.hpp"
#include "engine/analyse/linear/slopes.hpp"
#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

namespace {

/// The controllable canonical form of b(s)/a(s), a monic, highest power first; b with as many numbers as a.
StateSpace form_of(const std::vector<double>& b, const std::vector<double>& a, double sample_time = 0.0) {
  const auto n = static_cast<Eigen::Index>(a.size() - 1);
  StateSpace system{Eigen::MatrixXd::Zero(n, n),
                    Eigen::MatrixXd::Zero(n, 1),
                    Eigen::MatrixXd(1, n),
                    Eigen::MatrixXd::Constant(1, 1, b[0]),
                    {},
                    {{"u", ""}},
                    {{"y", ""}},
                    sample_time};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i + 1);
    system.A(0, i) = -a[k];
    if (i > 0) system.A(i, i - 1) = 1.0;
    system.C(0, i) = b[k] - a[k] * b[0];
    system.states.push_back({"x", ""});
  }
  system.B(0, 0) = 1.0;
  return system;
}

double degrees(double angle) {
  return angle * 180.0 / std::numbers::pi;
}

}  // namespace

// octave: pkg load control; [gm, pm, wg, wp] = margin(tf(4, [1 3 3 1])) gives
// 2 27.1416306 1.732050808 1.232818762
TEST_CASE("the margins of 4/(s+1)^3 are those of octave-control") {
  const Margins margins = margins_of(form_of({0, 0, 0, 4}, {1, 3, 3, 1}), -1.0);
  REQUIRE(margins.gain.size() == 1);
  REQUIRE(margins.phase.size() == 1);
  CHECK(margins.gain[0].margin == Approx(2.0).epsilon(1e-10));  // 8/4
  CHECK(margins.gain[0].frequency == Approx(std::sqrt(3.0)).epsilon(1e-10));
  const double crossover = std::sqrt(std::cbrt(16.0) - 1.0);  // |1 + jw|^3 = 4
  CHECK(margins.phase[0].frequency == Approx(crossover).epsilon(1e-10));
  CHECK(degrees(margins.phase[0].margin) ==
        Approx(180.0 - 3.0 * degrees(std::atan(crossover))).epsilon(1e-9));
  CHECK(degrees(margins.phase[0].margin) == Approx(27.1416306).epsilon(1e-8));
  CHECK(margins.stable);
  CHECK(margins.delay() == Approx(margins.phase[0].margin / crossover));
}

TEST_CASE("a loop that needs gain has a margin below 1") {
  // k (s + 1)^2 / s^3 closes to s^3 + k s^2 + 2 k s + k: by Routh stable for k above 1/2, here 12.
  const Margins margins = margins_of(form_of({0, 12, 24, 12}, {1, 0, 0, 0}), -1.0);
  REQUIRE(margins.gain.size() == 1);
  CHECK(margins.gain[0].margin == Approx(0.5 / 12.0).epsilon(1e-9));
  CHECK(margins.gain[0].frequency == Approx(1.0).epsilon(1e-9));
  CHECK(margins.stable);
  CHECK_FALSE(margins_of(form_of({0, 0.4, 0.8, 0.4}, {1, 0, 0, 0}), -1.0).stable);
}

TEST_CASE("a mode that grows outside of the loop makes it unstable, and an integrator there does not") {
  // 1/(s + 1) closed by -1 has its pole at -2. Beside it a mode that the input does not reach.
  const auto beside = [](double pole, double reached, double shown) {
    StateSpace system = form_of({0, 1}, {1, 1});
    system.A = Eigen::Matrix2d{{-1.0, 0.0}, {0.0, pole}};
    system.B = Eigen::Vector2d{1.0, reached};
    system.C = Eigen::RowVector2d{1.0, shown};
    system.states.push_back({"z", ""});
    return margins_of(system, -1.0);
  };
  for (const auto& [reached, shown] : {std::pair{0.0, 1.0}, {1.0, 0.0}}) {
    const Margins grows = beside(5.0, reached, shown);
    CHECK_FALSE(grows.stable);
    REQUIRE(grows.hidden);
    CHECK(grows.hidden->real() == Approx(5.0));
    REQUIRE(grows.closed_poles.size() == 1);
    CHECK(grows.closed_poles[0].real() == Approx(-2.0));
    CHECK(beside(0.0, reached, shown).stable);
    CHECK(beside(-3.0, reached, shown).stable);
  }
}

TEST_CASE("a loop that comes back as it is has the margins of its negative") {
  const Margins margins = margins_of(form_of({0, 0, 0, -4}, {1, 3, 3, 1}), 1.0);
  REQUIRE(margins.gain.size() == 1);
  CHECK(margins.gain[0].margin == Approx(2.0).epsilon(1e-10));
}

TEST_CASE("the margins of a sampled loop end at half of the sample frequency") {
  // 0.5/(z - 1): its gain margin is 4, at z = -1; |L| = 1 where 2 sin(wT/2) = 0.5.
  const Margins margins = margins_of(form_of({0, 0.5}, {1, -1}, 0.01), -1.0);
  REQUIRE(margins.gain.size() == 1);
  CHECK(margins.gain[0].margin == Approx(4.0));
  CHECK(margins.gain[0].frequency == Approx(std::numbers::pi / 0.01));
  REQUIRE(margins.phase.size() == 1);
  const double wt = 2.0 * std::asin(0.25);
  CHECK(margins.phase[0].frequency == Approx(wt / 0.01).epsilon(1e-9));
  CHECK(margins.phase[0].margin == Approx(0.5 * std::numbers::pi - 0.5 * wt).epsilon(1e-9));
}

TEST_CASE("bandwidth and gain at rest of a lag are those of its time constant") {
  const StateSpace lag = form_of({0, 3.0 / 0.2}, {1, 1.0 / 0.2});
  CHECK(gain_at_rest(lag) == Approx(3.0));
  CHECK(bandwidth(lag) == Approx(5.0).epsilon(1e-9));
  CHECK(bandwidth(form_of({0, 1}, {1, 0})) == 0.0);
}

TEST_CASE("zeros of one channel are the roots of its numerator, whatever the relative degree") {
  const auto zeros = zeros_of(form_of({0, 0, 1, 7, 10}, {1, 5, 8, 9, 3}));
  REQUIRE(zeros.size() == 2);
  CHECK(zeros[0].real() == Approx(-2.0).epsilon(1e-9));
  CHECK(zeros[1].real() == Approx(-5.0).epsilon(1e-9));
  CHECK(zeros_of(form_of({0, 0, 0, 1}, {1, 3, 3, 1})).empty());
  const auto biproper = zeros_of(form_of({2, 3, 1}, {1, 9, 8}));  // (2 s + 1)(s + 1)
  REQUIRE(biproper.size() == 2);
  CHECK(biproper[0].real() == Approx(-0.5).epsilon(1e-12));
  CHECK(biproper[1].real() == Approx(-1.0).epsilon(1e-12));
}

// scipy.linalg.eigvals of the system matrix against diag(I, 0) gives -4, too.
TEST_CASE("transmission zeros of two inputs and two outputs are no zeros of single channels") {
  StateSpace system{Eigen::MatrixXd(3, 3),
                    Eigen::MatrixXd(3, 2),
                    Eigen::MatrixXd(2, 3),
                    Eigen::MatrixXd::Zero(2, 2),
                    {{}, {}, {}},
                    {{}, {}},
                    {{}, {}},
                    0.0};
  system.A << -1, 0, 0, 0, -2, 0, 0, 0, -3;
  system.B << 1, 0, 0, 1, 1, 1;
  system.C << 1, 1, 0, 0, 1, 1;
  const auto zeros = zeros_of(system);
  REQUIRE(zeros.size() == 1);
  // G = [1/(s+1), 1/(s+2); 1/(s+3), 1/(s+2) + 1/(s+3)]: its determinant has the numerator (s+2) + (s+3) -
  // (s+1).
  CHECK(zeros[0].real() == Approx(-4.0).epsilon(1e-9));
}

TEST_CASE("what no input reaches, and no output shows, is missing from the ranks") {
  StateSpace system{Eigen::MatrixXd(3, 3),
                    Eigen::MatrixXd(3, 1),
                    Eigen::MatrixXd(1, 3),
                    Eigen::MatrixXd::Zero(1, 1),
                    {{}, {}, {}},
                    {{}},
                    {{}},
                    0.0};
  system.A << 0, 1e4, 0, -1e4, -20, 0, 0, 0, -1;
  system.B << 0, 1e3, 0;
  system.C << 1e-3, 0, 1;
  CHECK(controllability(system).rank == 2);
  CHECK(observability(system).rank == 3);
  CHECK(controllability(system).singular_values.size() == 3);
  CHECK(controllability(system).singular_values.back() == 0.0);
}

TEST_CASE("a chain of delays has exact zeros as its poles") {
  Eigen::MatrixXd chain = Eigen::MatrixXd::Zero(12, 12);
  for (Eigen::Index i = 1; i < 12; ++i) chain(i, i - 1) = 1.0;
  for (const Complex& pole : eigenvalues(chain)) CHECK(pole == 0.0);
}

TEST_CASE("modes have natural frequency and damping, also of a sampled system") {
  const double w = 10.0, d = 0.3, T = 0.02;
  const auto modes = modes_of(form_of({0, 0, 1}, {1, 2 * d * w, w * w}));
  CHECK(modes[0].frequency == Approx(w));
  CHECK(modes[0].damping == Approx(d));
  const Complex z = std::exp(Complex(-d * w, w * std::sqrt(1 - d * d)) * T);
  const auto sampled = modes_of(form_of({0, 0, 1}, {1, -2 * z.real(), std::norm(z)}, T));
  CHECK(sampled[0].frequency == Approx(w).epsilon(1e-9));
  CHECK(sampled[0].damping == Approx(d).epsilon(1e-9));
}

TEST_CASE("slopes of smooth functions are exact to the error that they tell") {
  const auto one = [](double value) { return Eigen::VectorXd::Constant(1, value); };
  const struct {
    std::function<double(double)> function;
    double at, slope;
  } cases[] = {{[](double x) { return std::sin(x); }, 0.3, std::cos(0.3)},
               {[](double x) { return std::tanh(x / 1e-4); }, 0.0, 1e4},
               {[](double x) { return x * x * x; }, 1e5, 3e10},
               {[](double x) { return std::sqrt(x); }, 1e-6, 500.0}};
  for (const auto& one_case : cases) {
    const Slopes slopes = slopes_of([&](double x) { return one(one_case.function(x)); }, one_case.at);
    INFO(one_case.at << " " << one_case.slope);
    CHECK(slopes.value[0] == Approx(one_case.slope).epsilon(1e-8));
    CHECK(std::abs(slopes.value[0] - one_case.slope) <=
          10.0 * slopes.error[0] + 1e-9 * std::abs(one_case.slope));
    CHECK_FALSE(std::isfinite(slopes.left[0]));
  }
}

TEST_CASE("a kink, a jump and steps are told apart from what is smooth") {
  const auto slopes = [](auto function) {
    return slopes_of([=](double x) { return Eigen::VectorXd::Constant(1, function(x)); }, 0.0);
  };
  const Slopes kink = slopes([](double x) { return std::max(x, 0.0); });
  CHECK(kink.left[0] == 0.0);
  CHECK(kink.right[0] == 1.0);
  CHECK_FALSE(kink.jumps[0]);
  CHECK(slopes([](double x) { return x < 0.0 ? -1.0 : 1.0; }).jumps[0]);
  const Slopes steps = slopes([](double x) { return 1e-5 * std::floor(x / 1e-5 + 0.5); });
  CHECK(steps.value[0] == 0.0);
  CHECK(steps.farther[0] == Approx(1.0).epsilon(1e-3));
  const Slopes line = slopes([](double x) { return 3.0 * x; });
  CHECK(line.value[0] == 3.0);
  CHECK(line.error[0] < 1e-14);
}

}  // namespace stepwire::linear
