#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/engine/app/cli/small_study.hpp"

using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("a study gives the same bits at any number of threads, compiled or not") {
  const Scratch folder;
  folder.file("a.yaml", small_study());
  REQUIRE(
      run_program(folder, {"study", "a.yaml", "--threads", "1", "--engine", "interpreted", "--out", "one"})
          .code == 0);
  REQUIRE(run_program(folder, {"study", "a.yaml", "--threads", "4", "--engine", "compiled", "--out", "four"})
              .code == 0);
  for (const char* name : {"/trials.csv", "/errors.csv", "/signals.csv", "/tables.txt", "/figure-2.svg"}) {
    INFO(name);
    CHECK(content_of(folder.path("one") + name) == content_of(folder.path("four") + name));
    CHECK_FALSE(content_of(folder.path("one") + name).empty());
  }
}

TEST_CASE("the trials of a study can be replayed, and analysed again as recorded ones") {
  const Scratch folder;
  folder.file("a.yaml", small_study());
  const Done done = run_program(folder, {"study", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  REQUIRE(done.code == 0);
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
  const Done again = run_program(folder, {"study", "a.yaml", "--trials", "out/trials.csv", "--out", "again"});
  INFO(again.err);
  CHECK(again.code == 0);
  CHECK_THAT(again.out, Contains("recorded trials"));
  const auto trials = json_file(folder, "out/study.json")["trials"],
             same = json_file(folder, "again/study.json")["trials"];
  REQUIRE(trials.size() == 24);
  for (std::size_t i = 0; i < trials.size(); ++i)
    CHECK(same[i]["error"].get<double>() == Approx(trials[i]["error"].get<double>()).epsilon(1e-6));
}

TEST_CASE("people are other people with another seed, and the same in a smaller group") {
  const Scratch folder;
  folder.file("a.yaml", small_study());
  run_program(folder, {"study", "a.yaml", "--out", "out"});
  run_program(folder, {"study", "a.yaml", "--subjects", "2", "--out", "two"});
  run_program(folder, {"study", "a.yaml", "--subjects", "2", "--seed", "2", "--out", "other"});
  const auto all = json_file(folder, "out/study.json")["trials"],
             two = json_file(folder, "two/study.json")["trials"],
             other = json_file(folder, "other/study.json")["trials"];
  REQUIRE(two.size() == 8);
  for (std::size_t i = 0; i < two.size(); ++i) {
    CHECK(two[i]["error"] == all[i]["error"]);
    CHECK(other[i]["error"] != all[i]["error"]);
  }
}

TEST_CASE("a trial that is not done in time is repeated with another noise, and told") {
  const Scratch folder;
  // The noise, one number for each attempt, decides whether a person finishes within the 4 s.
  std::string text = replaced(small_study(), "turned > 6.2832", "turned > 6.2832 && late < -0.3");
  text = replaced(text, "blocks:\n", "blocks:\n  late: {block: Noise, seed: $seed, every: 20 s}\n");
  folder.file("a.yaml", text);
  const Done done = run_program(folder, {"study", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK_THAT(done.out, Contains("not done within 4 s; done in attempt 2"));
  const auto trials = json_file(folder, "out/study.json")["trials"];
  int repeated = 0;
  for (const auto& trial : trials) repeated += trial["attempts"].get<int>() > 1;
  CHECK(repeated > 5);
  for (const auto& trial : trials) CHECK(trial["duration"].get<double>() < 4.0);
}

TEST_CASE("files of one study share its section and its experiment") {
  const Scratch folder;
  const std::string text = small_study();
  folder.file("a.yaml", text);
  std::string view =
      text.substr(0, text.find("study:\n")) + "study: {like: a.yaml}\n" + text.substr(text.find("blocks:\n"));
  folder.file("b.yaml", view);
  folder.file("c.yaml", replaced(replaced(view, "{like: a.yaml}", "{like: a.yaml, subjects: [3]}"),
                                 "subject == \"1\"", "subject == \"3\""));
  const Done done = run_program(folder, {"run", "a.yaml", "b.yaml", "--out", "out"});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK(content_of(folder.path("out/a/trials.csv")) == content_of(folder.path("out/b/trials.csv")));
  run_program(folder, {"study", "c.yaml", "--out", "three"});
  const auto three = json_file(folder, "three/study.json")["trials"],
             all = json_file(folder, "out/a/study.json")["trials"];
  REQUIRE(three.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(three[i]["error"] == all[8 + i]["error"]);
}

TEST_CASE("what is wrong with a study is told with its place before anything runs") {
  const Scratch folder;
  const auto error_of = [&](const std::string& from, const std::string& to) {
    folder.file("a.yaml", replaced(small_study(), from, to));
    const Done done = run_program(folder, {"check", "a.yaml"});
    CHECK(done.code == 2);
    return done.err;
  };
  CHECK_THAT(error_of("  position: hand", "  positon: hand"),
             Contains("study: the study has no 'positon'; did you mean 'position'?"));
  CHECK_THAT(error_of("  position: hand", "  position: hnad"),
             Contains("study.position: 'hnad' is not recorded; did you mean 'hand'?"));
  CHECK_THAT(error_of("{visual: 1}", "{visul: 1}"),
             Contains("study.conditions.V: there is no parameter 'visul'; did you mean 'visual'?"));
  CHECK_THAT(error_of("{visual: 1}", "{subject: 1}"),
             Contains("study.conditions.V: 'subject' is a factor of every study already"));
  CHECK_THAT(error_of("{visual: 1}", "{visual: 0.5}"), Contains("'0.5' is neither 1 (on) nor 0 (off)"));
  CHECK_THAT(error_of("x: center_x", "x: centre_x"),
             Contains("study.circle.sets.x: there is no parameter 'centre_x'; did you mean 'center_x'?"));
  CHECK_THAT(error_of("  position: hand", "  way_back: hand\n  position: hand"),
             Contains("study.way_back: a study is scored by 'circle' or by 'way_back', not both"));
  CHECK_THAT(error_of("subjects: 6", "subjects: [1, 1]"), Contains("'1' stands here twice"));
  CHECK_THAT(error_of("stop_when: turned > 6.2832\n", ""), Contains("This file has no 'stop_when'"));
  CHECK_THAT(error_of("where: subject == \"1\"", "where: subject == \"11\""),
             Contains("'subject' is never '11'"));
  CHECK_THAT(error_of("of: anova}", "of: anva}"),
             Contains("there is no table 'anva'; did you mean 'anova'?"));
  CHECK_THAT(error_of("  task: 1\n", "  task: 1\n  like: none.yaml\n"), Contains("study.like: "));
  CHECK_THAT(error_of("  - {that: seeing", "  - {that: none, final: mean.VH, at_most: 1}\n  - {that: seeing"),
             Contains("did you mean 'mean.H'?"));
}

TEST_CASE("study refuses a file without the section, and trials that do not fit it") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  CHECK_THAT(run_program(folder, {"study", "lag.yaml"}).err,
             Contains("has no section 'study'; it names task"));
  folder.file("a.yaml", small_study());
  folder.file("t.csv", "subject,task,condition,time [s],x [mm],y [mm]\nanna,1,VR,0,1,2\nanna,1,VR,1,2,3\n");
  const Done done = run_program(folder, {"study", "a.yaml", "--trials", "t.csv"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("t.csv: subject anna: there is no condition 'VR' in the study"));
  CHECK(run_program(folder, {"study", "a.yaml", "--trials", "none.csv"}).code == 3);
}

TEST_CASE("experiments are repeated with other people; the same call goes on with what is there") {
  const Scratch folder;
  folder.file("a.yaml", small_study());
  REQUIRE(run_program(folder, {"study", "a.yaml", "--repeat", "3", "--threads", "1", "--out", "few"}).code ==
          0);
  const Done more =
      run_program(folder, {"study", "a.yaml", "--repeat", "6", "--threads", "2", "--out", "few"});
  CHECK_THAT(more.out, Contains("Task 1: mean errors in 6 experiments"));
  REQUIRE(run_program(folder, {"study", "a.yaml", "--repeat", "6", "--threads", "2", "--out", "many"}).code ==
          0);
  CHECK(content_of(folder.path("few/experiments.csv")) == content_of(folder.path("many/experiments.csv")));
  CHECK(lines_of(content_of(folder.path("many/experiments.csv"))).size() == 7);
  CHECK_THAT(content_of(folder.path("many/experiments.svg")), Contains("published: 0.698"));
  const Done other =
      run_program(folder, {"study", "a.yaml", "--subjects", "3", "--repeat", "6", "--out", "many"});
  CHECK(other.code == 2);
  CHECK_THAT(other.err, Contains("has experiments of another study"));
}

TEST_CASE("an interrupted study leaves nothing half-written") {
  const Scratch folder;
  folder.file("a.yaml",
              replaced(replaced(small_study(), "stop: 4 s", "stop: 400 s"), "slope: 2.5", "slope: 0.016"));
  Call call;
  call.arguments = {"study", "a.yaml", "--subjects", "1000", "--out", "out"};
  call.interrupt_after = 1.0;
  CHECK(run_program(folder, call).code == 130);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("out")))
    CHECK(entry.path().filename() == ".stepwire");  // the list of what a run has written
}

TEST_CASE("verify computes trials, errors and tables of a study again") {
  const Scratch folder;
  folder.file("study.yaml", small_study());
  REQUIRE(
      run_program(folder, {"study", "study.yaml", "--subjects", "4", "--seed", "7", "--out", "out"}).code <
      2);
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
  for (const std::string file : {"trials.csv", "errors.csv", "tables.txt"}) {
    const std::string text = content_of(folder.path("out/" + file));
    std::string other = text;
    const std::size_t digit = other.find_last_of("12345678");
    REQUIRE(digit != std::string::npos);
    ++other[digit];
    folder.file("out/" + file, other);
    const Done changed = run_program(folder, {"verify", "out"});
    INFO(file << "\n" << changed.out << changed.err);
    CHECK(changed.code == 1);
    CHECK_THAT(changed.out,
               Catch::Contains("out/" + file + ":") && Catch::Contains("when it is computed again"));
    folder.file("out/" + file, text);
  }
}
