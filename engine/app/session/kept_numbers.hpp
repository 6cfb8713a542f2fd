#pragma once

#include <memory>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::session {

/// Reads the reductions that a sweep keeps of each run, and leaves names of these in the place of those of
/// signals. Null where the sweep keeps rows, or a reduction has a fault.
std::shared_ptr<const run::RunNumbers> read_kept_numbers(const diagram::Diagram& diagram,
                                                         query::SymbolTable& names, yaml::Faults& faults);

}  // namespace stepwire::session
