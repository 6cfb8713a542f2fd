#include "engine/app/difference/fact_edits.hpp"

#include <algorithm>
#include <sstream>

#include "engine/base/yaml/yaml_text.hpp"

namespace stepwire::difference {

using language::EditRefused;

FactEdits::FactEdits(const DiagramText& into, const DiagramText& from)
    : into_(into),
      from_(from),
      from_places_(from.text),
      places_(into.text),
      edits_(into.text, into.document) {}

/// Returns a value as its text has it where that is one line, in flow style otherwise.
std::string FactEdits::written(const Fact& fact) const {
  if (!fact.node) return fact.written;
  const bool is_in_brackets = fact.node->is_map() || fact.node->is_list();
  const std::string_view raw = from_places_.range(*fact.node).in(from_.text);
  const bool is_flow = !raw.empty() && (raw[0] == '{' || raw[0] == '[');
  const bool is_one_line =
      !raw.empty() && raw.find('\n') == std::string_view::npos && raw[0] != '|' && raw[0] != '>';
  if (is_one_line && (is_flow || !is_in_brackets)) return std::string(raw);
  return yaml::yaml_line(*fact.node);
}

/// Returns the lines of a section of the file, without comments that belong to the next one.
std::string FactEdits::section_text(const yaml::Entry& section) const {
  std::size_t end = from_.text.size();
  for (const yaml::Entry& other : from_.document.root.entries)
    if (other.mark.line > section.mark.line) end = std::min(end, from_places_.offset(other.mark));
  const std::size_t begin = from_places_.offset(section.mark);
  std::istringstream lines(from_.text.substr(begin, end - begin));
  std::string text, skipped;
  for (std::string line; std::getline(lines, line);) {
    skipped += line + "\n";
    if (line.empty() || line.front() == '#') continue;
    text += skipped;
    skipped.clear();
  }
  return text;
}

template <class Edit>
void FactEdits::attempt(Edit edit) {
  if (!refusal_.empty()) return;
  try {
    edit();
  } catch (const EditRefused& refused) {
    refusal_ = refused.what();
  }
}

void FactEdits::replace(const Fact& fact, const Fact& by) {
  attempt([&] {
    if (!fact.node) throw EditRefused("a value has no text of its own");
    edits_.replace(*fact.node, written(by));
  });
}

void FactEdits::add(const Fact& map, const Fact& part) {
  attempt([&] {
    const std::string key = unmarked(part.key);
    if (!is_map(map))
      throw EditRefused("'" + key + "' cannot be added to a short form; write it as a map first");
    if (const yaml::Node* there = map.node->find(key)) return edits_.replace(*there, written(part));
    const bool is_section = map.node == &into_.document.root && map.node->mark.column == 1 &&
                            !into_.text.substr(places_.offset(map.node->mark)).starts_with('{');
    if (is_section && part.entry)
      appended_ += section_text(*part.entry);
    else
      edits_.add(*map.node, key, written(part));
  });
}

void FactEdits::add_item(const Fact& list, const Fact& item) {
  attempt([&] {
    if (is_list(list)) return edits_.add_item(*list.node, written(item));
    if (!list.node) throw EditRefused("a list has no text of its own");
    edits_.replace(*list.node, "[" + yaml::yaml_line(*list.node) + ", " + written(item) + "]");
  });
}

void FactEdits::remove(const Fact& map, const Fact& part) {
  attempt([&] {
    if (!is_map(map) || !part.entry) throw EditRefused("a value has no text of its own");
    edits_.remove(*map.node, *part.entry);
  });
}

void FactEdits::remove_item(const Fact& list, const Fact& item) {
  attempt([&] {
    if (!is_list(list) || !item.node) throw EditRefused("an item has no text of its own");
    edits_.remove_item(*list.node, *item.node);
  });
}

std::string FactEdits::text() const {
  if (!refusal_.empty()) throw EditRefused(refusal_);
  std::string text = language::spliced(into_.text, edits_.checked());
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text + appended_;
}

}  // namespace stepwire::difference
