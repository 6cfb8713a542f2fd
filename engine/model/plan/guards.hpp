#pragma once

#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

struct Draft;

/// The blocks by which a block is active, from the one that it names itself outwards.
std::vector<int> guards_of(const diagram::Diagram& diagram, std::size_t block);
/// Does it put states back as it becomes active?
bool resets(const diagram::Diagram& diagram, int guard);
/// Does one of a block's guards?
bool is_reset(const diagram::Diagram& diagram, std::size_t block);

/// Lists what happens as guards change, once all numbers have their places.
void plan_guards(Draft& draft);

}  // namespace stepwire::plan
