#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/support/ivp/problem.hpp"

// Problems of stiff DETEST (Enright, Hull and Lindberg 1975, BIT 15(1); Enright and Pryce 1987, ACM TOMS
// 13(1)). `right` is empty: references of more digits are computed. D6, F1 and F5 are left out: their rates
// are too large for an explicit reference.
namespace stepwire::ivp {

namespace stiff_detest {

template <class Function>
Problem make(const std::string& name, std::vector<double> start, double end, Function function,
             double absolute = 1.0) {
  return {"stiff " + name, true, absolute, std::move(start), end, function, {}};
}

/// Linear, with real rates.
inline std::vector<Problem> a() {
  return {make("A1", {1, 1, 1, 1}, 20.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = -0.5 * y[0];
                 f[1] = -y[1];
                 f[2] = -100.0 * y[2];
                 f[3] = -90.0 * y[3];
               }),
          make("A2", std::vector<double>(9, 0.0), 120.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = -1800.0 * y[0] + 900.0 * y[1];
                 for (int i = 1; i < 8; ++i) f[i] = y[i - 1] - 2.0 * y[i] + y[i + 1];
                 f[8] = 1000.0 * y[7] - 2000.0 * y[8] + 1000.0;
               }),
          make("A3", {1, 1, 1, 1}, 20.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = -1e4 * y[0] + 100.0 * y[1] - 10.0 * y[2] + y[3];
                 f[1] = -1e3 * y[1] + 10.0 * y[2] - 10.0 * y[3];
                 f[2] = -y[2] + 10.0 * y[3];
                 f[3] = -0.1 * y[3];
               }),
          make("A4", std::vector<double>(10, 1.0), 1.0, [](auto, const auto* y, auto* f) {
            for (int i = 0; i < 10; ++i) f[i] = -std::pow(i + 1.0, 5) * y[i];
          })};
}

inline Problem spiral(const std::string& name, double turns) {
  return make(name, std::vector<double>(6, 1.0), 20.0, [turns](auto, const auto* y, auto* f) {
    f[0] = -10.0 * y[0] + turns * y[1];
    f[1] = -turns * y[0] - 10.0 * y[1];
    f[2] = -4.0 * y[2];
    f[3] = -y[3];
    f[4] = -0.5 * y[4];
    f[5] = -0.1 * y[5];
  });
}

/// Linear, with complex rates.
inline std::vector<Problem> b() {
  return {make("B1", {1, 0, 1, 0}, 20.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = -y[0] + y[1];
                 f[1] = -100.0 * y[0] - y[1];
                 f[2] = -100.0 * y[2] + y[3];
                 f[3] = -10000.0 * y[2] - 100.0 * y[3];
               }),
          spiral("B2", 3.0), spiral("B3", 8.0), spiral("B4", 25.0), spiral("B5", 100.0)};
}

inline Problem coupled(const std::string& name, double by) {
  return make(name, {1, 1, 1, 1}, 20.0, [by](auto, const auto* y, auto* f) {
    f[0] = -y[0] + 2.0;
    f[1] = -10.0 * y[1] + by * y[0] * y[0];
    f[2] = -40.0 * y[2] + 4.0 * by * (y[0] * y[0] + y[1] * y[1]);
    f[3] = -100.0 * y[3] + 10.0 * by * (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]);
  });
}

/// Coupled by squares.
inline std::vector<Problem> c() {
  return {make("C1", {1, 1, 1, 1}, 20.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = -y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3];
                 f[1] = -10.0 * y[1] + 10.0 * (y[2] * y[2] + y[3] * y[3]);
                 f[2] = -40.0 * y[2] + 40.0 * y[3] * y[3];
                 f[3] = -100.0 * y[3] + 2.0;
               }),
          coupled("C2", 0.1), coupled("C3", 1.0), coupled("C4", 10.0), coupled("C5", 20.0)};
}

