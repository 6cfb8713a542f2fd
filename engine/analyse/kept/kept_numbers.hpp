#pragma once

#include <memory>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::kept {

/// Reads the reductions that a sweep keeps of each run, and replaces the signals in `names` by their names.
/// Returns nullptr if the sweep keeps rows, or if a reduction has a fault.
std::shared_ptr<const run::RunNumbers> read_kept_numbers(const diagram::Diagram& diagram,
                                                         query::SymbolTable& names, yaml::Faults& faults);

/// Reads the same reductions for the folder of a run, from the plan of its flattened diagram; used by
/// replay::verify().
std::shared_ptr<const run::RunNumbers> numbers_of_folder(const plan::Plan& plan, const yaml::Node& note,
                                                         const table::Table& swept,
                                                         const table::ColumnWords& words);

}  // namespace stepwire::kept
