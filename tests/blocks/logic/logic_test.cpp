#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Returns the output of a block for t = 0, 1, ..., where a = 0 1 0 1 ... and b = 0 0 1 1 ...
std::vector<double> truth_table(const std::string& keys) {
  const std::string inputs = R"x(
step: 1
stop: 3
blocks:
  t: {block: Clock}
  a: {block: Expression, expression: "mod(u, 2)", u: t}
  b: {block: Expression, expression: "u >= 2", u: t}
)x";
  return column(run_text(inputs + "  y: {" + keys + "}\nrecord: [y]\n"), "y");
}

std::vector<double> over_time(int stop, const std::string& expression, const std::string& keys) {
  return column(run_text("step: 1\nstop: " + std::to_string(stop) + "\nblocks:\n  t: {block: Clock}\n" +
                         "  u: {block: Expression, expression: \"" + expression + "\", u: t}\n  y: {" + keys +
                         "}\nrecord: [y]\n"),
                "y");
}

using Values = std::vector<double>;

}  // namespace

TEST_CASE("Logic joins two inputs by its truth table") {
  const auto join = [](const std::string& word) {
    return truth_table("block: Logic, operator: " + word + ", u: [a, b]");
  };
  CHECK(join("and") == Values{0, 0, 0, 1});
  CHECK(join("or") == Values{0, 1, 1, 1});
  CHECK(join("nand") == Values{1, 1, 1, 0});
  CHECK(join("nor") == Values{1, 0, 0, 0});
  CHECK(join("xor") == Values{0, 1, 1, 0});
  CHECK(join("xnor") == Values{1, 0, 0, 1});
}

TEST_CASE("Logic takes one input and many, and joins vectors with scalars") {
  CHECK(truth_table("block: Logic, operator: not, u: a") == Values{1, 0, 1, 0});
  CHECK(truth_table("block: Logic, operator: xor, u: [a, b, 1]") == Values{1, 0, 0, 1});
  CHECK(truth_table("block: Logic, operator: and, u: [a, -1]") == Values{0, 0, 0, 0});
  const table::Table table = run_text(
      "step: 1\nstop: 1\nblocks:\n  v: {block: Constant, value: [1, 0]}\n"
      "  y: {block: Logic, operator: and, u: [v, 1]}\nrecord: [y]\n");
  CHECK(column(table, "y.1")[0] == 1.0);
  CHECK(column(table, "y.2")[0] == 0.0);
}

TEST_CASE("Not of several inputs is refused, and a wrong word gets a suggestion") {
  const std::string head = "step: 1\nstop: 1\nblocks:\n";
  CHECK_THAT(error_of(head + "  y: {block: Logic, operator: not, u: [1, 0]}\n"),
             Catch::Contains("'not' takes one input"));
  CHECK_THAT(error_of(head + "  y: {block: Logic, operator: adn, u: [1, 0]}\n"), Catch::Contains("and"));
}

TEST_CASE("Compare knows six relations by word and by sign") {
  const auto compare = [](const std::string& relation) {
    return over_time(2, "u", "block: Compare, operator: " + relation + ", u: u, to: 1");
  };
  CHECK(compare("less") == Values{1, 0, 0});
  CHECK(compare("less_equal") == Values{1, 1, 0});
  CHECK(compare("greater") == Values{0, 0, 1});
  CHECK(compare("greater_equal") == Values{0, 1, 1});
  CHECK(compare("equal") == Values{0, 1, 0});
  CHECK(compare("not_equal") == Values{1, 0, 1});
  CHECK(compare("\"<\"") == compare("less"));
  CHECK(compare("\"<=\"") == compare("less_equal"));
  CHECK(compare("\">\"") == compare("greater"));
  CHECK(compare("\">=\"") == compare("greater_equal"));
  CHECK(compare("\"==\"") == compare("equal"));
  CHECK(compare("\"!=\"") == compare("not_equal"));
}

TEST_CASE("Compare compares a vector with a number and checks the unit") {
  const std::string head =
      "step: 1\nstop: 1\nblocks:\n  v: {block: Constant, value: {value: [4, 6], unit: mm}}\n";
  const table::Table table =
      run_text(head + "  y: {block: Compare, u: v, operator: greater, to: 5 mm}\nrecord: [y]\n");
  CHECK(column(table, "y.1")[0] == 0.0);
  CHECK(column(table, "y.2")[0] == 1.0);
  CHECK_FALSE(error_of(head + "  y: {block: Compare, u: v, operator: greater, to: 5 N}\n").empty());
}

TEST_CASE("A switch passes one of two signals on") {
  const auto pass = [](const std::string& more) {
    return over_time(4, "u - 2", "block: Switch, control: u, then: t, else: -1" + more);
  };
  CHECK(pass("") == Values{-1, -1, -1, 3, 4});
  CHECK(pass(", threshold: 1, criterion: greater_equal") == Values{-1, -1, -1, 3, 4});
  CHECK(pass(", criterion: not_equal") == Values{0, 1, -1, 3, 4});
}

TEST_CASE("Hysteresis becomes 1 at the upper and 0 at the lower threshold") {
  const auto y = over_time(8, "4 - abs(u - 4)", "block: Hysteresis, lower: 1, upper: 3, u: u");
  CHECK(y == Values{0, 0, 0, 1, 1, 1, 1, 0, 0});
  CHECK(over_time(3, "2", "block: Hysteresis, lower: 1, upper: 3, u: u, initial: 1") == Values{1, 1, 1, 1});
  CHECK_THAT(error_of("step: 1\nstop: 1\nblocks:\n  h: {block: Hysteresis, lower: 3, upper: 1, u: 1}\n"),
             Catch::Contains("h.lower"));
}

TEST_CASE("A latch remembers from set to reset, and its priority decides where both are true") {
  const std::string head = R"(
step: 1
stop: 5
blocks:
  t: {block: Clock}
  s: {block: Expression, expression: "u == 1 || u == 4", u: t}
  r: {block: Expression, expression: "u == 3 || u == 4", u: t}
  y: {block: Latch, set: s, reset: r)";
  CHECK(column(run_text(head + "}\nrecord: [y]\n"), "y") == Values{0, 1, 1, 0, 0, 0});
  CHECK(column(run_text(head + ", priority: set}\nrecord: [y]\n"), "y") == Values{0, 1, 1, 0, 1, 1});
  CHECK(column(run_text(head + ", initial: 1}\nrecord: [y]\n"), "y") == Values{1, 1, 1, 0, 0, 0});
}

TEST_CASE("An edge is 1 for one tick, and never at the first") {
  const auto edges = [](const std::string& edge) {
    return over_time(6, "u < 1 || (u > 2 && u < 5)",
                     "block: EdgeDetect, u: u, edge: " + edge);  // 1 0 0 1 1 0 0
  };
  CHECK(edges("rising") == Values{0, 0, 0, 1, 0, 0, 0});
  CHECK(edges("falling") == Values{0, 1, 0, 0, 0, 1, 0});
  CHECK(edges("either") == Values{0, 1, 0, 1, 0, 1, 0});
}
