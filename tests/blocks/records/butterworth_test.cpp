#include "blocks/records/butterworth.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace stepwire;

namespace {

using Rows = std::vector<double>;

Rows filtered(const Rows& rows, int order, double cutoff) {
  return forward_and_backward(butterworth(order, cutoff), order, rows);
}

/// u_n = (7 n mod 11) - 5
Rows jagged() {
  Rows rows;
  for (int n = 0; n < 24; ++n) rows.push_back((7 * n) % 11 - 5.0);
  return rows;
}

void check_near(const Rows& rows, const Rows& expected) {
  REQUIRE(rows.size() == expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK(rows[i] == Approx(expected[i]).margin(1e-12));
}

}  // namespace

// scipy 1.10.1: n = np.arange(24); signal.sosfiltfilt(signal.butter(ORDER, 2*CUTOFF, output='sos'),
// (7*n)%11-5.0)
TEST_CASE("a low-pass forward and backward gives the numbers of scipy") {
  check_near(
      filtered(jagged(), 4, 0.1),
      {-4.99244768338606,  -2.45437274198162,  -0.33248553901269,  1.07714166001251,   1.67038814771211,
       1.53917252226666,   0.917724520748295,  0.10205959041672,   -0.627615707414043, -1.06519274301875,
       -1.11307062586723,  -0.793256505698232, -0.234864550469814, 0.364393638836296,  0.79962983786928,
       0.926501965952879,  0.710587197045274,  0.24098105040328,   -0.294240759440065, -0.662587428593869,
       -0.658540641563443, -0.17357787884001,  0.757724119888757,  1.95734319909725});
  check_near(
      filtered(jagged(), 3, 0.2),
      {-5.00045659085906, -0.872147356188646, 1.62372033164385,   2.03556346032289,   1.23289306103872,
       0.467311257157469, 0.185958992139964,  0.0576018965927265, -0.171730278549046, -0.655632942559884,
       -1.41659101254142, -1.73526273322178,  -0.808511883899414, 0.829207485601824,  1.72490610960701,
       1.36766663815205,  0.627780712699884,  0.269196946086812,  0.132366755262409,  -0.234598240922087,
       -1.05432577265007, -1.76820915445672,  -0.893495153234429, 1.9973748881895});
  check_near(
      filtered(jagged(), 1, 0.05),
      {-5.29521229849077,  -3.74714284552255,  -2.50755266693513,  -1.60324429997527,  -1.09552897743571,
       -0.803494819165317, -0.568428809892135, -0.520523582970942, -0.526192958746062, -0.457364893996689,
       -0.461341970833587, -0.409877967101075, -0.169020418002921, 0.131634134148409,  0.368643720600249,
       0.412015749607006,  0.394869823929174,  0.444096769218413,  0.410376568954,     0.41889415071687,
       0.599181742507987,  0.815408672564815,  1.21848553900489,   1.97855436659588});
}

TEST_CASE(
    "a sine keeps its phase and is made smaller by the square of the filter's gain, half at the cutoff") {
  const double cutoff = 0.02;
  for (const int order : {1, 2, 4, 5, 8})
    for (const double frequency : {0.005, 0.02, 0.04}) {
      Rows sine;
      for (int n = 0; n < 4000; ++n) sine.push_back(std::sin(2.0 * std::numbers::pi * frequency * n + 0.3));
      const Rows y = filtered(sine, order, cutoff);
      const double ratio = std::tan(std::numbers::pi * frequency) / std::tan(std::numbers::pi * cutoff);
      const double gain = 1.0 / (1.0 + std::pow(ratio, 2 * order));
      for (std::size_t n = 1500; n < 2500; ++n) REQUIRE(y[n] == Approx(gain * sine[n]).margin(1e-9));
    }
}

TEST_CASE("a constant passes a low-pass unchanged, and far from its ends a ramp") {
  for (const double value : filtered(Rows(100, 7.0), 4, 0.01)) CHECK(value == Approx(7.0).epsilon(1e-12));
  Rows ramp;
  for (int n = 0; n < 2000; ++n) ramp.push_back(0.5 * n - 3.0);
  const Rows y = filtered(ramp, 4, 0.02);
  for (std::size_t n = 800; n < 1200; ++n) REQUIRE(y[n] == Approx(ramp[n]).epsilon(1e-9));
}
