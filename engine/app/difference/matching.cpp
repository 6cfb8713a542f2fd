#include "engine/app/difference/matching.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace stepwire::difference {
namespace {

constexpr double least_shared = 0.5;  // of two claims or figures that count as one

constexpr std::size_t most_items =
    64;  // of two sets within, such as panels, that are compared each with each

double similarity(const Fact& a, const Fact& b);

/// Returns 1 for equal parts of two items, and the mean of the most similar pairs for two sets of panels.
double shared_part(const Fact& a, const Fact& b) {
  if (a.key != b.key) return 0.0;
  if (a.canonical == b.canonical || a.written == b.written) return 1.0;
  const bool are_sets = a.kind == Fact::Kind::set && b.kind == Fact::Kind::set;
  const std::size_t count = std::max(a.parts.size(), b.parts.size());
  if (!are_sets || count > most_items) return 0.0;
  double sum = 0.0;
  for (const Fact& item : a.parts) {
    double most = 0.0;
    for (const Fact& other : b.parts)
      most = std::max(most, item.canonical == other.canonical ? 1.0 : similarity(item, other));
    sum += most;
  }
  return sum / static_cast<double>(count);
}

double similarity(const Fact& a, const Fact& b) {
  if (a.parts.empty() || b.parts.empty()) return 0.0;
  double shared = 0.0;
  for (const Fact& part : a.parts) {
    double most = 0.0;
    for (const Fact& other : b.parts) most = std::max(most, shared_part(part, other));
    shared += most;
  }
  return shared / static_cast<double>(std::max(a.parts.size(), b.parts.size()));
}

/// Items that have no partner yet.
class Unpaired {
 public:
  Unpaired(const Fact& before, const Fact& after) {
    for (const Fact& one : before.parts) found_.removed.push_back(&one);
    for (const Fact& one : after.parts) found_.added.push_back(&one);
  }

  /// Pairs items of one text, in their order. An item without a text has no partner.
  void pair_by(const std::function<std::optional<std::string>(const Fact&)>& text_of) {
    std::unordered_map<std::string, std::deque<const Fact*>> others;
    for (const Fact* one : found_.added)
      if (auto text = text_of(*one)) others[std::move(*text)].push_back(one);
    pair([&](const Fact& one) -> const Fact* {
      const auto text = text_of(one);
      const auto same = text ? others.find(*text) : others.end();
      if (same == others.end() || same->second.empty()) return nullptr;
      const Fact* other = same->second.front();
      same->second.pop_front();
      return other;
    });
  }

  void pair_similar() {
    std::unordered_set<const Fact*> taken;
    pair([&](const Fact& one) -> const Fact* {
      for (const Fact* other : found_.added)
        if (!taken.contains(other) && similarity(one, *other) >= least_shared) {
          taken.insert(other);
          return other;
        }
      return nullptr;
    });
  }

  Matches found() && { return std::move(found_); }

 private:
  template <class Partner>
  void pair(Partner partner_of) {
    std::unordered_set<const Fact*> taken;
    std::erase_if(found_.removed, [&](const Fact* one) {
      const Fact* other = partner_of(*one);
      if (!other) return false;
      found_.pairs.emplace_back(one, other);
      return taken.insert(other).second;
    });
    std::erase_if(found_.added, [&](const Fact* one) { return taken.contains(one); });
  }

  Matches found_;
};

}  // namespace

Matches matches_of(const Fact& before, const Fact& after) {
  Unpaired items(before, after);
  items.pair_by([](const Fact& item) { return std::optional(item.canonical); });
  items.pair_by(
      [](const Fact& item) { return item.is_map() ? std::optional(label_of(item)) : std::nullopt; });
  items.pair_similar();
  return std::move(items).found();
}

}  // namespace stepwire::difference
