// Rows of sweeps that go from run to run into a file, and what needs them all at once.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "engine/base/data_file/data_file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

/// A lag for half a second, to which a swept time constant belongs, with claims of each kind.
std::string claimed_yaml() {
  return lag_yaml.substr(0, lag_yaml.find("figure:")) +
    "sweep: {tau: {from: 10 ms, to: 120 ms, count: 12}}\n"
    "figure: {plot: xy, x: tau in ms, y: lag, rows: final}\n"
    "claims:\n"
    "  - {that: a, final: lag, at_least: 0.9}\n"
    "  - {that: b, max: lag, at_most: 1}\n"
    "  - {that: c, mean: lag, between: [0, 1]}\n"
    "  - {that: d, rms: lag, where: tau > 50 ms, between: [0, 1]}\n"
    "  - {that: e, spread: lag, equals: 1, within: 0.1}\n"
    "  - {that: f, fraction: lag > 0.5, at_least: 0.5}\n"
    "  - {that: g, count: lag > 0.5, equals: 12}\n"
    "  - {that: h, at: {time: 100 ms, value: lag}, at_least: 0.1}\n"
    "  - {that: i, fraction_of_runs: rise_time(lag) < 100 ms, at_least: 0.1}\n"
    "  - {that: j, quantile_of_runs: {share: 50 %, value: final(lag)*tau}, at_least: 0}\n";
}

void check_same(const Scratch& folder, const std::string& file, const std::string& a, const std::string& b) {
  INFO(file << " of " << a << " and " << b);
  const std::string content = content_of(folder.path(a + "/" + file));
  CHECK_FALSE(content.empty());
  CHECK(content == content_of(folder.path(b + "/" + file)));
}

/// A sweep of 40 runs with 8 million numbers.
std::string large_yaml(const std::string& more) {
  return "stepwire: 1\ntitle: many rows\nstep: 1 ms\nstop: 100 s\nsolver: rk4\nblocks:\n"
         "  lag: {block: Lag, u: 1, tau: 10 ms}\nrecord: [lag]\n"
         "sweep: {lag.tau: {from: 10 ms, to: 50 ms, count: 40}}\n" +
         more;
}

/// Runs the program with a data segment of at most `megabytes` (ulimit -d).
stepwire::subprocess::ProcessResult run_within(int megabytes, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"sh", "-c", "ulimit -d " + std::to_string(megabytes * 1024) + " && exec \"$0\" \"$@\"",
                                   STEPWIRE_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return stepwire::subprocess::run_process({.command = command});
}

}  // namespace

TEST_CASE("rows that are written run by run, claims and figures are those of a sweep that is held in memory") {
  const Scratch folder;
  folder.file("sweep.yaml", claimed_yaml());
  const Done held = run_program(folder, {"run", "sweep.yaml", "--out", "held", "--files", "csv,h5,mcap"});
  INFO(held.err << held.out);
  REQUIRE(held.code == 0);
  REQUIRE(run_program(folder, {"run", "sweep.yaml", "--out", "passed", "--files", "h5,mcap"}).code == 0);
  for (const std::string file : {"signals.h5", "signals.mcap", "claims.json", "figure.svg"})
    check_same(folder, file, "held", "passed");
  const auto rows = stepwire::data_file::read_data_file(folder.path("passed/signals.h5"));
  CHECK(rows.find("run-12/lag")->values.size() == 501);
  CHECK(rows.find("run-12/lag")->values.back() == Approx(1.0 - std::exp(-0.5 / 0.12)));
}

TEST_CASE("without a folder claims of a sweep are those of its files") {
  const Scratch folder;
  folder.file("sweep.yaml", claimed_yaml());
  const Done alone = run_program(folder, {"run", "sweep.yaml"});
  const Done held = run_program(folder, {"run", "sweep.yaml", "--out", "held"});
  const auto claims = [](const Done& done) {
    std::vector<std::string> lines = lines_of(done.out);
    std::erase_if(lines, [](const std::string& line) { return !line.starts_with("  ok "); });
    return lines;
  };
  CHECK(alone.code == 0);
  CHECK(claims(alone).size() == 10);
  CHECK(claims(alone) == claims(held));
}

TEST_CASE("shares, and a sweep that goes on, give the rows of one call") {
  const Scratch folder;
  folder.file("sweep.yaml", claimed_yaml());
  const auto run = [&](std::vector<std::string> arguments) {
    const Done done = run_program(folder, arguments);
    INFO(done.err);
    REQUIRE(done.code == 0);
  };
  run({"run", "sweep.yaml", "--out", "whole", "--files", "h5"});
  run({"run", "sweep.yaml", "--part", "1/2", "--out", "one"});
  run({"run", "sweep.yaml", "--part", "2/2", "--out", "two"});
  run({"collect", "two", "one", "--out", "joined", "--files", "h5"});
  run({"run", "sweep.yaml", "--out", "one", "--files", "h5"});
  for (const std::string other : {"joined", "one"})
    for (const std::string file : {"signals.h5", "claims.json", "figure.svg"})
      check_same(folder, file, "whole", other);
}

