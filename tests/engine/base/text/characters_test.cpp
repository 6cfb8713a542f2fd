#include "engine/base/text/characters.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace stepwire::text {

TEST_CASE("A text that people can read is shown as it is") {
  for (const std::string text : {"", "plain", "a\\b 'c' \"d\"", "größe µm/s² – 测量", "\U0001F600"}) {
    CHECK(visible(text) == text);
    CHECK(visible_lines(text) == text);
    CHECK(printable(text) == text);
  }
}

TEST_CASE("What moves the cursor, breaks the line or turns the direction is written out") {
  CHECK(visible("a\nb\tc\rd") == "a\\nb\\tc\\rd");
  CHECK(visible("\x1b[31m\x7f") == "\\x1b[31m\\x7f");
  CHECK(visible(std::string("\0end", 4)) == "\\x00end");
  CHECK(visible("\u0085\u202e\u2028\u2066\ufeff") == "\\u0085\\u202e\\u2028\\u2066\\ufeff");
  CHECK(visible("\U000e0041") == "\\U000e0041");
  CHECK(visible("\xff\xc3(") == "\\xff\\xc3(");
}

TEST_CASE("A text of several lines keeps them, a picture has blanks instead") {
  CHECK(visible_lines("a\n\tb\x1b") == "a\n\tb\\x1b");
  CHECK(printable("a\n\tb\x1b\u202e\xff.") == "a\n\tb   .");
}

TEST_CASE("What is written out has nothing left to write out") {
  for (int code = 1; code < 256; ++code) {
    const std::string once = visible(std::string(3, static_cast<char>(code)));
    INFO(code);
    CHECK(visible(once) == once);
  }
}

TEST_CASE("Control characters of JSON are its own escapes, which a reader takes back") {
  const std::string text = "\u0085 \u202e \U000e0041 \x7f";
  const std::string escaped = json_escaped(nlohmann::json(text).dump());
  CHECK(visible(escaped) == escaped);
  CHECK(nlohmann::json::parse(escaped).get<std::string>() == text);
}

}  // namespace stepwire::text
