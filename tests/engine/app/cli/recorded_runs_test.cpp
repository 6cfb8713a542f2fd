// Sweeps that keep numbers of all runs, and the rows of some.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/table/table_file.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;
namespace table = stepwire::table;

namespace {

/// 1 - exp(-t/tau) in 41 runs, of which five are recorded over time: 1, 11, 21, 31 and 41.
std::string sweep_of(const std::string& more) {
  return "stepwire: 1\ntitle: A lag follows a constant\nstep: 1 ms\nstop: 0.5 s\nsolver: rk4\n"
         "parameters: {tau: {value: 0.1 s}}\n"
         "blocks:\n  reference: {block: Constant, value: 1.0}\n  lag: {block: Lag, u: reference, tau: $tau}\n"
         "record: [reference, lag]\nsweep: {tau: {from: 10 ms, to: 50 ms, count: 41}" +
         more + "}\n";
}

const std::string keep = ", keep: {end: final(lag), top: max(lag)}", record = ", record: {runs: 5}";

std::string content(const Scratch& folder, const std::string& path) {
  return content_of(folder.path(path));
}

void run_to(const Scratch& folder, const std::string& out, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"run", "sweep.yaml", "--out", out};
  words.insert(words.end(), more.begin(), more.end());
  const Done done = run_program(folder, words);
  INFO(done.err);
  REQUIRE(done.code == 0);
}

}  // namespace

TEST_CASE("runs to record are named where they belong: in the sweep") {
  const Scratch folder;
  for (const std::string entry : {"{signals: [lag], runs: 5}", "[lag, {runs: 5}]", "{runs: 5}"}) {
    std::string text = sweep_of(keep);
    const std::string signals = "[reference, lag]";
    text.replace(text.find(signals), signals.size(), entry);
    folder.file("sweep.yaml", text);
    const Done done = run_program(folder, {"check", "sweep.yaml"});
    CHECK(done.code == 2);
    CHECK_THAT(done.err,
               Contains("record: 'runs' is a key of 'sweep.record': sweep: {..., record: {runs: 20}}"));
  }
}

TEST_CASE("a sweep that keeps numbers records some evenly chosen runs over time as well") {
  const Scratch folder;
  folder.file("sweep.yaml", sweep_of(keep));
  run_to(folder, "numbers");
  folder.file("sweep.yaml", sweep_of(""));
  run_to(folder, "rows");
  folder.file("sweep.yaml", sweep_of(keep + record));
  run_to(folder, "both");
  CHECK(content(folder, "both/signals.csv") == content(folder, "numbers/signals.csv"));
  const auto note = nlohmann::json::parse(content(folder, "both/run.json"));
  CHECK(note["recorded_runs"] == std::vector<int>{1, 11, 21, 31, 41});
  const table::Table all = table::read_csv(folder.path("rows/signals.csv")),
                     some = table::read_csv(folder.path("both/signals-2.csv"));
  const std::size_t rows = all.rows() / 41;
  REQUIRE(some.rows() == 5 * rows);
  for (std::size_t column = 0; column < all.columns.size(); ++column)
    for (std::size_t row = 0; row < some.rows(); ++row)
      REQUIRE(some.columns[column].values[row] ==
              all.columns[column].values[row / rows * 10 * rows + row % rows]);
  CHECK_THAT(run_program(folder, {"verify", "both"}).out, Contains("all bits agree"));
}

TEST_CASE("threads, lanes, shares and a call that goes on record the same runs to the same bytes") {
  const Scratch folder;
  folder.file("sweep.yaml", sweep_of(keep + record));
  run_to(folder, "whole", {"--threads", "1"});
  run_to(folder, "lanes", {"--threads", "2", "--engine", "compiled"});
  for (const std::string number : {"3", "1", "2"})
    run_to(folder, "part-" + number, {"--part", number + "/3"});
  REQUIRE(run_program(folder, {"collect", "part-1", "part-2", "part-3", "--out", "all"}).code == 0);
  for (const std::string out : {"lanes", "all"})
    for (const std::string file : {"/signals.csv", "/signals-2.csv"})
      CHECK(content(folder, out + file) == content(folder, "whole" + file));
}

TEST_CASE("a changed number in a recorded run is found, in text and in HDF5") {
  const Scratch folder;
  folder.file("sweep.yaml", sweep_of(keep + record));
  run_to(folder, "text");
  run_to(folder, "h5", {"--files", "h5"});
  CHECK_THAT(run_program(folder, {"verify", "h5"}).out, Contains("all bits agree"));
  std::string rows = content(folder, "text/signals-2.csv");
  const std::size_t last = rows.rfind(',', rows.size() - 2) + 1;
  rows.replace(last, rows.size() - 1 - last, "0.25");
  folder.file("text/signals-2.csv", rows);
  const Done done = run_program(folder, {"verify", "text"});
  CHECK(done.code == 1);
  CHECK_THAT(done.out + done.err, Contains("signals-2.csv") && Contains("0.25 and 0.9999"));
  std::filesystem::remove(folder.path("h5/signals-2.h5"));
  CHECK_THAT(run_program(folder, {"verify", "h5"}).err, Contains("signals-2.csv: is missing"));
}

TEST_CASE("figures draw recorded runs beside numbers of all; claims go over all runs") {
  const Scratch folder;
  folder.file("sweep.yaml",
              sweep_of(keep + record) +
                  "figure: [{plot: lines, x: time, y: lag, by: tau}, {plot: histogram, x: top}]\n");
  run_to(folder, "out");
  const auto curves = nlohmann::json::parse(content(folder, "out/figure.json"));
  CHECK(curves["panels"][0]["marks"].size() == 5);
  const auto check = [&](const std::string& more) {
    folder.file("sweep.yaml", sweep_of(keep + record) + more);
    return run_program(folder, {"check", "sweep.yaml"}).err;
  };
  CHECK_THAT(check("claims: [{that: a, max: lag, at_most: 1}]\n"),
             Contains("rows stay of some of them only"));
  CHECK_THAT(check("figure: {plot: lines, x: top, y: lag}\n"),
             Contains("'top' and 'lag' are of different tables"));
}

TEST_CASE("rows of some runs are kept beside numbers alone") {
  const Scratch folder;
  const auto refusal = [&](const std::string& more) {
    folder.file("sweep.yaml", sweep_of(more));
    return run_program(folder, {"check", "sweep.yaml"}).err;
  };
  CHECK_THAT(refusal(record), Contains("all runs are recorded already"));
  CHECK_THAT(refusal(", keep: final" + record), Contains("not with their last rows"));
  CHECK_THAT(refusal(", keep: {lag: max(lag)}" + record),
             Contains("a signal that is recorded has this name"));
  CHECK_THAT(refusal(keep + ", record: {runs: 0}"), Contains("no whole number from 1"));
  CHECK_THAT(refusal(keep + ", record: {}"), Contains("runs"));
  CHECK(refusal(keep + ", record: {runs: 1000}").empty());
}
