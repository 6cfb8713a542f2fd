#include <catch2/catch.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

void change(const Scratch& folder, const std::string& file, const std::string& what, const std::string& by) {
  std::string content = content_of(folder.path(file));
  const std::size_t at = content.find(what);
  REQUIRE(at != std::string::npos);
  folder.file(file, content.replace(at, what.size(), by));
}

}  // namespace

TEST_CASE("verify says that all bits of a run agree, also after the diagram has changed") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  change(folder, "lag.yaml", "tau", "tua");
  const Done done = run_program(folder, {"verify", "out/"});
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK(done.out ==
        "out/: 2 signals in 501 rows: all bits agree\n"
        "out/: claims and tables are not computed again: lag.yaml with the values of the run cannot be read "
        "now\n");
}

TEST_CASE("verify names the first number that differs and ends with 1, whatever the other folders are") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  for (const std::string out : {"one", "two"})
    REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", out}).code == 0);
  change(folder, "one/signals.csv", "\n0.002,1,0.0198", "\n0.002,1,0.0298");
  const Done done = run_program(folder, {"verify", "one", "two"});
  CHECK(done.code == 1);
  CHECK(lines_of(done.out).size() == 2);
  CHECK_THAT(done.out, Catch::StartsWith("one/signals.csv:4: lag at 0.002 s is 0.0298") &&
                           Contains(" and 0.0198") && Contains(" when it is replayed\ntwo: 2 signals"));
}

TEST_CASE("verify of what is no such folder ends with 2, of what cannot be read with 3") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const Done none = run_program(folder, {"verify", "none"});
  CHECK(none.code == 2);
  CHECK(none.err == "none: there is no such folder\n");
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  std::filesystem::remove(folder.path("out/diagram.yaml"));
  const Done missing = run_program(folder, {"verify", "out"});
  CHECK(missing.code == 2);
  CHECK_THAT(missing.err,
             Catch::StartsWith("out/diagram.yaml: is missing; verify needs all that 'run --out'"));
  std::filesystem::remove(folder.path("out/signals.csv"));
  std::filesystem::create_directory(folder.path("out/signals.csv"));
  CHECK(run_program(folder, {"verify", "out"}).code == 3);
}

TEST_CASE("verify compares numbers and words that a sweep keeps with HDF5, where there is no CSV") {
  const Scratch folder;
  folder.file("rows.csv", "time [s],x\n0,1\n2,3\n");
  folder.file("kept.yaml",
              "stepwire: 1\ntitle: t\nstep: 0.5 s\nstop: 2 s\nparameters: {way: linear, gain: 1}\nblocks:\n"
              "  a: {block: FromFile, file: rows.csv, column: x, interpolation: $way}\n"
              "  b: {block: Gain, u: a, gain: $gain}\nrecord: b\n"
              "sweep: {way: [hold, linear], gain: [1, 2, 3], keep: {top: max(b), ratio: mean(b)/gain}}\n");
  REQUIRE(run_program(folder, {"run", "kept.yaml", "--out", "out", "--files", "h5"}).code == 0);
  REQUIRE_FALSE(std::filesystem::exists(folder.path("out/signals.csv")));
  const Done done = run_program(folder, {"verify", "out"});
  INFO(done.err);
  CHECK(done.out == "out: 2 signals in 6 rows of 6 runs: all bits agree\n");
}

TEST_CASE("what an interrupted run has recorded is verified without waiting for its end") {
  const Scratch folder;
  folder.file("endless.yaml", endless_yaml);
  Call call;
  call.arguments = {"run", "endless.yaml", "--out", "out"};
  call.interrupt_after = 0.3;
  REQUIRE(run_program(folder, call).code == 130);
  const Done done = run_program(folder, {"verify", "out"});
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("all bits agree; the run ended early"));
}

