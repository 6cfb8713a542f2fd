#include "engine/analyse/statistics/rounding.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/statistics/assumptions.hpp"
#include "engine/analyse/statistics/within_subjects.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"

namespace stepwire::statistics {

namespace {

constexpr std::size_t people = 6, conditions = 3;

/// The same score of everybody under every condition but for the last bits, which differ everywhere.
double nearly(double score, std::size_t index) {
  return score * (1.0 + static_cast<double>(index * 7 % 5) * 2.3e-16);
}

/// Scores by subject and then by condition.
Observations scores(double (*score)(std::size_t subject, std::size_t condition)) {
  Observations data{"error",
                    {},
                    {textbook::running("condition", conditions, 1, people * conditions),
                     textbook::running("subject", people, conditions, people * conditions, true)}};
  for (std::size_t i = 0; i < people * conditions; ++i)
    data.values.push_back(nearly(score(i / conditions, i % conditions), i));
  return data;
}

WithinSubjects analysed(double (*score)(std::size_t subject, std::size_t condition)) {
  return within_subjects(scores(score), {"condition"}, {"1", "2", "3"}, "condition", "subject");
}

}  // namespace

TEST_CASE("scores that only rounding tells apart give no value to any test") {
  const auto constant = [](std::size_t, std::size_t) { return 0.3; };
  const WithinSubjects within = analysed(constant);
  for (const PairComparison& one : within.comparisons) {
    CHECK(one.test.mean == 0.0);
    CHECK(std::isnan(one.test.p));
    CHECK(std::isnan(one.ranks.p));
    CHECK(std::isnan(one.effect.d_z));
    CHECK_FALSE(one.normality.has_value());
  }
  const AnovaRow& row = *within.repeated.find("condition");
  CHECK(std::isnan(row.f));
  CHECK(std::isnan(row.p));
  CHECK(row.sum_of_squares == 0.0);
  CHECK_FALSE(within.variances.has_value());
  const Anova plain = anova(scores(constant), additive_terms({"condition"}));
  CHECK(std::isnan(plain.find("condition")->p));
  CHECK(plain.total.sum_of_squares == 0.0);
  REQUIRE(plain.warnings.size() == 1);
  CHECK(plain.warnings[0] ==
        "F of condition has no value: what it is compared with varies by no more than rounding");
}

TEST_CASE("differences that are the same for everybody give neither t nor F") {
  const WithinSubjects within = analysed([](std::size_t subject, std::size_t condition) {
    return static_cast<double>(subject + 1) + 1e-3 * static_cast<double>(condition);
  });
  CHECK(within.comparisons[0].test.mean == Approx(-1e-3));
  CHECK(std::isnan(within.comparisons[0].test.t));
  CHECK(std::isnan(within.repeated.find("condition")->f));
  CHECK(within.repeated.find("condition")->sum_of_squares == Approx(12e-6));
}

TEST_CASE("small differences that are not rounding keep their test") {
  const WithinSubjects within = analysed([](std::size_t subject, std::size_t condition) {
    return 1.0 + 1e-10 * static_cast<double>(condition * (subject + 2));
  });
  CHECK(within.comparisons[0].test.p < 0.01);
  CHECK(within.repeated.find("condition")->p < 0.05);
}

TEST_CASE("two values in each group have no spread of their distances, so that variances are not compared") {
  CHECK_FALSE(variance_test({{0.1, 0.7}, {0.3, 0.35}, {1.0, 2.3}}).has_value());
  CHECK_FALSE(variance_test({{1.0, 3.0}, {1.0, 9.0}}).has_value());
  CHECK(variance_test({{0.1, 0.7}, {0.3, 0.35, 0.9}}).has_value());
}

}  // namespace stepwire::statistics
