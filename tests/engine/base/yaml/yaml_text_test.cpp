#include "engine/base/yaml/yaml_text.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

namespace stepwire::yaml {

namespace {

Node parse(const std::string& text) {
  return parse_document(text, "a.yaml").root;
}

Node text_node(const std::string& text, bool quoted) {
  Node node;
  node.kind = Node::Kind::scalar;
  node.text = text;
  node.quoted = quoted;
  return node;
}

}  // namespace

TEST_CASE("what is short stands on one line in brackets, the rest on lines of its own") {
  const std::string list = "[" + std::string(60, '1') + ", " + std::string(60, '2') + "]";
  CHECK(
      yaml_text(parse("a: {b: [1, 2], c: {}, d: []}\ne: \"1\"\nf: {g: " + list + "}\nh: [" + list + "]\n")) ==
      "a: {b: [1, 2], c: {}, d: []}\ne: \"1\"\nf:\n  g:\n    - " + std::string(60, '1') + "\n    - " +
          std::string(60, '2') + "\nh:\n  -\n    - " + std::string(60, '1') + "\n    - " +
          std::string(60, '2') + "\n");
}

TEST_CASE("a text that cannot stand plain gets quotes, and reads back") {
  for (const std::string text : {"",
                                 " ",
                                 "a ",
                                 "-",
                                 "- a",
                                 "-a",
                                 "a: b",
                                 "a #b",
                                 "#",
                                 "~",
                                 "null",
                                 "?",
                                 "[",
                                 "a, b",
                                 "*a",
                                 "&a",
                                 "!a",
                                 "|",
                                 ">",
                                 "%",
                                 "@",
                                 "a\"b\\c'",
                                 "two\nlines\n",
                                 "tab\there",
                                 "\x7f",
                                 "5 mm",
                                 "-.5",
                                 "$tau",
                                 "= 2*pi",
                                 "x > 5 mm && y < 2",
                                 "\xC3\xA4\xE2\x82\xAC",
                                 "true",
                                 "+-"}) {
    Node root;
    root.kind = Node::Kind::map;
    root.entries.push_back({"k", {}, text_node(text, false)});
    root.entries.push_back({text.empty() ? "empty" : text, {}, text_node(text, true)});
    root.entries.push_back({"list", {}, parse("[a]")});
    root.entries.back().value.items.push_back(text_node(text, false));
    const Node back = parse(yaml_text(root));
    INFO(yaml_text(root));
    REQUIRE(back.entries.size() == 3);
    CHECK(back.entries[0].value.text == text);
    CHECK(back.entries[1].key == root.entries[1].key);
    CHECK(back.entries[1].value.text == text);
    CHECK(back.entries[1].value.quoted);
    CHECK(back.entries[2].value.items.at(1).text == text);
  }
}

TEST_CASE("numbers, parameters and expressions stand without quotes, which would make them words") {
  for (const std::string text : {"-0.5 N m/s^2", "1e-05", "$tau", "= 2*pi*f", "-.5 mm", "lag.y"})
    CHECK(yaml_text(text_node(text, false)) == text + "\n");
}

TEST_CASE("every diagram file of the repository comes back from its tree") {
  const auto folder = std::filesystem::path(STEPWIRE_SOURCE_DIR) / "diagrams";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    INFO(entry.path());
    const Node root = read_document(entry.path().string()).root;
    const Node back = parse(yaml_text(root));
    CHECK(yaml_text(back) == yaml_text(root));
  }
}

}  // namespace stepwire::yaml