TEST_CASE("verify judges the claims again, and names the first line of claims.json that differs") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml + "  - {that: it rises, final: lag, at_least: 0}\n");
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out", "--set", "tau=0.2 s"}).code < 2);
  CHECK(run_program(folder, {"verify", "out"}).out == "out: 2 signals in 501 rows: all bits agree\n");
  const std::string claims = content_of(folder.path("out/claims.json"));
  change(folder, "out/claims.json", "\"holds\": true", "\"holds\": false");
  const Done changed = run_program(folder, {"verify", "out"});
  INFO(changed.out << changed.err);
  CHECK(changed.code == 1);
  CHECK_THAT(changed.out,
             Contains("out/claims.json:8: the claim 'the lag gets there' has \"holds\": false, and "
                      "\"holds\": true when it is judged again"));
  folder.file("out/claims.json", claims);
  change(folder, "lag.yaml", "  lag:", "  other: {block: Constant, value: 1}\n  lag:");
  const Done other = run_program(folder, {"verify", "out"});
  CHECK(other.code == 1);
  CHECK_THAT(other.out, Contains("out/run.json:4: has the hash of another diagram than lag.yaml with"));
  std::filesystem::remove(folder.path("lag.yaml"));
  CHECK_THAT(run_program(folder, {"verify", "out"}).out,
             Contains("lag.yaml with the values of the run cannot be read"));
}

TEST_CASE("verify compares the functions of a run, and leaves out the claims of a version without them") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  const std::string note = content_of(folder.path("out/run.json"));
  change(folder, "out/run.json", "\"functions\": \"portable\"", "\"functions\": \"libm\"");
  const Done other = run_program(folder, {"verify", "out"});
  CHECK(other.code == 1);
  CHECK_THAT(other.out + other.err,
             Contains("has \"functions\": \"libm\", and diagram.yaml beside it has \"portable\""));
  folder.file("out/run.json", note);
  change(folder, "out/run.json", "  \"functions\": \"portable\",\n", "");
  const Done old = run_program(folder, {"verify", "out"});
  CHECK(old.code == 0);
  CHECK_THAT(old.out, Contains("all bits agree") &&
                          Contains("claims and tables are not computed again: the run is of a "
                                   "version without the key 'functions'"));
}

TEST_CASE("verify judges the claims of a sweep again") {
  const Scratch folder;
  folder.file("sweep.yaml",
              "stepwire: 1\ntitle: t\nstep: 0.5 s\nstop: 2 s\nparameters: {gain: 1}\nblocks:\n"
              "  a: {block: Clock}\n  b: {block: Gain, u: a, gain: $gain}\nrecord: b\n"
              "sweep: {gain: [1, 2, 3]}\nclaims:\n  - {that: it grows, each_run: true, final: b - 2*gain, "
              "equals: 0}\n");
  REQUIRE(run_program(folder, {"run", "sweep.yaml", "--out", "out"}).code == 0);
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
  change(folder, "out/claims.json", "\"value\": 0", "\"value\": 3");
  CHECK_THAT(run_program(folder, {"verify", "out"}).out, Contains("the claim 'it grows' has \"value\": 3"));
}

TEST_CASE("verify names a row that is missing at the end of any table, unless the run was interrupted") {
  const Scratch folder;
  folder.file("two.yaml",
              "stepwire: 1\nstep: 0.5 s\nstop: 2 s\nblocks: {t: {block: Clock}}\n"
              "record: [{signals: t}, {signals: t, every: 1 s}]\n");
  REQUIRE(run_program(folder, {"run", "two.yaml", "--out", "out"}).code == 0);
  change(folder, "out/signals-2.csv", "2,2\n", "");
  const Done last = run_program(folder, {"verify", "out"});
  CHECK(last.code == 1);
  CHECK_THAT(last.out, Contains("out/signals-2.csv:4: the row at 2 s is missing, and run.json does not say"));
  change(folder, "out/signals.csv", "1.5,1.5\n2,2\n", "");
  CHECK_THAT(run_program(folder, {"verify", "out"}).out, Contains("signals.csv:5: the row at 1.5 s is"));
  change(folder, "out/run.json", "\"interrupted\": false", "\"interrupted\": true");
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
}

