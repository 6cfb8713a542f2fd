#include <bit>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include "engine/base/data_file/data_file.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::table {

namespace {

Table read(const std::string& content) {
  const Scratch scratch;
  return read_csv(scratch.file("press.csv", content));
}

/// The message without the folder.
std::string wrong(const std::string& content) {
  try {
    read(content);
  } catch (const stepwire::table::TableError& error) {
    const std::string message = error.what();
    return message.substr(message.find("press.csv"));
  }
  return "no error";
}

using Values = std::vector<double>;

}  // namespace

TEST_CASE("a CSV file gives its columns with names and units") {
  const Table table =
      read("time [s],rig.x [mm],push,x[2],F[N], a [N m] \n0,1.5,-2e-3,4,5,6\n1e-3,.25,+3,4,5,6\n");
  REQUIRE(table.columns.size() == 6);
  CHECK(table.rows() == 2);
  CHECK(table.columns[0].name == "time");
  CHECK(table.columns[0].unit == "s");
  CHECK(table.columns[0].values == Values{0.0, 1e-3});
  CHECK(table.find("rig.x")->unit == "mm");
  CHECK(table.find("rig.x")->values == Values{1.5, 0.25});
  CHECK(table.find("push")->unit.empty());
  CHECK(table.find("push")->values == Values{-2e-3, 3.0});
  CHECK(table.find("x[2]")->unit.empty());
  CHECK(table.find("F")->unit == "N");
  CHECK(table.find("a")->unit == "N m");
  CHECK(table.find("b") == nullptr);
}

TEST_CASE("a number that is too large or too small for a double is told from what is no number") {
  CHECK(wrong("time,x\n0,1e400\n") ==
        "press.csv:2: '1e400' is too large: numbers are below 1.8e308 (column 'x')");
  CHECK(wrong("time,x\n0,-1e5000\n") ==
        "press.csv:2: '-1e5000' is too large: numbers are below 1.8e308 (column 'x')");
  CHECK(wrong("time,x\n0,1e-400\n") ==
        "press.csv:2: '1e-400' is too small: numbers are 0 or above 4.9e-324 (column 'x')");
  CHECK(wrong("time,x\n0,1e400x\n") == "press.csv:2: '1e400x' is no number (column 'x')");
  CHECK(read("x\n1e308\n5e-324\n0e-999\n").columns[0].values == Values{1e308, 5e-324, 0.0});
}

TEST_CASE("semicolons, tabs, quotes, CRLF, a byte-order mark and empty last lines are understood") {
  CHECK(read("a;b\n1;2\n").find("b")->values == Values{2.0});
  CHECK(read("a\tb\n1\t2").find("b")->values == Values{2.0});
  CHECK(read("\"a,b\";c\n1;2\n").find("a,b")->values == Values{1.0});
  CHECK(read("\"a \"\"b\"\" [N]\",c\n\"1\",\"2\"\n").find("a \"b\"")->unit == "N");
  CHECK(read("a,b\r\n1,2\r\n3,4\r\n").find("b")->values == Values{2.0, 4.0});
  CHECK(read("\xEF\xBB\xBF"
             "a,b\n1,2\n")
            .find("a")
            ->values == Values{1.0});
  CHECK(read("a,b\n 1 , 2 \n\n\n").find("b")->values == Values{2.0});
  CHECK(read("a\n1\n2").find("a")->values == Values{1.0, 2.0});
}

TEST_CASE("infinities, nan, -0 and numbers near the smallest double are numbers in a file") {
  const Values values = read("a\nnan\nNaN\ninf\n-Inf\n0\n-0\n5e-324\n").columns[0].values;
  CHECK(std::isnan(values.at(0)));
  CHECK(std::isnan(values.at(1)));
  CHECK(values.at(2) == std::numeric_limits<double>::infinity());
  CHECK(values.at(3) == -std::numeric_limits<double>::infinity());
  CHECK(values.at(4) == 0.0);
  CHECK(std::signbit(values.at(5)));
  CHECK(values.at(6) == 5e-324);
}

