#include "engine/base/yaml/fault_place.hpp"

#include <algorithm>
#include <cctype>
#include <tuple>

#include "engine/base/text/characters.hpp"

namespace stepwire::yaml {

namespace {

bool lies_behind(const Mark& a, const Mark& b) {
  return std::tie(a.line, a.column) > std::tie(b.line, b.column);
}

bool same(const Mark& a, const Mark& b) {
  return a.line == b.line && a.column == b.column;
}

void find(const Node& node, const Mark& mark, FoundPlace& found) {
  if (same(node.mark, mark)) found.value = &node;
  if (node.is_scalar() && !lies_behind(node.mark, mark) && lies_behind(node.end, mark)) found.around = &node;
  const Entry* inside = nullptr;
  for (const Entry& entry : node.entries)
    if (!lies_behind(entry.mark, mark)) inside = &entry;
  const Node* item = nullptr;
  for (const Node& one : node.items)
    if (!lies_behind(one.mark, mark)) item = &one;
  if (inside) {
    found.keys.push_back(inside->key);
    if (same(inside->mark, mark)) found.key = inside;
    find(inside->value, mark, found);
  } else if (item) {
    find(*item, mark, found);
  }
}

/// Returns the last end of a value inside of a node within one line.
Mark last_end(const Node& node, int line) {
  if (node.end.line == line) return node.end;
  Mark last = node.mark;
  const auto take = [&](const Mark& end) {
    if (end.line == line && lies_behind(end, last)) last = end;
  };
  for (const Node& item : node.items) take(last_end(item, line));
  for (const Entry& entry : node.entries) {
    take(entry.end);
    take(last_end(entry.value, line));
  }
  return last;
}

int characters(std::string_view text) {
  return static_cast<int>(std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

}  // namespace

FoundPlace find_place(const Node& root, const Mark& mark) {
  FoundPlace found;
  find(root, mark, found);
  return found;
}

std::optional<Mark> end_of_fault(const Node& root, const Fault& fault) {
  const Mark& mark = fault.place.mark;
  const FoundPlace found = find_place(root, mark);
  if (found.key) return found.key->end;
  if (found.value) return found.value->is_scalar() ? found.value->end : last_end(*found.value, mark.line);
  if (!found.around) return std::nullopt;
  const auto& suggestion = fault.message.suggestion;
  if (suggestion && !suggestion->written.empty())
    return Mark{mark.line, mark.column + characters(suggestion->written)};
  return found.around->end;
}

std::optional<std::size_t> find_word(std::string_view text, std::size_t from, std::size_t to,
                                     const std::string& word) {
  const auto goes_on = [&](std::size_t before, std::size_t behind) {
    return behind < text.size() && is_word_character(text[before]) && is_word_character(text[behind]);
  };
  if (word.empty()) return std::nullopt;
  for (std::size_t at = text.find(word, from); at != std::string_view::npos && at + word.size() <= to;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if (!(at > 0 && goes_on(at - 1, at)) && !goes_on(end - 1, end)) return at;
  }
  return std::nullopt;
}

}  // namespace stepwire::yaml
