#include "engine/app/language/tree_edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>

#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/text_extent.hpp"

namespace stepwire::language {
namespace {

/// Text of a value at a place, and its parsed node.
struct WrittenValue {
  std::string text;
  yaml::Node node;
};

std::string in_quotes(const std::string& text, char quote) {
  std::string result(1, quote);
  for (const char c : text) {
    if (c == quote || (quote == '"' && c == '\\')) result += quote == '"' ? '\\' : quote;
    result += c;
  }
  return result + quote;
}

/// Parses a text as a value of a map, with or without brackets; std::nullopt if it is none.
std::optional<yaml::Node> value_of(const std::string& text, bool flow) {
  try {
    const yaml::Document read = yaml::parse_document(flow ? "{v: " + text + "}" : "v: " + text, "");
    if (!read.root.is_map() || read.root.entries.size() != 1 || read.root.entries[0].key != "v")
      return std::nullopt;
    return read.root.entries[0].value;
  } catch (const yaml::Error&) {
    return std::nullopt;
  }
}

/// True if a text in brackets has a comment. A '#' within quotes or a word begins none.
bool has_comment(const std::string& text) {
  char quote = 0, before = ' ';
  for (const char c : text) {
    const bool begins = std::string_view(" \t,[]{}:").find(before) != std::string_view::npos;
    if (quote != 0)
      quote = c == quote && before != '\\' ? 0 : quote;
    else if ((c == '"' || c == '\'') && begins)
      quote = c;
    else if (c == '#' && begins)
      return true;
    before = before == '\\' && c == '\\' ? ' ' : c;
  }
  return false;
}

/// True if the value contains the whole text, that is, no part of it is an anchor, a tag or a comment.
bool is_whole(const yaml::Node& value, const std::string& text) {
  if (value.is_scalar()) return value.text == text || text[0] == '"' || text[0] == '\'';
  return (value.is_list() || value.is_map()) && !has_comment(text) && text[0] != '&' && text[0] != '!';
}

/// Returns the notation of a value at a place: unchanged, such as "8 kg" or "[1, 2]", or quoted if it would
/// otherwise be parsed differently.
/// Examples of the latter are "max(a, b)" within brackets (`flow`) and a text with '#'. `quote` is the quote
/// of the old value, which is kept; 0 if it had none. Throws EditRefused for text that is no single-line
/// value.
WrittenValue written_value(const std::string& text, bool flow, char quote = 0) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  if (first == std::string::npos) throw EditRefused("a value is missing");
  if (text.find_first_of("\r\n") != std::string::npos) throw EditRefused("a value stands in one line here");
  const std::string value = text.substr(first, last - first + 1);
  const auto plain = value_of(value, flow);
  const bool keeps_quotes = quote != 0 && plain && plain->is_scalar() && !plain->quoted;
  if (plain && is_whole(*plain, value) && !keeps_quotes) return {value, *plain};
  const std::string quoted = in_quotes(value, quote ? quote : '"');
  if (const auto read = value_of(quoted, flow); read && read->text == value) return {quoted, *read};
  throw EditRefused(fmt::format("'{}' is no value", text::visible(value)));
}

bool same(const yaml::Node& a, const yaml::Node& b) {
  const auto same_entry = [](const yaml::Entry& one, const yaml::Entry& other) {
    return one.key == other.key && same(one.value, other.value);
  };
  return a.kind == b.kind && a.quoted == b.quoted && a.text == b.text &&
         std::ranges::equal(a.items, b.items, same) && std::ranges::equal(a.entries, b.entries, same_entry);
}

yaml::Entry entry_of(const std::string& key, yaml::Node value) {
  return {.key = key, .mark = {}, .value = std::move(value)};
}

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

TreeEdits::TreeEdits(std::string_view text, const yaml::Document& document)
    : text_(text),
      document_(document),
      places_(text),
      line_break_(text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n") {
  note_parents(document.root);
}

void TreeEdits::note_parents(const yaml::Node& node) {
  const auto note = [&](const yaml::Node& child) {
    parents_[&child] = &node;
    note_parents(child);
  };
  for (const yaml::Node& item : node.items) note(item);
  for (const yaml::Entry& entry : node.entries) note(entry.value);
}

bool TreeEdits::is_flow(const yaml::Node& node) const {
  const std::size_t at = places_.offset(node.mark);
  return (node.is_map() || node.is_list()) && at < text_.size() && (text_[at] == '{' || text_[at] == '[');
}

bool TreeEdits::stands_in_flow(const yaml::Node& node) const {
  const auto parent = parents_.find(&node);
  return parent != parents_.end() && is_flow(*parent->second);
}

void TreeEdits::replace(const yaml::Node& value, const std::string& text) {
  const TextRange range = places_.range(value);
  const char first = range.from < text_.size() ? text_[range.from] : ' ';
  const bool has_quotes = value.is_scalar() && (first == '"' || first == '\'');
  WrittenValue put = written_value(text, stands_in_flow(value), has_quotes ? first : '\0');
  const std::size_t behind = text_.find_first_not_of(" \t", range.to);
  const bool is_left_out =
      value.kind == yaml::Node::Kind::empty && text_.substr(std::min(behind, text_.size())).starts_with(':');
  splices_.push_back(is_left_out ? Splice{{behind + 1, behind + 1}, " " + put.text}
                                 : Splice{range, put.text});
  replaced_[&value] = std::move(put.node);
}

std::string TreeEdits::indent(const yaml::Node& node) const {
  return std::string(static_cast<std::size_t>(std::max(1, node.mark.column) - 1), ' ');
}

std::size_t TreeEdits::line_start(std::size_t at) const {
  const std::size_t before = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
  return before == std::string_view::npos ? 0 : before + 1;
}

std::size_t TreeEdits::line_end(std::size_t at) const {
  const std::size_t end = std::min(text_.find('\n', at), text_.size());
  return end > at && text_[end - 1] == '\r' ? end - 1 : end;
}

std::size_t TreeEdits::value_end(const yaml::Node& value, std::size_t key_end) const {
  if (value.kind == yaml::Node::Kind::empty) return std::max(key_end, places_.offset(value.end));
  std::size_t at = text_.find_first_not_of(": \t", key_end);
  if (at != std::string_view::npos && text_[at] == '*')
    return yaml::word_end(text_, at);  // an alias; its content is elsewhere
  std::size_t end = places_.offset(value.end);
  if (is_flow(value)) return end;
  for (const Child& child : children(value)) end = std::max(end, child.range.to);
  return end;
}

std::vector<TreeEdits::Child> TreeEdits::children(const yaml::Node& node) const {
  std::vector<Child> all;
  for (const yaml::Entry& entry : node.entries) {
    const TextRange key = places_.key_range(entry);
    all.push_back({&entry, {key.from, value_end(entry.value, key.to)}});
  }
  for (const yaml::Node& item : node.items) {
    const std::size_t from = places_.offset(item.mark);
    all.push_back({&item, {from, value_end(item, from)}});
  }
  return all;
}

void TreeEdits::append(const yaml::Node& parent, const std::string& text) {
  if (!is_flow(parent) && parent.entries.empty() && parent.items.empty())
    throw EditRefused("there is no list or map here yet; write it in the text");
  appended_[&parent].push_back(text);
}

bool TreeEdits::are_removed(const std::vector<Child>& all) const {
  return std::ranges::all_of(all, [&](const Child& one) { return removed_.contains(one.id); });
}

void TreeEdits::add_appended(const yaml::Node& parent, std::vector<Splice>& splices) const {
  const auto texts = appended_.find(&parent);
  if (texts == appended_.end()) return;
  const auto all = children(parent);
  if (is_flow(parent)) {
    const std::size_t at = all.empty() ? places_.offset(parent.end) - 1 : all.back().range.to;
    const char* comma = are_removed(all) ? "" : ", ";
    return splices.push_back({{at, at}, fmt::format("{}{}", comma, fmt::join(texts->second, ", "))});
  }
  const std::string line = line_break_ + indent(parent);
  std::string lines;
  for (const std::string& text : texts->second) lines += line + (parent.is_list() ? "- " : "") + text;
  if (are_removed(all))
    return splices.push_back(
        {{places_.offset(parent.mark), line_end(all.back().range.to)}, lines.substr(line.size())});
  const std::size_t at = end_of_lines(parent, all.back().range.to);
  splices.push_back({{at, at}, std::move(lines)});
}

void TreeEdits::add(const yaml::Node& map, const std::string& key, const std::string& text) {
  WrittenValue put = written_value(text, is_flow(map));
  append(map, key + ": " + put.text);
  added_[&map].push_back(entry_of(key, std::move(put.node)));
}

void TreeEdits::add_map(const yaml::Node& map, const std::string& key, const Keys& keys) {
  const bool in_lines = !is_flow(map) && !map.entries.empty() && map.entries.back().value.is_map() &&
                        !is_flow(map.entries.back().value);
  const yaml::Node* last = map.entries.empty() ? nullptr : &map.entries.back().value;
  std::string text = key + (in_lines ? ":" : ": {");
  yaml::Node value;
  value.kind = yaml::Node::Kind::map;
  for (const auto& [name, content] : keys) {
    WrittenValue put = written_value(content, !in_lines);
    text += in_lines ? line_break_ + indent(*last) : value.entries.empty() ? "" : ", ";
    text += name + ": " + put.text;
    value.entries.push_back(entry_of(name, std::move(put.node)));
  }
  append(map, in_lines ? text : text + "}");
  added_[&map].push_back(entry_of(key, std::move(value)));
}

void TreeEdits::add_item(const yaml::Node& list, const std::string& text) {
  WrittenValue put = written_value(text, is_flow(list));
  append(list, put.text);
  added_items_[&list].push_back(std::move(put.node));
}

void TreeEdits::remove(const yaml::Node& map, const yaml::Entry& entry) {
  removed_.insert(&entry);
  with_removals_.insert(&map);
}

void TreeEdits::remove_item(const yaml::Node& list, const yaml::Node& item) {
  removed_.insert(&item);
  with_removals_.insert(&list);
}

void TreeEdits::remove_in_flow(const std::vector<Child>& all, std::vector<Splice>& splices) const {
  const auto is_removed = [&](std::size_t i) { return removed_.contains(all[i].id); };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_removed(i)) continue;
    std::size_t next = i + 1;
    while (next < all.size() && is_removed(next)) ++next;
    const std::size_t from = next == all.size() && i > 0 ? all[i - 1].range.to : all[i].range.from;
    splices.push_back({{from, next == all.size() ? all.back().range.to : all[next].range.from}, ""});
    i = next;
  }
}

