#include "engine/app/difference/matching.hpp"

#include <algorithm>

namespace stepwire::difference {
namespace {

constexpr double least_shared = 0.5;  // of two claims or figures that count as one

double similarity(const Fact& a, const Fact& b) {
  if (a.parts.empty() || b.parts.empty()) return 0.0;
  const auto shared = std::ranges::count_if(a.parts, [&](const Fact& part) {
    return std::ranges::any_of(b.parts, [&](const Fact& other) {
      return part.key == other.key && (part.canonical == other.canonical || part.written == other.written);
    });
  });
  return static_cast<double>(shared) / static_cast<double>(std::max(a.parts.size(), b.parts.size()));
}

}  // namespace

Matches matches_of(const Fact& before, const Fact& after) {
  Matches found;
  for (const Fact& one : before.parts) found.removed.push_back(&one);
  for (const Fact& one : after.parts) found.added.push_back(&one);
  const auto match = [&](auto&& is_same) {
    std::erase_if(found.removed, [&](const Fact* one) {
      const auto other = std::ranges::find_if(found.added, [&](const Fact* b) { return is_same(*one, *b); });
      if (other == found.added.end()) return false;
      found.pairs.emplace_back(one, *other);
      found.added.erase(other);
      return true;
    });
  };
  match([](const Fact& a, const Fact& b) { return a.canonical == b.canonical; });
  match([](const Fact& a, const Fact& b) { return a.is_map() && b.is_map() && label_of(a) == label_of(b); });
  match([](const Fact& a, const Fact& b) { return similarity(a, b) >= least_shared; });
  return found;
}

}  // namespace stepwire::difference
