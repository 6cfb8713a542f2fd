#include "engine/analyse/study/scores.hpp"

#include <fmt/format.h>

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

TEST_CASE("scores with a decimal comma are read, and ones that may be read in two ways are refused") {
  const Scratch folder;
  const auto read = [&](const std::string& text) {
    folder.file("d.csv", text);
    return analyse_scores(folder.path("d.csv"), {}).observations.values;
  };
  CHECK(read("d;y\na;1,5\na;2,25\nb;3\nb;4,5\n") == std::vector<double>{1.5, 2.25, 3.0, 4.5});
  CHECK(read("d,y\na,1.234\na,2.345\nb,3.456\nb,4.567\n") == std::vector<double>{1.234, 2.345, 3.456, 4.567});
  CHECK_THROWS_WITH(read("d;y\na;1,234\nb;2\n"),
                    Contains("d.csv:2: '1,234' may part thousands or be decimal"));
  CHECK_THROWS_WITH(read("d;y\na;1,5\nb;2.5\n"),
                    Contains("a decimal comma, but other scores a decimal point"));
  CHECK_THROWS_WITH(read("d;y\na;1,5\nb;\n"), Contains("d.csv:3: the score is missing; leave the row out"));
  CHECK_THROWS_WITH(read("d;y\na;1.5\nb;NA\n"), Contains("d.csv:3: the score is missing"));
}

TEST_CASE("a table of scores is read as other programs write it, like a record") {
  const Scratch folder;
  const auto read = [&](const std::string& text) {
    folder.file("d.csv", text);
    return analyse_scores(folder.path("d.csv"), {}).observations;
  };
  const std::vector<double> scores{1.5, 2.5, 3.0, 4.5};
  CHECK(read("# of Monday\nd,y\na,1.5\na,2.5\n# more\nb,3\nb,4.5\n").values == scores);
  CHECK(read("sep=;\nd;y\na;1.5\na;2.5\n\nb;3\nb;4.5\n").values == scores);
  CHECK(read("d,y\na,1.5D0\na,25.0D-1\nb,3\nb,4.5\n").values == scores);
  std::string wide = "\xFF\xFE";
  for (const char c : std::string("d;y\na;1,5\na;2,5\nb;3\nb;4,5\n")) wide += {c, '\0'};
  const Observations found = read(wide);
  CHECK(found.values == scores);
  CHECK(found.factor("d").levels == std::vector<std::string>{"a", "b"});
  CHECK_THROWS_WITH(read("# x\n\nd,y\na,1\n\n# y\nb,two\n"), Contains("d.csv:7: 'two'"));
}

TEST_CASE("cells of scores with a large offset have the moments of the differences") {
  // The scores 0, 0.5 and 1 beyond 1e12 are exact there, each 667 times: mean 0.5, squares 2 * 667 * 0.25.
  const Scratch folder;
  std::string text = "d,y\n";
  for (const char* level : {"a", "b"})
    for (int row = 0; row < 2001; ++row)
      text += fmt::format("{},{:.10f}\n", level, 1e12 + (row % 3 == 0 ? 0.0 : row % 3 == 1 ? 0.5 : 1.0));
  folder.file("far.csv", text);
  const std::string json = scores_json("far.csv", analyse_scores(folder.path("far.csv"), {})).text();
  CHECK_THAT(json, Contains("\"mean\": 1000000000000.5"));
  CHECK_THAT(json, Contains("\"standard_deviation\": 0.40835"));  // sqrt(667 * 0.5 / 2000)
}

TEST_CASE("one factor of many levels is analysed in a time that its rows do not decide") {
  // 500 levels of 40 scores each: level k has mean k, and scores k +- 1, so the sums of squares are closed.
  Observations data{"y", {}, {{"d", {}, {}}}};
  for (std::size_t level = 0; level < 500; ++level) {
    data.factors[0].levels.push_back(std::to_string(level));
    for (int k = 0; k < 40; ++k) {
      data.factors[0].level.push_back(level);
      data.values.push_back(static_cast<double>(level) + (k % 2 ? 1.0 : -1.0));
    }
  }
  const statistics::Anova found = statistics::anova(data, statistics::crossed_terms({"d"}));
  CHECK(found.find("d")->sum_of_squares == Approx(40.0 * 500.0 * (250000.0 - 1.0) / 12.0).epsilon(1e-12));
  CHECK(found.residual.sum_of_squares == Approx(20000.0).epsilon(1e-12));
  CHECK(found.find("d")->freedom == 499.0);
  CHECK(found.residual.freedom == 19500.0);
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

TEST_CASE("subjects that all miss a cell are named with what they miss") {
  const Scratch folder;
  folder.file("a.csv",
              "s,g,c,y\n1,a,x,1\n1,a,z,2\n2,a,x,2\n2,a,z,2.5\n3,b,x,3\n3,b,z,4\n3,a,x,3\n4,b,x,2\n4,b,z,5\n");
  CHECK_THROWS_WITH(
      analyse_scores(folder.path("a.csv"), {.subject = "s"}),
      Contains("repeated measures need two subjects with a score in each cell, and there is none: "
               "no score for s 1, g b, c x; no score for s 1, g b, c z; ") &&
          Contains("; and 1 more; 'g' counts as within subjects, since s 3 has several levels of it"));
  folder.file("b.csv", "s,c,y\n1,x,1\n1,z,2\n2,x,2\n3,z,3\n");
  CHECK_THROWS_WITH(analyse_scores(folder.path("b.csv"), {.subject = "s"}),
                    Contains("and there is one: no score for s 2, c z; no score for s 3, c x"));
}

TEST_CASE("two factors that are one under two names are refused") {
  const Scratch folder;
  folder.file("a.csv", "f,g,y\na,x,1\na,x,2\nb,y,3\nb,y,5\n");
  for (const bool additive : {false, true})
    CHECK_THROWS_WITH(analyse_scores(folder.path("a.csv"), {.additive = additive}),
                      Contains("the factors 'f' and 'g' have the same rows at each level"));
  CHECK(analyse_scores(folder.path("a.csv"), {.factors = {"f"}}).anova.find("f")->freedom == 1.0);
}

TEST_CASE("a level that is a number of another level in other digits is refused") {
  const Scratch folder;
  const auto read = [&](const std::string& rows) {
    folder.file("a.csv", "g,y\n" + rows);
    return analyse_scores(folder.path("a.csv"), {}).observations.factor("g").levels;
  };
  CHECK_THROWS_WITH(
      read("1,1\n2,2\n1.0,3\n2,4\n"),
      Contains("a.csv:4: the level '1.0' of 'g' is the number of the level '1'; write one of them"));
  CHECK_THROWS_WITH(read("1,1\n2,2\n01,3\n2,4\n"), Contains("the level '01'"));
  CHECK(read("1,1\n1a,2\n1,3\n1a,4\n") == std::vector<std::string>{"1", "1a"});
}

}  // namespace stepwire::study
