// Folders without CSV: what --files h5 leaves, and runs of more numbers than CSV takes.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "engine/base/hdf5/hdf5_read.hpp"
#include "engine/base/hdf5/hdf5_writer.hpp"
#include "engine/simulate/replay/verify.hpp"
#include "tests/engine/simulate/replay/left_folder.hpp"

namespace stepwire::replay {

namespace {

const std::string two_periods = R"(stepwire: 1
step: 0.25 s
stop: 1 s
parameters: {gain: 2 m/s}
blocks: {t: {block: Clock}, twice: {block: Gain, u: t, gain: $gain}}
record: [{signals: [t, {rig.x: twice}]}, {every: 0.5 s, signals: twice}]
)";

const session::FileKinds h5{session::FileKind::h5};

/// The run of this name in a file that other hands have written again, with a number of a column changed; no
/// change where the row is not there.
struct Change {
  std::string run, column;
  std::size_t row = 0;
  double number = 0.0;
};

std::string run_of(const table::Column& column) {
  const auto slash = column.name.find('/');
  return slash == std::string::npos ? "" : column.name.substr(0, slash);
}

/// Writes an HDF5 file of a folder again, with one number changed.
void change_number(const DiagramFolder& folder, const std::string& file, const Change& change) {
  table::RecordTable table = hdf5::read_hdf5(folder.path(file));
  hdf5::Hdf5Writer writer(folder.path(file), "");
  for (std::size_t begin = 0, end = 0; begin < table.columns.size(); begin = end) {
    table::RunView view{run_of(table.columns[begin]), {}, {}};
    for (; end < table.columns.size() && run_of(table.columns[end]) == view.name; ++end) {
      table::Column& column = table.columns[end];
      const std::string name = view.name.empty() ? column.name : column.name.substr(view.name.size() + 1);
      if (view.name == change.run && name == change.column) column.values.at(change.row) = change.number;
      if (column.values.size() == 1)
        view.swept.push_back({name, column.unit, column.values.front()});
      else
        view.series.push_back({name, column.unit, column.values});
    }
    writer.add(view);
  }
  writer.finish();
}

}  // namespace

TEST_CASE("a run that left HDF5 alone is compared with it, at all of its periods") {
  const DiagramFolder folder;
  folder.write("main.yaml", two_periods);
  leave(folder, "main.yaml", "out", h5);
  REQUIRE_FALSE(std::filesystem::exists(folder.path("out/signals.csv")));
  CHECK(verdict_of(folder, "out") == "3 signals in 8 rows: all bits agree");
  change_number(folder, "out/signals-2.h5", {"", "twice", 1, std::nextafter(1.0, 2.0)});
  CHECK(verdict_of(folder, "out") ==
        "signals-2.h5: row 2: twice at 0.5 s is 1.0000000000000002 and 1 when it is replayed");
  change_number(folder, "out/signals.h5", {"", "rig.x", 0, -0.0});
  CHECK(verdict_of(folder, "out") == "signals.h5: row 1: rig.x at 0 s is -0 and 0 when it is replayed");
}

TEST_CASE("a table of text and one of HDF5 in one folder are each compared") {
  const DiagramFolder folder;
  folder.write("main.yaml", two_periods);
  leave(folder, "main.yaml", "out", {session::FileKind::csv, session::FileKind::h5});
  std::filesystem::remove(folder.path("out/signals.csv"));
  std::filesystem::remove(folder.path("out/signals-2.h5"));
  CHECK(verdict_of(folder, "out") == "3 signals in 8 rows: all bits agree");
}

TEST_CASE("runs of a sweep are compared group by group") {
  const DiagramFolder folder;
  folder.write("main.yaml", two_periods + "sweep: {gain: [2 m/s, 3 m/s, 4 m/s, 5 m/s]}\n");
  leave(folder, "main.yaml", "out", h5);
  CHECK(verdict_of(folder, "out") == "3 signals in 32 rows of 4 runs: all bits agree");
  change_number(folder, "out/signals.h5", {"run-3", "rig.x", 4, 5.0});
  CHECK(verdict_of(folder, "out") ==
        "signals.h5/run-3: row 5: rig.x at 1 s is 5 and 4 when it is replayed");
}

