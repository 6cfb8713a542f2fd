#include "engine/analyse/study/analysis.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/analyse/study/samples.hpp"

namespace stepwire::study {
using namespace testing;
using Catch::Matchers::Contains;

namespace {

const std::vector<std::pair<std::string, double>> task_1{
    {"NO", 0.698}, {"H", 0.217}, {"V", 0.114}, {"HV", 0.079}};
const std::vector<std::pair<std::string, double>> task_2{
    {"H", 0.421}, {"V", 0.547}, {"HV", 0.291}, {"V_gp", 0.288}, {"HV_gp", 0.185}};

}  // namespace

TEST_CASE("the additive form without subjects gives table 4 from the published means") {
  // The residual has 37 degrees of freedom and a mean square of 0.0278. The interaction, which the form
  // omits, is 10 (0.698 - 0.217 - 0.114 + 0.079)^2 / 4 of its sum of squares; the rest is spread about the
  // means.
  const double about = std::sqrt((37 * 0.0278 - 10.0 * 0.446 * 0.446 / 4.0) / 40.0);
  PathErrors errors = errors_of("1", task_1);
  for (std::size_t i = 0; i < errors.rows.size(); ++i)
    errors.rows[i].normalised = task_1[i % 4].second + (i / 4 % 2 == 0 ? about : -about);
  const TaskAnalysis found = analyse(errors, six_conditions());
  CHECK(found.additive.residual.freedom == 37.0);
  CHECK(found.additive.residual.mean_square == Approx(0.0278));
  CHECK(found.additive.find("haptic")->p == Approx(2.02e-5).epsilon(0.04));
  CHECK(found.additive.find("visual")->p == Approx(4.49e-8).epsilon(0.04));
}

TEST_CASE("task 1 is analysed within subjects by its two feedbacks") {
  const TaskAnalysis found = analyse(errors_of("1", task_1), six_conditions());
  REQUIRE(found.means.size() == 4);
  CHECK(found.means[0].name == "NO");
  CHECK(found.with_subject.find("subject")->freedom == 9.0);
  REQUIRE(found.repeated.has_value());
  CHECK(found.repeated->find("haptic:visual")->against == "haptic:visual:subject");
}

TEST_CASE(
    "task 2 is analysed within subjects by its conditions, as three of eight combinations are missing") {
  const TaskAnalysis found = analyse(errors_of("2", task_2), six_conditions());
  CHECK(found.additive.terms.size() == 3);
  CHECK(found.additive.residual.freedom == 46.0);
  REQUIRE(found.repeated.has_value());
  CHECK(found.repeated->find("condition")->freedom == 4.0);
  CHECK(found.repeated->find("condition")->sphericity.has_value());
}

TEST_CASE("a study with a missing trial says why it has no repeated measures") {
  PathErrors errors = errors_of("1", task_1);
  errors.rows.pop_back();
  const TaskAnalysis found = analyse(errors, six_conditions());
  CHECK_FALSE(found.repeated.has_value());
  CHECK_THAT(found.not_repeated,
             Contains("there is no value for subject 10, haptic present, visual present"));
  CHECK_FALSE(found.additive.balanced);
}

TEST_CASE("a table of variances has its lines, its design and its warnings") {
  const TaskAnalysis found = analyse(errors_of("1", task_1), six_conditions());
  const std::string words = text::text(anova_table(found.additive, "Task 1"));
  CHECK_THAT(words,
             Contains("Task 1\nterm") && Contains("haptic") && Contains("residual") && Contains("total"));
  CHECK_THAT(words, Contains("40 values in 4 cells of 10\n(balanced).") && Contains("type III"));
  CHECK_THAT(words, Contains("Mind: the variances of the cells differ"));
  const std::string json = anova_json(found.additive).text(-1);
  CHECK_THAT(json, Contains("\"name\":\"haptic\"") && Contains("\"degrees_of_freedom\":37.0") &&
                       Contains("\"balanced\":true"));
  CHECK_THAT(text::text(anova_table(*analyse(errors_of("2", task_2), six_conditions()).repeated, "Task 2")),
             Contains("P (GG)") && Contains("P (HF)"));
  CHECK_THAT(anova_json(*analyse(errors_of("2", task_2), six_conditions()).repeated).text(-1),
             Contains("\"epsilon_greenhouse_geisser\":") && Contains("\"P_huynh_feldt\":"));
}

TEST_CASE("the errors of every condition are summed up in one line") {
  const text::TextTable table = error_summary(errors_of("1", task_1));
  REQUIRE(table.rows.size() == 4);
  CHECK(table.rows[3][0] == "HV");
  CHECK(table.rows[3][1] == "10");
}

TEST_CASE("probabilities are printed with three digits") {
  CHECK(printed_probability(2.0234e-5) == "2.02e-05");
  CHECK(printed_probability(0.21649) == "0.216");
  CHECK(printed_probability(NAN) == "–");
}

}  // namespace stepwire::study