/// Not linear, with real rates.
inline std::vector<Problem> d() {
  return {make("D1", {0, 0, 0}, 400.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = 0.2 * (y[1] - y[0]);
                 f[1] = 10.0 * y[0] - (60.0 - 0.125 * y[2]) * y[1] + 0.125 * y[2];
                 f[2] = 1.0;
               }),
          make("D2", {1, 0, 0}, 40.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = -0.04 * y[0] + 0.01 * y[1] * y[2];
                 f[1] = 400.0 * y[0] - 100.0 * y[1] * y[2] - 3000.0 * y[1] * y[1];
                 f[2] = 30.0 * y[1] * y[1];
               }),
          make("D3", {1, 1, 0, 0}, 20.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = y[2] - 100.0 * y[0] * y[1];
                 f[1] = y[2] + 2.0 * y[3] - 100.0 * y[0] * y[1] - 2e4 * y[1] * y[1];
                 f[2] = -y[2] + 100.0 * y[0] * y[1];
                 f[3] = -y[3] + 1e4 * y[1] * y[1];
               }),
          make(
              "D4", {1, 1, 0}, 50.0,
              [](auto, const auto* y, auto* f) {
                f[0] = -0.013 * y[0] - 1000.0 * y[0] * y[2];
                f[1] = -2500.0 * y[1] * y[2];
                f[2] = f[0] + f[1];
              },
              1e-3),
          make("D5", {0, 0}, 100.0, [](auto, const auto* y, auto* f) {
            const auto sum = 0.01 + y[0] + y[1];
            f[0] = 0.01 - (1.0 + (y[0] + 1000.0) * (y[0] + 1.0)) * sum;
            f[1] = 0.01 - (1.0 + y[1] * y[1]) * sum;
          })};
}

/// Not linear, with complex rates.
inline std::vector<Problem> e() {
  return {make("E2", {2, 0}, 1.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = y[1];
                 f[1] = 5.0 * (1.0 - y[0] * y[0]) * y[1] - y[0];
               }),
          make("E3", {1, 1, 0}, 500.0, [](auto, const auto* y, auto* f) {
            f[0] = -(55.0 + y[2]) * y[0] + 65.0 * y[1];
            f[1] = 0.0785 * (y[0] - y[1]);
            f[2] = 0.1 * y[0];
          })};
}

/// Of chemistry.
inline std::vector<Problem> f() {
  return {make("F2", {1, 0}, 240.0,
               [](auto, const auto* y, auto* f) {
                 f[0] = -y[0] - y[0] * y[1] + 294.0 * y[1];
                 f[1] = y[0] * (1.0 - y[1]) / 98.0 - 3.0 * y[1];
               }),
          make(
              "F3", {4e-6, 1e-6, 0, 0, 0}, 100.0,
              [](auto, const auto* y, auto* f) {
                const auto first = 1e7 * y[1] * y[0], second = 1e7 * y[1] * y[4];
                f[0] = -first + 10.0 * y[2];
                f[1] = -first - second + 10.0 * y[2] + 10.0 * y[3];
                f[2] = first - 1.001e4 * y[2] + 1e-3 * y[3];
                f[3] = 1e4 * y[2] - 10.001 * y[3] + second;
                f[4] = 10.0 * y[3] - second;
              },
              1e-6),
          make("F4", {4, 1.1, 4}, 300.0, [](auto, const auto* y, auto* f) {
            f[0] = 77.27 * (y[1] - y[0] * y[1] + y[0] - 8.375e-6 * y[0] * y[0]);
            f[1] = (-y[1] - y[0] * y[1] + y[2]) / 77.27;
            f[2] = 0.161 * (y[0] - y[2]);
          })};
}

}  // namespace stiff_detest

inline std::vector<Problem> all_stiff_detest() {
  using namespace stiff_detest;
  std::vector<Problem> all;
  for (const auto& part : {a(), b(), c(), d(), e(), f()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace stepwire::ivp