TEST_CASE("a column of words is numbered where the caller says that it is one") {
  const Scratch scratch;
  const std::string path = scratch.file("a.csv", "time [s],way [m],x\n0,hold,1\n1,\"a,b\",2\n2,hold,+3\n");
  CHECK_THROWS_WITH(read_csv(path), Catch::Contains("a.csv:2: 'hold' is no number (column 'way')"));
  stepwire::table::ColumnWords words{{"way", {}}, {"other", {}}};
  const Table table = read_csv(path, words);
  CHECK(words.at("way") == std::vector<std::string>{"hold", "a,b"});
  CHECK(words.at("other").empty());
  CHECK(table.find("way")->values == Values{0.0, 1.0, 0.0});
  CHECK(table.find("way")->unit == "m");
  CHECK(table.find("x")->values == Values{1.0, 2.0, 3.0});
  CHECK(stepwire::table::read_csv_header(path).columns.at(1).unit == "m");
  CHECK(read_csv(scratch.file("b.csv", "a,b\n"), words).columns.size() == 2);
  CHECK(csv_text(table, words) == "time [s],way [m],x\n0,hold,1\n1,\"a,b\",2\n2,hold,3\n");
}

TEST_CASE("what is wrong in a CSV file is said with its line") {
  CHECK(wrong("a,b\n1,2\n3,abc\n") == "press.csv:3: 'abc' is no number (column 'b')");
  CHECK(wrong("a,b\n1,\n") == "press.csv:2: '' is no number (column 'b')");
  CHECK(wrong("a,b\n1,2 mm\n") == "press.csv:2: '2 mm' is no number (column 'b')");
  CHECK(wrong("a,b\n1,0x10\n") == "press.csv:2: '0x10' is no number (column 'b')");
  CHECK(wrong("a,b\n1,1e999\n") ==
        "press.csv:2: '1e999' is too large: numbers are below 1.8e308 (column 'b')");
  CHECK(wrong("a;b\n1;2,5\n") == "press.csv:2: '2,5' is no number (column 'b')");
  CHECK(wrong("a,b\n1,2\n3\n") == "press.csv:3: 1 value where the header names 2");
  CHECK(wrong("a,b\n1,2,3\n") == "press.csv:2: 3 values where the header names 2");
  CHECK(wrong("a,b\n1,2\n\n3,4\n") == "press.csv:3: 1 value where the header names 2");
  CHECK(wrong("a,a\n1,2\n") == "press.csv:1: two columns are named 'a'");
  CHECK(wrong("a,\n1,2\n") == "press.csv:1: column 2 has no name");
  CHECK(wrong("0,1\n1,2\n") == "press.csv:1: the first line holds numbers; it must name the columns");
  CHECK(wrong("a,b\n") == "press.csv: there are no rows below the header");
  CHECK(wrong("") == "press.csv: the file is empty");
  CHECK(wrong(" \n\n") == "press.csv: the file is empty");
  CHECK(wrong("a,\"b\n1,2\n") == "press.csv:1: a quote is not closed");
  CHECK(wrong("a,b\n1,\"2\"3\n") == "press.csv:2: text follows the quoted \"2\"");
  CHECK(wrong("a\n" + std::string(60, 'y')) ==
        "press.csv:2: '" + std::string(40, 'y') + "...' is no number (column 'a')");
}

TEST_CASE("a missing file is a matter of the surroundings and keeps the system's reason") {
  const Scratch scratch;
  CHECK_THROWS_WITH(read_csv(scratch.path("none.csv")),
                    Catch::Contains("none.csv: No such file or directory"));
  CHECK_THROWS_AS(read_csv(scratch.path("none.csv")), stepwire::io::EnvironmentError);
  CHECK_THROWS_WITH(read_csv(scratch.path("")), Catch::Contains("Is a directory"));
  CHECK_THROWS_WITH(stepwire::data_file::read_data_file(scratch.file("a.xlsx", "")),
                    Catch::Contains("not '.xlsx'; save a workbook as CSV"));
}

TEST_CASE("numbers are written in the fewest digits") {
  const Table table{{{"time", "s", {0.0, 0.1, 1e-3}},
                     {"a,b", "", {1.0 / 3.0, 1e22, -0.0}},
                     {"q", "\"", {5.0, NAN, -INFINITY}}}};
  CHECK(csv_text(table) ==
        "time [s],\"a,b\",\"q [\"\"]\"\n0,0.3333333333333333,5\n0.1,1e+22,nan\n0.001,-0,-inf\n");
}

