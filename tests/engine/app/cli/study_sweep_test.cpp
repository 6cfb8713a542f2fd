#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/engine/app/cli/small_study.hpp"

using Catch::Contains;

namespace {

/// Returns the small study with a parameter `learnt`, which scales the benefit of haptic feedback.
std::string learning_study() {
  const std::string text =
      replaced(small_study(), "(1 + 2*haptic + 4*visual)", "(1 + 2*learnt*haptic + 4*visual)");
  return replaced(text, "  sway: ", "  learnt: {value: 1, doc: how well it is felt}\n  sway: ");
}

std::string swept(const std::string& axes) {
  const std::string text = replaced(learning_study(), "study:\n", "sweep: {" + axes + "}\nstudy:\n");
  return replaced(text, "{plot: table, of: anova}", "{plot: table, of: means}");
}

/// A sweep whose points are of several plans: each holds the noise for another time.
std::string of_several_plans() {
  std::string text = replaced(swept("hold: [50 ms, 40 ms, 30 ms, 20 ms]"), "every: 50 ms}", "every: $hold}");
  text = replaced(text, "  sway: ", "  hold: {value: 50 ms, doc: how long a noise stays}\n  sway: ");
  return text.substr(0, text.find("claims:\n"));
}

/// All diagrams of a folder, and what each run sets in which of them.
std::vector<std::string> replayed_files(const std::string& folder) {
  std::vector<std::string> files{content_of(folder + "/sweep.csv")};
  for (std::size_t i = 1; std::filesystem::exists(folder + fmt::format("/diagrams/{:04}.yaml", i)); ++i)
    files.push_back(content_of(folder + fmt::format("/diagrams/{:04}.yaml", i)));
  return files;
}

/// The value of a column in a row of a CSV file, 0 for the first one below the header.
std::string cell(const std::string& file, const std::string& column, std::size_t row) {
  const auto lines = lines_of(content_of(file));
  const auto fields = [&](const std::string& line) {
    std::vector<std::string> all{""};
    for (const char c : line) c == ',' ? all.emplace_back() : all.back() += c;
    return all;
  };
  const auto head = fields(lines.at(0));
  for (std::size_t i = 0; i < head.size(); ++i)
    if (head[i] == column) return fields(lines.at(row + 1)).at(i);
  FAIL(file << " has no column " << column << ": " << lines.at(0));
  return {};
}

}  // namespace

TEST_CASE("each point of a swept study is the study that the file alone makes with these values") {
  const Scratch folder;
  folder.file("a.yaml", swept("learnt: [1, 3]"));
  folder.file("one.yaml", learning_study());
  const Done done = run_program(folder, {"study", "a.yaml", "--out", "both"});
  INFO(done.err << done.out);
  REQUIRE(done.code == 0);
  REQUIRE(run_program(folder, {"study", "one.yaml", "--out", "first"}).code == 0);
  REQUIRE(run_program(folder, {"study", "one.yaml", "--set", "learnt=3", "--out", "second"}).code == 0);
  const std::string first = content_of(folder.path("first/trials.csv"));
  const std::string second = content_of(folder.path("second/trials.csv"));
  CHECK(first != second);
  CHECK(content_of(folder.path("both/trials.csv")) == first);
  CHECK(content_of(folder.path("both/trials-2.csv")) == second);
  const auto points = json_file(folder, "both/study.json")["points"];
  REQUIRE(points.size() == 2);
  CHECK(points[1]["sets"]["learnt"] == "3");
  CHECK(points[1]["analysis"]["means"] == json_file(folder, "second/study.json")["analysis"]["means"]);
}

