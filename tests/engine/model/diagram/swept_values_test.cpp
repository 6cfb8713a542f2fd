#include "engine/model/diagram/sweep.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

TEST_CASE("a swept number is written so that it reads back as the same double") {
  const std::vector<double> numbers{0.1, 1.0 / 3.0, 2e-17, -123456789.123456789, 1e22, 5.0};
  for (const std::string unit : {"", "N/m", "mm", "deg"}) {
    const SweptValues values(numbers, unit, {3, 7});
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto read = unit::parse_quantity(values.text(i));
      REQUIRE(read);
      CHECK(read->value == values.number(i));
      CHECK(values.mark(i).column == 7);
    }
  }
  CHECK(SweptValues({0.25}, "N/m", {}).text(0) == "0.25 N/m");
}

TEST_CASE("texts may stand at several points of a sweep") {
  const SweptValues values({"ice", "road"}, {{1, 2}, {1, 9}}, {1, 0, 1});
  CHECK(values.size() == 3);
  CHECK(values.text(0) + values.text(1) + values.text(2) == "roadiceroad");
  CHECK(values.mark(2).column == 9);
  CHECK_FALSE(values.are_numbers());
}

namespace {

Sweep::Axis axis(std::string name, std::size_t values, bool sampled = false) {
  Sweep::Axis axis{std::move(name), SweptValues(std::vector<double>(values, 1.0), "", {}), {}};
  if (sampled) axis.group = Sweep::Group::samples;
  return axis;
}

}  // namespace

TEST_CASE("the last axis of a grid runs fastest, and paired axes run side by side") {
  Sweep sweep{{axis("a", 2), axis("b", 3)}};
  CHECK(sweep.count() == 6);
  CHECK(sweep.indices(1) == std::vector<std::size_t>{0, 1});
  CHECK(sweep.indices(5) == std::vector<std::size_t>{1, 2});
  sweep.together = true;
  CHECK(sweep.count() == 3);
  CHECK(sweep.indices(1) == std::vector<std::size_t>{1, 1});
}

TEST_CASE("sampled axes are one axis of a grid, so that every listed value meets every sample") {
  const Sweep sweep{{axis("k", 5, true), axis("road", 2), axis("m", 5, true), axis("tyre", 3)}};
  CHECK(sweep.count() == 30);
  CHECK(sweep.indices(0) == std::vector<std::size_t>{0, 0, 0, 0});
  CHECK(sweep.indices(4) == std::vector<std::size_t>{1, 0, 1, 1});
  CHECK(sweep.indices(29) == std::vector<std::size_t>{4, 1, 4, 2});
}

}  // namespace stepwire::diagram
