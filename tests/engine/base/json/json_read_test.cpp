#include <catch2/catch.hpp>
#include <string>

#include "engine/base/json/json.hpp"

namespace stepwire::json {

TEST_CASE("JSON that is read is written as it was") {
  for (const std::string text : {"{\"b\":[1,-2,0.5,true,null],\"a\":{}}", "\"\\\"\\\\ \xce\xa9\"",
                                 "18446744073709551615", "-9223372036854775808", "[]", "1e+300"})
    CHECK(Json::parse(text).text(-1) == text);
}

TEST_CASE("members, items, texts and numbers of JSON are found, and nothing where there is none") {
  const Json json = Json::parse("{\"text\": \"x\", \"list\": [1, 2.5], \"flag\": true}");
  CHECK(*json.find("text")->as_text() == "x");
  CHECK(json.find("list")->items().size() == 2);
  CHECK(json.find("list")->items()[1].as_number() == 2.5);
  CHECK(json.find("flag")->as_flag() == true);
  CHECK(json.find("none") == nullptr);
  CHECK(json.find("text")->find("x") == nullptr);
  CHECK(json.find("text")->items().empty());
  CHECK_FALSE(json.find("text")->as_number());
  CHECK_FALSE(json.find("flag")->as_text());
}

TEST_CASE("what is no JSON, or is nested without end, is refused") {
  for (const std::string text : {"", "{", "[1,]", "nul", "\"\xff\"", "{} {}", "'x'"})
    CHECK_THROWS_AS(Json::parse(text), JsonError);
  CHECK_THROWS_AS(Json::parse(std::string(100'000, '[')), JsonError);
  CHECK_THROWS_AS(Json::parse(std::string(200, '[') + std::string(200, ']')), JsonError);
  CHECK_NOTHROW(Json::parse(std::string(50, '[') + std::string(50, ']')));
}

}  // namespace stepwire::json
