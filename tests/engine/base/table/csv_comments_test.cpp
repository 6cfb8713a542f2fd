#include <catch2/catch.hpp>

#include "engine/base/table/record_table.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::table {

namespace {

using Values = std::vector<double>;

RecordTable read_record(const std::string& content) {
  const Scratch scratch;
  return read_record_csv(scratch.file("press.csv", content));
}

}  // namespace

TEST_CASE("lines of a record that begin with # are passed over") {
  const RecordTable table =
      read_record("# a press, 2026\n# by hand\ntime [s];force [N]\n0;1\n# a pause\n1;2\n#end\n");
  REQUIRE(table.columns.size() == 2);
  CHECK(table.columns[1].name == "force");
  CHECK(table.columns[1].unit == "N");
  CHECK(table.columns[1].values == Values{1.0, 2.0});
}

TEST_CASE("a comment above numbers alone names the columns") {
  const RecordTable table = read_record("# of a plotter\n# time, force\n0,1\n1,2\n");
  REQUIRE(table.columns.size() == 2);
  CHECK(table.columns[0].name == "time");
  CHECK(table.columns[1].values == Values{1.0, 2.0});
}

TEST_CASE("a column of text is in nobody's way while nothing reads it") {
  const RecordTable table = read_record("time,comment,force\n0,ok,1\n1,not so good,2\n");
  REQUIRE(table.columns.size() == 3);
  CHECK(table.columns[2].values == Values{1.0, 2.0});
  CHECK(table.problems.count("comment") == 1);
  CHECK(table.problems.count("force") == 0);
}

}  // namespace stepwire::table
