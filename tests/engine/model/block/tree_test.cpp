#include "engine/model/block/tree.hpp"

#include <catch2/catch.hpp>

#include "engine/model/block/value.hpp"

namespace stepwire {

TEST_CASE("a tree is an empty map until it is given one, and its copies outlive it") {
  Tree copy;
  REQUIRE(copy.value().map());
  CHECK(copy.value().map()->empty());
  {
    const Tree tree(Value{Value::Map{{"idle", {std::string("1"), 4, 2}}}});
    copy = tree;
    const Tree moved = std::move(copy);
    copy = moved;
  }
  const Value value = copy.value();
  REQUIRE(value.find("idle"));
  CHECK(*value.find("idle")->text() == "1");
  CHECK(value.find("idle")->line == 4);
}

}  // namespace stepwire