void TreeEdits::remove_line(const yaml::Node& parent, const std::vector<Child>& all, std::size_t index,
                            std::vector<Splice>& splices) const {
  const TextRange& range = all[index].range;
  std::size_t from = line_start(range.from);
  const std::string_view before = text_.substr(from, range.from - from);
  const std::size_t dash = parent.is_list() ? before.find('-') : std::string_view::npos;
  const bool is_alone = before.find_first_not_of(' ') == dash &&
                        (!parent.is_list() || before.find_first_not_of(' ', dash + 1) == before.npos);
  if (is_alone) {
    // The line break before it is removed, so that a line can be added behind it.
    if (from == 0)
      return splices.push_back({{0, std::min(text_.find('\n', range.to), text_.size() - 1) + 1}, ""});
    from -= text_.substr(0, from).ends_with("\r\n") ? 2 : 1;
    return splices.push_back({{from, line_end(range.to)}, ""});
  }
  if (index + 1 == all.size())
    throw EditRefused("this stands in one line with others; change it in the text");
  splices.push_back({{range.from, all[index + 1].range.from}, ""});
}

void TreeEdits::add_removals(const yaml::Node& node, std::vector<Splice>& splices) const {
  const auto all = children(node);
  if (is_flow(node)) return remove_in_flow(all, splices);
  if (are_removed(all) && appended_.contains(&node)) return;  // they are replaced
  if (are_removed(all))
    return splices.push_back({{places_.offset(node.mark), all.back().range.to}, node.is_map() ? "{}" : "[]"});
  for (std::size_t i = 0; i < all.size(); ++i)
    if (removed_.contains(all[i].id)) remove_line(node, all, i, splices);
}

