#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/engine/app/cli/small_study.hpp"

using Catch::Contains;

namespace {

std::string with_experiments(int count, const std::string& text = small_study()) {
  return replaced(text, "  seed: 1\n", "  seed: 1\n  experiments: " + std::to_string(count) + "\n");
}

/// Means of the file's own experiment with another seed.
nlohmann::json means_of_seed(const Scratch& folder, int seed) {
  const std::string out = "seed-" + std::to_string(seed);
  folder.file("one.yaml", small_study());
  REQUIRE(run_program(folder, {"study", "one.yaml", "--seed", std::to_string(seed), "--out", out}).code == 0);
  return json_file(folder, out + "/study.json")["analysis"]["means"];
}

}  // namespace

TEST_CASE("each experiment of a file is the study that its seed alone makes") {
  const Scratch folder;
  folder.file("a.yaml", with_experiments(3));
  const Done done = run_program(folder, {"study", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  REQUIRE(done.code == 0);
  const auto study = json_file(folder, "out/study.json");
  REQUIRE(study["experiments"].size() == 3);
  for (int i = 0; i < 3; ++i) {
    const auto means = means_of_seed(folder, 1 + i);
    CHECK(study["experiments"][i]["seed"] == 1 + i);
    for (const char* condition : {"NO", "H", "V", "HV"})
      CHECK(study["experiments"][i][std::string("mean.") + condition] == means[condition]);
  }
  CHECK(content_of(folder.path("out/trials.csv")) == content_of(folder.path("seed-1/trials.csv")));
  CHECK_THAT(done.out, Contains("Task 1: mean errors in 3 experiments"));
}

TEST_CASE("an experiment that was edited is refused, and one that was cut is performed again") {
  const Scratch folder;
  folder.file("a.yaml", with_experiments(3));
  const std::vector<std::string> call{"study", "a.yaml", "--out", "out"};
  REQUIRE(run_program(folder, call).code == 0);
  const std::string kept = content_of(folder.path("out/experiments.csv"));
  folder.file("out/experiments.csv", kept.substr(0, kept.size() - 10));
  REQUIRE(run_program(folder, call).code == 0);
  CHECK(content_of(folder.path("out/experiments.csv")) == kept);
  std::string edited = kept;
  char& digit = edited[edited.find('.', edited.find("\n2,")) + 1];
  digit = digit == '9' ? '8' : '9';
  folder.file("out/experiments.csv", edited);
  for (const std::string verb : {"verify", "study"}) {  // the study removes what the run before left
    const Done done = run_program(folder, verb == "study" ? call : std::vector<std::string>{"verify", "out"});
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains("experiments.csv:3: this experiment is not as it was written") &&
                             Contains("delete the line; it is performed again"));
  }
}

TEST_CASE("experiments are not read through a link") {
  const Scratch folder;
  folder.file("a.yaml", with_experiments(2));
  const std::vector<std::string> call{"study", "a.yaml", "--out", "out"};
  REQUIRE(run_program(folder, call).code == 0);
  std::filesystem::rename(folder.path("out/experiments.csv"), folder.path("away.csv"));
  std::filesystem::create_symlink(folder.path("away.csv"), folder.path("out/experiments.csv"));
  const std::string before = content_of(folder.path("away.csv"));
  const Done done = run_program(folder, call);
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("out/experiments.csv: is a link"));
  CHECK(content_of(folder.path("away.csv")) == before);
}

TEST_CASE("a folder of several experiments is replayed by its first, and the others are named") {
  const Scratch folder;
  folder.file("a.yaml", with_experiments(3));
  REQUIRE(run_program(folder, {"study", "a.yaml", "--out", "out"}).code == 0);
  const Done done = run_program(folder, {"verify", "out"});
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("all bits agree") &&
                           Contains("replayed is experiment 1 (seed 1); not replayed are 2 others (seeds 2, "
                                    "3) of experiments.csv"));
  REQUIRE(run_program(folder, {"study", "a.yaml", "--repeat", "1", "--out", "one"}).code == 0);
  CHECK_THAT(run_program(folder, {"verify", "one"}).out, !Contains("experiment"));
}

TEST_CASE("the tables of one experiment among several say which it is, and one alone has none of several") {
  const Scratch folder;
  folder.file("a.yaml", with_experiments(3));
  REQUIRE(run_program(folder, {"study", "a.yaml", "--out", "out"}).code == 0);
  const std::string tables = content_of(folder.path("out/tables.txt"));
  CHECK_THAT(tables, Contains("Analysis of variance of task 1 of experiment 1 of 3 (seed 1)"));
  CHECK_THAT(tables, Contains("mean errors in 3 experiments (simulated operators)"));
  REQUIRE(run_program(folder, {"study", "a.yaml", "--repeat", "1", "--out", "one"}).code == 0);
  CHECK_THAT(content_of(folder.path("one/tables.txt")),
             !Contains("in 1 experiment") && !Contains("of experiment 1") && !Contains("other people"));
}

TEST_CASE("the option says how many experiments there are in place of the file") {
  const Scratch folder;
  folder.file("a.yaml", with_experiments(2));
  REQUIRE(run_program(folder, {"study", "a.yaml", "--repeat", "4", "--out", "out"}).code == 0);
  CHECK(json_file(folder, "out/study.json")["experiments"].size() == 4);
  CHECK_THAT(run_program(folder, {"study", "a.yaml", "--repeat", "1"}).out, !Contains("experiments"));
}

