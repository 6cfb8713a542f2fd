#pragma once

#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::query {

/// Names of a diagram's values that differ between the runs of a job, and how: "swept".
struct VariedNames {
  std::vector<std::string> names;
  std::string how;
};

/// Marks the parameters and numbers of blocks that the varied names set, directly or through formulas, since
/// no single value of them is right for all runs. Formulas that use a marked name are refused with its column
/// or formula as the cure. Names that the diagram does not have, such as factors of recorded trials, are
/// ignored.
void mark_varied(const diagram::Diagram& diagram, const VariedNames& varied, SymbolTable& names);

}  // namespace stepwire::query
