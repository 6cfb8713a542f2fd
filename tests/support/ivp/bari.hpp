#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/support/ivp/problem.hpp"

// Problems of the Test Set for Initial Value Problem Solvers (Mazzia and Magherini, Bari, release 2.4) with
// the end values that its source files publish (subroutine solut).
namespace stepwire::ivp {

inline Problem hires() {
  return {"HIRES",
          true,
          1e-4,
          {1, 0, 0, 0, 0, 0, 0, 0.0057},
          321.8122,
          [](auto, const auto* y, auto* f) {
            f[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
            f[1] = 1.71 * y[0] - 8.75 * y[1];
            f[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
            f[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
            f[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
            f[5] = -280.0 * y[5] * y[7] + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
            f[6] = 280.0 * y[5] * y[7] - 1.81 * y[6];
            f[7] = -f[6];
          },
          {0.7371312573325668e-3, 0.1442485726316185e-3, 0.5888729740967575e-4, 0.1175651343283149e-2,
           0.2386356198831331e-2, 0.6238968252742796e-2, 0.2849998395185769e-2, 0.2850001604814231e-2}};
}

inline Problem robertson() {
  return {"ROBER",
          true,
          1e-10,
          {1, 0, 0},
          1e11,
          [](auto, const auto* y, auto* f) {
            f[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
            f[2] = 3e7 * y[1] * y[1];
            f[1] = -f[0] - f[2];
          },
          {0.2083340149701255e-7, 0.8333360770334713e-13, 0.9999999791665050}};
}

inline Problem oregonator() {
  return {"OREGO",
          true,
          1e-3,
          {1, 2, 3},
          360.0,
          [](auto, const auto* y, auto* f) {
            f[0] = 77.27 * (y[1] + y[0] * (1.0 - 8.375e-6 * y[0] - y[1]));
            f[1] = (y[2] - (1.0 + y[0]) * y[1]) / 77.27;
            f[2] = 0.161 * (y[0] - y[2]);
          },
          {0.1000814870318523e1, 0.1228178521549917e4, 0.1320554942846706e3}};
}

inline Problem van_der_pol() {
  return {"VDPOL",
          true,
          1e-3,
          {2, 0},
          2.0,
          [](auto, const auto* y, auto* f) {
            f[0] = y[1];
            f[1] = ((1.0 - y[0] * y[0]) * y[1] - y[0]) / 1e-6;
          },
          {0.1706167732170483e1, -0.8928097010247975}};
}

/// Pyrolysis with rates from 1e-10 to 1e9 (Enright, Hull and Lindberg 1975, E5). Two states fall from 1e-10
/// to 1e-22 while their difference matters: the rounding of doubles leaves 1e-26 and so no more than four
/// digits of them.
inline Problem e5() {
  return {"E5",
          true,
          1e-18,
          {1.76e-3, 0, 0, 0},
          1e13,
          [](auto, const auto* y, auto* f) {
            const auto decay = 7.89e-10 * y[0], makes = 1.1e7 * y[0] * y[2], meets = 1.13e9 * y[1] * y[2];
            f[0] = -decay - makes;
            f[1] = decay - meets;
            f[3] = makes - 1.13e3 * y[3];
            f[2] = f[1] - f[3];
          },
          {0.1152903278711829e-290, 0.8867655517642120e-22, 0.8854814626268838e-22, 0.0}};
}

/// Air pollution, 20 species in 25 reactions (Verwer 1994).
inline Problem pollution() {
  return {"POLLU",
          true,
          1e-6,
          {0, 0.2, 0, 0.04, 0, 0, 0.1, 0.3, 0.01, 0, 0, 0, 0, 0, 0, 0, 0.007, 0, 0, 0},
          60.0,
          [](auto, const auto* y, auto* f) {
            const auto r1 = .35 * y[0], r2 = 26.6 * y[1] * y[3], r3 = 12300. * y[4] * y[1],
                       r4 = .86e-3 * y[6], r5 = .82e-3 * y[6], r6 = 15e3 * y[6] * y[5], r7 = .13e-3 * y[8],
                       r8 = 24e3 * y[8] * y[5], r9 = 16500. * y[10] * y[1], r10 = 9e3 * y[10] * y[0],
                       r11 = .022 * y[12], r12 = 12e3 * y[9] * y[1], r13 = 1.88 * y[13],
                       r14 = 16300. * y[0] * y[5], r15 = 48e5 * y[2], r16 = .35e-3 * y[3], r17 = .0175 * y[3],
                       r18 = 1e8 * y[15], r19 = .444e12 * y[15], r20 = 1240. * y[16] * y[5],
                       r21 = 2.1 * y[18], r22 = 5.78 * y[18], r23 = .0474 * y[0] * y[3],
                       r24 = 1780. * y[18] * y[0], r25 = 3.12 * y[19];
            f[0] = -r1 - r10 - r14 - r23 - r24 + r2 + r3 + r9 + r11 + r12 + r22 + r25;
            f[1] = -r2 - r3 - r9 - r12 + r1 + r21;
            f[2] = -r15 + r1 + r17 + r19 + r22;
            f[3] = -r2 - r16 - r17 - r23 + r15;
            f[4] = -r3 + r4 + r4 + r6 + r7 + r13 + r20;
            f[5] = -r6 - r8 - r14 - r20 + r3 + r18 + r18;
            f[6] = -r4 - r5 - r6 + r13;
            f[7] = r4 + r5 + r6 + r7;
            f[8] = -r7 - r8;
            f[9] = -r12 + r7 + r9;
            f[10] = -r9 - r10 + r8 + r11;
            f[11] = r9;
            f[12] = -r11 + r10;
            f[13] = -r13 + r12;
            f[14] = r14;
            f[15] = -r18 - r19 + r16;
            f[16] = -r20;
            f[17] = r20;
            f[18] = -r21 - r22 - r24 + r23 + r25;
            f[19] = -r25 + r24;
          },
          {0.5646255480022769e-1, 0.1342484130422339,    0.4139734331099427e-8, 0.5523140207484359e-2,
           0.2018977262302196e-6, 0.1464541863493966e-6, 0.7784249118997964e-1, 0.3245075353396018,
           0.7494013383880406e-2, 0.1622293157301561e-7, 0.1135863833257075e-7, 0.2230505975721359e-2,
           0.2087162882798630e-3, 0.1396921016840158e-4, 0.8964884856898295e-2, 0.4352846369330103e-17,
           0.6899219696263405e-2, 0.1007803037365946e-3, 0.1772146513969984e-5, 0.5682943292316392e-4}};
}

/// Seven stars of masses 1 to 7 in a plane: positions x, y, velocities x, y (Hairer, Norsett and Wanner I).
inline Problem pleiades() {
  return {"PLEI",
          false,
          1.0,
          {3, 3, -1, -3, 2, -2, 2, 3, -3, 2, 0, 0, -4, 4, 0, 0, 0, 0, 0, 1.75, -1.5, 0, 0, 0, -1.25, 1, 0, 0},
          3.0,
          [](auto, const auto* y, auto* f) {
            using std::sqrt;
            for (int i = 0; i < 14; ++i) {
              f[i] = y[14 + i];
              f[14 + i] = 0.0;
            }
            for (int i = 0; i < 7; ++i)
              for (int j = 0; j < i; ++j) {
                const auto dx = y[j] - y[i], dy = y[7 + j] - y[7 + i], r2 = dx * dx + dy * dy,
                           inverse = 1.0 / (r2 * sqrt(r2));
                f[14 + i] += (j + 1) * inverse * dx;
                f[21 + i] += (j + 1) * inverse * dy;
                f[14 + j] -= (i + 1) * inverse * dx;
                f[21 + j] -= (i + 1) * inverse * dy;
              }
          },
          {0.3706139143970502,    0.3237284092057233e1,  -0.3222559032418324e1, 0.6597091455775310,
           0.3425581707156584,    0.1562172101400631e1,  -0.7003092922212495,   -0.3943437585517392e1,
           -0.3271380973972550e1, 0.5225081843456543e1,  -0.2590612434977470e1, 0.1198213693392275e1,
           -0.2429682344935824,   0.1091449240428980e1,  0.3417003806314313e1,  0.1354584501625501e1,
           -0.2590065597810775e1, 0.2025053734714242e1,  -0.1155815100160448e1, -0.8072988170223021,
           0.5952396354208710,    -0.3741244961234010e1, 0.3773459685750630,    0.9386858869551073,
           0.3667922227200571,    -0.3474046353808490,   0.2344915448180937e1,  -0.1947020434263292e1}};
}

/// An electrical circuit of 15 voltages and currents with four diodes (Horneber 1976), at the capacity of 2
/// pF.
inline Problem ring_modulator() {
  return {"RINGMOD",
          true,
          1e-3,
          std::vector<double>(15, 0.0),
          1e-3,
          [](auto t, const auto* y, auto* f) {
            using std::exp;
            using std::sin;
            using Number = std::decay_t<decltype(t)>;
            const Number pi = 3.14159265358979323846264338L;
            const Number in1 = 0.5 * sin(2e3 * pi * t), in2 = 2.0 * sin(2e4 * pi * t);
            const auto diode = [](Number u) { return Number(40.67286402e-9 * (exp(17.7493332 * u) - 1.0)); };
            const Number q1 = diode(y[2] - y[4] - y[6] - in2), q2 = diode(-y[3] + y[5] - y[6] - in2),
                         q3 = diode(y[3] + y[4] + y[6] + in2), q4 = diode(-y[2] - y[5] + y[6] + in2);
            f[0] = (y[7] - 0.5 * y[9] + 0.5 * y[10] + y[13] - y[0] / 25e3) / 1.6e-8;
            f[1] = (y[8] - 0.5 * y[11] + 0.5 * y[12] + y[14] - y[1] / 25e3) / 1.6e-8;
            f[2] = (y[9] - q1 + q4) / 2e-12;
            f[3] = (-y[10] + q2 - q3) / 2e-12;
            f[4] = (y[11] + q1 - q3) / 2e-12;
            f[5] = (-y[12] - q2 + q4) / 2e-12;
            f[6] = (-y[6] / 50.0 + q1 + q2 - q3 - q4) / 1e-8;
            f[7] = -y[0] / 4.45;
            f[8] = -y[1] / 4.45;
            f[9] = (0.5 * y[0] - y[2] - 17.3 * y[9]) / 5e-4;
            f[10] = (-0.5 * y[0] + y[3] - 17.3 * y[10]) / 5e-4;
            f[11] = (0.5 * y[1] - y[4] - 17.3 * y[11]) / 5e-4;
            f[12] = (-0.5 * y[1] + y[5] - 17.3 * y[12]) / 5e-4;
            f[13] = (-y[0] + in1 - 86.3 * y[13]) / 2e-3;
            f[14] = (-y[1] - 636.3 * y[14]) / 2e-3;
          },
          {-0.2339057358486745e-1, -0.7367485485540825e-2, 0.2582956709291169, -0.4064465721283450,
           -0.4039455665149794, 0.2607966765422943, 0.1106761861269975, 0.2939904342435596e-6,
           -0.2840029933642329e-7, 0.7267198267264553e-3, 0.7929487196960840e-3, -0.7255283495698965e-3,
           -0.7941401968526521e-3, 0.7088495416976114e-4, 0.2390059075236570e-4}};
}

inline std::vector<Problem> bari() {
  return {hires(), robertson(), oregonator(), van_der_pol(), e5(), pollution(), ring_modulator(), pleiades()};
}

}  // namespace stepwire::ivp
