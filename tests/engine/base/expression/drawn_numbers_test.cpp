#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

namespace {

double value(const std::string& text) {
  return Expression(text)({});
}

/// Number of persons, each with one random property.
constexpr int persons = 20000;

std::vector<double> drawn(double variation) {
  const Expression formula("lognormal(person, 3, variation)");
  std::vector<double> all;
  for (int person = 1; person <= persons; ++person) {
    const double v[] = {static_cast<double>(person), variation};
    all.push_back(formula(v));
  }
  return all;
}

}  // namespace

TEST_CASE("a uniform number is that of its seed and stream") {
  // Python 3.11: SplitMix64 as Steele, Lea and Flood print it:
  //   u = ((bits(bits(seed, stream), 2**62) >> 12) + 0.5) * 2.0**-52
  CHECK(value("uniform(1, 3)") == 0.3997576110937636);
  CHECK(value("uniform(2, 3)") == 0.7691045507402116);
  CHECK(value("uniform(1, 4)") == 0.8565706496578182);
  CHECK(value("uniform(10, 18)") == 0.1031293762123674);
}

TEST_CASE("over seeds, uniform numbers are as often in each hundredth from 0 to 1") {
  std::vector<int> hits(100);
  for (int seed = 1; seed <= persons; ++seed) {
    const double x = value("uniform(" + std::to_string(seed) + ", 3)");
    REQUIRE((x > 0.0 && x < 1.0));
    ++hits[static_cast<std::size_t>(100.0 * x)];
  }
  const double wanted = persons / 100.0;
  double chi_squared = 0.0;
  for (const int hit : hits) chi_squared += (hit - wanted) * (hit - wanted) / wanted;
  // Quantiles of 0.1 and 99.9 % of the chi-squared distribution of 99 degrees of freedom, from
  // Boost.Math 1.74:
  CHECK(chi_squared < 148.23);
  CHECK(chi_squared > 61.14);
}

TEST_CASE("a lognormal number is that of its seed and stream") {
  // Likewise, with statistics.NormalDist().inv_cdf:
  //   math.exp(math.sqrt(math.log1p(v*v)) * NormalDist().inv_cdf(u))
  CHECK(value("lognormal(1, 3, 0.3)") == Approx(0.9281546937119995).epsilon(1e-14));
  CHECK(value("lognormal(2, 3, 0.3)") == Approx(1.2411413512222684).epsilon(1e-14));
  CHECK(value("lognormal(1, 4, 0.3)") == Approx(1.3670470570880209).epsilon(1e-14));
  CHECK(value("lognormal(10, 18, 1)") == Approx(0.3491399616048296).epsilon(1e-14));
}

TEST_CASE("over persons, lognormal numbers have the median 1 and the deviation that is asked for") {
  for (const double variation : {0.1, 0.3, 1.0}) {
    double sum = 0.0, square = 0.0, logarithms = 0.0;
    int below_median = 0, below_mean = 0;
    const double mean = std::sqrt(1.0 + variation * variation), shape = std::sqrt(std::log(mean * mean));
    for (const double x : drawn(variation)) {
      sum += x / persons, square += x * x / persons, logarithms += std::log(x) / persons;
      below_median += x < 1.0;
      below_mean += x < mean;
    }
    const double few = 5.0 / std::sqrt(static_cast<double>(persons));  // standard errors
    CHECK(sum == Approx(mean).margin(few * variation * mean));
    CHECK(logarithms == Approx(0.0).margin(few * shape));
    CHECK(std::sqrt(square / (sum * sum) - 1.0) ==
          Approx(variation).margin(few * (1.0 + variation) * (1.0 + variation)));
    CHECK(below_median == Approx(0.5 * persons).margin(0.5 * few * persons));
    CHECK(below_mean ==
          Approx(0.5 * std::erfc(-shape / std::sqrt(8.0)) * persons).margin(0.5 * few * persons));
  }
}

TEST_CASE("streams of one person are independent") {
  double product = 0.0;
  for (int person = 1; person <= persons; ++person) {
    const std::string who = std::to_string(person);
    product += std::log(value("lognormal(" + who + ", 3, 1)")) *
               std::log(value("lognormal(" + who + ", 4, 1)")) / persons;
  }
  CHECK(std::abs(product) < 5.0 * std::log(2.0) / std::sqrt(static_cast<double>(persons)));
}

TEST_CASE("without variation everybody is alike") {
  CHECK(value("lognormal(7, 3, 0)") == 1.0);
}

TEST_CASE("a seed or a stream that is not whole is refused with its place") {
  for (const char* draw : {"uniform(63.99999999999999, 3)", "uniform(3, 0.5)", "lognormal(1/3, 3, 0.3)",
                           "lognormal(1, 3.5, 0.3)", "uniform(1/0, 3)", "lognormal(1e300, 3, 0.3)"})
    for (const std::string& text : {std::string("2 + ") + draw, std::string("x && ") + draw + " > 0.5"}) try {
        const Expression expression(text);
        FAIL("not refused: " << text);
      } catch (const stepwire::expression::ExpressionError& error) {
        CHECK(error.position == text.find(std::string(draw).substr(0, 4)));
        CHECK_THAT(error.what(), Catch::Contains("that is a whole number") && Catch::Contains("round"));
      }
  CHECK_NOTHROW(Expression("uniform(round(63.99999999999999), -7)"));
}

TEST_CASE("a seed that follows from variables is refused for the values that make it broken") {
  const Expression formula("x > 0 ? lognormal(subject / 2, 3, 0.3) : 1");
  using Values = std::vector<std::optional<double>>;
  CHECK_NOTHROW(formula.check_draws(Values{1.0, 8.0}));
  CHECK_THROWS_AS(formula.check_draws(Values{1.0, 9.0}), stepwire::expression::ExpressionError);
  CHECK_NOTHROW(formula.check_draws(Values{-1.0, 9.0}));          // nothing is drawn
  CHECK_NOTHROW(formula.check_draws(Values{1.0, std::nullopt}));  // nothing is known
  const double broken[] = {1.0, 9.0};
  CHECK(std::isnan(formula(broken)));
}

TEST_CASE("a number that is drawn has no unit, so that it keeps that of what it is multiplied with") {
  for (const char* text : {"4 Hz * lognormal(subject, 3, 0.3)", "4 Hz * uniform(subject, 3)"}) {
    const stepwire::expression::Measure measure =
        Expression(text).measure({{stepwire::unit::Dimension{}, true}});
    REQUIRE(measure.dimension);
    CHECK(*measure.dimension == stepwire::unit::parse_unit("Hz")->dimension);
    CHECK(measure.sure);
  }
}

}  // namespace stepwire::expression
