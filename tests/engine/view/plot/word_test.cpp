#include <catch2/catch.hpp>

#include "engine/analyse/query/formula.hpp"

namespace stepwire::plot {
using Catch::Contains;

namespace {

query::SymbolTable names_with_words() {
  query::SymbolTable names{"a.yaml", {}, {}};
  names.columns = {{"x", {}, 0}, {"rig.method", {}, 0}};
  names.columns.push_back({"condition", {}, 0});
  names.columns.back().words = {"NO", "H", "HV"};
  return names;
}

record::Recording rows_of_conditions() {
  return {table::Table{{{"x", "", {1, 2, 3}}, {"rig.method", "", {0, 0, 0}}, {"condition", "", {0, 1, 2}}}},
          {0},
          {}};
}

std::vector<double> values_of(const std::string& text) {
  yaml::Faults faults;
  const yaml::Node node{yaml::Node::Kind::scalar, false, {1, 1}, {}, text, {}, {}};
  const auto formula = query::read_formula(node, names_with_words(), "where", faults);
  INFO(text);
  REQUIRE(faults.empty());
  return query::evaluate(*formula, rows_of_conditions());
}

std::string fault_of(const std::string& text) {
  yaml::Faults faults;
  const yaml::Node node{yaml::Node::Kind::scalar, false, {1, 1}, {}, text, {}, {}};
  query::read_formula(node, names_with_words(), "where", faults);
  REQUIRE(faults.size() == 1);
  return faults.list().front().text();
}

}  // namespace

TEST_CASE("a column of words is compared with words in either quotes") {
  using Values = std::vector<double>;
  CHECK(values_of("condition == \"HV\"") == Values{0, 0, 1});
  CHECK(values_of("condition!='NO'") == Values{0, 1, 1});
  CHECK(values_of("x < 3 && (condition == \"H\" || condition == \"HV\")") == Values{0, 1, 0});
  CHECK(values_of("condition == \"H\" ? x : 10 + x") == Values{11, 2, 13});
}

TEST_CASE("a word that a column does not have, or that stands elsewhere, is told with its place") {
  CHECK_THAT(fault_of("condition == \"VH\""),
             Catch::StartsWith("a.yaml:1:15: ") && Contains("'condition' is never 'VH'; did you mean 'H'?"));
  CHECK_THAT(fault_of("x == \"HV\""), Catch::StartsWith("a.yaml:1:6: ") && Contains("a column of words"));
  CHECK_THAT(fault_of("x + \"HV\""), Contains("a column of words"));
  CHECK_THAT(fault_of("condition == \"HV"), Contains("has no end"));
}

}  // namespace stepwire::plot
