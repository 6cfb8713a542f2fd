#include "engine/base/json/json.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>

namespace stepwire::json {

TEST_CASE("every kind of value is written as RFC 8259 says") {
  CHECK(Json().text() == "null");
  CHECK(Json(nullptr).text() == "null");
  CHECK(Json(true).text() == "true");
  CHECK(Json(-3).text() == "-3");
  CHECK(Json(std::numeric_limits<std::uint64_t>::max()).text() == "18446744073709551615");
  CHECK(Json(std::numeric_limits<std::int64_t>::min()).text() == "-9223372036854775808");
  CHECK(Json("a \"b\"\n\t\\ \x01 µ").text() == R"("a \"b\"\n\t\\ \u0001 µ")");
  CHECK(Json(std::string_view("x")).text() == "\"x\"");
  CHECK(Json::list().text() == "[]");
  CHECK(Json::object().text() == "{}");
  CHECK(Json::list({1, "a", false}).text(-1) == "[1,\"a\",false]");
  CHECK(Json::list_of(std::vector<double>{0.5, 2.0}).text(-1) == "[0.5,2.0]");
}

TEST_CASE("doubles are short and what JSON has no number for is null") {
  CHECK(Json(0.1).text() == "0.1");
  CHECK(Json(1.0).text() == "1.0");
  CHECK(Json(1e-7).text() == "1e-07");
  CHECK(Json(1.0 / 3.0).text() == "0.3333333333333333");
  CHECK(Json(std::numeric_limits<double>::denorm_min()).text() == "5e-324");
  CHECK(Json(std::numeric_limits<double>::infinity()).text() == "null");
  CHECK(Json(std::numeric_limits<double>::quiet_NaN()).text() == "null");
}

TEST_CASE("an object keeps its order and a key is there once") {
  Json object = Json::object().set("z", 1).set("a", Json::list({1, 2})).set("m", nullptr);
  object.set("z", 3);
  CHECK(object.text(-1) == R"({"z":3,"a":[1,2],"m":null})");
  CHECK(Json::object().set("a", Json::object().set("b", 1)).text() == "{\n  \"a\": {\n    \"b\": 1\n  }\n}");
}

TEST_CASE("null grows into a list or an object and a number does not") {
  CHECK(Json().push(1).text(-1) == "[1]");
  CHECK(Json().set("a", 1).text(-1) == "{\"a\":1}");
  CHECK_THROWS_AS(Json(1).push(2), std::logic_error);
  CHECK_THROWS_AS(Json("a").set("b", 2), std::logic_error);
}

TEST_CASE("bytes that are no UTF-8 are replaced") {
  CHECK(Json("a\xFF"
             "b")
            .text() ==
        "\"a\xEF\xBF\xBD"
        "b\"");
}

}  // namespace stepwire::json
