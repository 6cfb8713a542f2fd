#include "engine/app/language/tree_edits.hpp"

#include <catch2/catch.hpp>
#include <functional>

namespace stepwire::language {

namespace {

using Change = std::function<void(TreeEdits&, const yaml::Node& root)>;

std::string changed(const std::string& text, const Change& change) {
  const yaml::Document document = yaml::parse_document(text, "a.yaml");
  TreeEdits edits(text, document);
  change(edits, document.root);
  return spliced(text, edits.checked());
}

std::string put(const std::string& text, const std::string& value) {
  return changed(text,
                 [&](TreeEdits& edits, const yaml::Node& root) { edits.replace(*root.find("a"), value); });
}

std::string added(const std::string& text, const std::string& key, const std::string& value) {
  return changed(text,
                 [&](TreeEdits& edits, const yaml::Node& root) { edits.add(*root.find("a"), key, value); });
}

std::string without(const std::string& text, const std::vector<std::string>& keys) {
  return changed(text, [&](TreeEdits& edits, const yaml::Node& root) {
    const yaml::Node& map = *root.find("a");
    for (const yaml::Entry& entry : map.entries)
      if (std::ranges::find(keys, entry.key) != keys.end()) edits.remove(map, entry);
    for (const yaml::Node& item : map.items)
      if (std::ranges::find(keys, item.text) != keys.end()) edits.remove_item(map, item);
  });
}

}  // namespace

TEST_CASE("a value is put in its place, and what stands around it stays") {
  CHECK(put("# \u03a9 \U0001f600\na: 1 kg   # mass\nb: 2\n", "8 kg") ==
        "# \u03a9 \U0001f600\na: 8 kg   # mass\nb: 2\n");
  CHECK(put("a: 1\r\nb: 2\r\n", "3") == "a: 3\r\nb: 2\r\n");
  CHECK(put("\"a\": 'on'\nb: 2\n", "off") == "\"a\": 'off'\nb: 2\n");
  CHECK(put("a: \"on\"\n", "say \"no\"") == "a: \"say \\\"no\\\"\"\n");
  CHECK(put("a: 'on'\n", "it's") == "a: 'it''s'\n");
  CHECK(put("a: \"on\"\n", "'off'") == "a: 'off'\n");
  CHECK(put("a: [1, 2] # two\n", "[1, 2, 3]") == "a: [1, 2, 3] # two\n");
  CHECK(put("a:\n  - 1\n  - 2\nb: 3\n", "[4, 5]") == "a:\n  [4, 5]\nb: 3\n");
  CHECK(put("a: |\n  some\n  text\nb: 3\n", "word") == "a: word\nb: 3\n");
  CHECK(put("a:\nb: 3\n", "1") == "a: 1\nb: 3\n");
  CHECK(put("a: null\nb: 3\n", "1") == "a: 1\nb: 3\n");
  CHECK(put("a: ~", "1") == "a: 1");
  CHECK(put("{a: 1, b: 2}\n", "max(x, y)") == "{a: \"max(x, y)\", b: 2}\n");
  CHECK(put("a: 1\n", "max(x, y)") == "a: max(x, y)\n");
  CHECK(put("a: 1\n", "=x: y") == "a: \"=x: y\"\n");
  CHECK(put("a: 1\n", "8 kg # heavy") == "a: \"8 kg # heavy\"\n");
  CHECK(put("a: &x 1\nb: 2\n", "3") == "a: &x 3\nb: 2\n");
}

TEST_CASE("a value that others share by an anchor is not changed for them") {
  CHECK_THROWS_AS(put("a: &x 1\nb: *x\n", "3"), EditRefused);
  CHECK_THROWS_AS(put("b: &x 1\na: *x\n", "3"), EditRefused);
  CHECK_THROWS_AS(put("a: 1\n", ""), EditRefused);
  CHECK_THROWS_AS(put("a: 1\n", "1\nb: 2"), EditRefused);
}

TEST_CASE("no text makes a value into anything else than one value") {
  for (const std::string text : {"1, b: 2", "1}",  "{x",  "[",  "&x 1", "*x",   "!tag x",
                                 "# x",     "- x", "? x", "'x", "\"x",  "x: y", "|",
                                 ">-",      "@x",  "%x",  "`x", "---",  "...",  "\u03a9: \U0001f600"})
    for (const std::string document : {"a: 1\nb: 2\n", "{a: 1, b: 2}\n", "{a: '1', b: 2}\n"}) {
      INFO(text << " in " << document);
      try {
        const yaml::Document after = yaml::parse_document(put(document, text), "");
        CHECK(after.root.entries.size() == 2);
        CHECK(after.root.find("a")->text == text);
        CHECK(after.root.find("b")->text == "2");
      } catch (const EditRefused&) {  // is right, too
      }
    }
}

TEST_CASE("a key is added in the style of its map") {
  CHECK(added("a: {b: 1}\n", "c", "2") == "a: {b: 1, c: 2}\n");
  CHECK(added("a: {}\n", "c", "2") == "a: {c: 2}\n");
  CHECK(added("a: {b: 1, d: [3, 4]  # here\n   }\n", "c", "2") ==
        "a: {b: 1, d: [3, 4], c: 2  # here\n   }\n");
  CHECK(added("a:\n  b: 1  # one\n\n# end\nd: 3\n", "c", "2") ==
        "a:\n  b: 1  # one\n  c: 2\n\n# end\nd: 3\n");
  CHECK(added("a:\r\n    b: 1\r\n", "c", "2") == "a:\r\n    b: 1\r\n    c: 2\r\n");
  CHECK(added("a:\n  b: 1", "c", "2") == "a:\n  b: 1\n  c: 2");
  CHECK(added("a:\n  b:\n    - 1\n    - x: 2\n      y: 3\n", "c", "2") ==
        "a:\n  b:\n    - 1\n    - x: 2\n      y: 3\n  c: 2\n");
  CHECK(added("a:\n  b: |\n    some\n    text\nd: 1\n", "c", "2") ==
        "a:\n  b: |\n    some\n    text\n  c: 2\nd: 1\n");
  CHECK(added("x: &n 1\na:\n  b: *n\n", "c", "2") == "x: &n 1\na:\n  b: *n\n  c: 2\n");
  CHECK_THROWS_AS(added("x: &n {b: 1}\na: *n\n", "c", "2"), EditRefused);
}

TEST_CASE("keys and items are removed with their lines or commas") {
  CHECK(without("a: {b: 1, c: 2, d: 3}\n", {"b"}) == "a: {c: 2, d: 3}\n");
  CHECK(without("a: {b: 1, c: 2, d: 3}\n", {"c", "d"}) == "a: {b: 1}\n");
  CHECK(without("a: {b: 1, c: 2, d: 3}\n", {"b", "d"}) == "a: {c: 2}\n");
  CHECK(without("a: {b: 1}\n", {"b"}) == "a: {}\n");
  CHECK(without("a: [b, c, \"d\"]\n", {"d"}) == "a: [b, c]\n");
  CHECK(without("a:\n  b: 1  # one\n  c:\n    x: 2\n    y: 3\n  d: 4\n", {"c"}) ==
        "a:\n  b: 1  # one\n  d: 4\n");
  CHECK(without("a:\n  b: 1  # one\n  c: 2\ne: 5\n", {"b"}) == "a:\n  c: 2\ne: 5\n");
  CHECK(without("a:\r\n  b: 1\r\n  c: 2", {"c"}) == "a:\r\n  b: 1");
  CHECK(without("a:\n- b\n- c\n- d\n", {"b", "d"}) == "a:\n- c\n");
  CHECK(without("a:\n  b: 1\ne: 5\n", {"b"}) == "a:\n  {}\ne: 5\n");
  CHECK_THROWS_AS(without("a: {b: &x 1, c: *x}\n", {"b"}), EditRefused);
}

TEST_CASE("several changes are one list of splices") {
  const std::string text = "a: {b: 1, c: 2}\nd: [x, y]\n";
  CHECK(changed(text, [](TreeEdits& edits, const yaml::Node& root) {
          edits.replace(*root.find("a")->find("b"), "7");
          edits.add(*root.find("a"), "e", "8");
          edits.add_item(*root.find("d"), "z");
          edits.remove_item(*root.find("d"), root.find("d")->items[0]);
        }) == "a: {b: 7, c: 2, e: 8}\nd: [y, z]\n");
}

}  // namespace stepwire::language
