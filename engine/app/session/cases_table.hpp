#pragma once

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/model/diagram/sweep.hpp"
#include "engine/simulate/record/recording.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::session {

/// Renames the kept numbers of a sweep by its cases, as in the table of by_cases(): error becomes HV.error.
/// Without cases it changes nothing.
void name_cases(const diagram::Sweep& sweep, const run::RunNumbers& kept, query::SymbolTable& names);

/// Converts the kept rows of runs to a table with one row for all cases of a point. It has the other swept
/// values, and the numbers of each case. After an interruption, with missing runs, the table is empty.
record::Recording by_cases(const diagram::Sweep& sweep, const run::RunNumbers& kept,
                           const record::Recording& runs);

}  // namespace stepwire::session
