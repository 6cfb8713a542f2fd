// Reference numbers: the textbook's recursions in numpy, e.g.
//   S = C P C' + R; K = P C' inv(S); e = x + K (y - C x); P = A (P - K S K') A' + Q; x = A e + B u
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A Kalman filter of one measurement gives the estimates of the textbook's recursion") {
  const table::Table table = run_text(R"(
step: 0.1 s
stop: 3 s
solver: euler
blocks:
  one: {block: Constant, value: 1}
  y: {block: Sine, frequency: 0.47746482927568606 Hz}
  kf: {block: KalmanFilter, measured: y, u: one, A: [[1, 0.1], [0, 0.9]], B: [[0.005], [0.1]], C: [[1, 0]],
       Q: [[0.01, 0], [0, 0.04]], R: [[0.25]], P0: [[1, 0], [0, 2]], initial: [0.5, -1], every: 0.1 s}
record: [kf.estimate, kf.innovation]
)");
  const double reference[][4] = {{0, 0.09999999999999998, -1.0, -0.5},
                                 {1, 0.14420759902522523, -0.6910549225019976, 0.29052020666133965},
                                 {5, 0.7999281752277215, 0.6982843890161097, 0.3030630972494751},
                                 {29, 0.9589265050911009, 0.9634676734152466, -0.3899824558687718}};
  for (const auto& row : reference) {
    const auto k = static_cast<std::size_t>(row[0]);
    CHECK(column(table, "kf.estimate.1")[k] == Approx(row[1]).epsilon(1e-12));
    CHECK(column(table, "kf.estimate.2")[k] == Approx(row[2]).epsilon(1e-12));
    CHECK(column(table, "kf.innovation")[k] == Approx(row[3]).epsilon(1e-12));
  }
}

TEST_CASE("A Kalman filter of two measurements whose noises belong together") {
  const table::Table table = run_text(R"(
step: 0.1 s
stop: 2 s
solver: euler
blocks:
  y1: {block: Sine, frequency: 0.47746482927568606 Hz}
  y2: {block: Sine, frequency: 0.3183098861837907 Hz, phase: 1.5707963267948966}
  y: {block: Mux, u: [y1, y2]}
  kf: {block: KalmanFilter, measured: y, A: [[0.9, 0.2, 0], [-0.1, 0.8, 0.3], [0.05, 0, 0.7]],
       C: [[1, 0, 0.5], [0, 1, -1]], Q: [[0.1, 0.02, 0], [0.02, 0.2, 0.01], [0, 0.01, 0.05]],
       R: [[0.3, 0.1], [0.1, 0.2]], every: 0.1 s}
record: [kf.estimate]
)");
  CHECK(column(table, "kf.estimate.1")[19] == Approx(-0.7807112976258285).epsilon(1e-12));
  CHECK(column(table, "kf.estimate.2")[19] == Approx(-0.7213723721553941).epsilon(1e-12));
  CHECK(column(table, "kf.estimate.3")[19] == Approx(0.00600808797044006).epsilon(1e-11));
}

TEST_CASE("A Kalman filter that is reset repeats its estimates, its covariance included") {
  const table::Table table = run_text(R"(
step: 0.1 s
stop: 2 s
solver: euler
blocks:
  r: {block: Step, time: 1}
  kf: {block: KalmanFilter, measured: 3, A: [[1]], C: [[1]], Q: [[0.1]], R: [[1]], P0: [[5]], initial: 1, reset: r}
record: [kf.estimate, kf.P]
)");
  for (std::size_t k = 0; k < 10; ++k)
    CHECK(column(table, "kf.estimate")[k + 10] == column(table, "kf.estimate")[k]);
  CHECK(column(table, "kf.estimate")[1] != column(table, "kf.estimate")[0]);
}

TEST_CASE("A Kalman filter whose covariances are none ends the run and says so") {
  CHECK(error_of(R"(
step: 0.1 s
stop: 2 s
solver: euler
blocks:
  kf: {block: KalmanFilter, measured: 3, A: [[1]], C: [[1]], Q: [[-1]], R: [[0.5]]}
record: [kf.estimate]
)")
            .find("positive definite") != std::string::npos);
}

