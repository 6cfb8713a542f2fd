#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "tests/house/source_tree.hpp"

namespace {

/// Rooms that people write blocks and programs with, and the header of the functions in formulas.
const std::set<std::string> public_rooms{"model/signal", "model/block", "base/math", "stepwire"};
const std::string formulas = "engine/base/expression/language.hpp";

/// "stepwire::plan" of "engine/model/plan/order.cpp".
std::string namespace_of(const std::string& file) {
  if (file == formulas) return "stepwire::language";
  if (!file.starts_with("engine/")) return "stepwire";
  const std::string room = folder_of(file).substr(std::string("engine/").size());
  return public_rooms.contains(room) ? "stepwire" : "stepwire::" + room.substr(room.rfind('/') + 1);
}

struct Opened {
  std::string name;
  bool declares_only = true;  ///< types of another room, by their names
};

/// The namespaces that a file opens; those inside of others are left out.
std::vector<Opened> opened_in(const std::vector<Line>& lines) {
  static const std::regex begin(R"(namespace ((?:stepwire|CLI)[\w:]*) \{)"),
      declaration(R"((struct|class) \w+;)");
  std::vector<Opened> opened;
  bool is_inside = false;
  for (const Line& line : lines) {
    std::smatch match;
    if (std::regex_match(line.text, match, begin)) {
      opened.push_back({match[1]});
      is_inside = true;
    } else if (line.text.starts_with("}  // namespace ") || (line.text == "}" && opened.size() > 0)) {
      is_inside = false;
    } else if (is_inside && !line.text.empty() && !std::regex_match(line.text, declaration)) {
      opened.back().declares_only = false;
    }
  }
  return opened;
}

std::vector<Line> lines(const std::vector<std::string>& texts) {
  std::vector<Line> all;
  for (const std::string& text : texts) all.push_back({"", 0, text});
  return all;
}

}  // namespace

TEST_CASE("a source defines what it defines in the namespace of its room") {
  std::size_t count = 0;
  for (const std::string& file : sources_under({"engine", "blocks"}))
    for (const Opened& opened : opened_in(lines_of(file))) {
      INFO(file << ": " << opened.name);
      CHECK((opened.name == namespace_of(file) || opened.declares_only));
      count += opened.name == namespace_of(file) ? 1 : 0;
    }
  CHECK(count > 900);
}

TEST_CASE("a type of another room may be declared where it stands, and nothing more") {
  CHECK(namespace_of("engine/model/plan/order.cpp") == "stepwire::plan");
  CHECK(namespace_of("engine/model/signal/signal.hpp") == "stepwire");
  CHECK(namespace_of("blocks/math/gain.hpp") == "stepwire");
  const auto declares_only = [](const std::string& line) {
    return opened_in(lines({"namespace stepwire::plan {", line, "}"})).front().declares_only;
  };
  CHECK(declares_only("struct Plan;"));
  CHECK_FALSE(declares_only("struct Plan {};"));
  CHECK_FALSE(declares_only("int answer();"));
}

TEST_CASE("no two headers define a type of one name in one namespace") {
  // The linker would use one of them for both, without a message.
  const std::regex definition(R"(^(?:struct|class) ([A-Z]\w*)(?: final)?(?: :.*)?(?: \{.*)?$)");
  std::map<std::string, std::string> first;
  for (const std::string& file : sources_under({"engine", "blocks"})) {
    if (!file.ends_with(".hpp")) continue;
    for (const Line& line : lines_of(file)) {
      std::smatch match;
      if (!std::regex_match(line.text, match, definition)) continue;
      const auto [known, is_new] = first.emplace(namespace_of(file) + "::" + match.str(1), file);
      INFO(line.place() << ": " << line.text << "; also in " << known->second);
      CHECK((is_new || known->second == file));
    }
  }
  CHECK(first.size() > 100);
}
