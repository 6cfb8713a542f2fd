#include "engine/view/plot/table_rows.hpp"

#include <catch2/catch.hpp>

namespace stepwire::plot {

namespace {

const query::SymbolTable names{
    "test.yaml",
    {{"time", unit::parse_unit("s")->dimension, {}}, {"x", unit::parse_unit("m")->dimension, 0}},
    {{"limit", 0.253, unit::parse_unit("m")->dimension}}};

/// x = 0, 1, 2 m at 0, 1, 2 s.
std::vector<record::Recording> recordings() {
  record::Recording recording;
  recording.table.columns = {{"time", "s", {0.0, 1.0, 2.0}}, {"x", "m", {0.0, 1.0, 2.0}}};
  recording.starts = {0};
  return {recording};
}

text::TextTable table_of(const std::string& yaml) {
  yaml::Faults faults;
  const yaml::Document document = yaml::parse_document(yaml, "test.yaml");
  const TableRows rows = read_table_rows(document.root, names, faults);
  faults.throw_if_any();
  return filled(rows, recordings());
}

std::string fault_of(const std::string& yaml) {
  yaml::Faults faults;
  const yaml::Document document = yaml::parse_document(yaml, "test.yaml");
  read_table_rows(document.root, names, faults);
  return faults.size() == 0 ? "" : faults.list().front().message.text();
}

}  // namespace

TEST_CASE("a table of expressions has their values with their units, in the row that is selected") {
  const text::TextTable table = table_of(
      "{title: T, headings: [of, now, limit], where: time > 0.5 s, rows: {x: [x in mm, $limit in mm], "
      "none: [2*time/(1 s), 0.5]}}");
  CHECK(table.title == "T");
  CHECK(table.columns == std::vector<std::string>{"of", "now", "limit"});
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0] == std::vector<std::string>{"x", "1000 mm", "253 mm"});
  CHECK(table.rows[1] == std::vector<std::string>{"none", "2", "0.5"});
}

TEST_CASE("a table of expressions without headings, without rows, or with a short row is refused") {
  CHECK(fault_of("{rows: {a: 1}}").find("'headings' is missing") != std::string::npos);
  CHECK(fault_of("{headings: [a, b]}").find("'rows' is missing") != std::string::npos);
  CHECK(fault_of("{headings: [a, b, c], rows: {a: 1}}").find("1 value, but there are 2 headings") !=
        std::string::npos);
}

TEST_CASE("a table of expressions for which no row is selected ends with the place") {
  CHECK_THROWS_AS(table_of("{headings: [of, x], where: time > 9 s, rows: {a: x}}"), yaml::Error);
}

}  // namespace stepwire::plot
