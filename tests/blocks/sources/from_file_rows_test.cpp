#include <algorithm>
#include <catch2/catch.hpp>

#include "engine/base/data_file/reading_log.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

std::string diagram(const std::string& file, const std::string& keys, const std::string& stop) {
  return "step: 0.1 s\nstop: " + stop + "\nblocks:\n  y: {block: FromFile, file: '" + file + "', " + keys +
         "}\nrecord: [y]\n";
}

/// `y` of a FromFile with these keys that plays a file with this text, at every 0.1 s up to `stop`.
std::vector<double> played(const std::string& text, const std::string& keys, const std::string& stop) {
  const Scratch scratch;
  return column(run_text(diagram(scratch.file("press.csv", text), keys, stop)), "y");
}

std::string refused(const std::string& text, const std::string& keys) {
  const Scratch scratch;
  const std::string message = error_of(diagram(scratch.file("press.csv", text), keys, "0.2 s"));
  const std::size_t at = message.find("press.csv");
  return at == std::string::npos ? message : message.substr(at);
}

void require_near(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) REQUIRE(values[i] == Approx(expected[i]).margin(1e-12));
}

/// How the file was read, as `check` prints it.
std::vector<std::string> done(const std::string& text, const std::string& keys) {
  const data_file::ReadingLog log;
  played(text, keys, "0.2 s");
  REQUIRE(data_file::ReadingLog::files().size() == 1);
  return data_file::ReadingLog::files().front().done;
}

}  // namespace

TEST_CASE("a record with decimal commas, a row of units and calendar times is played in SI") {
  const std::string text =
      "Zeit;Weg\n;mm\n2026-11-27T10:00:00.0Z;0\n2026-11-27T10:00:00.2Z;1500,5\n2026-11-27T10:00:00.4Z;1000\n";
  require_near(played(text, "column: Weg, time: Zeit", "0.4 s"), {0, 0.75025, 1.5005, 1.25025, 1});
  require_near(played("time (s);x (mm)\n0;1,5\n0,2;2,5\n", "column: x (mm)", "0.2 s"),
               {1.5e-3, 2e-3, 2.5e-3});
  require_near(played("t;x\n0;1,500\n1;3,500\n", "column: x, decimal: ','", "0.2 s"), {1.5, 1.7, 1.9});
  require_near(played("t;x\n0;1,500\n1;3,500\n", "column: x, decimal: '.'", "0.2 s"), {1500, 1700, 1900});
  CHECK(
      refused("t;x\n0;1,500\n1;3,500\n", "column: x").starts_with("press.csv:2: '1,500' is 1.500 or 1500: "));
}

TEST_CASE("a missing value is refused, held or left out with its row, as the block says") {
  const std::string text = "t,x\n0,1\n0.1,\n0.2,3\n0.3,NaN\n0.4,5\n";
  CHECK(refused(text, "column: x")
            .starts_with(
                "press.csv:3: x has no value; say `missing: hold` for the value before it, or `missing: "
                "skip` to leave the row out"));
  require_near(played(text, "column: x, missing: hold", "0.4 s"), {1, 1, 3, 3, 5});
  require_near(played(text, "column: x, missing: skip", "0.4 s"), {1, 2, 3, 4, 5});
}

TEST_CASE("a value is held from before the part in use, and the first one cannot be held") {
  const std::string late = "t,x\n0,\n0.1,2\n0.2,\n0.3,4\n";
  CHECK(refused(late, "column: x, missing: hold")
            .starts_with("press.csv:2: x has no value, and no row before it has one to hold"));
  require_near(played(late, "column: x, missing: hold, from: 0.2 s", "0.1 s"), {2, 4});
  require_near(played(late, "column: x, missing: skip, from: 0.1 s", "0.2 s"), {2, 3, 4});
}

TEST_CASE("a record whose first rows are left out does not move against other columns of its file") {
  const std::string text = "t,x,y\n0,,0\n0.1,1,1\n0.2,2,2\n0.3,3,3\n";
  CHECK(refused(text, "column: x, missing: skip")
            .starts_with(
                "press.csv:2: x has no value at 0 s, so that this record would begin at 0.1 s and other "
                "columns of the file earlier; say `from: 0.1 s`"));
  require_near(played(text, "column: y, missing: skip", "0.2 s"), {0, 1, 2});
  require_near(played(text, "column: x, missing: skip, from: 0.1 s", "0.2 s"), {1, 2, 3});
  require_near(played(text, "column: x, missing: skip, start: 0.1 s", "0.2 s"), {1, 2, 3});
  // since 1970 in ms: both columns count from the first row of the file
  const std::string since =
      "t [ms],x,y\n1764150000000,,0\n1764150000100,1,1\n1764150000200,2,2\n"
      "1764150000300,3,3\n";
  require_near(played(since, "column: x, missing: skip, start: 0.1 s", "0.2 s"), {1, 2, 3});
  require_near(played(since, "column: y, missing: skip, start: 0.1 s", "0.2 s"), {1, 2, 3});
}

