#include "engine/model/signal/text.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace stepwire {

TEST_CASE("a text keeps what it was given, and its copies outlive it") {
  Text copy, assigned = "other", moved;
  {
    std::string given = "a text that is too long for the place that a string has in itself";
    const Text text(given);
    given = "changed";
    copy = text;
    assigned = copy;
    moved = Text(text);
  }
  for (const Text* text : {&copy, &assigned, &moved})
    CHECK(text->view() == "a text that is too long for the place that a string has in itself");
  copy = "";
  CHECK(copy.view().empty());
  CHECK(Text().view().empty());
}

TEST_CASE("a literal can be copied and replaced like any text") {
  Text text = Text::literal<"time">();
  const Text copy = text;
  text = "t";
  CHECK(text.view() == "t");
  CHECK(copy.view() == "time");
  text = copy;
  CHECK(text.view() == "time");
  CHECK(text.view().data() == copy.view().data());
}

}  // namespace stepwire
