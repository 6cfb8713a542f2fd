// Reference datasets of NIST for one-way analysis of variance (public domain, itl.nist.gov/div898/strd);
// SmLs01 to SmLs09 are in anova_test.cpp.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/statistics/anova.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"

namespace stepwire::statistics {
using namespace textbook;

namespace {

double digits_of(double value, double certified) {
  return value == certified ? 15.0 : -std::log10(std::abs(value - certified) / std::abs(certified));
}

}  // namespace

TEST_CASE("The resistance of silicon is analysed to nine certified digits") {
  // SiRstv: five instruments, five measurements each.
  const Observations set{
      "resistance",
      {196.3052, 196.1240, 196.1890, 196.2569, 196.3403, 196.3042, 196.3825, 196.1669, 196.3257,
       196.0422, 196.1303, 196.2005, 196.2889, 196.0343, 196.1811, 196.2795, 196.1748, 196.1494,
       196.1485, 195.9885, 196.2119, 196.1051, 196.1850, 196.0052, 196.2090},
      {running("instrument", 5, 5, 25)}};
  const Anova found = anova(set, additive_terms({"instrument"}));
  CHECK(digits_of(found.terms[0].sum_of_squares, 5.11462616000000E-02) >= 9.0);
  CHECK(digits_of(found.terms[0].f, 1.18046237440255E+00) >= 9.0);
  CHECK(digits_of(found.residual.sum_of_squares, 2.16636560000000E-01) >= 9.0);
  CHECK(found.residual.freedom == 20.0);
}

TEST_CASE("The atomic weight of silver is analysed to the digits that doubles leave") {
  // AtmWtAg: two instruments, 24 measurements each, that differ in the seventh digit: their differences have
  // nine digits in doubles.
  const Observations set{
      "weight",
      {107.8681568, 107.8681465, 107.8681572, 107.8681785, 107.8681446, 107.8681903, 107.8681526,
       107.8681494, 107.8681616, 107.8681587, 107.8681519, 107.8681486, 107.8681419, 107.8681569,
       107.8681508, 107.8681672, 107.8681385, 107.8681518, 107.8681662, 107.8681424, 107.8681360,
       107.8681333, 107.8681610, 107.8681477, 107.8681079, 107.8681344, 107.8681513, 107.8681197,
       107.8681604, 107.8681385, 107.8681642, 107.8681365, 107.8681151, 107.8681082, 107.8681517,
       107.8681448, 107.8681198, 107.8681482, 107.8681334, 107.8681609, 107.8681101, 107.8681512,
       107.8681469, 107.8681360, 107.8681254, 107.8681261, 107.8681450, 107.8681368},
      {running("instrument", 2, 24, 48)}};
  const Anova found = anova(set, additive_terms({"instrument"}));
  CHECK(digits_of(found.terms[0].sum_of_squares, 3.63834187500000E-09) >= 8.5);
  CHECK(digits_of(found.terms[0].f, 1.59467335677930E+01) >= 8.5);
  CHECK(digits_of(found.residual.mean_square, 1.04951729166667E-08 / 46.0) >= 8.5);
}

TEST_CASE("An interaction that the model leaves out is named with its F") {
  // summary(aov(len ~ supp*factor(dose), ToothGrowth)): supp:dose F(2, 54) = 4.107, P = 0.0219
  const Anova additive = anova(teeth(), additive_terms({"supp", "dose"}));
  REQUIRE(!additive.warnings.empty());
  CHECK_THAT(
      additive.warnings[0],
      Catch::Contains("the interaction supp:dose is part of the residual; as a term it has F(2, 54) = 4.11"));
  for (const std::string& warning : anova(teeth(), crossed_terms({"supp", "dose"})).warnings)
    CHECK_THAT(warning, !Catch::Contains("part of the residual"));
}

}  // namespace stepwire::statistics
