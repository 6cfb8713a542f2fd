#pragma once

#include <utility>
#include <vector>

#include "engine/app/difference/facts.hpp"

namespace stepwire::difference {

/// Items of two sets, matched.
struct Matches {
  std::vector<std::pair<const Fact*, const Fact*>> pairs;
  std::vector<const Fact*> removed, added;
};

/// Matches the items of two sets: equal ones, then those with one label, then similar ones.
Matches matches_of(const Fact& before, const Fact& after);

}  // namespace stepwire::difference
