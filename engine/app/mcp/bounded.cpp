#include "engine/app/mcp/bounded.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stepwire::mcp {

using json::Json;

namespace {

/// Shortens one value with everything in it.
class Shortening {
 public:
  Shortening(std::size_t items, std::vector<std::string>& notes) : items_(items), notes_(notes) {}

  Json of(const Json& value, const std::string& path) {
    if (value.is_list()) return list(value, path);
    if (value.is_object()) {
      Json result = Json::object();
      for (const auto& [key, one] : value.members())
        result.set(key, of(one, path.empty() ? key : path + "." + key));
      return result;
    }
    const std::string* text = value.as_text();
    return text && text->size() > most_text() ? beginning(*text, path) : value;
  }

 private:
  std::size_t most_text() const { return 40 * items_; }

  Json list(const Json& value, const std::string& path) {
    Json result = Json::list();
    const auto all = value.items();
    if (all.size() > items_)
      notes_.push_back(fmt::format("{}: {} of {} items, evenly chosen", path, items_, all.size()));
    for (const std::size_t index : even_indices(all.size(), items_))
      result.push(of(all[index], fmt::format("{}[{}]", path, index)));
    return result;
  }

  Json beginning(const std::string& text, const std::string& path) {
    notes_.push_back(fmt::format("{}: the first {} of {} bytes", path, most_text(), text.size()));
    return Json(text.substr(0, most_text()));
  }

  std::size_t items_;
  std::vector<std::string>& notes_;
};

}  // namespace

std::vector<std::size_t> even_indices(std::size_t size, std::size_t count) {
  std::vector<std::size_t> indices;
  const std::size_t shown = std::min(size, count);
  for (std::size_t i = 0; i < shown; ++i)
    indices.push_back(shown == 1 ? size - 1 : i * (size - 1) / (shown - 1));
  return indices;
}

Json bounded(const Json& value, std::size_t most, std::vector<std::string>& notes) {
  if (value.text(-1).size() <= most) return value;
  constexpr std::size_t fewest = 2;
  for (std::size_t items = 2000; items > fewest; items /= 2) {
    std::vector<std::string> found;
    Json shorter = Shortening(items, found).of(value, "");
    if (shorter.text(-1).size() > most) continue;
    constexpr std::size_t most_notes = 20;
    if (found.size() > most_notes) {
      found.push_back(fmt::format("and {} more", found.size() - most_notes));
      found.erase(found.begin() + most_notes, found.end() - 1);
    }
    notes.insert(notes.end(), found.begin(), found.end());
    return shorter;
  }
  notes.push_back("the result is too large for an answer; write it with 'out', or ask for less");
  return {};
}

}  // namespace stepwire::mcp
