#include <catch2/catch.hpp>
#include <map>

#include "engine/analyse/study/study_tables.hpp"
#include "tests/engine/analyse/study/samples.hpp"

namespace stepwire::study {
using namespace testing;

namespace {

StudyRequest request_of_task_1() {
  StudyRequest request;
  request.task = "1";
  request.published = published_task_1();
  request.subjects = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  for (const Condition& one : six_conditions())
    if (!one.has("guiding path")) request.conditions.push_back({one, {}});
  return request;
}

Experiment experiment_of(const std::string& offset,
                         const std::vector<std::pair<std::string, double>>& means) {
  Experiment experiment;
  experiment.sets.push_back({"offset", offset});
  experiment.errors = errors_of("1", means);
  experiment.analysis = analyse(experiment.errors, six_conditions());
  return experiment;
}

std::map<std::string, text::TextTable> tables_of(const Experiments& experiments) {
  std::vector<query::NamedTable> tables = empty_study_tables();
  fill_sweep_tables(experiments, request_of_task_1(), tables);
  std::map<std::string, text::TextTable> all;
  for (const query::NamedTable& one : tables) all[one.name] = *one.table;
  return all;
}

}  // namespace

TEST_CASE("a swept study has a line for each point, with what is published below them") {
  // The means of section 4.3.1, then the same with H and V in each other's place.
  const auto tables =
      tables_of({experiment_of("2 N", {{"NO", 0.698}, {"H", 0.217}, {"V", 0.114}, {"HV", 0.079}}),
                 experiment_of("5 N", {{"NO", 0.698}, {"H", 0.114}, {"V", 0.217}, {"HV", 0.079}})});
  const text::TextTable& means = tables.at("means");
  CHECK(means.columns == std::vector<std::string>{"offset", "NO", "H", "V", "HV", "(1)"});
  REQUIRE(means.rows.size() == 3);
  CHECK(means.rows[0].front() == "2 N");
  CHECK(means.rows[0].back() == "holds");
  CHECK(means.rows[1].front() == "5 N");
  CHECK(means.rows[1].back() == "fails");
  CHECK(means.rows[2] == std::vector<std::string>{"published", "0.698", "0.217", "0.114", "0.079", "–"});
  CHECK(means.notes == std::vector<std::string>{"(1) Published: order NO > H > V > HV."});
}

TEST_CASE("whether factors are significant as published is told for each point") {
  // The errors of ten people differ by a third at most. With the means of the thesis both factors are
  // significant, with equal means neither is.
  const auto tables =
      tables_of({experiment_of("2 N", {{"NO", 0.698}, {"H", 0.217}, {"V", 0.114}, {"HV", 0.079}}),
                 experiment_of("5 N", {{"NO", 0.3}, {"H", 0.3}, {"V", 0.3}, {"HV", 0.3}})});
  const text::TextTable& significance = tables.at("significance");
  CHECK(significance.columns == std::vector<std::string>{"offset", "haptic", "visual", "(1)", "(2)"});
  REQUIRE(significance.rows.size() == 3);
  CHECK(significance.rows[0][3] == "holds");
  CHECK(significance.rows[0][4] == "holds");
  CHECK(significance.rows[1][3] == "fails");
  CHECK(significance.rows[1][4] == "fails");
}

TEST_CASE("the other tables have the rows of all points, each with what differs between them") {
  Experiments two{experiment_of("2 N", {{"NO", 0.698}, {"H", 0.217}, {"V", 0.114}, {"HV", 0.079}}),
                  experiment_of("5 N", {{"NO", 0.3}, {"H", 0.3}, {"V", 0.3}, {"HV", 0.3}})};
  two[0].sets.push_back({"slope", "1 N/mm"});  // not needed beside the offset
  two[1].sets.push_back({"slope", "1 N/mm"});
  const text::TextTable anova = tables_of(two).at("anova");
  CHECK(anova.columns[0] == "offset");
  CHECK(anova.columns[1] == "term");
  REQUIRE(anova.rows.size() == 8);
  CHECK(anova.rows[0][0] == "2 N");
  CHECK(anova.rows[0][1] == "haptic");
  CHECK(anova.rows[4][0] == "5 N");
  CHECK(anova.rows[4][1] == "haptic");
  CHECK(tables_of(two).at("means").notes.back() == "5 N: slope=1 N/mm.");
}

TEST_CASE("a point whose trials cannot be analysed says why") {
  Experiment lost;
  lost.sets.push_back({"offset", "9 N"});
  lost.not_analysed = "all errors are zero";
  const auto tables =
      tables_of({lost, experiment_of("2 N", {{"NO", 0.7}, {"H", 0.2}, {"V", 0.1}, {"HV", 0.05}})});
  const text::TextTable& means = tables.at("means");
  CHECK(means.rows[0] == std::vector<std::string>{"9 N", "–", "–", "–", "–", "–"});
  CHECK(means.notes.front() == "Not analysed with offset=9 N: all errors are zero.");
}

}  // namespace stepwire::study
