#pragma once

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/model/diagram/sweep.hpp"
#include "engine/simulate/record/recording.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::session {

/// Has the numbers that a sweep keeps of each run in the names of its cases, HV.error in place of error, as
/// the table of by_cases() has them. Without cases all stays.
void name_cases(const diagram::Sweep& sweep, const run::RunNumbers& kept, query::SymbolTable& names);

/// The kept rows of runs as a table with one row for all cases of a point: what else is swept, and the
/// numbers of each case. Without all runs, after an interruption, it has no rows.
record::Recording by_cases(const diagram::Sweep& sweep, const run::RunNumbers& kept,
                           const record::Recording& runs);

}  // namespace stepwire::session
