#include "engine/analyse/statistics/condition_table.hpp"

#include <catch2/catch.hpp>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "tests/engine/analyse/statistics/textbook.hpp"

namespace stepwire::statistics {
using namespace textbook;
using Catch::Matchers::Contains;

namespace {

Observations without(Observations observations, std::size_t row) {
  observations.values.erase(observations.values.begin() + static_cast<std::ptrdiff_t>(row));
  for (Factor& factor : observations.factors)
    factor.level.erase(factor.level.begin() + static_cast<std::ptrdiff_t>(row));
  return observations;
}

const std::vector<std::string> types{"1", "2", "3", "4"};

}  // namespace

TEST_CASE("a subject who misses a condition is left out and named") {
  const ConditionTable table = condition_table(without(stools(), 6), "Type", "Subject", types);
  CHECK(table.left_out == std::vector<std::string>{"Subject 2 has no value under 3"});
  CHECK(table.subjects.size() == 8);
  CHECK(table.values.rows() == 8);
  CHECK(table.values(1, 0) == 7.0);  // of subject 3
  CHECK(table.observations.values.size() == 32);
  CHECK(table.observations.factor("Subject").levels.size() == 8);
}

TEST_CASE("a condition that nobody has met is left out, and the order is the one given") {
  const ConditionTable table = condition_table(sleep(), "group", "ID", {"2", "3", "1"});
  CHECK(table.conditions == std::vector<std::string>{"2", "1"});
  CHECK(table.left_out == std::vector<std::string>{"nobody has a value under 3"});
  CHECK(table.values(0, 0) == 1.9);
  CHECK(table.differences(0, 1)[0] == Approx(1.2));
}

TEST_CASE("one condition or one subject is refused in one sentence") {
  CHECK_THROWS_WITH(condition_table(sleep(), "group", "ID", {"1"}),
                    "comparisons need two conditions or more; there is 1 alone");
  const Observations few{
      "error", {1.0, 2.0, 3.0}, {running("condition", 2, 1, 3), running("subject", 2, 2, 3, true)}};
  CHECK_THROWS_WITH(condition_table(few, "condition", "subject", {"1", "2"}),
                    "comparisons need two subjects or more with a value under every condition; there is one "
                    "(subject 2 has no value under 2)");
}

}  // namespace stepwire::statistics