TEST_CASE("every double comes back from a CSV file with the same bits") {
  std::mt19937_64 random(3);
  Table table{{{"a", "mm/s", {}}, {"b [1].y", "", {}}}};
  for (int i = 0; i < 5000; ++i) {
    const double value = std::bit_cast<double>(random());
    table.columns[0].values.push_back(std::isnan(value) ? 0.0 : value);
    table.columns[1].values.push_back(std::ldexp(double(random()), -64));
  }
  const Scratch scratch;
  write_csv(scratch.path("a.csv"), table);
  const Table back = stepwire::table::read_csv(scratch.path("a.csv"));
  REQUIRE(back.columns.size() == 2);
  for (std::size_t c = 0; c < 2; ++c) {
    CHECK(back.columns[c].name == table.columns[c].name);
    CHECK(back.columns[c].unit == table.columns[c].unit);
    for (std::size_t i = 0; i < table.rows(); ++i) {
      REQUIRE(std::bit_cast<std::uint64_t>(back.columns[c].values.at(i)) ==
              std::bit_cast<std::uint64_t>(table.columns[c].values[i]));
    }
  }
}

TEST_CASE("columns of different lengths are no CSV table") {
  CHECK_THROWS_AS(csv_text({{{"a", "", {1.0}}, {"b", "", {}}}}), stepwire::table::TableError);
}

TEST_CASE("ten megabytes are read within a second") {
  std::mt19937_64 random(5);
  Table table{{{"a", "", {}}, {"b", "", {}}, {"c", "", {}}}};
  for (int i = 0; i < 180'000; ++i) {
    for (Column& column : table.columns) column.values.push_back(std::ldexp(double(random()), -64));
  }
  const Scratch scratch;
  const std::string text = csv_text(table);
  REQUIRE(text.size() > 10'000'000);
  const std::string path = scratch.file("large.csv", text);
  const auto before = std::chrono::steady_clock::now();
  const Table back = read_csv(path);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - before;
  CHECK(back.columns[2].values == table.columns[2].values);
  INFO(spent.count() << " s");
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  CHECK(spent.count() < 1.0);
#endif
}

TEST_CASE("what is too large or too small to be a double is refused, however far") {
  const Scratch scratch;
  for (const char* number :
       {"1e400", "1e5000", "-1e5000", "1e999999999999999999999", "0.001e404", "1234.5e308", "1e-400",
        "1e-5000", "-1e-5000", "1e-999999999999999999999", "1000e-404"})
    CHECK_THROWS_AS(read_csv(scratch.file("a.csv", std::string("x\n") + number + "\n")), TableError);
  // The smallest double, and one that rounds to it.
  CHECK(read_csv(scratch.file("a.csv", "x\n4.9e-324\n")).columns[0].values[0] == 4.9406564584124654e-324);
}

TEST_CASE("a field without end is refused") {
  const Scratch scratch;
  const std::string long_field(1'000'000, '1');
  CHECK_THROWS_WITH(read_csv(scratch.file("a.csv", "x\n" + long_field + "\n")),
                    Catch::Contains("a.csv:2: a field has more than 100000 characters"));
  CHECK_THROWS_WITH(read_csv(scratch.file("a.csv", "x\n\"" + long_field + "\"\n")),
                    Catch::Contains("a.csv:2: a field has more than 100000 characters"));
  CHECK_THROWS_WITH(read_csv(scratch.file("a.csv", long_field + "\n1\n")),
                    Catch::Contains("a.csv:1: a field has more than 100000 characters"));
}

TEST_CASE("Words that a spreadsheet would compute are kept from it and read back as they were") {
  const std::vector<std::string> words{"=1+2", "+1+2",  "-cmd", "@SUM(A1)", "\t=1",   "\r=1", "'=1",  "''=1",
                                       "'",    "plain", "-5",   "+3.5",     "'plain", "=",    "-5 mm"};
  stepwire::table::Table table{{{"word", "", {}}, {"=name", "m", {}}}};
  for (std::size_t i = 0; i < words.size(); ++i) {
    table.columns[0].values.push_back(static_cast<double>(i));
    table.columns[1].values.push_back(-1.5);
  }
  const std::string text = stepwire::table::csv_text(table, {{"word", words}});
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string cell = line.substr(line.front() == '"' ? 1 : 0);
    INFO(line);
    CHECK((cell.find_first_of("=+-@\t\r") != 0 || cell.starts_with("-5,") || cell.starts_with("+3.5,")));
  }
  CHECK(text.find("'=name [m]") != std::string::npos);
  CHECK(text.find(",-1.5\n") != std::string::npos);
  const Scratch scratch;
  stepwire::table::ColumnWords read{{"word", {}}};
  const stepwire::table::Table back = stepwire::table::read_csv(scratch.file("words.csv", text), read);
  CHECK(read["word"] == words);
  CHECK(back.columns[1].name == "=name");
}

}  // namespace stepwire::table
