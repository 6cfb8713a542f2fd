#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/app/reference/block_json.hpp"
#include "engine/app/reference/block_page.hpp"
#include "engine/app/reference/example.hpp"
#include "engine/app/reference/format_page.hpp"
#include "engine/app/reference/words.hpp"

namespace stepwire::reference {

namespace {

/// A block that has one of everything.
struct OneOfAll2D {
  enum class Law { soft, hard };
  double length = 0.004, open = -std::numeric_limits<double>::infinity();
  Law law = Law::hard;
  std::int64_t order = 2;
  Text signs;
  FilePath file;
  Input<> u{};
  Inputs more{};
  Output<1> y{};
  State<1> level{};
  DiscreteState<1> held{};
  Diagnostic late{};

  void outputs() {}
  void derivatives() {}
  static void declare(Declare<OneOfAll2D>& is);
};

void shorten(OneOfAll2D& block) {
  block.length = 0.002;
}

void OneOfAll2D::declare(Declare<OneOfAll2D>& is) {
  is.block("OneOfAll2D", {.doc = "Has one of each: y = |u|. And a second sentence.",
                          .source = "a book",
                          .not_real_time = "it reads a book at every step"});
  is.parameter<&OneOfAll2D::length>({.unit = "mm", .doc = "how long", .above = 0.0, .at_most = 0.01});
  is.parameter<&OneOfAll2D::open>({.unit = "mm", .doc = "a bound"});
  is.parameter<&OneOfAll2D::law>({.doc = "which law", .words = {"soft", "hard"}});
  is.parameter<&OneOfAll2D::order>({.doc = "which order"});
  is.parameter<&OneOfAll2D::signs>({.doc = "which signs"});
  is.parameter<&OneOfAll2D::file>({.doc = "which file", .required = true});
  is.input<&OneOfAll2D::u>({.unit = "'u", .doc = "signal", .feedthrough = false});
  is.input<&OneOfAll2D::more>({.unit = "*", .doc = "other signals", .optional = true});
  is.output<&OneOfAll2D::y, &OneOfAll2D::level>({.unit = "'u", .doc = "value"});
  is.state<&OneOfAll2D::level>({.unit = "'u", .doc = "memory", .initial = 3.0});
  is.state<&OneOfAll2D::held>({.doc = "what was", .settable = false});
  is.diagnostic<&OneOfAll2D::late>({.doc = "too late", .ends_run = true});
  is.preset<shorten>("short", "a shorter one");
}

Registry registry() {
  Registry all;
  all.add<OneOfAll2D>("examples");
  return all;
}

const BlockType& type_in(const Registry& all) {
  return *all.find("OneOfAll2D");
}

bool has(const std::string& text, const std::string& piece) {
  INFO(piece);
  const bool found = text.find(piece) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_CASE("a name of a type becomes one of a file") {
  CHECK(snake_case("Lag") == "lag");
  CHECK(snake_case("PID") == "pid");
  CHECK(snake_case("DiscretePID") == "discrete_pid");
  CHECK(snake_case("RotaryMRDamper") == "rotary_mr_damper");
  CHECK(snake_case("LookupTable2D") == "lookup_table_2d");
  CHECK(snake_case("Atan2") == "atan2");
}

TEST_CASE("a page for the terminal says all that is declared, no line too wide") {
  const Registry all = registry();
  const std::string page = block_page(type_in(all));
  INFO(page);
  CHECK(page.starts_with("OneOfAll2D (examples)\n  Has one of each: y = |u|. And a second sentence.\n"));
  for (const char* piece : {"source       a book\n",
                            "timing       continuous",
                            "real time    not in a real-time loop: it reads a book at every step\n",
                            "on more\n",
                            "  length  number",
                            "4 mm",
                            "above 0, at most 10 mm",
                            "none",
                            "hard",
                            "soft, hard",
                            "required",
                            "list of signals, optional",
                            "any",
                            "value (the state level)\n",
                            "initial",
                            "  held",
                            "ends the run  too late\n",
                            "  short",
                            "a shorter one\n",
                            "A unit with a quote"})
    has(page, piece);
  CHECK(page.ends_with(
      "Example\n  one_of_all_2d: {block: OneOfAll2D, preset: short, u: source, file: record.csv}\n"));
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
}

TEST_CASE("the list of blocks has the families and first sentences") {
  CHECK(block_list(registry()) == "examples\n  OneOfAll2D  Has one of each: y = |u|.\n");
}

TEST_CASE("a Markdown page has tables whose cells hold bars") {
  const Registry all = registry();
  const std::string page = block_markdown(type_in(all));
  CHECK(page.starts_with("# OneOfAll2D\n\nHas one of each: y = \\|u\\|."));
  has(page,
      "## Parameters\n\n| name | kind | unit | default | allowed | meaning |\n| --- | --- | --- | --- | --- "
      "| --- |\n");
  has(page, "| `length` | number | mm | 4 mm | above 0, at most 10 mm | how long |\n");
  has(page, "```yaml\none_of_all_2d: {block: OneOfAll2D, ");
  const std::string book = blocks_markdown(all);
  has(book, "## examples\n\n- [OneOfAll2D](#oneofall2d): Has one of each");
  has(book, "\n## OneOfAll2D\n");
  has(book, "\n### Parameters\n");
}

TEST_CASE("the JSON of a block is complete, with numbers in SI") {
  const Registry all = registry();
  const nlohmann::json block = nlohmann::json::parse(block_json(type_in(all)).text());
  CHECK(block.at("name") == "OneOfAll2D");
  CHECK(block.at("timing") == "continuous");
  CHECK(block.at("not_real_time") == "it reads a book at every step");
  CHECK(block.at("parameters").at(0) ==
        nlohmann::json::parse(R"({"name": "length", "kind": "number", "unit": "mm", "shape": "",
      "doc": "how long", "required": false, "default": 0.004, "above": 0.0, "at_most": 0.01})"));
  CHECK(block.at("parameters").at(1).at("default") == nullptr);
  CHECK(block.at("parameters").at(2).at("default") == "hard");
  CHECK(block.at("parameters").at(2).at("words") == nlohmann::json({"soft", "hard"}));
  CHECK(block.at("inputs").at(0).at("feedthrough") == false);
  CHECK(block.at("inputs").at(1).at("optional") == true);
  CHECK(block.at("outputs").at(0).at("state") == "level");
  CHECK(block.at("states").at(0).at("initial") == 3.0);
  CHECK(block.at("states").at(0).at("key") == "initial");
  CHECK(block.at("states").at(1).at("key") == nullptr);
  CHECK(block.at("presets").at(0).at("values") == nlohmann::json::parse(R"({"length": 0.002})"));
  CHECK(block.at("notices").at(0).at("ends_run") == true);
  CHECK(block.at("keys") == nlohmann::json({"length", "open", "law", "order", "signs", "file", "u", "more",
                                            "initial", "preset", "enable", "trigger"}));
  CHECK(nlohmann::json::parse(blocks_json(all).text()).size() == 1);
}

TEST_CASE("the keys of a map stand once where a list of such maps may stand in its place") {
  const std::string page = format_page(*find_section("figure"));
  for (const std::string title : {"Keys of motion", "Keys of rose"}) {
    const std::size_t first = page.find(title);
    REQUIRE(first != std::string::npos);
    CHECK(page.find(title, first + 1) == std::string::npos);
  }
}

}  // namespace stepwire::reference
