#include "tests/pages/diagram_text.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <vector>

namespace {

/// A key of the head with all that belongs to it.
struct Section {
  std::string key, text;
};

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<Section> sections_of(const std::string& yaml) {
  std::vector<Section> sections;
  for (const std::string& line : split_lines(yaml)) {
    if (!line.empty() && std::isalpha(static_cast<unsigned char>(line.front())))
      sections.push_back({line.substr(0, line.find(':')), ""});
    if (!sections.empty()) sections.back().text += line + "\n";
  }
  return sections;
}

void put(std::vector<Section>& sections, const Section& added) {
  static const std::set<std::string> lists{"blocks", "parameters"};
  const auto known = std::find_if(sections.begin(), sections.end(),
                                  [&](const Section& section) { return section.key == added.key; });
  if (known == sections.end())
    sections.push_back(added);
  else if (lists.contains(added.key))
    known->text += added.text.substr(added.text.find('\n') + 1);
  else
    known->text = added.text;
}

std::vector<std::string> without_indentation(const std::string& text) {
  std::vector<std::string> lines = split_lines(text);
  for (std::string& line : lines) line.erase(0, line.find_first_not_of(' '));
  return lines;
}

bool has_section(const std::string& yaml, const std::string& key) {
  return ("\n" + yaml).find("\n" + key + ":") != std::string::npos;
}

}  // namespace

bool is_diagram(const std::string& yaml) {
  return yaml.starts_with("stepwire: 1\n");
}

bool is_part(const std::string& yaml) {
  return has_section(yaml, "outputs") && !has_section(yaml, "stop");
}

std::string with_sections(const std::string& diagram, const std::string& piece) {
  std::vector<Section> sections = sections_of(diagram);
  for (const Section& added : sections_of(piece)) put(sections, added);
  std::string text;
  for (const Section& section : sections) text += section.text;
  return text;
}

bool stands_in(const std::string& piece, const std::string& file) {
  const std::vector<std::string> lines = without_indentation(piece), all = without_indentation(file);
  return std::search(all.begin(), all.end(), lines.begin(), lines.end()) != all.end();
}