TEST_CASE("a sweep whose rows are more than memory writes them, and judges its runs") {
  const Scratch folder;
  folder.file("large.yaml", large_yaml("claims:\n  - {that: a, final: lag, equals: 1, within: 1e-6}\n"
                                       "  - {that: b, fraction_of_runs: max(lag) <= 1, equals: 1}\n"));
  const auto done = run_within(100, {"run", folder.path("large.yaml"), "--engine", "interpreted", "--threads", "1",
                                     "--out", folder.path("out"), "--files", "h5"});
  INFO(done.errors << done.output);
  REQUIRE(done.succeeded());
  CHECK(std::filesystem::file_size(folder.path("out/signals.h5")) > 64'000'000);
  CHECK_FALSE(std::filesystem::exists(folder.path("out/points.journal")));
}

TEST_CASE("what needs all rows at once is refused before the run where they are more than memory, at its line") {
  const Scratch folder;
  folder.file("large.yaml",
              large_yaml("figure: {plot: lines, x: time, y: lag}\nclaims:\n"
                         "  - {that: a, final: lag, equals: 1, within: 1e-6}\n"
                         "  - {that: b, quantile: {share: 50 %, value: lag}, at_least: 0}\n"));
  const auto run = [&](const std::string& files) {
    return run_within(100, {"run", folder.path("large.yaml"), "--out", folder.path("out"), "--files", files});
  };
  const auto done = run("csv");
  INFO(done.errors);
  CHECK_FALSE(done.succeeded());
  CHECK_THAT(done.errors, Contains("large.yaml:10:") && Contains("figure: the picture needs the rows of all runs at once"));
  CHECK_THAT(done.errors, Contains("large.yaml:13:") && Contains("claims: ") && Contains("'each_run: true'"));
  CHECK_THAT(done.errors, Contains("--files: a table of kind csv or mat needs") && Contains("give --files h5"));
  CHECK_THAT(done.errors, Contains("4e+06 rows with 1.2e+07 numbers take about 0.192 GB"));
  CHECK_FALSE(std::filesystem::exists(folder.path("out")));
}

TEST_CASE("csv is refused above its size before the run, and h5 is what a large run leaves") {
  const Scratch folder;
  folder.file("large.yaml", "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 3 s\nblocks:\n"
                            "  lag: {block: Constant, value: 1}\nrecord: [lag]\n"
                            "sweep: {lag.value: {from: 0, to: 1, count: 10000}}\n");
  const std::vector<std::string> share{"run", "large.yaml", "--part", "1/10000", "--out", "out"};
  auto named = share;
  named.insert(named.end(), {"--files", "csv,h5"});
  const Done refused = run_program(folder, named);
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, Contains("--files: csv takes 50 million numbers, and 90 million are recorded; name h5"));
  const Done done = run_program(folder, share);
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.err, Contains("more than 50 million numbers, so signals.h5 is written"));
}

TEST_CASE("numbers that are kept of runs are verified in their folder alone") {
  const Scratch folder;
  folder.file("kept.yaml",
              "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 0.5 s\nsolver: rk4\nparameters: {tau: 10 ms, share: 0.9, "
              "slow: 2}\nblocks:\n"
              "  one: {block: Constant, value: 1}\n  lag: {block: Lag, tau: $tau, u: one}\nrecord: [lag]\n"
              "sweep: {tau: [10 ms, 20 ms, 40 ms], lag.gain: [1, 2], keep: {rise: rise_time(lag), end: "
              "final(lag)*$share, late: max(lag where time > $slow*tau)/lag.gain}}\n");
  REQUIRE(run_program(folder, {"run", "kept.yaml", "--out", "out"}).code == 0);
  folder.file("kept.yaml", "another file\n");
  const Done done = run_program(folder, {"verify", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("3 signals in 6 rows of 6 runs: all bits agree"));
  std::string text = content_of(folder.path("out/signals.csv"));
  const std::size_t last = text.find_last_of("123456789");
  text[last] = text[last] == '1' ? '2' : '1';
  std::ofstream(folder.path("out/signals.csv")) << text;
  const Done differs = run_program(folder, {"verify", "out"});
  CHECK(differs.code == 1);
  CHECK_THAT(differs.out, Contains("out/signals.csv:7: late at 0.5 s is ") && Contains(" when it is replayed"));
}