TEST_CASE("a record that repeats leaves out no row, which would change its period") {
  const std::string text = "t,x\n0,0\n0.1,1\n0.2,\n0.3,3\n";
  CHECK_THAT(refused(text, "column: x, missing: skip, after_end: repeat"),
             Catch::Contains("press.csv:4: x has no value and its row is left out"));
  require_near(played(text, "column: x, missing: hold, after_end: repeat", "0.5 s"), {0, 1, 1, 3, 0, 1});
}

TEST_CASE("blank lines between rows of several columns are skipped") {
  require_near(played("t,x\n\n0,1\n  \n0.1,2\r\n\r\n0.2,3\n\n", "column: x", "0.2 s"), {1, 2, 3});
  require_near(played("x\n1\n\n3\n", "column: x, sample_time: 0.1 s, missing: hold", "0.2 s"), {1, 1, 3});
}

TEST_CASE("a missing time is left out and never held") {
  const std::string text = "t,x\n0,1\n,7\n0.2,3\n";
  CHECK(refused(text, "column: x, missing: hold")
            .starts_with("press.csv:3: t has no value; a time cannot be held: say `missing: skip`"));
  require_near(played(text, "column: x, missing: skip", "0.2 s"), {1, 2, 3});
}

TEST_CASE("a row is left out where any column of the vector has no value") {
  const std::string text = "t,x,y\n0,1,10\n0.1,,20\n0.2,3,\n0.3,4,40\n";
  const Scratch scratch;
  const table::Table run =
      run_text("step: 0.1 s\nstop: 0.3 s\nblocks:\n  v: {block: FromFile, file: '" +
               scratch.file("a.csv", text) + "', column: [x, y], missing: skip}\nrecord: [v.1, v.2]\n");
  require_near(column(run, "v.1"), {1, 2, 3, 4});
  require_near(column(run, "v.2"), {10, 20, 30, 40});
}

TEST_CASE("rows that are not in order are refused with the cure, and sorted where the block says so") {
  const std::string text = "t,x\n0.2,3\n0,1\n0.1,2\n";
  CHECK(
      refused(text, "column: x")
          .starts_with("press.csv:3: t is 0, after 0.2 in the row before; times must increase, or say `sort: "
                       "true`"));
  require_near(played(text, "column: x, sort: true", "0.2 s"), {1, 2, 3});
  // The two rows at 0.1 s keep their order.
  require_near(played("t,x\n0.2,9\n0.1,1\n0,0\n0.1,8\n", "column: x, sort: true", "0.2 s"), {0, 8, 9});
  // Times of the calendar count from the earliest row.
  const std::string days =
      "t,x\n2026-11-27T10:00:00.1Z,2\n2026-11-27T10:00:00Z,1\n2026-11-27T10:00:00.2Z,3\n";
  require_near(played(days, "column: x, sort: true", "0.2 s"), {1, 2, 3});
}

TEST_CASE("two rows of one time are a jump: the values before and after it") {
  const std::string text = "t,x\n0,0\n0.3,3\n0.3,7\n0.7,11\n0.7,-1\n1,2\n";
  require_near(played(text, "column: x", "1 s"), {0, 1, 2, 7, 8, 9, 10, -1, 0, 1, 2});
  require_near(played(text, "column: x, interpolation: hold", "1 s"), {0, 0, 0, 7, 7, 7, 7, -1, -1, -1, 2});
  require_near(played(text, "column: x, prepare: [{resample: 0.1 s}]", "1 s"),
               {0, 1, 2, 7, 8, 9, 10, -1, 0, 1, 2});
  require_near(played("t,x\n0,0\n0.1,1\n0.2,2\n0.2,5\n", "column: x, prepare: [{resample: 0.1 s}]", "0.2 s"),
               {0, 1, 5});
  CHECK(
      refused("t,x\n0,0\n0.1,1\n0.1,2\n0.1,3\n0.2,4\n", "column: x")
          .starts_with("press.csv:5: t is 0.1, as in the two rows before; two rows of one time are a jump"));
}

