#include "engine/analyse/study/side_by_side.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/analyse/study/samples.hpp"

namespace stepwire::study {
using namespace testing;
using Catch::Matchers::Contains;

namespace {

const Agreement& agreement(const SideBySide& both, const std::string& start) {
  for (const Agreement& agreement : both.agreements)
    if (agreement.that.starts_with(start)) return agreement;
  throw std::logic_error("no agreement starts with " + start);
}

}  // namespace

TEST_CASE("the published values agree with themselves") {
  for (const PublishedStudy& task : {published_task_1(), published_task_2()}) {
    const SideBySide both = compare_errors(task.means, task.means.values, task.order);
    CHECK(both.values.size() == task.means.values.size());
    for (const Agreement& agreement : both.agreements) CHECK(agreement.agrees);
    for (const PublishedValues& example : task.examples)
      CHECK(compare_errors(example, example.values, {}).agreements.size() == example.values.size() - 1);
  }
}

TEST_CASE("another order is told with ours") {
  const SideBySide both =
      compare_errors(published_task_1().means, {{"NO", 0.2}, {"H", 0.5}, {"V", 0.1}, {"HV", 0.05}},
                     {{"NO", "H", "V", "HV"}});
  const Agreement& order = agreement(both, "order NO > H > V > HV");
  CHECK_FALSE(order.agrees);
  CHECK(order.ours == "H > NO > V > HV");
}

TEST_CASE("equal errors are no order") {
  const SideBySide both = compare_errors(published_task_1().means, {{"NO", 0.2}, {"H", 0.2}}, {{"NO", "H"}});
  CHECK_FALSE(both.agreements[0].agrees);
  CHECK(both.agreements[0].ours == "NO = H");
}

TEST_CASE("ratios are judged against the largest error, however errors are normalised") {
  // Published: H is 0.217/0.698 = 0.311 of NO.
  const SideBySide both =
      compare_errors(published_task_1().means, {{"NO", 70.0}, {"H", 21.0}, {"V", 0.5}, {"HV", 8.0}}, {});
  CHECK(agreement(both, "H is 0.311 of NO").agrees);
  CHECK(agreement(both, "H is 0.311 of NO").ours == "0.3");
  CHECK_FALSE(agreement(both, "V is 0.163 of NO").agrees);
  CHECK(agreement(both, "HV is 0.113 of NO").agrees);
}

TEST_CASE("a condition that we do not have is left out of the words and shown as missing") {
  const SideBySide both =
      compare_errors(published_task_2().means, {{"V", 0.5}, {"H", 0.4}}, published_task_2().order);
  CHECK(both.agreements.size() == 2);  // one order, one ratio
  CHECK_THAT(text::text(side_by_side_table(both)), Contains("–"));
}

TEST_CASE("a factor agrees where it is significant on both sides or on neither") {
  TaskAnalysis ours;
  ours.effects = {{"haptic", -0.1}, {"visual", -0.2}, {"guiding path", -0.3}};
  for (const auto& [name, p] : {std::pair{"haptic", 0.04}, {"visual", 0.01}, {"guiding path", 0.06}}) {
    statistics::AnovaRow row;
    row.name = name;
    row.p = p;
    ours.additive.terms.push_back(row);
  }
  const SideBySide both = compare_significance(published_task_2(), ours, six_conditions());
  CHECK(agreement(both, "haptic is significant at 0.05").agrees);
  CHECK_FALSE(agreement(both, "visual is not significant at 0.05").agrees);
  CHECK(agreement(both, "guiding path is significant at 0.05").ours ==
        "not significant (lowers the error by 0.3)");
}

TEST_CASE("a factor that is significant the other way round does not agree") {
  TaskAnalysis ours;
  statistics::AnovaRow row;
  row.name = "haptic";
  row.p = 0.001;
  ours.additive.terms = {row};
  for (const double effect : {-0.2, 0.2}) {
    ours.effects = {{"haptic", effect}};
    const SideBySide both = compare_significance(published_task_2(), ours, six_conditions());
    // By hand, from the published means of V, HV, V_gp and HV_gp: (0.291 - 0.547 + 0.185 - 0.288) / 2.
    const Agreement& haptic = agreement(both, "haptic is significant at 0.05 and lowers the error by 0.18");
    CHECK(haptic.agrees == (effect < 0.0));
    CHECK(haptic.ours == (effect < 0.0 ? "significant and lowers the error by 0.2"
                                       : "significant and raises the error by 0.2"));
    CHECK_THAT(text::text(side_by_side_table(both)), Contains(effect < 0.0 ? "-0.200" : "+0.200"));
  }
}

TEST_CASE("effects of the published means of task 1 are differences of means") {
  // Two by two and balanced: ((H - NO) + (HV - V)) / 2 and ((V - NO) + (HV - H)) / 2.
  const auto effects = factor_effects(published_task_1().means.values, six_conditions());
  REQUIRE(effects.size() == 2);
  CHECK(value_of(effects, "haptic") == Approx((0.217 - 0.698 + 0.079 - 0.114) / 2.0));
  CHECK(value_of(effects, "visual") == Approx((0.114 - 0.698 + 0.079 - 0.217) / 2.0));
}

TEST_CASE("feedbacks that always come together have no effects of their own") {
  const auto effects = factor_effects({{"NO", 0.7}, {"HV", 0.1}}, six_conditions());
  REQUIRE(effects.size() == 2);
  for (const NamedValue& effect : effects) CHECK(std::isnan(effect.value));
}

TEST_CASE("the words stand below the table, and in JSON") {
  const auto all =
      compare(published_task_1(),
              analyse(errors_of("1", {{"NO", 0.7}, {"H", 0.2}, {"V", 0.1}, {"HV", 0.08}}), six_conditions()),
              six_conditions());
  REQUIRE(all.size() == 2);
  CHECK_THAT(text::text(side_by_side_table(all[0])),
             Contains("Agrees: order NO > H > V > HV; ours: NO > H > V > HV."));
  CHECK_THAT(text::text(side_by_side_table(all[1])),
             Contains("2.02e-05") && Contains("Agrees: haptic is significant"));
  CHECK_THAT(side_by_side_json(all[1]).text(-1),
             Contains("\"published\":2.02e-05") && Contains("\"agrees\":true"));
}

TEST_CASE("a study beside which nothing is published has its own numbers alone") {
  TaskAnalysis ours;
  ours.means = {{"A", 0.5}, {"B", 0.25}};
  ours.effects = {{"haptic", -0.25}};
  const auto all = compare({}, ours, six_conditions());
  CHECK(all[0].title == "Errors");
  REQUIRE(all[0].values.size() == 2);
  CHECK(all[0].values[1].name == "B");
  CHECK(all[0].values[1].ours == 0.25);
  CHECK(std::isnan(all[0].values[1].published));
  CHECK(all[0].agreements.empty());
  REQUIRE(all[1].effects.size() == 1);
  CHECK(all[1].effects[0].ours == -0.25);
  CHECK(all[1].agreements.empty());
}

}  // namespace stepwire::study