TEST_CASE("claims and figures read a row of each experiment") {
  const Scratch folder;
  folder.file("a.yaml",
              with_experiments(
                  4, replaced(small_study(), "claims:\n",
                              "  - {plot: box, y: [mean.NO, mean.HV], reference: [published.NO, "
                              "published.HV]}\n  - {plot: table, of: experiments_significance}\nclaims:\n"
                              "  - {that: rows, mean: experiment, equals: 2.5}\n"
                              "  - {that: all, fraction: mean.V < mean.NO, equals: 1}\n"
                              "  - {that: second, where: experiment == 2, fraction: mean.V > mean.NO, "
                              "equals: 0}\n"
                              "  - {that: median, quantile: {share: 50 %, value: experiment}, equals: "
                              "2.5}\n")));
  const Done done = run_program(folder, {"study", "a.yaml", "--out", "out"});
  INFO(done.out << done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("4 of 4"));
  CHECK(lines_of(content_of(folder.path("out/signals-3.csv"))).size() == 5);
  CHECK_THAT(content_of(folder.path("out/figure-5.svg")), Contains("of 4"));
}

TEST_CASE("experiments that were made with other blocks from outside are no longer gone on with", "[full]") {
  const Scratch folder;
  std::filesystem::create_directories(folder.path("own"));
  const auto write_law = [&](const std::string& factor) {
    folder.file("own/law.hpp", "#pragma once\ninline double law(double u) { return " + factor + " * u; }\n");
  };
  write_law("1.0");
  folder.file("own/shake.cpp", R"(#include <stepwire/block.hpp>
#include <stepwire/declare.hpp>
#include <stepwire/registry.hpp>
#include "law.hpp"
struct Shake {
  stepwire::Input<1> u{};
  stepwire::Output<1> y{};
  void outputs() { y = law(u); }
  static void declare(stepwire::Declare<Shake>& is) {
    is.block("Shake", {.doc = "A law."});
    is.input<&Shake::u>({.unit = "'u", .doc = "signal"});
    is.output<&Shake::y>({.unit = "'u", .doc = "by the law"});
  }
};
void register_blocks(stepwire::Registry& registry) { registry.add<Shake>("own"); }
)");
  folder.file("a.yaml", replaced(with_experiments(2), "  far:    {block: Sum, u: [swaying,",
                                 "  shaken: {block: Shake, u: swaying}\n  far:    {block: Sum, u: [shaken,"));
  const std::vector<std::string> call{"study", "a.yaml", "--blocks", "own",
                                      "--out", "out",    "--engine", "interpreted"};
  REQUIRE(run_program(folder, call).err.empty());
  CHECK(run_program(folder, call).err.empty());
  write_law("2.0");
  const Done other = run_program(folder, call);
  CHECK(other.code == 2);
  CHECK_THAT(other.err, Contains("has experiments of another study"));
}

TEST_CASE("experiments of a file go on where they were interrupted", "[full]") {
  const Scratch folder;
  const std::string slow =
      replaced(replaced(with_experiments(300), "stop: 4 s", "stop: 400 s"), "slope: 2.5", "slope: 0.1");
  folder.file("a.yaml", slow.substr(0, slow.find("claims:")));  // other people may break them
  Call call;
  call.arguments = {"study", "a.yaml", "--subjects", "2", "--out", "out"};
  call.interrupt_after = 1.5;
  const Done done = run_program(folder, call);
  REQUIRE(done.code == 130);
  CHECK_THAT(done.out, Contains("the same call goes on"));
  const std::string kept = content_of(folder.path("out/experiments.csv"));
  const std::size_t there = lines_of(kept).size() - 1;
  REQUIRE(there > 0);
  REQUIRE(there < 300);
  const std::string count = std::to_string(there + 2);
  call.arguments.insert(call.arguments.end(), {"--repeat", count});
  call.interrupt_after.reset();
  REQUIRE(run_program(folder, call).code == 0);
  const std::string more = content_of(folder.path("out/experiments.csv"));
  REQUIRE(
      run_program(folder, {"study", "a.yaml", "--subjects", "2", "--repeat", count, "--out", "anew"}).code ==
      0);
  CHECK(more == content_of(folder.path("anew/experiments.csv")));
}

TEST_CASE("experiments are made at each point of a sweep, with the same people at each", "[full]") {
  const Scratch folder;
  const std::string text = replaced(replaced(with_experiments(3), "10 mm * log", "shake * log"),
                                    "  sway:", "  shake: {value: 10 mm, doc: sway}\n  sway:");
  folder.file("a.yaml", replaced(replaced(text, "study:\n", "sweep: {shake: [10 mm, 5 mm]}\nstudy:\n"),
                                 "{plot: table, of: anova}", "{plot: table, of: means}"));
  const Done done = run_program(folder, {"study", "a.yaml", "--out", "out"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const auto points = json_file(folder, "out/study.json")["points"];
  for (int i = 0; i < 3; ++i)
    CHECK(points[0]["experiments"][i]["mean.NO"] == means_of_seed(folder, 1 + i)["NO"]);
  CHECK(lines_of(content_of(folder.path("out/signals-3.csv"))).size() == 7);
  CHECK(lines_of(content_of(folder.path("out/experiments.csv"))).size() == 7);
}