yaml::Node TreeEdits::expected(const yaml::Node& node) const {
  if (const auto put = replaced_.find(&node); put != replaced_.end()) {
    yaml::Node now = put->second;
    now.mark = node.mark;
    now.end = node.end;
    return now;
  }
  yaml::Node now = node;
  now.items.clear();
  now.entries.clear();
  for (const yaml::Node& item : node.items)
    if (!removed_.contains(&item)) now.items.push_back(expected(item));
  for (const yaml::Entry& entry : node.entries)
    if (!removed_.contains(&entry))
      now.entries.push_back({entry.key, entry.mark, expected(entry.value), entry.end});
  if (const auto more = added_.find(&node); more != added_.end())
    for (const yaml::Entry& entry : more->second)
      now.entries.push_back({entry.key, node.end, entry.value, node.end});
  if (const auto more = added_items_.find(&node); more != added_items_.end())
    std::ranges::copy(more->second, std::back_inserter(now.items));
  return now;
}

std::vector<Splice> TreeEdits::checked() const {
  std::vector<Splice> splices = splices_;
  std::vector<const yaml::Node*> parents(with_removals_.begin(), with_removals_.end());
  for (const auto& [parent, texts] : appended_)
    if (!with_removals_.contains(parent)) parents.push_back(parent);
  // Texts at the end of an inner value precede those at the end of the value around it.
  std::ranges::sort(parents, std::greater{},
                    [&](const yaml::Node* one) { return places_.offset(one->mark); });
  for (const yaml::Node* node : parents) {
    if (with_removals_.contains(node)) add_removals(*node, splices);
    add_appended(*node, splices);
  }
  std::ranges::stable_sort(splices, {}, &Splice::range);
  try {
    const yaml::Document after = yaml::parse_document(spliced(text_, splices), "");
    if (same(after.root, expected(document_.root))) return splices;
  } catch (const yaml::Error& error) {
    throw EditRefused(std::string("the file could not be read any more: ") + error.what());
  }
  throw EditRefused("this would change more of the file than it should; change it in the text");
}

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
