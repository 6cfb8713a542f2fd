#include <catch2/catch.hpp>

#include "engine/app/language/edits.hpp"

namespace stepwire::language {

namespace {

std::string below(const std::string& text, const std::string& key, const std::string& name,
                  const std::string& value) {
  const yaml::Document document = yaml::parse_document(text, "a.yaml");
  TreeEdits edits(text, document);
  edits.add_below(document.root, key, name, value);
  return spliced(text, edits.checked());
}

std::string entry(const std::string& text) {
  return below(text, "linear", "b", "{x: 2}");
}

std::string item(const std::string& text) {
  return below(text, "figure", "", "{x: 2}");
}

std::string cut(const std::string& text) {
  const yaml::Document document = yaml::parse_document(text, "a.yaml");
  TreeEdits edits(text, document);
  cut_loop(edits, document, {"e", "0.5 s"});
  return spliced(text, edits.checked());
}

}  // namespace

TEST_CASE("an entry is added to a section in the way in which the section is written") {
  CHECK(entry("linear:\n  a: {x: 1}\nz: 1\n") == "linear:\n  a: {x: 1}\n  b: {x: 2}\nz: 1\n");
  CHECK(entry("linear:\n     a: {x: 1}\n") == "linear:\n     a: {x: 1}\n     b: {x: 2}\n");
  CHECK(entry("linear:\n  a:\n    x: 1\n\nz: 1\n") == "linear:\n  a:\n    x: 1\n  b: {x: 2}\n\nz: 1\n");
  CHECK(entry("linear: {a: {x: 1}}  # one\nz: 1\n") == "linear: {a: {x: 1}, b: {x: 2}}  # one\nz: 1\n");
  CHECK(entry("linear: {\n  a: {x: 1},  # one\n}\n") == "linear: {\n  a: {x: 1}, b: {x: 2},  # one\n}\n");
  CHECK(entry("{linear: {a: {x: 1}}, z: 1}\n") == "{linear: {a: {x: 1}, b: {x: 2}}, z: 1}\n");
  CHECK(entry("linear:\n  # first\n  a: {x: 1}  # one\n  # last\n# of z\nz: 1\n") ==
        "linear:\n  # first\n  a: {x: 1}  # one\n  # last\n  b: {x: 2}\n# of z\nz: 1\n");
  CHECK(entry("linear:\r\n  a: {x: 1}\r\n") == "linear:\r\n  a: {x: 1}\r\n  b: {x: 2}\r\n");
  CHECK(entry("\"linear\":\n  a: {x: 1}") == "\"linear\":\n  a: {x: 1}\n  b: {x: 2}");
}

TEST_CASE("a section without a value, or without its key, is begun in lines") {
  CHECK(entry("linear:\nz: 1\n") == "linear:\n  b: {x: 2}\nz: 1\n");
  CHECK(entry("linear:  # none yet\n  # really\nz: 1\n") ==
        "linear:  # none yet\n  b: {x: 2}\n  # really\nz: 1\n");
  CHECK(entry("linear: {}\nz: 1\n") == "linear: {b: {x: 2}}\nz: 1\n");
  CHECK(entry("linear: ~\nz: 1\n") == "linear: {b: {x: 2}}\nz: 1\n");
  CHECK(entry("linear: []\nz: 1\n") == "linear: {b: {x: 2}}\nz: 1\n");
  CHECK(entry("z: 1\n") == "z: 1\nlinear:\n  b: {x: 2}\n");
  CHECK(entry("z: 1") == "z: 1\nlinear:\n  b: {x: 2}");
  CHECK(entry("{z: 1}\n") == "{z: 1, linear: {b: {x: 2}}}\n");
  CHECK(entry("  z: 1\n") == "  z: 1\n  linear:\n    b: {x: 2}\n");
  CHECK(item("figure:\nz: 1\n") == "figure:\n  - {x: 2}\nz: 1\n");
  CHECK(item("figure: []\nz: 1\n") == "figure: [{x: 2}]\nz: 1\n");
  CHECK(item("z: 1\n") == "z: 1\nfigure:\n  - {x: 2}\n");
}

TEST_CASE("an item is added to a list in lines or brackets, and one map becomes the first item") {
  CHECK(item("figure:\n  - {x: 1}\nz: 1\n") == "figure:\n  - {x: 1}\n  - {x: 2}\nz: 1\n");
  CHECK(item("figure:\n- {x: 1}\n# of z\nz: 1\n") == "figure:\n- {x: 1}\n- {x: 2}\n# of z\nz: 1\n");
  CHECK(item("figure:\n- {x: 1,\n   y: 2}\n") == "figure:\n- {x: 1,\n   y: 2}\n- {x: 2}\n");
  CHECK(item("figure: [{x: 1}]  # one\n") == "figure: [{x: 1}, {x: 2}]  # one\n");
  CHECK(item("figure:\n  - x: 1\n    y: 2\n") == "figure:\n  - x: 1\n    y: 2\n  - {x: 2}\n");
  CHECK(item("figure: {x: 1}  # one\nz: 1\n") == "figure: [{x: 1}, {x: 2}]  # one\nz: 1\n");
  CHECK(item("figure: {x: 1,\n  y: 2}\nz: 1\n") == "figure: [{x: 1,\n  y: 2}, {x: 2}]\nz: 1\n");
  CHECK(item("figure:\n  x: 1  # one\n\n  # of y\n  y:\n    - 3\nz: 1\n") ==
        "figure:\n  - x: 1  # one\n\n    # of y\n    y:\n      - 3\n  - {x: 2}\nz: 1\n");
  CHECK(item("figure:\n  x: |\n    a\n      b\nz: 1\n") ==
        "figure:\n  - x: |\n      a\n        b\n  - {x: 2}\nz: 1\n");
}

TEST_CASE("what would be another text, or is shared by an anchor, is refused with the line") {
  CHECK_THROWS_AS(entry("a: &n {a: 1}\nlinear: *n\n"), EditRefused);
  CHECK_THROWS_AS(item("a: &n [1]\nfigure: *n\n"), EditRefused);
  CHECK_THROWS_WITH(entry("linear: word\n"), "'linear' has another form here; the line would be: b: {x: 2}");
  CHECK_THROWS_WITH(item("figure: word\n"), "'figure' has another form here; the line would be: - {x: 2}");
}

TEST_CASE("a loop is cut where there is no analysis, one, or a taken name, wherever the sections lie") {
  const std::string line = "{from: e, to: e, open: e, at: 0.5 s}";
  const auto plot = [](const std::string& name) {
    return "{plot: bode, of: " + name + ", title: The loop opened at e}";
  };
  CHECK(cut("z: 1\n") == "z: 1\nlinear:\n  loop: " + line + "\nfigure:\n  - " + plot("loop") + "\n");
  CHECK(cut("z: 1\nlinear:\n    loop: {from: a}\n") ==
        "z: 1\nlinear:\n    loop: {from: a}\n    loop2: " + line + "\nfigure:\n  - " + plot("loop2") + "\n");
  CHECK(cut("z: 1\nfigure:\n  - {x: 1}\n") ==
        "z: 1\nfigure:\n  - {x: 1}\n  - " + plot("loop") + "\nlinear:\n  loop: " + line + "\n");
  CHECK(cut("linear: {loop: {from: a}, loop2: {from: b}}\nfigure: {x: 1}\n") ==
        "linear: {loop: {from: a}, loop2: {from: b}, loop3: " + line + "}\nfigure: [{x: 1}, " +
            plot("loop3") + "]\n");
  const std::string once = cut("z: 1\nfigure: {x: 1}\n");
  const yaml::Document twice = yaml::parse_document(cut(once), "a.yaml");
  CHECK(twice.root.find("linear")->entries.size() == 2);
  CHECK(twice.root.find("figure")->items.size() == 3);
}

}  // namespace stepwire::language
