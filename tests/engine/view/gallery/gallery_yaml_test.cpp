#include "engine/view/gallery/gallery_page.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>

#include "engine/base/io/file.hpp"

namespace stepwire::gallery {

namespace {

std::string painted(const std::string& text) {
  return painted_yaml(text,
                      [](const std::string& path) { return Address{path == "hand.yaml" ? "there" : ""}; })
      .code;
}

/// Returns the text that a browser shows for this HTML.
std::string shown(std::string code) {
  code = std::regex_replace(code, std::regex("<[^>]*>"), "");
  for (const auto& [name, sign] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
    code = std::regex_replace(code, std::regex(name), sign);
  return code;
}

}  // namespace

TEST_CASE("keys, types, numbers, names of parameters, texts and comments have their classes") {
  CHECK(
      painted("net: {block: Sum, gain: $mass, signs: \"+--\"}  # of # forces\n") ==
      "<span class=\"key\">net</span>: {<span class=\"key\">block</span>: <span class=\"type\">Sum</span>, "
      "<span "
      "class=\"key\">gain</span>: <span class=\"name\">$mass</span>, <span class=\"key\">signs</span>: <span "
      "class=\"string\">&quot;+--&quot;</span>}  <span class=\"comment\"># of # forces</span>\n");
  CHECK(painted("a: 2*1.5e-3 mm\n") ==
        "<span class=\"key\">a</span>: <span class=\"number\">2</span>*<span class=\"number\">1.5e-3</span> "
        "mm\n");
}

TEST_CASE("a part whose page is there is a link") {
  CHECK(painted("{diagram: hand.yaml}") ==
        "{<span class=\"key\">diagram</span>: <a href=\"there\">hand.yaml</a>}\n");
  CHECK(painted("{diagram: other.yaml}") == "{<span class=\"key\">diagram</span>: other.yaml}\n");
}

TEST_CASE("a block of text and a quoted text end where YAML ends them") {
  CHECK(painted("a: >\n  one: two\n\n  # three\nb: 1\n") ==
        "<span class=\"key\">a</span>: &gt;\n<span class=\"string\">  one: two</span>\n<span "
        "class=\"string\"></span>\n<span class=\"string\">  # three</span>\n<span class=\"key\">b</span>: "
        "<span "
        "class=\"number\">1</span>\n");
  CHECK(painted("a: \"one\n  b: \\\"two\"\nc: d\n") ==
        "<span class=\"key\">a</span>: <span class=\"string\">&quot;one</span>\n<span class=\"string\">  b: "
        "\\&quot;two&quot;</span>\n<span class=\"key\">c</span>: d\n");
}

TEST_CASE("every diagram file is shown with all its signs") {
  int files = 0;
  for (const char* folder : {"examples", "parts", "thesis"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(STEPWIRE_SOURCE_DIR "/diagrams/") + folder)) {
      if (entry.path().extension() != ".yaml") continue;
      const std::string text = io::read_file(entry.path().string());
      INFO(entry.path());
      CHECK(shown(painted(text)) == text);
      ++files;
    }
  CHECK(files > 100);
}

}  // namespace stepwire::gallery
