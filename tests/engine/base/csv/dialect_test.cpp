#include <catch2/catch.hpp>
#include <cmath>

#include "engine/base/csv/read_record.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::csv {

namespace {

using Values = std::vector<double>;

table::RecordTable read(const std::string& content, Decimal decimal = Decimal::detect) {
  const Scratch scratch;
  return read_record(scratch.file("press.csv", content), decimal);
}

Values column(const std::string& content, const std::string& name, Decimal decimal = Decimal::detect) {
  const table::RecordTable table = read(content, decimal);
  INFO(content);
  REQUIRE(table.find(name));
  REQUIRE(table.problems.count(name) == 0);
  return table.find(name)->values;
}

/// The problem of a column without the folder; empty for none.
std::string problem(const std::string& content, const std::string& name, Decimal decimal = Decimal::detect) {
  const auto problems = read(content, decimal).problems;
  const auto at = problems.find(name);
  return at == problems.end() ? "" : at->second.substr(at->second.find("press.csv"));
}

std::string unit(const std::string& content, const std::string& name) {
  const table::RecordTable table = read(content);
  INFO(content);
  REQUIRE(table.find(name));
  return table.find(name)->unit;
}

}  // namespace

TEST_CASE("a decimal comma is found between semicolons, tabs and blanks, and in quotes between commas") {
  CHECK(column("t;x\n0;0\n0,5;1,25\n", "x") == Values{0.0, 1.25});
  CHECK(column("t\tx\n0\t0\n0,5\t1,25\n", "x") == Values{0.0, 1.25});
  CHECK(column("t x\n0 0\n0,5 1,25\n", "x") == Values{0.0, 1.25});
  // pandas 1.5.3: DataFrame({'t': [0., .5], 'x': [0., 1.25]}).to_csv(index=False, decimal=',')
  CHECK(column("t,x\n\"0,0\",\"0,0\"\n\"0,5\",\"1,25\"\n", "x") == Values{0.0, 1.25});
  // and .to_csv(index=False, sep=';', decimal=',')
  CHECK(column("t;x\n0,0;0,0\n0,5;1,25\n", "t") == Values{0.0, 0.5});
}

TEST_CASE("cells without proof follow the mark that other cells of the file prove") {
  CHECK(column("t;x\n0,5;1,234\n1;2,000\n", "x") == Values{1.234, 2.0});
  CHECK(column("t;x\n0.5;1.234\n1;2.000\n", "x") == Values{1.234, 2.0});
  CHECK(column("t;x\n0,5;1.234,5\n1;2.000\n", "x") == Values{1234.5, 2000.0});
  CHECK(column("t;x\n0.5;1,234.5\n1;2,000\n", "x") == Values{1234.5, 2000.0});
  CHECK(column("t,x\n0.5,\"1,234.5\"\n1,\"2,000\"\n", "x") == Values{1234.5, 2000.0});
  CHECK(column("t,x\n0.5,\"2,000\"\n1,3\n", "x") == Values{2000.0, 3.0});
  CHECK(column("t,x\n1.234,2.345\n", "x") == Values{2.345});  // plain commas part columns: points are decimal
}

TEST_CASE("bars part columns where the header and the next line have as many") {
  CHECK(column("t|x [mm]\n0|0,5\n1|1,5\n", "x") == Values{0.5, 1.5});
  CHECK(unit("t|x\ns|mm\n0|1\n1|2\n", "x") == "mm");
  CHECK(column("t,|x|\n0,1\n1,2\n", "|x|") == Values{1.0, 2.0});
  CHECK(column("|x|\n1\n2\n", "|x|") == Values{1.0, 2.0});
}

TEST_CASE("fixed blanks around a cell are blanks") {
  CHECK(column("t;\xC2\xA0x [mm]\n0;\xC2\xA0"
               "1,5\n1;2,5\xC2\xA0\xE2\x80\xAF\n",
               "x") == Values{1.5, 2.5});
}

