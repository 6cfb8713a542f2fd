#pragma once

#include "engine/app/session/loaded_model.hpp"

namespace stepwire::session {

/// How many recordings the runs of a model make.
std::size_t recordings_of(const LoadedModel& model);

/// Reads what the sweep keeps of its runs, and leaves the names of these in the place of those of signals.
void add_kept(LoadedModel& model, query::SymbolTable& names, yaml::Faults& faults);

/// Names for figures: those of claims, and the signals of runs that are recorded beside the numbers of all.
query::SymbolTable names_of_figures(const LoadedModel& model, const query::SymbolTable& names);

/// Do figures and claims read a table with a row for all cases of a point?
bool has_cases(const LoadedModel& model);

/// Draws rows that are one of each run as the points that they are.
void draw_kept_as_points(const LoadedModel& model, std::vector<plot::Figure>& figures);

/// Reads of which outcomes it is found out which drawn parameter matters, and adds the names that this makes.
void add_sensitivity(LoadedModel& model, query::SymbolTable& names, yaml::Faults& faults);

}  // namespace stepwire::session