TEST_CASE("A Kalman filter whose first covariance is none ends the run at its first tick") {
  // The innovation has the variance P0 + R = -0.5; the gain of the first tick does not exist.
  CHECK(error_of(R"(
step: 0.1 s
stop: 2 s
solver: euler
blocks:
  kf: {block: KalmanFilter, measured: 3, A: [[1]], C: [[1]], Q: [[2]], R: [[0.5]], P0: [[-1]]}
record: [kf.estimate]
)")
            .find("(at 0 s)") != std::string::npos);
}

TEST_CASE("A discrete state space is its recursion") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 1 s
solver: euler
blocks:
  u: {block: Step, time: 50 ms, after: [2, -1]}
  s: {block: DiscreteStateSpace, u: u, A: [[0.9, 0.1], [-0.2, 0.8]], B: [[1, 0], [0.5, 1]], C: [[1, 1]],
      D: [[0, 0.25]], initial: [1, 0]}
record: [s]
)");
  double x1 = 1.0, x2 = 0.0;
  for (std::size_t k = 0; k <= 100; ++k) {
    const double u1 = k >= 5 ? 2.0 : 0.0, u2 = k >= 5 ? -1.0 : 0.0;
    CHECK(column(table, "s")[k] == Approx(x1 + x2 + 0.25 * u2).epsilon(1e-12));
    const double next = 0.9 * x1 + 0.1 * x2 + u1;
    x2 = -0.2 * x1 + 0.8 * x2 + 0.5 * u1 + u2;
    x1 = next;
  }
}

TEST_CASE("Observers with the plant's own matrices forget where they began") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 4 s
solver: rk4
blocks:
  force: {block: Sine, frequency: 0.5 Hz}
  plant: {block: StateSpace, u: force, A: [[0, 1], [-4, -0.4]], B: [[0], [1]], C: [[1, 0]], initial: [1, 0]}
  seen: {block: LuenbergerObserver, measured: plant, u: force, A: [[0, 1], [-4, -0.4]], B: [[0], [1]],
         C: [[1, 0]], L: [[9.6], [12.16]]}
record: [seen, plant.x]
)");
  // A - L C has the characteristic polynomial s^2 + 10 s + 20: errors fall at least as exp(-2.76 t).
  CHECK(std::abs(column(table, "seen.2").back() - column(table, "plant.x.2").back()) < 1e-4);
  CHECK(std::abs(column(table, "seen.1")[0] - column(table, "plant.x.1")[0]) == 1.0);
}

TEST_CASE("A discrete observer with poles at zero knows the states after as many ticks") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 100 ms
solver: euler
blocks:
  u: {block: Constant, value: 0.3}
  plant: {block: DiscreteStateSpace, u: u, A: [[1, 1], [0, 1]], B: [[0.5], [1]], C: [[1, 0]], initial: [5, -2]}
  seen: {block: DiscreteLuenbergerObserver, measured: plant, u: u, A: [[1, 1], [0, 1]], B: [[0.5], [1]],
         C: [[1, 0]], L: [[2], [1]]}
record: [seen, plant.x]
)");
  CHECK(column(table, "seen.1")[1] != Approx(column(table, "plant.x.1")[1]));
  for (std::size_t k = 2; k <= 10; ++k) {
    CHECK(column(table, "seen.1")[k] == Approx(column(table, "plant.x.1")[k]).margin(1e-13));
    CHECK(column(table, "seen.2")[k] == Approx(column(table, "plant.x.2")[k]).margin(1e-13));
  }
}

TEST_CASE("SampleAndHold shows a sample at once and keeps it") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 1 s
solver: euler
blocks:
  ramp: {block: Ramp, slope: 1 m/s}
  when: {block: Pulse, period: 0.4 s, width: 0.25, delay: 0.2 s}
  edge: {block: SampleAndHold, u: ramp, when: when, initial: -1 m}
  level: {block: SampleAndHold, u: ramp, when: when, trigger: level}
record: [edge, level]
)");
  CHECK(column(table, "edge")[19] == -1.0);
  CHECK(column(table, "edge")[20] == Approx(0.2));
  CHECK(column(table, "edge")[59] == Approx(0.2));
  CHECK(column(table, "edge")[60] == Approx(0.6));
  CHECK(column(table, "level")[25] == Approx(0.25));
  CHECK(column(table, "level")[45] == Approx(0.29));
  CHECK(table.find("edge")->unit == "m");
}
