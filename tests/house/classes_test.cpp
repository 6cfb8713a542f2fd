#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/house/source_tree.hpp"

namespace {

/// Classes whose member functions are in more than one source. The number may fall and never rises.
constexpr std::size_t most_parted_classes = 6;

/// A class of a header: its folder, and its name. Members are defined in sources of that folder.
using Class = std::pair<std::string, std::string>;

std::set<Class> classes_of(const std::vector<std::string>& files) {
  const std::regex definition(R"(^(?:struct|class) (\w+)(?: final)?(?: : .*)? \{.*$)");
  std::set<Class> classes;
  std::smatch match;
  for (const std::string& file : files)
    if (file.ends_with(".hpp"))
      for (const Line& line : lines_of(file))
        if (std::regex_match(line.text, match, definition)) classes.emplace(folder_of(file), match[1]);
  return classes;
}

/// Returns the class of a member function that begins in this line; empty for any other line.
std::string class_of_member(const std::string& line) {
  static const std::regex member(R"(^(?:[\w:<>,*& ]+[ *&])?(\w+)::~?\w+\(.*$)");
  std::smatch match;
  if (line.starts_with(" ") || !std::regex_match(line, match, member)) return "";
  return match[1];
}

std::map<Class, std::set<std::string>> sources_of_classes(const std::vector<std::string>& files) {
  const std::set<Class> classes = classes_of(files);
  std::map<Class, std::set<std::string>> sources;
  for (const std::string& file : files)
    if (file.ends_with(".cpp"))
      for (const Line& line : lines_of(file))
        if (const Class found{folder_of(file), class_of_member(line.text)}; classes.contains(found))
          sources[found].insert(file);
  return sources;
}

}  // namespace

TEST_CASE("no further class has its member functions in several sources") {
  std::size_t parted = 0;
  std::string names;
  const auto classes = sources_of_classes(sources_under({"engine", "blocks"}));
  for (const auto& [of, sources] : classes) {
    if (sources.size() < 2) continue;
    ++parted;
    names += of.first + ": " + of.second + "\n";
  }
  INFO(parted << " classes have several sources; give a class one source, up to 600 lines:\n" << names);
  CHECK(parted <= most_parted_classes);
  CHECK(classes.size() > 100);
}

TEST_CASE("a member function is told from a call of one") {
  CHECK(class_of_member("void Lamp::shine(double power) {") == "Lamp");
  CHECK(class_of_member("Lamp::~Lamp() {") == "Lamp");
  CHECK(class_of_member("const std::string& Lamp::name() const {") == "Lamp");
  CHECK(class_of_member("  Lamp::of(3).shine();").empty());
  CHECK(class_of_member("int shine() {").empty());
}
