#include "engine/simulate/run/row_per_run.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

const std::string head = "stepwire: 1\nstep: 1 s\nstop: 5 s\n";

/// y grows by a in each second; the run with a = 9 divides by 0 at 3 s.
const std::string rising =
    "parameters: {a: 1}\nblocks:\n  t: {block: Clock}\n  y: {block: Gain, gain: $a, u: t}\n"
    "  left: {block: Sum, signs: \"+-\", u: [27, y]}\n  z: {block: Divide, numerator: 1, denominator: "
    "left}\n";

RunResult swept(const std::string& yaml, const RunNumbers* numbers = nullptr, unsigned threads = 0) {
  const DiagramFolder folder;
  folder.write("sweep.yaml", head + yaml);
  diagram::Loader loader(library());
  const Job job = make_job(loader, folder.path("sweep.yaml"));
  RunOptions options;
  options.threads = threads;
  options.numbers = numbers;
  return run_job(job, options);
}

}  // namespace

TEST_CASE("a sweep that keeps final rows has the last row of each run") {
  const std::string tail = "record: [y, {every: 2 s, signals: z}]\nsweep: {a: [1, 2, 3]";
  const RunResult all = swept(rising + tail + "}\n"), final = swept(rising + tail + ", keep: final}\n");
  REQUIRE(final.recordings.size() == 2);
  for (std::size_t r = 0; r < 2; ++r) {
    const table::Table &rows = all.recordings[r].table, &last = final.recordings[r].table;
    CHECK(final.recordings[r].starts == std::vector<std::size_t>{0, 1, 2});
    REQUIRE(last.columns.size() == rows.columns.size());
    for (std::size_t c = 0; c < rows.columns.size(); ++c) {
      CHECK(last.columns[c].name == rows.columns[c].name);
      for (std::size_t run = 0; run < 3; ++run) {
        const std::size_t end = run < 2 ? all.recordings[r].starts[run + 1] : rows.rows();
        CHECK(last.columns[c].values[run] == rows.columns[c].values[end - 1]);
      }
    }
  }
  CHECK(column(final.recordings[0].table, "y") == std::vector<double>{5, 10, 15});
}

TEST_CASE("a run that a fault ends has a row of nan, and the others have theirs") {
  const RunResult result = swept(rising + "record: [y, z]\nsweep: {a: [1, 9, 2], keep: final}\n");
  REQUIRE(result.faults.size() == 1);
  const table::Table& table = result.recordings.at(0).table;
  CHECK(column(table, "a") == std::vector<double>{1, 9, 2});
  CHECK(column(table, "y")[0] == 5);
  CHECK(std::isnan(column(table, "y")[1]));
  CHECK(column(table, "y")[2] == 10);
}

TEST_CASE("numbers of a run see its rows with its swept parameters, and are its row") {
  RunNumbers numbers{{{"sum", "", {}}, {"rows", "", {}}}, {}};
  numbers.of = [](std::span<const record::Recording> run) {
    double sum = 0.0;
    for (const double value : run[0].table.find("y")->values) sum += value;
    return std::vector<double>{sum,
                               run[0].table.find("a")->values[0] * static_cast<double>(run[0].table.rows())};
  };
  const std::string yaml =
      "parameters: {a: 1}\nblocks:\n  t: {block: Clock}\n  y: {block: Gain, gain: $a, u: t}\nrecord: y\n"
      "sweep: {a: {from: 1, to: 50, count: 50}}\n";
  for (const unsigned threads : {1u, 4u}) {
    const RunResult result = swept(yaml, &numbers, threads);
    REQUIRE(result.recordings.size() == 1);
    const table::Table& table = result.recordings[0].table;
    CHECK(table.columns[0].name + table.columns[1].name + table.columns[2].name == "timeasum");
    for (std::size_t run = 0; run < 50; ++run) {
      const auto a = static_cast<double>(run + 1);
      CHECK(column(table, "sum")[run] == 15.0 * a);
      CHECK(column(table, "rows")[run] == 6.0 * a);
      CHECK(column(table, "time")[run] == 5.0);
    }
  }
}

}  // namespace stepwire::run
