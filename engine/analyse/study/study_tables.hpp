#pragma once

#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/analyse/study/experiment.hpp"

namespace stepwire::study {

/// The tables that a study makes, by the names that `plot: table` has for them, still empty.
std::vector<query::NamedTable> empty_study_tables();

/// Fills in those of one experiment. What cannot be analysed is said in the table's place.
void fill_study_tables(const Experiment& experiment, const StudyRequest& request,
                       std::vector<query::NamedTable>& tables);

/// Fills in those of a sweep. `means` and `significance` have a line for each point: means of the conditions,
/// P of the factors, and whether the statements of the thesis hold. The others have the rows of all points.
void fill_sweep_tables(const Experiments& experiments, const StudyRequest& request,
                       std::vector<query::NamedTable>& tables);

/// Whose trials they are, for titles: "simulated operators", "recorded trials".
std::string whose_trials(const StudyRequest& request);

}  // namespace stepwire::study
