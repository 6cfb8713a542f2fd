#include "engine/app/studio/text_merge.hpp"

#include <catch2/catch.hpp>

#include "engine/app/studio/fault.hpp"

namespace stepwire::studio {

TEST_CASE("places of changes count units of UTF-16") {
  const std::string text = "a\xce\xa9 \xf0\x9f\x98\x80 z\n";  // one unit, one, blank, two, blank, one
  CHECK(utf16_length(text) == 8);
  CHECK(changed(text, {{1, 2, "O"}}) == "aO \xf0\x9f\x98\x80 z\n");
  CHECK(changed(text, {{3, 5, "x"}}) == "a\xce\xa9 x z\n");
  CHECK(changed(text, {{8, 8, "end"}}) == text + "end");
  CHECK_THROWS_AS(changed(text, {{3, 4, ""}}), Fault);
  CHECK_THROWS_AS(changed(text, {{4, 5, ""}}), Fault);
  CHECK_THROWS_AS(changed(text, {{8, 9, ""}}), Fault);
  CHECK_THROWS_AS(changed(text, {{9, 9, "x"}}), Fault);
}

TEST_CASE("all places of one message lie in the text before, in any order") {
  CHECK(changed("0123456789", {{8, 9, "B"}, {0, 2, ""}, {2, 2, "A"}}) == "A234567B9");
  CHECK(changed("01", {{1, 1, "a"}, {1, 1, "b"}}) == "0ab1");
  CHECK(changed("", {{0, 0, "a"}}) == "a");
  CHECK(changed("abc", {}) == "abc");
  CHECK_THROWS_AS(changed("0123456789", {{0, 3, ""}, {2, 4, ""}}), Fault);
  CHECK_THROWS_AS(changed("0123456789", {{4, 3, ""}}), Fault);
}

TEST_CASE("a text is UTF-8 or it is none") {
  CHECK(is_utf8(""));
  CHECK(is_utf8("a\xce\xa9\xf0\x9f\x98\x80"));
  for (const std::string& text :
       std::vector<std::string>{"\xff", "a\xce", "\xc0\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80"})
    CHECK_FALSE(is_utf8(text));
}

}  // namespace stepwire::studio