TEST_CASE("a large number of a text has the rest that its double lacks") {
  const table::RecordTable table = read("t,x\n1767225600,0\n1767225600.1,1e7\n+1767225600.25 ,10000000.3\n");
  const Values &t = table.find("t")->values, &rest = table.rests.at("t");
  CHECK((t[1] - t[0]) + (rest[1] - rest[0]) == Approx(0.1).margin(1e-16));
  CHECK((t[2] - t[0]) + (rest[2] - rest[0]) == 0.25);
  CHECK(read("t;x\n0;-1.767.225.600,1\n1;0\n").rests.at("x")[0] ==
        Approx(-(0.1 - (1767225600.1 - 1767225600.0))).margin(1e-16));
  CHECK(read("t,x\n0.1,1\n1e9,123456.7\n").rests.empty());
}

TEST_CASE("a number that may be a thousand times another one is refused with both cures") {
  const std::string expected =
      "press.csv:2: '1,234' is 1.234 or 1234: write `decimal: \",\"` where the comma is decimal, or "
      "`decimal: "
      "\".\"` where it parts thousands (column 'x')";
  CHECK(problem("t;x\n0;1,234\n1;2,000\n", "x") == expected);
  CHECK(problem("t,x\n0,\"1,234\"\n1,\"2,000\"\n", "x") == expected);
  CHECK(problem("t;x\n0;1.234\n1;2.000\n", "x") ==
        "press.csv:2: '1.234' is 1.234 or 1234: write `decimal: \".\"` where the point is decimal, or "
        "`decimal: "
        "\",\"` where it parts thousands (column 'x')");
  // the point of the times does not show that the same hand wrote the values
  CHECK(problem("t;x\n0.5;1,234\n1;2,000\n", "x") == expected);
  CHECK(problem("t;x\n0,5;1.234\n1;2.000\n", "x") != "");
  CHECK(problem("t;x\n0,5;1.234\n1;2.000\n", "t").empty());
  CHECK(problem("t;x;y;z\n0,5;1.234;0.5;0,5\n1;2.000;1;1\n", "x") != "");
}

TEST_CASE("a given decimal mark settles what is open, and refuses the other one") {
  CHECK(column("t;x\n0;1,234\n1;2,000\n", "x", Decimal::comma) == Values{1.234, 2.0});
  CHECK(column("t;x\n0;1,234\n1;2,000\n", "x", Decimal::point) == Values{1234.0, 2000.0});
  CHECK(column("t;x\n0;1.234\n1;2.000\n", "x", Decimal::comma) == Values{1234.0, 2000.0});
  CHECK(problem("t;x\n0;0.5\n", "x", Decimal::comma) ==
        "press.csv:2: '0.5' is no number with a decimal comma; say `decimal: \".\"` (column 'x')");
  CHECK(problem("t;x\n0;0,5\n", "x", Decimal::point) ==
        "press.csv:2: '0,5' is no number with a decimal point; say `decimal: \",\"` (column 'x')");
}

TEST_CASE("both marks in a file are refused in the columns of the rarer one") {
  const std::string text = "t;x;y\n0,5;1,5;2.5\n1,5;2,5;3.5\n";
  CHECK(problem(text, "y") ==
        "press.csv:2: '2.5' has a decimal point, but '0,5' in line 2 has a decimal comma; write one of them "
        "in the "
        "whole file (column 'y')");
  CHECK(column(text, "x") == Values{1.5, 2.5});
  CHECK(problem("t;x\n0,5;1.5\n", "t") != "");
  CHECK(problem("t;x\n0,5;1.5\n", "x") != "");
  CHECK(problem("t;x\n0;1.5\n1;2,5\n", "x") != "");
  CHECK(column("t;x;version\n0,5;1,5;v1.2\n", "x") == Values{1.5});  // a text proves nothing
}

TEST_CASE("decimal commas between commas are refused with the cure") {
  CHECK_THROWS_WITH(read("t,x\n0,5,1,5\n"),
                    Catch::Contains("press.csv:2: 4 values where the header names 2; decimal "
                                    "commas between commas cannot be told apart"));
}