TEST_CASE("a sweep of more runs than are read at once is compared to its end", "[full]") {
  const DiagramFolder folder;
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 1 s\nparameters: {gain: 1}\n"
               "blocks: {t: {block: Clock}, y: {block: Gain, u: t, gain: $gain}}\nrecord: y\n"
               "sweep: {gain: {from: 1, to: 6000, count: 6000}}\n");
  leave(folder, "main.yaml", "out", h5);
  CHECK(verdict_of(folder, "out") == "1 signal in 12000 rows of 6000 runs: all bits agree");
  change_number(folder, "out/signals.h5", {"run-6000", "y", 1, 0.0});
  CHECK(verdict_of(folder, "out") ==
        "signals.h5/run-6000: row 2: y at 1 s is 0 and 6000 when it is replayed");
}

TEST_CASE("a run of a sweep that left no row has none in its replay") {
  const DiagramFolder folder;
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 2 s\nparameters: {a: 1}\nblocks:\n  t: {block: Clock}\n"
               "  d: {block: Sum, u: [t, $a]}\n  y: {block: Divide, numerator: 1, denominator: d}\n"
               "record: [y]\nsweep: {a: [1, 0, 2]}\n");
  leave(folder, "main.yaml", "out", h5);
  CHECK(verdict_of(folder, "out") == "1 signal in 6 rows of 3 runs: all bits agree");
}

TEST_CASE("runs, rows and columns beyond those of the replay are named") {
  const DiagramFolder folder;
  const std::string sweep = two_periods + "sweep: {gain: [2 m/s, 3 m/s, 4 m/s]}\n";
  folder.write("main.yaml", sweep);
  leave(folder, "main.yaml", "out", h5);
  const auto verdict_with = [&](const std::string& runs) {
    leave(folder, "main.yaml", "out", h5);
    hdf5::Hdf5Writer writer(folder.path("out/signals-2.h5"), "");
    const std::vector<double> times{0.0, 0.5, 1.0, 1.5};
    for (std::size_t run = 0; run < 4; ++run) {
      const double gain = 2.0 + static_cast<double>(run);
      const std::vector<double> y{0.0, gain * 0.5, gain, gain * 1.5};
      const std::size_t rows = runs == "long" && run == 1 ? 4 : 3;
      if (run < 3 || runs == "more")
        writer.add({"run-" + std::to_string(run + 1),
                    {{"gain", "m/s", gain}},
                    {{"time", "s", std::span(times).first(rows)},
                     {runs == "other" ? "thrice" : "twice", "m", std::span(y).first(rows)}}});
    }
    writer.finish();
    return verdict_of(folder, "out");
  };
  CHECK(verdict_with("same") == "3 signals in 24 rows of 3 runs: all bits agree");
  CHECK(verdict_with("more") == "signals-2.h5/run-4: there are more runs than the 3 of the sweep");
  CHECK(verdict_with("long") == "signals-2.h5/run-2: row 4: there is a row at 1.5 s, but the replay ends at 1 s");
  CHECK(verdict_with("other") ==
        "signals-2.h5/run-1: its columns are time [s], thrice [m]; diagram.yaml records time [s], twice [m]");
}

TEST_CASE("last rows of runs are compared with the one table of HDF5") {
  const DiagramFolder folder;
  folder.write("main.yaml", two_periods + "sweep: {gain: [2 m/s, 3 m/s], keep: final}\n");
  leave(folder, "main.yaml", "out", h5);
  CHECK(verdict_of(folder, "out") == "3 signals in 4 rows of 2 runs: all bits agree");
}

TEST_CASE("of other kinds of files the message says which are needed") {
  const DiagramFolder folder;
  folder.write("main.yaml", two_periods);
  leave(folder, "main.yaml", "out", {session::FileKind::mcap, session::FileKind::mat});
  CHECK(verdict_of(folder, "out") ==
        "signals.csv: is missing; verify needs it or signals.h5, which 'run --out' writes of a diagram that "
        "records something, with csv or h5 among '--files'");
}

TEST_CASE("a damaged HDF5 file is refused with its name") {
  const DiagramFolder folder;
  folder.write("main.yaml", two_periods);
  leave(folder, "main.yaml", "out", h5);
  folder.write("out/signals.h5", "no such file");
  CHECK_THAT(verdict_of(folder, "out"), Catch::StartsWith("signals.h5: this is no HDF5 file"));
}

}  // namespace stepwire::replay
