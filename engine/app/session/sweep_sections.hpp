#pragma once

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/model/diagram/sweep.hpp"
#include "engine/simulate/record/recording.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::session {

/// Converts the kept rows of runs to a table with one row for all cases of a point. It has the other swept
/// values, and the numbers of each case. After an interruption, with missing runs, the table is empty.
record::Recording by_cases(const diagram::Sweep& sweep, const run::RunNumbers& kept,
                           const record::Recording& runs);

/// Returns the number of recordings of a model's runs.
std::size_t recordings_of(const LoadedModel& model);

/// Reads the numbers that the sweep keeps of its runs. Their names replace those of signals.
void add_kept(LoadedModel& model, query::SymbolTable& names, yaml::Faults& faults);

/// Returns the names for figures: those of claims, and the signals of the runs whose rows are recorded.
query::SymbolTable names_of_figures(const LoadedModel& model, const query::SymbolTable& names);

/// True if figures and claims read a table with one row for all cases of a point.
bool has_cases(const LoadedModel& model);

/// Draws one row per run as separate points instead of a line.
void draw_kept_as_points(const LoadedModel& model, std::vector<plot::Figure>& figures);

/// Reads the outcomes of the sensitivity analysis, and adds the names of its results.
void add_sensitivity(LoadedModel& model, query::SymbolTable& names, yaml::Faults& faults);

}  // namespace stepwire::session
