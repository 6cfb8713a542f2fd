// Edits that add lines to a section, that is, to the value under a key of a map.
#include "engine/app/language/tree_edits.hpp"
#include "engine/app/language/written_value.hpp"

namespace stepwire::language {

namespace {

constexpr std::size_t deeper = 2;  // indentation of a section [columns]

std::string line_of(const std::string& name, const std::string& value) {
  return name.empty() ? "- " + value : name + ": " + value;
}

/// Returns a list or a map with one value.
yaml::Node node_of(const std::string& name, yaml::Node value) {
  yaml::Node node;
  node.kind = name.empty() ? yaml::Node::Kind::list : yaml::Node::Kind::map;
  if (name.empty())
    node.items.push_back(std::move(value));
  else
    node.entries.push_back({.key = name, .mark = {}, .value = std::move(value)});
  return node;
}

}  // namespace

/// Returns the end of a line, after following comment lines that are indented like the parent's content.
std::size_t TreeEdits::end_of_lines(const yaml::Node& parent, std::size_t end) const {
  const std::size_t wanted = indent(parent).size();
  std::size_t at = line_end(end);
  for (std::size_t next = text_.find('\n', at); wanted > 0 && next < text_.size() - 1;
       next = text_.find('\n', at)) {
    const std::size_t first = text_.find_first_not_of(" \t", next + 1);
    if (first == std::string_view::npos || text_[first] != '#' || first - next - 1 < wanted) break;
    at = line_end(first);
  }
  return at;
}

void TreeEdits::begin(const yaml::Node& map, const yaml::Entry* entry, const std::string& key,
                      const std::string& name, const std::string& text) {
  const bool is_left_out = entry && places_.offset(entry->value.end) <= places_.key_range(*entry).to;
  if (is_flow(map) || (entry && !is_left_out)) {
    const std::string value = name.empty() ? "[" + text + "]" : "{" + name + ": " + text + "}";
    return entry ? replace(entry->value, value) : add(map, key, value);
  }
  WrittenValue put = written_value(text, false);
  const std::string line = line_break_ + indent(map) + std::string(deeper, ' ') + line_of(name, put.text);
  yaml::Node value = node_of(name, std::move(put.node));
  if (entry) {
    const std::size_t at = line_end(places_.key_range(*entry).to);
    splices_.push_back({{at, at}, line});
    replaced_[&entry->value] = std::move(value);
    return;
  }
  append(map, key + ":" + line);
  added_[&map].push_back({.key = key, .mark = {}, .value = std::move(value)});
}

/// Converts a map to a list item: by a dash before a block map, or brackets around a flow map.
void TreeEdits::put_in_list(const yaml::Entry& entry) {
  const TextRange range{places_.offset(entry.value.mark),
                        value_end(entry.value, places_.key_range(entry).to)};
  if (is_flow(entry.value)) return splices_.push_back({{range.from, range.from}, "["});
  splices_.push_back({{range.from, range.from}, "- "});
  for (std::size_t line = text_.find('\n', range.from); line < range.to; line = text_.find('\n', line + 1)) {
    const bool is_empty = text_.find_first_not_of(" \t\r", line + 1) == text_.find('\n', line + 1);
    if (!is_empty && line + 1 < range.to) splices_.push_back({{line + 1, line + 1}, "  "});
  }
}

void TreeEdits::make_list(const yaml::Entry& entry, const std::string& text) {
  const bool flows = is_flow(entry.value);
  WrittenValue put = written_value(text, flows);
  put_in_list(entry);
  const std::size_t end = value_end(entry.value, places_.key_range(entry).to);
  const std::size_t at = flows ? end : end_of_lines(entry.value, end);
  const std::string line =
      flows ? ", " + put.text + "]" : line_break_ + indent(entry.value) + "- " + put.text;
  splices_.push_back({{at, at}, line});
  yaml::Node list = node_of("", entry.value);
  list.items.push_back(std::move(put.node));
  replaced_[&entry.value] = std::move(list);
}

void TreeEdits::add_below(const yaml::Node& map, const std::string& key, const std::string& name,
                          const std::string& text) {
  const auto found = std::ranges::find(map.entries, key, &yaml::Entry::key);
  const yaml::Entry* entry = found == map.entries.end() ? nullptr : &*found;
  if (!entry || entry->value.kind == yaml::Node::Kind::empty) return begin(map, entry, key, name, text);
  const yaml::Node& value = entry->value;
  const bool is_empty = value.entries.empty() && value.items.empty() && !value.is_scalar();
  if (is_empty) return begin(map, entry, key, name, text);
  if (!name.empty() && value.is_map()) return add(value, name, text);
  if (name.empty() && value.is_list()) return add_item(value, text);
  if (name.empty() && value.is_map()) return make_list(*entry, text);
  throw EditRefused("'" + key + "' has another form here; the line would be: " + line_of(name, text));
}

}  // namespace stepwire::language
