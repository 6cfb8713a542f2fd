#include <catch2/catch.hpp>
#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire::yaml {
using Catch::Contains;

namespace {

std::string error_of(const std::string& text) {
  try {
    parse_document(text, "a.yaml");
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("all double keys are reported, each with both places") {
  CHECK(error_of("a: 1\nb: {x: 1, y: 2, x: 3}\na: 2\na: 3\n") ==
        "a.yaml:2:17: 'x' is given twice, first at 2:5; leave one out\n"
        "a.yaml:3:1: 'a' is given twice, first at 1:1; leave one out\n"
        "a.yaml:4:1: 'a' is given twice, first at 1:1; leave one out");
}

TEST_CASE("double keys are still reported when the file breaks off later") {
  const std::string error = error_of("a: {x: 1, x: 2}\nb: [1, 2\n");
  CHECK_THAT(error, Contains("1:11: 'x' is given twice"));
  CHECK_THAT(error, Contains("expected ',' or ']'"));
}

TEST_CASE("tags are refused on every kind of value") {
  CHECK_THAT(error_of("a: !!float 3"), Contains("1:4: tags (!) are not used here"));
  CHECK_THAT(error_of("a: !x {b: 1}"), Contains("1:4: tags"));
  CHECK_THAT(error_of("a: !x [1]"), Contains("1:4: tags"));
  CHECK_THAT(error_of("a: ! b"), Contains("1:4: tags"));
  CHECK_THAT(error_of("a: !!null"), Contains("1:4: tags"));
  CHECK(error_of("a: '!b'") == "none");
}

TEST_CASE("merge keys are refused with what to do instead") {
  CHECK(error_of("a: &x {b: 1}\nc: {<<: *x}\n") ==
        "a.yaml:2:5: merge keys (<<) are not known here; write the keys out, or give the value an alias");
}

TEST_CASE("keys that are no words are refused") {
  for (const std::string text : {"? [a]\n: 1\n", "{a: 1}: 2\n", "[a]: 1\n", "{{a: 1}: 2}"})
    CHECK_THAT(error_of(text), Contains("cannot be a key"));
  CHECK_THAT(error_of(": 1\n"), Contains("1:1: a key is missing"));
  CHECK_THAT(error_of("{a: 1,, b: 2}"), Contains("1:7: a key is missing"));
  CHECK_THAT(error_of("null: 1\n"), Contains("null is no key"));
  CHECK_THAT(error_of("a: &x b\n*x : 1\n"), Contains("2:1: an alias (*name) cannot be a key"));
  CHECK_THAT(error_of("&k a: 1\nb: *k\n"), Contains("1:1: an anchor (&name) belongs to a value"));
}

TEST_CASE("a key that has swallowed its value is told from a missing blank") {
  CHECK(error_of("a: {b:1}") == "a.yaml:1:5: 'b:1' is a key without a value; a blank is missing after ':'");
}

TEST_CASE("a file holds one document") {
  CHECK_THAT(error_of("a: 1\n---\nb: 2\n"), Contains("2:1: a second document starts here"));
  CHECK_THAT(error_of("a: 1\n---\n"), Contains("2:1: a second document"));
  CHECK_THAT(error_of("[a]\nb\n"), Contains("2:1: text after the end of the document"));
}

TEST_CASE("aliases to nothing and to themselves are refused") {
  CHECK_THAT(error_of("a: *x\n"), Contains("1:4: the alias (*name) names no anchor"));
  CHECK_THAT(error_of("a: &x [1, *x]\n"), Contains("1:11: the alias stands inside the value that it names"));
  CHECK_THAT(error_of("a: &x {b: {c: *x}}\n"), Contains("1:15: the alias stands inside"));
}

TEST_CASE("a bracket that is not closed is named with the place where it opened") {
  CHECK_THAT(error_of("a: 1\nb: {c: 1\nd: 2\n"), Contains("a.yaml:3:2: ") && Contains("(opened at 2:4)"));
  CHECK_THAT(error_of("a: [1, 2\n"), Contains("(opened at 1:4)"));
}

TEST_CASE("a quote that is not closed is an error at the quote") {
  for (const std::string text : {"a: \"x\nb: 1\n", "a: 'x\nb: 1\n", "a: 'it''s ''\n", "a: &k \"x\n"})
    CHECK_THAT(error_of(text), Contains("a.yaml:1:4: the closing quote of this text is missing"));
  CHECK_THAT(error_of("a: 'it''s ''"), Contains("the file ends inside a text that starts after 1:1"));
  for (const std::string text : {"a: 'it''s'", "a: \"x\\\"\"", "a: \"\"", "a: ''", "a: it's", "a: &k 'x'"})
    CHECK(error_of(text) == "none");
}

TEST_CASE("a tab in the indentation is called one, and one between values is none") {
  for (const std::string text : {"a:\n\tb: 1\n", "a:\n\t- 1\n"})
    CHECK(error_of(text) == "a.yaml:2:1: a tab in the indentation; use blanks");
  CHECK(error_of("a:\n  b: 1\n\tc: 2\n") == "a.yaml:3:1: a tab in the indentation; use blanks");
  CHECK(error_of("a:\n \tb: 1\n") == "a.yaml:2:2: a tab in the indentation; use blanks");
  CHECK(error_of("a:\t1\nb: {c: 1,\n\td: 2}\n") == "none");
}

TEST_CASE("common slips of the hand give an error at their place") {
  CHECK_THAT(error_of("title: a: b\n"), Contains("a.yaml:1:9: a ': ' cannot stand here"));
  CHECK_THAT(error_of("a:\n  b: 1\n c: 2\n"), Contains("a.yaml:3:2: expected 'key: value'"));
  CHECK_THAT(error_of("a: @x\n"), Contains("a.yaml:1:4: this character starts nothing in YAML"));
  CHECK_THAT(error_of("a: ]\n"), Contains("a.yaml:1:4: this bracket closes nothing"));
  CHECK_THAT(error_of("a: {b: 1 c: 2}\n"), Contains("a.yaml:1:11: expected ',' or '}'"));
}

TEST_CASE("line ends of one carriage return are told as such and not as one wrong line") {
  CHECK_THAT(error_of("a: 1\rb: 2\r"), Contains("a.yaml:1:5: a carriage return without a line feed"));
  CHECK(error_of("a: 1\r\nb: 2\r\n") == "none");
}

}  // namespace stepwire::yaml
