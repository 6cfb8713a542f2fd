#include <catch2/catch.hpp>
#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire::yaml {

namespace {

Node parse(const std::string& text) {
  return parse_document(text, "a.yaml").root;
}

std::string at(Mark mark) {
  return std::to_string(mark.line) + ":" + std::to_string(mark.column);
}

}  // namespace

TEST_CASE("a block map and a flow map become entries with the places of keys and values") {
  const Node root = parse("blocks:\n  lag: {block: Lag, tau: 0.5 s}\n");
  REQUIRE(root.is_map());
  CHECK(at(root.mark) == "1:1");
  const Entry& lag = root.entries.at(0).value.entries.at(0);
  CHECK(lag.key == "lag");
  CHECK(at(lag.mark) == "2:3");
  CHECK(at(lag.value.mark) == "2:8");
  const Entry& tau = lag.value.entries.at(1);
  CHECK(at(tau.mark) == "2:21");
  CHECK(tau.value.text == "0.5 s");
  CHECK(at(tau.value.mark) == "2:26");
}

TEST_CASE("a value is found under its key, and nothing where the key is not") {
  const Node root = parse("{a: 1, b: 2}");
  REQUIRE(root.find("b") != nullptr);
  CHECK(root.find("b")->text == "2");
  CHECK(root.find("c") == nullptr);
}

TEST_CASE("lists keep their items in order, in brackets and in lines") {
  for (const std::string text : {"[1, [2], 3]", "- 1\n-\n  - 2\n- 3\n", "- 1\n- - 2\n- 3\n"}) {
    const Node root = parse(text);
    REQUIRE(root.is_list());
    REQUIRE(root.items.size() == 3);
    CHECK(root.items[0].text == "1");
    CHECK(root.items[1].items.at(0).text == "2");
    CHECK(root.items[2].text == "3");
  }
}

TEST_CASE("a text in quotes and a text block are marked as quoted, a plain word is not") {
  const Node root = parse("a: '1'\nb: \"2\"\nc: |\n  3\nd: 4\n");
  CHECK(root.find("a")->quoted);
  CHECK(root.find("b")->quoted);
  CHECK(root.find("c")->quoted);
  CHECK(root.find("c")->text == "3\n");
  CHECK_FALSE(root.find("d")->quoted);
}

TEST_CASE("numbers stay text as they are written") {
  const Node root = parse("[010, 1e999, .nan, -0, 0x1F, yes]");
  const char* written[] = {"010", "1e999", ".nan", "-0", "0x1F", "yes"};
  for (std::size_t i = 0; i < root.items.size(); ++i) CHECK(root.items[i].text == written[i]);
}

TEST_CASE("a tilde, the word null and an absent value are empty, the same in quotes is not") {
  const Node root = parse("a: ~\nb: null\nc:\nd: 'null'\ne: ''\nf: {g: , h: Null}\n");
  for (const char* key : {"a", "b", "c"}) CHECK(root.find(key)->kind == Node::Kind::empty);
  for (const char* key : {"g", "h"}) CHECK(root.find("f")->find(key)->kind == Node::Kind::empty);
  CHECK(root.find("d")->is_scalar());
  CHECK(root.find("e")->is_scalar());
}

TEST_CASE("an absent value has the place of its key, a written null its own") {
  const Node root = parse("a:\nb: ~\nc:\n");
  CHECK(at(root.find("a")->mark) == "1:1");
  CHECK(at(root.find("b")->mark) == "2:4");
  CHECK(at(root.find("c")->mark) == "3:1");
}

TEST_CASE("an absent value has the place of its key, whatever the next line begins with") {
  for (const std::string next : {"net: 1", "null_force: 1", "Nothing: 1", "~a: 1"}) {
    const Node root = parse("a:\n" + next + "\n");
    CHECK(at(root.entries.at(0).value.mark) == "1:1");
  }
}

TEST_CASE("a file without content has an empty root at its start") {
  for (const std::string text : {"", "\n\n", "# only a comment\n", "   ", "\xef\xbb\xbf"}) {
    const Node root = parse(text);
    CHECK(root.kind == Node::Kind::empty);
    CHECK(at(root.mark) == "1:1");
  }
}

TEST_CASE("an alias stands for a copy of what its anchor marks") {
  const Node root = parse("a: &x {tau: 1 s, u: [1, 2]}\nb: *x\nc: [*x, &y 3, *y]\n");
  CHECK(root.find("b")->find("tau")->text == "1 s");
  CHECK(at(root.find("b")->find("tau")->mark) == "1:13");
  const Node& c = *root.find("c");
  CHECK(c.items.at(0).find("u")->items.at(1).text == "2");
  CHECK(c.items.at(2).text == "3");
}

TEST_CASE("the last anchor of a name counts") {
  CHECK(parse("[&x 1, *x, &x 2, *x]").items.at(3).text == "2");
}

TEST_CASE("columns count characters, not bytes, and line ends of both kinds are one") {
  const Node root = parse("{\"größe µm\": 1, b: 2}\r\n");
  CHECK(at(root.entries.at(1).mark) == "1:17");
  CHECK(at(parse("a: 1\r\nb: 2\r\n").entries.at(1).mark) == "2:1");
}

TEST_CASE("a byte order mark does not move the first column") {
  CHECK(at(parse("\xef\xbb\xbf"
                 "a: 1")
               .entries.at(0)
               .value.mark) == "1:4");
}

TEST_CASE("a document may be framed by its signs and a version") {
  CHECK(parse("%YAML 1.2\n---\na: 1\n...\n").find("a")->text == "1");
}

TEST_CASE("many entries of one map are read and told apart") {
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "b" + std::to_string(i) + ": {block: Gain, u: b0}\n";
  const Node root = parse(text);
  CHECK(root.entries.size() == 20'000);
  CHECK(root.entries.back().key == "b19999");
  CHECK(root.entries.back().mark.line == 20'000);
}

TEST_CASE("the escapes of a text in double quotes are UTF-8") {
  CHECK(parse(R"("a\Nb\_c\L\u00e9")").text ==
        "a\xc2\x85"
        "b\xc2\xa0"
        "c\xe2\x80\xa8\xc3\xa9");
  CHECK(parse(R"({"\_": 1})").entries.at(0).key == "\xc2\xa0");
}

}  // namespace stepwire::yaml
