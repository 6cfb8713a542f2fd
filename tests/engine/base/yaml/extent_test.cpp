#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/text_position.hpp"

namespace stepwire::yaml {

namespace {

Node parse(const std::string& text) {
  return parse_document(text, "f.yaml").root;
}

/// Returns the text from one mark to the other.
std::string between(const std::string& text, const Mark& from, const Mark& to) {
  const LineIndex lines(text);
  const std::size_t begin = lines.position(from), end = lines.position(to);
  return begin <= end ? text.substr(begin, end - begin) : "the end stands before the start";
}

std::string of(const std::string& text, const Node& node) {
  return between(text, node.mark, node.end);
}

/// The text of the value under a key of the root.
std::string under(const std::string& key, const std::string& text) {
  const Node root = parse(text);
  const Node* node = root.find(key);
  return node ? of(text, *node) : "there is no " + key;
}

/// Checks that each value is within its parent and after its predecessor.
void check_order(const Node& node, const std::string& text) {
  const LineIndex lines(text);
  std::size_t at = lines.position(node.mark);
  const std::size_t end = lines.position(node.end);
  const auto comes_next = [&](const Mark& from, const Mark& to) {
    CHECK(at <= lines.position(from));
    CHECK(lines.position(from) <= lines.position(to));
    CHECK(lines.position(to) <= end);
    at = lines.position(to);
  };
  for (const Node& item : node.items) {
    comes_next(item.mark, item.end);
    check_order(item, text);
  }
  for (const Entry& entry : node.entries) {
    comes_next(entry.mark, entry.end);
    if (entry.value.kind == Node::Kind::empty) continue;
    comes_next(entry.value.mark, entry.value.end);
    check_order(entry.value, text);
  }
}

}  // namespace

TEST_CASE("a plain scalar ends behind its last character that is not blank") {
  CHECK(under("a", "a: 5 mm   # of the body\nb: 1\n") == "5 mm");
  CHECK(under("a", "a: it's a#b \t\n") == "it's a#b");
  CHECK(under("a", "a: http://x:1\n") == "http://x:1");
  CHECK(under("a", "a: {b: -1, c: x}\n") == "{b: -1, c: x}");
  CHECK(under("a", "a: last") == "last");
}

TEST_CASE("a plain scalar of several lines ends on the last of them") {
  CHECK(under("a", "a: one\n  two   # no more\nb: 1\n") == "one\n  two");
  CHECK(under("a", "a: one\n\n\n  two\n  three\nb: 1\n") == "one\n\n\n  two\n  three");
  CHECK(under("a", "a: [x\n   y, z]\n") == "[x\n   y, z]");
}

TEST_CASE("a scalar in quotes ends behind the closing quote, whatever is escaped in it") {
  CHECK(under("a", "a: \"one \\\" two\" # \"\n") == "\"one \\\" two\"");
  CHECK(under("a", "a: \"\\\\\"\nb: \"x\"\n") == "\"\\\\\"");
  CHECK(under("a", "a: 'it''s' # '\n") == "'it''s'");
  CHECK(under("a", "a: ''\nb: 'x'\n") == "''");
  CHECK(under("a", "a: \"one\n  two\\\n  three\"\nb: 1\n") == "\"one\n  two\\\n  three\"");
  CHECK(under("a", "a: \"\\u03a9 \\x41\"\n") == "\"\\u03a9 \\x41\"");
}

TEST_CASE("a scalar that is a block ends with its last line that is not blank") {
  CHECK(under("a", "a: |\n  one\n  # two\n\nb: 1\n") == "|\n  one\n  # two");
  CHECK(under("a", "a: >-  # folded\n  one\n  two\n\n  three\nb: 1\n") ==
        ">-  # folded\n  one\n  two\n\n  three");
  CHECK(under("a", "a: |2+\n    one\n   two\n\n\nb: 1\n") == "|2+\n    one\n   two");
  CHECK(under("a", "a: |\n\nb: 1\n") == "|");
  CHECK(under("a", "a: >\n  x") == ">\n  x");
}

TEST_CASE("characters of several bytes, tabs and line ends of Windows are counted as they stand") {
  CHECK(under("a", "a: 5 k\u03a9\nb: 1\n") == "5 k\u03a9");
  CHECK(under("b", "a: \U0001f600\U0001f600\nb: {\u03a9: 'x\U0001f600', c: 1}\n") ==
        "{\u03a9: 'x\U0001f600', c: 1}");
  CHECK(under("a", "a:\t5\t# x\n") == "5");
  CHECK(under("a", "a: one\r\nb: 1\r\n") == "one");
  CHECK(under("a", "a: \"one\r\n  two\"\r\nb: 1\r\n") == "\"one\r\n  two\"");
  CHECK(under("a", "a: |\r\n  one\r\n  two\r\nb: 1\r\n") == "|\r\n  one\r\n  two");
  CHECK(under("a", "a: [1,\r\n  2]\r\nb: 1\r\n") == "[1,\r\n  2]");
  const Node node = parse("a: \U0001f600\u03a9 # x\n").entries[0].value;
  CHECK(node.end.column == 6);  // characters from 1, neither bytes nor halves of surrogates
}

TEST_CASE("a list or map in brackets ends behind its bracket, past commas, comments and values left out") {
  CHECK(under("a", "a: [1, 2, ]  # ]\nb: 1\n") == "[1, 2, ]");
  CHECK(under("a", "a: {b: , c}\nd: 1\n") == "{b: , c}");
  CHECK(under("a", "a: {b: 1 # }\n  , # ]\n  c: [ ]\n  }\nd: 1\n") == "{b: 1 # }\n  , # ]\n  c: [ ]\n  }");
  CHECK(under("a", "a: []\nb: {}\n") == "[]");
  CHECK(under("b", "a: []\nb: { # x\n}\n") == "{ # x\n}");
  CHECK(under("a", "a: [{b: \"]\"}, ']']\n") == "[{b: \"]\"}, ']']");
  CHECK(under("a", "a: [b: 1, c]\n") == "[b: 1, c]");
}

TEST_CASE("a list or map of lines ends with the last value in it") {
  CHECK(under("a", "a:\n  b: 1\n  c: [2]  # x\n\n# y\nd: 1\n") == "b: 1\n  c: [2]");
  CHECK(under("a", "a:\n- 1\n- - 2\n  - 3   \nd: 1\n") == "- 1\n- - 2\n  - 3");
  CHECK(under("a", "a:\n  b: 1\n  c:\nd: 1\n") == "b: 1\n  c");
}

TEST_CASE("a key ends behind its last character or its quote") {
  const std::string text = "\"a b\" : 1\n'c''d': 2\nplain   : 3\n\u03a9: 4\n? long\n: 5\n";
  std::vector<std::string> keys;
  const Node root = parse(text);
  for (const Entry& entry : root.entries) keys.push_back(between(text, entry.mark, entry.end));
  CHECK(keys == std::vector<std::string>{"\"a b\"", "'c''d'", "plain", "\u03a9", "long"});
}

TEST_CASE("a value that is left out has the place of its key, and one that is written as null its own") {
  CHECK(under("a", "a:\nb: 1\n") == "a");
  CHECK(under("a", "a: ~  # x\n") == "~");
  CHECK(under("a", "a: {b: null, c: 1}\n") == "{b: null, c: 1}");
  const std::string text = "a: {b: null, c: 1}\n";
  const Node root = parse(text);
  CHECK(of(text, *root.find("a")->find("b")) == "null");
}

TEST_CASE("an anchor stands before its value, and an alias has the place of what it names") {
  CHECK(under("a", "a: &x 5 mm\nb: *x\n") == "5 mm");
  CHECK(under("b", "a: &x 5 mm\nb: *x\n") == "5 mm");
  CHECK(under("a", "a: &x {b: 1}\nc: [*x, *x ]\n") == "{b: 1}");
  CHECK(under("c", "a: &x {b: 1}\nc: [*x, *x ]  # ]\n") == "[*x, *x ]");
  CHECK(under("a", "a: &x\n  b: 1\nc: *x\n") == "b: 1");
  CHECK(under("a", "a: &x # why\n  'y'\n") == "'y'");
  CHECK(under("c", "a: &x 1\nc:\n  d: *x\ne: 1\n") == "d: *x");
}

TEST_CASE("in any text values follow one another, each inside of what holds it") {
  const std::vector<std::string> pieces{"{a: 1, b: [x, {c: 'd'}], e: }",
                                        "\n  k: |\n    text\n  l: >-\n    a\n    b\n",
                                        "\"q \\\" \u03a9\"",
                                        "plain\n  goes on # c",
                                        "[\n  1, # one\n  2\n]",
                                        "\n- x\n-\n- {y: z}",
                                        "\u03a9 \U0001f600",
                                        "~",
                                        "'a\n\n  b'"};
  for (const std::string& first : pieces)
    for (const std::string& second : pieces)
      for (const std::string line_end : {"\n", "\r\n"}) {
        std::string text = "one: " + first + "\ntwo: " + second + "\nthree: 3\n";
        if (line_end != "\n")
          for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
            text.replace(at, 1, line_end);
        INFO(text);
        check_order(parse(text), text);
      }
}

}  // namespace stepwire::yaml
