#include "engine/app/difference/rearrange.hpp"

#include <algorithm>
#include <optional>

#include "engine/app/difference/order.hpp"
#include "engine/app/language/text_places.hpp"

namespace stepwire::difference {
namespace {

using language::TextRange;
using Ranges = std::vector<TextRange>;

/// Returns the ranges of the items themselves: values of a list, keys with values of a map.
Ranges ranges_of(const language::TextPlaces& places, const yaml::Node& node) {
  Ranges ranges;
  for (const yaml::Entry& one : node.entries) ranges.push_back(places.range(one.mark, one.value.end));
  for (const yaml::Node& one : node.items) ranges.push_back(places.range(one));
  return ranges;
}

std::size_t line_start(const std::string& text, std::size_t at) {
  const std::size_t end = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  return end == std::string::npos ? 0 : end + 1;
}

bool is_comment(const std::string& text, std::size_t start) {
  const std::size_t first = text.find_first_not_of(" \t", start);
  return first != std::string::npos && (text[first] == '#' || text[first] == '\n');
}

/// Returns whole lines of each item with the comments above it; std::nullopt where an item begins within a
/// line.
std::optional<Ranges> lines_of(const std::string& text, const Ranges& items) {
  Ranges lines;
  for (const TextRange& item : items) {
    std::size_t start = line_start(text, item.from);
    if (text.substr(start, item.from - start).find_first_not_of(" -") != std::string::npos)
      return std::nullopt;
    while (start > 0 && is_comment(text, line_start(text, start - 1))) start = line_start(text, start - 1);
    if (!lines.empty()) lines.back().to = start;
    if (!lines.empty() && lines.back().from >= start) return std::nullopt;
    lines.push_back({start, 0});
  }
  const std::size_t last = items.back().to;
  const std::size_t end = last > 0 && text[last - 1] == '\n' ? last - 1 : text.find('\n', last);
  if (end == std::string::npos) return std::nullopt;
  lines.back().to = end + 1;
  return lines;
}

/// Returns the place in `from` of each name of `to`, each once; std::nullopt where the names differ.
std::optional<std::vector<std::size_t>> places_of(const std::vector<std::string>& to,
                                                  const std::vector<std::string>& from) {
  if (to.size() != from.size()) return std::nullopt;
  std::vector<std::size_t> places;
  for (const std::string& name : to) {
    std::size_t i = 0;
    while (i < from.size() && (from[i] != name || std::ranges::count(places, i))) ++i;
    if (i == from.size()) return std::nullopt;
    places.push_back(i);
  }
  return places;
}

}  // namespace

std::string rearranged(const DiagramText& file, const std::string& place,
                       const std::vector<std::string>& names) {
  const std::optional<OrderedNode> found = ordered_node(file.document.root, place);
  const auto places = found ? places_of(names, found->names) : std::nullopt;
  if (!places || names.size() < 2) return file.text;
  const Ranges items = ranges_of(language::TextPlaces(file.text), *found->node);
  if (items.size() != names.size()) return file.text;
  const Ranges ranges = lines_of(file.text, items).value_or(items);
  std::vector<language::Splice> splices;
  for (std::size_t i = 0; i < ranges.size(); ++i)
    splices.push_back({ranges[i], std::string(ranges[(*places)[i]].in(file.text))});
  return language::spliced(file.text, splices);
}

}  // namespace stepwire::difference
