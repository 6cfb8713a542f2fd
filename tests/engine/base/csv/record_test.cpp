#include <catch2/catch.hpp>
#include <cmath>

#include "engine/base/csv/read_record.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::csv {

namespace {

using Values = std::vector<double>;

table::RecordTable read(const std::string& content) {
  const Scratch scratch;
  return read_record(scratch.file("press.csv", content));
}

}  // namespace

TEST_CASE("lines of a record that begin with # are passed over") {
  const table::RecordTable table =
      read("# a press, 2026\n# by hand\ntime [s];force [N]\n0;1\n# a pause\n1;2\n#end\n");
  REQUIRE(table.columns.size() == 2);
  CHECK(table.columns[1].name == "force");
  CHECK(table.columns[1].unit == "N");
  CHECK(table.columns[1].values == Values{1.0, 2.0});
}

TEST_CASE("a comment above numbers alone names the columns") {
  const table::RecordTable table = read("# of a plotter\n# time, force\n0,1\n1,2\n");
  REQUIRE(table.columns.size() == 2);
  CHECK(table.columns[0].name == "time");
  CHECK(table.columns[1].values == Values{1.0, 2.0});
}

TEST_CASE("a column of text is in nobody's way while nothing reads it") {
  const table::RecordTable table = read("time,comment,force\n0,ok,1\n1,not so good,2\n");
  REQUIRE(table.columns.size() == 3);
  CHECK(table.columns[2].values == Values{1.0, 2.0});
  CHECK(table.problems.count("comment") == 1);
  CHECK(table.problems.count("force") == 0);
}

TEST_CASE("in a record as other programs leave it only what is read must be numbers") {
  const Scratch scratch;
  const table::RecordTable table = read_record(scratch.file(
      "press.csv",
      ",t [s],x [mm],note,\n0,0,1,begins,\n1,0.1,2,\"\",\n2,0.2,off,,\n3,0.3,4,ends\n,,,,\n,,\n"));
  REQUIRE(table.columns.size() == 3);  // that of the row numbers and that of the trailing comma have no names
  CHECK(table.find("t")->values == Values{0.0, 0.1, 0.2, 0.3});
  CHECK(table.find("x")->values.at(3) == 4.0);
  CHECK(std::isnan(table.find("x")->values.at(2)));
  CHECK_THAT(table.problems.at("x"), Catch::EndsWith("press.csv:4: 'off' is no number (column 'x')"));
  CHECK_THAT(table.problems.at("note"),
             Catch::EndsWith("press.csv:2: 'begins' is no number (column 'note')"));
  CHECK(table.problems.count("t") == 0);
  CHECK_THROWS_WITH(read_record(scratch.file("a.csv", "a,b\n1,2,3\n")),
                    Catch::Contains("a.csv:2: 3 values where the header names 2"));
  CHECK_THROWS_WITH(read_record(scratch.file("a.csv", "a,b\n1\n")),
                    Catch::Contains("a.csv:2: 1 value where the header names 2"));
}

}  // namespace stepwire::csv
