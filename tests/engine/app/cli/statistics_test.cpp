#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

/// Effort to rise from four stools by nine subjects; R: nlme::ergoStool.
std::string stools() {
  const int scores[9][4]{{7, 11, 8, 7},  {8, 11, 8, 7},   {7, 11, 10, 9},   {9, 13, 10, 8},  {9, 11, 11, 10},
                         {7, 14, 13, 9}, {8, 12, 12, 11}, {12, 15, 12, 10}, {10, 14, 13, 12}};
  std::string text = "person;stool;effort\n";
  for (int person = 0; person < 9; ++person)
    for (int stool = 0; stool < 4; ++stool)
      text += "P" + std::to_string(person) + ";T" + std::to_string(stool) + ";" +
              std::to_string(scores[person][stool]) + "\n";
  return text;
}

}  // namespace

TEST_CASE("statistics prints tables of a table of scores, and leaves them in a folder") {
  // summary(aov(effort ~ Type + Error(Subject/Type), ergoStool)): F(3, 24) = 22.36, P = 3.93e-07
  const Scratch folder;
  folder.file("stools.csv", stools());
  const Done done = run_program(folder, {"statistics", "stools.csv", "--subject", "person", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("Repeated measures") && Contains("22.36") && Contains("3.93e-07"));
  CHECK_THAT(done.out, Contains("T0 - T1") && !Contains("simulated"));
  const nlohmann::json found = nlohmann::json::parse(content_of(folder.path("out/statistics.json")));
  CHECK(found["within"] == nlohmann::json{"stool"});
  CHECK(found["repeated_measures"]["terms"][0]["sphericity"]["mauchly_W"].get<double>() ==
        Approx(0.1796005467).epsilon(1e-9));
  CHECK_THAT(content_of(folder.path("out/tables.txt")), Contains("Cells of effort"));
}

TEST_CASE("statistics of independent scores is for programs as well") {
  const Scratch folder;
  folder.file("stools.csv", stools());
  const Done done = run_program(folder, {"statistics", "stools.csv", "--factors", "stool", "--json"});
  CHECK(done.code == 0);
  const nlohmann::json found = nlohmann::json::parse(done.out);
  CHECK(found["anova"]["terms"][0]["degrees_of_freedom"] == 3.0);
  CHECK(found["subject"].is_null());
  CHECK(found["within_subjects"].is_null());
}

TEST_CASE("statistics refuses a column that is not there, with those that are") {
  const Scratch folder;
  folder.file("stools.csv", stools());
  const Done done = run_program(folder, {"statistics", "stools.csv", "--score", "efort"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("no column 'efort' for --score; did you mean 'effort'? There are: person, stool, effort"));
  CHECK(run_program(folder, {"statistics", "gone.csv"}).code == 2);
}

TEST_CASE("statistics names a bad score by its line and column") {
  const Scratch folder;
  for (const std::string bad : {"nan", "inf", "four", ""}) {
    folder.file("scores.csv", "device;error\na;1\nb;2\na;" + bad + "\nb;3\n");
    const Done done = run_program(folder, {"statistics", "scores.csv"});
    INFO(done.err);
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains("scores.csv:4: ") && Contains("(column 'error')"));
  }
}

TEST_CASE("statistics compares pairs of independent groups") {
  // R: t.test(weight ~ group, PlantGrowth, subset = group != "trt2"): t = 1.1913, df = 16.524, p-value =
  // 0.2504, 95 percent confidence interval -0.2875162 1.0295162
  const Scratch folder;
  std::string text = "group;weight\n";
  for (const char* weight : {"4.17", "5.58", "5.18", "6.11", "4.50", "4.61", "5.17", "4.53", "5.33", "5.14"})
    text += std::string("ctrl;") + weight + "\n";
  for (const char* weight : {"4.81", "4.17", "4.41", "3.59", "5.87", "3.83", "6.03", "4.89", "4.32", "4.69"})
    text += std::string("trt1;") + weight + "\n";
  folder.file("plants.csv", text + "alone;5\n");
  const Done done = run_program(folder, {"statistics", "plants.csv", "--json"});
  INFO(done.err);
  const nlohmann::json pairs = nlohmann::json::parse(done.out)["groups"];
  REQUIRE(pairs.size() == 3);
  CHECK(pairs[0]["first"] == "ctrl");
  CHECK(pairs[0]["t"].get<double>() == Approx(1.1913).epsilon(1e-4));
  CHECK(pairs[0]["degrees_of_freedom"].get<double>() == Approx(16.524).epsilon(1e-4));
  CHECK(pairs[0]["P"].get<double>() == Approx(0.2504).epsilon(1e-3));
  CHECK(pairs[0]["low"].get<double>() == Approx(-0.2875162).epsilon(1e-6));
  CHECK(pairs[0]["high"].get<double>() == Approx(1.0295162).epsilon(1e-6));
  CHECK(pairs[0]["P_holm"] == pairs[0]["P"]);
  CHECK(pairs[1]["t"].is_null());
  CHECK_THAT(run_program(folder, {"statistics", "plants.csv"}).out,
             Contains("ctrl - trt1") && Contains("16.52"));
}

TEST_CASE("residuals of two subjects under two conditions are not judged, since all have one size") {
  const Scratch folder;
  folder.file("few.csv", "person,device,error\n1,a,2\n1,b,3\n2,a,2.5\n2,b,4\n");
  const Done done = run_program(
      folder, {"statistics", "few.csv", "--score", "error", "--factors", "device", "--subject", "person"});
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("residuals: normality is not judged") && !Contains("W = "));
}
