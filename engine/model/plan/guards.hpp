#pragma once

#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

struct Draft;

/// Returns the guards of a block, from its own one outwards.
std::vector<int> guards_of(const diagram::Diagram& diagram, std::size_t block);
/// True where the guard resets states on activation.
bool resets(const diagram::Diagram& diagram, int guard);
/// True where one of the block's guards resets states.
bool is_reset(const diagram::Diagram& diagram, std::size_t block);

/// Lists the actions on changes of guards; requires the layout of memory.
void plan_guards(Draft& draft);

}  // namespace stepwire::plan