TEST_CASE("verify refuses claims.json that is empty or gone where the diagram has claims") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  for (const std::string empty : {"[]", "{}"}) {
    folder.file("out/claims.json", empty);
    const Done done = run_program(folder, {"verify", "out"});
    CHECK(done.code == 1);
    CHECK_THAT(done.out, Contains("out/claims.json: has no claim, and lag.yaml has 1 claim"));
  }
  std::filesystem::remove(folder.path("out/claims.json"));
  const Done gone = run_program(folder, {"verify", "out"});
  CHECK(gone.code == 1);
  CHECK_THAT(gone.out, Contains("out/claims.json: is missing; every run writes it"));
}

TEST_CASE(
    "verify names the entry of run.json that is not that of the run, and a changed copy of the diagram") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out", "--set", "tau=0.2 s"}).code < 2);
  const std::string note = content_of(folder.path("out/run.json")),
                    flat = content_of(folder.path("out/diagram.yaml"));
  const auto says = [&](const std::string& from, const std::string& to, const std::string& sentence) {
    change(folder, "out/run.json", from, to);
    const Done done = run_program(folder, {"verify", "out"});
    INFO(done.out << done.err);
    CHECK(done.code == 1);
    CHECK_THAT(done.out, Contains("out/run.json:") && Contains(sentence));
    folder.file("out/run.json", note);
  };
  says("\"step\": 0.001", "\"step\": 0.002", "has \"step\": 0.002, and diagram.yaml beside it has 0.001");
  says("\"stop\": 0.5", "\"stop\": 1.5", "has \"stop\": 1.5");
  says("\"solver\": \"", "\"solver\": \"x", "has \"solver\": \"x");
  says("\"ticks\": 500", "\"ticks\": 400", "has \"ticks\": 400, and the run has 500");
  says("\"hash\": \"", "\"hash\": \"0", "has \"hash\": \"0");
  says("\"value\": 0.2", "\"value\": 0.3", "the parameter \"tau\" has \"value\": 0.3, and 0.2 by lag.yaml");
  says("\"written\": \"0.2 s", "\"written\": \"0.3 s", "has the hash of another diagram than lag.yaml");
  change(folder, "out/diagram.yaml", "title: ", "stop_when: lag > 9\ntitle: ");
  CHECK_THAT(run_program(folder, {"verify", "out"}).out, Contains("has \"hash\": "));
  folder.file("out/diagram.yaml", flat);
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
}

TEST_CASE("verify agrees with a run whose call had another step and solver") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out", "--set", "step=2 ms", "--set",
                               "solver=euler", "--stop", "0.2 s"})
              .code < 2);
  const Done done = run_program(folder, {"verify", "out"});
  CHECK(done.code == 0);
  CHECK(done.out ==
        "out: 2 signals in 101 rows: all bits agree\n"
        "out: lag.yaml has another step, stop or solver than the run, which its call may have set; "
        "those of the run are used\n");
}

TEST_CASE("verify tells that the step of the file has changed since the run") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code < 2);
  CHECK_THAT(run_program(folder, {"verify", "out"}).out, !Contains("another step"));
  change(folder, "lag.yaml", "solver: rk4", "solver: euler");
  const Done done = run_program(folder, {"verify", "out"});
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("lag.yaml has another step, stop or solver than the run"));
}

TEST_CASE("verify says that run.json is cut short, wherever it was cut") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  const std::string whole = content_of(folder.path("out/run.json"));
  for (const std::size_t left : {std::size_t{5}, whole.size() / 3, whole.size() / 2, whole.size() - 3}) {
    folder.file("out/run.json", whole.substr(0, left));
    const Done done = run_program(folder, {"verify", "out"});
    INFO(left << done.err);
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains("out/run.json:") && Contains("the text is cut short or was edited"));
  }
}
