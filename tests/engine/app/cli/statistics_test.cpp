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
  CHECK_THAT(done.err, Contains("no column 'efort' for --score; there are: person, stool, effort"));
  CHECK(run_program(folder, {"statistics", "gone.csv"}).code == 3);
}
