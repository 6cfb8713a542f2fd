#include "blocks/plants/bouc_wen_law.hpp"

#include <catch2/catch.hpp>

using stepwire::BoucWenLaw;

namespace {

const BoucWenLaw printed{36.2095, 10.6140, -7.0773, 1.0};  // thesis eq. 4, in mm

/// z and loss by many small Runge-Kutta steps of the differential equation itself, with v going from v0 to
/// v1.
BoucWenLaw::Travelled integrate(const BoucWenLaw& law, double z, double v0, double v1, double duration) {
  constexpr int steps = 200000;
  const double h = duration / steps;
  double lost = 0.0;
  for (int k = 0; k < steps; ++k) {
    const auto v = [&](double part) { return v0 + (v1 - v0) * (k + part) / steps; };
    const double a = law.rate(v(0.0), z), b = law.rate(v(0.5), z + 0.5 * h * a);
    const double c = law.rate(v(0.5), z + 0.5 * h * b), d = law.rate(v(1.0), z + h * c);
    const double end = z + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    lost += h / 6.0 * (law.lost(v(0.0), z) + 4.0 * law.lost(v(0.5), 0.5 * (z + end)) + law.lost(v(1.0), end));
    z = end;
  }
  return {z, lost};
}

}  // namespace

TEST_CASE("The rate of a Bouc-Wen law is its equation") {
  const BoucWenLaw law{3.0, 0.5, -0.25, 2.0};
  CHECK(law.rate(2.0, -1.5) == Approx(3.0 * 2.0 - 0.5 * 2.0 * 1.5 * -1.5 + 0.25 * 2.0 * 2.25));
  CHECK(law.rate(-2.0, 0.0) == -6.0);
}

TEST_CASE("A long travel brings z to the limit of the law") {
  CHECK(printed.travel(0.0, 100.0).z == Approx(10.238).epsilon(1e-4));  // value of the thesis' numbers in mm
  CHECK(printed.travel(3.0, -100.0).z == Approx(-printed.limit()));
  CHECK(BoucWenLaw{2.0, 0.3, 0.2, 2.0}.limit() == Approx(2.0));
}

TEST_CASE("From rest the exact travel is the exponential of the closed form") {
  const double k = printed.beta + printed.gamma;
  CHECK(printed.travel(0.0, 0.2).z == Approx(printed.A / k * (1.0 - std::exp(-k * 0.2))).epsilon(1e-14));
}

TEST_CASE("The exact travel agrees with small steps of the differential equation") {
  const auto [z, v0, v1] = GENERATE(Catch::Generators::table<double, double, double>({{0.0, 10.0, 10.0},
                                                                                      {-8.0, 10.0, 40.0},
                                                                                      {9.0, -60.0, -5.0},
                                                                                      {-10.2, 100.0, 100.0},
                                                                                      {2.0, 30.0, -50.0},
                                                                                      {-5.0, 20.0, -1.0}}));
  const BoucWenLaw::Travelled fine = integrate(printed, z, v0, v1, 0.01);
  const BoucWenLaw::Travelled exact = printed.over(z, v0, v1, 0.01);
  CHECK(exact.z == Approx(fine.z).epsilon(1e-8));
  CHECK(exact.lost == Approx(fine.lost).epsilon(1e-7).margin(1e-9));
}

TEST_CASE("For n = 2 the travel from rest is a hyperbolic tangent, and from below zero a tangent") {
  const BoucWenLaw law{3.0, 0.5, 0.25, 2.0};
  const double up = std::sqrt(3.0 * 0.75), limit = std::sqrt(3.0 / 0.75);
  const double x = GENERATE(0.01, 0.3, 2.0, 50.0);
  CHECK(law.travel(0.0, x).z == Approx(limit * std::tanh(up * x)).epsilon(2e-6));
  CHECK(law.travel(0.0, -x).z == Approx(-limit * std::tanh(up * x)).epsilon(2e-6));
  const double down = std::sqrt(3.0 * 0.25), scale = std::sqrt(3.0 / 0.25);
  const double start = -1.5, phase = std::atan(start / scale);
  CHECK(law.travel(start, 0.2).z == Approx(scale * std::tan(phase + down * 0.2)).epsilon(2e-6));
}

TEST_CASE("For other n the travel agrees with small steps of the differential equation") {
  const double n = GENERATE(1.2, 1.5, 2.0, 4.0);
  const BoucWenLaw law{36.2095, 10.6140 / std::pow(5.0, n), -7.0773 / std::pow(5.0, n), n};
  const auto [z, v0, v1] = GENERATE(Catch::Generators::table<double, double, double>(
      {{0.0, 10.0, 10.0}, {-4.0, 10.0, 40.0}, {5.0, -60.0, -5.0}, {2.0, 30.0, -50.0}, {12.0, 20.0, 60.0}}));
  CAPTURE(n, z, v0, v1);
  const BoucWenLaw::Travelled fine = integrate(law, z, v0, v1, 0.01), way = law.over(z, v0, v1, 0.01);
  CHECK(way.z == Approx(fine.z).margin(3e-6 * law.limit()));
  CHECK(way.lost == Approx(fine.lost).epsilon(1e-4).margin(1e-5 * law.limit()));
}

TEST_CASE("The exact travel does not depend on where it is divided") {
  const double z = -9.0, dx = 1.3;
  const BoucWenLaw::Travelled whole = printed.travel(z, dx);
  BoucWenLaw::Travelled parts{z, 0.0};
  for (int k = 0; k < 1000; ++k) {
    const BoucWenLaw::Travelled part = printed.travel(parts.z, dx / 1000);
    parts = {part.z, parts.lost + part.lost};
  }
  CHECK(parts.z == Approx(whole.z).epsilon(1e-12));
  CHECK(parts.lost == Approx(whole.lost).epsilon(1e-11));
}

TEST_CASE("Loss and storage of a travel make up its work") {
  const double z = 4.0, dx = -2.5;
  const BoucWenLaw::Travelled way = printed.travel(z, dx);
  double work = 0.0;  // integral of z dx by Simpson's rule
  constexpr int parts = 2000;
  for (int k = 0; k <= parts; ++k)
    work += printed.travel(z, dx * k / parts).z *
            (k == 0 || k == parts ? 1
             : k % 2              ? 4
                                  : 2) *
            dx / parts / 3.0;
  CHECK(way.lost == Approx(printed.A * work - 0.5 * (way.z * way.z - z * z)).epsilon(1e-9));
}

TEST_CASE("Unloading without a rate constant goes in a straight line through zero") {
  const BoucWenLaw law{2.0, 1.0, 1.0, 1.0};  // beta = gamma
  CHECK(law.travel(-1.0, 0.25).z == Approx(-0.5));
  CHECK(law.travel(-1.0, 0.25).lost == Approx(0.0).margin(1e-15));
  CHECK(law.travel(-1.0, 0.5 + 0.1).z == Approx(1.0 - std::exp(-0.2)));
}
