#include "engine/analyse/study/scores.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/base/table/table_file.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::study {
using Catch::Matchers::Contains;
using statistics::Observations;

namespace {

/// A file with a column for each factor and one for the score.
std::string csv_of(const Observations& data, const Scratch& folder, const std::string& name) {
  std::string text;
  for (const statistics::Factor& factor : data.factors) text += factor.name + ",";
  text += data.response + "\n";
  for (std::size_t row = 0; row < data.values.size(); ++row) {
    for (const statistics::Factor& factor : data.factors) text += factor.levels[factor.level[row]] + ",";
    text += std::to_string(data.values[row]) + "\n";
  }
  folder.file(name, text);
  return folder.path(name);
}

}  // namespace

TEST_CASE("independent scores of a table are analysed with their interactions") {
  // summary(aov(len ~ supp*factor(dose), ToothGrowth))
  const Scratch folder;
  const ScoresAnalysis found = analyse_scores(csv_of(textbook::teeth(), folder, "teeth.csv"), {});
  CHECK(found.anova.find("supp")->f == Approx(15.57198).epsilon(1e-6));
  CHECK(found.anova.find("dose")->f == Approx(91.99996).epsilon(1e-6));
  CHECK(found.anova.find("supp:dose")->f == Approx(4.10699).epsilon(1e-6));
  CHECK(found.request.score == "len");
  CHECK_FALSE(found.pairs.has_value());
  CHECK_THAT(text::text(score_tables(found).front()), Contains("13.23"));  // the mean of OJ at 0.5 mg
}

TEST_CASE("scores of subjects are analysed by repeated measures, with comparisons of all conditions") {
  const Scratch folder;
  const ScoresAnalysis found =
      analyse_scores(csv_of(textbook::stools(), folder, "stools.csv"), {.subject = "Subject"});
  CHECK(found.within == std::vector<std::string>{"Type"});
  CHECK(found.anova.find("Type")->f == Approx(22.35564).epsilon(3e-7));
  CHECK(found.anova.find("Type")->sphericity->epsilon == Approx(0.6459).margin(5e-5));
  REQUIRE(found.pairs.has_value());
  CHECK(found.pairs->comparisons.size() == 6);
}

TEST_CASE("two factors within subjects have their interaction, and conditions are their combinations") {
  const Scratch folder;
  const ScoresAnalysis found = analyse_scores(csv_of(textbook::oats(), folder, "oats.csv"), {.subject = "B"});
  CHECK(found.anova.find("N:V")->f == Approx(0.26029).margin(6e-6));
  CHECK(found.pairs->table.conditions.size() == 12);
}

TEST_CASE("a subject who misses a cell is left out, which the tables report") {
  const Scratch folder;
  Observations some = textbook::sleep();
  some.values.pop_back();
  for (statistics::Factor& factor : some.factors) factor.level.pop_back();
  const ScoresAnalysis found = analyse_scores(csv_of(some, folder, "sleep.csv"), {.subject = "ID"});
  CHECK(found.anova.find("group:ID")->freedom == 8.0);
  REQUIRE(found.left_out.size() == 1);
  CHECK_THAT(found.left_out[0], Contains("no score for ID 10, group 2"));
}

TEST_CASE("what a table of scores lacks is named with its place") {
  const Scratch folder;
  folder.file("a.csv", "who,task,error\n1,a,2\n1,,3\n");
  const std::string path = folder.path("a.csv");
  CHECK_THROWS_WITH(analyse_scores(path, {}), Contains("a.csv:3: 'task' is missing"));
  CHECK_THROWS_WITH(analyse_scores(path, {.score = "erorr"}),
                    Contains("there is no column 'erorr' for --score"));
  CHECK_THROWS_WITH(analyse_scores(path, {.factors = {"error"}}), Contains("a factor and also the score"));
  folder.file("b.csv", "task,error\na,two\n");
  CHECK_THROWS_WITH(analyse_scores(folder.path("b.csv"), {}), Contains("b.csv:2"));
}

}  // namespace stepwire::study
