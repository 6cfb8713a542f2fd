#include "engine/app/difference/difference_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/base/text/characters.hpp"

namespace stepwire::difference {
namespace {

using Kind = Change::Kind;

constexpr std::size_t longest_value = 160;  // [bytes] of a value in a line

std::string shortened(const std::string& value) {
  if (value.size() <= longest_value) return value;
  std::size_t end = longest_value;
  while (end > 0 && (static_cast<unsigned char>(value[end]) & 0xC0u) == 0x80u) --end;  // within a character
  return value.substr(0, end) + " ...";
}

/// Removes the equal beginning of two long texts up to a word, so that a line has what differs.
void remove_equal_beginning(std::string& from, std::string& to) {
  if (std::max(from.size(), to.size()) <= longest_value) return;
  const auto differs = std::ranges::mismatch(from, to).in1;
  const std::size_t word = from.rfind(' ', static_cast<std::size_t>(differs - from.begin()));
  if (word == std::string::npos || word < longest_value / 2 || word >= to.size()) return;
  from = "..." + from.substr(word);
  to = "..." + to.substr(word);
}

/// Returns the name and its value, which are often one for an item of a list.
std::string named_value(const std::string& name, const std::string& value) {
  return name == value || name.empty() ? shortened(value) : fmt::format("{}: {}", name, shortened(value));
}

std::string place_of(const Change& change) {
  const bool is_gone = change.after.line == 0;
  const yaml::Mark& mark = is_gone ? change.before : change.after;
  return mark.line == 0 ? "" : fmt::format("{} {}", is_gone ? "old line" : "line", mark.line);
}

void append(std::string& text, const FileDifference& file) {
  const std::string& before = file.before_name.empty() ? file.before : file.before_name;
  const std::string& after = file.after_name.empty() ? file.after : file.after_name;
  text += before == after ? after + "\n" : fmt::format("{} -> {}\n", before, after);
  std::vector<std::string> sections;
  for (const Change& change : file.changes)
    if (!std::ranges::count(sections, change.section)) sections.push_back(change.section);
  for (const std::string& section : sections) {
    text += "  " + section + "\n";
    for (const Change& change : file.changes) {
      if (change.section != section) continue;
      const std::string place = place_of(change);
      text += "    " + line_of(change) + (place.empty() ? "" : "  [" + place + "]") + "\n";
    }
  }
}

/// Returns names of the items of a set, with their numbers where several have one name.
std::vector<std::string> labels_of(const Fact& set) {
  std::vector<std::string> names;
  for (const Fact& part : set.parts) names.push_back(label_of(part));
  std::map<std::string, int> counts, numbers;
  for (const std::string& name : names) ++counts[name];
  std::vector<std::string> labels = names;
  for (std::string& label : labels)
    if (const std::string name = label; counts[name] > 1) label += fmt::format(" ({})", ++numbers[name]);
  return labels;
}

void append_facts(std::vector<std::string>& lines, const Fact& fact, const std::string& path) {
  if (fact.kind == Fact::Kind::value || fact.kind == Fact::Kind::sequence || fact.parts.empty())
    return lines.push_back(path + ": " + fact.written);
  const std::vector<std::string> labels = labels_of(fact);
  for (std::size_t i = 0; i < fact.parts.size(); ++i) {
    const Fact& part = fact.parts[i];
    const bool is_named = fact.kind == Fact::Kind::set && part.parts.size() > 1;
    const std::string key = is_named ? "'" + labels[i] + "'" : unmarked(part.key);
    append_facts(lines, part, path.empty() ? key : key.empty() ? path : path + "." + key);
  }
}

}  // namespace

std::string line_of(const Change& change) {
  switch (change.kind) {
    case Kind::added:
      return "+ " + named_value(change.name, change.to);
    case Kind::removed:
      return "- " + named_value(change.name, change.from);
    case Kind::renamed:
      return fmt::format("> {} is now {}", change.from, change.to);
    case Kind::moved:
      return fmt::format("> {} moved to {}", change.from, change.to);
    case Kind::changed:
      break;
  }
  const std::string ratio = change.ratio ? fmt::format(" ({:.4g} times)", *change.ratio) : "";
  std::string from = change.from, to = change.to;
  remove_equal_beginning(from, to);
  return fmt::format("~ {}: {} -> {}{}", change.name, shortened(from), shortened(to), ratio);
}

std::string text_of(const Difference& difference) {
  std::string text;
  for (const FileDifference& file : difference.files) append(text, file);
  return text;
}

std::string facts_text(const Fact& root) {
  std::vector<std::string> lines;
  append_facts(lines, root, "");
  std::ranges::sort(lines);
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace stepwire::difference
