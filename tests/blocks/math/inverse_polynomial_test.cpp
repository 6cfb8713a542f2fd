#include "blocks/math/inverse_polynomial.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("The inverse of a square is the root") {
  InversePolynomial square;
  square.coefficients = {1.0, 0.0, 0.0};
  square.range = {0.0, 3.0};
  for (int k = 0; k <= 90; ++k) CHECK(square.argument(0.1 * k) == Approx(std::sqrt(0.1 * k)).margin(1e-15));
}

TEST_CASE("Values that the polynomial does not take give the end of the range") {
  InversePolynomial line;
  line.coefficients = {2.0, 1.0};
  line.range = {-1.0, 4.0};
  CHECK(line.argument(-1.1) == -1.0);
  CHECK(line.argument(9.1) == 4.0);
}

TEST_CASE("The current that is found makes the friction that is asked for, over the range of a damper") {
  // alpha(i) of the RD-1097-01, by Horner's rule as an independent formula
  InversePolynomial alpha;
  alpha.coefficients = {72.8, -42.88, 14.83, 0.29};
  alpha.range = {0.0, 0.35};
  for (int k = 0; k <= 100; ++k) {
    const double i = 0.0035 * k;
    CHECK(alpha.argument(72.8 * i * i * i - 42.88 * i * i + 14.83 * i + 0.29) == Approx(i).margin(1e-14));
  }
}

TEST_CASE("A polynomial that does not rise over its range is refused, with the place where it turns back") {
  const std::string head = "step: 1 ms\nstop: 1 s\nblocks:\n  p: {block: InversePolynomial, u: 1, ";
  CHECK_THAT(error_of(head + "coefficients: [1, 0, 0], range: [-1, 1]}\n"),
             Catch::Contains("p.range") && Catch::Contains("does not rise at -1"));
  CHECK_THAT(error_of(head + "coefficients: [1, 0], range: [1, -1]}\n"), Catch::Contains("p.range"));
  CHECK_THAT(error_of(head + "coefficients: [], range: [0, 1]}\n"), Catch::Contains("p.coefficients"));
}

TEST_CASE("A value is found where the polynomial hardly rises, and next to it") {
  InversePolynomial cube;
  cube.coefficients = {1.0, 0.0, 0.0, 0.0};
  cube.range = {-1.0, 1.0};
  for (const double root : {-0.9, -1e-2, -1e-3, -1e-5, 1e-5, 1e-3, 1e-2, 0.3, 0.999})
    CHECK(cube.argument(root * root * root) == Approx(root).margin(1e-11));
  CHECK(cube.value(cube.argument(0.0)) == Approx(0.0).margin(1e-18));  // any argument within 2e-7 gives it

  InversePolynomial quartic;  // x^4, whose slope and curvature are nothing at the end of the range
  quartic.coefficients = {1.0, 0.0, 0.0, 0.0, 0.0};
  quartic.range = {0.0, 2.0};
  for (const double root : {1e-3, 1e-2, 0.1, 0.5, 1.0, 1.9})
    CHECK(quartic.argument(std::pow(root, 4.0)) == Approx(root).margin(1e-12));
}
