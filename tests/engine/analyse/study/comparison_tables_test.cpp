#include "engine/analyse/study/comparison_tables.hpp"

#include <catch2/catch.hpp>

#include "engine/analyse/study/study_columns.hpp"
#include "tests/engine/analyse/study/samples.hpp"

namespace stepwire::study {
using namespace testing;
using Catch::Matchers::Contains;

namespace {

/// Errors of as many subjects, one list of values for each condition.
PathErrors errors_under(const std::vector<std::pair<std::string, std::vector<double>>>& conditions) {
  PathErrors errors{"1", "m", "rad", "made up", {}, {}, {}};
  for (const auto& [condition, values] : conditions)
    for (std::size_t i = 0; i < values.size(); ++i) {
      PathError row{std::to_string(i + 1), condition};
      row.error = row.normalised = values[i];
      errors.rows.push_back(row);
    }
  return errors;
}

TaskAnalysis analysed(const std::vector<std::pair<std::string, std::vector<double>>>& conditions) {
  std::vector<Condition> used;
  for (const Condition& one : six_conditions())
    for (const auto& [name, values] : conditions)
      if (one.name == name) used.push_back(one);
  return analyse(errors_under(conditions), used);
}

const std::vector<double> first{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0, 2},
    second{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

std::string shown(const std::string& name, const TaskAnalysis& analysis) {
  REQUIRE(analysis.within.has_value());
  const text::TextTable table = comparison_table(name, *analysis.within, " of task 1", 1);
  for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
  const std::string all = text::text(table);
  CHECK_THAT(all, !Contains("nan") && !Contains("inf"));
  return all;
}

/// The first row of a table that begins with these cells.
std::vector<std::string> row_of(const text::TextTable& table, const std::vector<std::string>& start) {
  for (const auto& row : table.rows)
    if (std::equal(start.begin(), start.end(), row.begin())) return row;
  return {};
}

}  // namespace

TEST_CASE("the tables of a study show what R says of the sleep data") {
  // t.test(d), wilcox by all signs, power.t.test and the noncentral t as in the tests of the statistics
  const TaskAnalysis analysis = analysed({{"NO", second}, {"H", first}});
  const statistics::WithinSubjects& within = *analysis.within;
  const text::TextTable pairs = comparison_table("comparisons", within, "", 1);
  CHECK(pairs.rows.at(0) == std::vector<std::string>{"NO - H", "1.580", "4.062", "0.00283", "0.00283", "45",
                                                     "0.00391", "0.00391"});
  CHECK(row_of(comparison_table("intervals", within, "", 1), {"NO - H"}) ==
        std::vector<std::string>{"NO - H", "1.580", "0.700", "2.460", "–", "–"});
  const text::TextTable effects = comparison_table("effect_sizes", within, "", 1);
  CHECK(row_of(effects, {"NO - H", "d_z"}) ==
        std::vector<std::string>{"NO - H", "d_z", "1.285", "0.415", "2.118"});
  CHECK(row_of(effects, {"NO - H", "d_av"})[2] == "0.833");
  CHECK(row_of(effects, {"haptic", "generalised η²"})[2] == "0.161");
  const text::TextTable power = comparison_table("power", within, "", 1);
  CHECK(power.rows.at(0)[4] == "7");
  CHECK(power.rows.at(0)[1] ==
        power.rows.at(1)[1]);  // the term haptic has the same scores but for their size
}

TEST_CASE("assumptions that do not hold say in words what to read") {
  // shapiro.test(sleep$extra[11:20] - sleep$extra[1:10]): W = 0.83, p = 0.0333
  const std::string words = shown("assumptions", analysed({{"NO", second}, {"H", first}}));
  CHECK_THAT(words, Contains("The differences NO - H are not normal (Shapiro-Wilk W = 0.83, P = 0.0333):"));
  CHECK_THAT(words, Contains("Every term has one degree of freedom, so that sphericity holds."));
}

TEST_CASE("four conditions have six comparisons, and the interaction of the feedbacks its power") {
  const TaskAnalysis analysis = analysed({{"NO", second}, {"H", first}, {"V", first}, {"HV", second}});
  REQUIRE(analysis.within->comparisons.size() == 6);
  for (const std::string& name : comparison_table_names()) shown(name, analysis);
  CHECK_FALSE(row_of(comparison_table("power", *analysis.within, "", 1), {"haptic:visual"}).empty());
  CHECK_THAT(shown("comparisons", analysis),
             Contains("NO - HV: the difference is 0 for every subject, so t and d_z have no"));
  CHECK_THAT(comparison_table("comparisons", *analysis.within, "", 1).notes.at(0),
             Contains("P (Holm): corrected for 4 comparisons."));
  CHECK_THAT(shown("assumptions", analysis), Contains("NO - HV: normality is not judged"));
}

TEST_CASE("a subject without a trial is left out of the comparisons with a sentence") {
  const std::vector<double> one_less(second.begin(), second.end() - 1);
  const TaskAnalysis analysis = analysed({{"NO", first}, {"H", one_less}});
  CHECK(analysis.within->table.subjects.size() == 9);
  for (const std::string& name : comparison_table_names())
    CHECK_THAT(shown(name, analysis), Contains("Left out: subject 10 has no value under H."));
}

TEST_CASE("two subjects have tables in which nothing is printed that does not exist") {
  const TaskAnalysis analysis = analysed({{"NO", {1.0, 2.0}}, {"H", {0.5, 0.7}}, {"V", {0.2, 0.1}}});
  for (const std::string& name : comparison_table_names()) shown(name, analysis);
  CHECK_THAT(shown("power", analysis), Contains("Power is not simulated: two subjects"));
  const std::string assumptions = shown("assumptions", analysis);
  CHECK_THAT(assumptions, Contains("normality is not judged"));
  CHECK_THAT(assumptions, Contains("Equal variances: not judged, three values per condition are needed."));
  CHECK_THAT(assumptions, !Contains("variances of the conditions differ"));
}

TEST_CASE("conditions whose values are all the same have no effect and no power") {
  const std::vector<double> same{0.5, 0.5, 0.5, 0.5};
  const TaskAnalysis analysis = analysed({{"NO", same}, {"H", same}, {"V", same}});
  for (const std::string& name : comparison_table_names()) shown(name, analysis);
}

TEST_CASE("one subject has no comparisons, and the reason is one sentence") {
  PathErrors errors = errors_under({{"NO", {1.0, 2.0}}, {"H", {0.5, 0.7}}});
  errors.rows.erase(errors.rows.begin() + 1);
  const TaskAnalysis analysis = analyse(errors, {{"NO", {}}, {"H", {{"haptic", true}}}});
  CHECK_FALSE(analysis.within.has_value());
  CHECK(
      analysis.not_within ==
      "comparisons need two subjects or more with a value under every condition; there is one (subject 2 has "
      "no value under NO)");
}

TEST_CASE("what a program reads has null for what does not exist") {
  const std::string json =
      comparisons_json(*analysed({{"NO", {1.0, 2.0}}, {"H", {0.5, 1.5}}}).within, 1).text(-1);
  CHECK_THAT(json, Contains("\"first\":\"NO\",\"second\":\"H\",\"difference\":0.5") &&
                       Contains("\"d_z\":null") && Contains("\"normality\":null") &&
                       Contains("\"subjects_needed_simulated\":null"));
  CHECK_THAT(json, !Contains("nan"));
}

TEST_CASE("claims read the pairs of a study by name") {
  StudyRequest request;
  for (const Condition& one : std::vector<Condition>{{"NO", {}}, {"H", {{"haptic", true}}}})
    request.conditions.push_back({one, {}});
  Experiment experiment;
  experiment.seed = 1;
  experiment.analysis = analysed({{"NO", second}, {"H", first}});
  const auto values = comparison_values(experiment, request);
  CHECK(value_of(values, "difference.NO_H") == Approx(1.58));
  CHECK(value_of(values, "holm.NO_H") == Approx(0.00283289019738427));
  CHECK(value_of(values, "d.NO_H") == Approx(1.28455756259106));
  CHECK(value_of(values, "signed_rank.NO_H") == Approx(0.00390625));
  CHECK(value_of(values, "needed.NO_H") >= 4.0);
}

TEST_CASE("a name that two pairs of conditions would have belongs to neither") {
  StudyRequest request;
  for (const char* name : {"A_B", "A", "B_A"}) request.conditions.push_back({{name}, {}});
  for (const std::string& column : comparison_columns(request)) CHECK_THAT(column, Contains(".A_B_B_A"));
  CHECK(comparison_columns(request).size() == 8);
}

}  // namespace stepwire::study