TEST_CASE("a claim on a mean that is not published is refused at its place, with what would publish it") {
  const Scratch folder;
  const std::string text = small_study();
  const std::size_t begin = text.find("  published:"), end = text.find("blocks:\n");
  REQUIRE(begin < end);
  const std::string bare = text.substr(0, begin) + text.substr(end);
  folder.file("a.yaml", bare + "  - {that: as published, final: mean.HV - published.HV, at_most: 0}\n");
  const Done done = run_program(folder, {"check", "a.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("a.yaml:" + std::to_string(lines_of(bare).size() + 1) + ":") &&
                           Contains("'published.HV' is not recorded"));
  folder.file("b.yaml", text + "  - {that: as published, final: mean.HV - published.HV, at_most: 1}\n");
  CHECK(run_program(folder, {"check", "b.yaml"}).code == 0);
}

TEST_CASE(
    "a swept study gives the same bits at any number of threads, compiled or not, and can be replayed") {
  const Scratch folder;
  folder.file("a.yaml", swept("learnt: [1, 2], radius: [15 mm, 20 mm]"));
  REQUIRE(
      run_program(folder, {"study", "a.yaml", "--threads", "1", "--engine", "interpreted", "--out", "one"})
          .code == 0);
  REQUIRE(run_program(folder, {"study", "a.yaml", "--threads", "4", "--engine", "compiled", "--out", "four"})
              .code == 0);
  for (const char* name : {"/trials-4.csv", "/errors.csv", "/signals.csv", "/signals-3.csv", "/tables.txt"}) {
    INFO(name);
    CHECK(content_of(folder.path("one") + name) == content_of(folder.path("four") + name));
  }
  const Done verified = run_program(folder, {"verify", "four"});
  CHECK(verified.code == 0);
  CHECK_THAT(verified.out, Contains("of 96 runs: all bits agree"));
}

TEST_CASE("the diagrams that a swept study leaves hang neither on its threads nor on what was compiled",
          "[full]") {
  const Scratch folder;
  folder.file("a.yaml", of_several_plans());
  const auto files_of = [&](const std::string& threads, const std::string& engine) {
    const std::string out = threads + engine;
    REQUIRE(run_program(folder, {"study", "a.yaml", "--threads", threads, "--engine", engine, "--out", out})
                .code == 0);
    return replayed_files(folder.path(out));
  };
  const auto files = files_of("1", "interpreted");
  CHECK(files.size() > 4);
  CHECK_THAT(lines_of(files.front()).at(1), Catch::StartsWith("diagrams/0001.yaml,"));
  for (const std::string threads : {"2", "3", "4"}) CHECK(files == files_of(threads, "interpreted"));
  CHECK(files == files_of("4", "compiled"));
  CHECK_THAT(run_program(folder, {"verify", "4interpreted"}).out, Contains("of 96 runs: all bits agree"));
}

TEST_CASE("tables of a swept study have the swept values, and say which statements hold at each point") {
  const Scratch folder;
  // With learnt = 4 haptic feedback helps more than visual feedback: V > HV still holds, H > V does not.
  folder.file("a.yaml", swept("together: true, learnt: [1, 4], radius: [20 mm, 15 mm]"));
  REQUIRE(run_program(folder, {"study", "a.yaml", "--out", "out"}).code == 0);
  const std::string errors = folder.path("out/errors.csv"), outcome = folder.path("out/signals-3.csv");
  CHECK(cell(errors, "learnt", 0) == "1");
  CHECK(cell(errors, "radius [m]", 24) == "0.015");
  CHECK(lines_of(content_of(outcome)).size() == 3);
  CHECK(cell(outcome, "radius [m]", 1) == "0.015");
  CHECK(cell(outcome, "published.NO", 1) == "0.698");
  const std::string tables = content_of(folder.path("out/tables.txt"));
  const auto lines = lines_of(tables.substr(tables.find("Mean normalised errors")));
  CHECK_THAT(lines.at(3), Catch::StartsWith("1 ") && Contains("holds"));
  CHECK_THAT(lines.at(4), Catch::StartsWith("4 ") && Contains("fails"));
  CHECK_THAT(lines.at(6), Contains("(1) Published: order NO > H > V > HV."));
  CHECK_THAT(tables, Contains("1: radius=20 mm.") && Contains("4: radius=15 mm."));
  CHECK_THAT(tables,
             Contains("\n1       NO ") && Contains("\n4       NO "));  // of errors, those of each point
}

TEST_CASE("claims about a swept study are judged at each point, of which the worst is told") {
  const Scratch folder;
  folder.file("a.yaml",
              replaced(swept("learnt: [1, 4]"), "claims:\n",
                       "claims:\n  - {that: seen, final: mean.H - mean.V, at_least: 0}\n"
                       "  - {that: once, where: learnt < 2, final: mean.H - mean.V, at_least: 0}\n"));
  const Done done = run_program(folder, {"study", "a.yaml"});
  CHECK(done.code == 1);
  CHECK_THAT(done.out, Contains("FAIL seen") && Contains("ok   once") && Contains("the worst of 2 runs"));
}

TEST_CASE("a trial is held against the circle that is fitted to the first drawing of the same subject") {
  const Scratch folder;
  folder.file("a.yaml", small_study());
  REQUIRE(run_program(folder, {"study", "a.yaml", "--out", "out"}).code == 0);
  const auto trials = json_file(folder, "out/study.json")["trials"];
  for (const std::size_t trial : {1u, 3u, 6u}) {
    const std::string radius = trials.at(trial)["sets"]["radius"].get<std::string>();
    CHECK(std::stod(cell(folder.path("out/signals-2.csv"), "circle.radius [m]", trial)) ==
          std::stod(radius));  // "0.02 m"
  }
}

TEST_CASE("the worst of runs whose values go together is named by what tells it apart") {
  const Scratch folder;
  folder.file(
      "a.yaml",
      "stepwire: 1\nstep: 1 s\nstop: 1 s\nparameters: {place: {value: here}, a: {value: 1}, b: {value: 1}}\n"
      "sweep: {together: true, place: [here, there], a: [1, 2], b: [3, 4]}\n"
      "blocks: {c: {block: Constant, value: $a}}\nrecord: c\n"
      "claims: [{that: small, max: c, at_most: 1}, {that: large, max: c*(place == \"here\"), at_most: 0}]\n");
  const Done done = run_program(folder, {"run", "a.yaml"});
  CHECK_THAT(done.out, Contains("(place=there)") && Contains("(place=here)") && !Contains("a=2"));
}

TEST_CASE("what makes no sense of a swept study is refused in words") {
  const Scratch folder;
  const auto error_of = [&](const std::string& text, std::vector<std::string> more) {
    folder.file("a.yaml", text);
    more.insert(more.begin(), {"study", "a.yaml"});
    const Done done = run_program(folder, {more});
    CHECK(done.code == 2);
    return done.err;
  };
  CHECK_THAT(error_of(swept("subject: [1, 2]"), {}),
             Contains("sweep.subject: the study sets this for each trial"));
  CHECK_THAT(error_of(swept("haptic: [0, 1]"), {}), Contains("sweep.haptic: the study sets this"));
  CHECK_THAT(error_of(swept("learned: [0, 1]"), {}), Contains("did you mean 'learnt'?"));
  CHECK_THAT(error_of(swept("radius: [20 mm, -1 mm]"), {}), Contains("-1 mm is not allowed"));
  CHECK_THAT(error_of(replaced(swept("learnt: [1, 2]"), "of: means", "of: anvoa"), {}),
             Contains("there is no table 'anvoa'"));
  folder.file("t.csv", "subject,task,condition,time [s],x [mm],y [mm]\nanna,1,NO,0,1,2\nanna,1,NO,1,2,3\n");
  CHECK_THAT(error_of(swept("learnt: [1, 2]"), {"--trials", "t.csv"}),
             Contains("the trials of t.csv were recorded as they are, and 'sweep' would change nothing"));
}

TEST_CASE("a swept parameter that is set has one value, and that one study can be repeated") {
  const Scratch folder;
  folder.file("a.yaml", swept("learnt: [1, 2]"));
  const Done one = run_program(folder, {"study", "a.yaml", "--set", "learnt=4", "--out", "one"});
  CHECK(one.code == 0);
  CHECK(json_file(folder, "one/study.json")["points"].size() == 1);
  CHECK(run_program(folder, {"study", "a.yaml", "--set", "learnt=4", "--repeat", "2", "--out", "two"}).code ==
        0);
}

TEST_CASE("verify analyses recorded trials again") {
  const Scratch folder;
  folder.file("a.yaml", small_study());
  REQUIRE(run_program(folder, {"study", "a.yaml", "--subjects", "3", "--out", "out"}).code == 0);
  REQUIRE(run_program(folder, {"study", "a.yaml", "--trials", "out/trials.csv", "--out", "again"}).code == 0);
  const Done good = run_program(folder, {"verify", "again"});
  CHECK(good.code == 0);
  CHECK(good.out == "again: errors and tables of the recorded trials: all bits agree\n");
  const std::string errors = content_of(folder.path("again/errors.csv"));
  folder.file("again/errors.csv", replaced(errors, ",H,", ",V,"));
  const Done bad = run_program(folder, {"verify", "again"});
  CHECK(bad.code == 1);
  CHECK_THAT(bad.out,
             Contains("again/errors.csv:3: is '1,V,") && Contains("but the recorded trials give '1,H,"));
  folder.file("again/errors.csv", errors);
  const std::string trials = content_of(folder.path("again/recorded.csv"));
  folder.file("again/recorded.csv", replaced(trials, ",0.06,", ",0.06,1"));
  CHECK(run_program(folder, {"verify", "again"}).code == 1);
}