TEST_CASE("a record with a jump repeats one interval after its last row") {
  require_near(played("t,x\n0,0\n0.1,1\n0.1,5\n0.2,6\n", "column: x, after_end: repeat", "0.7 s"),
               {0, 5, 6, 0, 5, 6, 0, 5});
}

TEST_CASE("every solver integrates a record with jumps exactly, on a tick and between two") {
  const Scratch scratch;
  // 0 to 1 in 0.3 s, from 3 to 4 until 0.57 s, then 2: the area up to 1 s.
  const double area = 0.3 * 0.5 + 0.27 * 3.5 + 0.43 * 2.0;
  const std::string file = scratch.file("jumps.csv", "t,x\n0,0\n0.3,1\n0.3,3\n0.57,4\n0.57,2\n2,2\n");
  for (const char* solver : {"euler", "heun", "rk4", "dormand_prince", "rosenbrock", "sdirk", "radau"}) {
    INFO(solver);
    const table::Table run = run_text(std::string("events: locate\nstep: 0.1 s\nstop: 1 s\nsolver: ") +
                                      solver + "\nblocks:\n  x: {block: FromFile, file: '" + file +
                                      "', column: x}\n  i: {block: Integrator, u: x}\nrecord: [i]\n");
    // Euler's method is off by half a step times the rise of each straight piece.
    const double margin = std::string(solver) == "euler" ? 0.11 : 1e-9;
    CHECK(column(run, "i").back() == Approx(area).margin(margin));
  }
}

TEST_CASE("how a file was read is told: marks, units, times, missing values, order and jumps") {
  CHECK(done("t;x\ns;mm\n0;0\n0,1;2\n0,1;3\n1;4\n", "column: x") ==
        std::vector<std::string>{"separator ';'", "decimal comma", "units in line 2",
                                 "1 jump by two rows of one time"});
  CHECK(done("t,x\n0.5,1\n0.3,\n0,2\n", "column: x, sort: true, missing: skip") ==
        std::vector<std::string>{"separator ','", "decimal point", "1 row without 'x' left out",
                                 "rows sorted by 't'"});
  CHECK(done("t,x\n0,1\n0.1,\n0.2,\n", "column: x, missing: hold") ==
        std::vector<std::string>{"separator ','", "decimal point", "2 missing values of 'x' held"});
  CHECK(data_file::ReadingLog::files().empty());
}

TEST_CASE("a step of preparation takes the rows that are in use, in their order") {
  const std::string text = "t,x,m\n0.4,5,1\n0.1,2,0\n0,1,0\n0.2,,0\n0.3,4,1\n0.5,6,0\n";
  require_near(played(text, "column: x, sort: true, missing: skip, prepare: [{trim: m}]", "0.1 s"), {4, 5});
  CHECK(refused("t,x,m\n0,1,0\n0.1,2,\n0.2,3,1\n", "column: x, prepare: [{trim: m}]")
            .starts_with("press.csv:3: m has no value; say `missing: hold`"));
}

TEST_CASE("times since 1970 count from the first row, and rows stay where they are") {
  // Whole milliseconds are exact. In seconds they would be rounded to 0.24 us.
  const std::string text = "t [ms],x\n1790000000000,0\n1790000000001,1\n1790000000201,201\n";
  require_near(played(text, "column: x", "0.2 s"), {0, 100, 200});
  const std::vector<std::string> notes = done(text, "column: x");
  CHECK(std::ranges::find(notes, "times count from the first row, 1790000000000 ms") != notes.end());
}

TEST_CASE("fractions of seconds since 1970 keep all their digits") {
  const std::string close = "t,x\n1790000000.0000,0\n1790000000.0001,1\n1790000000.0003,3\n";
  require_near(played(close, "column: x, after_end: hold", "0.1 s"), {0, 3});
  const std::string seconds = "t,x\n1767225600,0\n1767225601,1\n";
  for (const std::string at : {"", ", start: 1767225600 s", ", from: 1767225600 s, to: 1767225601 s"})
    CHECK(played(seconds, "column: x" + at, "0.2 s").at(1) == Approx(0.1).margin(1e-15).epsilon(0.0));
  const std::string tenths = "t,x\n1767225600.1,0\n1767225600.2,1\n1767225600.3,2\n";
  CHECK(played(tenths, "column: x", "0.2 s").at(1) == Approx(1.0).margin(1e-14).epsilon(0.0));
  const Scratch scratch;
  CHECK_THAT(error_of(diagram(scratch.file("press.csv", seconds), "column: x, start: 5 s", "0.2 s")),
             Catch::Contains("5 s is not in the record, which goes from 1767225600 s to 1767225601 s"));
}
