#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/support/ivp/problem.hpp"

// Problems of DETEST (Hull, Enright, Fellen and Sedgwick 1972, SIAM J. Numer. Anal. 9(4)): classes A to E,
// each from 0 to 20. `right` is empty: references of more digits are computed.
namespace stepwire::ivp {

namespace detest {

template <class Function>
Problem make(const std::string& name, std::vector<double> start, Function function) {
  return {"DETEST " + name, false, 1.0, std::move(start), 20.0, function, {}};
}

/// Single equations: decay, a special Riccati equation, an oscillation, the logistic curve, a spiral.
inline std::vector<Problem> a() {
  using std::cos;
  return {make("A1", {1}, [](auto, const auto* y, auto* f) { f[0] = -y[0]; }),
          make("A2", {1}, [](auto, const auto* y, auto* f) { f[0] = -0.5 * y[0] * y[0] * y[0]; }),
          make("A3", {1}, [](auto t, const auto* y, auto* f) { f[0] = y[0] * cos(t); }),
          make("A4", {1}, [](auto, const auto* y, auto* f) { f[0] = 0.25 * y[0] * (1.0 - y[0] / 20.0); }),
          make("A5", {4}, [](auto t, const auto* y, auto* f) { f[0] = (y[0] - t) / (y[0] + t); })};
}

/// Small systems: two populations, two chemical reactions, a torus, a rigid body.
inline std::vector<Problem> b() {
  return {make("B1", {1, 3},
               [](auto, const auto* y, auto* f) {
                 f[0] = 2.0 * (y[0] - y[0] * y[1]);
                 f[1] = -(y[1] - y[0] * y[1]);
               }),
          make("B2", {2, 0, 1},
               [](auto, const auto* y, auto* f) {
                 f[0] = -y[0] + y[1];
                 f[1] = y[0] - 2.0 * y[1] + y[2];
                 f[2] = y[1] - y[2];
               }),
          make("B3", {1, 0, 0},
               [](auto, const auto* y, auto* f) {
                 f[0] = -y[0];
                 f[1] = y[0] - y[1] * y[1];
                 f[2] = y[1] * y[1];
               }),
          make("B4", {3, 0, 0},
               [](auto, const auto* y, auto* f) {
                 using std::sqrt;
                 const auto r = sqrt(y[0] * y[0] + y[1] * y[1]);
                 f[0] = -y[1] - y[0] * y[2] / r;
                 f[1] = y[0] - y[1] * y[2] / r;
                 f[2] = y[0] / r;
               }),
          make("B5", {0, 1, 1}, [](auto, const auto* y, auto* f) {
            f[0] = y[1] * y[2];
            f[1] = -y[0] * y[2];
            f[2] = -0.51 * y[0] * y[1];
          })};
}

inline std::vector<double> first_of(std::size_t count) {
  std::vector<double> start(count, 0.0);
  start[0] = 1.0;
  return start;
}

/// A heat equation of `count` points with cold ends.
inline Problem heat(const std::string& name, int count) {
  return make(name, first_of(static_cast<std::size_t>(count)), [count](auto, const auto* y, auto* f) {
    for (int i = 0; i < count; ++i)
      f[i] = (i > 0 ? y[i - 1] : 0.0) - 2.0 * y[i] + (i + 1 < count ? y[i + 1] : 0.0);
  });
}

/// The sun's five outer planets: positions, then velocities, in astronomical units and 100 days.
inline Problem planets() {
  return make("C5", {3.42947415189,   3.35386959711,   1.35494901715,   6.64145542550,   5.97156957878,
                     2.18231499728,   11.2630437207,   14.6952576794,   6.27960525067,   -30.1552268759,
                     1.65699966404,   1.43785752721,   -21.1238353380,  28.4465098142,   15.3882659679,
                     -0.557160570446, 0.505696783289,  0.230578543901,  -0.415570776342, 0.365682722812,
                     0.169143213293,  -0.325325669158, 0.189706021964,  0.087726532278,  -0.024047625417,
                     -0.287659532608, -0.117219543175, -0.176860753121, -0.216393453025, -0.014864789309},
              [](auto t, const auto* y, auto* f) {
                using std::sqrt;
                using Number = std::decay_t<decltype(t)>;
                constexpr double sun = 1.00000597682, attraction = 2.95912208286;
                constexpr double mass[] = {0.000954786104043, 0.000285583733151, 0.0000437273164546,
                                           0.0000517759138449, 0.00000277777777778};
                const auto cube = [](Number a, Number b, Number c) {
                  const Number square = a * a + b * b + c * c;
                  return square * sqrt(square);
                };
                Number from_sun[5];
                for (int j = 0; j < 5; ++j) from_sun[j] = cube(y[3 * j], y[3 * j + 1], y[3 * j + 2]);
                for (int j = 0; j < 5; ++j) {
                  const Number* at = y + 3 * j;
                  Number pull[3];
                  for (int i = 0; i < 3; ++i) pull[i] = -(sun + mass[j]) * at[i] / from_sun[j];
                  for (int k = 0; k < 5; ++k) {
                    if (k == j) continue;
                    const Number* other = y + 3 * k;
                    const Number between = cube(other[0] - at[0], other[1] - at[1], other[2] - at[2]);
                    for (int i = 0; i < 3; ++i)
                      pull[i] += mass[k] * ((other[i] - at[i]) / between - other[i] / from_sun[k]);
                  }
                  for (int i = 0; i < 3; ++i) {
                    f[3 * j + i] = y[15 + 3 * j + i];
                    f[15 + 3 * j + i] = attraction * pull[i];
                  }
                }
              });
}

/// Larger systems: two chains of decays, two heat equations, five planets.
inline std::vector<Problem> c() {
  return {make("C1", first_of(10),
               [](auto, const auto* y, auto* f) {
                 f[0] = -y[0];
                 for (int i = 1; i < 9; ++i) f[i] = y[i - 1] - y[i];
                 f[9] = y[8];
               }),
          make("C2", first_of(10),
               [](auto, const auto* y, auto* f) {
                 f[0] = -y[0];
                 for (int i = 1; i < 9; ++i) f[i] = i * y[i - 1] - (i + 1) * y[i];
                 f[9] = 9.0 * y[8];
               }),
          heat("C3", 10), heat("C4", 51), planets()};
}

/// Two bodies on an ellipse of a given eccentricity.
inline Problem orbit(const std::string& name, double eccentricity) {
  return make(name, {1.0 - eccentricity, 0.0, 0.0, std::sqrt((1.0 + eccentricity) / (1.0 - eccentricity))},
              [](auto, const auto* y, auto* f) {
                using std::sqrt;
                const auto r2 = y[0] * y[0] + y[1] * y[1], r3 = r2 * sqrt(r2);
                f[0] = y[2];
                f[1] = y[3];
                f[2] = -y[0] / r3;
                f[3] = -y[1] / r3;
              });
}

inline std::vector<Problem> d() {
  return {orbit("D1", 0.1), orbit("D2", 0.3), orbit("D3", 0.5), orbit("D4", 0.7), orbit("D5", 0.9)};
}

/// Equations of second order: Bessel, Van der Pol, Duffing, a falling body, a pursuit.
inline std::vector<Problem> e() {
  return {make("E1", {0.6713967071418030, 0.09540051444747446},
               [](auto t, const auto* y, auto* f) {
                 f[0] = y[1];
                 f[1] = -(y[1] / (t + 1.0) + (1.0 - 0.25 / ((t + 1.0) * (t + 1.0))) * y[0]);
               }),
          make("E2", {2, 0},
               [](auto, const auto* y, auto* f) {
                 f[0] = y[1];
                 f[1] = (1.0 - y[0] * y[0]) * y[1] - y[0];
               }),
          make("E3", {0, 0},
               [](auto t, const auto* y, auto* f) {
                 using std::sin;
                 f[0] = y[1];
                 f[1] = y[0] * y[0] * y[0] / 6.0 - y[0] + 2.0 * sin(2.78535 * t);
               }),
          make("E4", {30, 0},
               [](auto, const auto* y, auto* f) {
                 f[0] = y[1];
                 f[1] = 0.032 - 0.4 * y[1] * y[1];
               }),
          make("E5", {0, 0}, [](auto t, const auto* y, auto* f) {
            using std::sqrt;
            f[0] = y[1];
            f[1] = sqrt(1.0 + y[1] * y[1]) / (25.0 - t);
          })};
}

}  // namespace detest

inline std::vector<Problem> all_detest() {
  std::vector<Problem> all;
  for (const auto& part : {detest::a(), detest::b(), detest::c(), detest::d(), detest::e()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace stepwire::ivp