TEST_CASE("a header below other lines, and one whose names contain blanks, are refused with the cure") {
  const std::string cure = "; if this line is the header, delete the lines above it, or begin them with '#'";
  CHECK_THROWS_WITH(read("Logger 7\nt,x\n0,1\n"),
                    Catch::EndsWith("press.csv:2: 2 values where the header names 1" + cure));
  CHECK_THROWS_WITH(read("Logger,7\nDate,today\nt,x,y,z\n0,1,2,3\n"),
                    Catch::EndsWith("press.csv:3: 4 values where the header names 2" + cure));
  CHECK_THROWS_WITH(
      read("t [s]   x [mm]\n0  1.5\n1  2.5\n"),
      Catch::EndsWith(
          "press.csv:1: the header 't [s]   x [mm]' is one name, but the row below has 2 values parted "
          "by blanks; part names and values by commas, semicolons or tabs, or write names without "
          "blanks"));
  CHECK(column("time of day\n27.11.2026 10:00:00\n", "time of day") == Values{0.0});
}

TEST_CASE("units are read from brackets and parentheses in the header") {
  CHECK(unit("t (s),x (mm)\n0,1\n", "x") == "mm");
  CHECK(unit("Time(s),x\n0,1\n", "Time") == "s");
  CHECK(unit("t [s],x (m/s)\n0,1\n", "x") == "m/s");
  CHECK(unit("t,x (filtered)\n0,1\n", "x (filtered)").empty());
  for (const char* none : {"x [-]", "x (-)", "x [--]", "x [\xE2\x80\x93]"})
    CHECK(unit(std::string("t,") + none + "\n0,1\n", "x") == "1");
  CHECK(unit("t,x(1)\n0,1\n", "x(1)").empty());
  CHECK(unit("t,x(t)\n0,1\n", "x(t)").empty());
  const std::string both = "t,F (N),F (kN)\n0,1,2\n";
  CHECK(unit(both, "F (N)") == "N");
  CHECK(unit(both, "F (kN)") == "kN");
  CHECK(read("t,x (mm)\n0,1\n").find_titled("x (mm)"));
  CHECK_FALSE(read("t,x (mm)\n0,1\n").find_titled("x (m)"));
}

TEST_CASE("a row of units below the names is used as brackets are") {
  const std::string text = "t;x;F;n\ns;mm;kN;1\n0;1,5;2;3\n0,5;2,5;3;4\n";
  CHECK(unit(text, "t") == "s");
  CHECK(unit(text, "x") == "mm");
  CHECK(unit(text, "F") == "kN");
  CHECK(unit(text, "n") == "1");
  CHECK(column(text, "x") == Values{1.5, 2.5});
  CHECK(unit("t,x,n\n[s],(mm),-\n0,1,2\n", "x") == "mm");
  CHECK(unit("t,x,note\ns,mm,\n0,1,ok\n", "x") == "mm");
  CHECK(unit("t [s],x [mm]\ns,mm\n0,1\n", "x") == "mm");
  CHECK_THROWS_WITH(read("t [s],x [mm]\ns,m\n0,1\n"),
                    Catch::Contains("press.csv:2: 'x' is in mm by its name, but in m by this row"));
  CHECK(read("t;x\ns;mm\n0;1\n1;2\n").line_of(1) == 4);
}

TEST_CASE("a first row of values is no row of units") {
  CHECK(problem("t,x\n0,m\n1,2\n", "x") == "press.csv:2: 'm' is no number (column 'x')");
  CHECK(problem("name,x\nAnn,m\nBob,n\n", "x") == "press.csv:2: 'm' is no number (column 'x')");
  CHECK(problem("t,gear\n1,N\n2,1\n", "gear") == "press.csv:2: 'N' is no number (column 'gear')");
}

