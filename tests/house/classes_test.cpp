#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>

#include "tests/house/source_tree.hpp"

namespace {

constexpr std::size_t max_lines = 300;
const std::string reason = "// More than 300 lines with its header: ";

std::string without_ending(const std::string& file) {
  return file.substr(0, file.rfind('.'));
}

/// The header that defines each class, by the name of the class.
std::map<std::string, std::string> headers_of_classes(const std::vector<std::string>& files) {
  const std::regex definition(R"(^(?:struct|class) (\w+)(?: final)?(?: : .*)? \{.*$)");
  std::map<std::string, std::string> headers;
  std::smatch match;
  for (const std::string& file : files)
    if (file.ends_with(".hpp"))
      for (const Line& line : lines_of(file))
        if (std::regex_match(line.text, match, definition)) headers.emplace(match[1], file);
  return headers;
}

/// The header whose class has a member function that is defined in this line; empty where there is none.
std::string header_of_member(const std::string& line, const std::map<std::string, std::string>& headers) {
  static const std::regex member(R"(^(?:[\w:<>,*& ]+[ *&])?(\w+)::~?\w+\(.*$)");
  std::smatch match;
  if (line.starts_with(" ") || !std::regex_match(line, match, member)) return "";
  const auto header = headers.find(match[1]);
  return header == headers.end() ? "" : header->second;
}

/// The sources of each header: that of its name, and those that define members of its classes.
std::map<std::string, std::set<std::string>> sources_of_headers(const std::vector<std::string>& files) {
  const auto headers = headers_of_classes(files);
  std::map<std::string, std::set<std::string>> sources;
  for (const std::string& file : files)
    if (file.ends_with(".cpp")) {
      sources[without_ending(file) + ".hpp"].insert(file);
      for (const Line& line : lines_of(file))
        if (const std::string header = header_of_member(line.text, headers); !header.empty())
          sources[header].insert(file);
    }
  return sources;
}

bool gives_reason(const std::set<std::string>& sources) {
  for (const std::string& file : sources)
    for (const Line& line : lines_of(file))
      if (line.text.starts_with(reason) && line.text.size() > reason.size() + 20) return true;
  return false;
}

}  // namespace

TEST_CASE("a class has at most 300 lines in its header and its sources, or says why it has more") {
  for (const auto& [header, sources] : sources_of_headers(sources_under({"engine", "blocks"}))) {
    std::size_t lines = lines_of(header).size();
    for (const std::string& file : sources) lines += lines_of(file).size();
    INFO(header << " and its sources have " << lines << " lines; split the class, or begin its source with '"
                << reason << "...'");
    CHECK((lines <= max_lines || gives_reason(sources)));
    CHECK_FALSE((lines <= max_lines && gives_reason(sources)));
  }
}

TEST_CASE("a member function is told from a call of one") {
  const std::map<std::string, std::string> headers{{"Lamp", "lamp.hpp"}};
  CHECK(header_of_member("void Lamp::shine(double power) {", headers) == "lamp.hpp");
  CHECK(header_of_member("Lamp::~Lamp() {", headers) == "lamp.hpp");
  CHECK(header_of_member("const std::string& Lamp::name() const {", headers) == "lamp.hpp");
  CHECK(header_of_member("  Lamp::of(3).shine();", headers).empty());
  CHECK(header_of_member("void Torch::shine() {", headers).empty());
}
