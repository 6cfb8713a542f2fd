// A member that a block does not declare is lost where its numbers are written: in flattened files and
// generated code.
#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/house/source_tree.hpp"

namespace {

/// Returns a line without the text in braces or angle brackets, which may contain commas.
std::string bare(std::string line) {
  static const std::regex group(R"(\{[^{}]*\}|<[^<>]*>)");
  for (std::string before; before != line;) {
    before = line;
    line = std::regex_replace(before, group, "");
  }
  return line;
}

/// Returns the names that a line of a struct defines; an empty list if it defines no data member.
std::vector<std::string> members_of(const std::string& line) {
  static const std::regex other(
      R"(  (using|static|constexpr|void|enum|template|private|protected|public|struct|class|friend)\b.*)");
  static const std::regex member(R"(  [A-Za-z][\w:]*(?: const)? ([^()]*);\s*(?://.*)?)");
  static const std::regex name(R"((\w+)\s*(?:=[^,]*)?(?:,|$))");
  std::smatch found;
  const std::string plain = bare(line);
  if (std::regex_match(plain, other) || !std::regex_match(plain, found, member)) return {};
  const std::string list = found[1];
  std::vector<std::string> names;
  for (std::sregex_iterator at(list.begin(), list.end(), name), end; at != end; ++at)
    names.push_back((*at)[1]);
  return names;
}

/// Members of the structs of a header that declare themselves or are the core of some that do.
std::vector<std::string> members_in(const std::string& header) {
  static const std::regex begin(R"(struct (\w+)[^;]*\{)");
  std::vector<std::string> members, own;
  bool is_block = false;
  for (const Line& line : lines_of(header)) {
    std::smatch found;
    if (std::regex_match(line.text, found, begin)) {
      own.clear();
      is_block = std::string(found[1]).ends_with("Core");
    }
    is_block = is_block || line.text.find("static void declare") != std::string::npos;
    for (std::string& member : members_of(line.text)) own.push_back(std::move(member));
    if (line.text == "};" && is_block) members.insert(members.end(), own.begin(), own.end());
    if (line.text == "};") is_block = false;
  }
  return members;
}

/// Returns the names in pointers to members, such as &Lag::tau, in the sources of each folder.
std::map<std::string, std::set<std::string>> declared_members() {
  static const std::regex member(R"(&\w+::(\w+))");
  std::map<std::string, std::set<std::string>> declared;
  for (const std::string& file : files_under("blocks")) {
    if (!file.ends_with(".cpp") && file.find("declare") == std::string::npos) continue;
    for (const Line& line : lines_of(file))
      for (std::sregex_iterator at(line.text.begin(), line.text.end(), member), end; at != end; ++at)
        declared[folder_of(file)].insert((*at)[1]);
  }
  return declared;
}

}  // namespace

TEST_CASE(
    "every member of a block is a parameter, port, state, notice or derived from these, and declared so") {
  auto declared = declared_members();
  std::size_t count = 0;
  for (const std::string& file : files_under("blocks")) {
    if (!file.ends_with(".hpp")) continue;
    for (const std::string& member : members_in(file)) {
      INFO(file << ": " << member);
      CHECK(declared[folder_of(file)].contains(member));
      ++count;
    }
  }
  CHECK(count > 700);
}