TEST_CASE("empty cells and words for them are missing numbers, and texts are problems") {
  const table::RecordTable table = read("t,x,y\n0,1,\n1,,2\n2,NaN,N/A\n3,4,off\n");
  CHECK(table.problems.count("x") == 0);
  CHECK(std::isnan(table.find("x")->values.at(1)));
  CHECK(std::isnan(table.find("x")->values.at(2)));
  CHECK(table.find("x")->values.at(3) == 4.0);
  CHECK_THAT(table.problems.at("y"), Catch::EndsWith("press.csv:5: 'off' is no number (column 'y')"));
}

TEST_CASE("times of the calendar become seconds from the first row") {
  // pandas 1.5.3: DataFrame({'t': date_range('2026-11-27 10:00', periods=3,
  // freq='250ms')}).to_csv(index=False)
  CHECK(column("t,x\n2026-11-27 10:00:00.000,0\n2026-11-27 10:00:00.250,1\n2026-11-27 10:00:00.500,2\n",
               "t") == Values{0.0, 0.25, 0.5});
  CHECK(unit("t [ms];x\n2026-11-27T10:00:00Z;0\n", "t") == "s");
  CHECK(column("t;x\n2026-11-27T10:00:00,250Z;0\n2026-11-27T11:00:00,5+01:00;1,5\n", "t") ==
        Values{0.0, 0.25});
  CHECK(column("t;x\n2026-11-27T10:00:01Z;0\n2026-11-27T10:00:00Z;1\n", "t") == Values{1.0, 0.0});
  CHECK(read("t;x\n2026-11-27T10:00:00Z;0\n").notes.back() == "'t' in seconds from 2026-11-27T10:00:00Z");
}

TEST_CASE("times of the day without a date count from the first one") {
  CHECK(column("t,x\n23:59:58.5,0\n23:59:59,1\n24:00:00,2\n", "t") == Values{0.0, 0.5, 1.5});
  CHECK(problem("t,x\n10:00:00,0\n2026-11-27 10:00:01,1\n", "t") != "");
}

TEST_CASE("times of several forms in a column are refused") {
  CHECK_THAT(
      problem("t,x\n2026-11-27T10:00:00Z,0\n2026-11-27T10:00:01,1\n", "t"),
      Catch::StartsWith("press.csv:3: '2026-11-27T10:00:01' is not written as '2026-11-27T10:00:00Z' at ") &&
          Catch::Contains("press.csv:2; write all times of a column in one form"));
  CHECK(problem("t,x\n2026-11-27T10:00:00Z,0\n1,1\n", "t") ==
        "press.csv:3: '1' is no time like '2026-11-27T10:00:00Z' (column 't')");
  CHECK(problem("t,x\n0,0\n2026-11-27T10:00:00Z,1\n", "t") != "");
}

TEST_CASE("blanks part columns where a line below the names has as many numbers, as Fortran writes them") {
  CHECK(column("  t     x\n  0.0   1.0D+03\n  0.5   2.5D-01\n", "x") == Values{1000.0, 0.25});
  CHECK(column("# t x\n0 1\n1 2\n", "x") == Values{1.0, 2.0});
  CHECK(problem("t x\n0.0 1.0+3\n0.5 2.5-1\n", "x") ==
        "press.csv:2: '1.0+3' is no number; write an exponent with its letter, 1.0e+3 (column 'x')");
}

TEST_CASE("a first line for a spreadsheet names the separator") {
  CHECK(column("sep=;\r\nt;x\r\n0;0,5\r\n", "x") == Values{0.5});
  CHECK(read("sep=;\nt;x\n0;0,5\n").line_of(0) == 3);
}

TEST_CASE("lines of rows are known below comments, units and quoted ends of lines") {
  const table::RecordTable table =
      read("# by hand\nt,x,note\ns,mm,\n0,1,\"two\nlines\"\n# a pause\n1,2,\n3,4,\n");
  CHECK(table.line_of(0) == 4);
  CHECK(table.line_of(1) == 7);
  CHECK(table.line_of(2) == 8);
}

}  // namespace stepwire::csv
